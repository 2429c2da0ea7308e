#include "dalembert/batches/square_matrix.hpp"

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
  for (const auto& t : sorted) {
    if (!entries_.empty() && entries_.back().row == t.row && entries_.back().column == t.column) {
      entries_.back().value += t.value;
    } else {
      entries_.push_back(t);
    }
  }
}

bool SquareMatrix::same_places(const SquareMatrix& other) const {
  return rows_ == other.rows_ && sparse() == other.sparse() &&
         std::ranges::equal(entries_, other.entries_,
                            [](const auto& a, const auto& b) { return a.row == b.row && a.column == b.column; });
}

void SquareMatrix::add_product(const double* x, std::span<const int> dofs, double* y) const {
  for (const auto& t : entries_) y[dofs[t.row]] += t.value * x[dofs[t.column]];
  if (dense_.empty()) return;
  const double* entry = dense_.data();
  for (int i = 0; i < rows_; ++i) {
    double sum = 0;
    for (int j = 0; j < rows_; ++j) sum += *entry++ * x[dofs[j]];
    y[dofs[i]] += sum;
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

void SquareMatrix::add(double factor, std::span<double> values) const {
  for (std::size_t i = 0; i < dense_.size(); ++i) values[i] += factor * dense_[i];
}

}  // namespace dalembert
