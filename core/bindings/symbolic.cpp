// The submodule `symbolic`: Real, Vector, Matrix, their functions, named variables and user functions.
#include "symbolic.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "conversion.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/symbolic/tape.hpp"
#include "index_types.hpp"
#include "main_system.hpp"
#include "python_errors.hpp"

namespace dalembert {
namespace {

using symbolic::Node;
using symbolic::Op;
using symbolic::Shape;

bool recording = true;

// The Python objects: an expression each, which operators in place exchange for another one.
struct Symbol {
  Node node;
};
struct Real : Symbol {};
struct Vector : Symbol {};
struct Matrix : Symbol {};

// Keeps only the value if nothing is recorded.
Node settled(Node node) {
  return recording ? node : symbolic::variable(node->shape, symbolic::evaluate(node), "");
}

py::object wrap(Node node) {
  node = settled(std::move(node));
  if (node->shape.is_scalar()) return py::cast(Real{{std::move(node)}});
  if (node->shape.is_matrix()) return py::cast(Matrix{{std::move(node)}});
  return py::cast(Vector{{std::move(node)}});
}

Node leaf(Shape shape, std::vector<double> values, const std::string& name) {
  return symbolic::variable(shape, std::move(values), recording ? name : "");
}

py::object not_implemented() { return py::reinterpret_borrow<py::object>(Py_NotImplemented); }

const Symbol* as_symbol(py::handle value) {
  if (py::isinstance<Real>(value)) return &value.cast<const Real&>();
  if (py::isinstance<Vector>(value)) return &value.cast<const Vector&>();
  if (py::isinstance<Matrix>(value)) return &value.cast<const Matrix&>();
  return nullptr;
}

// Real, or a number of Python or numpy; nullptr for anything else.
Node scalar_or_none(py::handle value) {
  if (py::isinstance<Real>(value)) return value.cast<const Real&>().node;
  const bool number = PyFloat_Check(value.ptr()) != 0 || PyIndex_Check(value.ptr()) != 0 || PyBool_Check(value.ptr()) != 0 ||
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

bool is_sequence(py::handle value) { return py::isinstance<py::array>(value) || PyList_Check(value.ptr()) || PyTuple_Check(value.ptr()); }

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
  if (!is_sequence(value)) throw py::type_error("symbolic.Vector: expected a list or array, but received " + show(value.ptr()));
  std::vector<Node> entries;
  for (const py::handle entry : value) entries.push_back(scalar(entry));
  const int n = static_cast<int>(entries.size());
  return joined({n, 0}, std::move(entries), name);
}

Node matrix_of(py::handle value, const std::string& name = "") {
  if (py::isinstance<Matrix>(value)) return value.cast<const Matrix&>().node;
  if (!is_sequence(value)) throw py::type_error("symbolic.Matrix: expected a list of lists or an array, but received " + show(value.ptr()));
  std::vector<Node> entries;
  int rows = 0;
  std::size_t columns = 0;
  for (const py::handle row : value) {
    if (!is_sequence(row)) throw py::type_error("symbolic.Matrix: expected a list of lists or a matrix, but received " + show(value.ptr()));
    const std::size_t before = entries.size();
    for (const py::handle entry : row) entries.push_back(scalar(entry));
    if (rows++ == 0) columns = entries.size();
    if (entries.size() - before != columns) throw py::value_error("symbolic.Matrix: all rows must have the same length");
  }
  return joined({rows, static_cast<int>(columns)}, std::move(entries), name);
}

// Converts the return value of a recorded function.
Node result_of(py::handle value) {
  if (Node node = operand_or_none(value)) return node;
  if (!is_sequence(value))
    throw py::type_error("symbolic: a user function must return a number, a list or a symbolic expression, but it returned " + show(value.ptr()));
  if (py::len(value) > 0 && is_sequence(py::reinterpret_steal<py::object>(PySequence_GetItem(value.ptr(), 0)))) return matrix_of(value);
  return vector_of(value);
}

py::object python_value(Shape shape, const std::vector<double>& values) {
  if (shape.is_scalar()) return py::float_(values[0]);
  if (shape.is_matrix()) return py::array_t<double>(std::vector<py::ssize_t>{shape.rows, shape.columns}, values.data());
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::object value_of_symbol(const Symbol& symbol) { return python_value(symbol.node->shape, symbolic::evaluate(symbol.node)); }

Node& variable_of(Symbol& symbol, const char* method) {
  if (symbol.node->op != Op::variable)
    throw py::value_error(std::string("symbolic: ") + method + ": '" + symbolic::text(*symbol.node) + "' is an expression; only variables can be set");
  return symbol.node;
}

void set_values(Symbol& symbol, const Node& value, const char* method) {
  Node& node = variable_of(symbol, method);
  if (node->shape != value->shape) throw py::value_error(std::string("symbolic: ") + method + ": the size cannot change");
  node->values = symbolic::evaluate(value);
}

int component(const Node& node, py::ssize_t index) {
  const int n = node->shape.rows;
  if (index < -n || index >= n) throw py::index_error("symbolic.Vector: index " + std::to_string(index) + " is out of range; the length is " + std::to_string(n));
  return static_cast<int>(index < 0 ? index + n : index);
}

int component(const Node& node, const std::pair<int, int>& at) {
  const auto [row, column] = at;
  const Shape& shape = node->shape;
  if (row < 0 || row >= shape.rows || column < 0 || column >= shape.columns)
    throw py::index_error("symbolic.Matrix: index (" + std::to_string(row) + ", " + std::to_string(column) + ") is out of range; the size is " +
                          std::to_string(shape.rows) + " x " + std::to_string(shape.columns));
  return row * shape.columns + column;
}

// A number changes a variable for every expression that has it; an expression makes an expression.
void set_component(Symbol& symbol, int index, py::handle value) {
  const Node entry = scalar(value);
  if (symbol.node->op == Op::variable && symbolic::is_leaf(*entry)) {
    symbol.node->values[static_cast<std::size_t>(index)] = entry->values[0];
    return;
  }
  symbol.node = settled(symbolic::replace(symbol.node, index, entry));
}

// ---- operators -------------------------------------------------------------------------------------------------------

using Binary = Node (*)(const Node&, const Node&);
template <Op O>
Node binary(const Node& a, const Node& b) { return symbolic::apply(O, a, b); }
Node quotient(const Node& a, const Node& b) {
  return a->shape.is_scalar() ? symbolic::apply(Op::divide, a, b) : symbolic::product(symbolic::apply(Op::divide, symbolic::constant(1), b), a);
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
    if (node->shape != symbol.node->shape) throw py::value_error("symbolic: an operator in place cannot change the size");
    symbol.node = std::move(node);
    return self;
  });
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
  add_in_place(type, "__iadd__", binary<Op::add>);
  add_in_place(type, "__isub__", binary<Op::subtract>);
  add_in_place(type, "__imul__", symbolic::product);
  add_in_place(type, "__itruediv__", quotient);
  add_operator(type, "__eq__", binary<Op::equal>);
  add_operator(type, "__ne__", binary<Op::not_equal>);
  type.attr("__hash__") = py::none();
  type.def("__neg__", [](const Symbol& a) { return wrap(symbolic::apply(Op::negate, a.node)); });
  type.def("__pos__", [](const Symbol& a) { return wrap(a.node); });
  type.def("Evaluate", &value_of_symbol, "The value that the expression has now.");
  type.def("__str__", [](const Symbol& a) { return symbolic::text(*a.node); });
  type.def("__repr__", [](const Symbol& a) { return symbolic::text(*a.node); });
  // Counters of the interface's origin; nothing needs counting here.
  type.attr("__newCount") = 0;
  type.attr("__deleteCount") = 0;
}

bool truth(const Real& a) {
  if (!symbolic::is_leaf(*a.node))
    throw py::type_error("symbolic: the truth of '" + symbolic::text(*a.node) + "' is not known while it is recorded; use symbolic.IfThenElse(condition, a, b)");
  return a.node->values[0] != 0;
}

void register_real(py::module_& module) {
  py::class_<Real, Symbol> real(module, "Real", "A scalar expression.");
  real.def(py::init([] { return Real{{leaf({}, {0.0}, "")}}; }));
  real.def(py::init([](const std::string& name, double value) { return Real{{leaf({}, {value}, name)}}; }), py::arg("name"), py::arg("value"));
  real.def(py::init([](const py::object& value) {
             const Node node = scalar(value);
             return Real{{symbolic::is_leaf(*node) ? leaf({}, node->values, node->name) : settled(node)}};
           }), py::arg("value"));
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
  real.def("__float__", [](const Real& a) { return symbolic::evaluate(a.node)[0]; });
  real.def("__bool__", &truth);
  real.def("SetValue", [](Real& a, const py::object& value) { set_values(a, scalar(value), "SetValue"); }, py::arg("value"),
           "Set a variable; all expressions that contain it follow.");
  real.def_property("value", [](const Real& a) {
             if (!symbolic::is_leaf(*a.node)) throw py::value_error("symbolic: '" + symbolic::text(*a.node) + "' is an expression; use Evaluate()");
             return a.node->values[0];
           }, [](Real& a, double value) { set_values(a, symbolic::constant(value), "value"); });
  real.def("Diff", [](const Real& a, const Real& variable) { return symbolic::Tape(a.node).derivative(*variable.node); }, py::arg("variable"),
           "The value of the derivative with respect to a variable.");
}

void register_vector(py::module_& module) {
  py::class_<Vector, Symbol> vector(module, "Vector", "A vector expression.");
  vector.def(py::init([](const py::object& values) { return Vector{{vector_of(values)}}; }), py::arg("vector"));
  vector.def(py::init([](const std::string& name, const py::object& values) { return Vector{{vector_of(values, name)}}; }), py::arg("name"), py::arg("vector"));
  add_common(vector);
  vector.attr("__array_ufunc__") = py::none();  // numpy leaves operators to this class
  vector.def("NumberOfItems", [](const Vector& v) { return v.node->shape.rows; });
  vector.def("__len__", [](const Vector& v) { return v.node->shape.rows; });
  vector.def("__getitem__", [](const Vector& v, py::ssize_t i) { return wrap(symbolic::element(v.node, component(v.node, i))); });
  vector.def("__setitem__", [](Vector& v, py::ssize_t i, const py::object& value) { set_component(v, component(v.node, i), value); });
  vector.def("SetVector", [](Vector& v, const py::object& values) { set_values(v, vector_of(values), "SetVector"); }, py::arg("vector"),
             "Set a variable; all expressions that contain it follow.");
  vector.def("NormL2", [](const Vector& v) { return wrap(symbolic::apply(Op::norm, v.node)); }, "The Euclidean length.");
  vector.def("MultComponents", [](const Vector& v, const Vector& w) { return wrap(symbolic::apply(Op::multiply_components, v.node, w.node)); },
             py::arg("other"), "Component times component.");
}

void register_matrix(py::module_& module) {
  py::class_<Matrix, Symbol> matrix(module, "Matrix", "A matrix expression.");
  matrix.def(py::init([](const py::object& values) { return Matrix{{matrix_of(values)}}; }), py::arg("matrix"));
  matrix.def(py::init([](const std::string& name, const py::object& values) { return Matrix{{matrix_of(values, name)}}; }), py::arg("name"), py::arg("matrix"));
  add_common(matrix);
  matrix.attr("__array_ufunc__") = py::none();
  matrix.def("NumberOfRows", [](const Matrix& m) { return m.node->shape.rows; });
  matrix.def("NumberOfColumns", [](const Matrix& m) { return m.node->shape.columns; });
  matrix.def("Get", [](const Matrix& m, int row, int column) { return wrap(symbolic::element(m.node, component(m.node, {row, column}))); },
             py::arg("row"), py::arg("column"));
  matrix.def("__getitem__", [](const Matrix& m, const std::pair<int, int>& at) { return wrap(symbolic::element(m.node, component(m.node, at))); });
  matrix.def("__setitem__", [](Matrix& m, const std::pair<int, int>& at, const py::object& value) { set_component(m, component(m.node, at), value); });
  matrix.def("SetMatrix", [](Matrix& m, const py::object& values) { set_values(m, matrix_of(values), "SetMatrix"); }, py::arg("matrix"),
             "Set a variable; all expressions that contain it follow.");
}

void register_functions(py::module_& module) {
  for (const auto& [op, name] : symbolic::functions_of_one())
    module.def(std::string(name).c_str(), [op = op](const py::object& x) { return wrap(symbolic::apply(op, scalar(x))); }, py::arg("x"));
  for (const auto& [op, name] : symbolic::functions_of_two())
    module.def(std::string(name).c_str(), [op = op](const py::object& x, const py::object& y) { return wrap(symbolic::apply(op, scalar(x), scalar(y))); },
               py::arg("x"), py::arg("y"));
  module.def("IfThenElse", [](const py::object& condition, const py::object& ifTrue, const py::object& ifFalse) {
    return wrap(symbolic::select(scalar(condition), result_of(ifTrue), result_of(ifFalse)));
  }, py::arg("condition"), py::arg("ifTrue"), py::arg("ifFalse"), "ifTrue where the condition is not zero, else ifFalse.");
  module.def("SetRecording", [](bool on) { recording = on; }, py::arg("recording"), "Whether operations are recorded or evaluated at once.");
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
    if (nodes.contains(name)) throw py::value_error("symbolic.VariableSet: the variable '" + name + "' exists already; use Set");
    set(name, value);
  }
  Real get(const std::string& name) const {
    const auto found = nodes.find(name);
    if (found == nodes.end()) {
      std::vector<std::string_view> names;
      for (const auto& entry : nodes) names.push_back(entry.first);
      throw py::key_error("symbolic.VariableSet: there is no variable '" + name + "'." + (names.empty() ? "" : " " + suggestion(name, names)));
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
    for (const auto& [name, node] : nodes) result += (result.empty() ? "'" : ", '") + name + "': " + symbolic::text(*symbolic::constant(node->values[0]));
    return "{" + result + "}";
  }
};

void register_variables(py::module_& module) {
  py::class_<VariableSet> type(module, "VariableSet", "Named scalars that Python sets and recorded functions read.");
  type.def(py::init<>());
  type.def("Add", &VariableSet::add, py::arg("name"), py::arg("value"), "Add a variable that does not exist yet.");
  type.def("Add", [](VariableSet& set, const Real& real) { set.add(real.node->name, symbolic::evaluate(real.node)[0]); }, py::arg("real"));
  type.def("Set", &VariableSet::set, py::arg("name"), py::arg("value"), "Set a variable, or add it.");
  type.def("Get", &VariableSet::get, py::arg("name"));
  type.def("Exists", [](const VariableSet& set, const std::string& name) { return set.nodes.contains(name); }, py::arg("name"));
  type.def("Reset", [](VariableSet& set) { set.nodes.clear(); }, "Remove all variables.");
  type.def("NumberOfItems", [](const VariableSet& set) { return set.nodes.size(); });
  type.def("GetNames", &VariableSet::names);
  type.def("__getitem__", &VariableSet::get);
  type.def("__setitem__", &VariableSet::set);
  type.def("__str__", &VariableSet::text);
  type.def("__repr__", &VariableSet::text);
  module.attr("variables") = VariableSet();
}

// ---- user functions --------------------------------------------------------------------------------------------------

struct SymbolicFunction {
  std::string name;
  Node result;
  std::vector<Node> arguments;
  std::shared_ptr<const symbolic::Tape> tape;
};

[[noreturn]] void refuse_empty() {
  throw py::value_error("symbolic.UserFunction: it is empty; call SetUserFunctionFromDict(...) or use CreateSymbolicUserFunction(...)");
}

class SymbolicCallback final : public Callback {
 public:
  SymbolicCallback(py::object function, const SymbolicFunction& source, const Row& row)
      : function_(std::move(function)), tape_(source.tape), name_(row.name),
        takes_time_(row.signature == nullptr || row.signature->takes_time), takes_item_(row.signature == nullptr || row.signature->takes_item) {}
  ~SymbolicCallback() override {
    if (Py_IsInitialized() == 0) {
      function_.release();
      return;
    }
    const py::gil_scoped_acquire gil;
    function_ = py::object();
  }
  SymbolicCallback(const SymbolicCallback&) = delete;
  SymbolicCallback& operator=(const SymbolicCallback&) = delete;

  void call(double time, int item, std::span<const Argument> arguments, std::span<double> results) const override {
    if (static_cast<int>(results.size()) != tape_->shape().size())
      complain("it gives " + std::to_string(tape_->shape().size()) + " numbers instead of " + std::to_string(results.size()));
    run(time, item, arguments, results);
  }
  std::vector<double> call_any(double time, int item, std::span<const Argument> arguments) const override {
    std::vector<double> results(static_cast<std::size_t>(tape_->shape().size()));
    run(time, item, arguments, results);
    return results;
  }
  // A derivative that does not exist, such as that of a root at zero, is left to differences.
  bool derivative(double time, int item, std::span<const Argument> arguments, int number, std::span<double> results) const override {
    if (static_cast<int>(results.size()) != tape_->shape().size()) return false;
    std::size_t input = 0;
    while (input < arguments.size() && number >= arguments[input].size()) number -= arguments[input++].size();
    const std::size_t before = static_cast<std::size_t>(takes_time_) + static_cast<std::size_t>(takes_item_);
    with_inputs(time, item, arguments, [&](std::span<const double* const> inputs) { tape_->derivative(inputs, before + input, number, results); });
    return std::ranges::all_of(results, [](double x) { return std::isfinite(x); });
  }
  PyObject* function() const { return function_.ptr(); }

 private:
  static constexpr std::size_t most = 24;

  void run(double time, int item, std::span<const Argument> arguments, std::span<double> results) const {
    with_inputs(time, item, arguments, [&](std::span<const double* const> inputs) { tape_->evaluate(inputs, results); });
  }

  template <class Use>
  void with_inputs(double time, int item, std::span<const Argument> arguments, Use&& use) const {
    const double number = item;
    std::array<const double*, most> inputs{};
    std::size_t n = 0;
    if (takes_time_) inputs[n++] = &time;
    if (takes_item_) inputs[n++] = &number;
    const auto shapes = tape_->input_shapes();
    if (n + arguments.size() != shapes.size())
      complain("it was recorded with " + std::to_string(shapes.size()) + " arguments, but is called with " + std::to_string(n + arguments.size()));
    for (const Argument& argument : arguments) {
      if (argument.size() != shapes[n].size())
        complain("argument " + std::to_string(n + 1) + " was recorded with " + std::to_string(shapes[n].size()) + " numbers, but has " +
                 std::to_string(argument.size()));
      inputs[n++] = argument.data;
    }
    use(std::span<const double* const>(inputs.data(), n));
  }

  [[noreturn]] void complain(const std::string& problem) const {
    refuse(ErrorKind::value, {.item = "symbolic user function '" + std::string(name_) + "'", .problem = problem,
                              .advice = "Create it with CreateSymbolicUserFunction(...) for the item that uses it."});
  }

  py::object function_;
  std::shared_ptr<const symbolic::Tape> tape_;
  std::string_view name_;
  bool takes_time_, takes_item_;
};

void set_from_dictionary(SymbolicFunction& function, const py::object&, const py::dict& data, const std::string& name, const py::object&, const std::string&) {
  for (const char* key : {"functionName", "argList", "returnValue"})
    if (!data.contains(key)) throw py::value_error("symbolic.UserFunction: " + name + ": the dictionary has no key '" + key + "'");
  SymbolicFunction made;
  made.name = py::str(data["functionName"]).cast<std::string>();
  made.result = result_of(data["returnValue"]);
  for (const py::handle argument : data["argList"]) {
    if (py::isinstance<MainSystem>(argument)) continue;
    const Symbol* symbol = as_symbol(argument);
    if (symbol == nullptr || symbol->node->op != Op::variable)
      throw py::type_error("symbolic.UserFunction: " + name + ": an argument must be a symbolic variable, but is " + show(argument.ptr()));
    made.arguments.push_back(symbol->node);
  }
  made.tape = std::make_shared<symbolic::Tape>(made.result, made.arguments);
  function = std::move(made);
}

py::object evaluate_function(const SymbolicFunction& function, const py::args& args) {
  if (!function.tape) refuse_empty();
  std::vector<std::vector<double>> values;
  std::vector<const double*> inputs;
  const auto shapes = function.tape->input_shapes();
  for (const py::handle argument : args) {
    if (py::isinstance<MainSystem>(argument) || (values.empty() && argument.is_none())) continue;
    values.push_back(symbolic::evaluate(result_of(argument)));
    const std::size_t i = values.size() - 1;
    if (i < shapes.size() && static_cast<int>(values[i].size()) != shapes[i].size())
      throw py::value_error("symbolic.UserFunction: '" + function.arguments[i]->name + "' needs " + std::to_string(shapes[i].size()) + " numbers, but received " + show(argument.ptr()));
  }
  if (values.size() != shapes.size())
    throw py::type_error("symbolic.UserFunction: " + std::to_string(shapes.size()) + " arguments are needed besides mbs, but " + std::to_string(values.size()) + " are given");
  for (const auto& value : values) inputs.push_back(value.data());
  const Shape shape = function.tape->shape();
  std::vector<double> results(static_cast<std::size_t>(shape.size()));
  function.tape->evaluate(inputs, results);
  if (shape.is_vector()) return py::cast(results);
  return python_value(shape, results);
}

// Scalars that the function reads besides its arguments, by name.
std::map<std::string, Node> scalars_of(const SymbolicFunction& function) {
  if (!function.tape) refuse_empty();
  std::map<std::string, Node> found;
  for (const Node& variable : function.tape->variables())
    if (variable->shape.is_scalar() && !variable->name.empty()) found.emplace(variable->name, variable);
  return found;
}

SymbolicFunction with_variable(const SymbolicFunction& function, const std::string& name, double value) {
  const auto scalars = scalars_of(function);
  const auto found = scalars.find(name);
  if (found == scalars.end()) {
    std::vector<std::string_view> names;
    for (const auto& entry : scalars) names.push_back(entry.first);
    throw py::value_error("symbolic.UserFunction: '" + function.name + "' has no variable '" + name + "'." + (names.empty() ? "" : " " + suggestion(name, names)));
  }
  SymbolicFunction made = function;
  made.tape = std::make_shared<symbolic::Tape>(function.tape->replaced(*found->second, symbolic::variable({}, {value}, name)));
  return made;
}

void transfer(const py::object& self, const py::object& main, const py::object& index, const std::string& name) {
  ItemKind kind{};
  int number = -1;
  if (!read_index(index.ptr(), kind, number))
    throw py::type_error("symbolic.UserFunction: TransferUserFunction2Item: expected an ObjectIndex, LoadIndex or the like, but received " + show(index.ptr()));
  const std::string type(index_name(kind));  // ObjectIndex
  main.attr(("Set" + type.substr(0, type.size() - 5) + "Parameter").c_str())(index, name, self);
}

// [kinds of arguments, kind of the result] of a user function of an item type.
py::object signature_of(const std::string& type_name, const std::string& function_name) {
  static constexpr std::array names{"scalar", "integer", "boolean",    "vector",       "matrix",
                                    "vector", "matrix",  "index_list", "configuration"};
  const auto name_of = [](Signature::Kind kind) { return names[static_cast<std::size_t>(kind)]; };
  for (const ItemType* type : item_types()) {
    if (type->name != type_name) continue;
    for (const Row& row : type->rows) {
      if (row.name != function_name || row.signature == nullptr) continue;
      py::list arguments;
      if (row.signature->takes_time) arguments.append("scalar");
      if (row.signature->takes_item) arguments.append("integer");
      for (const auto kind : row.signature->arguments) arguments.append(name_of(kind));
      return py::make_tuple(arguments, name_of(row.signature->result));
    }
  }
  return py::none();
}

void register_user_functions(py::module_& module) {
  py::class_<SymbolicFunction> type(module, "UserFunction", "A recorded user function; it is evaluated without the interpreter.");
  type.def(py::init<>());
  type.def("SetUserFunctionFromDict", &set_from_dictionary, py::arg("mainSystem"), py::arg("fcnDict"), py::arg("userFunctionName"),
           py::arg("itemIndex") = py::none(), py::arg("itemTypeName") = "None", "Use a result of ConvertFunctionToSymbolic(...).");
  type.def("Evaluate", &evaluate_function, "Call the function from Python; mbs comes first.");
  type.def("__call__", &evaluate_function);
  type.def("_Variables", [](const SymbolicFunction& f) {
    std::map<std::string, double> values;
    for (const auto& [name, node] : scalars_of(f)) values.emplace(name, node->values[0]);
    return values;
  });
  type.def("_WithVariable", &with_variable, py::arg("name"), py::arg("value"));
  type.def("TransferUserFunction2Item", &transfer, py::arg("mainSystem"), py::arg("itemIndex"), py::arg("userFunctionName"),
           "Make it the user function of an item.");
  type.def("__str__", [](const SymbolicFunction& f) { return f.result ? symbolic::text(*f.result) : std::string("None"); });
  type.def("__repr__", [](const SymbolicFunction& f) { return "Symbolic<" + f.name + ">"; });
  module.def("_signature", &signature_of, py::arg("itemTypeName"), py::arg("userFunctionName"));
}

}  // namespace

bool is_symbolic_real(PyObject* value) { return py::isinstance<Real>(value); }

std::shared_ptr<const Callback> symbolic_callback(PyObject* value, const Row& row) {
  if (!py::isinstance<SymbolicFunction>(value)) return nullptr;
  const auto& function = py::handle(value).cast<const SymbolicFunction&>();
  if (!function.tape) refuse_empty();
  const bool scalar = row.signature == nullptr || row.signature->result <= Signature::Kind::boolean;
  if (scalar != function.tape->shape().is_scalar())
    throw Refusal{ErrorKind::value, scalar ? "a symbolic function that gives a scalar" : "a symbolic function that gives a vector or matrix", ""};
  return std::make_shared<SymbolicCallback>(py::reinterpret_borrow<py::object>(value), function, row);
}

PyObject* symbolic_function(const Callback& callback) {
  const auto* found = dynamic_cast<const SymbolicCallback*>(&callback);
  return found == nullptr ? nullptr : found->function();
}

void register_symbolic(py::module_& module) {
  py::module_ symbolic = module.def_submodule("symbolic", "Expressions of scalars, vectors and matrices that are recorded and evaluated without the interpreter.");
  py::class_<Symbol>(symbolic, "_Symbol");
  register_real(symbolic);
  register_vector(symbolic);
  register_matrix(symbolic);
  register_functions(symbolic);
  register_variables(symbolic);
  register_user_functions(symbolic);
}

}  // namespace dalembert
