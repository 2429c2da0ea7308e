// Lookup of batches during assembly, by common properties of their entries.
#pragma once

#include <compare>
#include <map>
#include <memory>
#include <vector>

#include "dalembert/reflection/item_type.hpp"
#include "dalembert/system/term.hpp"

namespace dalembert {

struct BatchKey {
  int region = 0;
  // The type of the items or its substitute, the type of their carrier, and the types of its nodes.
  std::vector<const void*> types;
  auto operator<=>(const BatchKey&) const = default;
};

template <class B>
struct GrowingBatch {
  B* batch = nullptr;
  int entries = 0;
  int region = 0;  // region that contains all of its entries
  bool acts = false;  // an entry has coordinates or markers
};

template <class B>
class BatchTable {
 public:
  // The batches themselves go to `batches`.
  explicit BatchTable(std::vector<std::unique_ptr<B>>& batches) : batches_(batches) {}

  // `make` gives the batch when the first of its entries comes.
  template <class Make>
  GrowingBatch<B>& find(const BatchKey& key, Make&& make) {
    if (last_ != table_.end() && last_->first == key) return last_->second;  // neighbours mostly have the same key
    last_ = table_.find(key);
    if (last_ != table_.end()) return last_->second;
    batches_.push_back(make());
    last_ = table_.emplace(key, GrowingBatch<B>{batches_.back().get(), 0, key.region}).first;
    in_order_.push_back(&last_->second);
    return last_->second;
  }

  // In the order of the batches.
  const std::vector<GrowingBatch<B>*>& in_order() const { return in_order_; }

 private:
  std::vector<std::unique_ptr<B>>& batches_;
  std::map<BatchKey, GrowingBatch<B>> table_;
  std::vector<GrowingBatch<B>*> in_order_;
  typename std::map<BatchKey, GrowingBatch<B>>::iterator last_ = table_.end();
};

}  // namespace dalembert
