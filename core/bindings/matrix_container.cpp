// MatrixContainer: a matrix that is kept dense or as triplets.
#include <pybind11/numpy.h>

#include <cmath>
#include <limits>

#include "containers.hpp"
#include "conversion.hpp"
#include "python_errors.hpp"

namespace dalembert {
namespace {

std::size_t position(const MatrixContainer& m, int row, int column) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(m.columns) + static_cast<std::size_t>(column);
}

[[noreturn]] void refuse_value(const char* method, const std::string& received, const std::string& expected,
                               ErrorKind kind = ErrorKind::value) {
  refuse(kind, {.item = std::string("MatrixContainer.") + method, .received = received, .expected = expected});
}

// Reads lists, arrays, scipy matrices and containers, and keeps the form of the source.
MatrixContainer read_any(const char* method, const py::object& value) {
  static const Row row{.name = "matrix", .storage = Storage::matrix_container, .offset = 0, .role = Role::parameter};
  MatrixContainer matrix;
  try {
    from_python(value.ptr(), row, &matrix);
  } catch (const Refusal& refusal) {
    refuse(refusal.kind, {.item = std::string("MatrixContainer.") + method,
                          .received = show(value.ptr()),
                          .expected = refusal.expected,
                          .advice = refusal.advice});
  }
  return matrix;
}

void check_size(const char* method, int rows, int columns) {
  if (rows < 0 || columns < 0)
    refuse_value(method, std::to_string(rows) + " x " + std::to_string(columns),
                 "a number of rows and of columns that is not negative");
}

MatrixContainer sized(const char* method, int rows, int columns, bool dense) {
  check_size(method, rows, columns);
  MatrixContainer m;
  m.rows = rows;
  m.columns = columns;
  m.dense = dense;
  if (dense) m.values.edit().assign(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns), 0.0);
  return m;
}

void add(MatrixContainer& m, int row, int column, double value) {
  if (m.dense)
    m.values.edit()[position(m, row, column)] += value;
  else
    m.triplets.edit().push_back({row, column, value});
}

// All entries of a matrix, those of triplets as they come.
template <class F>
void for_each_entry(const MatrixContainer& m, F&& f) {
  for (const MatrixContainer::Triplet& t : m.triplets) f(t.row, t.column, t.value);
  if (!m.dense) return;
  for (int i = 0; i < m.rows; ++i)
    for (int j = 0; j < m.columns; ++j) f(i, j, m.values[position(m, i, j)]);
}

MatrixContainer converted(const MatrixContainer& source, bool dense, double factor) {
  MatrixContainer m = sized("", source.rows, source.columns, dense);
  for_each_entry(source, [&](int i, int j, double value) {
    if (dense || value != 0) add(m, i, j, factor * value);
  });
  return m;
}

bool is_sparse(const py::object& value) {
  return py::hasattr(value, "tocoo") || py::isinstance<MatrixContainer>(value);
}

// Lines of [row, column, value]. Negative sizes mean: as large as the triplets need. With `grows`, sizes are lower
// bounds.
MatrixContainer read_triplets(const char* method, const py::object& value, int rows, int columns, bool grows = false) {
  const MatrixContainer table = read_any(method, value);
  if (!table.empty() && table.columns != 3)
    refuse_value(method, show(value.ptr()), "a scipy sparse matrix, or triplets [row, column, value]");
  MatrixContainer m;
  m.dense = false;
  for (int k = 0; k < table.rows; ++k) {
    const double i = table.values[position(table, k, 0)], j = table.values[position(table, k, 1)];
    const auto fits = [grows](double index, int size) {
      constexpr double most = std::numeric_limits<int>::max();  // largest number of rows and columns
      return index >= 0 && index < most && index == std::floor(index) && (grows || size < 0 || index < size);
    };
    if (!fits(i, rows) || !fits(j, columns))
      refuse_value(
          method, "a triplet for row " + std::to_string(i) + ", column " + std::to_string(j),
          "indices of a matrix with " + std::to_string(rows) + " rows and " + std::to_string(columns) + " columns",
          ErrorKind::index);
    m.triplets.edit().push_back({static_cast<int>(i), static_cast<int>(j), table.values[position(table, k, 2)]});
    m.rows = std::max(m.rows, m.triplets.back().row + 1);
    m.columns = std::max(m.columns, m.triplets.back().column + 1);
  }
  m.rows = grows ? std::max(m.rows, rows) : rows >= 0 ? rows : m.rows;
  m.columns = grows ? std::max(m.columns, columns) : columns >= 0 ? columns : m.columns;
  return m;
}

void set_sparse(MatrixContainer& m, const py::object& value, int rows, int columns, bool dense, double factor) {
  const MatrixContainer source = is_sparse(value) ? read_any("SetWithSparseMatrix", value)
                                                  : read_triplets("SetWithSparseMatrix", value, rows, columns, !dense);
  m = converted(source, dense, factor);
}

void add_sparse(MatrixContainer& m, const py::object& value, double factor) {
  const MatrixContainer source = is_sparse(value) ? read_any("AddSparseMatrix", value)
                                                  : read_triplets("AddSparseMatrix", value, m.rows, m.columns);
  if (source.rows > m.rows || source.columns > m.columns)
    refuse_value(
        "AddSparseMatrix", "a matrix of " + std::to_string(source.rows) + " x " + std::to_string(source.columns),
        "at most " + std::to_string(m.rows) + " x " + std::to_string(m.columns) + ", the size given to Initialize");
  for_each_entry(source, [&](int i, int j, double entry) { add(m, i, j, factor * entry); });
}

py::array_t<double> dense_array(const MatrixContainer& m) {
  py::array_t<double> array({m.rows, m.columns});
  auto out = array.mutable_unchecked<2>();
  for (int i = 0; i < m.rows; ++i)
    for (int j = 0; j < m.columns; ++j) out(i, j) = 0;
  for_each_entry(m, [&](int i, int j, double value) { out(i, j) += value; });
  return array;
}

py::array_t<double> triplet_array(const MatrixContainer& m) {
  const auto n = static_cast<py::ssize_t>(m.triplets.size());
  py::array_t<double> array({n, py::ssize_t{3}});
  auto out = array.mutable_unchecked<2>();
  for (py::ssize_t k = 0; k < n; ++k) {
    const MatrixContainer::Triplet& t = m.triplets[static_cast<std::size_t>(k)];
    out(k, 0) = t.row;
    out(k, 1) = t.column;
    out(k, 2) = t.value;
  }
  return array;
}

py::object object_of_matrix(const MatrixContainer& m) {
  if (m.dense) return dense_array(m);
  py::dict result;
  result["numberOfRows"] = m.rows;
  result["numberOfColumns"] = m.columns;
  result["triplets"] = triplet_array(m);
  return result;
}

MatrixContainer from_state(const py::object& state) {
  if (!py::isinstance<py::dict>(state)) return read_any("__setstate__", state);
  return read_triplets("__setstate__", state["triplets"], state["numberOfRows"].cast<int>(),
                       state["numberOfColumns"].cast<int>());
}

}  // namespace

void register_matrix_container(py::module_& module) {
  using M = MatrixContainer;
  py::class_<M> container(module, "MatrixContainer",
                          "A matrix, dense or sparse. Sparse: triplets (row, column, value) that add up.");
  container.def(py::init<>());
  container.def(py::init([](const py::object& matrix) { return read_any("__init__", matrix); }), py::arg("matrix"),
                "From None, a list of lists or an array (dense), or a scipy matrix (sparse).");
  container.def(
      "Initialize", [](M& m, int rows, int columns, bool dense) { m = sized("Initialize", rows, columns, dense); },
      py::arg("numberOfRows"), py::arg("numberOfColumns"), py::arg("useDenseMatrix") = true, "Zeros of a given size.");
  container.def(
      "SetWithDenseMatrix",
      [](M& m, const py::object& value, bool dense, double factor) {
        m = converted(read_any("SetWithDenseMatrix", value), dense, factor);
      },
      py::arg("pyArray"), py::arg("useDenseMatrix") = false, py::arg("factor") = 1.0,
      "Take over a matrix times a factor, dense or as triplets.");
  container.def("SetWithSparseMatrix", &set_sparse, py::arg("sparseMatrix"), py::arg("numberOfRows") = -1,
                py::arg("numberOfColumns") = -1, py::arg("useDenseMatrix") = false, py::arg("factor") = 1.0,
                "Take over a scipy matrix, or triplets of a matrix of the given size, times a factor.");
  container.def(
      "SetWithSparseMatrixCSR",
      [](M& m, int rows, int columns, const py::object& value, bool dense, double factor) {
        check_size("SetWithSparseMatrixCSR", rows, columns);
        set_sparse(m, value, rows, columns, dense, factor);
      },
      py::arg("numberOfRowsInit"), py::arg("numberOfColumnsInit"), py::arg("pyArrayCSR"),
      py::arg("useDenseMatrix") = false, py::arg("factor") = 1.0, "Earlier form of SetWithSparseMatrix.");
  container.def("AddSparseMatrix", &add_sparse, py::arg("sparseMatrix"), py::arg("factor") = 1.0,
                "Add a scipy matrix, or triplets, times a factor; it may be smaller.");
  container.def("GetPythonObject", &object_of_matrix,
                "An array (dense), or a dictionary with numberOfRows, numberOfColumns and triplets (n x 3).");
  container.def("Convert2DenseMatrix", &dense_array, "The matrix as an array.");
  container.def("UseDenseMatrix", [](const M& m) { return m.dense; }, "True: dense; False: triplets.");
  container.def(
      "SetAllZero", [](M& m) { m = sized("SetAllZero", m.rows, m.columns, m.dense); },
      "Set all entries to zero; the size stays.");
  container.def("__repr__",
                [](const M& m) { return m.empty() && m.dense ? py::str("[]") : py::str(object_of_matrix(m)); });
  container.def("__array__", [](const M& m, const py::args&, const py::kwargs&) { return dense_array(m); });
  container.def("__copy__", [](const M& m) { return M(m); });
  container.def("__deepcopy__", [](const M& m, const py::dict&) { return M(m); });
  container.def(py::pickle(&object_of_matrix, &from_state));
}

}  // namespace dalembert
