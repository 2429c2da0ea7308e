#include "dalembert/model/model.hpp"

#include <algorithm>
#include <charconv>
#include <map>

#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/model/references.hpp"

namespace dalembert {
namespace {

// Number of remembered changes; after more of them everything counts as changed.
constexpr std::size_t remembered_changes = 4096;

void refuse_planned(const ItemType& type) {
  Complaint complaint;
  complaint.problem =
      std::string(type.name) + " is specified, but its physics is planned and not yet part of this release";
  complaint.advice = "Its parameters are described in " + std::string(type.spec) +
                     "; a kernel for it would make it ready, see docs/developer.";
  refuse(ErrorKind::planned, complaint);
}

Item renamed(const Item& item, std::string name) {
  std::shared_ptr<void> record = item.type->record.copy(item.record.get());
  name_in(*item.type, record.get()) = std::move(name);
  return {item.type, std::move(record)};
}

}  // namespace

int default_name_number(ItemKind kind, std::string_view name) {
  const std::string_view prefix = kind_name(kind);
  if (!name.starts_with(prefix) || name.size() == prefix.size()) return -1;
  int number = -1;
  const auto [end, error] = std::from_chars(name.data() + prefix.size(), name.data() + name.size(), number);
  return error == std::errc{} && end == name.data() + name.size() ? number : -1;
}

const Item* Model::find_item(ItemKind kind, int number) const {
  const auto& list = items(kind);
  return number >= 0 && number < static_cast<int>(list.size()) ? &list[static_cast<std::size_t>(number)] : nullptr;
}

const Item& Model::item(ItemKind kind, int number) const {
  if (const Item* item = find_item(kind, number)) return *item;
  Complaint complaint;
  const std::string noun(kind_name(kind));
  complaint.problem = "there is no " + noun + " with number " + std::to_string(number);
  complaint.expected = count(kind) == 0 ? "nothing: the system has no " + noun + "s yet"
                                        : "a number from 0 to " + std::to_string(count(kind) - 1);
  complaint.advice = "Use the index that Add" + std::string(kind_title(kind)) + "(...) returned.";
  refuse(ErrorKind::index, complaint);
}

std::string Model::name(ItemKind kind, int number) const {
  const Item& found = item(kind, number);
  return found.name().empty() ? default_name(kind, number) : found.name();
}

int Model::number(ItemKind kind, std::string_view name) const {
  const auto& names = numbers_[static_cast<std::size_t>(kind)];
  if (const auto found = names.find(std::string(name)); found != names.end()) return found->second;
  const int number = default_name_number(kind, name);
  const Item* item = find_item(kind, number);
  return item != nullptr && item->name().empty() ? number : -1;
}

std::string Model::describe(ItemKind kind, int number) const {
  const auto& titles = titles_[static_cast<std::size_t>(kind)];
  if (const auto title = titles.find(number); title != titles.end()) return title->second;
  if (const Item* item = find_item(kind, number)) return describe_item(kind, number, item->name(), *item->type);
  return std::string(kind_name(kind)) + " " + std::to_string(number);
}

ItemLabel::operator std::string() const { return model.describe(kind, number); }

// Default names belong to the item with that number, so that every item has a name of its own.
void Model::check_name(ItemKind kind, int number, std::string_view name, const ItemType& type) const {
  if (name.empty()) return;
  Complaint complaint;
  complaint.item = std::string(kind_name(kind)) + " " + std::to_string(number) + " (" + std::string(type.name) + ")";
  complaint.parameter = "name";
  complaint.received = in_quotes(name);
  if (const int reserved = default_name_number(kind, name); reserved >= 0 && reserved != number) {
    complaint.expected = "a name that is not of the form '" + std::string(kind_name(kind)) + "' + number";
    complaint.advice = "Such names are given to items without a name; choose another one, or leave the name empty.";
    refuse(ErrorKind::value, complaint);
  }
  const auto& names = numbers_[static_cast<std::size_t>(kind)];
  const auto found = names.find(std::string(name));
  if (found == names.end() || found->second == number) return;
  complaint.expected = "a name that no other " + std::string(kind_name(kind)) + " has";
  complaint.advice = "The name belongs to " + describe(kind, found->second) + "; choose another one.";
  refuse(ErrorKind::value, complaint);
}

void Model::adopt_name(ItemKind kind, int number, Item& item) const {
  check_name(kind, number, item.name(), *item.type);
  if (default_name_number(kind, item.name()) == number) item = renamed(item, {});
}

void Model::register_name(ItemKind kind, int number, std::string_view name) {
  if (!name.empty()) numbers_[static_cast<std::size_t>(kind)][std::string(name)] = number;
}

void Model::index_names(ItemKind kind) {
  numbers_[static_cast<std::size_t>(kind)].clear();
  for (int i = 0; i < count(kind); ++i) register_name(kind, i, items(kind)[static_cast<std::size_t>(i)].name());
}

int Model::add(Item item) {
  const ItemKind kind = item.type->kind;
  const int number = count(kind);
  if (item.type->physics == nullptr) refuse_planned(*item.type);
  if (names_are_used())
    item = with_numbers(*this, std::move(item), describe_item(kind, number, item.name(), *item.type));
  if (!item.name().empty()) {
    adopt_name(kind, number, item);
    register_name(kind, number, item.name());
  }
  items(kind).push_back(std::move(item));
  note_structure_change(kind);
  return number;
}

void Model::complete(int object, std::shared_ptr<const void> record) {
  items(ItemKind::object)[static_cast<std::size_t>(object)].record = std::move(record);
}

void Model::replace(ItemKind kind, int number, Item item) {
  const Item& old = this->item(kind, number);
  if (old.type != item.type) {
    Complaint complaint;
    complaint.item = describe(kind, number);
    complaint.received = "parameters of a " + std::string(item.type->name);
    complaint.expected = "those of a " + std::string(old.type->name);
    complaint.advice = "The type of an item cannot change; delete the item and add another one.";
    refuse(ErrorKind::value, complaint);
  }
  if (names_are_used()) item = with_numbers(*this, std::move(item), describe(kind, number));
  adopt_name(kind, number, item);
  items(kind)[static_cast<std::size_t>(number)] = std::move(item);
  index_names(kind);
  note_structure_change(kind);
  if (kind == ItemKind::node) load_dependencies_.clear();
}

bool Model::changes_structure(const Row& row) {
  return row.role == Role::parameter && (row.needs_assemble || index_storage(row.storage).is_index);
}
bool Model::changes_values(const Row& row) { return row.role == Role::parameter && !changes_structure(row); }

void Model::edit(ItemKind kind, int number, const Row& row, const std::function<void(void*)>& write) {
  const Item& old = item(kind, number);
  std::shared_ptr<void> record = old.type->record.copy(old.record.get());
  write(member(record.get(), row));
  const bool may_be_named = row.named != Named::no || index_storage(row.storage).is_index;
  if (may_be_named && names_are_used()) resolve_names(*this, *old.type, row, record.get(), describe(kind, number));
  if (row.role == Role::name) {
    rename(kind, number, *static_cast<const std::string*>(member(record.get(), row)));
    return;
  }
  items(kind)[static_cast<std::size_t>(number)].record = std::move(record);
  if (changes_structure(row)) {
    note_structure_change(kind);
    if (kind == ItemKind::node) load_dependencies_.clear();
  } else if (changes_values(row)) {
    note_value_change({{kind, number}, &row});
  }
}

void Model::renew(ItemKind kind, int number, std::shared_ptr<const void> record) {
  items(kind)[static_cast<std::size_t>(number)].record = std::move(record);
  note_value_change({{kind, number}});
}

void Model::rename(ItemKind kind, int number, std::string name) {
  Item item = renamed(this->item(kind, number), std::move(name));
  adopt_name(kind, number, item);
  items(kind)[static_cast<std::size_t>(number)] = std::move(item);
  index_names(kind);
}

void Model::become(Model other) {
  other.structure_changes_ += structure_changes_ + 1;
  other.equation_changes_ += equation_changes_ + 1;
  other.value_changes_ += value_changes_ + 1;
  other.record_changes_ += record_changes_ + 1;
  *this = std::move(other);
}

void Model::add_load_dependencies(int load, std::span<const int> coordinates) {
  std::vector<int>& known = load_dependencies_[load];
  for (const int i : coordinates)
    if (std::ranges::find(known, i) == known.end()) known.push_back(i);
}

void Model::add(std::shared_ptr<SystemTermSource> source) {
  term_sources_.push_back(std::move(source));
  term_source_changed();
}

void Model::remove_term_source(std::size_t number) {
  term_sources_.erase(term_sources_.begin() + static_cast<std::ptrdiff_t>(number));
  term_source_changed();
}

void Model::term_source_changed() {
  ++structure_changes_;
  ++equation_changes_;
}

void Model::note_structure_change(ItemKind kind) {
  ++structure_changes_;
  if (kind != ItemKind::sensor) ++equation_changes_;
}

void Model::note_value_change(const ItemChange& change) {
  if (changes_.size() >= remembered_changes)
    changes_.erase(changes_.begin(), changes_.begin() + remembered_changes / 2);
  changes_.push_back(change);
  ++value_changes_;
}

std::optional<std::span<const ItemChange>> Model::changed_since(std::uint64_t since) const {
  const std::uint64_t missing = value_changes_ - since;
  if (missing > changes_.size()) return std::nullopt;
  return std::span(changes_).last(static_cast<std::size_t>(missing));
}

// Largest first, each once.
std::vector<int> referenced(const Item& item, ItemKind kind) {
  std::vector<int> found;
  for (const Row& row : item.type->rows) {
    const IndexStorage storage = index_storage(row.storage);
    if (!storage.is_index || storage.kind != kind) continue;
    for (const int number : index_values(row, item.record.get()))
      if (number >= 0) found.push_back(number);
  }
  std::ranges::sort(found, std::greater<>{});
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<int> constraints_between(const Model& model, std::vector<int> bodies) {
  std::ranges::sort(bodies, std::greater<>{});
  std::vector<int> found, carriers;
  const std::vector<Item>& objects = model.items(ItemKind::object);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!provides(*objects[i].type, "Constraint")) continue;
    carriers.clear();
    for (const int marker : referenced(objects[i], ItemKind::marker))
      for (const int body : referenced(model.item(ItemKind::marker, marker), ItemKind::object))
        carriers.push_back(body);
    std::ranges::sort(carriers, std::greater<>{});
    if (carriers == bodies) found.push_back(static_cast<int>(i));
  }
  return found;
}

}  // namespace dalembert
