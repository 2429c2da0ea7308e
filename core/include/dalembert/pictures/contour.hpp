// Outputs as colors: numbers of outputs, and bytes for many numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace dalembert {

// One number for each row of so many outputs: a component, 0 if there are fewer of them, or the length (component -1).
void contour_numbers(std::span<const double> outputs, std::size_t size, int component, double* numbers);

struct NumberRange {
  double low = 0, high = 1;
};
constexpr double least_range = 1e-6;  // of the larger of 1 and the number that all numbers are
// From the smallest to the largest of numbers; none if there are none, or one is not finite.
std::optional<NumberRange> range_of(std::span<const double> numbers);

// Three bytes for each number, out of the rows of a table: one for what is below the range, those of equal steps from its lower to its upper
// end, and one for what is above. What is no number is below.
void contour_shades(std::span<const double> numbers, double low, double high, std::span<const std::uint8_t> table, std::uint8_t* bytes);
constexpr std::size_t bytes_of_shade = 3, fewest_shades = 4;

}  // namespace dalembert
