// Combinations of constraint equations that vanish, by block inverse iteration: P has the eigenvalue one for them, and eps/(eps + s)
// for all others.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "dalembert/math/decompositions.hpp"
#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"
#include "dalembert/solvers/redundant_constraints.hpp"
#include "constraints/constraint_blocks.hpp"
#include "constraints/local_combinations.hpp"
#include "steppers/number_sequence.hpp"

namespace dalembert {

namespace {

constexpr int block_size = 8;
constexpr int iterations = 2;
constexpr int most_refinements = 5;         // of solutions
constexpr double accurate = 1e-5;           // corrections of multipliers that change nothing of what is found
constexpr double evidently_regular = 1e-3;  // eigenvalues of combinations that do not vanish
// At once: what is left of vectors at random by those that vanish and by all others, and how far P may be from one for the first.
constexpr double evident = 1e-3, evident_rest = 1e-6, evident_loss = 1e-4;
constexpr int most_projections = 5;
constexpr double unknown = 1e-10;           // the share of what is known in a column
constexpr double separate = 0.25;           // what others add to a combination that vanishes by itself
constexpr double same_factor = 1e-13;       // changes of a metric that turn nothing
constexpr double removable_share = 1e-10;   // squared: of the equations of an item in combinations that vanish

using Block = Eigen::MatrixXd;
using GivenBlock = Eigen::Map<const Block>;

std::span<const double> numbers_of(const Block& block) { return {block.data(), static_cast<std::size_t>(block.size())}; }

// Columns that are nothing but round-off beside others may become anything, also what is known.
Block beside(const Block& known, const Block& block) {
  Block columns = orthonormal(block);
  for (int time = 0; time < most_projections && known.cols() > 0 && columns.cols() > 0; ++time) {
    const Block share = known.transpose() * columns;
    if (time > 0 && share.cwiseAbs().maxCoeff() < unknown) break;
    columns = orthonormal(columns - known * share);
  }
  return columns;
}

}  // namespace

// P with this eps, for columns in sqrt(D) lambda, with these weights for D.
class RedundantConstraints::Search {
 public:
  Search(RedundantConstraints& all, const Pattern& pattern, std::span<const double> values, double eps, std::span<const double> weights,
         LinearSolver& factors)
      : all_(all), pattern_(pattern), matrix_(values.begin(), values.end()), factors_(factors), eps_(eps), x_(all.x_.size()) {
    const std::span<const int> slots = all.slots(pattern);
    for (std::size_t i = 0; i < slots.size(); ++i) {
      const int k = all.rows_[i];
      double& entry = matrix_[static_cast<std::size_t>(slots[i])];
      if (entry == 0) entry = -eps * all.row_factor(k) * weights[static_cast<std::size_t>(k)];
      root_.push_back(std::sqrt(weights[static_cast<std::size_t>(k)]));
    }
  }
  bool factorize() { return factors_.factorize(matrix_) == LinearSolver::success; }
  // The same in units in which coordinates have an inertia of one, and equations a weight of one: in others, eps of the smallest weights is
  // round-off beside the largest. Nobody else can use these factors.
  bool factorize_in_own_units() {
    find_own_units();
    for_each_entry(pattern_, [&](int row, int column, std::size_t slot) { matrix_[slot] *= own_unit_[row] * own_unit_[column]; });
    return factorize();
  }
  // Fills the parts; what they have is only looked at again. False, with `is_finite`: they are not independent of each other.
  bool find_in(std::vector<Part>& parts, bool are_independent) {
    compares = parts.size() > 1 && !are_independent;
    bool looks_again = std::ranges::any_of(parts, [](const Part& part) { return part.count > 0; });
    is_finite = true;
    std::vector<PartAtWork> work;
    for (Part& part : parts) work.emplace_back(part);
    while (std::ranges::any_of(work, [](const PartAtWork& w) { return !w.done; }))
      if (!one_round(work, std::exchange(looks_again, false))) return false;
    return true;
  }
  // One application of P to a few vectors shows all that vanish if the others are far from it; a second one, to what has been found, whether
  // it does, and whether parts are independent. False: a closer look is needed, and parts are as before.
  bool find_at_once(std::vector<Part>& parts) {
    const bool guesses = std::ranges::any_of(parts, [](const Part& part) { return part.count > 0; });
    std::vector<PartAtWork> work;
    for (Part& part : parts) work.emplace_back(part);
    begin_round(work, guesses);
    image(work);
    if (refinements_ > 0 || !std::ranges::all_of(work, [&](PartAtWork& w) { return take_what_is_left(w); })) return false;
    std::vector<Block> found(work.size());
    for (std::size_t i = 0; i < work.size(); ++i) {
      found[i] = work[i].block;
      work[i].block *= mixture(found[i].cols());
      work[i].known = work[i].block;
    }
    image(work);
    for (const PartAtWork& w : work)
      if (w.block.cols() > 0 && !((w.block - w.known).colwise().norm().maxCoeff() < evident_loss)) return false;
    for (std::size_t i = 0; i < work.size(); ++i) work[i].part.take(numbers_of(found[i]));
    return true;
  }
  // How far the others are from vanishing where all that vanish are known. False: the matrix is singular for other reasons as well.
  bool look_at_the_rest(std::vector<Part>& parts) {
    std::vector<PartAtWork> work;
    for (Part& part : parts) {
      PartAtWork& w = work.emplace_back(part);
      w.known = std::move(w.guess);
      w.guess.resize(w.known.rows(), 0);
    }
    for (PartAtWork& w : work) {
      w.block.resize(w.known.rows(), w.known.cols() < w.known.rows() ? 1 : 0);
      for (double& x : w.block.reshaped()) x = number_at_random();
      w.block = beside(w.known, w.block);
    }
    double before = 0;
    for (int i = 0; i < iterations; ++i) {
      image(work);
      before = i + 1 < iterations ? size_of(work) : before;
    }
    const double after = size_of(work);
    largest_rest = before > 0 ? std::min(1.0, after / before) : 0;
    weakest_vector_.assign(root_.size(), 0.0);
    for (const PartAtWork& w : work)
      if (after > 0 && w.block.cols() > 0) add_to_weakest(w.part, w.block.col(0) / after);
    return std::isfinite(largest_rest);
  }
  bool is_finite = true;
  bool compares = false;    // whether parts turn out to be independent of each other
  double largest_rest = 0;  // the largest eigenvalue of P that is not one
  // The smallest eigenvalue that is not zero, as far as it is known, in the metric of these weights.
  double weakest(std::span<const double> weights) const {
    if (!(largest_rest > 0)) return 1;
    double size = 0;
    for (std::size_t i = 0; i < weakest_vector_.size(); ++i)
      size += weakest_vector_[i] * weakest_vector_[i] * weights[static_cast<std::size_t>(all_.rows_[i])] / (root_[i] * root_[i]);
    return eps_ * (1 / largest_rest - 1) / (size > 0 ? size : 1);
  }

 private:
  struct PartAtWork {
    Part& part;
    Block guess, known, block;
    bool done = false;
    double rest = 0;
    Eigen::VectorXd weakest;
    explicit PartAtWork(Part& p) : part(p) {
      const auto m = static_cast<Eigen::Index>(p.rows.size());
      guess = GivenBlock(p.combinations().data(), m, p.count);
      known.resize(m, 0);
    }
  };

  // Powers of two, which round nothing. Equations without a weight, such as conditions of unit length, have that of their entries.
  void find_own_units() {
    const auto unit_of = [](double size) { return size > 0 && std::isfinite(size) ? std::exp2(-std::round(0.5 * std::log2(size))) : 1; };
    own_unit_.assign(x_.size(), 1);
    const int first_ae = all_.first_ae_, end_of_ode2 = static_cast<int>(all_.nodes_.size());
    for (int j = 0; j < end_of_ode2; ++j) own_unit_[static_cast<std::size_t>(j)] = unit_of(std::abs(matrix_[static_cast<std::size_t>(pattern_.slot(j, j))]));
    for (int k = first_ae; k < static_cast<int>(x_.size()); ++k) {
      double sum = 0;
      const ColumnRange column = column_range(pattern_, k, end_of_ode2);
      for (std::size_t slot = column.begin; slot < column.middle; ++slot) {
        const double entry = matrix_[slot] * own_unit_[static_cast<std::size_t>(row_in(pattern_, column, slot))];
        sum += entry * entry;
      }
      own_unit_[static_cast<std::size_t>(k)] = unit_of(sum);
    }
    for (std::size_t i = 0; i < root_.size(); ++i) own_unit_[unknown(i)] = unit_of(root_[i] * root_[i]);
  }

  void add_to_weakest(const Part& part, const Eigen::VectorXd& share) {
    for (std::size_t i = 0; i < part.rows.size(); ++i) weakest_vector_[static_cast<std::size_t>(part.rows[i])] = share[static_cast<Eigen::Index>(i)];
  }

  // Of all blocks together, without what is known.
  static double size_of(std::vector<PartAtWork>& work) {
    double sum = 0;
    for (PartAtWork& w : work) {
      if (w.block.cols() == 0) continue;
      if (w.known.cols() > 0) w.block -= w.known * (w.known.transpose() * w.block);
      sum += w.block.squaredNorm();
    }
    return std::sqrt(sum);
  }

  Block mixture(Eigen::Index columns) {
    Block mixed(columns, columns);
    for (double& x : mixed.reshaped()) x = number_at_random();
    return orthonormal(mixed);
  }

  void begin_round(std::vector<PartAtWork>& work, bool looks_again) {
    for (PartAtWork& w : work) {
      if (w.done) continue;
      const Eigen::Index m = w.known.rows(), guessed = w.guess.cols();
      const Eigen::Index others = std::min<Eigen::Index>(looks_again ? 1 : block_size, m - w.known.cols() - guessed);
      w.block.resize(m, guessed + others);
      w.block.leftCols(guessed) = w.guess;
      for (double& x : w.block.rightCols(others).reshaped()) x = number_at_random();
      w.guess.resize(m, 0);
      w.block = beside(w.known, w.block);
    }
  }

  // Images of vectors at random, and of a guess.
  bool take_what_is_left(PartAtWork& w) {
    const Eigen::Index columns = w.block.cols(), others = columns - w.part.count;
    if (!w.block.allFinite()) return false;
    w.block *= symmetric_eigenpairs(w.block.transpose() * w.block).vectors;
    const Eigen::VectorXd sizes = w.block.colwise().norm();
    const auto vanishing = static_cast<Eigen::Index>(std::ranges::count_if(sizes, [](double x) { return x > evident; }));
    if (vanishing == columns && columns < w.block.rows()) return false;  // there may be more
    if (vanishing < columns && others > 0) {
      const double share = std::sqrt(static_cast<double>(others) / static_cast<double>(w.block.rows()));
      const double rest = sizes[columns - vanishing - 1] / share;
      if (!(rest < evident_rest)) return false;
      largest_rest = std::max(largest_rest, rest);
    }
    w.block = vanishing > 0 ? orthonormal(w.block.rightCols(vanishing)) : Block(w.block.rows(), 0);
    return true;
  }

  // All parts at once: their columns are side by side in the same vectors.
  bool one_round(std::vector<PartAtWork>& work, bool looks_again) {
    begin_round(work, looks_again);
    for (int i = 0; i < (looks_again ? 1 : iterations); ++i) {
      image(work);
      for (PartAtWork& w : work)
        if (!w.done) w.block = beside(w.known, w.block);
    }
    return judge(work);
  }

  // Mixed in another way in each part, they show where parts are not independent of each other.
  bool judge(std::vector<PartAtWork>& work) {
    std::vector<Block> before(work.size()), mixed(work.size());
    for (std::size_t i = 0; i < work.size(); ++i) {
      PartAtWork& w = work[i];
      if (w.done) continue;
      before[i] = w.block;
      if (!compares) continue;
      mixed[i] = mixture(w.block.cols());
      w.block *= mixed[i];
    }
    image(work);
    largest_rest = 0;
    for (std::size_t i = 0; i < work.size(); ++i) {
      PartAtWork& w = work[i];
      if (!w.done) {
        if (compares) w.block *= mixed[i].transpose();
        if (!take_vanishing(before[i], w)) return false;
      }
      if (w.rest > largest_rest) {
        largest_rest = w.rest;
        weakest_vector_.assign(root_.size(), 0.0);
        add_to_weakest(w.part, w.weakest);
      }
    }
    return true;
  }

  // Rayleigh-Ritz, of vectors and their images.
  bool take_vanishing(const Block& vectors, PartAtWork& w) {
    const Block small = vectors.transpose() * w.block;
    is_finite = is_finite && small.allFinite();
    if (!is_finite) return false;
    const SymmetricEigenpairs shares = symmetric_eigenpairs((small + small.transpose()) / 2);
    const Eigen::Index columns = vectors.cols();
    const auto vanishing = static_cast<Eigen::Index>(std::ranges::count_if(shares.values, [](double x) { return x > 0.5; }));
    w.rest = vanishing < columns ? std::max(0.0, shares.values[columns - vanishing - 1]) : 0;
    if (vanishing < columns) w.weakest = vectors * shares.vectors.col(columns - vanishing - 1);
    Block more(w.known.rows(), w.known.cols() + vanishing);
    more << w.known, vectors * shares.vectors.rightCols(vanishing);
    if (compares && vanishing > 0 &&
        (w.block * shares.vectors.rightCols(vanishing) - more.rightCols(vanishing)).colwise().norm().maxCoeff() > separate)
      return false;
    w.known = std::move(more);
    // Round-off may have spoilt some of those before, but not where factors do by themselves.
    w.done = vanishing == 0 || w.known.cols() == w.known.rows() || (vanishing < columns && w.rest < evidently_regular && refinements_ == 0);
    if (!w.done) return true;
    w.part.take(numbers_of(w.known));
    return true;
  }

  // Blocks become their images.
  void image(std::vector<PartAtWork>& work) {
    Eigen::Index columns = 0;
    for (const PartAtWork& w : work) columns = std::max(columns, w.done ? 0 : w.block.cols());
    column_.resize(root_.size());
    for (Eigen::Index j = 0; j < columns; ++j) {
      std::ranges::fill(column_, 0.0);
      const auto each = [&](auto&& f) {
        for (PartAtWork& w : work)
          for (std::size_t i = 0; !w.done && j < w.block.cols() && i < w.part.rows.size(); ++i)
            f(static_cast<std::size_t>(w.part.rows[i]), w.block(static_cast<Eigen::Index>(i), j));
      };
      each([&](std::size_t row, double& x) { column_[row] = x * root_[row]; });
      apply(column_.data());
      each([&](std::size_t row, double& x) { x = column_[row] * root_[row]; });
    }
  }

  // From sqrt(D) times columns to multipliers. In large systems, factors alone leave too much of the small numbers that count here, as
  // the first solution shows.
  void apply(double* column) {
    wanted_.assign(x_.size(), 0.0);
    for (std::size_t i = 0; i < root_.size(); ++i) wanted_[unknown(i)] = -eps_ * all_.row_factor(all_.rows_[i]) * column[i] * own_unit(i);
    std::ranges::fill(x_, 0.0);
    for (int time = 0; time <= refinements_; ++time) {
      rest_ = wanted_;
      if (time > 0) for_each_entry(pattern_, [&](int row, int column, std::size_t slot) { rest_[row] -= matrix_[slot] * x_[column]; });
      factors_.solve(rest_);
      for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += rest_[i];
      if (time > 0 && largest_multiplier(rest_) < accurate * largest_multiplier(x_)) refinements_ = time - 1;
    }
    for (std::size_t i = 0; i < root_.size(); ++i) column[i] = x_[unknown(i)] * own_unit(i);
  }
  double own_unit(std::size_t i) const { return own_unit_.empty() ? 1 : own_unit_[unknown(i)]; }
  std::size_t unknown(std::size_t i) const { return static_cast<std::size_t>(all_.first_ae_ + all_.rows_[i]); }
  double largest_multiplier(const std::vector<double>& x) const {
    double size = 0;
    for (std::size_t i = 0; i < root_.size(); ++i) size = std::max(size, std::abs(x[unknown(i)]) * own_unit(i));
    return size;
  }

  const RedundantConstraints& all_;
  const Pattern& pattern_;
  std::vector<double> matrix_;
  LinearSolver& factors_;
  double eps_;
  int refinements_ = most_refinements;
  std::vector<double> root_, wanted_, rest_, x_, column_, own_unit_;
  std::vector<double> weakest_vector_;  // of the length one
  NumberSequence number_at_random;
};

std::vector<RedundantConstraints::Part> RedundantConstraints::all_in_one() const {
  std::vector<int> all(rows_.size());
  std::iota(all.begin(), all.end(), 0);
  return {Part(std::move(all))};
}

std::vector<RedundantConstraints::Part> RedundantConstraints::apart(bool by_loops, const Pattern& pattern, std::span<const double> values,
                                                                    bool& is_local) const {
  std::vector<Part> parts;
  for (ConstraintBlock& block : constraint_blocks(by_loops ? BlocksOf::loops : BlocksOf::coordinates, pattern, values, first_ae_, nodes_, rows_))
    parts.emplace_back(std::move(block.rows), block.hangs_on);
  is_local = by_loops && take_local_combinations(parts, pattern, values);
  return is_local || rows_.size() > few_rows ? parts : all_in_one();
}

bool RedundantConstraints::take_local_combinations(std::vector<Part>& parts, const Pattern& pattern, std::span<const double> values) const {
  std::vector<ConstraintBlock> blocks;
  for (const Part& part : parts) blocks.push_back({part.rows, part.hangs_on});
  const std::vector<Block> found = local_combinations({pattern, values, scales_, first_ae_, nodes_, rows_, weight_, multiplier_, counting_}, blocks);
  for (std::size_t i = 0; i < found.size(); ++i) parts[i].take(numbers_of(found[i]));
  return !found.empty() || parts.empty();
}

bool RedundantConstraints::find_locally(const Pattern& pattern, std::span<const double> values) {
  parts_ = apart(true, pattern, values, local_);
  count_parts();
  return local_;
}

void RedundantConstraints::count_parts() {
  count_ = 0;
  for (const Part& part : parts_) count_ += part.count;
}

void RedundantConstraints::Part::take(std::span<const double> found) {
  count = static_cast<int>(found.size() / rows.size());
  combinations_.assign(found.begin(), found.end());
  factors_.clear();
  leading_.clear();
}

// In any metric.
bool RedundantConstraints::Part::has(std::size_t i) const {
  constexpr double noticeable = 1e-6;
  double sum = 0;
  for (std::size_t at = i; at < combinations_.size(); at += rows.size()) sum += combinations_[at] * combinations_[at];
  return sum > noticeable * noticeable;
}

std::span<const int> RedundantConstraints::Part::leading() const {
  if (leading_.empty() && count > 0) {
    const GivenBlock all(combinations_.data(), static_cast<Eigen::Index>(rows.size()), count);
    leading_ = pivoted_triangle(all.transpose()).columns;
    leading_.resize(static_cast<std::size_t>(count));
  }
  return leading_;
}

void RedundantConstraints::Part::rescale(std::span<const int> equations, std::span<const double> from, std::span<const double> to) {
  const auto factor = [&](std::size_t i) {
    const auto k = static_cast<std::size_t>(equations[static_cast<std::size_t>(rows[i])]);
    return std::sqrt(to[k] / from[k]);
  };
  bool is_same = true;  // but for a factor in common: steps of other sizes
  for (std::size_t i = 1; i < rows.size() && is_same; ++i) is_same = std::abs(factor(i) - factor(0)) <= same_factor * factor(0);
  if (count == 0 || is_same) return;
  factors_.resize(rows.size(), 1.0);
  for (std::size_t i = 0; i < rows.size(); ++i) factors_[i] *= factor(i);
}

std::span<const double> RedundantConstraints::Part::combinations() const {
  if (!factors_.empty()) {
    Block all = GivenBlock(combinations_.data(), static_cast<Eigen::Index>(rows.size()), count);
    for (std::size_t i = 0; i < rows.size(); ++i) all.row(static_cast<Eigen::Index>(i)) *= factors_[i];
    all = orthonormal(all);
    combinations_.assign(all.data(), all.data() + all.size());
    factors_.clear();
  }
  return combinations_;
}

bool RedundantConstraints::as_many(const std::vector<Part>& some, const std::vector<Part>& others) {
  return std::ranges::equal(some, others, [](const Part& one, const Part& other) { return one.count == other.count; });
}

// Combinations that are known from a state close by become those of this one by one application of P. A vector at random beside them tells
// whether there are more. Large systems are taken apart, such that few vectors are enough for many combinations.
bool RedundantConstraints::find(const Pattern& pattern, std::span<const double> values, double eps, LinearSolver& factors) {
  const bool counts = eps == counting_;
  const std::span<const double> weights = counts ? own_weight_ : weight_;
  Search search(*this, pattern, values, eps, weights, factors);
  if (!search.factorize_in_own_units()) return false;
  bool is_local = false;
  std::vector<Part> parts = apart(true, pattern, values, is_local);
  if (is_local && as_many(parts, parts_))
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i].lead_as(parts_[i]);
  if (parts_.empty() || is_local) parts_ = std::move(parts);
  local_ = is_local;
  const auto into = [&](std::span<const double> from, std::span<const double> to) {
    for (Part& part : parts_)
      if (counts) part.rescale(rows_, from, to);
  };
  into(weight_, weights);
  bool found = is_local ? search.look_at_the_rest(parts_) : search.find_in(parts_, false);
  if (!found && !is_local && search.is_finite && rows_.size() > few_rows) {
    parts_ = apart(false, pattern, values, is_local);
    found = search.find_in(parts_, true);
  }
  into(weights, weight_);
  if (!found) return false;
  if (counts) certain_ = is_local || search.largest_rest < evidently_regular;
  count_parts();
  weakest_ = search.weakest(weight_);
  return true;
}

// Where stiffness resists some motions alone, what is left of all others is much more than D, which joints that are apart would outweigh.
bool RedundantConstraints::find_rest(const Pattern& pattern, std::span<const double> values, LinearSolver& factors) {
  Search search(*this, pattern, values, counting_, own_weight_, factors);
  if (!search.factorize_in_own_units()) return false;
  for (Part& part : parts_) part.rescale(rows_, weight_, own_weight_);
  const bool found = search.look_at_the_rest(parts_);
  for (Part& part : parts_) part.rescale(rows_, own_weight_, weight_);
  weakest_by_masses_ = std::exchange(weakest_, search.weakest(weight_));
  if (found && weakest_ > 1) scale_weights(std::exchange(weakest_, 1.0));
  return found;
}

bool RedundantConstraints::find_at_once(const Pattern& pattern, std::span<const double> values, double eps, LinearSolver& factors) {
  Search search(*this, pattern, values, eps, weight_, factors);
  if (!search.factorize()) return false;
  if (local_ ? !search.look_at_the_rest(parts_) || search.largest_rest > evident_rest : !search.find_at_once(parts_)) return false;
  count_parts();
  weakest_ = search.weakest(weight_);
  return true;
}

bool RedundantConstraints::confirm(const Pattern& pattern, std::span<const double> values, LinearSolver& factors) {
  std::vector<Part> parts = parts_;
  if (!local_ || !take_local_combinations(parts, pattern, without_eps(values))) {
    parts = parts_;
    if (Search search(*this, pattern, values, eps_, weight_, factors); !search.find_at_once(parts)) return false;
  }
  return take_if_as_many(std::move(parts));
}

bool RedundantConstraints::confirm_locally(const Pattern& pattern, std::span<const double> values) {
  std::vector<Part> parts = parts_;
  return local_ && take_local_combinations(parts, pattern, values) && take_if_as_many(std::move(parts));
}

bool RedundantConstraints::take_if_as_many(std::vector<Part> parts) {
  if (!as_many(parts, parts_)) return false;
  parts_ = std::move(parts);
  return true;
}

bool RedundantConstraints::take_over(const RedundantConstraints& found) {
  if (found.rows_ != rows_) return false;
  if (found.weight_scale_ != weight_scale_) scale_weights(found.weight_scale_ / weight_scale_);
  parts_ = found.parts_;
  local_ = found.local_;
  counting_ = found.counting_;
  for (Part& part : parts_) part.rescale(rows_, found.weight_, weight_);
  count_ = found.count_;
  certain_ = found.certain_;
  weakest_ = found.weakest_;
  weakest_by_masses_ = found.weakest_by_masses_;
  consistent_ = found.consistent_;
  return true;
}

bool RedundantConstraints::serve_as(const RedundantConstraints& found) {
  if (!found.in_use() || found.rows_ != rows_) return false;
  const bool by_masses = found.weakest_by_masses_ > 0;
  weakest_ = by_masses ? found.weakest_by_masses_ : found.weakest_;
  use(by_masses ? eps_for(0, false) : found.eps_);
  return true;
}

// f(part, owner, rows, first) for the rows of each owner in the combinations of each part, of which the first is rows[first] there.
template <class F>
void RedundantConstraints::each_owner(F&& f, const System& system) const {
  if (count_ == 0) return;  // solvers that have not begun have no system either
  const auto owners = system.equation_owners();
  for (const Part& part : parts_) {
    if (part.count == 0) continue;
    const GivenBlock all(part.combinations().data(), static_cast<Eigen::Index>(part.rows.size()), part.count);
    auto owner = owners.begin();
    for (std::size_t i = 0; i < part.rows.size();) {
      while (rows_[part.rows[i]] >= owner->first + owner->count) ++owner;
      std::size_t end = i;
      while (end < part.rows.size() && rows_[part.rows[end]] < owner->first + owner->count) ++end;
      f(part, *owner, all.middleRows(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(end - i)), static_cast<int>(i));
      i = end;
    }
  }
}

// Equations of one item can be left out as long as the rest of the combinations stays independent of them: as many as the rank of
// their part of the combinations.
std::vector<RedundantConstraints::Item> RedundantConstraints::items(const System& system) const {
  std::map<int, Item> found;  // by equation
  each_owner([&](const Part&, const System::EquationOwner& owner, const Block& rows, int) {
    if (!(rows.squaredNorm() > removable_share)) return;
    const auto rank = static_cast<int>(std::ranges::count_if(symmetric_eigenvalues(rows * rows.transpose()), [](double x) { return x > removable_share; }));
    const auto acting = std::count(acting_.begin() + owner.first, acting_.begin() + owner.first + owner.count, 1);
    const auto known = found.try_emplace(owner.first, Item{owner.number, system.describe(owner), owner.first, owner.count, static_cast<int>(acting), 0}).first;
    known->second.removable += rank;
  }, system);
  std::vector<Item> items;
  for (auto& [equation, item] : found) items.push_back(std::move(item));
  return items;
}

// What vanishes of a gap is the same wherever it is: the smallest gap of the item alone that has as much of it.
std::vector<std::string> RedundantConstraints::contradictions(std::span<const double> misfit, const System& system) const {
  constexpr double not_all = 1e-2;
  std::vector<std::string> lines;
  const auto whole_of = [&](const Part& part) -> Eigen::VectorXd {
    Eigen::VectorXd scaled(static_cast<Eigen::Index>(part.rows.size()));
    for (std::size_t i = 0; i < part.rows.size(); ++i) scaled[static_cast<Eigen::Index>(i)] = misfit[rows_[part.rows[i]]] / std::sqrt(weight_[rows_[part.rows[i]]]);
    return GivenBlock(part.combinations().data(), scaled.size(), part.count).transpose() * scaled;
  };
  double largest = 0;
  for (const Part& part : parts_) largest = std::max(largest, part.count > 0 ? whole_of(part).norm() : 0.0);
  each_owner([&](const Part& part, const System::EquationOwner& owner, const Block& rows, int first) {
    const Eigen::VectorXd whole = whole_of(part);
    if (!(whole.norm() > not_all * largest)) return;
    Eigen::VectorXd gap = smallest_solution(rows.transpose(), whole);
    if ((rows.transpose() * gap - whole).norm() > not_all * whole.norm()) return;
    const auto equation_at = [&](Eigen::Index i) { return rows_[part.rows[static_cast<std::size_t>(first + i)]]; };
    for (Eigen::Index i = 0; i < gap.size(); ++i) gap[i] *= std::sqrt(weight_[equation_at(i)]);
    Eigen::Index worst = 0;
    gap.cwiseAbs().maxCoeff(&worst);
    const int equation = equation_at(worst);
    const char* unit = units_[equation] == CoordinateUnit::meter ? " m" : units_[equation] == CoordinateUnit::radian ? " rad" : "";
    lines.push_back(system.describe(owner) + ", equation " + std::to_string(equation - owner.first) + ": " + format_number(gap[worst]) + unit);
  }, system);
  return lines;
}

}  // namespace dalembert
