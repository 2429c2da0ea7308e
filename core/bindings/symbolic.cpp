// The submodule `symbolic`: Real, Vector, Matrix, their functions and named variables.
#include "symbolic.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "conversion.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/symbolic/tape.hpp"
#include "python_errors.hpp"
#include "symbolic_objects.hpp"

namespace dalembert {
namespace {

using symbolic::as_symbol;
using symbolic::Matrix;
using symbolic::Node;
using symbolic::Op;
using symbolic::python_value;
using symbolic::Real;
using symbolic::result_of;
using symbolic::Shape;
using symbolic::Symbol;
using symbolic::Vector;
using symbolic::wrap;

bool recording = true;

// Keeps only the value if nothing is recorded.
Node settled(Node node) { return recording ? node : symbolic::variable(node->shape, symbolic::evaluate(node), ""); }

Node leaf(Shape shape, std::vector<double> values, const std::string& name) {
  return symbolic::variable(shape, std::move(values), recording ? name : "");
}

py::object not_implemented() { return py::reinterpret_borrow<py::object>(Py_NotImplemented); }

// Real, or a number of Python or numpy; nullptr for anything else.
Node scalar_or_none(py::handle value) {
  if (py::isinstance<Real>(value)) return value.cast<const Real&>().node;
  const bool number =
      PyFloat_Check(value.ptr()) != 0 || PyIndex_Check(value.ptr()) != 0 || PyBool_Check(value.ptr()) != 0 ||
      (PyObject_HasAttrString(value.ptr(), "__float__") != 0 && PyObject_HasAttrString(value.ptr(), "__len__") == 0);
  if (!number) return nullptr;
  const double x = PyFloat_AsDouble(value.ptr());
  if (x == -1.0 && PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    return nullptr;
  }
  return symbolic::constant(x);
}

Node scalar(py::handle value) {
  Node node = scalar_or_none(value);
  if (!node) throw py::type_error("symbolic: expected a number or symbolic.Real, but received " + show(value.ptr()));
  return node;
}

Node operand_or_none(py::handle value) {
  if (const Symbol* symbol = as_symbol(value)) return symbol->node;
  return scalar_or_none(value);
}

bool is_sequence(py::handle value) {
  return py::isinstance<py::array>(value) || PyList_Check(value.ptr()) || PyTuple_Check(value.ptr());
}

// Scalars side by side: a variable if all are plain numbers, else an expression.
Node joined(Shape shape, std::vector<Node> entries, const std::string& name) {
  if (shape.size() != static_cast<int>(entries.size()) || entries.empty())
    throw py::value_error("symbolic: a vector or matrix needs at least one component, and rows of the same length");
  const bool plain = std::ranges::all_of(entries, [](const Node& e) { return e->op == Op::constant; });
  if (recording && !plain) return symbolic::gather(shape, std::move(entries));
  std::vector<double> values;
  for (const Node& entry : entries) values.push_back(symbolic::evaluate(entry)[0]);
  return leaf(shape, std::move(values), name);
}

Node vector_of(py::handle value, const std::string& name = "") {
  if (py::isinstance<Vector>(value)) return value.cast<const Vector&>().node;
  if (!is_sequence(value))
    throw py::type_error("symbolic.Vector: expected a list or array, but received " + show(value.ptr()));
  std::vector<Node> entries;
  for (const py::handle entry : value) entries.push_back(scalar(entry));
  const int n = static_cast<int>(entries.size());
  return joined({n, 0}, std::move(entries), name);
}

Node matrix_of(py::handle value, const std::string& name = "") {
  if (py::isinstance<Matrix>(value)) return value.cast<const Matrix&>().node;
  if (!is_sequence(value))
    throw py::type_error("symbolic.Matrix: expected a list of lists or an array, but received " + show(value.ptr()));
  std::vector<Node> entries;
  int rows = 0;
  std::size_t columns = 0;
  for (const py::handle row : value) {
    if (!is_sequence(row))
      throw py::type_error("symbolic.Matrix: expected a list of lists or a matrix, but received " + show(value.ptr()));
    const std::size_t before = entries.size();
    for (const py::handle entry : row) entries.push_back(scalar(entry));
    if (rows++ == 0) columns = entries.size();
    if (entries.size() - before != columns)
      throw py::value_error("symbolic.Matrix: all rows must have the same length");
  }
  return joined({rows, static_cast<int>(columns)}, std::move(entries), name);
}

// Returns the current numbers of an expression. Arguments have no numbers while a function is recorded: a function that used
// such numbers would be recorded for these numbers only.
std::vector<double> known_values(const Node& node) {
  if (const symbolic::Expression* open = symbolic::open_variable(node))
    throw py::type_error("symbolic: '" + symbolic::text(*node) + "' has no value while a function of '" + open->name +
                         "' is recorded; use functions of exu.symbolic instead of those of math and float()");
  return symbolic::evaluate(node);
}

py::object value_of_symbol(const Symbol& symbol) { return python_value(symbol.node->shape, known_values(symbol.node)); }

Node& variable_of(Symbol& symbol, const char* method) {
  if (symbol.node->op != Op::variable)
    throw py::value_error(std::string("symbolic: ") + method + ": '" + symbolic::text(*symbol.node) +
                          "' is an expression; only variables can be set");
  return symbol.node;
}

void set_values(Symbol& symbol, const Node& value, const char* method) {
  Node& node = variable_of(symbol, method);
  if (node->shape != value->shape)
    throw py::value_error(std::string("symbolic: ") + method + ": the size cannot change");
  node->values = symbolic::evaluate(value);
  node->is_open = false;
}

int component(const Node& node, py::ssize_t index) {
  const int n = node->shape.rows;
  if (index < -n || index >= n)
    throw py::index_error("symbolic.Vector: index " + std::to_string(index) + " is out of range; the length is " +
                          std::to_string(n));
  return static_cast<int>(index < 0 ? index + n : index);
}

int component(const Node& node, const std::pair<int, int>& at) {
  const auto [row, column] = at;
  const Shape& shape = node->shape;
  if (row < 0 || row >= shape.rows || column < 0 || column >= shape.columns)
    throw py::index_error("symbolic.Matrix: index (" + std::to_string(row) + ", " + std::to_string(column) +
                          ") is out of range; the size is " + std::to_string(shape.rows) + " x " +
                          std::to_string(shape.columns));
  return row * shape.columns + column;
}

// A number changes a variable for every expression that has it; an expression makes an expression.
void set_component(Symbol& symbol, int index, py::handle value) {
  const Node entry = scalar(value);
  if (symbol.node->op == Op::variable && symbolic::is_leaf(*entry) && !symbol.node->is_open && !entry->is_open) {
    symbol.node->values[static_cast<std::size_t>(index)] = entry->values[0];
    return;
  }
  symbol.node = settled(symbolic::replace(symbol.node, index, entry));
}

// ---- operators -------------------------------------------------------------------------------------------------------

using Binary = Node (*)(const Node&, const Node&);
template <Op O>
Node binary(const Node& a, const Node& b) {
  return symbolic::apply(O, a, b);
}
Node quotient(const Node& a, const Node& b) {
  return a->shape.is_scalar() ? symbolic::apply(Op::divide, a, b)
                              : symbolic::product(symbolic::apply(Op::divide, symbolic::constant(1), b), a);
}

template <class Class>
void add_operator(Class& type, const char* name, Binary f) {
  type.def(name, [f](const Symbol& a, const py::object& other) {
    const Node b = operand_or_none(other);
    return b ? wrap(f(a.node, b)) : not_implemented();
  });
}
template <class Class>
void add_reflected(Class& type, const char* name, Binary f) {
  type.def(name, [f](const Symbol& b, const py::object& other) {
    const Node a = operand_or_none(other);
    return a ? wrap(f(a, b.node)) : not_implemented();
  });
}
template <class Class>
void add_in_place(Class& type, const char* name, Binary f) {
  type.def(name, [f](const py::object& self, const py::object& other) -> py::object {
    const Node b = operand_or_none(other);
    if (!b) return not_implemented();
    auto& symbol = self.cast<Symbol&>();
    Node node = settled(f(symbol.node, b));
    if (node->shape != symbol.node->shape)
      throw py::value_error("symbolic: an operator in place cannot change the size");
    symbol.node = std::move(node);
    return self;
  });
}

// In-place operators exist for vectors and matrices only: in Python, a += b of numbers makes another number.
template <class Class>
void add_in_place_operators(Class& type) {
  add_in_place(type, "__iadd__", binary<Op::add>);
  add_in_place(type, "__isub__", binary<Op::subtract>);
  add_in_place(type, "__imul__", symbolic::product);
  add_in_place(type, "__itruediv__", quotient);
}

template <class Class>
void add_common(Class& type) {
  add_operator(type, "__add__", binary<Op::add>);
  add_reflected(type, "__radd__", binary<Op::add>);
  add_operator(type, "__sub__", binary<Op::subtract>);
  add_reflected(type, "__rsub__", binary<Op::subtract>);
  add_operator(type, "__mul__", symbolic::product);
  add_reflected(type, "__rmul__", symbolic::product);
  add_operator(type, "__truediv__", quotient);
  add_operator(type, "__eq__", binary<Op::equal>);
  add_operator(type, "__ne__", binary<Op::not_equal>);
  type.attr("__hash__") = py::none();
  type.def("__neg__", [](const Symbol& a) { return wrap(symbolic::apply(Op::negate, a.node)); });
  type.def("__pos__", [](const Symbol& a) { return wrap(a.node); });
  type.def("Evaluate", &value_of_symbol, "The value that the expression has now.");
  type.def("__str__", [](const Symbol& a) { return symbolic::text(*a.node); });
  type.def("__repr__", [](const Symbol& a) { return symbolic::text(*a.node); });
  // Counters of the interface's origin; nothing needs counting here.
  type.def("_Open", [](const py::object& self) {
    variable_of(self.cast<Symbol&>(), "_Open")->is_open = true;
    return self;
  });
  type.attr("__newCount") = 0;
  type.attr("__deleteCount") = 0;
}

bool truth(const Real& a) {
  if (!symbolic::is_leaf(*a.node) || a.node->is_open)
    throw py::type_error("symbolic: the truth of '" + symbolic::text(*a.node) +
                         "' is not known while it is recorded; use symbolic.IfThenElse(condition, a, b)");
  return a.node->values[0] != 0;
}

constexpr std::array<std::pair<const char*, Op>, 19> methods_for_numpy{{{"sin", Op::sin},
                                                                        {"cos", Op::cos},
                                                                        {"tan", Op::tan},
                                                                        {"arcsin", Op::asin},
                                                                        {"arccos", Op::acos},
                                                                        {"arctan", Op::atan},
                                                                        {"sinh", Op::sinh},
                                                                        {"cosh", Op::cosh},
                                                                        {"tanh", Op::tanh},
                                                                        {"arcsinh", Op::asinh},
                                                                        {"arccosh", Op::acosh},
                                                                        {"arctanh", Op::atanh},
                                                                        {"exp", Op::exp},
                                                                        {"log", Op::log},
                                                                        {"sqrt", Op::sqrt},
                                                                        {"rint", Op::round},
                                                                        {"fabs", Op::absolute},
                                                                        {"__floor__", Op::floor},
                                                                        {"__ceil__", Op::ceil}}};

void register_real(py::module_& module) {
  py::class_<Real, Symbol> real(module, "Real", "A scalar expression.");
  real.def(py::init([] { return Real{{leaf({}, {0.0}, "")}}; }));
  real.def(py::init([](const std::string& name, double value) { return Real{{leaf({}, {value}, name)}}; }),
           py::arg("name"), py::arg("value"));
  real.def(py::init([](const py::object& value) {
             const Node node = scalar(value);
             return Real{{symbolic::is_leaf(*node) ? leaf({}, node->values, node->name) : settled(node)}};
           }),
           py::arg("value"));
  add_common(real);
  add_reflected(real, "__rtruediv__", quotient);
  add_operator(real, "__pow__", binary<Op::power>);
  add_reflected(real, "__rpow__", binary<Op::power>);
  add_operator(real, "__mod__", binary<Op::floored_modulo>);
  add_reflected(real, "__rmod__", binary<Op::floored_modulo>);
  add_operator(real, "__floordiv__", binary<Op::floored_quotient>);
  add_reflected(real, "__rfloordiv__", binary<Op::floored_quotient>);
  add_operator(real, "__lt__", binary<Op::less>);
  add_operator(real, "__le__", binary<Op::less_equal>);
  add_operator(real, "__gt__", binary<Op::greater>);
  add_operator(real, "__ge__", binary<Op::greater_equal>);
  real.def("__abs__", [](const Real& a) { return wrap(symbolic::apply(Op::absolute, a.node)); });
  real.def("__round__", [](const Real& a) { return wrap(symbolic::apply(Op::round, a.node)); });
  real.def("__float__", [](const Real& a) { return known_values(a.node)[0]; });
  real.def("__bool__", &truth);
  // Functions of numpy call methods of objects: np.sin(x) is x.sin(), np.floor(x) is math.floor(x).
  for (const auto& [name, op] : methods_for_numpy)
    real.def(name, [op = op](const Real& a) { return wrap(symbolic::apply(op, a.node)); });
  real.def(
      "SetValue", [](Real& a, const py::object& value) { set_values(a, scalar(value), "SetValue"); }, py::arg("value"),
      "Set a variable; all expressions that contain it follow.");
  real.def_property(
      "value",
      [](const Real& a) {
        if (!symbolic::is_leaf(*a.node))
          throw py::value_error("symbolic: '" + symbolic::text(*a.node) + "' is an expression; use Evaluate()");
        return known_values(a.node)[0];
      },
      [](Real& a, double value) { set_values(a, symbolic::constant(value), "value"); });
  real.def(
      "Diff", [](const Real& a, const Real& variable) { return symbolic::Tape(a.node).derivative(*variable.node); },
      py::arg("variable"), "The value of the derivative with respect to a variable.");
}

void register_vector(py::module_& module) {
  py::class_<Vector, Symbol> vector(module, "Vector", "A vector expression.");
  vector.def(py::init([](const py::object& values) { return Vector{{vector_of(values)}}; }), py::arg("vector"));
  vector.def(
      py::init([](const std::string& name, const py::object& values) { return Vector{{vector_of(values, name)}}; }),
      py::arg("name"), py::arg("vector"));
  add_common(vector);
  add_in_place_operators(vector);
  vector.attr("__array_ufunc__") = py::none();  // numpy leaves operators to this class
  vector.def("NumberOfItems", [](const Vector& v) { return v.node->shape.rows; });
  vector.def("__len__", [](const Vector& v) { return v.node->shape.rows; });
  vector.def("__getitem__",
             [](const Vector& v, py::ssize_t i) { return wrap(symbolic::element(v.node, component(v.node, i))); });
  vector.def("__setitem__",
             [](Vector& v, py::ssize_t i, const py::object& value) { set_component(v, component(v.node, i), value); });
  vector.def(
      "SetVector", [](Vector& v, const py::object& values) { set_values(v, vector_of(values), "SetVector"); },
      py::arg("vector"), "Set a variable; all expressions that contain it follow.");
  vector.def(
      "NormL2", [](const Vector& v) { return wrap(symbolic::apply(Op::norm, v.node)); }, "The Euclidean length.");
  vector.def(
      "MultComponents",
      [](const Vector& v, const Vector& w) { return wrap(symbolic::apply(Op::multiply_components, v.node, w.node)); },
      py::arg("other"), "Component times component.");
}

void register_matrix(py::module_& module) {
  py::class_<Matrix, Symbol> matrix(module, "Matrix", "A matrix expression.");
  matrix.def(py::init([](const py::object& values) { return Matrix{{matrix_of(values)}}; }), py::arg("matrix"));
  matrix.def(
      py::init([](const std::string& name, const py::object& values) { return Matrix{{matrix_of(values, name)}}; }),
      py::arg("name"), py::arg("matrix"));
  add_common(matrix);
  add_in_place_operators(matrix);
  matrix.attr("__array_ufunc__") = py::none();
  matrix.def("NumberOfRows", [](const Matrix& m) { return m.node->shape.rows; });
  matrix.def("NumberOfColumns", [](const Matrix& m) { return m.node->shape.columns; });
  matrix.def(
      "Get",
      [](const Matrix& m, int row, int column) {
        return wrap(symbolic::element(m.node, component(m.node, {row, column})));
      },
      py::arg("row"), py::arg("column"));
  matrix.def("__getitem__", [](const Matrix& m, const std::pair<int, int>& at) {
    return wrap(symbolic::element(m.node, component(m.node, at)));
  });
  matrix.def("__setitem__", [](Matrix& m, const std::pair<int, int>& at, const py::object& value) {
    set_component(m, component(m.node, at), value);
  });
  matrix.def(
      "SetMatrix", [](Matrix& m, const py::object& values) { set_values(m, matrix_of(values), "SetMatrix"); },
      py::arg("matrix"), "Set a variable; all expressions that contain it follow.");
}

void register_functions(py::module_& module) {
  for (const auto& [op, name] : symbolic::functions_of_one())
    module.def(
        std::string(name).c_str(), [op = op](const py::object& x) { return wrap(symbolic::apply(op, scalar(x))); },
        py::arg("x"));
  for (const auto& [op, name] : symbolic::functions_of_two())
    module.def(
        std::string(name).c_str(),
        [op = op](const py::object& x, const py::object& y) { return wrap(symbolic::apply(op, scalar(x), scalar(y))); },
        py::arg("x"), py::arg("y"));
  module.def(
      "IfThenElse",
      [](const py::object& condition, const py::object& ifTrue, const py::object& ifFalse) {
        return wrap(symbolic::select(scalar(condition), result_of(ifTrue), result_of(ifFalse)));
      },
      py::arg("condition"), py::arg("ifTrue"), py::arg("ifFalse"),
      "ifTrue where the condition is not zero, else ifFalse.");
  module.def(
      "_Table",
      [](const py::object& x, const py::object& numbers) {
        return wrap(symbolic::table(scalar(x), vector_of(numbers)));
      },
      py::arg("x"), py::arg("numbers"), "A cubic polynomial between two points, see math/piecewise_cubic.hpp.");
  module.def(
      "SetRecording", [](bool on) { recording = on; }, py::arg("recording"),
      "Whether operations are recorded or evaluated at once.");
  module.def("GetRecording", [] { return recording; });
}

// ---- variables -------------------------------------------------------------------------------------------------------

struct VariableSet {
  std::map<std::string, Node> nodes;

  void set(const std::string& name, double value) {
    if (const auto found = nodes.find(name); found != nodes.end()) {
      found->second->values[0] = value;
      return;
    }
    nodes.emplace(name, symbolic::variable({}, {value}, name));
  }
  void add(const std::string& name, double value) {
    if (nodes.contains(name))
      throw py::value_error("symbolic.VariableSet: the variable '" + name + "' exists already; use Set");
    set(name, value);
  }
  Real get(const std::string& name) const {
    const auto found = nodes.find(name);
    if (found == nodes.end()) {
      std::vector<std::string_view> names;
      for (const auto& entry : nodes) names.push_back(entry.first);
      throw py::key_error("symbolic.VariableSet: there is no variable '" + name + "'." +
                          (names.empty() ? "" : " " + suggestion(name, names)));
    }
    return {{found->second}};
  }
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : nodes) result.push_back(entry.first);
    return result;
  }
  std::string text() const {
    std::string result;
    for (const auto& [name, node] : nodes)
      result += (result.empty() ? "'" : ", '") + name + "': " + symbolic::text(*symbolic::constant(node->values[0]));
    return "{" + result + "}";
  }
};

void register_variables(py::module_& module) {
  py::class_<VariableSet> type(module, "VariableSet", "Named scalars that Python sets and recorded functions read.");
  type.def(py::init<>());
  type.def("Add", &VariableSet::add, py::arg("name"), py::arg("value"), "Add a variable that does not exist yet.");
  type.def(
      "Add", [](VariableSet& set, const Real& real) { set.add(real.node->name, symbolic::evaluate(real.node)[0]); },
      py::arg("real"));
  type.def("Set", &VariableSet::set, py::arg("name"), py::arg("value"), "Set a variable, or add it.");
  type.def("Get", &VariableSet::get, py::arg("name"));
  type.def(
      "Exists", [](const VariableSet& set, const std::string& name) { return set.nodes.contains(name); },
      py::arg("name"));
  type.def("Reset", [](VariableSet& set) { set.nodes.clear(); }, "Remove all variables.");
  type.def("NumberOfItems", [](const VariableSet& set) { return set.nodes.size(); });
  type.def("GetNames", &VariableSet::names);
  type.def("__getitem__", &VariableSet::get);
  type.def("__setitem__", &VariableSet::set);
  type.def("__str__", &VariableSet::text);
  type.def("__repr__", &VariableSet::text);
  module.attr("variables") = VariableSet();
}

}  // namespace

namespace symbolic {

py::object wrap(Node node) {
  node = settled(std::move(node));
  if (node->shape.is_scalar()) return py::cast(Real{{std::move(node)}});
  if (node->shape.is_matrix()) return py::cast(Matrix{{std::move(node)}});
  return py::cast(Vector{{std::move(node)}});
}

const Symbol* as_symbol(py::handle value) {
  if (py::isinstance<Real>(value)) return &value.cast<const Real&>();
  if (py::isinstance<Vector>(value)) return &value.cast<const Vector&>();
  if (py::isinstance<Matrix>(value)) return &value.cast<const Matrix&>();
  return nullptr;
}

Node result_of(py::handle value) {
  if (Node node = operand_or_none(value)) return node;
  if (!is_sequence(value))
    throw py::type_error(
        "symbolic: a user function must return a number, a list or a symbolic expression, but it returned " +
        show(value.ptr()));
  if (py::len(value) > 0 && is_sequence(py::reinterpret_steal<py::object>(PySequence_GetItem(value.ptr(), 0))))
    return matrix_of(value);
  return vector_of(value);
}

py::object python_value(Shape shape, const std::vector<double>& values) {
  if (shape.is_scalar()) return py::float_(values[0]);
  if (shape.is_matrix()) return py::array_t<double>(std::vector<py::ssize_t>{shape.rows, shape.columns}, values.data());
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

}  // namespace symbolic

bool is_symbolic_real(PyObject* value) { return py::isinstance<Real>(value); }

void register_symbolic(py::module_& module) {
  py::module_ symbolic = module.def_submodule(
      "symbolic",
      "Expressions of scalars, vectors and matrices that are recorded and evaluated without the interpreter.");
  py::class_<Symbol>(symbolic, "_Symbol");
  register_real(symbolic);
  register_vector(symbolic);
  register_matrix(symbolic);
  register_functions(symbolic);
  register_variables(symbolic);
  symbolic::register_user_functions(symbolic);
}

}  // namespace dalembert
