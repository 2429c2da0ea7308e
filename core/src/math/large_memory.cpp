#include "dalembert/math/large_memory.hpp"

#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace dalembert {
namespace {

constexpr std::size_t line = 64, large_page = std::size_t{1} << 21;
constexpr std::size_t large = 2 * large_page;

std::align_val_t alignment(std::size_t bytes) { return std::align_val_t(bytes < large ? line : large_page); }

// Advice that the system may ignore. Remainders of less than a large page stay in small ones.
void prefer_large_pages([[maybe_unused]] void* start, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  madvise(start, bytes / large_page * large_page, MADV_HUGEPAGE);
#endif
}

}  // namespace

void* allocate_large(std::size_t bytes) {
  void* start = ::operator new(bytes, alignment(bytes));
  if (bytes >= large) prefer_large_pages(start, bytes);
  return start;
}

void release_large(void* memory, std::size_t bytes) { ::operator delete(memory, alignment(bytes)); }

}  // namespace dalembert
