#include "dalembert/model/references.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <deque>
#include <iterator>
#include <mutex>
#include <unordered_map>

#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/model/model.hpp"

namespace dalembert {
namespace {

// Names of the whole process, as a name may be given before any system exists. They are few, and stay.
struct Names {
  std::mutex mutex;
  std::deque<std::string> texts;
  std::unordered_map<std::string, int> numbers;
};

Names& names() {
  static auto* all = new Names;
  return *all;
}
std::atomic<bool> used{false};

// Names of links and joints of the object: one list for each, empty if it has none.
std::array<std::span<const std::string>, 2> names_in_tree(const Item& object) {
  std::array<std::span<const std::string>, 2> lists;
  for (const Row& row : object.type->rows)
    if (row.storage == Storage::texts && row.role == Role::parameter)
      lists[row.name == "jointNames" ? 1 : 0] =
          *static_cast<const std::vector<std::string>*>(member(object.record.get(), row));
  return lists;
}

// The item number in the first row of this storage; -1 if there is no such row.
int number_in(const ItemType& type, const void* record, Storage storage) {
  const auto row =
      std::ranges::find_if(type.rows, [&](const Row& r) { return r.storage == storage && r.role == Role::parameter; });
  return row == type.rows.end() ? -1 : index_values(*row, record).front();
}

// The tree whose links or joints an item counts: its object, or that on its node.
const Item* tree_of(const Model& model, const ItemType& type, const void* record) {
  if (const int object = number_in(type, record, Storage::object); object >= 0)
    return model.find_item(ItemKind::object, object);
  const int node = number_in(type, record, Storage::node);
  if (node < 0) return nullptr;
  const auto stands_on = [&](const Item& object) {
    const auto lists = names_in_tree(object);
    return !(lists[0].empty() && lists[1].empty()) &&
           number_in(*object.type, object.record.get(), Storage::node) == node;
  };
  const auto& objects = model.items(ItemKind::object);
  const auto found = std::ranges::find_if(objects, stands_on);
  return found == objects.end() ? nullptr : &*found;
}

bool has_link_name(const Row& row, const void* record) {
  return row.named != Named::no && is_named_reference(*static_cast<const int*>(member(record, row)));
}

bool has_names(const Row& row, const void* record) {
  return row.role == Role::parameter && index_storage(row.storage).is_index &&
         std::ranges::any_of(index_values(row, record), is_named_reference);
}

}  // namespace

bool names_are_used() { return used.load(std::memory_order_relaxed); }

int named_reference(const std::string& name) {
  Names& all = names();
  const std::lock_guard lock(all.mutex);
  const auto [found, is_new] = all.numbers.try_emplace(name, -2 - static_cast<int>(all.texts.size()));
  if (is_new) all.texts.push_back(name);
  used = true;
  return found->second;
}

const std::string& referred_name(int number) {
  Names& all = names();
  const std::lock_guard lock(all.mutex);
  return all.texts.at(static_cast<std::size_t>(-2 - number));
}

int number_of(const Model& model, ItemKind kind, const std::string& name, const std::string& where,
              const std::string& parameter) {
  const int number = model.number(kind, name);
  if (number >= 0) return number;
  std::vector<std::string> own;
  for (int i = 0; i < model.count(kind); ++i) own.push_back(model.name(kind, i));
  std::string advice = suggestion(name, {own.begin(), own.end()});
  if (own.empty()) advice = "The system has no " + std::string(kind_name(kind)) + "s yet; add it first.";
  refuse(ErrorKind::index, {where, parameter, "", in_quotes(name),
                            "the name of " + with_article(kind_name(kind)) + " of this system", advice});
}

int number_of_link(const Item& tree, Named counted, const std::string& name, const std::string& where,
                   const std::string& parameter) {
  auto lists = names_in_tree(tree);
  if (counted == Named::joints) std::swap(lists[0], lists[1]);
  std::vector<std::string_view> known;
  for (const auto& list : lists) {
    if (const auto found = std::ranges::find(list, name); found != list.end())
      return static_cast<int>(found - list.begin());
    std::ranges::copy_if(list, std::back_inserter(known), [](const std::string& other) { return !other.empty(); });
  }
  refuse(ErrorKind::index,
         {where, parameter, "", in_quotes(name), "the name of a link or of a joint of the tree",
          known.empty() ? "Its links have no names; linkNames and jointNames give them." : suggestion(name, known)});
}

void resolve_names(const Model& model, const ItemType& type, const Row& row, void* record, const std::string& where) {
  if (has_link_name(row, record)) {
    int& value = *static_cast<int*>(member(record, row));
    const Item* tree = tree_of(model, type, record);
    if (tree == nullptr)
      refuse(ErrorKind::index,
             {where, std::string(row.name), "", in_quotes(referred_name(value)),
              "a number: this item is not on a kinematic tree", "Add the tree first, with linkNames and jointNames."});
    value = number_of_link(*tree, row.named, referred_name(value), where, std::string(row.name));
    return;
  }
  if (!has_names(row, record)) return;
  for (int& value : index_values(row, record))
    if (is_named_reference(value))
      value = number_of(model, index_storage(row.storage).kind, referred_name(value), where, std::string(row.name));
}

Item with_numbers(const Model& model, Item item, const std::string& where) {
  const auto named = [&](const Row& row) {
    return has_names(row, item.record.get()) || has_link_name(row, item.record.get());
  };
  if (std::ranges::none_of(item.type->rows, named)) return item;
  std::shared_ptr<void> record = item.type->record.copy(item.record.get());
  for (const Row& row : item.type->rows) resolve_names(model, *item.type, row, record.get(), where);
  return {item.type, std::move(record)};
}

}  // namespace dalembert
