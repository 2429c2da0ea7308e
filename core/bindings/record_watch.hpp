// Detects changed items of a model. Their records are replaced, never changed in place.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "dalembert/model/model.hpp"

namespace dalembert {

class RecordWatch {
 public:
  // Whether items have come, gone or other records since the last call; renewed(kind, number, item) is called for each that was not there so.
  template <class Renewed>
  bool look(const Model& model, Renewed&& renewed) {
    if (model.record_changes() == changes_) return false;
    changes_ = model.record_changes();
    bool result = false;
    for (int k = 0; k < item_kinds; ++k) {
      const auto kind = static_cast<ItemKind>(k);
      auto& known = records_[static_cast<std::size_t>(k)];
      const auto count = static_cast<std::size_t>(model.count(kind));
      result = result || known.size() != count;
      known.resize(count);
      for (std::size_t i = 0; i < count; ++i) {
        const Item& item = model.item(kind, static_cast<int>(i));
        if (known[i] == item.record) continue;
        known[i] = item.record;
        renewed(kind, static_cast<int>(i), item);
        result = true;
      }
    }
    return result;
  }
  bool look(const Model& model) {
    return look(model, [](ItemKind, int, const Item&) {});
  }

 private:
  std::array<std::vector<std::shared_ptr<const void>>, item_kinds> records_;
  std::uint64_t changes_ = ~std::uint64_t{0};
};

}  // namespace dalembert
