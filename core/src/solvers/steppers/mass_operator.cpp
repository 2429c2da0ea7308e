#include "dalembert/solvers/mass_operator.hpp"

#include <algorithm>
#include <cmath>

#include "dalembert/solvers/numerical_tangent.hpp"

namespace dalembert {

// Blocks up to this size are dense.
constexpr int dense_limit = 40;

void MassOperator::prepare(System& system, LinearSolverType type, const LinearSolverOptions& options) {
  *this = MassOperator();
  type_ = type;
  options_ = options;
  size_ = system.sizes().ode2;
}

void MassOperator::prepare_matrix(System& system) {
  pattern_ = &system.mass_pattern();
  values_.resize(static_cast<std::size_t>(pattern_->values()));
  inverse_.assign(static_cast<std::size_t>(size_), 0.0);
  diagonal_.resize(static_cast<std::size_t>(size_));
  alone_.assign(static_cast<std::size_t>(size_), 1);
  coupled_ = DisjointSets(size_);
  without_matrix_ = static_cast<int>(system.coordinates_without_matrix().size());
  for (const int i : system.coordinates_without_matrix()) {
    alone_[i] = 0;
    inverse_[i] = 1;
  }
  for_each_entry(*pattern_, [&](int row, int column, std::size_t slot) {
    if (row == column && row < size_) diagonal_[row] = slot;
  });
}

// Calls f(entry) for all off-diagonal entries.
template <class F>
void MassOperator::each_coupling(F&& f) const {
  for_each_entry(*pattern_, [&](int row, int column, std::size_t slot) {
    if (row != column && row < size_ && column < size_) f(Entry{row, column, slot});
  });
}

// Blocks only grow, because an entry that is zero now may return.
bool MassOperator::join_blocks() {
  bool joined = false;
  each_coupling([&](const Entry& e) {
    if (values_[e.slot] != 0 && coupled_.join(e.row, e.column)) joined = true;
  });
  return joined;
}

void MassOperator::build_blocks() {
  blocks_.clear();
  std::vector<int> members(size_, 0), block_of(size_, -1), place(size_, 0);
  for (int i = 0; i < size_; ++i) ++members[coupled_.of(i)];
  for (int i = 0; i < size_; ++i) {
    const int r = coupled_.of(i);
    if (members[r] == 1) continue;
    alone_[i] = 0;
    if (r == i) {
      block_of[r] = static_cast<int>(blocks_.size());
      blocks_.emplace_back();
    }
    Block& block = blocks_[block_of[r]];
    block_of[i] = block_of[r];
    place[i] = static_cast<int>(block.coordinates.size());
    block.coordinates.push_back(i);
  }
  std::vector<std::vector<Entry>> entries(blocks_.size());
  each_coupling([&](const Entry& e) {
    if (block_of[e.row] >= 0 && block_of[e.row] == block_of[e.column]) entries[block_of[e.row]].push_back(e);
  });
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    Block& block = blocks_[k];
    const int n = static_cast<int>(block.coordinates.size());
    for (const int i : block.coordinates) entries[k].push_back({i, i, diagonal_[i]});
    const bool dense = is_dense(type_) || n <= dense_limit;
    Couplings couplings;
    for (const Entry& e : entries[k]) couplings.add(place[e.row], place[e.column]);
    block.pattern = std::make_unique<Pattern>(dense ? Pattern::dense(n) : Pattern::sparse(n, couplings));
    block.values.assign(static_cast<std::size_t>(block.pattern->values()), 0.0);
    block.x.resize(static_cast<std::size_t>(n));
    for (const Entry& e : entries[k]) {
      block.from.push_back(e.slot);
      block.to.push_back(static_cast<std::size_t>(block.pattern->slot(place[e.row], place[e.column])));
    }
    block.solver = make_linear_solver(*block.pattern, dense ? LinearSolverType::EXUdense : type_, options_);
  }
}

// Returns success, or the coordinate if it has no mass.
int MassOperator::invert(int coordinate, double mass) {
  const bool has_mass = std::abs(mass) > options_.pivot_threshold;
  inverse_[coordinate] = has_mass ? 1 / mass : 0;
  return has_mass || options_.ignore_singular ? LinearSolver::success : coordinate;
}

int MassOperator::update(System& system, const State& state) {
  if (pattern_ == nullptr) {
    inverse_.assign(static_cast<std::size_t>(size_), 0.0);
    if (system.add_diagonal_masses(state, inverse_)) {
      for (int i = 0; i < size_; ++i)
        if (const int failed = invert(i, inverse_[i]); failed != LinearSolver::success) return failed;
      return LinearSolver::success;
    }
    prepare_matrix(system);
  }
  if (without_matrix_ == size_) return LinearSolver::success;
  system.mass_matrix(state, *pattern_, values_);
  if (join_blocks()) build_blocks();
  for (int i = 0; i < size_; ++i)
    if (alone_[i])
      if (const int failed = invert(i, values_[diagonal_[i]]); failed != LinearSolver::success) return failed;
  for (Block& block : blocks_) {
    for (std::size_t i = 0; i < block.from.size(); ++i) block.values[block.to[i]] = values_[block.from[i]];
    const int failed = block.solver->factorize(block.values);
    if (failed != LinearSolver::success) return block.coordinates[static_cast<std::size_t>(failed)];
  }
  return LinearSolver::success;
}

void MassOperator::solve_blocks(std::span<double> x) {
  for (Block& block : blocks_) {
    for (std::size_t i = 0; i < block.x.size(); ++i) block.x[i] = x[block.coordinates[i]];
    block.solver->solve(block.x);
  }
  for (int i = 0; i < size_; ++i) x[i] *= inverse_[i];
  for (const Block& block : blocks_) {
    for (std::size_t i = 0; i < block.x.size(); ++i) x[block.coordinates[i]] = block.x[i];
  }
}

}  // namespace dalembert
