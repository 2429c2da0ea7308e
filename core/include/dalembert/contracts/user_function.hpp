// A user function takes and gives doubles. Recorded functions have derivatives; those of other functions are differences.
// Both are found argument by argument, and only for those arguments that move.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "dalembert/contracts/context.hpp"
#include "dalembert/math/dual.hpp"
#include "dalembert/math/fixed.hpp"
#include "dalembert/math/traced.hpp"

namespace dalembert {

// Arguments of one call as a flat list, with their shapes. At most `Capacity` numbers.
template <class S, int Capacity>
class CallArguments {
 public:
  CallArguments& scalar(const S& x) {
    shapes_[count_++] = {size_, 0, 0};
    values_[size_++] = x;
    return *this;
  }
  template <class T, int N>
  CallArguments& vector(const Vec<T, N>& x) {
    shapes_[count_++] = {size_, N, 0};
    for (int i = 0; i < N; ++i) values_[size_++] = S(x[i]);
    return *this;
  }
  template <class T, int R, int C>
  CallArguments& matrix(const Mat<T, R, C>& x) {
    shapes_[count_++] = {size_, R, C};
    for (int i = 0; i < R * C; ++i) values_[size_++] = S(x.x[i]);
    return *this;
  }

  // Calls with the given numbers in place of the arguments' values.
  void call(const UserFunction& f, const Context& c, const double* numbers, std::span<double> results) const {
    std::array<Argument, most_arguments> arguments;
    f.callback->call(c.time, c.item, described(arguments, numbers), results);
  }
  // Variant that returns the results of the last call if nothing has changed since.
  void recall(const UserFunction& f, const Context& c, const double* numbers, std::span<double> results) const {
    std::array<Argument, most_arguments> arguments;
    f.callback->recall(c.time, c.item, described(arguments, numbers), results);
  }
  bool derivative(const UserFunction& f, const Context& c, const double* numbers, int number, std::span<double> results) const {
    std::array<Argument, most_arguments> arguments;
    return f.callback->derivative(c.time, c.item, described(arguments, numbers), number, results);
  }

  // The arguments as a callback takes them, over their own numbers (S is double) or over given ones.
  void describe(std::span<Argument> arguments) const
    requires std::is_same_v<S, double>
  {
    describe(arguments, values_.data());
  }
  void describe(std::span<Argument> arguments, const double* numbers) const {
    for (int i = 0; i < count_; ++i)
      arguments[static_cast<std::size_t>(i)] = {numbers + shapes_[i].start, shapes_[i].rows, shapes_[i].columns};
  }

  int size() const { return size_; }
  const S& operator[](int i) const { return values_[i]; }

 private:
  static constexpr std::size_t most_arguments = std::min(Capacity, 16);  // every argument has at least one number

  std::span<const Argument> described(std::span<Argument> arguments, const double* numbers) const {
    describe(arguments, numbers);
    return arguments.first(static_cast<std::size_t>(count_));
  }

  struct Shape {
    int start = 0, rows = 0, columns = 0;
  };
  std::array<S, Capacity> values_{};
  std::array<Shape, most_arguments> shapes_{};
  int size_ = 0, count_ = 0;
};

template <int Results, int Capacity>
Vec<double, Results> evaluate(const UserFunction& f, const Context& c, const CallArguments<double, Capacity>& arguments) {
  Vec<double, Results> r;
  arguments.call(f, c, &arguments[0], r.x);
  return r;
}

template <int Results, int Capacity, int N, class T>
Vec<Dual<N, T>, Results> evaluate(const UserFunction& f, const Context& c,
                                  const CallArguments<Dual<N, T>, Capacity>& arguments) {
  std::array<double, Capacity> numbers{};
  for (int i = 0; i < arguments.size(); ++i) numbers[i] = value_of(arguments[i]);
  Vec<double, Results> at, slopes;
  c.same_state ? arguments.recall(f, c, numbers.data(), at.x) : arguments.call(f, c, numbers.data(), at.x);
  Vec<Dual<N, T>, Results> r;
  for (int k = 0; k < Results; ++k) r[k] = Dual<N, T>(at[k]);
  for (int i = 0; i < arguments.size(); ++i) {
    const auto& d = arguments[i].d;
    if (std::all_of(d.begin(), d.end(), [](const T& x) { return value_of(x) == 0; })) continue;
    if (!arguments.derivative(f, c, numbers.data(), i, slopes.x)) {
      const double x = numbers[i];
      numbers[i] = x + 1e-8 * std::max(1e-2, std::abs(x));
      arguments.call(f, c, numbers.data(), slopes.x);
      const double step = numbers[i] - x;  // as rounded
      numbers[i] = x;
      for (int k = 0; k < Results; ++k) slopes[k] = (slopes[k] - at[k]) / step;
    }
    for (int k = 0; k < Results; ++k)
      for (int j = 0; j < N; ++j) r[k].d[j] += slopes[k] * d[j];
  }
  return r;
}

// User functions cannot be traced: such traces are unusable.
template <int Results, int Capacity>
Vec<Traced, Results> evaluate(const UserFunction&, const Context&, const CallArguments<Traced, Capacity>&) {
  Vec<Traced, Results> unknown;
  unknown.x.fill(std::numeric_limits<double>::quiet_NaN());
  return unknown;
}

// The common case: all arguments scalar, one result.
template <class S, class... Rest>
S call_scalar(const UserFunction& f, const Context& c, const S& first, const Rest&... rest) {
  CallArguments<S, 1 + sizeof...(Rest)> arguments;
  arguments.scalar(first);
  (arguments.scalar(S(rest)), ...);
  return evaluate<1>(f, c, arguments)[0];
}

}  // namespace dalembert
