// dalembert._core.testing.LinearSolver: the linear solver alone, for tests and benchmarks.
#include "dalembert/linear/linear_solver.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "dalembert/model/errors.hpp"
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

  py::dict statistics() const {
    const LinearSolverStatistics s = solver_->statistics();
    py::dict result;
    result["factorizations"] = s.factorizations;
    result["pivot_searches"] = s.pivot_searches;
    result["entries"] = s.entries;
    return result;
  }

 private:
  static void check(const DoubleArray& received, std::size_t size, const char* where) {
    if (received.ndim() == 1 && static_cast<std::size_t>(received.size()) == size) return;
    const auto numbers = [](auto count) { return std::to_string(count) + " numbers"; };
    refuse(ErrorKind::value, {.item = "testing.LinearSolver",
                              .parameter = where,
                              .received = numbers(received.size()),
                              .expected = numbers(size)});
  }

  Pattern pattern_;
  std::vector<int> slots_;
  bool complete_;  // the slots are those of the pattern
  std::vector<double> values_;
  std::unique_ptr<LinearSolver> solver_;
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
  testing.def("instruction_sets", &instruction_sets,
              "Those of this processor for which the factorization has code of its own, best first.");
}

}  // namespace dalembert
