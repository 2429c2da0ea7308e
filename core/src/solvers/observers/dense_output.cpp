// Hairer, Norsett, Wanner: Solving Ordinary Differential Equations I, section II.6, for Hermite interpolation.
#include "observers/dense_output.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "steppers/rotation_increments.hpp"

namespace dalembert {

namespace {

// Weights of [q0, q0', q0'', q1, q1', q1''] at s, and of the derivatives by s.
struct Quintic {
  std::array<double, 6> value, rate, second;
  explicit Quintic(double s) {
    const double s2 = s * s, s3 = s2 * s, s4 = s3 * s, s5 = s4 * s;
    value = {1 - 10 * s3 + 15 * s4 - 6 * s5, s - 6 * s3 + 8 * s4 - 3 * s5, 0.5 * (s2 - 3 * s3 + 3 * s4 - s5),
             10 * s3 - 15 * s4 + 6 * s5,     -4 * s3 + 7 * s4 - 3 * s5,    0.5 * (s3 - 2 * s4 + s5)};
    rate = {-30 * s2 + 60 * s3 - 30 * s4, 1 - 18 * s2 + 32 * s3 - 15 * s4, 0.5 * (2 * s - 9 * s2 + 12 * s3 - 5 * s4),
            30 * s2 - 60 * s3 + 30 * s4,  -12 * s2 + 28 * s3 - 15 * s4,    0.5 * (3 * s2 - 8 * s3 + 5 * s4)};
    second = {-60 * s + 180 * s2 - 120 * s3, -36 * s + 96 * s2 - 60 * s3, 0.5 * (2 - 18 * s + 36 * s2 - 20 * s3),
              60 * s - 180 * s2 + 120 * s3,  -24 * s + 84 * s2 - 60 * s3, 0.5 * (6 * s - 24 * s2 + 20 * s3)};
  }
};

using Vector = Vec3<double>;

Vector part(const std::vector<double>& x, std::size_t r) { return load<double, 3>(&x[r]); }
void put(std::vector<double>& x, std::size_t r, const Vector& value) {
  for (std::size_t k = 0; k < 3; ++k) x[r + k] = value[static_cast<int>(k)];
}

// Returns the derivative along x + s rate, at s = 0, of an operator at x, times a vector.
template <class Operator>
Vector derivative_times(const Operator& at, const Vector& x, const Vector& rate, const Vector& vector) {
  constexpr double step = 1e-4;
  const Vector after = x + step * rate, before = x - step * rate;
  return (0.5 / step) * (at(&after[0]) * vector - at(&before[0]) * vector);
}

}  // namespace

void StepInterpolation::prepare(System& system, const State& start, const State& end, bool accelerations_known,
                                bool rates_known) {
  system_ = &system;
  start_ = &start;
  end_ = &end;
  const std::size_t n = start.q.size();
  const double h = end.time - start.time;
  for (Ends* ends : {&first_, &last_}) {
    ends->q.assign(n, 0.0);
    ends->v.resize(n);
    ends->a.resize(n);
  }
  for (std::size_t i = 0; i < n; ++i) {
    last_.q[i] = end.q[i] - start.q[i];
    first_.v[i] = h * start.v[i];
    last_.v[i] = h * end.v[i];
    first_.a[i] = h * h * start.a[i];
    last_.a[i] = h * h * end.a[i];
  }
  if (system.has_lie_nodes()) turn_ends();
  for (std::size_t i = 0; i < n && !accelerations_known; ++i) {
    first_.a[i] = 6 * last_.q[i] - 4 * first_.v[i] - 2 * last_.v[i];
    last_.a[i] = -6 * last_.q[i] + 2 * first_.v[i] + 4 * last_.v[i];
  }
  y0_ = start.y_t;
  y1_ = end.y_t;
  for (std::size_t i = 0; i < y0_.size(); ++i) {
    const double chord = end.y[i] - start.y[i];
    y1_[i] *= h;
    y0_[i] = rates_known ? h * y0_[i] : 2 * chord - y1_[i];
  }
}

// Computes the rotation vector from start to end of the step, and its first and second derivatives.
void StepInterpolation::turn_ends() {
  const std::vector<double>& reference = system_->state(ConfigurationType::Reference).q;
  std::vector<double> back(first_.q.size()), total(back.size()), turn(back.size());
  for (const System::LieBlock& block : system_->lie_blocks()) {
    for (auto i = static_cast<std::size_t>(block.rotation); i < static_cast<std::size_t>(block.rotation) + 3; ++i) {
      back[i] = -start_->q[i] - 2 * reference[i];
      total[i] = end_->q[i] + reference[i];
    }
  }
  system_->compose(back, total, turn);
  for (const System::LieBlock& block : system_->lie_blocks()) {
    const auto r = static_cast<std::size_t>(block.rotation);
    Vector x = part(turn, r) + part(reference, r);
    const double angle = std::sqrt(dot(x, x));
    if (angle > std::numbers::pi) x = (1 - 2 * std::numbers::pi / angle) * x;
    const Vector spin = part(last_.v, r), rate = inverse_tangent_operator(&x[0]) * spin;
    put(last_.q, r, x);
    put(last_.v, r, rate);
    put(last_.a, r,
        inverse_tangent_operator(&x[0]) * part(last_.a, r) + derivative_times(inverse_tangent_operator, x, rate, spin));
  }
}

void StepInterpolation::evaluate(double time, State& state) const {
  const double h = end_->time - start_->time, s = (time - start_->time) / h;
  const Quintic weights(s);
  const std::size_t n = first_.q.size();
  const auto combine = [&](const std::array<double, 6>& w, std::size_t i) {
    return w[1] * first_.v[i] + w[2] * first_.a[i] + w[3] * last_.q[i] + w[4] * last_.v[i] + w[5] * last_.a[i];
  };
  state = *end_;
  state.time = time;
  for (std::vector<double>* numbers : {&now_.q, &now_.v, &now_.a}) numbers->resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    now_.q[i] = combine(weights.value, i);
    now_.v[i] = combine(weights.rate, i);
    now_.a[i] = combine(weights.second, i);
    state.q[i] = start_->q[i] + now_.q[i];
    state.v[i] = now_.v[i] / h;
    state.a[i] = now_.a[i] / (h * h);
  }
  if (system_->has_lie_nodes()) turn_back(now_, h, state);
  const double s2 = s * s, s3 = s2 * s;
  for (std::size_t i = 0; i < y0_.size(); ++i) {
    const double chord = end_->y[i] - start_->y[i];
    state.y[i] = start_->y[i] + (3 * s2 - 2 * s3) * chord + (s - 2 * s2 + s3) * y0_[i] + (s3 - s2) * y1_[i];
    state.y_t[i] = ((6 * s - 6 * s2) * chord + (1 - 4 * s + 3 * s2) * y0_[i] + (3 * s2 - 2 * s) * y1_[i]) / h;
  }
  for (std::size_t i = 0; i < state.lambda.size(); ++i)
    state.lambda[i] = (1 - s) * start_->lambda[i] + s * end_->lambda[i];
  system_->restore_unit_lengths(state, 1);
}

// Converts rotations since the start of the step to rotation vectors and angular velocities.
void StepInterpolation::turn_back(const Ends& now, double h, State& state) const {
  system_->compose(start_->q, now.q, state.q);
  for (const System::LieBlock& block : system_->lie_blocks()) {
    const auto r = static_cast<std::size_t>(block.rotation);
    const Vector x = part(now.q, r), rate = part(now.v, r);
    put(state.v, r, (1 / h) * (tangent_operator(&x[0]) * rate));
    put(state.a, r,
        (1 / (h * h)) * (tangent_operator(&x[0]) * part(now.a, r) + derivative_times(tangent_operator, x, rate, rate)));
  }
}

}  // namespace dalembert
