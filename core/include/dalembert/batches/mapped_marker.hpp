// Markers with a map of the coordinates of their body (contracts/mapped_marker.hpp), side by side.
#pragma once

#include <algorithm>
#include <vector>

#include "dalembert/batches/port_sweep.hpp"
#include "dalembert/contracts/mapped_marker.hpp"

namespace dalembert {

template <MappedMarkerKernel K, class Record>
class MappedMarkerBatch final : public MarkerBatch {
 public:
  int value_count(const void* record, const Placement& on) const override {
    return K::values(parameters(record), prepared(record, on));
  }
  int force_count(const void* record, const Placement& on) const override {
    return K::forces(parameters(record), prepared(record, on));
  }

  void add(const void* record, const Placement& placement, const Ports&) override {
    entries_.push_back({parameters(record), prepared(record, placement), placement.owner_type, placement.owner,
                        placement.reference, placement.item, placement.dofs});
  }
  void refresh(int entry, const void* record) override {
    Entry& e = entries_[static_cast<std::size_t>(entry)];
    e.parameters = parameters(record);
    e.constants = K::prepare(e.parameters, *e.body, e.body_record, e.reference);
  }
  void refresh_owner(int entry, const void* record) override {
    Entry& e = entries_[static_cast<std::size_t>(entry)];
    e.body_record = record;
    e.constants = K::prepare(e.parameters, *e.body, record, e.reference);
  }
  void visit(BlockVisitor& visitor, const Ports&) const override {
    for (const Entry& e : entries_)
      if (!K::constant_pull_back(e.parameters)) visitor.block(e.dofs, e.dofs);
  }

  void evaluate(const Evaluation& evaluation, Ports& ports) const override {
    for (const Entry& e : entries_) {
      gather(e, evaluation);
      K::template map<double>(e.parameters, e.constants, q_.data(), v_.data(), ports.frame(e.marker));
    }
  }
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const override {
    for (const Entry& e : entries_) {
      gather(e, evaluation);
      differentiate(e, weights, ports);
      const std::size_t n = e.dofs.size();
      const int forces = K::forces(e.parameters, e.constants);
      force_.assign(static_cast<std::size_t>(forces), 0.0);
      double* jacobian = ports.jacobian(e.marker);
      std::fill_n(jacobian, static_cast<std::size_t>(forces) * n, 0.0);
      for (int f = 0; f < forces; ++f, jacobian += n) {
        force_[static_cast<std::size_t>(f)] = 1;
        K::template pull_back<double>(e.parameters, e.constants, q_.data(), force_.data(), jacobian);
        force_[static_cast<std::size_t>(f)] = 0;
      }
    }
  }
  void pull_back(const Evaluation& evaluation, Ports& ports, double* r) const override {
    for (const Entry& e : entries_) {
      gather(e, evaluation);
      generalised_.assign(e.dofs.size(), 0.0);
      K::template pull_back<double>(e.parameters, e.constants, q_.data(), ports.force(e.marker), generalised_.data());
      for (std::size_t i = 0; i < e.dofs.size(); ++i) r[e.dofs[i]] -= generalised_[i];
    }
  }
  bool geometric_follows_tangent() const override { return false; }
  void geometric(const Evaluation& evaluation, const Weights& weights, const Ports& ports,
                 double* values) const override {
    const int* slot = slots.data();
    for (const Entry& e : entries_) {
      if (K::constant_pull_back(e.parameters)) continue;
      gather(e, evaluation);
      const double* force = ports.force(e.marker);
      moving_force_.assign(force, force + K::forces(e.parameters, e.constants));
      const int n = static_cast<int>(e.dofs.size());
      for (int first = 0; first < n; first += sweep_width) {
        seed(e, weights, first);
        moving_generalised_.assign(e.dofs.size(), SweepDual());
        K::template pull_back<SweepDual>(e.parameters, e.constants, moving_q_.data(), moving_force_.data(),
                                         moving_generalised_.data());
        for (int i = 0; i < n; ++i)
          for (int j = first; j < std::min(n, first + sweep_width); ++j)
            values[slot[i * n + j]] -=
                moving_generalised_[static_cast<std::size_t>(i)].d[static_cast<std::size_t>(j - first)];
      }
      slot += n * n;
    }
  }
  bool motion(int entry, const Evaluation& evaluation, Motion<double>& m) const override {
    const Entry& e = entries_[static_cast<std::size_t>(entry)];
    gather(e, evaluation);
    std::vector<double> a;
    for (const int dof : e.dofs) a.push_back(evaluation.a[dof]);
    m = K::origin(e.constants, q_.data(), v_.data(), a.data());
    return true;
  }

 private:
  struct Entry {
    typename K::Parameters parameters;
    typename K::Constants constants;
    const ItemType* body = nullptr;
    const void* body_record = nullptr;
    std::vector<double> reference;  // coordinates
    int marker = -1;
    std::vector<int> dofs;
  };
  static const typename K::Parameters& parameters(const void* record) {
    return static_cast<const Record*>(record)->parameters;
  }
  static typename K::Constants prepared(const void* record, const Placement& on) {
    return K::prepare(parameters(record), *on.owner_type, on.owner, on.reference);
  }

  void gather(const Entry& e, const Evaluation& evaluation) const {
    q_.clear();
    v_.clear();
    for (const int dof : e.dofs) {
      q_.push_back(evaluation.q[dof]);
      v_.push_back(evaluation.v[dof]);
    }
  }
  // Coordinates that move along columns [first, first + sweep_width).
  void seed(const Entry& e, const Weights& weights, int first) const {
    moving_q_.assign(q_.begin(), q_.end());
    moving_v_.assign(v_.begin(), v_.end());
    for (std::size_t i = static_cast<std::size_t>(first), k = 0; i < e.dofs.size() && k < sweep_width; ++i, ++k) {
      moving_q_[i].d[k] = weights.q;
      moving_v_[i].d[k] = weights.v;
    }
  }
  void differentiate(const Entry& e, const Weights& weights, Ports& ports) const {
    const int n = static_cast<int>(e.dofs.size()), values = K::values(e.parameters, e.constants);
    double* derivative = ports.derivative(e.marker);
    for (int first = 0; first < n; first += sweep_width) {
      seed(e, weights, first);
      moving_values_.assign(static_cast<std::size_t>(values), SweepDual());
      K::template map<SweepDual>(e.parameters, e.constants, moving_q_.data(), moving_v_.data(), moving_values_.data());
      for (int i = 0; i < values; ++i)
        for (int j = first; j < std::min(n, first + sweep_width); ++j)
          derivative[i * n + j] = moving_values_[static_cast<std::size_t>(i)].d[static_cast<std::size_t>(j - first)];
    }
  }

  std::vector<Entry> entries_;
  // Work space: a batch is evaluated by one thread at a time.
  mutable std::vector<double> q_, v_, force_, generalised_;
  mutable std::vector<SweepDual> moving_q_, moving_v_, moving_values_, moving_force_, moving_generalised_;
};

}  // namespace dalembert
