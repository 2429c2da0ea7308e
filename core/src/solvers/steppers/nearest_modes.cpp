#include "steppers/nearest_modes.hpp"

#include <algorithm>
#include <cmath>

#include "dalembert/math/decompositions.hpp"

namespace dalembert {

namespace {

using Vector = std::vector<double>;

constexpr std::size_t most_modes = 4;
constexpr int first_sweeps = 12, later_sweeps = 3;
// A vector is independent of others if the remainder after orthogonalization is larger than round-off.
constexpr double independent = 1e-10;
// Relative imaginary part that counts as round-off.
constexpr double real = 1e-8;

// Orthogonalizing twice is enough: B. N. Parlett, The Symmetric Eigenvalue Problem, 1998, section 6.9.
void orthonormalize(std::vector<Vector>& vectors) {
  std::vector<Vector> kept;
  for (Vector& x : vectors) {
    const double before = std::sqrt(dot(x, x));
    for (int pass = 0; pass < 2; ++pass) {
      for (const Vector& y : kept) {
        const double part = dot(x, y);
        for (std::size_t i = 0; i < x.size(); ++i) x[i] -= part * y[i];
      }
    }
    const double size = std::sqrt(dot(x, x));
    if (!(size > independent * before)) continue;
    for (double& number : x) number /= size;
    kept.push_back(std::move(x));
  }
  vectors = std::move(kept);
}

// Returns start vectors with components in all modes.
std::vector<Vector> mixed_vectors(std::size_t size) {
  std::vector<Vector> vectors(std::min(most_modes, size), Vector(size));
  for (std::size_t j = 0; j < vectors.size(); ++j)
    for (std::size_t i = 0; i < size; ++i)
      vectors[j][i] = std::sin(1.0 + (2.7 + 0.71 * static_cast<double>(j)) * static_cast<double>(i + j));
  return vectors;
}

}  // namespace

void NearestModes::find(const Solve& solve, std::size_t ode2, std::size_t total) {
  const int sweeps = basis_.empty() ? first_sweeps : later_sweeps;
  if (basis_.empty()) basis_ = mixed_vectors(ode2);
  modes_.clear();
  std::vector<Vector> images;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    if (sweep > 0) basis_ = images;
    orthonormalize(basis_);
    images = basis_;
    for (Vector& x : images) {
      x.resize(total, 0.0);
      solve(x);
      x.resize(ode2);
    }
  }
  const auto m = static_cast<Eigen::Index>(basis_.size());
  Eigen::MatrixXd projected(m, m);
  for (Eigen::Index i = 0; i < m; ++i)
    for (Eigen::Index j = 0; j < m; ++j)
      projected(i, j) = dot(basis_[static_cast<std::size_t>(i)], images[static_cast<std::size_t>(j)]);
  if (m == 0 || !projected.allFinite()) return;
  const Eigenpairs pairs = eigenpairs(projected);
  for (Eigen::Index k = 0; k < m; ++k) {
    const std::complex<double> inverse = pairs.values[k];
    if (std::abs(inverse.imag()) > real * std::abs(inverse) || inverse.real() == 0) continue;
    Mode mode{1 / inverse.real(), Vector(ode2, 0.0)};
    for (Eigen::Index j = 0; j < m; ++j) {
      const double share = pairs.vectors(j, k).real();
      for (std::size_t i = 0; i < ode2; ++i) mode.vector[i] += share * images[static_cast<std::size_t>(j)][i];
    }
    const double size = std::sqrt(dot(mode.vector, mode.vector));
    for (double& number : mode.vector) number /= size;
    modes_.push_back(std::move(mode));
  }
  std::ranges::sort(modes_, {}, [](const Mode& mode) { return std::abs(mode.eigenvalue); });
  basis_ = std::move(images);
}

}  // namespace dalembert
