// Deletion of items: dependent items, and references to deleted items.
#include <algorithm>

#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/model/model.hpp"

namespace dalembert {
// Walk all references to items of one kind: the removed one becomes invalid, those behind it move up.
void Model::shift_references(ItemKind kind, int removed, std::vector<std::string>& lost) {
  for (std::size_t k = 0; k < item_kinds; ++k) {
    for (std::size_t i = 0; i < items_[k].size(); ++i) {
      Item& item = items_[k][i];
      const std::vector<int> numbers = referenced(item, kind);
      if (numbers.empty() || numbers.front() < removed) continue;
      std::shared_ptr<void> record = item.type->record.copy(item.record.get());
      for (const Row& row : item.type->rows) {
        const IndexStorage storage = index_storage(row.storage);
        if (!storage.is_index || storage.kind != kind) continue;
        for (int& number : index_values(row, record.get())) {
          if (number > removed) {
            --number;
          } else if (number == removed) {
            number = -1;
            lost.push_back(describe(item.type->kind, static_cast<int>(i)) + ": parameter " + in_quotes(row.name) +
                           " referred to the deleted " + std::string(kind_name(kind)) + " " + std::to_string(removed) +
                           " and is invalid now");
          }
        }
      }
      item.record = std::move(record);
    }
  }
}

// Coordinates are numbered by nodes; the keys are numbers of loads.
void Model::shift_load_dependencies(ItemKind kind, int removed) {
  if (kind == ItemKind::node) load_dependencies_.clear();
  if (kind != ItemKind::load) return;
  load_dependencies_.erase(removed);
  std::map<int, std::vector<int>> shifted;
  for (auto& [load, coordinates] : load_dependencies_)
    shifted[load > removed ? load - 1 : load] = std::move(coordinates);
  load_dependencies_ = std::move(shifted);
}

std::vector<std::string> Model::remove(ItemKind kind, int number, bool with_dependents) {
  const Item removed = item(kind, number);
  auto& list = items(kind);
  list.erase(list.begin() + number);
  index_names(kind);
  note_structure_change(kind);
  changes_.clear();
  std::vector<std::string> lost;
  shift_references(kind, number, lost);
  shift_load_dependencies(kind, number);
  for (std::size_t i = 0; i < term_sources_.size(); ++i)
    term_sources_[i]->shift_references(kind, number, term_name(i), lost);
  if (!with_dependents) return lost;

  const auto take_along = [&](ItemKind dependent) {
    for (const int other : referenced(removed, dependent)) {
      if (find_item(dependent, other) == nullptr) continue;
      std::vector<std::string> more = remove(dependent, other, false);
      lost.insert(lost.end(), more.begin(), more.end());
    }
  };
  if (kind == ItemKind::object) take_along(ItemKind::node);
  if (kind == ItemKind::object || kind == ItemKind::load) take_along(ItemKind::marker);
  return lost;
}

}  // namespace dalembert
