// Room for many numbers.
#pragma once

#include <cstddef>
#include <memory>

namespace dalembert {

// Numbers without values, in large memory (math/large_memory.hpp).
class NumberStorage {
 public:
  NumberStorage() : NumberStorage(0) {}
  explicit NumberStorage(std::size_t count);
  double* data() const { return numbers_.get(); }

 private:
  struct Release {
    std::size_t bytes;
    void operator()(double* numbers) const;
  };
  std::unique_ptr<double[], Release> numbers_;
};

}  // namespace dalembert
