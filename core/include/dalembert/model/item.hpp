// One item of a model, and its name in error texts.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

inline constexpr int item_kinds = 5;

// Records of items in a model are never changed in place: a change replaces the record by a changed copy. Raw
// pointers to records must be fetched again if Model::value_changes() has increased.
struct Item {
  const ItemType* type = nullptr;
  std::shared_ptr<const void> record;

  const std::string& name() const;  // empty: the default name, made of the kind and the number
  template <class Record>
  const Record& as() const {
    return *static_cast<const Record*>(record.get());
  }
};

// The name in a record, as the user gave it; every record has one.
std::string& name_in(const ItemType& type, void* record);
const std::string& name_in(const ItemType& type, const void* record);

// "node 3 'foot' (NodePoint)"; the default name stands in for an empty one.
std::string describe_item(ItemKind kind, int number, const std::string& name, const ItemType& type);
std::string default_name(ItemKind kind, int number);  // 'node3'

std::string_view kind_name(ItemKind kind);    // "node"
std::string_view kind_title(ItemKind kind);   // "Node"
std::string_view index_name(ItemKind kind);   // "NodeIndex"
std::string_view type_key(ItemKind kind);     // "nodeType"

// nullptr if it does not exist.
const ItemType* find_type(std::string_view name);                 // 'NodePoint'
const ItemType* find_type(ItemKind kind, std::string_view name);  // 'NodePoint' or 'Point'
// Variant that rejects an unknown name, with the nearest known one. `where` begins the text of the error.
const ItemType& require_type(ItemKind kind, std::string_view name, const std::string& where);

// Finds parameters by name or alias, visualization parameters with a leading 'V'; nullptr if unknown.
const Row* find_row(const ItemType& type, std::string_view name);
const Row* find_visualization_row(const ItemType& type, std::string_view name);  // name without the 'V'
// Suggestion for an unknown parameter name; the second function searches a given list.
std::string suggest_parameter(const ItemType& type, std::string_view name);
std::string suggest_parameter(const ItemType& type, std::string_view name, const std::vector<std::string_view>& known);
bool provides(const ItemType& type, std::string_view what);

std::string_view variable_name(OutputVariableType variable);                     // "Position"
std::string variable_names(std::span<const OutputVariableType> variables);  // "Position, Velocity"

}  // namespace dalembert
