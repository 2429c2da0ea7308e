// All elements of one type side by side: bodies on nodes and finite elements. There is no other loop over them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "dalembert/batches/element_parameters.hpp"
#include "dalembert/math/pack.hpp"
#include "dalembert/math/wide_registers.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

template <class E, class Record>
class ElementBatch : public Term {
 public:
  static constexpr int n = E::size;
  static constexpr bool is_diagonal = E::traits.diagonal;  // its tangent
  static constexpr int slots_per_entry = is_diagonal ? n : n * n;

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
  void refresh_resting(int entry, const void* record, const Placement& placement) override {
    take_parameters<E, Record>(entries_[entry].parameters, record, placement);
  }
  void visit(BlockVisitor& visitor, const Ports&) const override {
    if constexpr (n > 0)
      for (const Entry& e : entries_) {
        if constexpr (!is_diagonal) visitor.block(e.dofs, e.dofs);
        else for (const int dof : e.dofs) visitor.entry(dof, dof);
      }
  }

  void residual(const Evaluation& evaluation, Ports&, double* r) const override {
    if (PureInertia<E> && !evaluation.inertia) return;
    if constexpr (n > 0)
      each_element([&]<int L>(std::size_t first, int count) { residuals_in_lanes<L>(first, count, evaluation, r); },
                   [&](std::size_t i) { add_residual(entries_[i], evaluation, r); });
  }
  void tangent(const Evaluation& evaluation, const Weights& weights, Ports&, double* values) const override {
    sweep(evaluation, weights, values);
  }
  void mass(const Evaluation& evaluation, Ports&, double* values) const override {
    sweep(evaluation, {.q = 0, .v = 0, .a = 1, .y = 0, .y_t = 0}, values);
  }
  bool traceable() const override { return TracedElement<E>; }
  void trace(const TracedCall& call) const override {
    if constexpr (TracedElement<E>)
      for (std::size_t i = 0; i < entries_.size(); ++i)
        call.function == TracedCall::Function::residual ? add_residual(entries_[i], call.evaluation, call.sums)
                                                        : add_tangent(entries_[i], call.evaluation, call.weights, slots_of(i), call.sums);
  }
  bool has_mass() const override { return n > 0; }
  // Where rates are spins, only the lever of a centre of mass turns.
  bool constant_mass() const override {
    if constexpr (RotatingBodyElement<E>) {
      if constexpr (LieKernel<typename E::OwnRotation> && E::Kernel::traits.constant_mass)
        return std::ranges::none_of(entries_, [](const Entry& e) { return E::Kernel::mass_properties(e.parameters).eccentric(); });
    }
    return E::traits.constant_mass;
  }

  bool motion(int entry, const Evaluation& evaluation, const Vec3<double>& local, Motion<double>& m) const override {
    const Entry& e = entries_[entry];
    m = E::template motion<double>(e.parameters, gather<n>(evaluation, e.dofs.data()), local);
    return true;
  }
  bool output(int entry, OutputVariableType variable, const Vec3<double>& local, const Evaluation& evaluation, const Ports&,
              std::vector<double>& values) const override {
    const Entry& e = entries_[entry];
    const auto x = gather<n>(evaluation, e.dofs.data());
    const OutputRequest request{variable, local, e.reference.x, evaluation.of_reference};
    return E::output(e.parameters, context(evaluation, e), x, request, values);
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
  template <class S>
  static Context context(const EvaluationOf<S>& evaluation, const Entry& e) {
    return Context::of(evaluation, e.item);
  }
  template <class S>
  static void add_residual(const Entry& e, const EvaluationOf<S>& evaluation, S* r) {
    const auto x = gather<n>(evaluation, e.dofs.data());
    const auto f = element_residual<E, S>(e.parameters, e.constants, context(evaluation, e), x);
    for (int k = 0; k < n; ++k) r[e.dofs[k]] += f[k];
  }
  template <class S>
  static void add_tangent(const Entry& e, const EvaluationOf<S>& evaluation, const Weights& weights, const int* slot, S* values) {
    if constexpr (PureInertia<E>) return add_mass(e, evaluation, weights.a, slot, values);
    const auto x = gather<n>(evaluation, e.dofs.data());
    if constexpr (TangentKernel<E>) {
      add(E::tangent(e.parameters, e.constants, context(evaluation, e), x, weights), slot, values);
    } else {
      const auto f = element_residual<E, Dual<n, S>>(e.parameters, e.constants, context(evaluation, e), seeded<E>(x, weights));
      for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) values[*slot++] += f[row].d[column];
    }
  }

  // What it takes to accelerate coordinates, one after the other; all at once if each needs a force of its own only.
  template <class S>
  static void add_mass(const Entry& e, const EvaluationOf<S>& evaluation, double weight, const int* slot, S* values) {
    Coordinates<S, n> x{};
    const auto force = [&] { return element_residual<E, S>(e.parameters, e.constants, context(evaluation, e), x); };
    if constexpr (is_diagonal) {
      x.a.x.fill(weight);
      const auto f = force();
      for (int i = 0; i < n; ++i) values[slot[i]] += f[i];
    } else {
      for (int column = 0; column < n; ++column) {
        x.a[column] = weight;
        const auto f = force();
        x.a[column] = 0;
        for (int row = 0; row < n; ++row) values[slot[row * n + column]] += f[row];
      }
    }
  }

  const int* slots_of(std::size_t entry) const { return slots.data() + entry * slots_per_entry; }
  void sweep(const Evaluation& evaluation, const Weights& weights, double* values) const {
    if constexpr (n > 0)
      each_element(
          [&]<int L>(std::size_t first, int count) { tangents_in_lanes<L>(first, count, evaluation, weights, slots_of(first), values); },
          [&](std::size_t i) { add_tangent(entries_[i], evaluation, weights, slots_of(i), values); });
  }

  template <class S>
  static void add(const Mat<S, n, n>& k, const int* slot, S* values) {
    for (const S& entry : k.x) values[*slot++] += entry;
  }

  // ---- elements of one law, side by side ----
  // Calls together<L>(first, count) for elements of one law, as many at once as registers hold, and alone(i) for the others.
  template <class Together, class Alone>
  void each_element(const Together& together, const Alone& alone) const {
    for (std::size_t i = 0; i < entries_.size();) {
      if constexpr (LaneKernel<E>) {
        std::size_t end = i + 1;
        while (end < entries_.size() && lanes_[end].like_previous) ++end;
        if (end - i > 1)
          in_lanes([&]<int L>() {
            for (std::size_t count; end - i > 1; i += count) {
              count = std::min<std::size_t>(L, end - i);
              together.template operator()<L>(i, static_cast<int>(count));
            }
          });
        if (i == end) continue;
      }
      alone(i++);
    }
  }
  void compare_laws(int changed) {
    if constexpr (LaneKernel<E>) {
      const auto last = static_cast<int>(entries_.size()) - 1;
      if (lanes_.size() < entries_.size()) {
        lanes_.emplace_back();
        for (int i = 0; i < fours; ++i) lanes_.back().fours[i] = entries_.back().dofs[four(i)];
      }
      for (int i = std::max(changed, 1); i <= std::min(changed + 1, last); ++i) {
        const Entry &e = entries_[i], &previous = entries_[i - 1];
        lanes_[i].like_previous = E::same_law(previous.parameters, previous.constants, e.parameters, e.constants);
      }
    }
  }
  // Numbers move in fours. Where those of a node are no multiple, the last four begin before the others end: what has moved
  // already is read once more, and not added again.
  static constexpr int node_size = [] {
    if constexpr (LaneKernel<E>) return E::node_size;
    return 4;
  }();
  static constexpr int fours_per_node = (node_size + 3) / 4, fours = n / node_size * fours_per_node;
  static constexpr int four(int i) {
    return i / fours_per_node * node_size + std::min(i % fours_per_node * 4, node_size - 4);
  }
  static constexpr bool moved_before(int i, int j) { return i % fours_per_node > 0 && four(i) + j < four(i - 1) + 4; }
  // Number j of four i out of number(k), for those to be added.
  template <int i, class Number>
  static auto four_of(const Number& number) {
    using S = decltype(number(0));
    return [&]<int... j>(std::integer_sequence<int, j...>) {
      return std::array<S, 4>{(moved_before(i, j) ? S(0.0) : number(four(i) + j))...};
    }(std::make_integer_sequence<int, 4>{});
  }
  template <class Call>
  static void each_four(const Call& call) {
    [&]<int... i>(std::integer_sequence<int, i...>) { (call.template operator()<i>(), ...); }(std::make_integer_sequence<int, fours>{});
  }
  // Where four i of each lane begins; lanes without an element repeat the last one.
  template <int L, class T>
  std::array<T*, L> places(T* vector, std::size_t first, int count, int i) const {
    std::array<T*, L> at;
    for (int lane = 0; lane < L; ++lane) at[lane] = vector + lanes_[first + std::min(lane, count - 1)].fours[i];
    return at;
  }
  template <int L>
  Vec<Pack<L>, n> gather_lanes(const double* from, std::size_t first, int count) const {
    Vec<Pack<L>, n> x;
    each_four([&]<int i>() {
      const auto numbers = gather_fours<L>(places<L>(from, first, count, i));
      for (int j = 0; j < 4; ++j) x[four(i) + j] = numbers[j];
    });
    return x;
  }
  template <int L>
  Coordinates<Pack<L>, n> gather_lanes(const Evaluation& evaluation, std::size_t first, int count) const {
    const auto gathered = [&](const double* from) { return gather_lanes<L>(from, first, count); };
    return {gathered(evaluation.q), gathered(evaluation.v), evaluation.inertia ? gathered(evaluation.a) : Vec<Pack<L>, n>{}};
  }
  template <int L>
  void residuals_in_lanes(std::size_t first, int count, const Evaluation& evaluation, double* r) const {
    const Entry* e = &entries_[first];
    const auto x = gather_lanes<L>(evaluation, first, count);
    const auto f = element_residual<E, Pack<L>>(e->parameters, e->constants, context(evaluation, *e), x);
    each_four([&]<int i>() {
      scatter_fours<L>(four_of<i>([&](int row) { return f[row]; }), places<L>(r, first, count, i), count);
    });
  }
  template <int L>
  void tangents_in_lanes(std::size_t first, int count, const Evaluation& evaluation, const Weights& weights, const int* slot,
                         double* values) const {
    const Entry* e = &entries_[first];
    const auto k = E::tangent(e->parameters, e->constants, context(evaluation, *e), gather_lanes<L>(evaluation, first, count), weights);
    each_four([&]<int i>() {
      for (int column = 0; column < n; ++column) {
        std::array<double*, L> at;  // the rows of one node lie side by side (system/pattern.hpp)
        for (int lane = 0; lane < L; ++lane) at[lane] = values + slot[(std::min(lane, count - 1) * n + four(i)) * n + column];
        scatter_fours<L>(four_of<i>([&](int row) { return k(row, column); }), at, count);
      }
    });
  }

  // All that the loop over lanes reads of an element whose law it knows.
  struct Lane {
    std::array<int, ElementBatch::fours> fours{};  // where they begin among the coordinates
    bool like_previous = false;      // its law is that of the element before
  };
  std::vector<Lane> lanes_;
};

}  // namespace dalembert
