// The item types of the core, followed by those of packages.
#include <vector>

#include "dalembert/reflection/item_package.hpp"

namespace dalembert {
namespace {

template <class T>
void append(std::vector<T>& list, std::span<const T> entries) {
  list.insert(list.end(), entries.begin(), entries.end());
}

struct Registry {
  std::vector<const ItemType*> types;
  std::vector<ItemText> texts;
  std::vector<ItemTransformation> transformations;

  void add(std::span<const ItemType* const> more, std::span<const ItemText> their_texts,
           std::span<const ItemTransformation> their_transformations) {
    append(types, more);
    append(texts, their_texts);
    append(transformations, their_transformations);
  }
  Registry() { add(own_item_types(), own_item_texts(), own_item_transformations()); }
};

Registry& registry() {
  static Registry all;
  return all;
}

}  // namespace

std::span<const ItemType* const> item_types() { return registry().types; }
std::span<const ItemText> item_texts() { return registry().texts; }
std::span<const ItemTransformation> item_transformations() { return registry().transformations; }

void add_item_types(const ItemPackage& package) {
  registry().add(package.types, package.texts, package.transformations);
}

}  // namespace dalembert
