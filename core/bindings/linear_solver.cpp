// dalembert._core.testing.LinearSolver, ProximalSolver: linear solvers alone, for analyses in Python, tests and benchmarks.
#include "dalembert/linear/linear_solver.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "dalembert/model/errors.hpp"
#include "dalembert/solvers/proximal_equations.hpp"
#include "module.hpp"

namespace dalembert {
namespace {

using DoubleArray = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<int, py::array::c_style | py::array::forcecast>;

// A pattern in compressed-column storage, made symmetric, with its solver.
class PatternSolver {
 public:
  PatternSolver(const Integers& column_start, const Integers& row_index, bool dense,
                const LinearSolverOptions& options) {
    const int size = static_cast<int>(column_start.size()) - 1;
    const auto for_each_entry = [&](auto&& f) {
      for (int j = 0; j < size; ++j) {
        for (int k = column_start.at(j); k < column_start.at(j + 1); ++k) f(row_index.at(k), j);
      }
    };
    Couplings couplings;
    for_each_entry([&](int row, int column) { couplings.add(column, row); });
    pattern_ = dense ? Pattern::dense(size) : Pattern::sparse(size, couplings);
    for_each_entry([&](int row, int column) { slots_.push_back(pattern_.slot(row, column)); });
    complete_ = static_cast<int>(slots_.size()) == pattern_.values() && std::is_sorted(slots_.begin(), slots_.end());
    values_.assign(static_cast<std::size_t>(pattern_.values()), 0.0);
    solver_ = make_linear_solver(pattern_, dense ? LinearSolverType::EXUdense : LinearSolverType::EigenSparse, options);
  }
  PatternSolver(const PatternSolver&) = delete;
  PatternSolver& operator=(const PatternSolver&) = delete;

  int factorize(const DoubleArray& values) { return solver_->factorize(in_order_of_pattern(values)); }
  std::span<const double> in_order_of_pattern(const DoubleArray& values) {
    check(values, slots_.size(), "data");
    if (complete_) return {values.data(), slots_.size()};
    for (std::size_t k = 0; k < slots_.size(); ++k) values_[slots_[k]] = values.data()[k];
    return values_;
  }
  const Pattern& pattern() const { return pattern_; }
  LinearSolver& solver() { return *solver_; }

  DoubleArray solve(const DoubleArray& right) {
    check(right, static_cast<std::size_t>(pattern_.size()), "b");
    DoubleArray x(right.size(), right.data());
    solver_->solve({x.mutable_data(), static_cast<std::size_t>(x.size())});
    return x;
  }

  static void check(const DoubleArray& received, std::size_t size, const char* where) {
    if (received.ndim() == 1 && static_cast<std::size_t>(received.size()) == size) return;
    const auto numbers = [](auto count) { return std::to_string(count) + " numbers"; };
    refuse(ErrorKind::value, {.item = "testing.LinearSolver",
                              .parameter = where,
                              .received = numbers(received.size()),
                              .expected = numbers(size)});
  }

  py::dict statistics() const {
    const LinearSolverStatistics s = solver_->statistics();
    py::dict result;
    result["factorizations"] = s.factorizations;
    result["pivot_searches"] = s.pivot_searches;
    result["entries"] = s.entries;
    return result;
  }

 private:
  Pattern pattern_;
  std::vector<int> slots_;
  bool complete_;  // the slots are those of the pattern
  std::vector<double> values_;
  std::unique_ptr<LinearSolver> solver_;
};

// Factors of a matrix whose last unknowns are multipliers of constraints, perhaps redundant ones.
class ProximalSolver {
 public:
  ProximalSolver(const Integers& column_start, const Integers& row_index, const DoubleArray& metric)
      : first_(static_cast<int>(column_start.size() - 1 - metric.size())),
        equations_(first_, {metric.data(), metric.data() + metric.size()}),
        factors_(column_start, row_index, false, options()),
        matrix_(static_cast<std::size_t>(factors_.pattern().values())) {}

  int factorize(const DoubleArray& values, double eps) {
    std::ranges::copy(factors_.in_order_of_pattern(values), matrix_.begin());
    for (const int k : equations_.rows()) {
      double& entry = matrix_[static_cast<std::size_t>(factors_.pattern().slot(first_ + k, first_ + k))];
      const auto row = static_cast<std::size_t>(k);
      equations_.entries()[row] = entry != 0 ? 0 : -eps * equations_.metric()[row];
      entry += equations_.entries()[row];
    }
    return factors_.solver().factorize(matrix_);
  }
  DoubleArray step(const DoubleArray& right) { return factors_.solve(right); }
  DoubleArray solve(const DoubleArray& right, bool fit) {
    factors_.check(right, static_cast<std::size_t>(factors_.pattern().size()), "b");
    DoubleArray x(right.size(), right.data());
    equations_.solve(factors_.solver(), {x.mutable_data(), static_cast<std::size_t>(x.size())}, fit);
    return x;
  }
  DoubleArray misfit(const DoubleArray& gaps) {
    factors_.check(gaps, equations_.metric().size(), "gaps");
    const std::vector<double> open = equations_.misfit(factors_.solver(), {gaps.data(), equations_.metric().size()});
    return DoubleArray(static_cast<py::ssize_t>(open.size()), open.data());
  }

 private:
  LinearSolverOptions options() const {
    LinearSolverOptions options;
    for (const int k : equations_.rows()) options.tiny_diagonal.push_back(first_ + k);
    return options;
  }

  int first_;  // unknown of the first equation
  ProximalEquations equations_;
  PatternSolver factors_;
  std::vector<double> matrix_;
};

}  // namespace

void register_linear_solver(py::module_& module) {
  py::module_ testing = module.attr("testing");
  py::class_<PatternSolver>(
      testing, "LinearSolver",
      "Solver of A x = b for matrices with one pattern, in compressed columns as scipy.sparse.csc_array "
      "has them. instructions: one of instruction_sets(), by default the first.")
      .def(py::init([](const Integers& column_start, const Integers& row_index, bool dense, double pivot_threshold,
                       bool ignore_singular, int unsettled_matrices, const std::string& instructions) {
             const LinearSolverOptions options{pivot_threshold, ignore_singular, unsettled_matrices, instructions};
             return std::make_unique<PatternSolver>(column_start, row_index, dense, options);
           }),
           py::arg("indptr"), py::arg("indices"), py::kw_only(), py::arg("dense") = false,
           py::arg("pivot_threshold") = 0.0, py::arg("ignore_singular") = false, py::arg("unsettled_matrices") = 0,
           py::arg("instructions") = "")
      .def("factorize", &PatternSolver::factorize, py::arg("data"),
           "Factors of the matrix with these values, which stand in the order of indices. Returns -1, or the column at "
           "which no pivot was left.")
      .def("solve", &PatternSolver::solve, py::arg("b"), "x of A x = b.")
      .def_property_readonly(
          "statistics", &PatternSolver::statistics,
          "factorizations; pivot_searches: how many of them chose their pivots; entries: numbers in the "
          "factors.");
  py::class_<ProximalSolver>(
      testing, "ProximalSolver",
      "Solver of [[A, G^T], [G, -eps D]] (x, lambda) = b, whose matrix is in compressed columns without the entries of "
      "eps. metric: the diagonal of D, one number per equation; 0: the equation is not regularized.")
      .def(py::init<const Integers&, const Integers&, const DoubleArray&>(), py::arg("indptr"), py::arg("indices"),
           py::arg("metric"))
      .def("factorize", &ProximalSolver::factorize, py::arg("data"), py::arg("eps"),
           "Computes factors. Returns -1, or the column at which no pivot was left.")
      .def("step", &ProximalSolver::step, py::arg("b"), "Solution of the regularized equations.")
      .def("solve", &ProximalSolver::solve, py::arg("b"), py::arg("fit") = true,
           "Solution for eps = 0. fit = false: the part of b that no x fulfils is left open.")
      .def("misfit", &ProximalSolver::misfit, py::arg("gaps"), "Part of G x = gaps that no x fulfils.");
  testing.def("instruction_sets", &instruction_sets,
              "Those of this processor for which the factorization has code of its own, best first.");
}

}  // namespace dalembert
