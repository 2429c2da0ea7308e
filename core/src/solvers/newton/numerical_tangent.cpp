#include "dalembert/solvers/numerical_tangent.hpp"

#include <cmath>
#include <vector>

namespace dalembert {

namespace {

// Residuals on both sides of a state, along one column of the matrix. It is the current state that moves, since user functions
// read that one; it comes back at the end.
class Differences {
 public:
  Differences(System& system, const State& state, const Conditions& conditions, const Weights& weights)
      : system_(system), state_(state), moved_(system.state(ConfigurationType::Current)), saved_(moved_), conditions_(conditions),
        weights_(weights), increment_(state.q.size(), 0.0), up_(static_cast<std::size_t>(system.sizes().total())),
        down_(up_.size()) {
    moved_ = state_;
  }
  ~Differences() { moved_ = saved_; }
  Differences(const Differences&) = delete;
  Differences& operator=(const Differences&) = delete;

  // (r(+eps) - r(-eps)) / (2 eps) for one unknown.
  const std::vector<double>& slope(int column, double eps) {
    evaluate(column, eps, up_);
    evaluate(column, -eps, down_);
    for (std::size_t i = 0; i < up_.size(); ++i) up_[i] = (up_[i] - down_[i]) / (2 * eps);
    return up_;
  }

 private:
  void evaluate(int column, double eps, std::vector<double>& r) {
    const Sizes& s = system_.sizes();
    if (column < s.ode2) {
      const auto i = static_cast<std::size_t>(column);
      moved_.q[i] = state_.q[i] + weights_.q * eps;
      moved_.v[i] = state_.v[i] + weights_.v * eps;
      if (!moved_.a.empty()) moved_.a[i] = state_.a[i] + weights_.a * eps;
      if (system_.has_lie_nodes()) {
        increment_[i] = weights_.q * eps;
        system_.compose(state_.q, increment_, moved_.q);
        increment_[i] = 0;
      }
      system_.residual(moved_, conditions_, r);
      moved_.q = state_.q;
      moved_.v[i] = state_.v[i];
      if (!moved_.a.empty()) moved_.a[i] = state_.a[i];
    } else if (column < s.first_ae()) {
      const auto i = static_cast<std::size_t>(column - s.ode2);
      moved_.y[i] = state_.y[i] + weights_.y * eps;
      moved_.y_t[i] = state_.y_t[i] + weights_.y_t * eps;
      system_.residual(moved_, conditions_, r);
      moved_.y[i] = state_.y[i];
      moved_.y_t[i] = state_.y_t[i];
    } else {
      const auto i = static_cast<std::size_t>(column - s.first_ae());
      moved_.lambda[i] = state_.lambda[i] + eps;
      system_.residual(moved_, conditions_, r);
      moved_.lambda[i] = state_.lambda[i];
    }
  }

  System& system_;
  const State state_;
  State& moved_;
  const State saved_;
  Conditions conditions_;
  Weights weights_;
  std::vector<double> increment_, up_, down_;
};

// Which entries come from differences.
class Choice {
 public:
  Choice(System& system, const NewtonNumericalDifferentiationSettings& options)
      : all_(options.doSystemWideDifferentiation), algebraic_(options.forAE), motion_(options.forODE2 || options.forODE2connectors),
        first_ae_(system.sizes().first_ae()), of_items_(all_ ? nullptr : &system.pattern(false)) {}

  bool everything() const { return all_; }
  bool any_in(int column) const { return all_ || algebraic_ || column < first_ae_; }
  bool operator()(int row, int column) const {
    if (all_) return true;
    return (row < first_ae_ && column < first_ae_ ? motion_ : algebraic_) && of_items_->contains(row, column);
  }

 private:
  bool all_, algebraic_, motion_;
  int first_ae_;
  const Pattern* of_items_;  // what items say that they depend on
};

double size_of_unknown(const Sizes& s, const State& state, const State& reference, bool with_reference, int column) {
  if (column >= s.first_ae()) return state.lambda[static_cast<std::size_t>(column - s.first_ae())];
  if (column >= s.ode2) return state.y[static_cast<std::size_t>(column - s.ode2)];
  const auto i = static_cast<std::size_t>(column);
  return state.q[i] + (with_reference ? reference.q[i] : 0.0);
}

}  // namespace

void numerical_tangent(System& system, const State& state, const Conditions& conditions, const Weights& weights,
                       const NewtonNumericalDifferentiationSettings& options, const Pattern& pattern,
                       std::span<double> values) {
  const Choice chosen(system, options);
  if (!chosen.everything()) system.tangent(state, conditions, weights, pattern, values);
  const Sizes& s = system.sizes();
  const State& reference = system.state(ConfigurationType::Reference);
  // The weights may be scaled by any factor: steps are not.
  const double unit = weights.q != 0 ? weights.q : 1.0;
  Weights direction = weights;
  for (double* weight : {&direction.q, &direction.v, &direction.a}) *weight /= unit;
  Differences differences(system, state, conditions, direction);
  const double constraints = weights.q == 0 && weights.v != 0 ? 1 / weights.v : 1.0;
  for (int column = 0; column < s.total(); ++column) {
    if (!chosen.any_in(column)) continue;
    const double size = size_of_unknown(s, state, reference, options.addReferenceCoordinatesToEpsilon, column);
    const double eps = options.relativeEpsilon * std::max(options.minimumCoordinateSize, std::abs(size));
    const std::vector<double>& slope = differences.slope(column, eps);
    for_each_row(pattern, column, [&](int row) {
      if (!chosen(row, column)) return;
      const double factor = column < s.ode2 && row < s.first_ae() ? unit : column < s.first_ae() && row >= s.first_ae() ? constraints : 1.0;
      values[static_cast<std::size_t>(pattern.slot(row, column))] = factor * slope[static_cast<std::size_t>(row)];
    });
  }
}

}  // namespace dalembert
