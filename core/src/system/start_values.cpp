#include "start_values.hpp"

namespace dalembert {
namespace {

// Missing values are zeros.
void append(std::vector<double>& list, const std::vector<double>& values, int count) {
  const std::size_t size = list.size() + static_cast<std::size_t>(count);
  list.insert(list.end(), values.begin(), values.end());
  list.resize(size);
}

}  // namespace

Sizes StartValues::make_room(std::span<const Sizes> nodes, SystemParts& parts) {
  Sizes sum;
  for (const Sizes& node : nodes) {
    sum.ode2 += node.ode2;
    sum.ode1 += node.ode1;
    sum.ae += node.ae;
    sum.data += node.data;
  }
  State& reference = parts.state(ConfigurationType::Reference);
  State& initial = parts.state(ConfigurationType::Initial);
  for (auto* list : {&reference.q, &initial.q, &initial.v}) list->reserve(static_cast<std::size_t>(sum.ode2));
  for (auto* list : {&reference.y, &initial.y}) list->reserve(static_cast<std::size_t>(sum.ode1));
  initial.lambda.reserve(static_cast<std::size_t>(sum.ae));
  initial.data.reserve(static_cast<std::size_t>(sum.data));
  return sum;
}

void StartValues::take(const NodePlace& node, SystemParts& parts) {
  values_.clear();
  node.physics->values(node.record.get(), values_);
  State& reference = parts.state(ConfigurationType::Reference);
  State& initial = parts.state(ConfigurationType::Initial);
  const Sizes& sizes = node.sizes;
  append(reference.q, values_.reference, sizes.ode2);
  append(initial.q, values_.displacement, sizes.ode2);
  append(initial.v, values_.velocity, sizes.ode2);
  append(reference.y, values_.reference_ode1, sizes.ode1);
  append(initial.y, values_.ode1, sizes.ode1);
  append(initial.lambda, values_.algebraic, sizes.ae);
  append(initial.data, values_.data, sizes.data);
}

void complete_configurations(SystemParts& parts) {
  const Sizes& n = parts.sizes;
  State &reference = parts.state(ConfigurationType::Reference), &initial = parts.state(ConfigurationType::Initial);
  for (State* state : {&reference, &initial}) {
    state->y_t.resize(n.ode1);
    state->lambda.resize(n.ae);
    state->data.resize(n.data);
  }
  initial.a.resize(n.ode2);
  parts.state(ConfigurationType::Current) = initial;
  for (const ConfigurationType c : {ConfigurationType::StartOfStep, ConfigurationType::Visualization})
    parts.states[static_cast<std::size_t>(c)].waits = true;
}

void start_again(SystemParts& parts) {
  for (State& state : parts.states) {
    for (auto* list : {&state.q, &state.v, &state.a, &state.y, &state.y_t, &state.lambda, &state.data}) list->clear();
    state.time = 0;
    state.sign = MultiplierSign::motion;
    state.waits = false;
  }
  StartValues values;
  for (const NodePlace& node : parts.nodes) values.take(node, parts);
  complete_configurations(parts);
}

}  // namespace dalembert
