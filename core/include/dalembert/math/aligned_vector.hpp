// Vectors that begin with a cache line: numbers that are read four at a time do not lie astride of two lines. Large ones lie in large pages.
#pragma once

#include <cstddef>
#include <vector>

#include "dalembert/math/large_memory.hpp"

namespace dalembert {

template <class T>
struct CacheLineAllocator {
  using value_type = T;

  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}

  T* allocate(std::size_t count) { return static_cast<T*>(allocate_large(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) { release_large(memory, count * sizeof(T)); }
  bool operator==(const CacheLineAllocator&) const = default;
};

template <class T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

}  // namespace dalembert
