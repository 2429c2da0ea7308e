#include "dalembert/solvers/constraint_rank.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "constraints/constraint_states.hpp"
#include "dalembert/math/decompositions.hpp"
#include "dalembert/output/numbers.hpp"
#include "diagnosis/orthogonal_factors.hpp"
#include "steppers/number_sequence.hpp"

namespace dalembert {

namespace {

// Limits of squared remainders of columns with unit length. Smaller ones are round-off if joints fit; gaps g cause up to
// (3 g)^2.
constexpr double tolerance_where_joints_fit = 1e-12, largest_tolerance = 1e-7, largest_ratio = 3;
constexpr double certain_multiple = 1e4;     // ratio of remainders to the tolerance that makes a count certain
constexpr double most_operations = 2e8;      // to compute the whole null space
constexpr std::size_t further_samples = 4;   // random vectors of a null space, more than the equations of an item
constexpr double share_of_equation = 1e-10;  // smallest squared entry of an equation in the null space

Eigen::Map<const Eigen::MatrixXd> matrix(const std::vector<double>& columns, std::size_t rows) {
  return {columns.data(), static_cast<Eigen::Index>(rows),
          rows == 0 ? 0 : static_cast<Eigen::Index>(columns.size() / rows)};
}

}  // namespace

ConstraintRank::ConstraintRank(System& system, const State& state, const Conditions& conditions,
                               const ConstraintMetric& metric, double tolerance)
    : units_(metric.kinds), acting_(metric.acting) {
  for (std::size_t k = 0; k < metric.weights.size(); ++k)
    if (metric.weights[k] > 0) rows_.push_back(static_cast<int>(k));
  if (rows_.empty() || !metric.has_loops) return;
  const double gap = largest_ratio * metric.largest(gaps_of_positions(system, state, conditions));
  if (tolerance == 0) {
    tolerance = std::clamp(gap * gap, tolerance_where_joints_fit, largest_tolerance);
    allows_for_gaps_ = tolerance > tolerance_where_joints_fit;
  }

  std::vector<OrthogonalFactors::Vector> columns;
  for (const int k : rows_) {
    OrthogonalFactors::Vector& column = columns.emplace_back();
    double sum = 0;
    for (const auto& [row, value] : metric.columns[static_cast<std::size_t>(k)]) sum += value * value;
    lengths_.push_back(sum > 0 ? std::sqrt(sum) : 1);
    for (const auto& [row, value] : metric.columns[static_cast<std::size_t>(k)])
      column.push_back({row, value / lengths_.back()});
    roots_.push_back(std::sqrt(metric.weights[static_cast<std::size_t>(k)]));
  }
  OrthogonalFactors factors(columns, system.sizes().ode2, tolerance);
  weakest_ = factors.smallest_pivot();
  std::vector<double> strengths;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    strengths.push_back(lengths_[i] * lengths_[i] / (roots_[i] * roots_[i]));
  strength_ = factors.smallest_pivot(strengths);
  certain_ = factors.dependent().empty() || weakest_ > certain_multiple * tolerance;
  for (const int i : factors.dependent()) dependent_.push_back(rows_[static_cast<std::size_t>(i)]);
  std::ranges::sort(dependent_);
  if (dependent_.empty()) return;
  largest_item_ = 0;
  for (const System::EquationOwner& owner : system.equation_owners())
    largest_item_ = std::max(largest_item_, owner.count);
  factors_ = std::make_shared<const OrthogonalFactors>(std::move(factors));
}

// Orthonormal vectors of the null space: a basis if `most` allows, otherwise random ones. By columns.
std::vector<double> ConstraintRank::null_vectors(std::size_t most) const {
  const std::size_t count = dependent_.size(), rows = rows_.size();
  const auto columns = static_cast<Eigen::Index>(std::min(count, most));
  Eigen::MatrixXd basis(static_cast<Eigen::Index>(rows), columns),
      given = Eigen::MatrixXd::Identity(static_cast<Eigen::Index>(count), columns);
  if (count > most) {
    NumberSequence random;
    std::generate_n(given.data(), given.size(), random);
  }
  // The vectors have entries of very different size. The second pass makes all of an orthonormal basis accurate.
  for (int pass = 0; pass < 2; ++pass) {
    for (Eigen::Index j = 0; j < columns; ++j) {
      const std::vector<double> vector = factors_->null_vector({given.col(j).data(), count});
      for (std::size_t i = 0; i < rows; ++i)  // from columns of unit length to multipliers in the metric
        basis(static_cast<Eigen::Index>(i), j) = vector[i] * roots_[i] / lengths_[i];
    }
    basis = orthonormal(basis);
    for (std::size_t i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(factors_->dependent()[i]);
      given.row(static_cast<Eigen::Index>(i)) = basis.row(static_cast<Eigen::Index>(k)) * (lengths_[k] / roots_[k]);
    }
  }
  return {basis.data(), basis.data() + basis.size()};
}

std::size_t ConstraintRank::samples() const { return static_cast<std::size_t>(largest_item_) + further_samples; }

// Computed at the first request.
const std::vector<double>& ConstraintRank::null_space() const {
  if (!null_space_.empty() || !factors_) return null_space_;
  const auto rows = static_cast<double>(rows_.size()), count = static_cast<double>(dependent_.size());
  whole_null_space_ = dependent_.size() <= samples() || rows * count * count < most_operations;
  null_space_ = null_vectors(whole_null_space_ ? dependent_.size() : samples());
  return null_space_;
}

std::vector<int> ConstraintRank::equations() const {
  std::vector<int> found;
  if (count() == 0) return found;
  const std::vector<double> vectors = null_vectors(samples());
  const auto space = matrix(vectors, rows_.size());
  for (Eigen::Index i = 0; i < space.rows(); ++i)
    if (space.row(i).squaredNorm() > share_of_equation) found.push_back(rows_[static_cast<std::size_t>(i)]);
  return found;
}

std::vector<double> ConstraintRank::misfit(std::span<const double> gaps) const {
  std::vector<double> open(gaps.size(), 0.0);
  if (count() == 0) return open;
  const auto space = matrix(null_space(), rows_.size());
  if (!whole_null_space_) return open;
  Eigen::VectorXd scaled(space.rows());
  for (std::size_t i = 0; i < rows_.size(); ++i)
    scaled[static_cast<Eigen::Index>(i)] = gaps[static_cast<std::size_t>(rows_[i])] / roots_[i];
  scaled = space * (space.transpose() * scaled).eval();
  for (std::size_t i = 0; i < rows_.size(); ++i)
    open[static_cast<std::size_t>(rows_[i])] = scaled[static_cast<Eigen::Index>(i)] * roots_[i];
  return open;
}

namespace {

// Calls f(owner, first, count) with the range of each item in `rows`.
template <class F>
void each_owner(std::span<const int> rows, const System& system, F&& f) {
  const auto owners = system.equation_owners();
  auto owner = owners.begin();
  for (std::size_t i = 0; i < rows.size();) {
    while (rows[i] >= owner->first + owner->count) ++owner;
    std::size_t end = i;
    while (end < rows.size() && rows[end] < owner->first + owner->count) ++end;
    f(*owner, static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(end - i));
    i = end;
  }
}

}  // namespace

// The number of removable equations of an item is the rank of its rows in the null space.
std::vector<ConstraintRank::Item> ConstraintRank::items(const System& system) const {
  std::vector<Item> found;
  if (count() == 0) return found;  // a solver that has not started has no system
  const auto space = matrix(null_space(), rows_.size());
  each_owner(rows_, system, [&](const System::EquationOwner& owner, Eigen::Index first, Eigen::Index equations) {
    const Eigen::MatrixXd part = space.middleRows(first, equations);
    if (!(part.squaredNorm() > share_of_equation)) return;
    const auto rank = static_cast<int>(std::ranges::count_if(symmetric_eigenvalues(part * part.transpose()),
                                                             [](double x) { return x > share_of_equation; }));
    const auto acting = std::count(acting_.begin() + owner.first, acting_.begin() + owner.first + owner.count, 1);
    found.push_back({owner.number, system.describe(owner), owner.first, owner.count, static_cast<int>(acting), rank});
  });
  return found;
}

// For each item, the smallest gap of this item alone that has the given null-space part.
std::vector<std::string> ConstraintRank::contradictions(std::span<const double> misfit, const System& system) const {
  constexpr double not_all = 1e-2;
  std::vector<std::string> lines;
  if (count() == 0) return lines;
  const auto space = matrix(null_space(), rows_.size());
  Eigen::VectorXd scaled(space.rows());
  for (std::size_t i = 0; i < rows_.size(); ++i)
    scaled[static_cast<Eigen::Index>(i)] = misfit[static_cast<std::size_t>(rows_[i])] / roots_[i];
  const Eigen::VectorXd whole = space.transpose() * scaled;
  each_owner(rows_, system, [&](const System::EquationOwner& owner, Eigen::Index first, Eigen::Index equations) {
    const Eigen::MatrixXd part = space.middleRows(first, equations).transpose();
    Eigen::VectorXd gap = smallest_solution(part, whole);
    if ((part * gap - whole).norm() > not_all * whole.norm()) return;
    for (Eigen::Index i = 0; i < gap.size(); ++i) gap[i] *= roots_[static_cast<std::size_t>(first + i)];
    Eigen::Index worst = 0;
    gap.cwiseAbs().maxCoeff(&worst);
    const int equation = rows_[static_cast<std::size_t>(first + worst)];
    const CoordinateUnit kind = units_[static_cast<std::size_t>(equation)];
    const char* unit = kind == CoordinateUnit::meter ? " m" : kind == CoordinateUnit::radian ? " rad" : "";
    lines.push_back(system.describe(owner) + ", equation " + std::to_string(equation - owner.first) + ": " +
                    format_number(gap[worst]) + unit);
  });
  return lines;
}

}  // namespace dalembert
