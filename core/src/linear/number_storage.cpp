#include "number_storage.hpp"

#include "dalembert/math/large_memory.hpp"

namespace dalembert {

NumberStorage::NumberStorage(std::size_t count)
    : numbers_(static_cast<double*>(allocate_large(count * sizeof(double))), Release{count * sizeof(double)}) {}

void NumberStorage::Release::operator()(double* numbers) const { release_large(numbers, bytes); }

}  // namespace dalembert
