#include "dalembert/solvers/redundant_constraints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "constraints/constraint_states.hpp"
#include "dalembert/math/decompositions.hpp"
#include "dalembert/math/disjoint_sets.hpp"
#include "diagnosis/finite.hpp"
#include "steppers/number_sequence.hpp"

namespace dalembert {

namespace {

// Entries of the diagonal that are so much smaller than others of an equation belong to motions without inertia.
constexpr double no_inertia = 1e-10;
// What constrains links of a tree to a plane where they move in it anyway acts on none of their coordinates, but for round-off: relative to the
// largest entries of other equations.
constexpr double round_off_of_forces = 1e-12;
// Equations whose combinations are so much weaker than the equations themselves are worth a closer look: far above what counts as vanishing.
constexpr double suspicious_multiple = 1e4;
// The filter is applied again as long as it would take more than this off multipliers that forces come from.
constexpr double harmless_share = 1e-7;
constexpr int most_passes = 3, most_times = 4;
// An idle part leaves 1e-16 / eps of it as round-off: this times eps of the multipliers may be idle, such that 1e-10 of them is left.
constexpr double harmless_round_off = 1e6;
// The range for redundancy that lasts: below, round-off of multipliers shows; above, singular positions are not passed.
constexpr double smallest_eps = 1e-11;
// Beside the weakest constraint that is none of the redundant ones.
constexpr double share_of_weakest = 1e-3;
// Joints apart by a misfit m (relative to the size of the mechanism) constrain with m^2 what aligned ones would leave free, and so do those
// that have drifted apart because velocities alone are constrained.
constexpr double misaligned = 1e6, eps_for_misfits = 1e-8;
// Where velocities alone are constrained, gaps stay, and what they leave of combinations would take a part of the motion in each step.
constexpr double multiple_of_vanishing = 100;

// Beside the radius of gyration of bodies, places may be much closer together than it, and models much larger: what moments count for is limited
// to these multiples of it. Beyond, their part of eps D would be round-off beside that of forces, or of the inertia of bodies.
constexpr double smallest_arm = 1e-3, largest_arm = 20;
// Mechanisms may be that much smaller than the model: positions in it are rounded by more than what counts in smaller ones.
constexpr double smallest_share_of_model = 1e-4;

double mean_of_logarithms(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double x : numbers) sum += std::log(x);
  return numbers.empty() ? 0 : std::exp(sum / static_cast<double>(numbers.size()));
}

// Of equations by what they are about, from their own.
class WeightsOfKinds {
 public:
  using Kinds = std::map<CoordinateUnit, std::vector<double>>;
  // Mechanisms of no size, such as a wheel on a shaft, have that of their bodies.
  WeightsOfKinds(Kinds kinds, double size_of_mechanism, double size_of_model, double moment_length)
      : force_(mean_of_logarithms(kinds[CoordinateUnit::meter])),
        moment_(mean_of_logarithms(kinds[CoordinateUnit::radian])),
        other_(mean_of_logarithms(kinds[CoordinateUnit::unknown])) {
    const double radius_of_gyration = force_ > 0 && moment_ > 0 ? std::sqrt(force_ / moment_) : 0;
    size_ = size_of_mechanism > 0 ? size_of_mechanism : radius_of_gyration > 0 ? radius_of_gyration : size_of_model;
    arm_ = radius_of_gyration > 0 ? std::clamp(size_, smallest_arm * radius_of_gyration, largest_arm * radius_of_gyration) : size_;
    const double length = moment_length > 0 ? moment_length : arm_;
    if (force_ > 0) moment_ = force_ / (length * length);
    else if (moment_ > 0) force_ = moment_ * length * length;
  }
  double size() const { return size_; }
  double arm() const { return arm_; }  // of forces
  double of(CoordinateUnit unit) const {
    const double weight = unit == CoordinateUnit::meter ? force_ : unit == CoordinateUnit::radian ? moment_ : other_ > 0 ? other_ : force_;
    return weight > 0 ? weight : 1.0;
  }

 private:
  double force_, moment_, other_, size_ = 0, arm_ = 1;
};

double largest_number(std::span<const double> numbers) {
  double size = 0;
  for (const double x : numbers) size = std::max(size, std::abs(x));
  return size;
}

// An equation is independent of others if this share of what it states, in the metric of the diagonal, is a coordinate of its own.
constexpr double own_share = 1e-3;

// f(coordinate, share) for the entries of G^T in the column of an equation.
template <class F>
void each_share(const Pattern& pattern, std::span<const double> values, std::span<const double> diagonal, int column, F&& f) {
  const int ode2 = static_cast<int>(diagonal.size());
  const ColumnRange range = column_range(pattern, column, ode2);
  for (std::size_t slot = range.begin; slot < range.middle; ++slot) {
    if (values[slot] == 0) continue;
    const int row = row_in(pattern, range, slot);
    f(row, diagonal[static_cast<std::size_t>(row)] > 0 ? values[slot] * values[slot] / diagonal[static_cast<std::size_t>(row)] : 0);
  }
}

// Rotations by parameters whose length is one: how a body is turned decides which of these have inertia, and what makes them longer moves nothing.
struct Turning {
  std::size_t first;           // coordinate
  Eigen::MatrixXd compliance;  // what generalized forces turn, by masses and stiffness of the matrix
};

// By node.
std::map<int, Turning> turnings(const System& system, const Pattern& pattern, std::span<const double> values, std::span<const int> nodes) {
  const std::vector<CoordinateUnit> units = system.coordinate_units();
  std::map<int, Turning> found;
  for (const System::EquationOwner& owner : system.equation_owners()) {
    if (!owner.of_node) continue;
    const ColumnRange column = column_range(pattern, system.sizes().first_ae() + owner.first, static_cast<int>(nodes.size()));
    std::size_t entry = column.begin;
    while (entry < column.middle && values[entry] == 0) ++entry;
    if (entry == column.middle) continue;
    std::size_t first = static_cast<std::size_t>(row_in(pattern, column, entry)), end = first + 1;
    while (first > 0 && nodes[first - 1] == nodes[end - 1] && units[first - 1] == units[end - 1]) --first;
    while (end < nodes.size() && nodes[end] == nodes[first] && units[end] == units[first]) ++end;
    const auto n = static_cast<Eigen::Index>(end - first);
    const auto place = [=](int row) { return static_cast<Eigen::Index>(static_cast<std::size_t>(row) - first); };
    Eigen::MatrixXd inertia = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t j = first; j < end; ++j) {
      const ColumnRange own = column_range(pattern, static_cast<int>(j), static_cast<int>(end));
      for (std::size_t slot = own.begin; slot < own.middle; ++slot)
        if (const int row = row_in(pattern, own, slot); static_cast<std::size_t>(row) >= first) inertia(place(row), place(static_cast<int>(j))) = values[slot];
    }
    Eigen::VectorXd longer = Eigen::VectorXd::Zero(n);
    for (std::size_t slot = entry; slot < column.middle; ++slot)
      if (values[slot] != 0) longer[place(row_in(pattern, column, slot))] = values[slot];
    longer.normalize();
    const Eigen::MatrixXd turned = Eigen::MatrixXd::Identity(n, n) - longer * longer.transpose();
    const SymmetricEigenpairs pairs = symmetric_eigenpairs(turned * (inertia + inertia.transpose()) / 2 * turned);
    Eigen::VectorXd inverse = pairs.values.cwiseAbs();
    const double least = no_inertia * inverse.maxCoeff();
    for (double& x : inverse) x = x > least ? 1 / x : 0;
    found.try_emplace(nodes[first], Turning{first, pairs.vectors * inverse.asDiagonal() * pairs.vectors.transpose()});
  }
  return found;
}

}  // namespace

// Equations are taken away one by one, each at a coordinate that it alone acts on, which may leave others alone with theirs.
bool RedundantConstraints::evidently_none(const System& system, const Pattern& pattern, std::span<const double> values) {
  const Sizes& s = system.sizes();
  const auto n = static_cast<std::size_t>(s.ae), coordinates = static_cast<std::size_t>(s.ode2);
  std::vector<double> diagonal(coordinates, 0.0), total(n, 0.0);
  std::vector<int> count(coordinates, 0), sum(coordinates, 0), alone;  // equations that act on a coordinate, and the sum of their numbers
  const auto each = [&](int k, auto&& f) { each_share(pattern, values, diagonal, s.first_ae() + k, f); };
  for (int k = 0; k < s.ae; ++k) {
    each(k, [&](int j, double) {
      if (count[j]++ == 0) diagonal[j] = std::abs(values[static_cast<std::size_t>(pattern.slot(j, j))]);
      sum[j] += k;
    });
  }
  for (int k = 0; k < s.ae; ++k) each(k, [&](int, double share) { total[static_cast<std::size_t>(k)] += share; });
  for (int j = 0; j < s.ode2; ++j)
    if (count[j] == 1) alone.push_back(j);
  std::vector<char> taken(n, 0);
  while (!alone.empty()) {
    const int j = alone.back(), k = sum[j];
    alone.pop_back();
    if (count[j] != 1) continue;
    bool own = false;
    each(k, [&](int i, double share) { own |= i == j && share >= own_share * total[static_cast<std::size_t>(k)] && share > 0; });
    if (!own) continue;
    taken[static_cast<std::size_t>(k)] = 1;
    each(k, [&](int i, double) {
      sum[i] -= k;
      if (--count[i] == 1) alone.push_back(i);
    });
  }
  for (const System::EquationOwner& owner : system.equation_owners()) {
    for (int k = owner.first; k < owner.first + owner.count && !owner.of_node; ++k)
      if (taken[static_cast<std::size_t>(k)] == 0 && system.constrains_motion(k)) return false;
  }
  return true;
}

// Conditions of unit length act on coordinates of their own nodes.
int RedundantConstraints::equations_beyond_coordinates(const System& system, const Pattern& pattern, std::span<const double> values) {
  const Sizes& s = system.sizes();
  std::vector<char> acted_on(static_cast<std::size_t>(s.ode2), 0);
  int equations = 0, coordinates = 0;
  for (int k = 0; k < s.ae; ++k) {
    if (!system.constrains_motion(k)) continue;
    const ColumnRange column = column_range(pattern, s.first_ae() + k, s.ode2);
    bool acts = false;
    for (std::size_t slot = column.begin; slot < column.middle; ++slot) {
      if (values[slot] == 0) continue;
      acts = true;
      char& known = acted_on[static_cast<std::size_t>(row_in(pattern, column, slot))];
      coordinates += known == 0;
      known = 1;
    }
    for (std::size_t slot = column.middle; slot < column.end; ++slot) acts = acts && values[slot] == 0;  // otherwise it states its multiplier
    equations += acts;
  }
  return equations - coordinates;
}

bool RedundantConstraints::measure(System& system, const Pattern& pattern, std::span<const double> values, double moment_length,
                                   double rate_factor) {
  const Sizes& s = system.sizes();
  first_ae_ = s.first_ae();
  rate_factor_ = rate_factor;
  count_ = 0;
  parts_.clear();
  slots_.clear();
  entries_.clear();
  harmless_.clear();
  local_ = lasts_ = false;
  certain_ = true;
  counting_ = counting_eps;
  weakest_by_masses_ = 0;
  weight_scale_ = 1;
  const auto n = static_cast<std::size_t>(s.ae);
  x_.resize(static_cast<std::size_t>(s.total()));
  length_ = system.extent();
  multiplier_.resize(n);
  for (int k = 0; k < s.ae; ++k) multiplier_[k] = system.constrains_motion(k);
  std::vector<char> eligible = multiplier_;
  for (const System::EquationOwner& owner : system.equation_owners())
    if (owner.of_node) std::fill_n(eligible.begin() + owner.first, owner.count, 0);
  rows_.clear();
  for (int k = 0; k < s.ae; ++k)
    if (eligible[k]) rows_.push_back(k);
  if (rows_.empty()) return false;
  nodes_ = system.nodes_of_coordinates();

  std::vector<double> diagonal(static_cast<std::size_t>(s.ode2)), ratio(n, 0.0), columns(n, 0.0), lines(n, 0.0);
  const std::vector<CoordinateUnit> units_of_coordinates = system.coordinate_units();
  std::vector<std::array<double, 3>> largest(n, std::array<double, 3>{});  // by unit
  const auto inertia_beside = [&](int k, int j) -> double& { return largest[static_cast<std::size_t>(k)][static_cast<std::size_t>(units_of_coordinates[static_cast<std::size_t>(j)])]; };
  for (int j = 0; j < s.ode2; ++j) diagonal[j] = std::abs(values[static_cast<std::size_t>(pattern.slot(j, j))]);
  const std::map<int, Turning> turning = turnings(system, pattern, values, nodes_);
  std::vector<CoordinateUnit> units(n, CoordinateUnit::unknown);
  const auto each_force = [&](auto&& f) {  // f(equation, coordinate, entry) of G^T
    for (int k = 0; k < s.ae; ++k) {
      const ColumnRange column = column_range(pattern, first_ae_ + k, s.ode2);
      for (std::size_t slot = column.begin; slot < column.middle; ++slot)
        if (values[slot] != 0) f(k, row_in(pattern, column, slot), values[slot]);
    }
  };
  each_force([&](int k, int j, double g) {
    inertia_beside(k, j) = std::max(inertia_beside(k, j), diagonal[j]);
    columns[k] += g * g;
    units[k] = std::max(units[k], units_of_coordinates[j]);
  });
  int equation = -1, node = -1;
  Eigen::VectorXd moment;
  const auto add_turning = [&] {
    if (equation >= 0) ratio[static_cast<std::size_t>(equation)] += moment.dot(turning.at(node).compliance * moment);
    equation = -1;
  };
  each_force([&](int k, int j, double g) {
    const int at = nodes_[static_cast<std::size_t>(j)];
    const auto turns = turning.find(at);
    if (turns == turning.end() || units_of_coordinates[j] != CoordinateUnit::radian) {
      if (diagonal[j] > no_inertia * inertia_beside(k, j)) ratio[k] += g * g / diagonal[j];
      return;
    }
    if (k != equation || at != node) {
      add_turning();
      equation = k, node = at;
      moment = Eigen::VectorXd::Zero(turns->second.compliance.rows());
    }
    moment[static_cast<Eigen::Index>(static_cast<std::size_t>(j) - turns->second.first)] = g;
  });
  add_turning();
  for (int j = 0; j < s.ode2; ++j) {
    const ColumnRange column = column_range(pattern, j, first_ae_);
    for (std::size_t slot = column.middle; slot < column.end; ++slot)
      if (values[slot] != 0) lines[row_in(pattern, column, slot) - first_ae_] += values[slot] * values[slot];
  }
  acting_.assign(n, 0);
  std::ranges::transform(columns, acting_.begin(), [](double sum) { return sum > 0; });
  const double nothing = round_off_of_forces * round_off_of_forces * largest_number(columns);
  for (std::size_t k = 0; k < n; ++k)
    if (!(columns[k] > nothing)) ratio[k] = 0;
  of_rate_.assign(n, 0);
  for (std::size_t k = 0; k < n; ++k) {
    const double factor = columns[k] > 0 && lines[k] > 0 ? 0.5 * std::log(lines[k] / columns[k]) : 0;
    of_rate_[k] = std::abs(factor - std::log(rate_factor)) < std::abs(factor);
  }
  const int mechanisms = find_mechanisms(pattern, values, system.bodies_of_coordinates());
  lengths_ = system.extents(mechanism_of_coordinate_, mechanisms);
  find_weights(ratio, units, moment_length);
  find_scales(pattern, values, units_of_coordinates);
  return true;
}

int RedundantConstraints::find_mechanisms(const Pattern& pattern, std::span<const double> values, std::span<const int> bodies) {
  const std::size_t numbers = bodies.empty() ? 0 : static_cast<std::size_t>(*std::ranges::max_element(bodies) + 1);
  const std::size_t equations = multiplier_.size();
  DisjointSets joined(static_cast<int>(equations));
  std::vector<int> first(numbers, -1);  // equation of a body
  for (const int k : rows_) {
    const ColumnRange column = column_range(pattern, first_ae_ + k, static_cast<int>(bodies.size()));
    for (std::size_t slot = column.begin; slot < column.middle; ++slot) {
      const int body = values[slot] != 0 ? bodies[static_cast<std::size_t>(row_in(pattern, column, slot))] : -1;
      if (body < 0) continue;
      int& other = first[static_cast<std::size_t>(body)];
      if (other < 0) other = k;
      else joined.join(k, other);
    }
  }
  int count = 0;
  std::vector<int> number(equations, -1);
  const auto number_of = [&](int k) {
    int& known = number[static_cast<std::size_t>(joined.of(k))];
    return known < 0 ? known = count++ : known;
  };
  mechanism_.assign(equations, -1);
  for (const int k : rows_) mechanism_[static_cast<std::size_t>(k)] = number_of(k);
  mechanism_of_coordinate_.assign(bodies.size(), -1);
  for (std::size_t j = 0; j < bodies.size(); ++j)
    if (bodies[j] >= 0 && first[static_cast<std::size_t>(bodies[j])] >= 0) mechanism_of_coordinate_[j] = number_of(first[static_cast<std::size_t>(bodies[j])]);
  return count;
}

// Equations of a kind have one weight in a mechanism, whatever its bodies weigh: equal hinges carry equal parts.
void RedundantConstraints::find_weights(const std::vector<double>& ratios, const std::vector<CoordinateUnit>& units, double moment_length) {
  std::vector<WeightsOfKinds::Kinds> apart(lengths_.size());
  WeightsOfKinds::Kinds all;
  for (const int k : rows_) {
    if (!(ratios[k] > 0 && std::isfinite(ratios[k]))) continue;
    apart[static_cast<std::size_t>(mechanism_[k])][units[k]].push_back(ratios[k]);
    all[units[k]].push_back(ratios[k]);
  }
  std::vector<WeightsOfKinds> weights;
  for (std::size_t i = 0; i < lengths_.size(); ++i) weights.emplace_back(apart[i].empty() ? all : apart[i], lengths_[i], length_, moment_length);
  arms_.clear();
  std::ranges::transform(weights, std::back_inserter(arms_), &WeightsOfKinds::arm);
  units_ = units;
  weight_.assign(ratios.size(), 0.0);
  own_weight_.assign(ratios.size(), 0.0);
  unit_.assign(ratios.size(), 1.0);
  for (const int k : rows_) {
    const WeightsOfKinds& known = weights[static_cast<std::size_t>(mechanism_[k])];
    weight_[k] = known.of(units[k]);
    own_weight_[k] = ratios[k] > 0 && std::isfinite(ratios[k]) ? ratios[k] : weight_[k];
    if (units[k] == CoordinateUnit::meter) unit_[k] = std::max(known.size(), smallest_share_of_model * length_);
  }
}

void RedundantConstraints::scale_weights(double factor) {
  for (double& weight : weight_) weight *= factor;
  weight_scale_ *= factor;
}

// What equations state is of one size, in units of length: rotations count by the arm of moments, and coordinates of trees, of which nobody knows
// whether they turn, by the longest lever, if it is more than one.
void RedundantConstraints::find_scales(const Pattern& pattern, std::span<const double> values, std::span<const CoordinateUnit> units) {
  scales_.assign(units.size(), 1.0);
  std::vector<double> largest(units.size(), 1.0);
  for (const int k : rows_) {
    const double arm = units_[k] == CoordinateUnit::radian ? arms_[static_cast<std::size_t>(mechanism_[k])] : 1;
    const ColumnRange column = column_range(pattern, first_ae_ + k, static_cast<int>(units.size()));
    for (std::size_t slot = column.begin; slot < column.middle; ++slot) {
      double& most = largest[static_cast<std::size_t>(row_in(pattern, column, slot))];
      most = std::max(most, arm * std::abs(values[slot]));
    }
  }
  for (std::size_t j = 0; j < units.size(); ++j) {
    const int mechanism = mechanism_of_coordinate_[j];
    if (units[j] == CoordinateUnit::unknown) scales_[j] = 1 / largest[j];
    if (units[j] == CoordinateUnit::radian && mechanism >= 0) scales_[j] = 1 / arms_[static_cast<std::size_t>(mechanism)];
  }
}

void RedundantConstraints::apply(LinearSolver& factors, double eps, std::span<const double> weights, std::span<double> multipliers) {
  std::ranges::fill(x_, 0.0);
  for (const int k : rows_) x_[static_cast<std::size_t>(first_ae_ + k)] = -eps * row_factor(k) * weights[k] * multipliers[k];
  factors.solve(x_);
  for (std::size_t k = 0; k < multipliers.size(); ++k)
    multipliers[k] = multiplier_[k] ? x_[static_cast<std::size_t>(first_ae_) + k] : 0;
}

// Without eps the operator is S^-1 D, which makes large what forces hardly come from. The factors of a matrix that is singular but for
// round-off show it at once: combinations that vanish have a share in the mixture. Equations have weights of their own, since one between
// light bodies is not weak.
double RedundantConstraints::growth(LinearSolver& factors) {
  NumberSequence random;
  std::vector<double> lambda(weight_.size(), 0.0);
  for (const int k : rows_) lambda[k] = random();
  const auto size = [&] {
    double sum = 0;
    for (const int k : rows_) sum += own_weight_[k] * lambda[k] * lambda[k];
    return std::sqrt(sum);
  };
  const double before = size();
  apply(factors, 1, own_weight_, lambda);
  return size() / before;
}

bool RedundantConstraints::suspected(LinearSolver& factors) { return !(suspicious_multiple * counting_ * growth(factors) < 1); }

std::vector<int> RedundantConstraints::equations() const {
  std::vector<int> found;
  for (const Part& part : parts_)
    for (std::size_t i = 0; i < part.rows.size(); ++i)
      if (part.has(i)) found.push_back(rows_[static_cast<std::size_t>(part.rows[i])]);
  std::ranges::sort(found);
  return found;
}

std::vector<double> RedundantConstraints::misfit(std::span<const double> gaps) const {
  std::vector<double> open(gaps.size(), 0.0);
  for (const Part& part : parts_)
    for (int k = 0; k < part.count; ++k) {
      const std::span<const double> combination = part.combination(k);
      double share = 0;
      for (std::size_t i = 0; i < part.rows.size(); ++i) share += combination[i] * gaps[rows_[part.rows[i]]] / std::sqrt(weight_[rows_[part.rows[i]]]);
      for (std::size_t i = 0; i < part.rows.size(); ++i) open[rows_[part.rows[i]]] += share * combination[i] * std::sqrt(weight_[rows_[part.rows[i]]]);
    }
  return open;
}

double RedundantConstraints::largest(std::span<const double> gaps) const {
  double size = 0;
  for (const int k : rows_) size = std::max(size, std::abs(gaps[static_cast<std::size_t>(k)]) / unit(k));
  return size;
}

double RedundantConstraints::largest_of_all(std::span<const double> gaps) const {
  double size = 0;
  for (std::size_t k = 0; k < gaps.size(); ++k) size = std::max(size, std::abs(gaps[k]) / unit_[k]);
  return size;
}

double RedundantConstraints::largest_apart(std::span<const double> gaps) const {
  double size = 0;
  for (const int k : rows_) size = std::max(size, std::abs(gaps[static_cast<std::size_t>(k)]) / unit_[static_cast<std::size_t>(k)]);
  return size;
}

std::vector<double> RedundantConstraints::left_open(LinearSolver& factors, std::span<const double> gaps) {
  std::vector<double> open(gaps.size(), 0.0);
  std::ranges::fill(x_, 0.0);
  for (const int k : rows_) x_[static_cast<std::size_t>(first_ae_ + k)] = gaps[static_cast<std::size_t>(k)];
  factors.solve(x_);
  for (const int k : rows_) open[static_cast<std::size_t>(k)] = -left_open(k, x_[static_cast<std::size_t>(first_ae_ + k)]);
  return open;
}

double RedundantConstraints::largest_left_open(LinearSolver& factors, std::span<const double> gaps) {
  std::vector<double> of_rows(gaps.begin(), gaps.end());
  for (const int k : rows_) of_rows[static_cast<std::size_t>(k)] *= row_factor(k);
  return largest(left_open(factors, of_rows));
}

void RedundantConstraints::allow_for(std::span<const double> gaps) {
  constexpr double largest_ratio = 3;  // of what is left to the gap
  const double left = largest_ratio * largest_apart(gaps);
  counting_ = std::clamp(left * left, counting_eps, largest_eps);
}

// In each iteration: factors of rows, which gaps and their units have in common, and products that do not change are left out.
bool RedundantConstraints::leaves_open(std::span<const double> multipliers, double share) const {
  if (harmless_.empty())
    for (const int k : rows_) harmless_.push_back(unit_[static_cast<std::size_t>(k)] / (eps_ * weight_[static_cast<std::size_t>(k)]));
  bool any = false;
  for (std::size_t i = 0; i < rows_.size(); ++i) any |= std::abs(multipliers[static_cast<std::size_t>(rows_[i])]) > share * harmless_[i];
  return any;
}

double RedundantConstraints::eps_for(double misfit, bool of_rates) const {
  const double weak = std::max(smallest_eps, share_of_weakest * weakest_);
  if (of_rates) return std::min(weak, std::max(largest_eps, multiple_of_vanishing * counting_));
  if (!(misfit > silent_misfit)) return std::min(weak, regular_eps);
  return std::min({weak, largest_eps, std::max(eps_for_misfits, misaligned * misfit * misfit)});
}

double RedundantConstraints::eps_for_gaps(std::span<const double> gaps, bool of_rates, const std::function<void(double)>& find) {
  const double open = largest(misfit(gaps));
  consistent_ = !(open > silent_misfit);
  if (!consistent_) find(std::max(eps_for_misfits, counting_));
  return eps_for(open, of_rates);
}

std::vector<int> RedundantConstraints::unknowns() const {
  std::vector<int> all;
  for (const int k : rows_) all.push_back(first_ae_ + k);
  return all;
}

LinearSolverOptions RedundantConstraints::options_to_find(LinearSolverOptions options) const {
  options.unsettled_matrices = 0;
  options.tiny_diagonal = unknowns();
  return options;
}

LinearSolverOptions RedundantConstraints::options(LinearSolverOptions options) const {
  options.tiny_diagonal = unknowns();
  for (const DependentEquations& part : dependent())
    for (const int k : part.dependent) options.dependent.push_back(first_ae_ + k);
  return options;
}

std::vector<DependentEquations> RedundantConstraints::dependent() const {
  std::vector<DependentEquations> found;
  for (const Part& part : parts_) {
    if (part.count == 0) continue;
    const auto equations = [&](std::span<const int> places) {
      std::vector<int> all;
      for (const int i : places) all.push_back(rows_[static_cast<std::size_t>(i)]);
      return all;
    };
    DependentEquations& some = found.emplace_back(DependentEquations{equations(part.rows), {}});
    for (const int i : part.leading()) some.dependent.push_back(some.all[static_cast<std::size_t>(i)]);
  }
  return found;
}

int RedundantConstraints::most_of_a_part() const {
  int most = 0;
  for (const Part& part : parts_) most = std::max(most, part.count);
  return most;
}

// Equations that are off state their multipliers themselves.
void RedundantConstraints::regularize(const Pattern& pattern, std::span<double> values, double rate_factor) {
  slots(pattern);
  if (rate_factor != rate_factor_ || entries_.size() != rows_.size()) {
    rate_factor_ = rate_factor;
    entries_.clear();
    for (const int k : rows_) entries_.push_back(entry_of(k));
  }
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    double& entry = values[static_cast<std::size_t>(slots_[i])];
    if (entry == 0) entry = entries_[i];
  }
}

std::span<const int> RedundantConstraints::slots(const Pattern& pattern) {
  if (slots_.empty())
    for (const int k : rows_) slots_.push_back(pattern.slot(first_ae_ + k, first_ae_ + k));
  return slots_;
}

std::vector<double> RedundantConstraints::without_eps(std::span<const double> values) const {
  std::vector<double> plain(values.begin(), values.end());
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    double& entry = plain[static_cast<std::size_t>(slots_[i])];
    if (entry == entry_of(rows_[i])) entry = 0;
  }
  return plain;
}

double RedundantConstraints::largest_weighed(std::span<const double> multipliers) const {
  double size = 0;
  for (const int k : rows_) size = std::max(size, weight_[static_cast<std::size_t>(k)] * multipliers[static_cast<std::size_t>(k)] * multipliers[static_cast<std::size_t>(k)]);
  return std::sqrt(size);
}

// Again where the idle part is so large that its round-off would show, which eps enlarges.
void RedundantConstraints::take_off_idle_part(LinearSolver& factors, std::span<double> multipliers) {
  const double large = std::clamp(harmless_round_off * eps_, 1e-3, 0.1);
  for (int time = 0; time < most_times; ++time) {
    idle_.assign(multipliers.begin(), multipliers.end());
    double share = 1;
    for (int i = 0; i < most_passes && share > harmless_share; ++i) {
      apply(factors, eps_, weight_, idle_);
      share *= eps_ / (eps_ + weakest_);
    }
    for (std::size_t k = 0; k < idle_.size(); ++k) multipliers[k] -= idle_[k];
    if (largest_weighed(idle_) <= large * largest_weighed(multipliers)) break;
  }
}

void RedundantConstraints::take_off_idle_solution(LinearSolver& factors, std::span<double> unknowns) {
  const auto first = static_cast<std::size_t>(first_ae_);
  const auto multipliers = unknowns.subspan(first);
  idle_.assign(multipliers.begin(), multipliers.end());
  apply(factors, eps_, weight_, idle_);
  for (std::size_t i = 0; i < first; ++i) unknowns[i] -= x_[i];
  for (std::size_t k = 0; k < idle_.size(); ++k) multipliers[k] -= idle_[k];
}

// Where joints are apart, what is idle elsewhere exerts forces: one solution leaves a part of it.
int RedundantConstraints::take_off_idle_solution(LinearSolver& factors, std::span<double> unknowns, std::span<double> kept, int most_times) {
  constexpr double harmless_gap = 1e-4;  // of what is taken off at first
  const auto multipliers = unknowns.subspan(static_cast<std::size_t>(first_ae_));
  double first = 0;
  for (int time = 1;; ++time) {
    const std::vector<double> before(multipliers.begin(), multipliers.end());
    take_off_idle_solution(factors, unknowns);
    double open = 0;
    for (const int k : rows_) {
      const auto i = static_cast<std::size_t>(k);
      const double gap = left_open(k, before[i] - multipliers[i]);
      kept[i] -= gap;
      open = std::max(open, std::abs(gap) / unit(k));
    }
    if (time == 1) first = open;
    if (time >= most_times || open <= std::max(round_off_of_gaps, harmless_gap * first)) return time;
  }
}

bool treats_redundancy(const Sizes& sizes, const RedundantConstraintsSettings& settings, bool ignores_singular) {
  return sizes.ae > 0 && settings.treat && !ignores_singular;
}

namespace {

// The forces of constraints around a diagonal: any metric serves for counting, and one without zeros makes the matrix regular whatever the model is.
std::vector<double> forces_beside(std::span<const double> diagonal, System& system, const State& still, const Conditions& conditions, const Pattern& pattern) {
  const Sizes& s = system.sizes();
  std::vector<double> matrix(static_cast<std::size_t>(pattern.values())), part(matrix.size());
  for (int j = 0; j < s.first_ae(); ++j) matrix[static_cast<std::size_t>(pattern.slot(j, j))] = j < s.ode2 ? diagonal[static_cast<std::size_t>(j)] : 1;
  system.tangent(still, at_level(conditions, false), along_positions, pattern, part);
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    if (column >= s.first_ae() && (row < s.ode2 || row >= s.first_ae())) matrix[slot] = part[slot];
  });
  return matrix;
}

// And what velocities change.
std::vector<double> gradients_beside(std::span<const double> diagonal, System& system, const State& still, const Conditions& conditions, const Pattern& pattern) {
  const Sizes& s = system.sizes();
  std::vector<double> matrix = forces_beside(diagonal, system, still, conditions, pattern), part(matrix.size());
  system.tangent(still, at_level(conditions, true), along_velocities, pattern, part);
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    if (row >= s.first_ae() && column < s.ode2) matrix[slot] = part[slot];
  });
  return matrix;
}

// With others where there is no mass.
std::vector<double> diagonal_of_masses(System& system, const State& still, const Pattern& pattern) {
  std::vector<double> masses(static_cast<std::size_t>(pattern.values())), diagonal;
  system.mass_matrix(still, pattern, masses);
  for (int j = 0; j < system.sizes().ode2; ++j) {
    diagonal.push_back(masses[static_cast<std::size_t>(pattern.slot(j, j))]);
  }
  fill_in_masses(system, diagonal);
  return diagonal;
}

// Where a mechanism can go is the same whatever its bodies weigh.
std::vector<double> diagonal_of_lengths(const System& system) {
  const double length = system.extent();
  std::vector<double> diagonal;
  for (const CoordinateUnit unit : system.coordinate_units()) diagonal.push_back(unit == CoordinateUnit::radian ? length * length : 1);
  return diagonal;
}

}  // namespace

double smallest_unit(const System& system) { return smallest_share_of_model * system.extent(); }

ConstraintMetric constraint_metric(System& system, const State& state, Conditions conditions) {
  const Pattern& pattern = system.pattern(false);
  const State still = without_multipliers(state);
  const auto n = static_cast<std::size_t>(system.sizes().ae);
  RedundantConstraints all;
  // Users' functions that are asked for positions alone need not know of velocities.
  if (!all.measure(system, pattern, forces_beside(diagonal_of_masses(system, still, pattern), system, still, conditions, pattern), 0, 1))
    return {std::vector<double>(n), std::vector<double>(n, 1.0)};
  return {all.weights(), all.units()};
}

RedundantConstraints redundant_constraints(System& system, const State& state, Conditions conditions, double moment_length, double eps) {
  const Pattern& pattern = system.pattern(false);
  const State still = without_multipliers(state);
  const std::vector<double> matrix = gradients_beside(diagonal_of_masses(system, still, pattern), system, still, conditions, pattern);
  RedundantConstraints found;
  if (!found.measure(system, pattern, matrix, moment_length, 1)) return found;
  const auto factors = make_linear_solver(pattern, LinearSolverType::EigenSparse, found.options_to_find({}));
  if (eps == 0) found.allow_for(gaps_of_positions(system, state, conditions));
  found.find(pattern, matrix, eps > 0 ? eps : found.counting(), *factors);
  return found;
}

double growth_of_multipliers(System& system, const State& state, Conditions conditions) {
  const Pattern& pattern = system.pattern(false);
  const std::vector<double> matrix = gradients_beside(diagonal_of_lengths(system), system, without_multipliers(state), conditions, pattern);
  RedundantConstraints all;
  if (RedundantConstraints::evidently_none(system, pattern, matrix) || !all.measure(system, pattern, matrix, 0, 1)) return 0;
  const auto factors = make_linear_solver(pattern, LinearSolverType::EigenSparse, {});
  return factors->factorize(matrix) == LinearSolver::success ? all.growth(*factors) : std::numeric_limits<double>::infinity();
}

}  // namespace dalembert
