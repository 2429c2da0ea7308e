// Recorded user functions: their objects in Python, calls from the core, stored form and constants.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>
#include <utility>

#include "conversion.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/symbolic/tape.hpp"
#include "index_types.hpp"
#include "main_system.hpp"
#include "python_errors.hpp"
#include "symbolic.hpp"
#include "symbolic_objects.hpp"

namespace dalembert {
namespace {

using symbolic::Node;
using symbolic::Op;
using symbolic::Shape;
using symbolic::Symbol;

struct SymbolicFunction {
  std::string name;
  Node result;
  std::vector<Node> arguments;
  std::shared_ptr<const symbolic::Tape> tape;
};

[[noreturn]] void refuse_empty() {
  throw py::value_error(
      "symbolic.UserFunction: it is empty; call SetUserFunctionFromDict(...) or use CreateSymbolicUserFunction(...)");
}

class SymbolicCallback final : public Callback {
 public:
  SymbolicCallback(py::object function, const SymbolicFunction& source, const Row& row)
      : function_(std::move(function)),
        tape_(source.tape),
        name_(row.name),
        takes_time_(row.signature == nullptr || row.signature->takes_time),
        takes_item_(row.signature == nullptr || row.signature->takes_item) {
    for (const Node& argument : source.arguments) arguments_.push_back(argument->name);
  }
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
    require_size(results.size(), item);
    run(time, item, arguments, results);
  }
  std::vector<double> call_any(double time, int item, std::span<const Argument> arguments) const override {
    std::vector<double> results(static_cast<std::size_t>(tape_->shape().size()));
    run(time, item, arguments, results);
    return results;
  }
  bool has_derivatives() const override { return true; }
  void linearize(double time, int item, std::span<const Argument> arguments, std::span<const int> numbers,
                 std::span<double> results, std::span<double> slopes) const override {
    require_size(results.size(), item);
    const std::size_t before = static_cast<std::size_t>(takes_time_) + static_cast<std::size_t>(takes_item_);
    with_inputs(time, item, arguments, [&](std::span<const double* const> inputs) {
      tape_->linearize(inputs, before, numbers, results, slopes);
    });
  }
  PyObject* function() const { return function_.ptr(); }

 private:
  static constexpr std::size_t most = 24;

  void require_size(std::size_t size, int item) const {
    if (static_cast<int>(size) != tape_->shape().size())
      complain(item,
               "it gives " + std::to_string(tape_->shape().size()) + " numbers instead of " + std::to_string(size));
  }
  void run(double time, int item, std::span<const Argument> arguments, std::span<double> results) const {
    with_inputs(time, item, arguments,
                [&](std::span<const double* const> inputs) { tape_->evaluate(inputs, results); });
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
      complain(item, "it was recorded with " + std::to_string(shapes.size()) + " arguments, but is called with " +
                         std::to_string(n + arguments.size()));
    for (const Argument& argument : arguments) {
      if (argument.size() != shapes[n].size())
        complain(item, "argument '" + arguments_[n] + "' was recorded with " + std::to_string(shapes[n].size()) +
                           " numbers, but has " + std::to_string(argument.size()));
      inputs[n++] = argument.data;
    }
    use(std::span<const double* const>(inputs.data(), n));
  }

  [[noreturn]] void complain(int item, const std::string& problem) const {
    refuse(
        ErrorKind::value,
        {.item = (takes_item_ ? "object " + std::to_string(item) + ", " : "") + "recorded user function '" +
                 std::string(name_) + "'",
         .problem = problem,
         .advice = "Record it for the markers and nodes of this item: by CreateSymbolicUserFunction(...), or by a law "
                   "with these numbers of coordinates or states."});
  }

  py::object function_;
  std::shared_ptr<const symbolic::Tape> tape_;
  std::string_view name_;
  std::vector<std::string> arguments_;
  bool takes_time_, takes_item_;
};

void set_from_dictionary(SymbolicFunction& function, const py::object&, const py::dict& data, const std::string& name,
                         const py::object&, const std::string&) {
  for (const char* key : {"functionName", "argList", "returnValue"})
    if (!data.contains(key))
      throw py::value_error("symbolic.UserFunction: " + name + ": the dictionary has no key '" + key + "'");
  SymbolicFunction made;
  made.name = py::str(data["functionName"]).cast<std::string>();
  made.result = symbolic::result_of(data["returnValue"]);
  for (const py::handle argument : data["argList"]) {
    if (py::isinstance<MainSystem>(argument)) continue;
    const Symbol* symbol = symbolic::as_symbol(argument);
    if (symbol == nullptr || symbol->node->op != Op::variable)
      throw py::type_error("symbolic.UserFunction: " + name + ": an argument must be a symbolic variable, but is " +
                           show(argument.ptr()));
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
    values.push_back(symbolic::evaluate(symbolic::result_of(argument)));
    const std::size_t i = values.size() - 1;
    if (i < shapes.size() && static_cast<int>(values[i].size()) != shapes[i].size())
      throw py::value_error("symbolic.UserFunction: '" + function.arguments[i]->name + "' needs " +
                            std::to_string(shapes[i].size()) + " numbers, but received " + show(argument.ptr()));
  }
  if (values.size() != shapes.size())
    throw py::type_error("symbolic.UserFunction: " + std::to_string(shapes.size()) +
                         " arguments are needed besides mbs, but " + std::to_string(values.size()) + " are given");
  for (const auto& value : values) inputs.push_back(value.data());
  const Shape shape = function.tape->shape();
  std::vector<double> results(static_cast<std::size_t>(shape.size()));
  function.tape->evaluate(inputs, results);
  if (shape.is_vector()) return py::cast(results);
  return symbolic::python_value(shape, results);
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
    throw py::value_error("symbolic.UserFunction: '" + function.name + "' has no variable '" + name + "'." +
                          (names.empty() ? "" : " " + suggestion(name, names)));
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
    entry.append(std::string(e->op == Op::element   ? "element"
                             : e->op == Op::gather  ? "gather"
                             : e->op == Op::replace ? "replace"
                                                    : symbolic::name_of(e->op)));
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
    for (const auto& [name, value] : entry<std::map<std::string, double>>(data_, "constants"))
      function = with_variable(function, name, value);
    return function;
  }

 private:
  [[noreturn]] static void complain(const std::string& problem) {
    throw py::value_error("symbolic.UserFunction: the stored function is not valid: " + problem);
  }

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
    if (rows < 0 || columns < 0 || (rows == 0 && columns > 0) || rows > largest || columns > largest)
      complain("unexpected shape " + show(value.ptr()));
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
    if (PyFloat_Check(node.ptr()) != 0 || PyLong_Check(node.ptr()) != 0)
      return symbolic::constant(PyFloat_AsDouble(node.ptr()));
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
    const Symbol* symbol = symbolic::as_symbol(variable);
    if (symbol == nullptr || symbol->node->op != Op::variable)
      throw py::type_error("symbolic: expected a variable, but received " + show(variable.ptr()));
    const Node along = symbolic::result_of(rate);
    if (along->shape != symbol->node->shape) throw py::value_error("symbolic: a rate has the wrong size");
    given.emplace(symbol->node.get(), along);
  }
  return symbolic::wrap(symbolic::rate_of(symbolic::result_of(expression), given));
}

void transfer(const py::object& self, const py::object& main, const py::object& index, const std::string& name) {
  ItemKind kind{};
  int number = -1;
  if (!read_index(index.ptr(), kind, number))
    throw py::type_error(
        "symbolic.UserFunction: TransferUserFunction2Item: expected an ObjectIndex, LoadIndex or the like, but "
        "received " +
        show(index.ptr()));
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

void symbolic::register_user_functions(py::module_& module) {
  py::class_<SymbolicFunction> type(module, "UserFunction",
                                    "A recorded user function; it is evaluated without the interpreter.");
  type.def(py::init<>());
  type.def("SetUserFunctionFromDict", &set_from_dictionary, py::arg("mainSystem"), py::arg("fcnDict"),
           py::arg("userFunctionName"), py::arg("itemIndex") = py::none(), py::arg("itemTypeName") = "None",
           "Use a result of ConvertFunctionToSymbolic(...).");
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
  type.def("TransferUserFunction2Item", &transfer, py::arg("mainSystem"), py::arg("itemIndex"),
           py::arg("userFunctionName"), "Make it the user function of an item.");
  type.def("__str__",
           [](const SymbolicFunction& f) { return f.result ? symbolic::text(*f.result) : std::string("None"); });
  type.def("__repr__", [](const SymbolicFunction& f) { return "Symbolic<" + f.name + ">"; });
  module.def("_signature", &signature_of, py::arg("itemTypeName"), py::arg("userFunctionName"));
}

std::shared_ptr<const Callback> symbolic_callback(PyObject* value, const Row& row) {
  if (!py::isinstance<SymbolicFunction>(value)) return nullptr;
  const auto& function = py::handle(value).cast<const SymbolicFunction&>();
  if (!function.tape) refuse_empty();
  const bool scalar = row.signature == nullptr || row.signature->result <= Signature::Kind::boolean;
  if (scalar != function.tape->shape().is_scalar())
    throw Refusal{
        ErrorKind::value,
        scalar ? "a symbolic function that gives a scalar" : "a symbolic function that gives a vector or matrix", ""};
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
  const auto callback = [&](const Row& of) {
    return static_cast<const UserFunction*>(member(item.record.get(), of))->callback;
  };
  std::vector<RecordedConstant> found{{*row, callback(*row), constant}};
  if (!known.at(constant)->is_open) return found;
  for (const Row& other : item.type->rows)
    if (&other != row && has_own(recorded_in(item, other), constant))
      found.push_back({other, callback(other), constant});
  return found;
}

std::string own_constant(const Model& model, ItemKind kind, int number, std::string_view name) {
  const Item& item = model.item(kind, number);
  for (const Row& row : item.type->rows) {
    const SymbolicFunction* function = recorded_in(item, row);
    if (function != nullptr && has_own(function, std::string(name)))
      return std::string(row.name) + "." + std::string(name);
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

}  // namespace dalembert
