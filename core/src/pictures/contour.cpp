#include "dalembert/pictures/contour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace dalembert {
namespace {

constexpr std::size_t block = 256;     // numbers, whose places in the table are found together
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
  std::array<std::int32_t, block> places;
  for (std::size_t begin = 0; begin < numbers.size(); begin += block) {
    const std::size_t count = std::min(block, numbers.size() - begin);
    for (std::size_t k = 0; k < count; ++k) {
      const double part = (numbers[begin + k] - low) * scale, inside = std::clamp(part, 0.0, steps) + 1.5;
      const double row = part > last ? static_cast<double>(above) : part >= first ? inside : 0.0;
      places[k] = static_cast<std::int32_t>(row);
    }
    for (std::size_t k = 0; k < count; ++k, bytes += bytes_of_shade) std::memcpy(bytes, table.data() + bytes_of_shade * static_cast<std::size_t>(places[k]), bytes_of_shade);
  }
}

}  // namespace dalembert
