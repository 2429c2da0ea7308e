// Loads: kernels that put a force on one marker. Their value in time comes from the kernel's `value`. A kernel may have a
// variant `BodyFixed` that reads more of the marker than the plain one.
#pragma once

#include "dalembert/batches/connector.hpp"

namespace dalembert {

template <class K, class Record>
struct LoadPhysicsOf final : LoadPhysics {
  static_assert(LoadKernel<K>);

  bool body_fixed(const void* record) const override {
    if constexpr (has_follower)
      return K::BodyFixed::applies(static_cast<const Record*>(record)->parameters);
    else
      return false;
  }
  std::unique_ptr<Term> make_batch(bool body_fixed) const override {
    if constexpr (has_follower)
      if (body_fixed) return std::make_unique<PortBatch<typename K::BodyFixed, Record, 1>>();
    return std::make_unique<PortBatch<K, Record, 1>>();
  }
  std::vector<double> values(const void* record, double time) const override {
    const auto v = K::value(static_cast<const Record*>(record)->parameters, Context{.time = time});
    return {v.x.begin(), v.x.end()};
  }

 private:
  static constexpr bool has_follower = !std::is_void_v<typename K::BodyFixed>;
};

}  // namespace dalembert
