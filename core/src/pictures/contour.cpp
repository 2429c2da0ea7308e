#include "dalembert/pictures/contour.hpp"

#include <algorithm>
#include <cmath>

namespace dalembert {
namespace {

constexpr double tolerance = 1e-9;  // of the range, by which a number may be outside of it and is not

}  // namespace

void contour_numbers(std::span<const double> outputs, std::size_t size, int component, double* numbers) {
  const std::size_t count = outputs.size() / size;
  const double* row = outputs.data();
  if (component < 0) {
    for (std::size_t k = 0; k < count; ++k, row += size) {
      double squares = 0;
      for (std::size_t i = 0; i < size; ++i) squares += row[i] * row[i];
      numbers[k] = std::sqrt(squares);
    }
  } else {
    const auto at = static_cast<std::size_t>(component);
    for (std::size_t k = 0; k < count; ++k, row += size) numbers[k] = at < size ? row[at] : 0.0;
  }
}

void contour_shades(std::span<const double> numbers, double low, double high, std::span<const std::uint8_t> table, std::uint8_t* bytes) {
  const std::size_t above = table.size() / bytes_of_shade - 1;
  const auto steps = static_cast<double>(above - 2);
  const double scale = steps / (high - low), first = -tolerance * steps, last = steps - first;
  for (const double number : numbers) {
    const double part = (number - low) * scale;
    std::size_t row = part > last ? above : 0;
    if (part >= first && part <= last) row = 1 + static_cast<std::size_t>(std::clamp(part, 0.0, steps) + 0.5);
    bytes = std::copy_n(table.data() + bytes_of_shade * row, bytes_of_shade, bytes);
  }
}

}  // namespace dalembert
