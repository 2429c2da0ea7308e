// All elements of one type side by side: bodies on nodes and finite elements. There is no other loop over them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "dalembert/batches/element_parameters.hpp"
#include "dalembert/batches/groups.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

template <class E, class Record>
class ElementBatch : public Term {
 public:
  static constexpr int n = E::size;
  static constexpr bool is_diagonal = E::traits.diagonal;  // its tangent
  static constexpr int slots_per_entry = is_diagonal ? n : n * n;
  static constexpr bool is_summed_here = n > 0 && !RotatingBodyElement<E>;  // RotatingBodyBatch sums by itself

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
        if constexpr (!is_diagonal)
          visitor.block(e.dofs, e.dofs);
        else
          for (const int dof : e.dofs) visitor.entry(dof, dof);
      }
  }

  void residual(const Evaluation& evaluation, Ports&, double* r) const override {
    if (PureInertia<E> && !evaluation.inertia) return;
    if constexpr (is_summed_here)
      each_element([&](const auto& group) { residuals_in_lanes(group, evaluation, r); },
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
        call.function == TracedCall::Function::residual
            ? add_residual(entries_[i], call.evaluation, call.sums)
            : add_tangent(entries_[i], call.evaluation, call.weights, slots_of(i), call.sums);
  }
  bool has_mass() const override { return n > 0; }
  bool reads_totals() const override { return !PureInertia<E>; }
  bool add_diagonal_masses(const Evaluation& evaluation, double* diagonal) const override {
    if constexpr (is_diagonal && PureInertia<E>)
      for (const Entry& e : entries_) add_mass(e, evaluation, 1.0, e.dofs.data(), diagonal);
    return n == 0 || (is_diagonal && PureInertia<E>);
  }
  // If rates are spins, only the lever arm of a center of mass rotates.
  bool constant_mass() const override {
    if constexpr (RotatingBodyElement<E>) {
      if constexpr (LieKernel<typename E::OwnRotation> && E::Kernel::traits.constant_mass)
        return std::ranges::none_of(
            entries_, [](const Entry& e) { return E::Kernel::mass_properties(e.parameters).eccentric(); });
    }
    return E::traits.constant_mass;
  }

  bool motion(int entry, const Evaluation& evaluation, const Vec3<double>& local, Motion<double>& m) const override {
    const Entry& e = entries_[entry];
    m = E::template motion<double>(e.parameters, gather<n>(evaluation, e.dofs.data()), local);
    return true;
  }
  // Inlining removes the computation of the remaining motion.
  [[gnu::flatten]] void poses(int first, int count, const Evaluation& evaluation, double* rows) const override {
    if constexpr (moves_in_packs) {
      const auto begin = static_cast<std::size_t>(first), end = begin + static_cast<std::size_t>(count);
      each_group(begin, end, [&]<int L>(const Group<L>& group) {
        // consecutive entries
        const auto q = gathered<n>(group.each([&](std::size_t i) { return evaluation.q + entries_[i].dofs[0]; }));
        const auto m = E::OwnRotation::template motion<Numbers<L>>({q, {}, {}});
        store_numbers(pose_numbers(m.position, m.rotation),
                      group.each([&](std::size_t i) { return rows + 12 * (i - begin); }));
      });
    } else if constexpr (requires { typename E::Kernel; }) {
      const Evaluation e = evaluation;  // local copy: the compiler then knows that writing rows does not change it
      for (int i = first; i < first + count; ++i, rows += 12) {
        const Entry& entry = entries_[static_cast<std::size_t>(i)];
        const auto m = E::template motion<double>(entry.parameters, gather<n>(e, entry.dofs.data()), {});
        write_pose(m.position, m.rotation, rows);
      }
    } else {
      Term::poses(first, count, evaluation, rows);
    }
  }
  bool output(int entry, OutputVariableType variable, const Vec3<double>& local, const Evaluation& evaluation,
              const Ports&, std::vector<double>& values) const override {
    const Entry& e = entries_[entry];
    const auto x = gather<n>(evaluation, e.dofs.data());
    const OutputRequest request{variable, local, e.reference.x, evaluation.of_reference};
    return E::output(e.parameters, context(evaluation, e), x, request, values);
  }
  // The kinetic energy is v' M v / 2, where M v are the forces of accelerations v minus those of none.
  bool energy(int entry, Energy kind, const Evaluation& evaluation, double& value) const override {
    value = 0;
    if constexpr (n > 0) {
      const Entry& e = entries_[entry];
      const auto x = gather<n>(evaluation, e.dofs.data());
      if (kind == Energy::potential) {
        if constexpr (requires { E::strain_energy(e.parameters, e.constants, x.q, value); })
          return E::strain_energy(e.parameters, e.constants, x.q, value);
        return true;
      }
      const auto forces = [&](const Vec<double, n>& a) {
        return forces_at<double>(e, evaluation, {.q = x.q, .v = {}, .a = a});
      };
      const auto moving = forces(x.v), resting = forces({});
      for (int i = 0; i < n; ++i) value += 0.5 * x.v[i] * (moving[i] - resting[i]);
    }
    return true;
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
  static constexpr bool moves_in_packs = [] {
    if constexpr (requires { typename E::OwnRotation; })
      return NodeInPacks<typename E::OwnRotation>;
    else
      return false;
  }();
  template <class S>
  static Context context(const EvaluationOf<S>& evaluation, const Entry& e) {
    return Context::of(evaluation, e.item);
  }
  // The call where time does not matter: the compiler then unfolds the kernel into add_residual.
  template <class S>
  [[gnu::noinline]] static Vec<S, n> forces_at(const Entry& e, const EvaluationOf<S>& evaluation,
                                               const Coordinates<S, n>& x) {
    return element_residual<E, S>(e.parameters, e.constants, context(evaluation, e), x);
  }
  template <class S>
  static void add_residual(const Entry& e, const EvaluationOf<S>& evaluation, S* r) {
    const auto x = gather<n>(evaluation, e.dofs.data());
    const auto f = element_residual<E, S>(e.parameters, e.constants, context(evaluation, e), x);
    for (int k = 0; k < n; ++k) r[e.dofs[k]] += f[k];
  }
  template <class S>
  static void add_tangent(const Entry& e, const EvaluationOf<S>& evaluation, const Weights& weights, const int* slot,
                          S* values) {
    if constexpr (PureInertia<E>) return add_mass(e, evaluation, weights.a, slot, values);
    const auto x = gather<n>(evaluation, e.dofs.data());
    if constexpr (TangentKernel<E>) {
      add(E::tangent(e.parameters, e.constants, context(evaluation, e), x, weights), slot, values);
    } else {
      const auto f =
          element_residual<E, Dual<n, S>>(e.parameters, e.constants, context(evaluation, e), seeded<E>(x, weights));
      for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) values[*slot++] += f[row].d[column];
    }
  }

  // Inverse masses of consecutive coordinates; stored once if each coordinate needs only its own force.
  template <class S>
  static void add_mass(const Entry& e, const EvaluationOf<S>& evaluation, double weight, const int* slot, S* values) {
    Coordinates<S, n> x{};
    const auto force = [&] { return forces_at<S>(e, evaluation, x); };
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
    if constexpr (is_summed_here)
      each_element([&](const auto& group) { tangents_in_lanes(group, evaluation, weights, values); },
                   [&](std::size_t i) { add_tangent(entries_[i], evaluation, weights, slots_of(i), values); });
  }

  template <class S>
  static void add(const Mat<S, n, n>& k, const int* slot, S* values) {
    for (const S& entry : k.x) values[*slot++] += entry;
  }

  // ---- elements of one law, side by side ----------------------------------------------------------------------------
  // Calls together(group) for elements of one law, as many at once as registers hold, and alone(i) for the remaining
  // ones.
  template <class Together, class Alone>
  void each_element(const Together& together, const Alone& alone) const {
    for (std::size_t i = 0; i < entries_.size();) {
      if constexpr (LaneKernel<E>)
        if (has_wide_registers()) {
          std::size_t end = i + 1;
          while (end < entries_.size() && lanes_[end].like_previous) ++end;
          const auto in_groups = [&]<int L>() {
            for (std::size_t count; end - i > 1; i += count) {
              count = std::min<std::size_t>(L, end - i);
              together(Group<L>{i, static_cast<int>(count)});
            }
          };
          if constexpr (E::most_lanes == 8)
            if (end - i > 4 && numbers_in_register() == 8)
              run_in_widest_registers([&] { in_groups.template operator()<8>(); });
          if (end - i > 1) run_in_wide_registers([&] { in_groups.template operator()<4>(); });
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
        for (int i = 0; i < nodes; ++i) lanes_.back().starts[i] = entries_.back().dofs[i * node_size];
      }
      for (int i = std::max(changed, 1); i <= std::min(changed + 1, last); ++i) {
        const Entry &e = entries_[i], &previous = entries_[i - 1];
        lanes_[i].like_previous = E::same_law(previous.parameters, previous.constants, e.parameters, e.constants);
      }
    }
  }
  // The numbers of a node lie side by side.
  static constexpr int node_size = [] {
    if constexpr (LaneKernel<E>) return E::node_size;
    return n;
  }();
  static constexpr int nodes = n == 0 ? 0 : n / node_size;

  template <int L>
  Vec<Pack<L>, n> gather_lanes(const double* from, const Group<L>& group) const {
    Vec<Pack<L>, n> x;
    for (int node = 0; node < nodes; ++node) {
      const auto numbers =
          gathered<node_size>(group.each([&](std::size_t i) { return from + lanes_[i].starts[node]; }));
      for (int j = 0; j < node_size; ++j) x[node * node_size + j] = numbers[j];
    }
    return x;
  }
  template <int L>
  Coordinates<Pack<L>, n> gather_lanes(const Evaluation& evaluation, const Group<L>& group) const {
    const auto of = [&](const double* from) { return gather_lanes<L>(from, group); };
    return {of(evaluation.q), of(evaluation.v), evaluation.inertia ? of(evaluation.a) : Vec<Pack<L>, n>{}};
  }
  template <int L>
  void residuals_in_lanes(const Group<L>& group, const Evaluation& evaluation, double* r) const {
    const Entry& e = entries_[group.first];
    const auto f = element_residual<E, Pack<L>>(e.parameters, e.constants, context(evaluation, e),
                                                gather_lanes<L>(evaluation, group));
    for (int node = 0; node < nodes; ++node)
      add_numbers(segment<node_size>(f, node * node_size),
                  group.each([&](std::size_t i) { return r + lanes_[i].starts[node]; }), group.count);
  }
  template <int L>
  void tangents_in_lanes(const Group<L>& group, const Evaluation& evaluation, const Weights& weights,
                         double* values) const {
    const Entry& e = entries_[group.first];
    const auto k =
        E::tangent(e.parameters, e.constants, context(evaluation, e), gather_lanes<L>(evaluation, group), weights);
    for (int row = 0; row < n; row += node_size)  // the rows of one node lie side by side (system/pattern.hpp)
      for (int column = 0; column < n; ++column)
        add_numbers(vector_of<node_size>([&](int j) { return k(row + j, column); }),
                    group.each([&](std::size_t i) { return values + slots_of(i)[row * n + column]; }), group.count);
  }

  // Data of an element with a known law for the loop over lanes.
  struct Lane {
    std::array<int, ElementBatch::nodes> starts{};  // starts of its nodes among the coordinates
    bool like_previous = false;                     // its law is that of the element before
  };
  std::vector<Lane> lanes_;
};

}  // namespace dalembert
