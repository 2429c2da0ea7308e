// Items as dictionaries, and the assignment of single members with complete error texts.
#include <array>

#include "conversion.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/model/value_checks.hpp"
#include "item_classes.hpp"
#include "item_docs.hpp"
#include "item_equality.hpp"
#include "item_packages.hpp"
#include "python_errors.hpp"

namespace dalembert {
namespace {

// Placeholder for graphics that GetObject omits unless requested; as an input it means 'unchanged'.
constexpr const char* not_requested = "<not requested>";

bool is_graphics(const Row& row) {
  return row.storage == Storage::opaque && (row.name == "graphicsData" || row.name == "graphicsDataList");
}

bool stands_for_graphics(const Row& row, PyObject* value) {
  if (row.storage != Storage::opaque || !PyList_Check(value) || PyList_GET_SIZE(value) != 1) return false;
  PyObject* entry = PyList_GET_ITEM(value, 0);
  PyObject* text = PyDict_Check(entry) ? PyDict_GetItemString(entry, "graphicsData") : nullptr;
  return text != nullptr && PyUnicode_Check(text) && PyUnicode_CompareWithASCIIString(text, not_requested) == 0;
}

// Some defaults do not pass the check of their own parameter (a number of coordinates of 0: not set yet). They must
// survive dictionaries and pickles; Assemble() is where they are refused.
bool is_default(const ItemClass& item_class, const Row& row, PyObject* value) {
  if (row.check == Check::none) return false;
  Row unchecked = row;
  unchecked.check = Check::none;
  const auto equals_default = [&]<class T>(T given) {
    from_python(value, unchecked, &given);
    const T& standard = *static_cast<const T*>(member(item_class.defaults.get(), row));
    if constexpr (is_vec<T>)
      return given.x == standard.x;
    else
      return given == standard;
  };
  try {
    switch (row.storage) {
      case Storage::integer: return equals_default(0);
      case Storage::real: return equals_default(0.0);
      case Storage::vector3: return equals_default(Vec3<double>{});
      default: return false;
    }
  } catch (const Refusal&) {
    return false;
  }
}

bool is_at_default(const VisualizationObject& drawn, std::string_view name) {
  const Row* row = find_visualization_row(*drawn.item_class->type, name);
  return row != nullptr && equal_members(*row, drawn.record.get(), drawn.item_class->defaults.get());
}

void warn(const std::string& message) {
  if (PyErr_WarnEx(PyExc_UserWarning, message.c_str(), 1) != 0) throw py::error_already_set();
}

void warn_if_doubtful(const Row& row, const void* record, PyObject* value, const std::string& name,
                      const Label& where) {
  const Verdict verdict = judge(row, member(record, row));
  if (verdict.fit != Fit::doubtful) return;
  warn(Complaint{where.text(), name, "", show(value), demand(row.check), verdict.problem + " " + advice(row.check)}
           .text() +
       " The value is used as it is.");
}

// 'nodeType' and its like, interned.
PyObject* type_key_name(ItemKind kind) {
  static const auto names = [] {
    std::array<PyObject*, item_kinds> made{};
    for (std::size_t k = 0; k < made.size(); ++k)
      made[k] = PyUnicode_InternFromString(std::string(type_key(static_cast<ItemKind>(k))).c_str());
    return made;
  }();
  return names[static_cast<std::size_t>(kind)];
}

// Converts a row to its dictionary entry.
py::object entry_of(const Row& row, const void* record, const std::string& name, bool graphics) {
  if (row.role == Role::name) return py::str(name);
  if (!graphics && is_graphics(row)) {
    py::dict placeholder;
    placeholder["graphicsData"] = not_requested;
    py::list list;
    list.append(placeholder);
    return list;
  }
  py::object value = py::reinterpret_steal<py::object>(to_python(row, member(record, row), Form::copy, nullptr));
  if (row.role == Role::visualization && row.storage >= Storage::vector2 && row.storage <= Storage::vector9)
    return value.attr("tolist")();
  return value;
}

void copy_default(const ItemClass& item_class, const Row& row, void* record) {
  with_type(row.storage, [&]<class T>(TypeTag<T>) {
    *static_cast<T*>(member(record, row)) = *static_cast<const T*>(member(item_class.defaults.get(), row));
  });
}

}  // namespace

void set_member(const ItemClass& item_class, const Row& row, PyObject* value, void* record, const Label& where) {
  const auto name = [&] { return (row.role == Role::visualization ? "V" : "") + std::string(row.name); };
  try {
    from_python(value, row, member(record, row));
  } catch (const Refusal& refusal) {
    if (refusal.kind == ErrorKind::value && is_default(item_class, row, value)) {
      copy_default(item_class, row, record);
      return;
    }
    std::string expected = refusal.expected;
    if (has_unit(row)) expected += " (unit " + std::string(row.unit) + ")";
    refuse(refusal.kind, {where.text(), name(), "", show(value), expected, refusal.advice});
  }
  if (row.check == Check::orthogonal) warn_if_doubtful(row, record, value, name(), where);
}

const ItemClass::Transformation* find_transformation(const ItemClass& item_class, PyObject* name) {
  for (const auto& each : item_class.transformations)
    if (each.name == name || (PyUnicode_Check(name) && PyUnicode_Compare(each.name, name) == 0)) return &each;
  return nullptr;
}

namespace {
py::module_ transformation_module() { return py::module_::import("dalembert._geometry.rigid_transformation"); }
bool is_list(const ItemClass::Transformation& transformation) {
  return transformation.rotation->storage == Storage::matrix3s;
}
}  // namespace

void set_transformation(const ItemClass& item_class, const ItemClass::Transformation& transformation, PyObject* value,
                        void* record, const Label& where) {
  if (value == Py_None) return;
  const std::string name = where.text() + ": " + to_string(transformation.name);
  const py::tuple parts = transformation_module().attr("parts")(name, py::handle(value), is_list(transformation),
                                                                transformation.position != nullptr);
  if (transformation.position != nullptr)
    set_member(item_class, *transformation.position, parts[0].ptr(), record, where);
  set_member(item_class, *transformation.rotation, parts[1].ptr(), record, where);
}

py::object get_transformation(const ItemClass::Transformation& transformation, const void* record) {
  const auto read = [&](const Row* row) -> py::object {
    if (row == nullptr) return py::none();
    return py::reinterpret_steal<py::object>(to_python(*row, member(record, *row), Form::copy, nullptr));
  };
  return transformation_module().attr("of_parts")(read(transformation.position), read(transformation.rotation),
                                                  is_list(transformation));
}

void set_visualization(const ItemClass& item_class, PyObject* value, void* record, const Label& where) {
  const ItemType& type = *item_class.type;
  const VisualizationObject* other = as_visualization(value);
  if (other != nullptr && other->item_class == &item_class) {
    for (const auto& argument : item_class.visualization_arguments) {
      with_type(argument.row->storage, [&]<class T>(TypeTag<T>) {
        *static_cast<T*>(member(record, *argument.row)) =
            *static_cast<const T*>(member(other->record.get(), *argument.row));
      });
    }
    return;
  }
  const auto complain = [&](const std::string& problem, const std::string& advice) {
    refuse(ErrorKind::type, {where.text(), "visualization", problem, show(value),
                             "V" + std::string(type.name) + "(...) or a dictionary", advice});
  };
  py::dict entries;
  if (PyDict_Check(value)) {
    entries = py::reinterpret_borrow<py::dict>(value);
  } else {
    PyObject* made = PyObject_CallOneArg(reinterpret_cast<PyObject*>(&PyDict_Type), value);
    if (made == nullptr) {
      PyErr_Clear();
      complain("", "");
    }
    entries = py::reinterpret_steal<py::dict>(made);
  }
  for (const auto& [key, entry] : entries) {
    if (const auto* argument = find_interned(item_class.visualization_arguments, key.ptr())) {
      set_member(item_class, *argument->row, entry.ptr(), record, where);
      continue;
    }
    const std::string word = PyUnicode_Check(key.ptr()) ? to_string(key.ptr()) : show(key.ptr());
    const Row* row = find_visualization_row(type, word);
    if (row == nullptr) {
      // dictionary of another item: only common parameters are used
      if (other != nullptr && is_at_default(*other, word)) continue;
      std::vector<std::string_view> names;
      for (const auto& argument : item_class.visualization_arguments) names.push_back(argument.row->name);
      complain("there is no visualization parameter " + in_quotes(word), suggestion(word, names));
    }
    set_member(item_class, *row, entry.ptr(), record, where);
  }
}

py::dict item_dictionary(const ItemType& type, const void* record, const std::string& name, bool graphics) {
  py::dict result;
  result[py::handle(type_key_name(type.kind))] = py::str(std::string(type.type_name));
  const Row* written = nullptr;
  for (const auto& [row, key] : class_of(type).entries) {
    const bool alias = row == written;
    written = row;
    if (row != nullptr && !row->internal && !alias) result[py::handle(key)] = entry_of(*row, record, name, graphics);
  }
  return result;
}

namespace {

// Why an entry that occurs in models of old releases has no effect; empty for others.
std::string obsolete(const ItemClass& item_class, const std::string& word) {
  if (item_class.type->kind == ItemKind::marker && word == "bodyFixed") return " has no effect on markers";
  const std::string drawn = "V" + word;
  for (const auto& entry : item_class.entries)
    if (to_string(entry.name) == drawn) return " has no effect, " + drawn + " has";
  return {};
}

// The entry of a key that is not interned; nullptr: there is nothing to set.
const ItemClass::Argument* find_spelt(const ItemClass& item_class, PyObject* key, const Label& where) {
  const ItemType& type = *item_class.type;
  const std::string word = PyUnicode_Check(key) ? to_string(key) : show(key);
  if (word == type_key(type.kind)) return nullptr;
  for (const auto& entry : item_class.entries)
    if (to_string(entry.name) == word) return &entry;
  if (const std::string reason = obsolete(item_class, word); !reason.empty()) {
    warn(Complaint{where.text(), "", in_quotes(word) + reason, "", "", ""}.text() + " The entry is ignored.");
    return nullptr;
  }
  refuse(ErrorKind::value,
         {where.text(), "", "there is no parameter " + in_quotes(word), "", "", suggest_parameter(type, word)});
}

}  // namespace

void update_from_dictionary(const ItemClass& item_class, const py::dict& dictionary, void* record, const Label& where) {
  PyObject* const type_name = type_key_name(item_class.type->kind);
  for (const auto& [key, value] : dictionary) {
    if (key.ptr() == type_name) continue;
    const auto* entry = find_interned(item_class.entries, key.ptr());
    if (entry == nullptr) {
      if (const auto* transformation = find_transformation(item_class, key.ptr())) {
        set_transformation(item_class, *transformation, value.ptr(), record, where);
        continue;
      }
      entry = find_spelt(item_class, key.ptr(), where);
    }
    if (entry == nullptr) continue;
    if (entry->row == nullptr) {
      set_visualization(item_class, value.ptr(), record, where);
    } else if (!entry->row->internal && !stands_for_graphics(*entry->row, value.ptr())) {
      set_member(item_class, *entry->row, value.ptr(), record, where);
    }
  }
}

namespace {

// The class that a dictionary names.
const ItemClass& class_in(ItemKind kind, const py::dict& dictionary, const Label& where) {
  PyObject* name = PyDict_GetItemWithError(dictionary.ptr(), type_key_name(kind));
  if (name != nullptr)
    if (const ItemClass* found = find_class(kind, name)) return *found;
  const std::string key(type_key(kind));
  if (name == nullptr) {
    refuse(ErrorKind::value, {where.text(), "", "the dictionary has no key " + in_quotes(key), show(dictionary.ptr()),
                              "a dictionary of " + with_article(kind_name(kind)),
                              "Name the type, e.g. {" + in_quotes(key) + ": " +
                                  in_quotes(find_type(kind, "Point") != nullptr ? "Point" : "...") + ", ...}"});
  }
  if (!PyUnicode_Check(name))
    refuse(ErrorKind::type, {where.text(), key, "", show(name), "the name of a type as a string", ""});
  return class_of(require_type_of_any_package(kind, to_string(name), where.text()));
}

}  // namespace

Item item_from_dictionary(ItemKind kind, const py::dict& dictionary, const Label& where) {
  const ItemClass& item_class = class_in(kind, dictionary, where);
  const ItemType& type = *item_class.type;
  std::shared_ptr<void> record = type.record.create();
  update_from_dictionary(item_class, dictionary, record.get(),
                         [&] { return where.text() + ": " + std::string(type.name); });
  return {&type, std::move(record)};
}

}  // namespace dalembert
