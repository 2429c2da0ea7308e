#include "dalembert/pictures/modal_points.hpp"

#include <algorithm>
#include <array>

#include "dalembert/math/wide_registers.hpp"
#include "lengths.hpp"

namespace dalembert {
namespace {

std::array<float, 12> in_single_precision(ModalPoints::Rows rows) {
  std::array<float, 12> result;
  std::ranges::transform(rows, result.begin(), [](double number) { return static_cast<float>(number); });
  return result;
}

}  // namespace

// Points and displacements of one picture have the same weights.
void ModalPoints::deform(std::span<const double> weights) {
  weights = weights.first(planes_.modes());
  if (!deformation_.empty() && std::ranges::equal(weights, weights_)) return;
  weights_.assign(weights.begin(), weights.end());
  deformation_.resize(rest_.size());
  for (std::size_t first = 0; first < planes_.nodes(); first += ModePlanes::block)
    planes_.sum(weights, first, deformation_.data() + 3 * first);
}

void ModalPoints::place(std::span<const double> weights, Rows rows, float* to) {
  deform(weights);
  const std::array<float, 12> frame = in_single_precision(rows);
  for (std::size_t first = 0; first < planes_.nodes(); first += ModePlanes::block) {
    const std::size_t count = planes_.size_of_block(first);
    const float *const x = rest_.data() + 3 * first, *const u = deformation_.data() + 3 * first;
    in_registers_of_four([f = frame, x, u, count, to] {
      for (std::size_t k = 0; k < count; ++k) {
        const float y0 = x[k] + u[k], y1 = x[count + k] + u[count + k], y2 = x[2 * count + k] + u[2 * count + k];
        to[3 * k] = f[0] * y0 + f[1] * y1 + f[2] * y2 + f[3];
        to[3 * k + 1] = f[4] * y0 + f[5] * y1 + f[6] * y2 + f[7];
        to[3 * k + 2] = f[8] * y0 + f[9] * y1 + f[10] * y2 + f[11];
      }
    });
    to += 3 * count;
  }
}

// Rotation and translation of the frame, and the deformation in it, are added separately, so that small displacements
// are not differences of large numbers.
void ModalPoints::displacements(std::span<const double> weights, Rows rows, Rows at_rest, int component, double* to) {
  deform(weights);
  std::array<double, 12> change;
  std::ranges::transform(rows, at_rest, change.begin(), std::minus{});
  const std::array<float, 12> frame = in_single_precision(rows), moved = in_single_precision(change);
  const std::size_t begin = component < 0 ? 0 : static_cast<std::size_t>(component),
                    end = component < 0 ? 3 : std::min<std::size_t>(begin + 1, 3);
  std::array<float, 3 * ModePlanes::block> found{};
  for (std::size_t first = 0; first < planes_.nodes(); first += ModePlanes::block) {
    const std::size_t count = planes_.size_of_block(first);
    const float *const x = rest_.data() + 3 * first, *const u = deformation_.data() + 3 * first;
    in_registers_of_four([&, x, u, count, to] {
      for (std::size_t row = begin; row < end; ++row) {
        const float *const f = frame.data() + 4 * row, *const m = moved.data() + 4 * row;
        float* const d = found.data() + (row - begin) * count;
        for (std::size_t k = 0; k < count; ++k)
          d[k] = m[3] + m[0] * x[k] + m[1] * x[count + k] + m[2] * x[2 * count + k] + f[0] * u[k] +
                 f[1] * u[count + k] + f[2] * u[2 * count + k];
      }
      if (component < 0)
        find_lengths(found.data(), 3, count, to);
      else
        for (std::size_t k = 0; k < count; ++k) to[k] = static_cast<double>(found[k]);
    });
    to += count;
  }
}

}  // namespace dalembert
