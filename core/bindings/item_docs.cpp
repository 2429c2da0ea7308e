#include "item_docs.hpp"

#include <pybind11/numpy.h>

#include <algorithm>

#include "conversion.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/model/value_checks.hpp"
#include "dalembert/reflection/item_texts.hpp"
#include "item_equality.hpp"

namespace dalembert {
namespace {

std::string_view storage_text(Storage storage) {
  switch (storage) {
    case Storage::boolean: return "bool";
    case Storage::integer: return "int";
    case Storage::real: return "float";
    case Storage::text: return "str";
    case Storage::texts: return "list of str";
    case Storage::vector2: return "2 numbers";
    case Storage::vector3: return "3 numbers";
    case Storage::vector4: return "4 numbers";
    case Storage::vector6: return "6 numbers";
    case Storage::vector7: return "7 numbers";
    case Storage::vector9: return "9 numbers";
    case Storage::matrix3: return "3 x 3 numbers";
    case Storage::matrix6: return "6 x 6 numbers";
    case Storage::vector: return "numbers";
    case Storage::matrix: return "matrix";
    case Storage::integer_matrix: return "matrix of integers";
    case Storage::matrix_container: return "MatrixContainer or matrix";
    case Storage::integers: return "list of int";
    case Storage::vector3s: return "list of 3 numbers each";
    case Storage::matrix3s: return "list of 3 x 3 matrices";
    case Storage::vector6s: return "list of 6 numbers each";
    case Storage::node: return "NodeIndex";
    case Storage::object: return "ObjectIndex";
    case Storage::marker: return "MarkerIndex";
    case Storage::load: return "LoadIndex";
    case Storage::sensor: return "SensorIndex";
    case Storage::nodes: return "list of NodeIndex";
    case Storage::objects: return "list of ObjectIndex";
    case Storage::markers: return "list of MarkerIndex";
    case Storage::loads: return "list of LoadIndex";
    case Storage::sensors: return "list of SensorIndex";
    case Storage::output_variable: return "OutputVariableType";
    case Storage::joint_types: return "list of JointType";
    case Storage::beam_section: return "BeamSection";
    case Storage::user_function: return "function or 0";
    case Storage::opaque: return "object";
    case Storage::enumeration: return "enumeration";
  }
  return "";
}

// A Python literal of the default value; None if there is no literal.
std::string literal(const Row& row, const void* record) {
  switch (row.storage) {
    case Storage::matrix_container:
    case Storage::beam_section:
    case Storage::output_variable: return "None";
    case Storage::opaque: return row.name.find("UserFunction") != std::string_view::npos ? "0" : "[]";
    case Storage::user_function: return "0";
    case Storage::vector3s:
    case Storage::matrix3s:
    case Storage::vector6s:
    case Storage::joint_types:
    case Storage::texts: return "[]";
    default: break;
  }
  py::object value = py::reinterpret_steal<py::object>(to_python(row, member(record, row), Form::copy, nullptr));
  if (py::isinstance<py::array>(value)) value = value.attr("tolist")();
  const IndexStorage index = index_storage(row.storage);
  if (index.is_list) {
    value = py::list(py::module_::import("builtins").attr("map")(py::type::of(py::int_()), value));
  } else if (index.is_index) {
    value = py::int_(value);
  }
  return py::repr(value).cast<std::string>();
}

std::string visualization_literal(const ItemClass& item_class) {
  std::string text = "{";
  for (const auto& argument : item_class.visualization_arguments) {
    text += (text.size() > 1 ? ", '" : "'") + std::string(argument.row->name) +
            "': " + literal(*argument.row, item_class.defaults.get());
  }
  return text + "}";
}

// Finds the texts of the spec of an item type.
const ItemText& text_of(const ItemType& type) {
  const auto types = item_types();
  return item_texts()[static_cast<std::size_t>(std::find(types.begin(), types.end(), &type) - types.begin())];
}

std::string_view row_text(const ItemType& type, const Row& row) {
  return text_of(type).rows[static_cast<std::size_t>(&row - type.rows.data())];
}

std::string type_words(const Row& row) {
  std::string text(storage_text(row.storage));
  if (row.size > 0) text += " of length " + std::to_string(row.size);
  return text;
}

std::string_view check_name(Check check) {
  switch (check) {
    case Check::none: return "";
    case Check::non_negative: return "non_negative";
    case Check::positive: return "positive";
    case Check::rotation: return "rotation";
    case Check::orthogonal: return "orthogonal";
    case Check::unit_vector: return "unit_vector";
    case Check::color: return "color";
  }
  return "";
}

std::string facts_after_type(const Row& row) {
  std::string text;
  if (row.check == Check::positive) text += ", > 0";
  if (row.check == Check::non_negative) text += ", >= 0";
  if (row.named != Named::no)
    text += row.named == Named::links ? ", or the name of a link" : ", or the name of a joint";
  if (const std::string demanded = demand(row.check); !demanded.empty()) text += ", " + demanded;
  if (!row.unit.empty()) text += ", unit " + std::string(row.unit);
  if (row.needs_assemble) text += "; changes need Assemble()";
  for (const std::string_view alias : row.aliases) text += "; also named " + std::string(alias);
  return text;
}

std::string output_line(const OutputText& output) {
  const std::string size = output.size == 1   ? "float"
                           : output.size == 0 ? "numbers"
                                              : std::to_string(output.size) + " numbers";
  return "    " + std::string(output.name) + ": " + size + ", unit " + std::string(output.unit) + "\n        " +
         std::string(output.text) + "\n";
}

std::string words(std::span<const std::string_view> list) {
  std::string text;
  for (const std::string_view word : list) text += (text.empty() ? "" : ", ") + std::string(word);
  return text;
}

}  // namespace

std::string row_doc(const ItemType& type, const Row& row) {
  return type_words(row) + facts_after_type(row) + "\n" + std::string(row_text(type, row));
}

py::list described_parameters(const ItemClass& item_class, bool visualization) {
  py::list made;
  for (const auto& argument : visualization ? item_class.visualization_arguments : item_class.arguments) {
    if (argument.row == nullptr) continue;
    const Row& row = *argument.row;
    py::list aliases;
    for (const std::string_view alias : row.aliases) aliases.append(alias);
    made.append(py::make_tuple(row.name, type_words(row), check_name(row.check), facts_after_type(row),
                               row_text(*item_class.type, row), py::tuple(aliases)));
  }
  return made;
}

py::list described_outputs(const ItemClass& item_class) {
  py::list made;
  for (const OutputText& output : text_of(*item_class.type).outputs)
    made.append(py::make_tuple(output.name, output.size, output.unit, output.text));
  return made;
}

std::string class_doc(const ItemClass& item_class, bool visualization) {
  const ItemType& type = *item_class.type;
  const std::string name = (visualization ? "V" : "") + std::string(type.name);
  const auto& arguments = visualization ? item_class.visualization_arguments : item_class.arguments;
  std::string signature, parameters;
  for (const auto& argument : arguments) {
    if (!signature.empty()) signature += ", ";
    if (argument.row == nullptr) {
      signature += "visualization=" + visualization_literal(item_class);
      parameters += "    visualization: V" + std::string(type.name) + " or dict\n        how the item is drawn\n";
      continue;
    }
    const Row& row = *argument.row;
    const std::string value = literal(row, item_class.defaults.get());
    signature += std::string(row.name) + "=" + value;
    parameters += "    " + std::string(row.name) + ": " + type_words(row) + " = " + value + facts_after_type(row) +
                  "\n        " + std::string(row_text(type, row)) + "\n";
  }
  if (!visualization) {
    std::string others;
    for (const auto& argument : arguments)
      if (argument.row != nullptr)
        for (const std::string_view alias : argument.row->aliases) others += ", " + std::string(alias) + "=...";
    for (const auto& each : item_class.transformations) {
      others += ", " + to_string(each.name) + "=None";
      parameters += "    " + to_string(each.name) + ": exu.HT or 4x4 matrix\n        " +
                    (each.position != nullptr ? std::string(each.position->name) + " and " : "") +
                    std::string(each.rotation->name) + " as rigid transformation\n";
    }
    if (!others.empty()) signature += ", *" + others;
  }
  std::string text = name + "(" + signature + ")\n--\n\n";
  const ItemText& of_spec = text_of(type);
  text += visualization ? "How a " + std::string(type.name) + " is drawn.\n" : std::string(of_spec.summary) + "\n";
  text += "\nParameters:\n" + parameters;
  if (visualization) return text;
  if (!of_spec.outputs.empty()) text += "\nOutput variables:\n";
  for (const OutputText& output : of_spec.outputs) text += output_line(output);
  if (!type.provides.empty()) text += "\nProvides: " + words(type.provides) + "\n";
  text += of_spec.more;
  if (type.physics == nullptr && type.kind != ItemKind::sensor)
    text += "\nIts physics is planned: it can be described, but not yet added to a system.\n";
  return text;
}

std::string call_of(const ItemType& type, std::string_view user_function) {
  const std::string_view text = text_of(type).more;
  const std::size_t begin = text.find("\n    " + std::string(user_function) + "(");
  if (begin == std::string_view::npos) return "";
  const std::size_t first = begin + std::string_view("\n    ").size();
  return std::string(text.substr(first, text.find('\n', first) - first));
}

std::string item_repr(const ItemClass& item_class, const void* record, bool visualization) {
  const auto changes = [&](const std::vector<ItemClass::Argument>& arguments) {
    std::string text;
    for (const auto& argument : arguments) {
      if (argument.row == nullptr || equal_members(*argument.row, record, item_class.defaults.get())) continue;
      py::object value = py::reinterpret_steal<py::object>(
          to_python(*argument.row, member(record, *argument.row), Form::copy, nullptr));
      if (py::isinstance<py::array>(value)) value = value.attr("tolist")();
      text += (text.empty() ? "" : ", ") + std::string(argument.row->name) + "=" + py::repr(value).cast<std::string>();
    }
    return text;
  };
  const std::string name(item_class.type->name);
  const std::string drawn = changes(item_class.visualization_arguments);
  if (visualization) return "V" + name + "(" + drawn + ")";
  std::string text = changes(item_class.arguments);
  if (!drawn.empty()) text += (text.empty() ? "" : ", ") + ("visualization=V" + name) + "(" + drawn + ")";
  return name + "(" + text + ")";
}

}  // namespace dalembert
