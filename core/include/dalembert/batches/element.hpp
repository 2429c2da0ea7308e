// All elements of one type side by side: bodies on nodes and finite elements. There is no other loop over them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "dalembert/batches/element_parameters.hpp"
#include "dalembert/math/lanes.hpp"
#include "dalembert/math/wide_registers.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

template <class E, class Record>
class ElementBatch : public Term {
 public:
  static constexpr int n = E::size;

  void reserve(int entries) override { entries_.reserve(static_cast<std::size_t>(entries)); }
  void add(const void* record, const Placement& placement, const Ports&) override {
    Entry entry;
    take_parameters<E, Record>(entry.parameters, record, placement);
    entry.item = placement.item;
    entry.node = placement.rotating_node;
    for (int i = 0; i < n; ++i) {
      entry.dofs[i] = placement.dofs[i];
      entry.reference[i] = placement.reference[i];
    }
    entry.constants = prepared<E>(entry.parameters, entry.reference);
    entries_.push_back(std::move(entry));
    compare_laws(static_cast<int>(entries_.size()) - 1);
  }
  void refresh(int entry, const void* record) override {
    Entry& e = entries_[entry];
    renew_parameters<E, Record>(e.parameters, record);
    e.constants = prepared<E>(e.parameters, e.reference);
    compare_laws(entry);
  }
  void visit(BlockVisitor& visitor, const Ports&) const override {
    if constexpr (n > 0)
      for (const Entry& e : entries_) visitor.block(e.dofs, e.dofs);
  }

  void residual(const Evaluation& evaluation, Ports&, double* r) const override {
    if (PureInertia<E> && !evaluation.inertia) return;
    if constexpr (n > 0)
      for (std::size_t i = 0; i < entries_.size(); i += side_by_side(i)) {
        if constexpr (LaneKernel<E>)
          if (side_by_side(i) == Lanes::count) {
            in_widest_registers([&] { four_residuals(&entries_[i], evaluation, r); });
            continue;
          }
        const Entry& e = entries_[i];
        const auto x = gather<n>(evaluation, e.dofs.data());
        const auto f = element_residual<E, double>(e.parameters, e.constants, context(evaluation, e), x);
        for (int k = 0; k < n; ++k) r[e.dofs[k]] += f[k];
      }
  }
  void tangent(const Evaluation& evaluation, const Weights& weights, Ports&, double* values) const override {
    sweep(evaluation, weights, values);
  }
  void mass(const Evaluation& evaluation, Ports&, double* values) const override {
    sweep(evaluation, {.q = 0, .v = 0, .a = 1, .y = 0, .y_t = 0}, values);
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

 protected:
  struct Entry {
    typename E::Parameters parameters;
    int item = -1;
    int node = -1;  // among the rotating nodes of the ports
    std::array<int, n> dofs{};
    Vec<double, n> reference{};
    [[no_unique_address]] typename PreparedOf<E>::Type constants;
  };

  std::vector<Entry> entries_;

 private:

  static Context context(const Evaluation& evaluation, const Entry& e) { return Context::of(evaluation, e.item); }

  void sweep(const Evaluation& evaluation, const Weights& weights, double* values) const {
    if constexpr (n > 0) {
      for (std::size_t i = 0; i < entries_.size(); i += side_by_side(i)) {
        const int* slot = slots.data() + i * n * n;
        if constexpr (LaneKernel<E>)
          if (side_by_side(i) == Lanes::count) {
            in_widest_registers([&] { four_tangents(&entries_[i], evaluation, weights, slot, values); });
            continue;
          }
        const Entry& e = entries_[i];
        const auto x = gather<n>(evaluation, e.dofs.data());
        if constexpr (TangentKernel<E>) {
          add(E::tangent(e.parameters, e.constants, context(evaluation, e), x, weights), slot, values);
        } else {
          const auto f = element_residual<E, Dual<n>>(e.parameters, e.constants, context(evaluation, e), seeded<E>(x, weights));
          for (int row = 0; row < n; ++row)
            for (int column = 0; column < n; ++column) values[*slot++] += f[row].d[column];
        }
      }
    }
  }

  static void add(const Mat<double, n, n>& k, const int* slot, double* values) {
    for (const double entry : k.x) values[*slot++] += entry;
  }

  // ---- elements of one law, side by side ----
  // How many elements from here on are computed at once.
  std::size_t side_by_side(std::size_t first) const {
    if constexpr (LaneKernel<E>)
      if (first % Lanes::count == 0 && first / Lanes::count < one_law_.size() && one_law_[first / Lanes::count]) return Lanes::count;
    return 1;
  }
  void compare_laws(int changed) {
    if constexpr (LaneKernel<E>) {
      const std::size_t four = static_cast<std::size_t>(changed) / Lanes::count, first = four * Lanes::count;
      if (first + Lanes::count > entries_.size()) return;
      one_law_.resize(std::max(one_law_.size(), four + 1));
      const auto same = [&](const Entry& e) {
        return E::same_law(entries_[first].parameters, entries_[first].constants, e.parameters, e.constants);
      };
      one_law_[four] = std::all_of(&entries_[first], &entries_[first] + Lanes::count, same);
    }
  }
  static Coordinates<Lanes, n> gather_four(const Evaluation& evaluation, const Entry* e) {
    Coordinates<Lanes, n> x;
    const auto pick = [e](const double* from, int i) {
      return Lanes(from[e[0].dofs[i]], from[e[1].dofs[i]], from[e[2].dofs[i]], from[e[3].dofs[i]]);
    };
    for (int i = 0; i < n; ++i) {
      x.q[i] = pick(evaluation.q, i);
      x.v[i] = pick(evaluation.v, i);
      if (evaluation.inertia) x.a[i] = pick(evaluation.a, i);
    }
    return x;
  }
  static void four_residuals(const Entry* e, const Evaluation& evaluation, double* r) {
    const auto f = element_residual<E, Lanes>(e->parameters, e->constants, context(evaluation, *e), gather_four(evaluation, e));
    for (int lane = 0; lane < Lanes::count; ++lane)
      for (int i = 0; i < n; ++i) r[e[lane].dofs[i]] += f[i][lane];
  }
  static void four_tangents(const Entry* e, const Evaluation& evaluation, const Weights& weights, const int* slot,
                                             double* values) {
    const auto k = E::tangent(e->parameters, e->constants, context(evaluation, *e), gather_four(evaluation, e), weights);
    for (int lane = 0; lane < Lanes::count; ++lane)
      for (const Lanes& entry : k.x) values[*slot++] += entry[lane];
  }

  std::vector<char> one_law_;  // of each four elements
};

}  // namespace dalembert
