#include "dalembert/pictures/contour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "dalembert/math/wide_registers.hpp"
#include "dalembert/pictures/four.hpp"

namespace dalembert {
namespace {

constexpr std::size_t block = 256;     // numbers, whose places in the table are found together
constexpr double tolerance = 1e-9;  // relative to the range: numbers within it count as inside

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

// Compares every eighth number separately, so that comparisons do not wait for each other.
std::optional<NumberRange> range_of(std::span<const double> numbers) {
  using Doubles [[gnu::vector_size(32)]] = double;
  constexpr std::size_t width = 4, registers = 2, lanes = width * registers;
  if (numbers.empty()) return std::nullopt;
  const double first = numbers[0];
  double low = first, high = first, sum = 0;  // nan, as soon as a number is not finite
  const std::size_t whole = numbers.size() / lanes * lanes;
  in_registers_of_four([&] {
    std::array<Doubles, registers> lows, highs, sums{};
    lows.fill(first - Doubles{}), highs.fill(first - Doubles{});
    for (const double *x = numbers.data(), *const end = x + whole; x < end; x += lanes)
      for (std::size_t j = 0; j < registers; ++j) {
        const auto now = load<Doubles>(x + width * j);
        lows[j] = now < lows[j] ? now : lows[j], highs[j] = now > highs[j] ? now : highs[j], sums[j] += 0.0 * now;
      }
    for (std::size_t k = 0; k < lanes; ++k) {
      const std::size_t j = k / width, i = k % width;
      low = std::min(low, lows[j][i]), high = std::max(high, highs[j][i]), sum += sums[j][i];
    }
  });
  for (const double number : numbers.subspan(whole))
    low = std::min(low, number), high = std::max(high, number), sum += 0 * number;
  if (!(sum == 0)) return std::nullopt;
  return NumberRange{low, high};
}

void contour_shades(std::span<const double> numbers, double low, double high, std::span<const std::uint8_t> table,
                    std::uint8_t* bytes) {
  if (low == high) high += std::max(std::abs(low), 1.0) * least_range;
  const std::size_t above = table.size() / bytes_of_shade - 1;
  const auto steps = static_cast<double>(above - 2);
  const double scale = steps / (high - low), first = -tolerance * steps, last = steps - first;
  std::vector<std::array<std::uint8_t, 4>> shades(above + 1);
  for (std::size_t i = 0; i <= above; ++i) std::memcpy(&shades[i], table.data() + bytes_of_shade * i, bytes_of_shade);
  std::array<std::int32_t, block> places;
  for (std::size_t begin = 0; begin < numbers.size(); begin += block) {
    const std::size_t count = std::min(block, numbers.size() - begin);
    in_registers_of_four([=, number = numbers.data() + begin, place = places.data()] {
      for (std::size_t k = 0; k < count; ++k) {
        const double part = (number[k] - low) * scale, inside = std::min(std::max(0.0, part), steps);  // 0 for NaN
        const double beyond = (part > last ? 1.0 : 0.0) - (part >= first ? 0.0 : 1.0);
        place[k] = static_cast<std::int32_t>(inside + beyond + 1.5);
      }
    });
    // Four bytes at once, of which the next shade replaces the last.
    for (std::size_t k = 0; k + 1 < count; ++k, bytes += bytes_of_shade)
      std::memcpy(bytes, &shades[static_cast<std::size_t>(places[k])], sizeof shades[0]);
    std::memcpy(bytes, &shades[static_cast<std::size_t>(places[count - 1])], bytes_of_shade);
    bytes += bytes_of_shade;
  }
}

}  // namespace dalembert
