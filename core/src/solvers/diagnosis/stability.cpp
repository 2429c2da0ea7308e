#include "diagnosis/stability.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>

#include "dalembert/solvers/numerical_tangent.hpp"

namespace dalembert {

namespace {

using Vector = std::vector<double>;
using Complex = std::complex<double>;

constexpr int power_iterations = 100;

// y = A x, for the ODE2 coordinates.
void multiply(const Pattern& pattern, const Vector& values, const Vector& x, Vector& y) {
  std::fill(y.begin(), y.end(), 0.0);
  const int n = static_cast<int>(x.size());
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    if (row < n && column < n) y[row] += values[slot] * x[column];
  });
}

double dot(const Vector& x, const Vector& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum;
}

// Returns a start vector with components in all modes.
Vector mixed_numbers(std::size_t count) {
  Vector x(count);
  for (std::size_t i = 0; i < count; ++i) x[i] = std::sin(1.0 + 2.7 * static_cast<double>(i));
  return x;
}

}  // namespace

// Uses power iterations with M^-1 K and M^-1 D. Rayleigh quotients of symmetric matrices are lower bounds.
Vibration fastest_vibration(System& system, const State& state, const Conditions& conditions,
                            const std::function<bool(std::vector<double>&)>& accelerate, const std::vector<int>& held) {
  const Pattern& pattern = system.pattern(false);
  Vector stiffness(static_cast<std::size_t>(pattern.values())), damping = stiffness, inertia = stiffness;
  system.tangent(state, conditions, {.q = 1, .v = 0, .a = 0, .y = 0, .y_t = 0}, pattern, stiffness);
  system.tangent(state, conditions, {.q = 0, .v = 1, .a = 0, .y = 0, .y_t = 0}, pattern, damping);
  system.mass_matrix(state, pattern, inertia);
  const auto fastest_by = [&](const Vector& matrix) -> Vibration {
    Vector x = mixed_numbers(state.q.size()), y = x;
    for (int i = 0; i < power_iterations; ++i) {
      for (const int k : held) x[k] = 0;
      const double length = std::sqrt(dot(x, x));
      if (!(length > 0) || !std::isfinite(length)) return {};
      for (double& number : x) number /= length;
      if (i + 1 == power_iterations) break;
      multiply(pattern, matrix, x, y);
      if (!accelerate(y)) return {};
      std::swap(x, y);
    }
    const auto quotient = [&](const Vector& values) {
      multiply(pattern, values, x, y);
      return dot(x, y);
    };
    const double energy = quotient(stiffness), loss = quotient(damping), motion = quotient(inertia);
    if (!(motion > 0) || !(energy > 0 || loss > 0)) return {};
    const auto most = std::ranges::max_element(x, {}, [](double number) { return std::abs(number); });
    return {std::sqrt(std::max(energy, 0.0) / motion), loss / motion, static_cast<int>(most - x.begin())};
  };
  const Vibration stiffest = fastest_by(stiffness), most_damped = fastest_by(damping);
  return most_damped.rate() > stiffest.rate() ? most_damped : stiffest;
}

// R(z) = 1 + z b^T (1 - z A)^-1 1 for z = h times a root of s^2 + damping s + frequency^2.
double amplification(const RungeKuttaMethod& method, const Vibration& vibration, double step_size) {
  const double half = 0.5 * vibration.damping;
  const Complex root = std::sqrt(Complex(half * half - vibration.frequency * vibration.frequency));
  double largest = 0;
  for (const Complex z : {step_size * (root - half), step_size * (-root - half)}) {
    std::vector<Complex> stages;
    Complex result = 1;
    for (int i = 0; i < method.stages; ++i) {
      Complex at_stage = 1;
      for (int j = 0; j < i; ++j) at_stage += method.coefficient(i, j) * stages[static_cast<std::size_t>(j)];
      stages.push_back(z * at_stage);
      result += method.b[static_cast<std::size_t>(i)] * stages.back();
    }
    largest = std::max(largest, std::abs(result));
  }
  return largest;
}

// Velocities u are those between the steps: u+ = u - h (damping u + frequency^2 q), q+ = q + h u+, so that r^2 - b r +
// d = 0.
double verlet_amplification(const Vibration& vibration, double step_size) {
  const double z = vibration.frequency * step_size, loss = vibration.damping * step_size, b = 2 - loss - z * z,
               d = 1 - loss;
  const double discriminant = 0.25 * b * b - d;
  return discriminant > 0 ? 0.5 * std::abs(b) + std::sqrt(discriminant) : std::sqrt(d);
}

double largest_stable_step(const Vibration& vibration, double step_size,
                           const std::function<double(double)>& amplified) {
  if (!(vibration.rate() > 0)) return step_size;
  const double period = 2 * std::numbers::pi / vibration.rate();
  const auto stable = [&](double h) { return std::pow(amplified(h), period / h) <= 1.01; };
  if (stable(step_size)) return step_size;
  for (double h = std::min(step_size, period); h > 1e-4 * period; h *= 0.98) {
    if (stable(h)) return h;
  }
  return 0;
}

}  // namespace dalembert
