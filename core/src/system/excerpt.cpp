#include "dalembert/system/excerpt.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"

namespace dalembert {
namespace {

class Copier {
 public:
  explicit Copier(const Model& from) : from_(from) {}

  // Copies an item after those that it refers to, with their new numbers; each one once.
  int copy(ItemKind kind, int number) {
    const auto [found, is_new] = numbers_.try_emplace({kind, number}, being_copied);
    if (found->second == being_copied && !is_new)
      refuse(ErrorKind::value,
             {from_.describe(kind, number), "", "it refers to itself, by what it refers to", "", "", ""});
    if (!is_new) return found->second;
    const ItemChange here{{kind, number}};
    from_.check({&here, 1});  // also that there is a body where one is asked for
    const Item& item = from_.item(kind, number);
    sources.push_back({kind, number, item.record});
    const std::shared_ptr<void> record = item.type->record.copy(item.record.get());
    for (const Row& row : item.type->rows) {
      const IndexStorage storage = index_storage(row.storage);
      if (!storage.is_index) continue;
      for (int& reference : index_values(row, record.get()))
        if (reference >= 0 && from_.find_item(storage.kind, reference) != nullptr)
          reference = copy(storage.kind, reference);
    }
    name_in(*item.type, record.get()).clear();
    const int copied = to.add({item.type, record});
    to.entitle(kind, copied, from_.describe(kind, number));
    return numbers_[{kind, number}] = copied;
  }

  Model to;
  std::vector<Excerpt::Source> sources;

 private:
  static constexpr int being_copied = -1;

  const Model& from_;
  std::map<std::pair<ItemKind, int>, int> numbers_;
};

// Records never change, they are replaced.
bool is_current(const Excerpt& excerpt, const Model& model) {
  return std::ranges::all_of(excerpt.sources, [&](const Excerpt::Source& source) {
    const Item* item = model.find_item(source.kind, source.number);
    return item != nullptr && item->record == source.record;
  });
}

}  // namespace

Excerpt excerpt(const Model& model, ItemKind kind, int number) {
  Copier copier(model);
  Excerpt part{std::make_unique<System>(), copier.copy(kind, number), std::move(copier.sources)};
  part.system->assemble(copier.to);
  return part;
}

std::shared_ptr<const Excerpt> Excerpts::of(const Model& model, ItemKind kind, int number) {
  for (const auto& known : kept_) {
    if (!known || known->sources[0].kind != kind || known->sources[0].number != number) continue;
    if (is_current(*known, model)) return known;
  }
  auto made = std::make_shared<const Excerpt>(excerpt(model, kind, number));
  kept_[std::exchange(next_, (next_ + 1) % kept_.size())] = made;
  return made;
}

}  // namespace dalembert
