// A constant matrix of an item of run-time size, as the user gave it: dense, or sparse with its own entries only.
#pragma once

#include <span>
#include <vector>

#include "dalembert/reflection/storage.hpp"
#include "dalembert/system/term.hpp"

namespace dalembert {

class SquareMatrix {
 public:
  SquareMatrix() = default;
  explicit SquareMatrix(const MatrixContainer& from);

  bool empty() const { return rows_ == 0; }
  // Whether it was made from these very entries.
  bool is_made_from(const MatrixContainer& m) const {
    return m.empty() ? empty()
                     : rows_ == m.rows && (m.dense ? dense_.shares_with(m.values) : given_.shares_with(m.triplets));
  }
  bool sparse() const { return !empty() && dense_.empty(); }
  // The entries of a sparse matrix, each place once, row by row.
  const SharedList<MatrixContainer::Triplet>& entries() const { return entries_; }
  bool same_places(const SquareMatrix& other) const;

  // y += A x, with x and y in the system's vectors.
  void add_product(const double* x, std::span<const int> dofs, double* y) const { add_product(x, dofs, y, dofs); }
  void add_product(const double* x, std::span<const int> from, double* y, std::span<const int> to) const;
  // Places of a sparse matrix, and its entries times `factor` in their order.
  void visit(BlockVisitor& visitor, std::span<const int> dofs) const;
  void add(double factor, SlotCursor& slot) const;
  // A dense matrix: values += factor A, in the last rows and columns of a larger one of so many columns.
  void add(double factor, std::span<double> values, std::size_t columns) const;

 private:
  int rows_ = 0;
  SharedList<double> dense_;
  SharedList<MatrixContainer::Triplet> given_, entries_;  // of a sparse matrix: in the order of the user, and sorted
};

}  // namespace dalembert
