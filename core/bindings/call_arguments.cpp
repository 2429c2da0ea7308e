#include "call_arguments.hpp"

#include <bitset>

#include "dalembert/model/errors.hpp"
#include "python_errors.hpp"

namespace dalembert {

const std::vector<ItemClass::Argument>& CallTarget::arguments() const {
  return visualization ? item_class.visualization_arguments : item_class.arguments;
}

std::string CallTarget::where() const {
  const std::string name(item_class.type->name);
  if (visualization) return "V" + name;
  const std::string& own = name_in(*item_class.type, record);
  return own.empty() ? name : name + " " + in_quotes(own);
}

void CallTarget::assign(std::size_t position, PyObject* value) const {
  const Row* row = arguments()[position].row;
  const auto label = [this] { return where(); };
  if (row == nullptr) {
    set_visualization(item_class, value, record, label);
  } else {
    set_member(item_class, *row, value, record, label);
  }
}

const ItemClass::Argument* find_interned(const std::vector<ItemClass::Argument>& arguments, PyObject* name) {
  for (const auto& argument : arguments)
    if (argument.name == name) return &argument;
  return nullptr;
}

namespace {

std::size_t find_argument(const CallTarget& target, PyObject* name) {
  const auto& arguments = target.arguments();
  if (const auto* found = find_interned(arguments, name)) return static_cast<std::size_t>(found - arguments.data());
  if (!target.visualization)
    if (const auto* entry = find_interned(target.item_class.entries, name); entry != nullptr && entry->row != nullptr)
      for (std::size_t i = 0; i < arguments.size(); ++i)
        if (arguments[i].row == entry->row) return i;
  const std::string word = to_string(name);
  const ItemType& type = *target.item_class.type;
  const Row* row = target.visualization ? find_visualization_row(type, word) : find_row(type, word);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (row != nullptr && arguments[i].row == row && (target.visualization || row->role != Role::visualization))
      return i;
    if (row == nullptr && to_string(arguments[i].name) == word) return i;
  }
  std::vector<std::string> names;
  for (const auto& argument : arguments) {
    names.push_back(to_string(argument.name));
    if (argument.row != nullptr) names.insert(names.end(), argument.row->aliases.begin(), argument.row->aliases.end());
  }
  refuse(ErrorKind::type, {target.where(), "", "there is no parameter " + in_quotes(word), "", "",
                           suggest_parameter(type, word, {names.begin(), names.end()})});
}

}  // namespace

void assign_arguments(const CallTarget& target, PyObject* const* values, std::size_t positional, PyObject* keywords) {
  const std::size_t most = target.arguments().size();
  if (positional > most) {
    refuse(ErrorKind::type, {target.where(), "", "", std::to_string(positional) + " positional arguments",
                             "at most " + std::to_string(most),
                             "Name the parameters: " + std::string(target.item_class.type->name) + "(" +
                                 to_string(target.arguments()[0].name) + "=...)"});
  }
  for (std::size_t i = 0; i < positional; ++i) target.assign(i, values[i]);
  std::bitset<64> by_name;  // more than the arguments of any item
  const Py_ssize_t named = keywords == nullptr ? 0 : PyTuple_GET_SIZE(keywords);
  for (Py_ssize_t k = 0; k < named; ++k) {
    const auto take = [&](std::size_t i) {
      if (i < positional)
        refuse(ErrorKind::type,
               {target.where(), to_string(target.arguments()[i].name), "given by position and by name", "", "", ""});
      if (by_name.test(i))
        refuse(ErrorKind::type,
               {target.where(), to_string(target.arguments()[i].name), "given twice, by two of its names", "", "", ""});
      by_name.set(i);
    };
    PyObject* const name = PyTuple_GET_ITEM(keywords, k);
    PyObject* const value = values[positional + static_cast<std::size_t>(k)];
    if (const auto* transformation = target.visualization ? nullptr : find_transformation(target.item_class, name)) {
      if (value == Py_None) continue;
      for (std::size_t i = 0; i < target.arguments().size(); ++i)
        if (const Row* row = target.arguments()[i].row;
            row != nullptr && (row == transformation->position || row == transformation->rotation))
          take(i);
      set_transformation(target.item_class, *transformation, value, target.record, [&] { return target.where(); });
      continue;
    }
    const std::size_t i = find_argument(target, name);
    take(i);
    target.assign(i, value);
  }
}

void assign_init_arguments(const CallTarget& target, PyObject* args, PyObject* kwargs) {
  std::vector<PyObject*> values;
  for (Py_ssize_t i = 0; i < PyTuple_GET_SIZE(args); ++i) values.push_back(PyTuple_GET_ITEM(args, i));
  py::object names;
  if (kwargs != nullptr) {
    names = py::reinterpret_steal<py::object>(PySequence_Tuple(kwargs));
    for (Py_ssize_t k = 0; k < PyTuple_GET_SIZE(names.ptr()); ++k)
      values.push_back(PyDict_GetItem(kwargs, PyTuple_GET_ITEM(names.ptr(), k)));
  }
  assign_arguments(target, values.data(), static_cast<std::size_t>(PyTuple_GET_SIZE(args)), names.ptr());
}

}  // namespace dalembert
