#include "dalembert/system/excerpt.hpp"

#include <map>
#include <utility>

#include "dalembert/model/member.hpp"

namespace dalembert {
namespace {

class Copier {
 public:
  explicit Copier(const Model& from) : from_(from) {}

  // Copies an item after those that it refers to, with their new numbers; each one once.
  int copy(ItemKind kind, int number) {
    const auto found = numbers_.find({kind, number});
    if (found != numbers_.end()) return found->second;
    const Item& item = from_.item(kind, number);
    const std::shared_ptr<void> record = item.type->record.copy(item.record.get());
    for (const Row& row : item.type->rows) {
      const IndexStorage storage = index_storage(row.storage);
      if (!storage.is_index) continue;
      for (int& reference : index_values(row, record.get()))
        if (reference >= 0 && from_.find_item(storage.kind, reference) != nullptr) reference = copy(storage.kind, reference);
    }
    name_in(*item.type, record.get()).clear();
    return numbers_[{kind, number}] = to.add({item.type, record});
  }

  Model to;

 private:
  const Model& from_;
  std::map<std::pair<ItemKind, int>, int> numbers_;
};

}  // namespace

Excerpt excerpt(const Model& model, ItemKind kind, int number) {
  Copier copier(model);
  Excerpt part{std::make_unique<System>(), copier.copy(kind, number)};
  part.system->assemble(copier.to);
  return part;
}

}  // namespace dalembert
