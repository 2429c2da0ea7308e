// The parameters by which items name other items.
#pragma once

#include <array>
#include <unordered_map>
#include <vector>

#include "dalembert/model/member.hpp"

namespace dalembert {

// Looked up once per type.
class NamingRows {
 public:
  // Rows that refer to items of one kind, in the order of the spec.
  const std::vector<const Row*>& of(const ItemType& type, ItemKind kind) {
    if (&type != last_type_) {  // items of one type mostly follow each other
      const auto [found, is_new] = known_.try_emplace(&type);
      if (is_new) list(type, found->second);
      last_type_ = &type;
      last_ = &found->second;
    }
    return (*last_)[static_cast<std::size_t>(kind)];
  }

 private:
  using ByKind = std::array<std::vector<const Row*>, item_kinds>;

  static void list(const ItemType& type, ByKind& rows) {
    for (const Row& row : type.rows) {
      const IndexStorage storage = index_storage(row.storage);
      if (storage.is_index && row.role == Role::parameter) rows[static_cast<std::size_t>(storage.kind)].push_back(&row);
    }
  }

  std::unordered_map<const ItemType*, ByKind> known_;
  const ItemType* last_type_ = nullptr;
  const ByKind* last_ = nullptr;
};

}  // namespace dalembert
