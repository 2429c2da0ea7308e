// All elements of one type side by side: bodies on nodes and finite elements. There is no other loop over them.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "dalembert/batches/element_parameters.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

template <class E, class Record>
class ElementBatch final : public Term {
 public:
  static constexpr int n = E::size;

  void add(const void* record, const Placement& placement, const Ports&) override {
    Entry entry;
    take_parameters<E, Record>(entry.parameters, record, placement);
    entry.item = placement.item;
    entry.rotation = placement.rotation;
    for (int i = 0; i < n; ++i) {
      entry.dofs[i] = placement.dofs[i];
      entry.reference[i] = placement.reference[i];
    }
    entry.constants = prepared<E>(entry.parameters, entry.reference);
    entries_.push_back(std::move(entry));
  }
  void refresh(int entry, const void* record) override {
    Entry& e = entries_[entry];
    renew_parameters<E, Record>(e.parameters, record);
    e.constants = prepared<E>(e.parameters, e.reference);
  }
  void visit(BlockVisitor& visitor, const Ports&) const override {
    if constexpr (n > 0)
      for (const Entry& e : entries_) visitor.block(e.dofs, e.dofs);
  }

  void residual(const Evaluation& evaluation, Ports&, double* r) const override {
    if (PureInertia<E> && !evaluation.inertia) return;
    if constexpr (n > 0)
      for (const Entry& e : entries_) {
        const auto x = gather<n>(evaluation, e.dofs.data());
        const auto f = element_residual<E, double>(e.parameters, e.constants, context(evaluation, e), x);
        for (int i = 0; i < n; ++i) r[e.dofs[i]] += f[i];
      }
  }
  void tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports, double* values) const override {
    sweep(evaluation, weights, ports.rotations, values);
  }
  void mass(const Evaluation& evaluation, Ports&, double* values) const override {
    sweep(evaluation, {.q = 0, .v = 0, .a = 1, .y = 0, .y_t = 0}, {}, values);
  }
  bool has_mass() const override { return n > 0; }
  bool constant_mass() const override { return E::constant_mass; }

  bool motion(int entry, const Evaluation& evaluation, const Vec3<double>& local, Motion<double>& m) const override {
    const Entry& e = entries_[entry];
    m = E::template motion<double>(e.parameters, gather<n>(evaluation, e.dofs.data()), local);
    return true;
  }
  bool output(int entry, OutputVariableType variable, const Vec3<double>& local, const Evaluation& evaluation, const Ports&,
              std::vector<double>& values) const override {
    const Entry& e = entries_[entry];
    const auto x = gather<n>(evaluation, e.dofs.data());
    const OutputRequest request{variable, local, e.reference.x};
    if constexpr (requires { E::output(e.parameters, Context{}, x, request, values); })
      return E::output(e.parameters, context(evaluation, e), x, request, values);
    return false;
  }

 private:
  struct Entry {
    typename E::Parameters parameters;
    int item = -1;
    int rotation = -1;  // place in Ports::rotations
    std::array<int, n> dofs{};
    Vec<double, n> reference{};
    [[no_unique_address]] typename PreparedOf<E>::Type constants;
  };

  static Context context(const Evaluation& evaluation, const Entry& e) { return Context::of(evaluation, e.item); }

  // `rotations`: those of the ports, if they were found along the same weights.
  void sweep(const Evaluation& evaluation, const Weights& weights, const std::vector<double>& rotations, double* values) const {
    if constexpr (n > 0) {
      SlotCursor slot(slots.data(), values);
      for (const Entry& e : entries_) {
        const auto x = gather<n>(evaluation, e.dofs.data());
        if constexpr (TurningBody<E>) {
          const SharedRotation<typename E::Turning> rotation(rotations, rotations.empty() ? -1 : e.rotation, x, weights);
          const auto k = inertia_tangent<typename E::Kernel, typename E::Turning>(e.parameters, x, *rotation, weights);
          for (const double entry : k.x) slot.add(entry);
        } else if constexpr (TangentKernel<E>) {
          const auto k = E::tangent(e.parameters, e.constants, context(evaluation, e), x, weights);
          for (const double entry : k.x) slot.add(entry);
        } else {
          const auto f = element_residual<E, Dual<n>>(e.parameters, e.constants, context(evaluation, e), seeded<E>(x, weights));
          for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) slot.add(f[i].d[j]);
        }
      }
    }
  }

  std::vector<Entry> entries_;
};

}  // namespace dalembert
