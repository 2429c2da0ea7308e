// User functions of whole coordinate vectors, for items of run-time size.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <type_traits>
#include <vector>

#include "dalembert/contracts/context.hpp"
#include "dalembert/contracts/user_function.hpp"
#include "dalembert/math/dual.hpp"
#include "dalembert/reflection/callback.hpp"

namespace dalembert {

inline Argument as_argument(const std::vector<double>& x) { return {x.data(), static_cast<int>(x.size()), 0}; }

// matrix(i, j) += factor * d f_i / d x_j for all x_j, row by row. `at` is f(x), `evaluate(f)` reads x, which is left as it was.
// `derivative(j, f)` gives df/dx_j or returns false; forward differences are used then.
template <class Evaluate, class Derivative>
void add_derivatives(std::vector<double>& x, double factor, std::span<const double> at, std::span<double> matrix,
                     Evaluate&& evaluate, Derivative&& derivative) {
  if (factor == 0 || x.empty()) return;
  const std::size_t columns = x.size();
  std::vector<double> slopes(at.size());
  for (std::size_t j = 0; j < columns; ++j) {
    if (!derivative(static_cast<int>(j), std::span(slopes))) {
      const double here = x[j];
      x[j] = here + 1e-7 * std::max(1e-2, std::abs(here));
      const double step = x[j] - here;  // as rounded
      evaluate(std::span(slopes));
      x[j] = here;
      for (std::size_t i = 0; i < slopes.size(); ++i) slopes[i] = (slopes[i] - at[i]) / step;
    }
    for (std::size_t i = 0; i < slopes.size(); ++i) matrix[i * columns + j] += factor * slopes[i];
  }
}

// A function of vectors that returns a vector. Dual numbers: derivatives of recorded functions are exact, those of other
// functions are forward differences; both only for components that move.
template <class S>
std::vector<S> call_with_vectors(const UserFunction& f, const Context& c,
                                 std::initializer_list<std::span<const S>> vectors, std::size_t size) {
  std::vector<S> x;
  for (const auto& vector : vectors) x.insert(x.end(), vector.begin(), vector.end());
  std::vector<double> numbers(x.size()), results(size);
  std::ranges::transform(x, numbers.begin(), [](const S& number) { return value_of(number); });
  std::vector<Argument> arguments;
  const double* first = numbers.data();
  for (const auto& vector : vectors) {
    arguments.push_back({first, static_cast<int>(vector.size()), 0});
    first += vector.size();
  }
  if constexpr (std::is_same_v<S, double>) {
    f.callback->call(c.time, c.item, arguments, results);
    return results;
  } else {
    std::vector<int> moving;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (std::ranges::any_of(x[i].d, [](const auto& d) { return value_of(d) != 0; }))
        moving.push_back(static_cast<int>(i));
    std::vector<double> slopes(moving.size() * size);
    const bool exact = f.callback->has_derivatives();
    if (exact)
      f.callback->linearize(c.time, c.item, arguments, moving, results, slopes);
    else
      c.same_state ? f.callback->recall(c.time, c.item, arguments, results)
                   : f.callback->call(c.time, c.item, arguments, results);
    std::vector<S> r(results.begin(), results.end());
    for (std::size_t m = 0; m < moving.size(); ++m) {
      const auto i = static_cast<std::size_t>(moving[m]);
      const std::span<double> slope = std::span(slopes).subspan(m * size, size);
      if (!exact || !all_finite(slope)) {
        const double here = numbers[i];
        numbers[i] = here + 1e-8 * std::max(1e-2, std::abs(here));
        const double step = numbers[i] - here;  // as rounded
        f.callback->call(c.time, c.item, arguments, slope);
        numbers[i] = here;
        for (std::size_t k = 0; k < size; ++k) slope[k] = (slope[k] - results[k]) / step;
      }
      for (std::size_t k = 0; k < size; ++k) r[k] += slope[k] * (x[i] - numbers[i]);
    }
    return r;
  }
}

}  // namespace dalembert
