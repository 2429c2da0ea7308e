// Calls of user functions that are plain C functions. Their parameters follow from the signature in the spec: a number is a
// double, an integer or a truth value an int64_t; a vector or a matrix, row by row, is a const double*, followed by the number
// of its entries, an int64_t, if that is known at run time only. One number is returned; vectors and matrices are written to
// a last parameter, double* result.
#pragma once

#include <cstdint>
#include <tuple>
#include <utility>

#include "dalembert/reflection/callback.hpp"
#include "dalembert/reflection/row.hpp"

namespace dalembert {

// Parameter types of the C function for an argument.
template <Signature::Kind K>
auto c_parameters(const Argument& argument) {
  using Kind = Signature::Kind;
  if constexpr (K == Kind::scalar) {
    return std::tuple(*argument.data);
  } else if constexpr (K == Kind::integer || K == Kind::boolean) {
    return std::tuple(static_cast<std::int64_t>(*argument.data));
  } else if constexpr (Signature::is_open(K)) {
    return std::tuple(argument.data, static_cast<std::int64_t>(argument.size()));
  } else {
    static_assert(K == Kind::vector || K == Kind::matrix, "no C function can take this");
    return std::tuple(argument.data);
  }
}

template <bool Takes, class T>
auto if_taken(T value) {
  if constexpr (Takes) {
    return std::tuple(value);
  } else {
    return std::tuple<>();
  }
}

template <class Result, class... Parameters>
Result call_c(const void* function, Parameters... parameters) {
  return reinterpret_cast<Result (*)(Parameters...)>(const_cast<void*>(function))(parameters...);
}

// A CompiledCall; `Arguments` is the array of kinds of the signature.
template <const auto& Arguments, bool TakesTime, bool TakesItem, Signature::Kind Result>
void compiled_call(const void* function, double time, int item, std::span<const Argument> arguments,
                   std::span<double> results) {
  const auto parameters = [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::tuple_cat(if_taken<TakesTime>(time), if_taken<TakesItem>(static_cast<std::int64_t>(item)),
                          c_parameters<Arguments[I]>(arguments[I])...);
  }(std::make_index_sequence<Arguments.size()>());
  std::apply(
      [&](auto... x) {
        if constexpr (Result == Signature::Kind::scalar) {
          results[0] = call_c<double>(function, x...);
        } else if constexpr (Signature::is_open(Result)) {
          call_c<void>(function, x..., results.data(), static_cast<std::int64_t>(results.size()));
        } else {
          call_c<void>(function, x..., results.data());
        }
      },
      parameters);
}

}  // namespace dalembert
