// A user function takes and gives doubles. Recorded functions have derivatives; those of other functions are differences.
// Both are found only for those arguments that move.
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
  void linearize(const UserFunction& f, const Context& c, const double* numbers, std::span<const int> moving,
                 std::span<double> results, std::span<double> slopes) const {
    std::array<Argument, most_arguments> arguments;
    f.callback->linearize(c.time, c.item, described(arguments, numbers), moving, results, slopes);
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

inline bool all_finite(std::span<const double> numbers) {
  return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
}

template <int Results, int Capacity>
Vec<double, Results> evaluate(const UserFunction& f, const Context& c,
                              const CallArguments<double, Capacity>& arguments) {
  Vec<double, Results> r;
  c.same_state ? arguments.recall(f, c, &arguments[0], r.x) : arguments.call(f, c, &arguments[0], r.x);
  return r;
}

template <int Results, int Capacity, int N, class T>
Vec<Dual<N, T>, Results> evaluate(const UserFunction& f, const Context& c,
                                  const CallArguments<Dual<N, T>, Capacity>& arguments) {
  std::array<double, Capacity> numbers;
  std::array<int, Capacity> moving;
  std::size_t count = 0;
  for (int i = 0; i < arguments.size(); ++i) {
    const auto& d = arguments[i].d;
    numbers[i] = value_of(arguments[i]);
    if (std::any_of(d.begin(), d.end(), [](const T& x) { return value_of(x) != 0; })) moving[count++] = i;
  }
  Vec<double, Results> at;
  std::array<double, Capacity * Results> slopes;
  const bool exact = f.callback->has_derivatives();
  if (exact)
    arguments.linearize(f, c, numbers.data(), std::span(moving).first(count), at.x,
                        std::span(slopes).first(count * Results));
  else
    c.same_state ? arguments.recall(f, c, numbers.data(), at.x) : arguments.call(f, c, numbers.data(), at.x);
  Vec<Dual<N, T>, Results> r;
  for (int k = 0; k < Results; ++k) r[k] = Dual<N, T>(at[k]);
  for (std::size_t m = 0; m < count; ++m) {
    const int i = moving[m];
    const std::span<double> slope = std::span(slopes).subspan(m * Results, Results);
    if (!exact || !all_finite(slope)) {
      const double x = numbers[i];
      numbers[i] = x + 1e-8 * std::max(1e-2, std::abs(x));
      arguments.call(f, c, numbers.data(), slope);
      const double step = numbers[i] - x;  // as rounded
      numbers[i] = x;
      for (int k = 0; k < Results; ++k) slope[k] = (slope[k] - at[k]) / step;
    }
    for (int k = 0; k < Results; ++k)
      for (int j = 0; j < N; ++j) r[k].d[j] += slope[k] * arguments[i].d[j];
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
