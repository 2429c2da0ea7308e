#include "dalembert/contact/planar_cable.hpp"

#include <algorithm>
#include <cmath>

namespace dalembert {
namespace {

double value_at(std::span<const double> polynomial, double x) {
  double value = 0;
  for (std::size_t i = polynomial.size(); i-- > 0;) value = value * x + polynomial[i];
  return value;
}

// Zero between two points of different sign, by Newton's method with bisection.
double zero_between(std::span<const double> p, std::span<const double> slope, double a, double b) {
  const bool rises = value_at(p, b) > 0;
  double x = 0.5 * (a + b);
  for (int i = 0; i < 100; ++i) {
    const double value = value_at(p, x), rate = value_at(slope, x);
    if (value == 0) return x;
    ((value > 0) == rises ? b : a) = x;
    double next = rate != 0 ? x - value / rate : a;
    if (!(next > a && next < b)) next = 0.5 * (a + b);
    if (next == x || b - a <= 4e-16 * (std::abs(a) + std::abs(b))) return next;
    x = next;
  }
  return x;
}

}  // namespace

std::array<double, 8> CableShape::numbers(const double* of_all) const {
  std::array<double, 8> q{};
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = of_all[dofs[i]];
  return q;
}

std::array<std::array<double, 4>, 2> CableShape::polynomials(const std::array<double, 8>& q) const {
  std::array<std::array<double, 4>, 2> result{};
  const double l = length;
  for (std::size_t i = 0; i < 2; ++i) {
    const double chord = q[i + 4] - q[i], s0 = q[i + 2], s1 = q[i + 6];
    result[i] = {q[i], s0, (3 * chord / l - 2 * s0 - s1) / l, (s0 + s1 - 2 * chord / l) / (l * l)};
  }
  return result;
}

// Zeros of the derivative part the range where the polynomial is monotonous.
int real_zeros(std::span<const double> polynomial, double from, double to, std::array<double, 6>& zeros) {
  if (polynomial.size() < 2) return 0;
  std::array<double, 6> slope{};
  const std::size_t degree = polynomial.size() - 1;
  for (std::size_t i = 0; i < degree; ++i) slope[i] = static_cast<double>(i + 1) * polynomial[i + 1];
  const std::span<const double> derivative(slope.data(), degree);
  std::array<double, 6> turns{};
  const int n = real_zeros(derivative, from, to, turns);
  int count = 0;
  double begin = from;
  for (int i = 0; i <= n; ++i) {
    const double end = i < n ? turns[static_cast<std::size_t>(i)] : to;
    const double a = value_at(polynomial, begin), b = value_at(polynomial, end);
    if ((a < 0) != (b < 0) && end > begin && count < 6)
      zeros[static_cast<std::size_t>(count++)] = zero_between(polynomial, derivative, begin, end);
    begin = end;
  }
  return count;
}

int stretches_within(const CableShape& cable, const std::array<double, 8>& q, const Vec<double, 2>& centre,
                     double radius, std::array<Stretch1D, 4>& stretches) {
  auto r = cable.polynomials(q);
  std::array<double, 7> square{};
  square[0] = -radius * radius;
  for (std::size_t i = 0; i < 2; ++i) {
    r[i][0] -= centre[static_cast<int>(i)];
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < 4; ++b) square[a + b] += r[i][a] * r[i][b];
  }
  std::array<double, 6> zeros{};
  const int n = real_zeros(square, 0, cable.length, zeros);
  int count = 0;
  double begin = 0;
  for (int i = 0; i <= n; ++i) {
    const double end = i < n ? zeros[static_cast<std::size_t>(i)] : cable.length;
    if (end > begin && value_at(square, 0.5 * (begin + end)) < 0 && count < 4)
      stretches[static_cast<std::size_t>(count++)] = {begin, end};
    begin = end;
  }
  return count;
}

}  // namespace dalembert
