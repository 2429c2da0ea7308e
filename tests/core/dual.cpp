// The example of math/dual.hpp: the numbers of its comments, and the closed form of the stiffness of a spring.
#include "dalembert/math/dual.hpp"

using namespace dalembert;

namespace {

constexpr double rounding = 1e-14;  // numbers up to 10, after a few operations

bool differs(double a, double b) { return !(std::abs(a - b) < rounding * 10); }
template <int N>
int failures_of(const Dual<N>& found, double value, const std::array<double, N>& d) {
  int failures = differs(found.value, value);
  for (int i = 0; i < N; ++i) failures += differs(found.d[i], d[i]);
  return failures;
}

int spring() {
  using S = Dual<2>;
  const S x0 = S::seed(3, 0), x1 = S::seed(4, 1);
  const S l = sqrt(x0 * x0 + x1 * x1);
  const S t = 10 * (l - 4);
  const S f0 = t / l * x0, f1 = t / l * x1;
  int failures = failures_of<2>(l, 5, {0.6, 0.8}) + failures_of<2>(t, 10, {6, 8});
  failures += failures_of<2>(f0, 6, {4.88, 3.84}) + failures_of<2>(f1, 8, {3.84, 7.12});
  const double n[] = {0.6, 0.8}, k = 10, geometric = 10.0 / 5;
  for (int j = 0; j < 2; ++j) {
    failures += differs(f0.d[j], k * n[0] * n[j] + geometric * ((j == 0) - n[0] * n[j]));
    failures += differs(f1.d[j], k * n[1] * n[j] + geometric * ((j == 1) - n[1] * n[j]));
  }
  return failures;
}

// x^3 at 2, twice differentiated: 8, 12, 12.
int second_derivative() {
  using Once = Dual<1>;
  using Twice = Dual<1, Once>;
  const Twice x = Twice::seed(Once::seed(2, 0), 0), cube = x * x * x;
  return differs(cube.value.value, 8) + differs(cube.value.d[0], 12) + differs(cube.d[0].value, 12) +
         differs(cube.d[0].d[0], 12);
}

// A comparison takes the branch of the value; constants have no derivatives.
int branches_and_constants() {
  using S = Dual<1>;
  return failures_of<1>(abs(S::seed(-2, 0)), 2, {-1}) + failures_of<1>(S(3), 3, {0});
}

}  // namespace

int main() { return spring() + second_derivative() + branches_and_constants(); }
