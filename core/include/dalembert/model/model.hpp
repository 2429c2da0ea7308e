// The editable description of a multibody system: items, before anything is assembled.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "dalembert/model/item.hpp"
#include "dalembert/model/term_source.hpp"

namespace dalembert {

struct ItemReference {
  ItemKind kind = ItemKind::node;
  int number = -1;
};

// An item with a new value in one row, or, if that is null, in any of them.
struct ItemChange : ItemReference {
  const Row* row = nullptr;
};

class Model {
 public:
  int count(ItemKind kind) const { return static_cast<int>(items(kind).size()); }
  const std::vector<Item>& items(ItemKind kind) const { return items_[static_cast<std::size_t>(kind)]; }
  // Refused if there is no such item.
  const Item& item(ItemKind kind, int number) const;
  const Item* find_item(ItemKind kind, int number) const;  // nullptr if it does not exist
  std::string name(ItemKind kind, int number) const;
  int number(ItemKind kind, std::string_view name) const;  // -1 if it does not exist
  // The numbers of items with names of their own.
  const std::unordered_map<std::string, int>& names(ItemKind kind) const {
    return numbers_[static_cast<std::size_t>(kind)];
  }
  std::string describe(ItemKind kind, int number) const;   // "node 3 'foot' (NodePoint)"
  // Names of items whose number differs in the original model; empty for an independent model.
  using Titles = std::array<std::unordered_map<int, std::string>, item_kinds>;
  const Titles& titles() const { return titles_; }
  void entitle(ItemKind kind, int number, std::string title) {
    titles_[static_cast<std::size_t>(kind)][number] = std::move(title);
  }

  // Add one item and return its number. A planned type, or a name that is taken, is refused.
  int add(Item item);
  // Replace all parameters; type and number stay.
  void replace(ItemKind kind, int number, Item item);
  // Write one parameter: `write` gets the member in a copy, which is kept only if `write` returns.
  void edit(ItemKind kind, int number, const Row& row, const std::function<void(void*)>& write);
  // Replaces an object by one with derived parameters that Assemble has computed; the input of the computation has
  // not changed.
  void complete(int object, std::shared_ptr<const void> record);
  // Replaces parameter values; connections do not change.
  void renew(ItemKind kind, int number, std::shared_ptr<const void> record);
  void rename(ItemKind kind, int number, std::string name);
  // Take the items of another model; changes go on counting.
  void become(Model other);
  // The effect of an edit of a row: another Assemble, or only the new value; neither for rows that are only drawn or
  // names.
  static bool changes_structure(const Row& row);
  static bool changes_values(const Row& row);

  // Delete one item; numbers behind it move up, references to it become invalid. `with_dependents`: objects take their
  // nodes and markers along, loads their marker. Returns a sentence for each reference that was lost.
  std::vector<std::string> remove(ItemKind kind, int number, bool with_dependents);

  // The value of a load depends on these ODE2 coordinates of the assembled system, besides those that it acts on. The numbers keep
  // their meaning when items are added; they are forgotten when a node is deleted or replaced.
  void add_load_dependencies(int load, std::span<const int> coordinates);
  const std::map<int, std::vector<int>>& load_dependencies() const { return load_dependencies_; }

  // Sources of further terms of the assembled system. Code that changes a source must report whether another Assemble
  // is needed.
  std::span<const std::shared_ptr<SystemTermSource>> term_sources() const { return term_sources_; }
  static std::string term_name(std::size_t number) { return "GeneralContact " + std::to_string(number); }
  void add(std::shared_ptr<SystemTermSource> source);
  void remove_term_source(std::size_t number);
  void term_source_changed();

  // Warning about questionable items: a sentence on the first one, and their number; empty if there are none.
  std::string doubt() const;
  // Refuse a model that cannot be assembled: indices, types of nodes and markers, array lengths. Throws ModelError.
  void check() const;
  void check(std::span<const ItemChange> some) const;  // the same for what has changed

  std::uint64_t structure_changes() const { return structure_changes_; }  // grown: Assemble is needed
  std::uint64_t equation_changes() const { return equation_changes_; }    // the same without those of sensors
  std::uint64_t value_changes() const { return value_changes_; }          // grown: parameters were replaced
  std::uint64_t record_changes() const {
    return record_changes_;
  }        // the same: no item has another record, name or number
  // The changes since number `since`, until the next one; none if everything may have changed.
  std::optional<std::span<const ItemChange>> changed_since(std::uint64_t since) const;

 private:
  std::vector<Item>& items(ItemKind kind) {  // for changes
    ++record_changes_;
    return items_[static_cast<std::size_t>(kind)];
  }
  void check_name(ItemKind kind, int number, std::string_view name, const ItemType& type) const;
  void adopt_name(ItemKind kind, int number, Item& item) const;  // checked; a default name is left out
  void register_name(ItemKind kind, int number, std::string_view name);
  void index_names(ItemKind kind);
  void note_structure_change(ItemKind kind);
  void note_value_change(const ItemChange& change);
  void shift_references(ItemKind kind, int removed, std::vector<std::string>& lost);
  void shift_load_dependencies(ItemKind kind, int removed);

  std::array<std::vector<Item>, item_kinds> items_;
  std::array<std::unordered_map<std::string, int>, item_kinds> numbers_;
  Titles titles_;
  std::map<int, std::vector<int>> load_dependencies_;
  std::vector<std::shared_ptr<SystemTermSource>> term_sources_;  // shared by copies of the model
  std::vector<ItemChange> changes_;                                       // the last of the value changes
  std::uint64_t structure_changes_ = 0, equation_changes_ = 0, value_changes_ = 0, record_changes_ = 0;
};

// Numbers of the items of a kind that an item refers to.
std::vector<int> referenced(const Item& item, ItemKind kind);
// Objects with constraints whose markers are on these bodies and no others.
std::vector<int> constraints_between(const Model& model, std::vector<int> bodies);

// The number in a default name such as 'node12' of that kind; -1 if the name is not of this form.
int default_name_number(ItemKind kind, std::string_view name);

}  // namespace dalembert
