#include "dalembert/solvers/constraint_metric.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Core>

#include "constraints/constraint_states.hpp"
#include "dalembert/math/decompositions.hpp"
#include "dalembert/math/disjoint_sets.hpp"

namespace dalembert {

namespace {

// Smaller masses, relative to others of an equation, belong to motions without inertia.
constexpr double no_inertia = 1e-10;
// Smaller gradients, relative to the largest of all equations, are round-off.
constexpr double round_off_of_forces = 1e-12;
// A column is independent if at least this share of its squared length is in a row of its own.
constexpr double own_share = 1e-3;
// Limits of the arm of moments, in radii of gyration. Otherwise, eps D of one kind would be round-off of the other.
constexpr double smallest_arm = 1e-3, largest_arm = 20;
// Smallest size of a mechanism relative to the model: positions are rounded relative to the size of the model.
constexpr double smallest_share_of_model = 1e-4;

double geometric_mean(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double x : numbers) sum += std::log(x);
  return numbers.empty() ? 0 : std::exp(sum / static_cast<double>(numbers.size()));
}

// The entries of M^-1/2 G^T. Nodes with Euler parameters have a matrix of their own, because the orientation of the body
// determines which of the parameters have inertia.
class ScaledColumns {
 public:
  ScaledColumns(System& system, const State& still, const Conditions& conditions, Inertia inertia)
      : system_(system),
        pattern_(system.pattern(false)),
        ode2_(system.sizes().ode2),
        first_ae_(system.sizes().first_ae()),
        units_(system.coordinate_units()),
        nodes_(system.nodes_of_coordinates()),
        forces_(static_cast<std::size_t>(pattern_.values())),
        masses_(forces_.size()) {
    if (inertia == Inertia::masses)
      system.mass_matrix(still, pattern_, masses_);
    else
      fill_with_lengths();
    system.tangent(still, at_level(conditions, false), along_positions, pattern_, forces_);
    for (int j = 0; j < ode2_; ++j) diagonal_.push_back(masses_[static_cast<std::size_t>(pattern_.slot(j, j))]);
    fill_in_masses(system, diagonal_);
    find_turnings();
  }

  std::span<const CoordinateUnit> units() const { return units_; }

  // Calls f(coordinate, entry) for the entries of an equation in G^T.
  template <class F>
  void each_force(int equation, F&& f) const {
    const ColumnRange column = column_range(pattern_, first_ae_ + equation, ode2_);
    for (std::size_t slot = column.begin; slot < column.middle; ++slot)
      if (forces_[slot] != 0) f(row_in(pattern_, column, slot), forces_[slot]);
  }

  // An inactive equation defines its multiplier.
  bool is_off(int equation) const {
    const int slot = pattern_.slot(first_ae_ + equation, first_ae_ + equation);
    return slot >= 0 && forces_[at(slot)] != 0;
  }

  std::vector<ConstraintMetric::Entry> column(int equation) const {
    std::array<double, 3> inertia{};  // largest inertia by unit
    each_force(equation, [&](int j, double) { inertia[kind(j)] = std::max(inertia[kind(j)], diagonal_[at(j)]); });
    std::map<int, Eigen::VectorXd> moments;  // by node
    std::vector<ConstraintMetric::Entry> entries;
    each_force(equation, [&](int j, double g) {
      const auto turning = turnings_.find(nodes_[at(j)]);
      if (turning != turnings_.end() && units_[at(j)] == CoordinateUnit::radian) {
        Eigen::VectorXd& moment =
            moments.try_emplace(nodes_[at(j)], Eigen::VectorXd::Zero(turning->second.root.rows())).first->second;
        moment[j - turning->second.first] = g;
      } else if (diagonal_[at(j)] > no_inertia * inertia[kind(j)]) {
        entries.push_back({j, g / std::sqrt(diagonal_[at(j)])});
      }
    });
    for (const auto& [node, moment] : moments) {
      const Turning& turning = turnings_.at(node);
      const Eigen::VectorXd scaled = turning.root * moment;
      for (Eigen::Index i = 0; i < scaled.size(); ++i)
        entries.push_back({turning.first + static_cast<int>(i), scaled[i]});
    }
    return entries;
  }

 private:
  struct Turning {
    int first;             // first coordinate
    Eigen::MatrixXd root;  // square root of the inverse inertia, without the direction that changes the length
  };
  void fill_with_lengths() {
    const double length = system_.extent();
    for (int j = 0; j < ode2_; ++j)
      masses_[at(pattern_.slot(j, j))] = units_[at(j)] == CoordinateUnit::radian ? length * length : 1;
  }
  static std::size_t at(int j) { return static_cast<std::size_t>(j); }
  std::size_t kind(int j) const { return static_cast<std::size_t>(units_[at(j)]); }

  void find_turnings() {
    for (const System::EquationOwner& owner : system_.equation_owners()) {
      if (!owner.of_node) continue;
      std::vector<std::pair<int, double>> condition;
      each_force(owner.first, [&](int j, double g) { condition.emplace_back(j, g); });
      if (condition.empty()) continue;
      int first = condition.front().first, end = first + 1;
      while (first > 0 && nodes_[at(first - 1)] == nodes_[at(first)] && units_[at(first - 1)] == units_[at(first)])
        --first;
      while (end < ode2_ && nodes_[at(end)] == nodes_[at(first)] && units_[at(end)] == units_[at(first)]) ++end;
      const int n = end - first;
      Eigen::MatrixXd inertia(n, n);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const int slot = pattern_.slot(first + i, first + j);
          inertia(i, j) = slot < 0 ? 0 : masses_[at(slot)];
        }
      for (int i = 0; i < n; ++i)
        if (!(inertia(i, i) > 0)) inertia(i, i) = diagonal_[at(first + i)];  // nodes without inertia
      Eigen::VectorXd longer = Eigen::VectorXd::Zero(n);
      for (const auto& [j, g] : condition)
        if (j >= first && j < end) longer[j - first] = g;
      longer.normalize();
      const Eigen::MatrixXd turned = Eigen::MatrixXd::Identity(n, n) - longer * longer.transpose();
      const SymmetricEigenpairs pairs = symmetric_eigenpairs(turned * (inertia + inertia.transpose()) / 2 * turned);
      Eigen::VectorXd root = pairs.values.cwiseAbs();
      const double least = no_inertia * root.maxCoeff();
      for (double& x : root) x = x > least ? 1 / std::sqrt(x) : 0;
      turnings_.try_emplace(nodes_[at(first)], Turning{first, root.asDiagonal() * pairs.vectors.transpose()});
    }
  }

  System& system_;
  const Pattern& pattern_;
  int ode2_, first_ae_;
  std::vector<CoordinateUnit> units_;
  std::vector<int> nodes_;
  std::vector<double> forces_, masses_, diagonal_;
  std::map<int, Turning> turnings_;
};

// Equations that act on the same body belong to one mechanism.
struct Mechanisms {
  std::vector<int> of_equation, of_coordinate;  // -1 if in no mechanism
  int count = 0;
};
Mechanisms find_mechanisms(const System& system, const ScaledColumns& columns, std::span<const char> examined) {
  const std::vector<int> bodies = system.bodies_of_coordinates();
  const auto numbers = bodies.empty() ? 0 : static_cast<std::size_t>(*std::ranges::max_element(bodies) + 1);
  const int equations = static_cast<int>(examined.size());
  DisjointSets joined(equations);
  std::vector<int> first(numbers, -1);  // first equation of each body
  for (int k = 0; k < equations; ++k) {
    if (!examined[static_cast<std::size_t>(k)]) continue;
    columns.each_force(k, [&](int j, double) {
      const int body = bodies[static_cast<std::size_t>(j)];
      if (body < 0) return;
      int& other = first[static_cast<std::size_t>(body)];
      if (other < 0)
        other = k;
      else
        joined.join(k, other);
    });
  }
  Mechanisms found{std::vector<int>(examined.size(), -1), std::vector<int>(bodies.size(), -1)};
  std::vector<int> number(examined.size(), -1);
  const auto number_of = [&](int k) {
    int& known = number[static_cast<std::size_t>(joined.of(k))];
    return known < 0 ? known = found.count++ : known;
  };
  for (int k = 0; k < equations; ++k)
    if (examined[static_cast<std::size_t>(k)]) found.of_equation[static_cast<std::size_t>(k)] = number_of(k);
  for (std::size_t j = 0; j < bodies.size(); ++j)
    if (bodies[j] >= 0 && first[static_cast<std::size_t>(bodies[j])] >= 0)
      found.of_coordinate[j] = number_of(first[static_cast<std::size_t>(bodies[j])]);
  return found;
}

// Equations of one kind have the same weight in a mechanism, independently of masses, so that equal hinges carry equal parts.
struct KindWeights {
  double force = 0, moment = 0, other = 0, size = 0;
  KindWeights(std::map<CoordinateUnit, std::vector<double>> of_kind, double size_of_mechanism, double size_of_model,
              double moment_length)
      : force(geometric_mean(of_kind[CoordinateUnit::meter])),
        moment(geometric_mean(of_kind[CoordinateUnit::radian])),
        other(geometric_mean(of_kind[CoordinateUnit::unknown])) {
    const double gyration = force > 0 && moment > 0 ? std::sqrt(force / moment) : 0;
    // The size of a mechanism without extent, such as a wheel on a shaft, is that of its bodies.
    size = size_of_mechanism > 0 ? size_of_mechanism : gyration > 0 ? gyration : size_of_model;
    const double arm = gyration > 0 ? std::clamp(size, smallest_arm * gyration, largest_arm * gyration) : size;
    const double length = moment_length > 0 ? moment_length : arm;
    if (force > 0)
      moment = force / (length * length);
    else if (moment > 0)
      force = moment * length * length;
  }
  double of(CoordinateUnit kind) const {
    const double weight = kind == CoordinateUnit::meter    ? force
                          : kind == CoordinateUnit::radian ? moment
                          : other > 0                      ? other
                                                           : force;
    return weight > 0 ? weight : 1;
  }
};

double squared_length(const std::vector<ConstraintMetric::Entry>& column) {
  double sum = 0;
  for (const auto& [row, value] : column) sum += value * value;
  return sum;
}

// Removes columns one by one, each with a row in which no other column has an entry. Removals may free rows for others.
bool all_have_own_rows(const std::vector<std::vector<ConstraintMetric::Entry>>& columns, std::span<const char> examined,
                       int rows) {
  // By row: number of columns with an entry, and the sum of their indices.
  std::vector<int> count(static_cast<std::size_t>(rows), 0), sum(count.size(), 0), alone;
  const auto each = [&](int k, auto&& f) {
    for (const auto& [row, value] : columns[static_cast<std::size_t>(k)])
      if (value != 0) f(static_cast<std::size_t>(row), value);
  };
  std::size_t left = 0;
  for (int k = 0; k < static_cast<int>(columns.size()); ++k) {
    left += examined[static_cast<std::size_t>(k)] != 0;
    each(k, [&](std::size_t j, double) {
      ++count[j];
      sum[j] += k;
    });
  }
  for (std::size_t j = 0; j < count.size(); ++j)
    if (count[j] == 1) alone.push_back(static_cast<int>(j));
  while (!alone.empty()) {
    const auto j = static_cast<std::size_t>(alone.back());
    alone.pop_back();
    if (count[j] != 1) continue;
    const int k = sum[j];
    const double enough = own_share * squared_length(columns[static_cast<std::size_t>(k)]);
    bool own = false;
    each(k, [&](std::size_t i, double value) { own |= i == j && value * value >= enough; });
    if (!own) continue;
    --left;
    each(k, [&](std::size_t i, double) {
      sum[i] -= k;
      if (--count[i] == 1) alone.push_back(static_cast<int>(i));
    });
  }
  return left == 0;
}

}  // namespace

double smallest_unit(const System& system) { return smallest_share_of_model * system.extent(); }

double ConstraintMetric::largest(std::span<const double> gaps) const {
  double size = 0;
  for (std::size_t k = 0; k < weights.size(); ++k)
    if (weights[k] > 0) size = std::max(size, std::abs(gaps[k]) / units[k]);
  return size;
}

ConstraintMetric constraint_metric(System& system, const State& state, const Conditions& conditions,
                                   double moment_length, Inertia inertia) {
  const auto n = static_cast<std::size_t>(system.sizes().ae);
  ConstraintMetric metric{std::vector<double>(n, 0.0), std::vector<double>(n, 1.0),
                          std::vector<CoordinateUnit>(n, CoordinateUnit::unknown), std::vector<char>(n, 0),
                          std::vector<std::vector<ConstraintMetric::Entry>>(n)};
  if (n == 0) return metric;
  const ScaledColumns columns(system, without_multipliers(state), conditions, inertia);
  std::vector<char> examined(n);
  for (std::size_t k = 0; k < n; ++k)
    examined[k] = system.constrains_motion(static_cast<int>(k)) && !columns.is_off(static_cast<int>(k));
  for (const System::EquationOwner& owner : system.equation_owners())
    if (owner.of_node) std::fill_n(examined.begin() + owner.first, owner.count, 0);

  std::vector<double> ratios(n, 0.0);
  double largest_force = 0;
  std::vector<double> forces(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    columns.each_force(static_cast<int>(k), [&](int j, double g) {
      forces[k] += g * g;
      metric.acting[k] = 1;
      metric.kinds[k] = std::max(metric.kinds[k], columns.units()[static_cast<std::size_t>(j)]);
    });
    largest_force = std::max(largest_force, forces[k]);
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (!examined[k]) continue;
    if (!(forces[k] > round_off_of_forces * round_off_of_forces * largest_force))
      continue;  // redundant: it acts on no coordinate
    metric.columns[k] = columns.column(static_cast<int>(k));
    ratios[k] = squared_length(metric.columns[k]);
  }
  const Mechanisms mechanisms = find_mechanisms(system, columns, examined);
  const std::vector<double> lengths = system.extents(mechanisms.of_coordinate, mechanisms.count);
  std::vector<std::map<CoordinateUnit, std::vector<double>>> apart(lengths.size());
  std::map<CoordinateUnit, std::vector<double>> all;
  for (std::size_t k = 0; k < n; ++k) {
    if (!(ratios[k] > 0 && std::isfinite(ratios[k]))) continue;
    apart[static_cast<std::size_t>(mechanisms.of_equation[k])][metric.kinds[k]].push_back(ratios[k]);
    all[metric.kinds[k]].push_back(ratios[k]);
  }
  std::vector<KindWeights> weights;
  const double extent = system.extent();
  for (std::size_t i = 0; i < lengths.size(); ++i)
    weights.emplace_back(apart[i].empty() ? all : apart[i], lengths[i], extent, moment_length);
  for (std::size_t k = 0; k < n; ++k) {
    if (!examined[k]) continue;
    const KindWeights& known = weights[static_cast<std::size_t>(mechanisms.of_equation[k])];
    metric.weights[k] = known.of(metric.kinds[k]);
    if (metric.kinds[k] == CoordinateUnit::meter)
      metric.units[k] = std::max(known.size, smallest_share_of_model * extent);
  }
  metric.has_loops = !all_have_own_rows(metric.columns, examined, system.sizes().ode2);
  return metric;
}

}  // namespace dalembert
