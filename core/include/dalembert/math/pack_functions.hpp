// Sine and cosine of numbers side by side, to rounding: Taylor series within an eighth of a turn (the next terms are below 1e-17),
// after the nearest quarter turn has been taken off in three parts (W. J. Cody, W. Waite, Software Manual for the Elementary Functions, 1980).
#pragma once

#include <bit>
#include <cmath>

#include "dalembert/math/pack.hpp"

namespace dalembert {

template <int N>
struct SineCosine {
  Pack<N> sine, cosine;
};

// 1 - x^2 / (k (k + 1)) (1 - ...), from k on.
template <int k, int last, int N>
DALEMBERT_INLINE inline Pack<N> alternating_series(const Pack<N>& square) {
  constexpr double factor = 1.0 / (k * (k + 1.0));
  if constexpr (k == last) return 1.0 - factor * square.x;
  else return 1.0 - factor * (square.x * alternating_series<k + 2, last, N>(square).x);
}

template <int N>
DALEMBERT_INLINE inline SineCosine<N> sine_cosine(const Pack<N>& angle) {
  using Register = typename Pack<N>::Register;
  using Integers = typename Pack<N>::Mask;
  bool large = false;
  for (int lane = 0; lane < N; ++lane) large = large || !(std::abs(angle[lane]) < 1e5);
  if (large) [[unlikely]]
    return {Pack<N>::of_each([&angle](int lane) { return std::sin(angle[lane]); }),
            Pack<N>::of_each([&angle](int lane) { return std::cos(angle[lane]); })};
  constexpr double to_integer = 6755399441055744.0;  // 1.5 * 2^52: the last bits of a sum with it are an integer
  // Of a turn; products with the first two parts are exact.
  constexpr double quarter[] = {1.5707963267341256, 6.077100506303966e-11, 2.0222662487959506e-21};
  const Register shifted = angle.x * 0.6366197723675814 + to_integer, quarters = shifted - to_integer;
  const auto turns = std::bit_cast<Integers>(shifted);
  const Pack<N> x(((angle.x - quarters * quarter[0]) - quarters * quarter[1]) - quarters * quarter[2]), square = x * x;
  const Pack<N> sine = x * alternating_series<2, 16, N>(square), cosine = alternating_series<1, 17, N>(square);
  const Integers is_odd = (turns & 1) != 0, turns_sine = (turns & 2) != 0, turns_cosine = ((turns + 1) & 2) != 0;
  const Register s = is_odd ? cosine.x : sine.x, c = is_odd ? sine.x : cosine.x;
  return {Pack<N>(turns_sine ? -s : s), Pack<N>(turns_cosine ? -c : c)};
}

}  // namespace dalembert
