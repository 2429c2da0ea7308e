#include "dalembert/math/decompositions.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace dalembert {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd orthonormal(const MatrixXd& columns) {
  const Eigen::HouseholderQR<MatrixXd> qr(columns);
  return qr.householderQ() * MatrixXd::Identity(columns.rows(), columns.cols());
}

SymmetricEigenpairs symmetric_eigenpairs(const MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> pairs(matrix);
  return {pairs.eigenvalues(), pairs.eigenvectors()};
}

VectorXd symmetric_eigenvalues(const MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigenpairs eigenpairs(const MatrixXd& matrix) {
  const Eigen::EigenSolver<MatrixXd> pairs(matrix);
  return {pairs.eigenvalues(), pairs.eigenvectors()};
}

VectorXd smallest_solution(const MatrixXd& matrix, const VectorXd& right_hand_side) {
  return Eigen::CompleteOrthogonalDecomposition<MatrixXd>(matrix).solve(right_hand_side);
}

PivotedTriangle pivoted_triangle(const MatrixXd& matrix) {
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(matrix);
  const auto& columns = qr.colsPermutation().indices();
  const Eigen::Index rank = std::min(matrix.rows(), matrix.cols());
  return {qr.matrixQR().topRows(rank).triangularView<Eigen::Upper>(), std::vector<int>(columns.begin(), columns.end())};
}

std::optional<TurnedApart> turned_apart(const MatrixXd& columns, double large, double negligible) {
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
  const VectorXd pivots = qr.matrixQR().diagonal().cwiseAbs();
  const Eigen::Index rank = std::ranges::count_if(pivots, [=](double x) { return x > large; });
  if (!std::ranges::all_of(pivots, [=](double x) { return x > large || x < negligible; })) return {};
  return TurnedApart{qr.householderQ(), rank};
}

MatrixXd kernel_of(const MatrixXd& matrix, double negligible_pivot) {
  Eigen::FullPivLU<MatrixXd> lu(matrix);
  lu.setThreshold(negligible_pivot);
  return lu.isInvertible() ? MatrixXd(matrix.cols(), 0) : MatrixXd(lu.kernel());
}

// Eigen moves columns of which less than its threshold is left behind all others: T = [T11 T12], and the basis is [-T11^-1 T12; 1].

}  // namespace dalembert
