// Each of the numbers side by side gets what it gets alone; they find the way from their places in memory and back.
#include <array>
#include <cmath>
#include <cstdio>

#include "dalembert/batches/groups.hpp"
#include "dalembert/math/pack.hpp"

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
  for (int lane = 0; lane < N; ++lane) failures += !(std::abs(c[lane] - formula(a[lane], b[lane])) < 1e-14 * std::abs(c[lane]));
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

template <int N>
int failures_of() {
  int failures = arithmetic_differs<N>();
  for (int count = 1; count <= N; ++count) failures += memory_differs<N, 3>(count) + memory_differs<N, 4>(count) + memory_differs<N, 6>(count) + memory_differs<N, 9>(count);
  if (failures > 0) std::printf("%d lanes: %d failures\n", N, failures);
  return failures;
}

}  // namespace

int main() { return failures_of<2>() + failures_of<4>() + failures_of<8>(); }
