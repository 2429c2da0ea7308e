#include "dalembert/system/traced_equations.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>

#include "dalembert/system/parts.hpp"

namespace dalembert {

std::string TracedEquations::obstacle(const System& system) {
  const SystemParts& parts = *system.parts_;
  std::string found;
  const auto search = [&found](const auto& places, const auto& is_obstacle, std::string_view what) {
    const auto place = std::ranges::find_if(places, is_obstacle);
    if (found.empty() && place != places.end()) found.append(place->type->name).append(what);
  };
  const auto calls_user = [](const auto& place) { return has_user_function(*place.type, place.record.get()); };
  const std::string_view with_function = " with a function of the user";
  search(parts.nodes, calls_user, with_function);
  search(parts.objects, calls_user, with_function);
  search(parts.loads, calls_user, with_function);
  if (!found.empty()) return found;
  if (parts.sizes.ode1 > 0) return "coordinates of first order";
  if (parts.has_history) return "items with data coordinates, such as contact and friction";
  if (!parts.lie_blocks.empty()) return "nodes whose rotations are composed on a Lie group";
  if (parts.plan.regions.size() != 1) return "the size of the system";
  const RegionPlan& plan = parts.plan.regions.front();
  if (!plan.nodes.empty()) return "nodes that rotate in space";
  const Batch* untraceable = nullptr;
  const auto look_at = [&untraceable](const auto& batches) {
    for (const Batch* batch : batches)
      if (!untraceable && !batch->traceable()) untraceable = batch;
  };
  look_at(plan.terms);
  look_at(plan.loads);
  look_at(plan.moving);
  if (!untraceable) return {};
  const auto is_it = [untraceable](const auto& place) { return place.member.batch == untraceable; };
  search(parts.objects, is_it, "");
  search(parts.loads, is_it, "");
  search(parts.markers, is_it, "");
  return found.empty() ? "conditions of nodes" : found;
}

// Markers at rest have been evaluated, or are now: their frames are constants.
TracedEquations::TracedEquations(System& system)
    : parts_(*system.parts_), total_(static_cast<std::size_t>(parts_.sizes.ode2)) {
  parts_.evaluate_resting(parts_.evaluation(parts_.state(ConfigurationType::Current), {}));
  ports_ = TracedPorts(parts_.ports);
}

TracedEvaluation TracedEquations::evaluation(const TracedState& state, const Conditions& conditions) {
  const std::vector<double>& reference = parts_.state(ConfigurationType::Reference).q;
  for (std::size_t i = 0; i < total_.size(); ++i) total_[i] = reference[i] + state.q[i];
  TracedEvaluation e;
  e.q = total_.data();
  e.u = state.q.data();
  e.v = state.v.data();
  e.a = state.a.data();
  e.lambda = state.lambda.data();
  e.time = std::numeric_limits<double>::quiet_NaN();  // results that depend on it become NaN
  e.load_factor = conditions.load_factor;
  e.step_size = conditions.step_size;
  e.rate_level = conditions.rate_level;
  e.inertia = conditions.inertia;
  return e;
}

void TracedEquations::residual(const TracedState& state, const Conditions& conditions, std::span<Traced> r) {
  const TracedEvaluation e = evaluation(state, conditions);
  const RegionPlan& plan = parts_.plan.regions.front();
  const std::vector<double>& constant = parts_.plan.constant.residual;
  for (std::size_t i = 0; i < r.size(); ++i)
    r[i] = conditions.loads && !constant.empty() ? conditions.load_factor * constant[i] : 0.0;
  std::ranges::fill(ports_.forces, Traced());
  const auto note = [&](const auto& batches, TracedCall::Function function) {
    for (const auto* batch : batches) batch->trace({function, e, Weights{}, ports_, r.data()});
  };
  note(plan.moving, TracedCall::Function::evaluate);
  note(plan.terms, TracedCall::Function::residual);
  if (conditions.loads) note(plan.changing_loads, TracedCall::Function::residual);
  note(plan.pulled, TracedCall::Function::pull_back);
}

void TracedEquations::tangent(const TracedState& state, const Conditions& conditions, const Weights& weights,
                              const Pattern& pattern, std::span<Traced> values) {
  parts_.bind(pattern);
  if (!conditions.follows_residual) {
    std::vector<Traced> unused(static_cast<std::size_t>(parts_.sizes.total()));
    residual(state, conditions, unused);
  }
  TracedEvaluation e = evaluation(state, conditions);
  e.same_state = true;
  const RegionPlan& plan = parts_.plan.regions.front();
  std::ranges::fill(values, Traced());
  ports_.differentiate();
  const auto note = [&](const auto& batches, TracedCall::Function function) {
    for (const auto* batch : batches) batch->trace({function, e, weights, ports_, values.data()});
  };
  note(plan.differentiated, TracedCall::Function::evaluate_tangent);
  note(plan.terms, TracedCall::Function::tangent);
  if (conditions.loads) note(plan.loads, TracedCall::Function::tangent);
  note(plan.moving, TracedCall::Function::geometric);
}

}  // namespace dalembert
