// Conversion of settings: to and from Python, as dictionaries and as text.
#include <pybind11/numpy.h>

#include <algorithm>

#include "conversion.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/reflection/settings_texts.hpp"
#include "dalembert/simulation_settings.hpp"
#include "index_types.hpp"
#include "item_docs.hpp"
#include "item_equality.hpp"
#include "python_errors.hpp"
#include "settings.hpp"

namespace dalembert {
namespace {

const char* type_word(const Row& row) {
  switch (row.storage) {
    case Storage::boolean: return "bool";
    case Storage::integer: return "int";
    case Storage::real: return "float";
    case Storage::text: return "str";
    case Storage::output_variable: return "OutputVariableType";
    case Storage::enumeration: return enum_tables()[row.enumeration].name.data();
    case Storage::user_function:
    case Storage::opaque: return "function";
    default: return "list";
  }
}

bool is_function(const Row& row) { return row.storage == Storage::opaque && row.name.ends_with("UserFunction"); }

// Arrays are lists here, as in dictionaries of settings.
template <class T>
py::object plain(const Row& row, const T& value) {
  if constexpr (is_vec<T>) {
    py::list list;
    for (const auto& entry : value.x) list.append(entry);
    return list;
  } else if constexpr (is_mat<T>) {
    constexpr int n = row_count<T>;
    py::list list;
    for (int i = 0; i < n; ++i) {
      py::list line;
      for (int j = 0; j < n; ++j) line.append(value(i, j));
      list.append(line);
    }
    return list;
  } else if constexpr (std::is_same_v<T, std::vector<double>> || std::is_same_v<T, std::vector<int>>) {
    py::list list;
    for (const auto& entry : value) list.append(entry);
    return list;
  } else if constexpr (std::is_same_v<T, std::uint32_t>) {
    return enum_member(enum_tables()[row.enumeration].name.data(), value);
  } else {
    return py::reinterpret_steal<py::object>(to_python(row, &value, Form::copy, nullptr));
  }
}

// A member, or its name as in handles: 'EigenSparse' or 'eigen_sparse'.
void write_enumeration(const Row& row, PyObject* value, std::uint32_t& out) {
  const std::string name(enum_tables()[row.enumeration].name);
  const py::object type = core_module().attr(name.c_str());
  if (PyUnicode_Check(value)) {
    const auto member = py::module_::import("dalembert._model.words").attr("member");
    out = member(type, py::handle(value), std::string(row.name)).cast<std::uint32_t>();
    return;
  }
  if (!py::isinstance(value, type)) throw Refusal{ErrorKind::type, "a member of " + name, member_advice(name, value)};
  out = py::handle(value).cast<std::uint32_t>();
}

// Settings store item numbers as integers; index types of Add functions are accepted as well.
py::object plain_number(py::handle value, ItemKind expected) {
  ItemKind kind{};
  int number = 0;
  if (read_index(value.ptr(), kind, number) && kind == expected) return py::int_(number);
  return py::reinterpret_borrow<py::object>(value);
}
py::object with_plain_numbers(PyObject* value, ItemKind expected) {
  if (!PyList_Check(value)) return py::reinterpret_borrow<py::object>(value);
  py::list plain;
  for (const py::handle entry : py::reinterpret_borrow<py::list>(value)) plain.append(plain_number(entry, expected));
  return plain;
}

// The range of the setting takes the place of the sign that its type allows.
template <class T>
T number_in_range(const Row& row, const SettingRule& rule, PyObject* value) {
  Row any = row;
  any.check = Check::none;
  T number{};
  from_python(value, any, &number);
  if (!rule.admits(number))
    throw Refusal{ErrorKind::value, (std::is_same_v<T, int> ? "an integer " : "a number ") + std::string(rule.words),
                  ""};
  return number;
}

void write_value(const SettingsView& view, const Row& row, PyObject* value) {
  const SettingRule* rule = view.group->rule_of(row.name);
  const bool ranged = rule != nullptr && !rule->words.empty();
  visit(row, view.data, [&]<class T>(T& out) {
    if constexpr (std::is_same_v<T, int> || std::is_same_v<T, double>) {
      if (ranged) {
        out = number_in_range<T>(row, *rule, value);
        return;
      }
    }
    if constexpr (std::is_same_v<T, std::uint32_t>) {
      write_enumeration(row, value, out);
    } else if constexpr (std::is_same_v<T, std::vector<int>>) {
      from_python(with_plain_numbers(value, ItemKind::sensor).ptr(), row, &out);
    } else if constexpr (std::is_same_v<T, int>) {
      from_python(row.name == "trackMarker" ? plain_number(value, ItemKind::marker).ptr() : value, row, &out);
    } else if constexpr (std::is_same_v<T, bool>) {
      const bool number = PyLong_Check(value) && !PyBool_Check(value);
      from_python(number ? py::bool_(PyObject_IsTrue(value) == 1).ptr() : value, row, &out);
    } else {
      const bool none = value == Py_None || (PyLong_Check(value) && PyObject_IsTrue(value) == 0);
      if (is_function(row) && !none && PyCallable_Check(value) == 0)
        throw Refusal{ErrorKind::type, "a function, or 0 for none", ""};
      if (is_function(row) && none)
        out = T{};
      else
        from_python(value, row, &out);
    }
  });
}

// Who sets a type of linear solver gets it.
void note_choice(const SettingsView& view, const Row& row) {
  if (view.group == &simulation_settings_group() && row.name == "linearSolverType")
    static_cast<SimulationSettings*>(view.data)->linearSolverChoice.automatic = false;
}

// Writes a dictionary into a copy, so that an error leaves the settings unchanged. Flags that record an explicit
// choice are written after the choice.
void merge(const SettingsView& view, const py::dict& values) {
  std::vector<std::pair<py::handle, py::handle>> entries(values.begin(), values.end());
  std::stable_partition(entries.begin(), entries.end(),
                        [](const auto& entry) { return !py::isinstance<py::dict>(entry.second); });
  for (const auto& [key, value] : entries) {
    if (!py::isinstance<py::str>(key))
      refuse(ErrorKind::type, {.item = view.title(),
                               .problem = "keys of a dictionary of settings must be strings",
                               .received = show(key.ptr())});
    const auto name = key.cast<std::string>();
    const SettingsField field = find_field(view, name);
    if (!field) refuse_unknown(view, name);
    if (field.row != nullptr) {
      write_setting(field.view, *field.row, value.ptr());
    } else if (field.child != nullptr || field.only_names) {
      if (!py::isinstance<py::dict>(value))
        refuse(ErrorKind::type,
               {.item = view.title(), .parameter = name, .received = show(value.ptr()), .expected = "a dictionary"});
      merge(field.only_names ? field.view : field.view.child(*field.child), py::reinterpret_borrow<py::dict>(value));
    }
  }
}

py::list size_of(const py::object& value) {
  py::list size;
  if (!py::isinstance<py::list>(value)) {
    size.append(1);
    return size;
  }
  size.append(py::len(value));
  if (py::len(value) > 0 && py::isinstance<py::list>(value[py::int_(0)])) size.append(py::len(value[py::int_(0)]));
  return size;
}

// With `defaults`, only differing values are written.
void append_text(const SettingsView& view, const SettingsView* defaults, int depth, std::string& text) {
  const std::string indent(static_cast<std::size_t>(2 * depth), ' ');
  for (const SettingsChild& child : view.group->children) {
    std::string inner;
    if (defaults != nullptr) {
      const SettingsView inner_defaults = defaults->child(child);
      append_text(view.child(child), &inner_defaults, depth + 1, inner);
    } else {
      append_text(view.child(child), nullptr, depth + 1, inner);
    }
    if (defaults == nullptr || !inner.empty()) text += indent + std::string(child.name) + ":\n" + inner;
  }
  for (const Row& row : view.group->rows) {
    const std::string value(py::str(read_setting(view, row)));
    if (defaults != nullptr && value == std::string(py::str(read_setting(*defaults, row)))) continue;
    text += indent + std::string(row.name) + " = " + value + "\n";
  }
}

const SettingsText* text_of(const SettingsGroup& group) {
  for (const SettingsText& text : settings_texts())
    if (text.name == group.name) return &text;
  return nullptr;
}

}  // namespace

py::object read_setting(const SettingsView& view, const Row& row) {
  return visit(row, static_cast<const void*>(view.data), [&](const auto& value) { return plain(row, value); });
}

void write_setting(const SettingsView& view, const Row& row, PyObject* value) {
  try {
    write_value(view, row, value);
    note_choice(view, row);
  } catch (const Refusal& refusal) {
    const std::string root(view.tree->group->name);
    refuse(refusal.kind, {.item = root,
                          .parameter = view.path_to(row.name),
                          .received = show(value),
                          .expected = refusal.expected,
                          .advice = refusal.advice});
  }
}

void assign_settings(const SettingsGroup& group, void* target, const void* source) {
  for (const Row& row : group.rows)
    with_type(row.storage, [&]<class T>(TypeTag<T>) {
      *static_cast<T*>(member(target, row)) = *static_cast<const T*>(member(source, row));
    });
  for (const SettingsChild& child : group.children)
    assign_settings(*child.group, static_cast<char*>(target) + child.offset,
                    static_cast<const char*>(source) + child.offset);
}

bool equal_settings(const SettingsGroup& group, const void* a, const void* b) {
  const auto inside = [](const void* data, const SettingsChild& child) {
    return static_cast<const char*>(data) + child.offset;
  };
  return std::ranges::all_of(group.rows, [&](const Row& row) { return equal_members(row, a, b); }) &&
         std::ranges::all_of(group.children, [&](const SettingsChild& child) {
           return equal_settings(*child.group, inside(a, child), inside(b, child));
         });
}

py::dict settings_dictionary(const SettingsView& view) {
  py::dict values;
  for (const SettingsChild& child : view.group->children)
    values[py::str(child.name)] = settings_dictionary(view.child(child));
  for (const Row& row : view.group->rows) values[py::str(row.name)] = read_setting(view, row);
  return values;
}

py::dict settings_dictionary_with_types(const SettingsView& view) {
  py::dict values;
  for (const SettingsChild& child : view.group->children)
    values[py::str(child.name)] = settings_dictionary_with_types(view.child(child));
  for (const Row& row : view.group->rows) {
    py::dict entry;
    const py::object value = read_setting(view, row);
    entry["itemIdentifier"] = "";
    entry["value"] = value;
    entry["type"] = type_word(row);
    entry["size"] = size_of(value);
    entry["description"] = setting_text(*view.group, row) + " (" + setting_doc(*view.group, row) + ")";
    values[py::str(row.name)] = entry;
  }
  return values;
}

void find_settings_without_effect(const SettingsGroup& group, std::string_view SettingRule::* reason,
                                  const std::string& path, py::dict& found) {
  for (const SettingRule& rule : group.rules) {
    const bool acts =
        reason == &SettingRule::no_effect && !rule.only_in.empty() && path.starts_with(std::string(rule.only_in) + ".");
    if (!acts && !(rule.*reason).empty()) found[py::str(path + std::string(rule.name))] = py::str(rule.*reason);
  }
  for (const SettingsChild& child : group.children)
    find_settings_without_effect(*child.group, reason, path + std::string(child.name) + ".", found);
}

void set_settings_dictionary(const SettingsView& view, const py::dict& values) {
  SettingsView copy = view;
  copy.root = view.tree->operations.copy(view.root.get());
  copy.data =
      static_cast<char*>(copy.root.get()) + (static_cast<char*>(view.data) - static_cast<char*>(view.root.get()));
  merge(copy, values);
  // Earlier names may reach beyond this structure.
  assign_settings(*view.tree->group, view.root.get(), copy.root.get());
}

std::string settings_text(const SettingsView& view) {
  std::string text = view.title() + ":\n";
  append_text(view, nullptr, 1, text);
  text.pop_back();
  return text;
}

std::string settings_differences(const SettingsView& view, const SettingsView& defaults) {
  std::string text;
  append_text(view, &defaults, 1, text);
  if (text.empty()) return view.title() + ": all at their defaults";
  text.pop_back();
  return view.title() + ", where it differs from the defaults:\n" + text;
}

std::string settings_summary(const SettingsGroup& group) {
  const SettingsText* text = text_of(group);
  return text != nullptr ? std::string(text->summary) : std::string("Settings");
}

std::string setting_text(const SettingsGroup& group, const Row& row) {
  const SettingsText* text = text_of(group);
  return text != nullptr ? std::string(text->rows[static_cast<std::size_t>(&row - group.rows.data())]) : std::string();
}

std::string setting_doc(const SettingsGroup& group, const Row& row) {
  const SettingRule* rule = group.rule_of(row.name);
  std::string text = type_word(row);
  if (rule != nullptr && !rule->words.empty()) {
    text += ", " + std::string(rule->words);
  } else {
    if (row.check == Check::positive) text += ", greater than zero";
    if (row.check == Check::non_negative) text += ", not negative";
  }
  if (row.size > 0) text += " of length " + std::to_string(row.size);
  if (has_unit(row)) text += ", in " + std::string(row.unit);
  if (rule == nullptr) return text;
  const auto add = [&text](const char* words, std::string_view reason) {
    text += reason.empty() ? std::string() : words + std::string(reason);
  };
  add("; ", rule->condition());
  add(rule->only_in.empty() ? "; no effect: " : "; ", rule->no_effect);
  add("; no effect on pages: ", rule->no_effect_on_pages);
  add("; no effect without rays: ", rule->no_effect_without_rays);
  return text;
}

}  // namespace dalembert
