// Room for many numbers.
#pragma once

#include <cstddef>
#include <memory>

namespace dalembert {

// Numbers without values; the first one begins a line of the cache. Of large storage the system is asked to make pages of two
// megabytes, if it can: a page is made when it is touched for the first time, and making many small ones would take longer than the
// factorization that fills them.
class NumberStorage {
 public:
  NumberStorage() : NumberStorage(0) {}
  explicit NumberStorage(std::size_t count);
  double* data() const { return numbers_.get(); }

 private:
  struct Release {
    std::size_t alignment;
    void operator()(double* numbers) const;
  };
  std::unique_ptr<double[], Release> numbers_;
};

}  // namespace dalembert
