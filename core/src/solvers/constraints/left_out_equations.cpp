#include "dalembert/solvers/left_out_equations.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dalembert/math/decompositions.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"

namespace dalembert {

namespace {

// Forces of a combination that count as none, and multipliers in it, relative to the largest.
constexpr double no_force = 1e-8, no_multiplier = 1e-10;
constexpr double exact = 1e-10;  // such forces, where another solution would not make reactions better
constexpr int most_repeats = 3;
constexpr double largest_multiple = 10;          // of the multiplier of an equation that is left out, by their weights
// Combinations of all equations: with one solution for each, and one number for each equation of the model.
constexpr std::size_t most_found_alone = 100, most_terms = 1'000'000;

// f(coordinate, entry) for the forces of an equation.
template <class F>
void each_force(const Pattern& pattern, std::span<const double> matrix, int first_ae, int equation, F&& f) {
  const ColumnRange range = column_range(pattern, first_ae + equation, first_ae);
  for (std::size_t slot = range.begin; slot < range.middle; ++slot)
    if (matrix[slot] != 0) f(static_cast<std::size_t>(row_in(pattern, range, slot)), matrix[slot]);
}

}  // namespace

LeftOutEquations::LeftOutEquations(const std::vector<DependentEquations>& parts, std::span<const double> weights, int first_ae)
    : first_ae_(first_ae) {
  for (const double weight : weights) roots_.push_back(std::sqrt(weight));
  for (const DependentEquations& part : parts) {
    for (const int k : part.dependent) {
      equations_.push_back(k);
      Combination& found = combinations_.emplace_back(Combination{{k, 1}});
      for (const int other : part.all)
        if (std::ranges::find(part.dependent, other) == part.dependent.end()) found.push_back({other, 0});
    }
  }
  held_.resize(equations_.size());
}

LinearSolverOptions LeftOutEquations::options(LinearSolverOptions options) const {
  for (const int k : equations_) options.left_out.push_back(first_ae_ + k);
  return options;
}

void LeftOutEquations::hold(std::span<const double> multipliers) {
  for (std::size_t i = 0; i < held_.size(); ++i) held_[i] = multipliers[static_cast<std::size_t>(equations_[i])];
}

// The forces of an equation that is left out are those of others, multiplied by what the factors find for them. Where these are hardly exact, as with
// forces beside small moments, what is left of the forces is found once more.
bool LeftOutEquations::find(const Pattern& pattern, std::span<const double> matrix, LinearSolver& factors) {
  for (Combination& c : combinations_)
    for (Term& term : std::span(c).subspan(1)) term.factor = 0;
  double rest = 1;
  for (int time = 0; time < most_repeats && rest > exact; ++time) {
    improve(pattern, matrix, factors);
    rest = 0;
    for (const Combination& c : combinations_)
      if (const double left = rest_of_forces(c, pattern, matrix); !(left <= rest)) rest = left;
  }
  return rest <= no_force;
}

void LeftOutEquations::improve(const Pattern& pattern, std::span<const double> matrix, LinearSolver& factors) {
  for (const std::vector<int>& group : groups_) {
    std::ranges::fill(x_, 0.0);
    for (const int i : group)
      for (const Term& term : combination(i))
        if (term.factor != 0) each_force(pattern, matrix, first_ae_, term.equation, [&](std::size_t j, double g) { x_[j] += term.factor * g; });
    factors.solve(x_);
    for (const int i : group)
      for (Term& term : std::span(combination(i)).subspan(1)) term.factor -= x_[static_cast<std::size_t>(first_ae_ + term.equation)];
  }
  std::ranges::fill(x_, 0.0);
}

// Of a combination, beside what each of its equations causes. Leaves zeros behind.
double LeftOutEquations::rest_of_forces(const Combination& combination, const Pattern& pattern, std::span<const double> matrix) {
  touched_.clear();
  for (const Term& term : combination)
    each_force(pattern, matrix, first_ae_, term.equation, [&](std::size_t j, double g) {
      if (sizes_[j] == 0) touched_.push_back(j);
      x_[j] += term.factor * g;
      sizes_[j] += std::abs(term.factor * g);
    });
  double rest = 0, whole = 0;
  for (const std::size_t j : touched_) {
    const double force = std::exchange(x_[j], 0.0), size = std::exchange(sizes_[j], 0.0);
    const double inertia = std::abs(matrix[static_cast<std::size_t>(pattern.slot(static_cast<int>(j), static_cast<int>(j)))]);
    if (!(inertia > 0)) continue;
    rest += force * force / inertia;
    whole += size * size / inertia;
  }
  return rest > 0 || std::isnan(rest) ? std::sqrt(rest / whole) : 0;
}

// Of nodes that a combination acts on, such as conditions of unit length.
void LeftOutEquations::add_equations_without_weight(const Pattern& pattern, std::span<const double> matrix) {
  std::vector<std::vector<int>> acting(static_cast<std::size_t>(first_ae_));  // by coordinate
  for (int k = 0; k < static_cast<int>(roots_.size()); ++k)
    if (root(k) == 0) each_force(pattern, matrix, first_ae_, k, [&](std::size_t j, double) { acting[j].push_back(k); });
  for (Combination& c : combinations_) {
    std::vector<int> found;
    for (const Term& term : c)
      each_force(pattern, matrix, first_ae_, term.equation, [&](std::size_t j, double) { found.insert(found.end(), acting[j].begin(), acting[j].end()); });
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const int k : found) c.push_back({k, 0});
  }
}

void LeftOutEquations::allow_all_equations() {
  for (Combination& c : combinations_) {
    c.resize(1);
    for (int k = 0; k < static_cast<int>(roots_.size()); ++k)
      if (std::ranges::find(equations_, k) == equations_.end()) c.push_back({k, 0});
  }
}

// Forces and moments are compared by their weights; what has none, such as conditions of unit length, by its number.
void LeftOutEquations::drop_small_terms() {
  for (Combination& c : combinations_) {
    double largest = 0, heaviest = 0;
    for (const Term& term : c) {
      largest = std::max(largest, std::abs(term.factor));
      heaviest = std::max(heaviest, std::abs(weighed(term)));
    }
    std::erase_if(c, [&](const Term& term) {
      return root(term.equation) > 0 ? !(std::abs(weighed(term)) > no_multiplier * heaviest) : !(std::abs(term.factor) > no_multiplier * largest);
    });
  }
}

// By equation: combinations that it has a part in.
std::vector<std::vector<int>> LeftOutEquations::users() const {
  std::vector<std::vector<int>> all(roots_.size());
  for (int i = 0; i < static_cast<int>(combinations_.size()); ++i)
    for (const Term& term : combination(i)) all[static_cast<std::size_t>(term.equation)].push_back(i);
  return all;
}

void LeftOutEquations::find_groups() {
  groups_.clear();
  const std::vector<std::vector<int>> users_of = users();
  std::vector<std::size_t> group(combinations_.size());
  for (int i = 0; i < static_cast<int>(combinations_.size()); ++i) {
    std::vector<char> taken(groups_.size() + 1, 0);
    for (const Term& term : combination(i))
      for (const int other : users_of[static_cast<std::size_t>(term.equation)])
        if (other < i) taken[group[static_cast<std::size_t>(other)]] = 1;
    const auto free = static_cast<std::size_t>(std::ranges::find(taken, 0) - taken.begin());
    if (free == groups_.size()) groups_.emplace_back();
    groups_[free].push_back(i);
    group[static_cast<std::size_t>(i)] = free;
  }
}

void LeftOutEquations::find_clusters() {
  clusters_.clear();
  const std::vector<std::vector<int>> users_of = users();
  std::vector<char> known(combinations_.size(), 0), seen(roots_.size(), 0);
  for (int i = 0; i < static_cast<int>(combinations_.size()); ++i) {
    if (std::exchange(known[static_cast<std::size_t>(i)], 1)) continue;
    Cluster& cluster = clusters_.emplace_back();
    cluster.combinations.push_back(i);
    for (std::size_t next = 0; next < cluster.combinations.size(); ++next) {
      for (const Term& term : combination(cluster.combinations[next])) {
        if (root(term.equation) == 0 || std::exchange(seen[static_cast<std::size_t>(term.equation)], 1)) continue;
        cluster.equations.push_back(term.equation);
        for (const int other : users_of[static_cast<std::size_t>(term.equation)])
          if (!std::exchange(known[static_cast<std::size_t>(other)], 1)) cluster.combinations.push_back(other);
      }
    }
    std::ranges::sort(cluster.equations);
  }
}

Eigen::MatrixXd LeftOutEquations::weighed(const Cluster& cluster) const {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(cluster.equations.size()), static_cast<Eigen::Index>(cluster.combinations.size()));
  for (Eigen::Index j = 0; j < all.cols(); ++j)
    for (const Term& term : combination(cluster.combinations[static_cast<std::size_t>(j)]))
      if (root(term.equation) > 0) all(std::ranges::lower_bound(cluster.equations, term.equation) - cluster.equations.begin(), j) = weighed(term);
  return all;
}

// Solutions tell combinations of a group apart by the equations that these have had before: where some have got others, each is found alone.
bool LeftOutEquations::renew(const Pattern& pattern, std::span<const double> matrix, LinearSolver& factors) {
  bool are_others = clusters_.empty();
  if (are_others) {
    x_.resize(static_cast<std::size_t>(pattern.size()));
    sizes_.assign(x_.size(), 0.0);
    add_equations_without_weight(pattern, matrix);
    find_groups();
  }
  bool found = find(pattern, matrix, factors);
  if (!found && equations_.size() <= most_found_alone && equations_.size() * roots_.size() <= most_terms) {
    are_others = true;
    allow_all_equations();
    find_groups();
    found = find(pattern, matrix, factors);
  }
  if (found && are_others) {
    drop_small_terms();
    find_groups();
    find_clusters();
  }
  return found;
}

bool LeftOutEquations::make_smallest(const Pattern& pattern, std::span<const double> matrix, LinearSolver& factors, std::span<double> multipliers) {
  if (!renew(pattern, matrix, factors)) return false;
  for (const Cluster& cluster : clusters_) {
    Eigen::VectorXd now(static_cast<Eigen::Index>(cluster.equations.size()));
    for (Eigen::Index i = 0; i < now.size(); ++i) {
      const int k = cluster.equations[static_cast<std::size_t>(i)];
      now[i] = root(k) * multipliers[static_cast<std::size_t>(k)];
    }
    const Eigen::MatrixXd all = weighed(cluster);
    const Eigen::VectorXd idle = all.cols() == 1 ? Eigen::VectorXd(all.transpose() * now / all.squaredNorm()) : smallest_solution(all, now);
    for (Eigen::Index j = 0; j < idle.size(); ++j)
      for (const Term& term : combination(cluster.combinations[static_cast<std::size_t>(j)]))
        multipliers[static_cast<std::size_t>(term.equation)] -= idle[j] * term.factor;
  }
  return true;
}

std::vector<DependentEquations> LeftOutEquations::better() const {
  const auto outgrown = [&](const Combination& c) {
    const double most = largest_multiple * weighed(c.front());
    return std::ranges::any_of(c, [&](const Term& term) { return std::abs(weighed(term)) > most; });
  };
  if (std::ranges::none_of(combinations_, outgrown)) return {};
  std::vector<DependentEquations> parts;
  for (const Cluster& cluster : clusters_) {
    DependentEquations& part = parts.emplace_back(DependentEquations{cluster.equations, {}});
    const std::vector<int> order = pivoted_triangle(orthonormal(weighed(cluster)).transpose()).columns;
    for (std::size_t i = 0; i < cluster.combinations.size(); ++i) part.dependent.push_back(cluster.equations[static_cast<std::size_t>(order[i])]);
  }
  return parts;
}

}  // namespace dalembert
