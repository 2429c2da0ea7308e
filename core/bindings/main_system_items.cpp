// The methods of MainSystem that add, read and change items, for all five kinds.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "conversion.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/model/references.hpp"
#include "index_types.hpp"
#include "item_arguments.hpp"
#include "item_packages.hpp"
#include "main_system.hpp"
#include "main_system_attributes.hpp"
#include "python_callback.hpp"
#include "python_errors.hpp"
#include "sequence.hpp"
#include "symbolic.hpp"

namespace dalembert {

int item_number_argument(const MainSystem& main, ItemKind kind, PyObject* value, const Label& method) {
  ItemKind given{};
  int number = -1;
  const auto complain = [&](const std::string& advice) {
    refuse(ErrorKind::type, {"mbs." + method.text() + "(...)", std::string(kind_name(kind)) + "Number", "", show(value),
                             with_article(index_name(kind)) + ", an integer or a name", advice});
  };
  if (read_index(value, given, number)) {
    if (given != kind) {
      complain("It is " + with_article(index_name(given)) + ": it counts " + std::string(kind_name(given)) + "s, not " +
               std::string(kind_name(kind)) + "s.");
    }
  } else if (PyUnicode_Check(value)) {
    return number_of(main.model, kind, to_string(value), "mbs." + method.text() + "(...)",
                     std::string(kind_name(kind)) + "Number");
  } else {
    try {
      number = read_integer(value);
    } catch (const Refusal&) {
      complain("Pass what Add" + std::string(kind_title(kind)) + "(...) returned.");
    }
  }
  if (main.model.find_item(kind, number) != nullptr) return number;
  try {
    main.model.item(kind, number);
  } catch (const ModelError& error) {
    throw ModelError(error.kind(), "mbs." + method.text() + "(...): " + error.what());
  }
  return number;
}

ConfigurationType configuration_argument(const py::object& value, const Label& where) {
  static const Enumeration configurations("ConfigurationType");
  const bool is_member = configurations.has(value.ptr());
  if (is_member) {
    const auto configuration = static_cast<ConfigurationType>(Enumeration::number(value.ptr()));
    if (configuration != ConfigurationType::_None && configuration != ConfigurationType::EndOfEnumList)
      return configuration;
  }
  refuse(is_member ? ErrorKind::value : ErrorKind::type,
         {.item = where.text(),
          .parameter = "configuration",
          .received = show(value.ptr()),
          .expected = "ConfigurationType.Current, Initial, Reference, StartOfStep or Visualization"});
}

namespace {

using Class = py::class_<MainSystem, std::shared_ptr<MainSystem>>;

std::string method_name(const char* verb, ItemKind kind, const char* rest = "") {
  return verb + std::string(kind_title(kind)) + rest;
}

// ---- adding: the one path that must be quick -----------------------------------------------------------------------

[[noreturn]] void refuse_item(ItemKind kind, PyObject* value, const std::string& advice) {
  refuse(ErrorKind::type, {"mbs." + method_name("Add", kind) + "(...)", "", "", show(value),
                           with_article(kind_name(kind)) + " item or its dictionary", advice});
}

Item other_item(ItemKind kind, PyObject* value) {
  const auto where = [&] { return "mbs." + method_name("Add", kind) + "(...)"; };
  if (PyDict_Check(value)) return item_from_dictionary(kind, py::reinterpret_borrow<py::dict>(value), where);
  if (PyType_Check(value)) refuse_item(kind, value, "Put parentheses behind the class to make an item of it.");
  // Everything that dict() accepts is allowed.
  PyObject* dictionary = PyObject_CallOneArg(reinterpret_cast<PyObject*>(&PyDict_Type), value);
  if (dictionary == nullptr) {
    PyErr_Clear();
    refuse_item(kind, value, "Items are made by their classes, e.g. NodePoint(...) or ObjectMassPoint(...).");
  }
  return item_from_dictionary(kind, py::reinterpret_steal<py::dict>(dictionary), where);
}

Item item_argument(ItemKind kind, PyObject* value) {
  if (PyDict_CheckExact(value)) return other_item(kind, value);
  ItemObject* object = as_item(value);
  if (object == nullptr) return other_item(kind, value);
  const ItemType& type = *object->item_class->type;
  if (type.kind != kind) {
    refuse_item(kind, value,
                std::string(type.name) + " is " + with_article(kind_name(type.kind)) + "; use mbs." +
                    method_name("Add", type.kind) + "(...).");
  }
  return take_item(object);
}

// The object must be a system.
MainSystem* system_of(PyObject* self) {
  auto* main = reinterpret_cast<py::detail::instance*>(self)->get_value_and_holder().value_ptr<MainSystem>();
  if (main == nullptr) refuse(ErrorKind::state, {"mbs", "", "MainSystem.__init__ was not called", "", "", ""});
  return main;
}

// A plain method descriptor: argument parsing of pybind11 would take longer than the rest of the call.
template <ItemKind K>
PyObject* add_item(PyObject* self, PyObject* value) {
  return guarded([&] {
    MainSystem* main = system_of(self);
    Item item = item_argument(K, value);
    static const ItemType* last = nullptr;
    static bool has_functions = false;  // the last type that was added
    if (item.type != last) {
      has_functions =
          std::ranges::any_of(item.type->rows, [](const Row& row) { return row.storage == Storage::user_function; });
      last = item.type;
    }
    if (has_functions) item.record = bind_user_functions(*item.type, std::move(item.record), *main);
    return make_index(K,
                      main->restructure([] { return "mbs." + method_name("Add", K) + "(...)"; }).add(std::move(item)));
  });
}

template <ItemKind K>
void register_add(Class& main_system) {
  static const std::string name = method_name("Add", K);
  static const std::string doc = name + "($self, pyObject, /)\n--\n\nAdd " + with_article(kind_name(K)) +
                                 ", given as item or dictionary, and return its " + std::string(index_name(K)) + ".";
  static PyMethodDef definition{name.c_str(), add_item<K>, METH_O, doc.c_str()};
  PyObject* descriptor = PyDescr_NewMethod(reinterpret_cast<PyTypeObject*>(main_system.ptr()), &definition);
  if (descriptor == nullptr) throw py::error_already_set();
  main_system.attr(name.c_str()) = py::reinterpret_steal<py::object>(descriptor);
}

// ---- reading ---------------------------------------------------------------------------------------------------------

py::dict get_item(const MainSystem& main, ItemKind kind, int number, bool graphics) {
  const Item& item = main.model.item(kind, number);
  return item_dictionary(*item.type, item.record.get(), main.model.name(kind, number), graphics);
}

const Row& require_row(const MainSystem& main, ItemKind kind, int number, std::string_view name) {
  const ItemType& type = *main.model.item(kind, number).type;
  const Row* row = find_row(type, name);
  if (row == nullptr) {
    const std::string constant = own_constant(main.model, kind, number, name);
    refuse(ErrorKind::value,
           {main.model.describe(kind, number), "", "there is no parameter " + in_quotes(name), "", "",
            constant.empty() ? suggest_parameter(type, name) : "Did you mean " + in_quotes(constant) + "?"});
  }
  return *row;
}

// A rigid transformation of that name, for Get...Parameter and Set...Parameter; nullptr: there is none.
const ItemClass::Transformation* transformation_of(const MainSystem& main, ItemKind kind, int number,
                                                   std::string_view name) {
  const ItemClass& item_class = class_of(*main.model.item(kind, number).type);
  if (item_class.transformations.empty()) return nullptr;
  return find_transformation(item_class, py::str(std::string(name)).ptr());
}

py::object get_parameter(const MainSystem& main, ItemKind kind, int number, const std::string& name) {
  if (const auto* transformation = transformation_of(main, kind, number, name))
    return get_transformation(*transformation, main.model.item(kind, number).record.get());
  if (const auto constants = constants_named(main.model, kind, number, name); !constants.empty())
    return py::float_(constant_of(*constants[0].function, constants[0].name));
  const Row& row = require_row(main, kind, number, name);
  if (row.role == Role::name) return py::str(main.model.name(kind, number));
  const Item& item = main.model.item(kind, number);
  py::object value =
      py::reinterpret_steal<py::object>(to_python(row, member(item.record.get(), row), Form::copy, nullptr));
  if (row.role == Role::visualization && row.storage == Storage::vector4) return value.attr("tolist")();
  return value;
}

// ---- changing --------------------------------------------------------------------------------------------------------

// An assembled system uses changed values at once: user functions change parameters between two steps. Changes during
// an evaluation are used in the next one.
void take_over(MainSystem& main) {
  if (main.consistent()) main.assembled("SetParameter");
}

void set_parameter(MainSystem& main, ItemKind kind, int number, std::string_view name, PyObject* value) {
  if (const auto* transformation = transformation_of(main, kind, number, name)) {
    const Item& item = main.model.item(kind, number);
    const std::shared_ptr<void> changed = item.type->record.copy(item.record.get());
    set_transformation(class_of(*item.type), *transformation, value, changed.get(),
                       [&] { return main.model.describe(kind, number); });
    for (const Row* part : {transformation->position, transformation->rotation})
      if (part != nullptr) {
        const py::object given =
            py::reinterpret_steal<py::object>(to_python(*part, member(changed.get(), *part), Form::copy, nullptr));
        set_parameter(main, kind, number, part->name, given.ptr());
      }
    return;
  }
  if (const auto constants = constants_named(main.model, kind, number, name); !constants.empty()) {
    double given = 0;
    try {
      given = read_real(value);
    } catch (const Refusal& refusal) {
      refuse(refusal.kind,
             {main.model.describe(kind, number), std::string(name), "", show(value), "a finite number", ""});
    }
    for (const RecordedConstant& constant : constants)
      set_parameter(main, kind, number, constant.row.name,
                    with_constant(*constant.function, constant.name, given).ptr());
    return;
  }
  const Row& row = require_row(main, kind, number, name);
  if (const std::string constant = own_constant(main.model, kind, number, name); !constant.empty())
    refuse(ErrorKind::value, {main.model.describe(kind, number), std::string(name),
                              "the law has a constant of this name, and does not read the parameter", "", "",
                              "Use " + in_quotes(constant) + "."});
  const Item& item = main.model.item(kind, number);
  const auto where = [&] { return main.model.describe(kind, number); };
  if (row.internal)
    refuse(ErrorKind::value, {where(), std::string(name), "cannot be set", "", "", "It is computed by the system."});
  const ItemType& type = *item.type;
  const std::shared_ptr<const void> before = item.record;
  const auto write = [&](void* target) {
    // `target` is the member; the record begins at its offset before.
    set_member(class_of(type), row, value, static_cast<char*>(target) - row.offset, where);
    if (row.storage == Storage::user_function) {
      auto& function = *static_cast<UserFunction*>(target);
      function = bind_user_function(type, function, main);
    }
  };
  main.edit(kind, number, row, std::ref(write));
  try {
    take_over(main);
  } catch (...) {  // it does not fit nodes and markers
    main.edit(kind, number, row, [&](void* target) {
      visit(row, before.get(), [&]<class T>(const T& old) { *static_cast<T*>(target) = old; });
    });
    take_over(main);
    throw;
  }
}

void modify_item(MainSystem& main, ItemKind kind, int number, const py::dict& changes) {
  const Item& old = main.model.item(kind, number);
  const ItemType& type = *old.type;
  const std::string where = main.model.describe(kind, number), key(type_key(kind));
  if (changes.contains(key.c_str())) {
    const ItemType& given = require_type(kind, py::str(changes[key.c_str()]).cast<std::string>(), where);
    if (&given != &type) {
      refuse(ErrorKind::value, {where, key, "", in_quotes(given.type_name), in_quotes(type.type_name),
                                "The type of an item cannot change; delete the item and add another one."});
    }
  }
  std::shared_ptr<void> record = type.record.copy(old.record.get());
  update_from_dictionary(class_of(type), changes, record.get(), where);
  main.restructure([&] { return "mbs." + method_name("Modify", kind) + "(...)"; })
      .replace(kind, number, {&type, bind_user_functions(type, std::move(record), main)});
}

void delete_item(MainSystem& main, ItemKind kind, int number, bool with_dependents, bool quiet) {
  const std::string call = "mbs." + method_name("Delete", kind) + "(...)";
  for (const std::string& lost : main.restructure(call).remove(kind, number, with_dependents)) {
    const std::string text = call + ": " + lost + ".";
    if (!quiet && PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 1) != 0) throw py::error_already_set();
  }
}

void register_delete(Class& main_system, ItemKind kind) {
  const std::string name = method_name("Delete", kind);
  const std::string number = std::string(kind_name(kind)) + "Number";
  const std::string doc = "Delete " + with_article(kind_name(kind)) + "; the numbers behind it move up by one.";
  const bool dependents = kind == ItemKind::object || kind == ItemKind::load;
  if (!dependents) {
    main_system.def(
        name.c_str(),
        [kind, name](MainSystem& main, const py::object& index, bool quiet) {
          delete_item(main, kind, item_number_argument(main, kind, index.ptr(), name), false, quiet);
        },
        py::arg(number.c_str()), py::arg("suppressWarnings") = false, doc.c_str());
    return;
  }
  main_system.def(
      name.c_str(),
      [kind, name](MainSystem& main, const py::object& index, bool along, bool quiet) {
        delete_item(main, kind, item_number_argument(main, kind, index.ptr(), name), along, quiet);
      },
      py::arg(number.c_str()),
      py::arg(kind == ItemKind::object ? "deleteDependentItems" : "deleteDependentMarkers") = true,
      py::arg("suppressWarnings") = false, doc.c_str());
}

void register_reading(Class& main_system, ItemKind kind) {
  const std::string noun(kind_name(kind)), title(kind_title(kind)), number = noun + "Number", get = "Get" + title;
  main_system.def((get + "Number").c_str(),
                  [kind](const MainSystem& main, const std::string& name) {
                    return py::reinterpret_steal<py::object>(make_index(kind, main.model.number(kind, name)));
                  },
                  py::arg((noun + "Name").c_str()),
                  ("The index of the " + noun + " with that name; invalid if there is none.").c_str());
  if (kind == ItemKind::object) {
    main_system.def(
        get.c_str(),
        [kind, get](const MainSystem& main, const py::object& index, bool graphics) {
          return get_item(main, kind, item_number_argument(main, kind, index.ptr(), get), graphics);
        },
        py::arg(number.c_str()), py::arg("addGraphicsData") = false, "All parameters as a dictionary.");
  } else {
    main_system.def(
        get.c_str(),
        [kind, get](const MainSystem& main, const py::object& index) {
          return get_item(main, kind, item_number_argument(main, kind, index.ptr(), get), true);
        },
        py::arg(number.c_str()), "All parameters as a dictionary.");
  }
  main_system.def((get + "Defaults").c_str(),
                  [kind](const MainSystem&, const std::string& name) {
                    const ItemType& type = require_type_of_any_package(
                        kind, name, "mbs." + method_name("Get", kind, "Defaults") + "(...)");
                    return item_dictionary(type, class_of(type).defaults.get(), "", true);
                  },
                  py::arg("typeName"), ("The default parameters of a type of " + noun + " as a dictionary.").c_str());
  main_system.def(
      (get + "Parameter").c_str(),
      [kind, method = get + "Parameter"](const MainSystem& main, const py::object& index, const std::string& name) {
        return get_parameter(main, kind, item_number_argument(main, kind, index.ptr(), method), name);
      },
      py::arg(number.c_str()), py::arg("parameterName"),
      ("A parameter of the " + noun + ", which is given by its index or name; visualization parameters begin with 'V'.")
          .c_str());
}

// Set...Parameter(number, name, value), which user functions call at each step: pybind11 takes a quarter of its time to find
// arguments. Other calls, such as those with keywords, are passed to the function made by pybind11, which also raises the errors.
std::array<PyObject*, item_kinds> general_setters{};

template <ItemKind K>
PyObject* quick_set(PyObject* self, PyObject* const* arguments, Py_ssize_t count, PyObject* names) {
  static const std::string method = method_name("Set", K, "Parameter");
  if (count != 3 || names != nullptr || PyUnicode_CheckExact(arguments[1]) == 0) [[unlikely]] {
    const Py_ssize_t all = count + (names == nullptr ? 0 : PyTuple_GET_SIZE(names));
    std::vector<PyObject*> passed{self};
    passed.insert(passed.end(), arguments, arguments + all);
    return PyObject_Vectorcall(general_setters[static_cast<std::size_t>(K)], passed.data(),
                               static_cast<std::size_t>(count + 1), names);
  }
  return guarded([&] {
    MainSystem* main = system_of(self);
    Py_ssize_t length = 0;
    const char* name = PyUnicode_AsUTF8AndSize(arguments[1], &length);
    if (name == nullptr) throw py::error_already_set();
    set_parameter(*main, K, item_number_argument(*main, K, arguments[0], method),
                  {name, static_cast<std::size_t>(length)}, arguments[2]);
    return Py_NewRef(Py_None);
  });
}

template <ItemKind K>
void register_quick_set(Class& main_system) {
  static const std::string name = method_name("Set", K, "Parameter");
  const py::object general = main_system.attr(name.c_str());
  main_system.attr(("_" + name).c_str()) = general;  // where explain_wrong_calls() finds it
  general_setters[static_cast<std::size_t>(K)] = Py_NewRef(general.ptr());
  static const std::string doc =
      name + "($self, " + std::string(kind_name(K)) + "Number, parameterName, value)\n--\n\nSet a parameter of the " +
      std::string(kind_name(K)) + ", which is given by its index or name; visualization parameters begin with 'V'.";
  static PyMethodDef definition{name.c_str(), reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(quick_set<K>)),
                                METH_FASTCALL | METH_KEYWORDS, doc.c_str()};
  PyObject* descriptor = PyDescr_NewMethod(reinterpret_cast<PyTypeObject*>(main_system.ptr()), &definition);
  if (descriptor == nullptr) throw py::error_already_set();
  main_system.attr(name.c_str()) = py::reinterpret_steal<py::object>(descriptor);
}

void register_writing(Class& main_system, ItemKind kind) {
  const std::string noun(kind_name(kind)), title(kind_title(kind)), number = noun + "Number";
  const std::string set = "Set" + title + "Parameter", modify = "Modify" + title;
  main_system.def(
      set.c_str(),
      [kind, set](MainSystem& main, const py::object& index, const std::string& name, const py::object& value) {
        set_parameter(main, kind, item_number_argument(main, kind, index.ptr(), set), name, value.ptr());
      },
      py::arg(number.c_str()), py::arg("parameterName"), py::arg("value"),
      ("Set a parameter of the " + noun +
       ", which is given by its index or name; visualization parameters begin with 'V'.")
          .c_str());
  main_system.def(
      modify.c_str(),
      [kind, modify](MainSystem& main, const py::object& index, const py::dict& changes) {
        modify_item(main, kind, item_number_argument(main, kind, index.ptr(), modify), changes);
      },
      py::arg(number.c_str()), py::arg((noun + "Dict").c_str()),
      "Set the parameters that the dictionary names; the others stay.");
}

// _item_counts(mbs): numbers of items, from which a function with several steps can undo its additions.
PyObject* item_counts(PyObject* system_class, PyObject* self) {
  return guarded([&]() -> PyObject* {
    if (!PyObject_TypeCheck(self, reinterpret_cast<PyTypeObject*>(system_class)))
      return PyErr_Format(PyExc_TypeError, "_item_counts(mbs) takes a MainSystem");
    const MainSystem& main = *system_of(self);
    std::array<int, item_kinds> counts{};
    for (int k = 0; k < item_kinds; ++k)
      counts[static_cast<std::size_t>(k)] = main.model.count(static_cast<ItemKind>(k));
    return PyBytes_FromStringAndSize(reinterpret_cast<const char*>(counts.data()),
                                     sizeof(counts));  // quicker than five integers
  });
}

py::dict factory_items() {
  py::dict result;
  for (int k = 0; k < item_kinds; ++k) {
    py::list names;
    for (const ItemType* type : item_types())
      if (type->kind == static_cast<ItemKind>(k)) names.append(std::string(type->name));
    names.attr("sort")();
    result[std::string(kind_title(static_cast<ItemKind>(k))).c_str()] = names;
  }
  return result;
}

}  // namespace

void register_main_system_items(py::module_& module, Class& main_system) {
  register_add<ItemKind::node>(main_system);
  register_add<ItemKind::object>(main_system);
  register_add<ItemKind::marker>(main_system);
  register_add<ItemKind::load>(main_system);
  register_add<ItemKind::sensor>(main_system);
  register_main_system_attributes(module, main_system,
                                  {add_item<ItemKind::node>, add_item<ItemKind::object>, add_item<ItemKind::marker>,
                                   add_item<ItemKind::load>, add_item<ItemKind::sensor>});
  for (int k = 0; k < item_kinds; ++k) {
    const ItemKind kind = static_cast<ItemKind>(k);
    register_reading(main_system, kind);
    register_writing(main_system, kind);
    register_delete(main_system, kind);
  }
  register_quick_set<ItemKind::node>(main_system);
  register_quick_set<ItemKind::object>(main_system);
  register_quick_set<ItemKind::marker>(main_system);
  register_quick_set<ItemKind::load>(main_system);
  register_quick_set<ItemKind::sensor>(main_system);
  static PyMethodDef counts{"_item_counts", item_counts, METH_O,
                            "_item_counts(mbs, /)\n--\n\nThe numbers of nodes, objects, markers, loads and sensors, as "
                            "the bytes of integers of C."};
  module.add_object("_item_counts", py::reinterpret_steal<py::object>(PyCFunction_New(&counts, main_system.ptr())));
  main_system.def(
      "GetAvailableFactoryItems", [](const MainSystem&) { return factory_items(); },
      "The names of all item types, by kind.");
}

}  // namespace dalembert
