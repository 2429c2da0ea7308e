#include "dalembert/model/item.hpp"

#include <algorithm>
#include <array>

#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"

namespace dalembert {
namespace {

template <std::size_t N>
std::string_view word(const std::array<std::string_view, N>& words, ItemKind kind) {
  return words[static_cast<std::size_t>(kind)];
}

bool has_name(const Row& row, std::string_view name) {
  return row.name == name || std::ranges::find(row.aliases, name) != row.aliases.end();
}

}  // namespace

std::string& name_in(const ItemType& type, void* record) {
  const auto row = std::ranges::find(type.rows, Role::name, &Row::role);
  return *static_cast<std::string*>(member(record, *row));
}
const std::string& name_in(const ItemType& type, const void* record) {
  return name_in(type, const_cast<void*>(record));
}

const std::string& Item::name() const { return name_in(*type, record.get()); }

std::string default_name(ItemKind kind, int number) { return std::string(kind_name(kind)) + std::to_string(number); }

std::string describe_item(ItemKind kind, int number, const std::string& name, const ItemType& type) {
  return std::string(kind_name(kind)) + " " + std::to_string(number) + " '" +
         (name.empty() ? default_name(kind, number) : name) + "' (" + std::string(type.name) + ")";
}

std::string_view kind_name(ItemKind kind) {
  return word(std::array<std::string_view, 5>{"node", "object", "marker", "load", "sensor"}, kind);
}
std::string_view kind_title(ItemKind kind) {
  return word(std::array<std::string_view, 5>{"Node", "Object", "Marker", "Load", "Sensor"}, kind);
}
std::string_view index_name(ItemKind kind) {
  return word(std::array<std::string_view, 5>{"NodeIndex", "ObjectIndex", "MarkerIndex", "LoadIndex", "SensorIndex"},
              kind);
}
std::string_view type_key(ItemKind kind) {
  return word(std::array<std::string_view, 5>{"nodeType", "objectType", "markerType", "loadType", "sensorType"}, kind);
}

const ItemType* find_type(std::string_view name) {
  for (const ItemType* type : item_types())
    if (type->name == name) return type;
  return nullptr;
}

const ItemType* find_type(ItemKind kind, std::string_view name) {
  for (const ItemType* type : item_types())
    if (type->kind == kind && (type->type_name == name || type->name == name)) return type;
  return nullptr;
}

const ItemType& require_type(ItemKind kind, std::string_view name, const std::string& where) {
  if (const ItemType* type = find_type(kind, name)) return *type;
  std::vector<std::string_view> known;
  for (const ItemType* type : item_types())
    if (type->kind == kind && type->physics != nullptr) known.push_back(type->type_name);
  Complaint complaint;
  complaint.item = where;
  complaint.problem = "there is no " + std::string(kind_name(kind)) + " type " + in_quotes(name);
  complaint.advice = suggestion(name, known);
  if (const ItemType* other = find_type(name))
    complaint.advice = in_quotes(name) + " is " + with_article(kind_name(other->kind)) + " type; use Add" +
                       std::string(kind_title(other->kind)) + "(...).";
  refuse(ErrorKind::value, complaint);
}

const Row* find_visualization_row(const ItemType& type, std::string_view name) {
  for (const Row& row : type.rows)
    if (row.role == Role::visualization && has_name(row, name)) return &row;
  return nullptr;
}

const Row* find_row(const ItemType& type, std::string_view name) {
  for (const Row& row : type.rows)
    if (row.role != Role::visualization && has_name(row, name)) return &row;
  return name.starts_with('V') ? find_visualization_row(type, name.substr(1)) : nullptr;
}

std::string suggest_parameter(const ItemType& type, std::string_view name) {
  std::vector<std::string> names;
  for (const Row& row : type.rows) {
    const std::string prefix = row.role == Role::visualization ? "V" : "";
    names.push_back(prefix + std::string(row.name));
    for (const std::string_view alias : row.aliases) names.push_back(prefix + std::string(alias));
  }
  return suggest_parameter(type, name, {names.begin(), names.end()});
}

std::string suggest_parameter(const ItemType& type, std::string_view name, const std::vector<std::string_view>& known) {
  const bool of_body = name.starts_with("body") || name.starts_with("object") || name.starts_with("node");
  for (const char* markers : {"markerNumber", "markerNumbers"})
    if (of_body && name.find("umber") != std::string_view::npos && std::ranges::find(known, markers) != known.end())
      return std::string(type.name) + " acts on markers: pass " + in_quotes(markers) +
             ", made of what AddMarker(...) returned. Functions of the system, such as " +
             (type.kind == ItemKind::load ? "mbs.CreateForce(...) and CreateTorque(...)"
                                          : "mbs.CreateSpringDamper(...) and CreateGenericJoint(...)") +
             ", take body numbers and make the markers.";
  return suggestion(name, known);
}

bool provides(const ItemType& type, std::string_view what) {
  return std::ranges::find(type.provides, what) != type.provides.end();
}

std::string_view variable_name(OutputVariableType variable) {
  for (const EnumTable& table : enum_tables())
    if (table.name == "OutputVariableType")
      for (const EnumEntry& entry : table.entries)
        if (entry.value == static_cast<std::uint64_t>(variable)) return entry.name;
  return "_None";
}

std::string variable_names(std::span<const OutputVariableType> variables) {
  std::string names;
  for (const OutputVariableType v : variables) names += (names.empty() ? "" : ", ") + std::string(variable_name(v));
  return names;
}

namespace {
template <class Numbers, class Record>
std::span<Numbers> numbers(const Row& row, Record* record) {
  return visit(row, record, [](auto& value) -> std::span<Numbers> {
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (is_item_index<T>)
      return {&value.value, 1};
    else if constexpr (requires { requires is_item_index<typename T::value_type>; })
      return value.empty() ? std::span<Numbers>{} : std::span<Numbers>{&value.data()->value, value.size()};
    else
      return {};
  });
}
static_assert(sizeof(NodeIndex) == sizeof(int));
}  // namespace

std::span<int> index_values(const Row& row, void* record) { return numbers<int>(row, record); }
std::span<const int> index_values(const Row& row, const void* record) { return numbers<const int>(row, record); }

}  // namespace dalembert
