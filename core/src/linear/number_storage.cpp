#include "number_storage.hpp"

#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace dalembert {

namespace {

constexpr std::size_t line = 64, large_page = std::size_t{1} << 21;
constexpr std::size_t large = 2 * large_page;

// Advice that may be ignored. What does not fill a large page stays in small ones.
void prefer_large_pages([[maybe_unused]] void* start, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  madvise(start, bytes / large_page * large_page, MADV_HUGEPAGE);
#endif
}

}  // namespace

NumberStorage::NumberStorage(std::size_t count) : numbers_(nullptr, Release{}) {
  const std::size_t bytes = count * sizeof(double), alignment = bytes < large ? line : large_page;
  void* start = ::operator new(bytes, std::align_val_t(alignment));
  numbers_ = std::unique_ptr<double[], Release>(static_cast<double*>(start), Release{alignment});
  if (alignment == large_page) prefer_large_pages(start, bytes);
}

void NumberStorage::Release::operator()(double* numbers) const { ::operator delete(numbers, std::align_val_t(alignment)); }

}  // namespace dalembert
