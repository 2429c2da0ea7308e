// The submodule `symbolic`: Real, Vector, Matrix, their functions, named variables and user functions.
#include "symbolic.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

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
    throw py::value_error(std::string("symbolic: ") + method + ": '" + symbolic::text(*symbol.node) + "' is an expression; only variables can be set");
  return symbol.node;
}

void set_values(Symbol& symbol, const Node& value, const char* method) {
  Node& node = variable_of(symbol, method);
  if (node->shape != value->shape) throw py::value_error(std::string("symbolic: ") + method + ": the size cannot change");
  node->values = symbolic::evaluate(value);
  node->is_open = false;
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
  if (symbol.node->op == Op::variable && symbolic::is_leaf(*entry) && !symbol.node->is_open && !entry->is_open) {
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
    throw py::type_error("symbolic: the truth of '" + symbolic::text(*a.node) + "' is not known while it is recorded; use symbolic.IfThenElse(condition, a, b)");
  return a.node->values[0] != 0;
}

constexpr std::array<std::pair<const char*, Op>, 19> methods_for_numpy{{
    {"sin", Op::sin}, {"cos", Op::cos}, {"tan", Op::tan}, {"arcsin", Op::asin}, {"arccos", Op::acos}, {"arctan", Op::atan},
    {"sinh", Op::sinh}, {"cosh", Op::cosh}, {"tanh", Op::tanh}, {"arcsinh", Op::asinh}, {"arccosh", Op::acosh}, {"arctanh", Op::atanh},
    {"exp", Op::exp}, {"log", Op::log}, {"sqrt", Op::sqrt}, {"rint", Op::round}, {"fabs", Op::absolute},
    {"__floor__", Op::floor}, {"__ceil__", Op::ceil}}};

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
  real.def("__float__", [](const Real& a) { return known_values(a.node)[0]; });
  real.def("__bool__", &truth);
  // Functions of numpy call methods of objects: np.sin(x) is x.sin(), np.floor(x) is math.floor(x).
  for (const auto& [name, op] : methods_for_numpy) real.def(name, [op = op](const Real& a) { return wrap(symbolic::apply(op, a.node)); });
  real.def("SetValue", [](Real& a, const py::object& value) { set_values(a, scalar(value), "SetValue"); }, py::arg("value"),
           "Set a variable; all expressions that contain it follow.");
  real.def_property("value", [](const Real& a) {
             if (!symbolic::is_leaf(*a.node)) throw py::value_error("symbolic: '" + symbolic::text(*a.node) + "' is an expression; use Evaluate()");
             return known_values(a.node)[0];
           }, [](Real& a, double value) { set_values(a, symbolic::constant(value), "value"); });
  real.def("Diff", [](const Real& a, const Real& variable) { return symbolic::Tape(a.node).derivative(*variable.node); }, py::arg("variable"),
           "The value of the derivative with respect to a variable.");
}

void register_vector(py::module_& module) {
  py::class_<Vector, Symbol> vector(module, "Vector", "A vector expression.");
  vector.def(py::init([](const py::object& values) { return Vector{{vector_of(values)}}; }), py::arg("vector"));
  vector.def(py::init([](const std::string& name, const py::object& values) { return Vector{{vector_of(values, name)}}; }), py::arg("name"), py::arg("vector"));
  add_common(vector);
  add_in_place_operators(vector);
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
  add_in_place_operators(matrix);
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
  module.def("_Table", [](const py::object& x, const py::object& numbers) { return wrap(symbolic::table(scalar(x), vector_of(numbers))); }, py::arg("x"),
             py::arg("numbers"), "A cubic polynomial between two points, see math/piecewise_cubic.hpp.");
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
    require_size(results.size());
    run(time, item, arguments, results);
  }
  std::vector<double> call_any(double time, int item, std::span<const Argument> arguments) const override {
    std::vector<double> results(static_cast<std::size_t>(tape_->shape().size()));
    run(time, item, arguments, results);
    return results;
  }
  bool has_derivatives() const override { return true; }
  void linearize(double time, int item, std::span<const Argument> arguments, std::span<const int> numbers, std::span<double> results,
                 std::span<double> slopes) const override {
    require_size(results.size());
    const std::size_t before = static_cast<std::size_t>(takes_time_) + static_cast<std::size_t>(takes_item_);
    with_inputs(time, item, arguments,
                [&](std::span<const double* const> inputs) { tape_->linearize(inputs, before, numbers, results, slopes); });
  }
  PyObject* function() const { return function_.ptr(); }

 private:
  static constexpr std::size_t most = 24;

  void require_size(std::size_t size) const {
    if (static_cast<int>(size) != tape_->shape().size())
      complain("it gives " + std::to_string(tape_->shape().size()) + " numbers instead of " + std::to_string(size));
  }
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
  const Node variable = symbolic::variable({}, {value}, name);
  variable->is_open = found->second->is_open;
  SymbolicFunction made = function;
  made.tape = std::make_shared<symbolic::Tape>(function.tape->replaced(*found->second, variable));
  return made;
}

// ---- stored functions ------------------------------------------------------------------------------------------------

// A function as numbers, texts and lists: operands are numbers of earlier entries of `nodes`. A constant is a number, a
// variable a dictionary, an operation a list of its name, operands, and perhaps an index or a shape.
py::dict stored(const SymbolicFunction& function) {
  if (!function.tape) refuse_empty();
  std::unordered_map<const symbolic::Expression*, int> numbers;
  py::list nodes, arguments;
  const auto add = [&](const Node& e) {
    if (!numbers.emplace(e.get(), static_cast<int>(numbers.size())).second) return;
    if (e->op == Op::constant) {
      nodes.append(e->values[0]);
      return;
    }
    if (e->op == Op::variable) {
      py::dict variable;
      variable["name"] = e->name;
      variable["shape"] = py::make_tuple(e->shape.rows, e->shape.columns);
      variable["values"] = e->values;
      variable["open"] = e->is_open;
      nodes.append(variable);
      return;
    }
    py::list entry;
    entry.append(std::string(e->op == Op::element ? "element" : e->op == Op::gather ? "gather" : e->op == Op::replace ? "replace" : symbolic::name_of(e->op)));
    for (const Node& operand : e->operands) entry.append(numbers.at(operand.get()));
    if (e->op == Op::element || e->op == Op::replace) entry.append(e->index);
    if (e->op == Op::gather) entry.append(py::make_tuple(e->shape.rows, e->shape.columns));
    nodes.append(entry);
  };
  for (const Node& argument : function.arguments) {
    add(argument);
    arguments.append(numbers.at(argument.get()));
  }
  // constants with the values of this function, which a copy by _WithVariable has changed
  for (const Node& e : symbolic::in_order(function.result)) add(e);
  py::dict result, constants;
  for (const auto& [name, node] : scalars_of(function)) constants[py::str(name)] = node->values[0];
  result["name"] = function.name;
  result["arguments"] = arguments;
  result["constants"] = constants;
  result["nodes"] = nodes;
  result["result"] = numbers.at(function.result.get());
  return result;
}

// Reads what `stored` returns; a file may have anything in its place.
class StoredFunction {
 public:
  explicit StoredFunction(const py::dict& data) : data_(data) {}

  SymbolicFunction read() {
    const auto nodes = entry<py::list>(data_, "nodes");
    for (const py::handle node : nodes) nodes_.push_back(made(node));
    SymbolicFunction function;
    function.name = entry<std::string>(data_, "name");
    for (const py::handle number : entry<py::list>(data_, "arguments")) {
      const Node argument = operand(number);
      if (argument->op != Op::variable) complain("an argument is not a variable");
      function.arguments.push_back(argument);
    }
    function.result = operand(entry<py::object>(data_, "result"));
    function.tape = std::make_shared<symbolic::Tape>(function.result, function.arguments);
    for (const auto& [name, value] : entry<std::map<std::string, double>>(data_, "constants")) function = with_variable(function, name, value);
    return function;
  }

 private:
  [[noreturn]] static void complain(const std::string& problem) { throw py::value_error("symbolic.UserFunction: the stored function is not valid: " + problem); }

  template <class T>
  static T entry(const py::dict& data, const char* key) {
    if (!data.contains(key)) complain("'" + std::string(key) + "' is missing");
    return cast<T>(data[key]);
  }
  template <class T>
  static T cast(const py::object& value) {
    try {
      if constexpr (std::is_base_of_v<py::object, T>) {
        if (!py::isinstance<T>(value)) complain("unexpected " + show(value.ptr()));
        return py::reinterpret_borrow<T>(value);
      } else {
        return value.cast<T>();
      }
    } catch (const py::cast_error&) {
      complain("unexpected " + show(value.ptr()));
    }
  }
  static Shape shape(const py::object& value) {
    const auto [rows, columns] = cast<std::pair<int, int>>(value);
    if (rows < 0 || columns < 0 || (rows == 0 && columns > 0) || rows > largest || columns > largest) complain("unexpected shape " + show(value.ptr()));
    return {rows, columns};
  }
  Node operand(const py::handle& number) const {
    const int i = cast<int>(py::reinterpret_borrow<py::object>(number));
    if (i < 0 || i >= static_cast<int>(nodes_.size())) complain("there is no earlier node " + std::to_string(i));
    return nodes_[static_cast<std::size_t>(i)];
  }
  int index(const py::handle& value, const Node& of) const {
    const int i = cast<int>(py::reinterpret_borrow<py::object>(value));
    if (of->shape.is_scalar() || i < 0 || i >= of->shape.size()) complain("there is no component " + std::to_string(i));
    return i;
  }

  Node made(const py::handle& node) const {
    if (PyFloat_Check(node.ptr()) != 0 || PyLong_Check(node.ptr()) != 0) return symbolic::constant(PyFloat_AsDouble(node.ptr()));
    if (py::isinstance<py::dict>(node)) {
      const auto data = py::reinterpret_borrow<py::dict>(node);
      const Shape size = shape(entry<py::object>(data, "shape"));
      auto values = entry<std::vector<double>>(data, "values");
      if (static_cast<int>(values.size()) != size.size()) complain("a variable has the wrong number of values");
      const Node variable = symbolic::variable(size, std::move(values), entry<std::string>(data, "name"));
      variable->is_open = entry<bool>(data, "open");
      return variable;
    }
    const auto parts = cast<py::list>(py::reinterpret_borrow<py::object>(node));
    if (parts.size() < 2) complain("unexpected " + show(node.ptr()));
    const std::string name = cast<std::string>(parts[0]);
    const bool further = name == "element" || name == "replace" || name == "gather";
    std::vector<Node> operands;
    for (std::size_t i = 1; i + (further ? 1 : 0) < parts.size(); ++i) operands.push_back(operand(parts[i]));
    const py::object last = parts[parts.size() - 1];
    try {
      if (name == "element" && operands.size() == 1) return symbolic::element(operands[0], index(last, operands[0]));
      if (name == "replace" && operands.size() == 2 && operands[1]->shape.is_scalar())
        return symbolic::replace(operands[0], index(last, operands[0]), operands[1]);
      if (name == "gather" && std::ranges::all_of(operands, [](const Node& e) { return e->shape.is_scalar(); }) &&
          shape(last).size() == static_cast<int>(operands.size()))
        return symbolic::gather(shape(last), std::move(operands));
      return symbolic::apply(name, operands);
    } catch (const std::invalid_argument& error) {
      complain(error.what());
    }
  }

  static constexpr int largest = 1'000'000;
  const py::dict& data_;
  std::vector<Node> nodes_;
};

// Derivatives of an expression along rates of variables, [(variable, rate), ...].
py::object rate_along(const py::object& expression, const std::vector<std::pair<py::object, py::object>>& rates) {
  std::unordered_map<const symbolic::Expression*, Node> given;
  for (const auto& [variable, rate] : rates) {
    const Symbol* symbol = as_symbol(variable);
    if (symbol == nullptr || symbol->node->op != Op::variable) throw py::type_error("symbolic: expected a variable, but received " + show(variable.ptr()));
    const Node along = result_of(rate);
    if (along->shape != symbol->node->shape) throw py::value_error("symbolic: a rate has the wrong size");
    given.emplace(symbol->node.get(), along);
  }
  return wrap(symbolic::rate_of(result_of(expression), given));
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
  type.def("_Stored", &stored);
  type.def_static("_FromStored", [](const py::dict& data) { return StoredFunction(data).read(); }, py::arg("data"));
  type.def(py::pickle(&stored, [](const py::dict& data) { return StoredFunction(data).read(); }));
  module.def("_Rate", &rate_along, py::arg("expression"), py::arg("rates"));
  type.def("TransferUserFunction2Item", &transfer, py::arg("mainSystem"), py::arg("itemIndex"), py::arg("userFunctionName"),
           "Make it the user function of an item.");
  type.def("__str__", [](const SymbolicFunction& f) { return f.result ? symbolic::text(*f.result) : std::string("None"); });
  type.def("__repr__", [](const SymbolicFunction& f) { return "Symbolic<" + f.name + ">"; });
  module.def("_signature", &signature_of, py::arg("itemTypeName"), py::arg("userFunctionName"));
}

// The recorded function of a row; nullptr: there is none.
const SymbolicFunction* recorded_in(const Item& item, const Row& row) {
  if (row.storage != Storage::user_function) return nullptr;
  const auto& function = *static_cast<const UserFunction*>(member(item.record.get(), row));
  PyObject* const found = function ? symbolic_function(*function.callback) : nullptr;
  return found == nullptr ? nullptr : &py::handle(found).cast<const SymbolicFunction&>();
}

// Whether a function has a constant, and does not read a variable of the program.
bool has_own(const SymbolicFunction* function, const std::string& name) {
  if (function == nullptr) return false;
  const auto known = scalars_of(*function);
  const auto found = known.find(name);
  return found != known.end() && found->second->is_open;
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

std::vector<RecordedConstant> constants_named(const Model& model, ItemKind kind, int number, std::string_view name) {
  const std::size_t dot = name.find('.');
  if (dot == std::string_view::npos) return {};
  const Item& item = model.item(kind, number);
  const Row* row = find_row(*item.type, name.substr(0, dot));
  const std::string constant(name.substr(dot + 1)), where = model.describe(kind, number);
  const SymbolicFunction* function = row == nullptr ? nullptr : recorded_in(item, *row);
  if (function == nullptr)
    refuse(ErrorKind::value, {where, "", "there is no parameter " + in_quotes(name), "", "",
                              row == nullptr ? suggest_parameter(*item.type, name.substr(0, dot))
                                             : std::string(row->name) + " is not a recorded function with constants."});
  const auto known = scalars_of(*function);
  if (!known.contains(constant)) {
    std::vector<std::string_view> names;
    for (const auto& entry : known) names.push_back(entry.first);
    refuse(ErrorKind::value, {where, std::string(row->name), "there is no constant " + in_quotes(constant), "", "",
                              names.empty() ? "The function has no constants." : suggestion(constant, names)});
  }
  const auto callback = [&](const Row& of) { return static_cast<const UserFunction*>(member(item.record.get(), of))->callback; };
  std::vector<RecordedConstant> found{{*row, callback(*row), constant}};
  if (!known.at(constant)->is_open) return found;
  for (const Row& other : item.type->rows)
    if (&other != row && has_own(recorded_in(item, other), constant)) found.push_back({other, callback(other), constant});
  return found;
}

std::string own_constant(const Model& model, ItemKind kind, int number, std::string_view name) {
  const Item& item = model.item(kind, number);
  for (const Row& row : item.type->rows) {
    if (has_own(recorded_in(item, row), std::string(name))) return std::string(row.name) + "." + std::string(name);
  }
  return "";
}

double constant_of(const Callback& function, const std::string& name) {
  return scalars_of(py::handle(symbolic_function(function)).cast<const SymbolicFunction&>()).at(name)->values[0];
}

py::object with_constant(const Callback& function, const std::string& name, double value) {
  return py::cast(with_variable(py::handle(symbolic_function(function)).cast<const SymbolicFunction&>(), name, value));
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
