// Numbers in lanes get the same results as alone; they find the way from their places in memory and back.
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>

#include "dalembert/batches/groups.hpp"
#include "dalembert/math/pack.hpp"
#include "dalembert/math/pack_functions.hpp"
#include "dalembert/math/rotations.hpp"
#include "dalembert/math/wide_registers.hpp"

using namespace dalembert;

namespace {

template <class S>
S formula(const S& a, const S& b) {
  using std::sqrt;
  S c = 2.0 * a - b / (a + 0.5);
  c += sqrt(a) * (1.0 / b);
  c -= -b;
  c *= a;
  return c;
}

template <int N>
int arithmetic_differs() {
  const auto a = Pack<N>::of_each([](int lane) { return 1.0 + lane; });
  const auto b = Pack<N>::of_each([](int lane) { return 0.3 * lane - 4; });
  const Pack<N> c = formula(a, b);
  int failures = 0;
  for (int lane = 0; lane < N; ++lane)
    failures += !(std::abs(c[lane] - formula(a[lane], b[lane])) < 1e-14 * std::abs(c[lane]));
  return failures;
}

// `Count` numbers of each lane. Places overlap, as those of elements with a common node do; lanes beyond `count` leave nothing.
template <int N, int Count>
int memory_differs(int count) {
  std::array<double, (Count + 3) * N> from, to{}, expected{};
  for (std::size_t i = 0; i < from.size(); ++i) from[i] = 0.5 + static_cast<double>(i);
  std::array<const double*, N> sources;
  std::array<double*, N> targets;
  for (int lane = 0; lane < N; ++lane) {
    sources[lane] = &from[3 * lane];
    targets[lane] = &to[2 * lane];
  }
  const auto numbers = gathered<Count>(sources);
  add_numbers(numbers, targets, count);
  int failures = 0;
  for (int lane = 0; lane < N; ++lane)
    for (int j = 0; j < Count; ++j) {
      failures += numbers[j][lane] != from[3 * lane + j];
      if (j < 4 && Count >= 4) failures += gather_fours<N>(sources)[j][lane] != numbers[j][lane];
      if (lane < count) expected[2 * lane + j] += from[3 * lane + j];
    }
  return failures + (to != expected);
}

// Agreement is to rounding, independently of other lanes: a few angles that the library is asked for are among those of polynomials.
template <int N>
int functions_differ() {
  int failures = 0;
  const auto differs = [](double a, double b) { return !(std::abs(a - b) <= 4e-16 * std::abs(b)); };
  const auto twin = [](auto x) { return x; };
  for (int k = -4000; k <= 4000; ++k) {
    const auto angle =
        Pack<N>::of_each([k](int lane) { return lane == 1 && k % 7 == 0 ? 1e7 : 0.0031 * k + 0.0007 * lane; });
    const auto [sine, cosine] = sine_cosine(angle);
    const Pack<N> found = angle_of(Pack<N>(2.5 * sine), Pack<N>(2.5 * cosine));
    for (int lane = 0; lane < N; ++lane) {
      failures += !(std::abs(sine[lane] - std::sin(angle[lane])) < 3e-16) ||
                  !(std::abs(cosine[lane] - std::cos(angle[lane])) < 3e-16);
      failures += differs(found[lane], std::atan2(2.5 * sine[lane], 2.5 * cosine[lane]));
      const auto alone = sine_cosine(twin(Pack<N>(angle[lane])));
      failures += alone.sine[0] != sine[lane] || alone.cosine[0] != cosine[lane];
    }
    Pack<N> terms[3];
    RodriguesSeries::terms(Pack<N>(angle * angle), terms[0], terms[1], terms[2]);
    for (int lane = 0; lane < N; ++lane) {
      double one[3];
      RodriguesSeries::terms(angle[lane] * angle[lane], one[0], one[1], one[2]);
      for (int i = 0; i < 3; ++i)
        failures += !(std::abs(terms[i][lane] - one[i]) <
                      1e-12 * (1e-3 + std::abs(one[i])));  // 1 - sine/angle loses three digits
    }
  }
  failures += angle_of(Pack<N>(0.0), Pack<N>(0.0))[0] != 0;
  return failures;
}

// Numbers that compare in ways of their own, each with each.
template <int N>
int choices_differ() {
  using Limits = std::numeric_limits<double>;
  constexpr std::array all{-0.0, 0.0,  Limits::quiet_NaN(), Limits::denorm_min(),
                           1.0,  -1.0, Limits::infinity(),  -Limits::infinity()};
  const auto from = [&](std::size_t first) {
    return Pack<N>::of_each([&](int lane) { return all[(first + static_cast<std::size_t>(lane)) % all.size()]; });
  };
  const Pack<N> yes(1.0), no(0.0);
  int failures = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < all.size(); ++j) {
      const Pack<N> a = from(i), b = from(j), is_less = Pack<N>::chosen(less(a, b), yes, no),
                    is_equal = Pack<N>::chosen(equal(a, b), yes, no);
      double any_less = 0;
      for (int lane = 0; lane < N; ++lane) {
        failures += is_less[lane] != (a[lane] < b[lane] ? 1 : 0) || is_equal[lane] != (a[lane] == b[lane] ? 1 : 0);
        failures += std::bit_cast<long long>(larger(a, b)[lane]) !=
                    std::bit_cast<long long>(a[lane] > b[lane] ? a[lane] : b[lane]);
        any_less += is_less[lane];
      }
      failures += Pack<N>::is_none(less(a, b)) != (any_less == 0);
    }
    for (int at = 0; at < N; ++at)
      failures += is_zero(Pack<N>::of_each([&](int lane) { return lane == at ? all[i] : -0.0; })) != (all[i] == 0);
  }
  return failures;
}

template <int N>
int failures_of() {
  int failures = arithmetic_differs<N>() + functions_differ<N>() + choices_differ<N>();
  for (int count = 1; count <= N; ++count)
    failures += memory_differs<N, 3>(count) + memory_differs<N, 4>(count) + memory_differs<N, 6>(count) +
                memory_differs<N, 9>(count);
  if (failures > 0) std::printf("%d lanes: %d failures\n", N, failures);
  return failures;
}

}  // namespace

int main() {
  int in_registers = 0;
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
    run_in_widest_registers([&in_registers] { in_registers = choices_differ<8>(); });
#endif
  return failures_of<2>() + failures_of<4>() + failures_of<8>() + in_registers;
}
