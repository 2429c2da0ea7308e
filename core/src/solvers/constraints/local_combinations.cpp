#include "constraints/local_combinations.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "dalembert/math/decompositions.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"
#include "constraints/sparse_kernel.hpp"

namespace dalembert {

namespace {

constexpr std::size_t largest_block = 200;  // equations, which are taken as full columns
constexpr double clear_multiple = 1e4;  // of what is left of a combination that vanishes
// What is left of equations behind others, where it is so clear that combinations need not be looked at one by one.
constexpr double evident_local_rest = 1e-8, evident_pivot = 1e-2;
constexpr double evident_step = 1e-3;  // the same where nodes are eliminated one by one

using Block = Eigen::MatrixXd;

class Loops {
 public:
  explicit Loops(const ConstraintEquations& all) : all_(all), unit_(all.nodes.size(), -1), place_(all.nodes.size(), -1) {
    for (int k = 0; k < static_cast<int>(all.weights.size()); ++k) {
      if (all.weights[static_cast<std::size_t>(k)] > 0) continue;
      each(k, [&](int j, double) { unit_[static_cast<std::size_t>(j)] = k; });
    }
  }

  // False: it does not tell.
  bool find(const ConstraintBlock& block, Block& found) {
    if (!take(block)) return false;
    if (block.rows.size() > largest_block) return find_by_nodes(block, found);
    const auto inside = static_cast<Eigen::Index>(inside_), m = static_cast<Eigen::Index>(block.rows.size());
    found = Block::Zero(m, 0);
    if (active_.empty()) return true;
    const Block forces = entries(active_), units = entries(units_);
    if (!forces.allFinite() || !units.allFinite()) return false;
    Block left = forces.topRows(inside);
    Block basis = independent(units.topRows(inside));
    left -= basis * (basis.transpose() * left);
    Block combinations;
    if (!evident_combinations(left, combinations) && !weighed_combinations(left, all_.vanishing, combinations)) return false;
    const Eigen::Index count = combinations.cols();
    if (count > 0 && inside < forces.rows()) {
      // What the block hands on to the rest, by the node that it hangs on.
      basis = independent(units);
      Block handed_on = forces * combinations;
      handed_on -= basis * (basis.transpose() * handed_on);
      if (handed_on.colwise().squaredNorm().maxCoeff() >= all_.vanishing) return false;
    }
    found = Block::Zero(m, count);
    for (std::size_t i = 0; i < active_.size(); ++i) found.row(places_[i]) = combinations.row(static_cast<Eigen::Index>(i));
    return true;
  }

 private:
  // The same where most entries are zero.
  bool find_by_nodes(const ConstraintBlock& block, Block& found) {
    const std::vector<SparseEntry> all = entries_without_units();
    std::vector<SparseEntry> inside;
    std::ranges::copy_if(all, std::back_inserter(inside), [&](const SparseEntry& e) { return static_cast<std::size_t>(e.row) < inside_; });
    std::vector<int> nodes;
    for (std::size_t i = 0; i < inside_; ++i) nodes.push_back(all_.nodes[static_cast<std::size_t>(coordinates_[i])]);
    if (!std::ranges::all_of(all, [](const SparseEntry& e) { return std::isfinite(e.value); }) || !std::ranges::is_sorted(nodes)) return false;
    if (!nodes.empty() && nodes.front() < 0) return false;
    const double independent = std::max(evident_step, std::sqrt(clear_multiple * all_.vanishing));
    const auto combinations = sparse_kernel(static_cast<int>(active_.size()), nodes, inside, evident_local_rest, independent);
    if (!combinations) return false;
    Block left = Block::Zero(static_cast<Eigen::Index>(coordinates_.size()), combinations->cols());
    for (const SparseEntry& e : all) left.row(e.row) += e.value * combinations->row(e.column);
    if (left.size() > 0 && left.colwise().squaredNorm().maxCoeff() >= all_.vanishing) return false;
    found = Block::Zero(static_cast<Eigen::Index>(block.rows.size()), combinations->cols());
    for (std::size_t i = 0; i < active_.size(); ++i) found.row(places_[i]) = combinations->row(static_cast<Eigen::Index>(i));
    return true;
  }

  // As `entries`, without what conditions of unit length take up.
  std::vector<SparseEntry> entries_without_units() {
    std::vector<SparseEntry> found;
    std::vector<double> column(coordinates_.size());
    double largest = 0;
    for (std::size_t i = 0; i < active_.size(); ++i) {
      std::vector<int> touched, units;
      const double scale = 1 / std::sqrt(all_.weights[static_cast<std::size_t>(active_[i])]);
      each(active_[i], [&](int j, double x) {
        touched.push_back(place_[static_cast<std::size_t>(j)]);
        column[static_cast<std::size_t>(touched.back())] = scale * x;
        largest = std::max(largest, std::abs(scale * x));
        if (const int k = unit_[static_cast<std::size_t>(j)]; k >= 0 && std::ranges::find(units, k) == units.end()) units.push_back(k);
      });
      for (const int k : units) {
        double share = 0, size = 0;
        each(k, [&](int j, double x) {
          touched.push_back(place_[static_cast<std::size_t>(j)]);
          share += x * column[static_cast<std::size_t>(touched.back())];
          size += x * x;
        });
        each(k, [&](int j, double x) { column[static_cast<std::size_t>(place_[static_cast<std::size_t>(j)])] -= share / size * x; });
      }
      std::ranges::sort(touched);
      touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
      for (const int row : touched) found.push_back({row, static_cast<int>(i), std::exchange(column[static_cast<std::size_t>(row)], 0.0)});
    }
    for (SparseEntry& e : found) e.value /= largest > 0 ? largest : 1;
    return found;
  }

  // By elimination. False: it does not tell.
  static bool evident_combinations(const Block& left, Block& found) {
    if (left.rows() == 0) return false;
    const PivotedTriangle pivoted = pivoted_triangle(left);
    const Eigen::VectorXd pivots = pivoted.triangle.diagonal().cwiseAbs();
    const auto rank = static_cast<Eigen::Index>(std::ranges::count_if(pivots, [](double x) { return x > evident_pivot; }));
    const Eigen::Index others = left.cols() - rank;
    if (rank < pivots.size() && !(pivots.tail(pivots.size() - rank).maxCoeff() < evident_local_rest)) return false;
    Block in_order(left.cols(), others);
    in_order.topRows(rank) = -pivoted.triangle.topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solve(pivoted.triangle.topRightCorner(rank, others));
    in_order.bottomRows(others).setIdentity();
    found.resize(left.cols(), others);
    for (Eigen::Index i = 0; i < left.cols(); ++i) found.row(pivoted.columns[static_cast<std::size_t>(i)]) = in_order.row(i);
    if (others > 0) found = orthonormal(found);
    return true;
  }

  // By what is left of each combination. False: some neither vanish nor are clear.
  static bool weighed_combinations(const Block& left, double vanishing, Block& found) {
    const SymmetricEigenpairs shares = symmetric_eigenpairs(left.transpose() * left);
    if (std::ranges::any_of(shares.values, [=](double x) { return x >= vanishing && x < clear_multiple * vanishing; })) return false;
    found = shares.vectors.leftCols(std::ranges::count_if(shares.values, [=](double x) { return x < vanishing; }));
    return true;
  }

  template <class F>
  void each(int equation, F&& f) const {
    const ColumnRange column = column_range(all_.pattern, all_.first_ae + equation, static_cast<int>(all_.nodes.size()));
    for (std::size_t slot = column.begin; slot < column.middle; ++slot) {
      if (all_.values[slot] == 0) continue;
      const int j = row_in(all_.pattern, column, slot);
      f(j, all_.values[slot] * all_.scales[static_cast<std::size_t>(j)]);
    }
  }

  // Coordinates that the equations of a block act on, those of the node that it hangs on last, and the conditions of unit length among them.
  // Equations that state their multipliers by themselves have no part.
  bool take(const ConstraintBlock& block) {
    for (const int j : coordinates_) place_[static_cast<std::size_t>(j)] = -1;
    coordinates_.clear();
    active_.clear();
    places_.clear();
    units_.clear();
    for (std::size_t i = 0; i < block.rows.size(); ++i) {
      const int k = all_.rows[static_cast<std::size_t>(block.rows[i])];
      bool states_itself = false;
      const ColumnRange column = column_range(all_.pattern, all_.first_ae + k, all_.first_ae);
      for (std::size_t slot = column.middle; slot < column.end; ++slot) {
        if (all_.values[slot] == 0) continue;
        if (row_in(all_.pattern, column, slot) != all_.first_ae + k) return false;
        states_itself = true;
      }
      if (states_itself) continue;
      active_.push_back(k);
      places_.push_back(static_cast<Eigen::Index>(i));
      each(k, [&](int j, double) { coordinates_.push_back(j); });
    }
    std::ranges::sort(coordinates_);
    coordinates_.erase(std::unique(coordinates_.begin(), coordinates_.end()), coordinates_.end());
    for (const int j : coordinates_)
      if (const int k = unit_[static_cast<std::size_t>(j)]; k >= 0) units_.push_back(k);
    std::ranges::sort(units_);
    units_.erase(std::unique(units_.begin(), units_.end()), units_.end());
    if (std::ranges::any_of(units_, [&](int k) { return all_.multipliers[static_cast<std::size_t>(k)] == 0; })) return false;
    for (const int k : units_) each(k, [&](int j, double) { coordinates_.push_back(j); });
    std::ranges::sort(coordinates_);
    coordinates_.erase(std::unique(coordinates_.begin(), coordinates_.end()), coordinates_.end());
    const auto outside = std::stable_partition(coordinates_.begin(), coordinates_.end(), [&](int j) { return all_.nodes[static_cast<std::size_t>(j)] != block.hangs_on; });
    inside_ = static_cast<std::size_t>(outside - coordinates_.begin());
    for (std::size_t i = 0; i < coordinates_.size(); ++i) place_[static_cast<std::size_t>(coordinates_[i])] = static_cast<int>(i);
    return true;
  }

  // In sqrt(D), such that the largest entry of a column is one: what vanishes does so in any metric.
  Block entries(const std::vector<int>& equations) const {
    Block all = Block::Zero(static_cast<Eigen::Index>(coordinates_.size()), static_cast<Eigen::Index>(equations.size()));
    for (std::size_t i = 0; i < equations.size(); ++i) {
      const double weight = all_.weights[static_cast<std::size_t>(equations[i])], scale = weight > 0 ? 1 / std::sqrt(weight) : 1;
      each(equations[i], [&](int j, double entry) { all(place_[static_cast<std::size_t>(j)], static_cast<Eigen::Index>(i)) = scale * entry; });
    }
    const double largest = all.size() > 0 ? all.cwiseAbs().maxCoeff() : 0;
    return largest > 0 ? Block(all / largest) : all;
  }

  // Conditions of unit length have coordinates of their own.
  static Block independent(Block columns) {
    for (Eigen::Index i = 0; i < columns.cols(); ++i)
      if (const double size = columns.col(i).norm(); size > 0) columns.col(i) /= size;
    return columns;
  }

  const ConstraintEquations& all_;
  std::vector<int> unit_, place_;  // by coordinate: an equation of its node; where it is in the block
  std::vector<int> coordinates_, active_, units_;
  std::vector<Eigen::Index> places_;  // of active equations in the block
  std::size_t inside_ = 0;
};

}  // namespace

std::vector<Eigen::MatrixXd> local_combinations(const ConstraintEquations& all, const std::vector<ConstraintBlock>& blocks) {
  Loops loops(all);
  std::vector<Eigen::MatrixXd> found(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i)
    if (!loops.find(blocks[i], found[i])) return {};
  return found;
}

}  // namespace dalembert
