#include "stability.hpp"

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

// y = A x, of the ODE2 coordinates.
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

// Entries of all sizes and signs: no mode is left out.
Vector mixed_numbers(std::size_t count) {
  Vector x(count);
  for (std::size_t i = 0; i < count; ++i) x[i] = std::sin(1.0 + 2.7 * static_cast<double>(i));
  return x;
}

}  // namespace

// Power iteration with M^-1 K, and Rayleigh quotients, which for symmetric matrices are never above the true values.
Vibration fastest_vibration(System& system, State state, const Conditions& conditions, MassOperator& mass, const std::vector<int>& held) {
  std::fill(state.a.begin(), state.a.end(), 0.0);
  std::fill(state.lambda.begin(), state.lambda.end(), 0.0);
  if (state.q.empty() || mass.update(system, state) != LinearSolver::success) return {};
  const Pattern& pattern = system.pattern(false);
  Vector stiffness(static_cast<std::size_t>(pattern.values())), values = stiffness;
  system.tangent(state, conditions, {.q = 1, .v = 0, .a = 0, .y = 0, .y_t = 0}, pattern, stiffness);
  Vector x = mixed_numbers(state.q.size()), y = x;
  for (int i = 0; i < power_iterations; ++i) {
    for (const int k : held) x[k] = 0;
    const double length = std::sqrt(dot(x, x));
    if (!(length > 0) || !std::isfinite(length)) return {};
    for (double& number : x) number /= length;
    if (i + 1 == power_iterations) break;
    multiply(pattern, stiffness, x, y);
    if (mass.solve(system, state, y) != LinearSolver::success) return {};
    std::swap(x, y);
  }
  const auto quotient = [&] {
    multiply(pattern, values, x, y);
    return dot(x, y);
  };
  multiply(pattern, stiffness, x, y);
  const double energy = dot(x, y);
  system.mass_matrix(state, pattern, values);
  const double inertia = quotient();
  system.tangent(state, conditions, {.q = 0, .v = 1, .a = 0, .y = 0, .y_t = 0}, pattern, values);
  const double loss = quotient();
  if (!(energy > 0 && inertia > 0)) return {};
  const auto most = std::ranges::max_element(x, {}, [](double number) { return std::abs(number); });
  return {std::sqrt(energy / inertia), loss / inertia, static_cast<int>(most - x.begin())};
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

// Without damping, which makes it less stable: r^2 - 2 c r + 1 = 0 with c = 1 - (frequency h)^2 / 2.
double verlet_amplification(const Vibration& vibration, double step_size) {
  const double z = vibration.frequency * step_size, c = std::abs(1 - 0.5 * z * z);
  return c <= 1 ? 1 : c + std::sqrt(c * c - 1);
}

double largest_stable_step(const Vibration& vibration, double step_size, const std::function<double(double)>& amplified) {
  if (!(vibration.frequency > 0)) return step_size;
  const double period = 2 * std::numbers::pi / vibration.frequency;
  const auto stable = [&](double h) { return std::pow(amplified(h), period / h) <= 1.01; };
  if (stable(step_size)) return step_size;
  for (double h = std::min(step_size, period); h > 1e-4 * period; h *= 0.98) {
    if (stable(h)) return h;
  }
  return 0;
}

}  // namespace dalembert
