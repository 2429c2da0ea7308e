// Outputs as colors: numbers of outputs, and bytes for many numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace dalembert {

// One number per row of outputs: a component (0 if it does not exist), or the norm (component -1).
void contour_numbers(std::span<const double> outputs, std::size_t size, int component, double* numbers);

struct NumberRange {
  double low = 0, high = 1;
};
constexpr double round_off =
    1e-13;  // relative width of a range that is one number: outputs are sums of some hundred products
constexpr double least_range = 1e-6;  // width for the colors of one number, relative to the larger of 1 and this number
// Range of numbers; nullopt if there are none, or one is not finite.
std::optional<NumberRange> range_of(std::span<const double> numbers);

// Three bytes per number, from a table of colors: one row below the range, rows of equal steps within the range, and
// one row above it. NaN counts as below.
void contour_shades(std::span<const double> numbers, double low, double high, std::span<const std::uint8_t> table,
                    std::uint8_t* bytes);
constexpr std::size_t bytes_of_shade = 3, fewest_shades = 4;

}  // namespace dalembert
