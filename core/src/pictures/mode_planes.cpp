#include "dalembert/pictures/mode_planes.hpp"

#include "dalembert/math/wide_registers.hpp"
#include "lengths.hpp"

namespace dalembert {

void ModePlanes::sum(std::span<const double> weights, std::size_t first, float* sums) const {
  std::fill_n(sums, components_ * size_of_block(first), 0.0f);
  in_registers_of_four([this, weights, first, sums] { add(weights, first, sums); });
}

// Two or four modes at once take longer: their planes have equal distances, and displace each other in the cache.
void ModePlanes::add(std::span<const double> weights, std::size_t first, float* sums) const {
  const std::size_t count = size_of_block(first);
  const std::int16_t* plane = planes_.data() + starts_[first / block];
  const double* unit = units_.data() + first / block * components_ * modes_;
  for (const double weight : weights.first(modes_))
    for (std::size_t i = 0; i < components_; ++i, ++unit) {
      if (*unit == 0) continue;
      const auto factor = static_cast<float>(weight * *unit);
      float* const to = sums + i * count;
      for (std::size_t k = 0; k < count; ++k) to[k] += factor * static_cast<float>(plane[k]);
      plane += count;
    }
}

void ModePlanes::numbers(std::span<const double> weights, double* to) const {
  std::array<float, most_components * block> sums;
  for (std::size_t first = 0; first < nodes_; first += block) {
    const std::size_t count = size_of_block(first);
    sum(weights, first, sums.data());
    if (components_ == 1)
      std::copy_n(sums.data(), count, to);
    else
      in_registers_of_four([this, &sums, count, to] { find_lengths(sums.data(), components_, count, to); });
    to += count;
  }
}

}  // namespace dalembert
