#include "dalembert/batches/marker.hpp"

#include <algorithm>

namespace dalembert {

int CoordinateMarkerBatch::value_count(const void*, const Placement& placement) const { return 2 * count(placement); }
int CoordinateMarkerBatch::force_count(const void*, const Placement& placement) const { return count(placement); }
int CoordinateMarkerBatch::count(const Placement& placement) const {
  const int own = static_cast<int>(placement.dofs.size());
  return totals_ ? own : std::max(own, 1);
}
void CoordinateMarkerBatch::add(const void*, const Placement& placement, const Ports& ports) {
  entries_.push_back({placement.item, ports.offsets(placement.item), dofs_.size(), placement.dofs.size()});
  dofs_.insert(dofs_.end(), placement.dofs.begin(), placement.dofs.end());
}
template <class S>
void CoordinateMarkerBatch::find_values(const EvaluationOf<S>& evaluation, PortsOf<S>& ports) const {
  const S* q = totals_ ? evaluation.q : evaluation.u;
  for (const Entry& e : entries_) {
    S* values = ports.values.data() + e.port.value;
    const int* dofs = dofs_.data() + e.first;
    for (std::size_t i = 0; i < e.count; ++i) {
      values[i] = q[dofs[i]];
      values[e.count + i] = evaluation.v[dofs[i]];
    }
  }
}
template <class S>
void CoordinateMarkerBatch::differentiate(const Weights& weights, PortsOf<S>& ports) const {
  for (const Entry& e : entries_) {
    S* derivative = ports.derivative(e.marker);
    S* jacobian = ports.jacobian(e.marker);
    const std::size_t n = e.count;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        derivative[i * n + j] = i == j ? weights.q : 0;
        derivative[(n + i) * n + j] = i == j ? weights.v : 0;
        jacobian[i * n + j] = i == j ? 1 : 0;
      }
  }
}
template <class S>
void CoordinateMarkerBatch::subtract_forces(const PortsOf<S>& ports, S* r) const {
  for (const Entry& e : entries_) {
    const S* force = ports.forces.data() + e.port.force;
    const int* dofs = dofs_.data() + e.first;
    for (std::size_t i = 0; i < e.count; ++i) r[dofs[i]] -= force[i];
  }
}

void CoordinateMarkerBatch::evaluate(const Evaluation& evaluation, Ports& ports) const {
  find_values(evaluation, ports);
}
void CoordinateMarkerBatch::evaluate_tangent(const Evaluation&, const Weights& weights, Ports& ports) const {
  differentiate(weights, ports);
}
void CoordinateMarkerBatch::pull_back(const Evaluation&, Ports& ports, double* r) const { subtract_forces(ports, r); }
void CoordinateMarkerBatch::trace(const TracedCall& call) const {
  switch (call.function) {
    case TracedCall::Function::evaluate: return find_values(call.evaluation, call.ports);
    case TracedCall::Function::evaluate_tangent: return differentiate(call.weights, call.ports);
    case TracedCall::Function::pull_back: return subtract_forces(call.ports, call.sums);
    default: return;
  }
}

}  // namespace dalembert
