// A list whose copies share its entries until one of them is edited: records of items are copied at each change of a parameter, also those
// with matrices of a million entries.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace dalembert {

template <class T>
class SharedList {
 public:
  SharedList() = default;
  SharedList(std::vector<T> list) : list_(list.empty() ? nullptr : std::make_shared<std::vector<T>>(std::move(list))) {}
  SharedList(std::initializer_list<T> list) : SharedList(std::vector<T>(list)) {}

  operator const std::vector<T>&() const { return list_ ? *list_ : none; }
  bool empty() const { return size() == 0; }
  std::size_t size() const { return list_ ? list_->size() : 0; }
  const T* data() const { return list_ ? list_->data() : nullptr; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size(); }
  const T& operator[](std::size_t i) const { return (*list_)[i]; }
  const T& back() const { return list_->back(); }

  // The entries of this list.
  std::vector<T>& edit() {
    if (!list_)
      list_ = std::make_shared<std::vector<T>>();
    else if (list_.use_count() > 1)
      list_ = std::make_shared<std::vector<T>>(*list_);
    return *list_;
  }
  // True: both have the same entries in the same memory. False: they may still be equal.
  bool shares_with(const SharedList& other) const { return list_ == other.list_; }

 private:
  static inline const std::vector<T> none{};
  std::shared_ptr<std::vector<T>> list_;
};

}  // namespace dalembert
