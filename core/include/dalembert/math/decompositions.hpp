// Decompositions of matrices of any size, for set-up and diagnosis. Eigen's templates for them take long to compile: they are
// instantiated in one place.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace dalembert {

// Orthonormal columns that span those of a matrix, by Householder reflections.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns);

struct SymmetricEigenpairs {
  Eigen::VectorXd values;  // ascending
  Eigen::MatrixXd vectors;
};
SymmetricEigenpairs symmetric_eigenpairs(const Eigen::MatrixXd& matrix);
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

struct Eigenpairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};
Eigenpairs eigenpairs(const Eigen::MatrixXd& matrix);

// The smallest x of all that bring matrix x nearest to the right-hand side.
Eigen::VectorXd smallest_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right_hand_side);

// The triangle of a QR decomposition in which each column is the one of which most is left behind those before it.
struct PivotedTriangle {
  Eigen::MatrixXd triangle;
  std::vector<int> columns;  // columns of the matrix, in this order
};
PivotedTriangle pivoted_triangle(const Eigen::MatrixXd& matrix);

// An orthonormal basis whose first `rank` vectors span all columns. Empty if the remainder of a column is neither
// large enough nor negligible.
struct TurnedApart {
  Eigen::MatrixXd basis;
  Eigen::Index rank;
};
std::optional<TurnedApart> turned_apart(const Eigen::MatrixXd& columns, double large, double negligible);

// Columns that span the null space of the matrix; smaller pivots, relative to the largest, count as zero.
Eigen::MatrixXd kernel_of(const Eigen::MatrixXd& matrix, double negligible_pivot);

}  // namespace dalembert
