// Memory for many numbers that are written once: large blocks request pages of two megabytes from the system. A page
// is created at its first use, and creating many small ones takes longer than filling them.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace dalembert {

// The first byte begins a line of the cache.
void* allocate_large(std::size_t bytes);
void release_large(void* memory, std::size_t bytes);

// Elements are not initialized.
template <class T>
struct LargeAllocator {
  using value_type = T;

  LargeAllocator() = default;
  template <class U>
  LargeAllocator(const LargeAllocator<U>&) {}

  T* allocate(std::size_t count) { return static_cast<T*>(allocate_large(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) { release_large(memory, count * sizeof(T)); }
  template <class U, class... Values>
  void construct(U* place, Values&&... values) {
    if constexpr (sizeof...(Values) > 0 || !std::is_trivially_default_constructible_v<U>)
      ::new (static_cast<void*>(place)) U(std::forward<Values>(values)...);
  }
  bool operator==(const LargeAllocator&) const = default;
};

template <class T>
using LargeVector = std::vector<T, LargeAllocator<T>>;

}  // namespace dalembert
