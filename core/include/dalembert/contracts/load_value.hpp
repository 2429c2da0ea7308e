// The value of a load at a time: its parameter, or the result of its user function.
#pragma once

#include "dalembert/contracts/user_function.hpp"

namespace dalembert {

template <int N>
Vec<double, N> called_load_value(const UserFunction& f, const Context& c, const Vec<double, N>& parameter) {
  CallArguments<double, N> arguments;
  if constexpr (N == 1) {
    arguments.scalar(parameter[0]);
  } else {
    arguments.vector(parameter);
  }
  return evaluate<N>(f, c, arguments);
}
template <int N>
Vec<double, N> load_value(const UserFunction& f, const Context& c, const Vec<double, N>& parameter) {
  return f ? called_load_value(f, c, parameter) : parameter;
}

// User functions know the load factor of a static solution from time; parameters are scaled by it.
inline double load_factor(const UserFunction& f, const Context& c) { return f ? 1.0 : c.load_factor; }

}  // namespace dalembert
