// Arguments of a kernel besides its parameters and coordinates.
#pragma once

#include "dalembert/reflection/callback.hpp"
#include "dalembert/reflection/storage.hpp"
#include "dalembert/system/evaluation.hpp"

namespace dalembert {

struct Context {
  double time = 0;
  int item = -1;
  double load_factor = 1;
  double step_size = 0;
  const double* data = nullptr;  // the item's data coordinates; null: none
  int data_count = 0;
  bool same_state = false;  // same state as in the previous evaluation: user functions need not be called again

  template <class S>
  static Context of(const EvaluationOf<S>& e, int item, int first_data = -1, int data_count = 0) {
    return {e.time,     item,        e.load_factor, e.step_size, first_data < 0 ? nullptr : e.data + first_data,
            data_count, e.same_state};
  }
};

// Specs declare whether an item can be switched off.
bool is_active(const auto& parameters) {
  if constexpr (requires { parameters.activeConnector; }) return parameters.activeConnector;
  return true;
}

}  // namespace dalembert
