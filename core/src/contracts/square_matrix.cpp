#include "dalembert/contracts/square_matrix.hpp"

#include <algorithm>
#include <tuple>

namespace dalembert {

SquareMatrix::SquareMatrix(const MatrixContainer& from) {
  if (from.empty()) return;
  rows_ = from.rows;
  if (from.dense) {
    dense_ = from.values;
    return;
  }
  std::vector<MatrixContainer::Triplet> sorted = from.triplets;
  std::ranges::stable_sort(sorted, {}, [](const auto& t) { return std::tuple(t.row, t.column); });
  std::vector<MatrixContainer::Triplet> entries;
  for (const auto& t : sorted) {
    if (!entries.empty() && entries.back().row == t.row && entries.back().column == t.column) {
      entries.back().value += t.value;
    } else {
      entries.push_back(t);
    }
  }
  given_ = from.triplets;
  entries_ = std::move(entries);
}

bool SquareMatrix::same_places(const SquareMatrix& other) const {
  if (rows_ != other.rows_ || sparse() != other.sparse()) return false;
  return entries_.shares_with(other.entries_) ||
         std::ranges::equal(entries_, other.entries_,
                            [](const auto& a, const auto& b) { return a.row == b.row && a.column == b.column; });
}

void SquareMatrix::add_product(const double* x, std::span<const int> from, double* y, std::span<const int> to) const {
  for (const auto& t : entries_) y[to[t.row]] += t.value * x[from[t.column]];
  if (dense_.empty()) return;
  const double* entry = dense_.data();
  for (int i = 0; i < rows_; ++i) {
    double sum = 0;
    for (int j = 0; j < rows_; ++j) sum += *entry++ * x[from[j]];
    y[to[i]] += sum;
  }
}

void SquareMatrix::visit(BlockVisitor& visitor, std::span<const int> dofs) const {
  for (const auto& t : entries_) visitor.entry(dofs[t.row], dofs[t.column]);
}

void SquareMatrix::add(double factor, SlotCursor& slot) const {
  if (factor == 0) {
    slot.skip(static_cast<int>(entries_.size()));
    return;
  }
  for (const auto& t : entries_) slot.add(factor * t.value);
}

void SquareMatrix::add(double factor, std::span<double> values, std::size_t columns) const {
  if (dense_.empty() || factor == 0) return;
  const auto n = static_cast<std::size_t>(rows_);
  double* row = values.data() + (columns + 1) * (columns - n);
  for (std::size_t i = 0; i < n; ++i, row += columns)
    for (std::size_t j = 0; j < n; ++j) row[j] += factor * dense_[i * n + j];
}

}  // namespace dalembert
