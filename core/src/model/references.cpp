#include "dalembert/model/references.hpp"

#include <algorithm>
#include <atomic>
#include <deque>
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

int number_of(const Model& model, ItemKind kind, const std::string& name, const std::string& where, const std::string& parameter) {
  const int number = model.number(kind, name);
  if (number >= 0) return number;
  std::vector<std::string> own;
  for (int i = 0; i < model.count(kind); ++i) own.push_back(model.name(kind, i));
  std::string advice = suggestion(name, {own.begin(), own.end()});
  if (own.empty()) advice = "The system has no " + std::string(kind_name(kind)) + "s yet; add it first.";
  refuse(ErrorKind::index, {where, parameter, "", quoted(name), "the name of " + with_article(kind_name(kind)) + " of this system", advice});
}

void resolve_names(const Model& model, const Row& row, void* record, const std::string& where) {
  if (!has_names(row, record)) return;
  for (int& value : index_values(row, record))
    if (is_named_reference(value))
      value = number_of(model, index_storage(row.storage).kind, referred_name(value), where, std::string(row.name));
}

Item with_numbers(const Model& model, Item item, const std::string& where) {
  const auto named = [&](const Row& row) { return has_names(row, item.record.get()); };
  if (std::ranges::none_of(item.type->rows, named)) return item;
  std::shared_ptr<void> record = item.type->record.copy(item.record.get());
  for (const Row& row : item.type->rows) resolve_names(model, row, record.get(), where);
  return {item.type, std::move(record)};
}

}  // namespace dalembert
