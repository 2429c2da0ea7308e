// Constraints and joints: gap equations between two markers, and the reaction that Lagrange multipliers make of them.
//
// The rate is the gap's derivative along the motion of the frames, the reaction its derivative by virtual motions of the frames,
// unless a kernel states them in closed form. A nonholonomic kernel has no gap, but `gap_rate` and `reaction`.
#pragma once

#include <concepts>
#include <memory>
#include <utility>

#include "dalembert/batches/groups.hpp"
#include "dalembert/batches/joint_tangent.hpp"
#include "dalembert/batches/many_ports.hpp"
#include "dalembert/batches/port_sweep.hpp"
#include "dalembert/contracts/linear_equations.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/contracts/variation.hpp"
#include "dalembert/math/wide_registers.hpp"
#include "dalembert/system/marker_forces.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

template <class K, class Record>
class ConstraintBatch final : public Term, public MarkerForces {
 public:
  using Port = typename K::Port;
  using Parameters = typename K::Parameters;
  static constexpr int m = K::equations;
  template <class S>
  using Frames = std::array<typename Port::template Frame<S>, 2>;

  void reserve(int entries) override { entries_.reserve(static_cast<std::size_t>(entries)); }
  void add(const void* record, const Placement& placement, const Ports& ports) override {
    Entry e;
    e.parameters = parameters_between_markers<Parameters, Record>(record);
    e.markers = {placement.markers[0], placement.markers[1]};
    e.offsets = {ports.offsets(placement.markers[0]), ports.offsets(placement.markers[1])};
    e.item = placement.item;
    e.first_ae = placement.first_ae;
    e.first_row = placement.ae_offset + placement.first_ae;
    e.write_table();
    entries_.push_back(std::move(e));
  }
  void refresh(int entry, const void* record) override {
    entries_[entry].parameters = parameters_between_markers<Parameters, Record>(record);
    entries_[entry].write_table();
  }
  void visit(BlockVisitor& visitor, const Ports& ports) const override {
    for (const Entry& e : entries_) {
      const auto dofs = all_dofs<2>(ports, e.markers);
      std::array<int, m> rows;
      for (int k = 0; k < m; ++k) rows[k] = e.first_row + k;
      visitor.block(rows, dofs);
      visitor.mirror(rows, dofs);  // multipliers, in the rows of the coordinates
      const auto turns = varying_reaction(ports, e);
      for (std::size_t i = 0; i < dofs.size(); ++i)
        for (std::size_t j = 0; j < dofs.size(); ++j)
          turns[i] && turns[j] ? visitor.entry(dofs[i], dofs[j]) : visitor.zero();
      for (int k = 0; k < m; ++k) visitor.block(std::span(&rows[k], 1), std::span(&rows[k], 1));
    }
  }

  void residual(const Evaluation& evaluation, Ports& ports, double* r) const override {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if constexpr (requires { K::is_table; }) {
        const std::size_t first = i;
        while (i < entries_.size() && by_table(entries_[i], evaluation)) ++i;
        if (i > first) add_tables(first, i, evaluation, ports, r);
        if (i == entries_.size()) return;
      }
      add_residual<double>(entries_[i], evaluation, ports, r);
    }
  }
  void add_marker_forces(int entry, const Evaluation& evaluation, Ports& ports) const override {
    const Entry& e = entries_[static_cast<std::size_t>(entry)];
    if (!is_active(e.parameters)) return;
    add_forces<Port, 2>(ports, e.markers, -1.0,
                        reaction<double>(e.parameters, Context::of(evaluation, e.item), read(ports, e),
                                         load<double, m>(evaluation.lambda + e.first_ae)));
  }
  bool traceable() const override { return LinearConstraint<K>; }
  void trace(const TracedCall& call) const override {
    if constexpr (LinearConstraint<K>) {
      if (call.function == TracedCall::Function::tangent)
        return add_linear_blocks(call.evaluation, call.weights, call.ports, call.sums);
      for (const Entry& e : entries_) add_residual<Traced>(e, call.evaluation, call.ports, call.sums);
    }
  }

  void tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports, double* values) const override {
    if constexpr (LinearConstraint<K>) return add_linear_blocks(evaluation, weights, ports, values);
    const double scale = row_scale(weights);
    each_block(ports, values, [&](const Entry& e, const Columns<2>& columns, const BlockSlots& blocks) {
      if constexpr (TabulatedJoint<K>)
        if (!evaluation.rate_level && weights.q != 0 && in_closed_form(e, ports)) {
          in_wide_registers([&] { closed_form(e, evaluation, weights, ports, blocks.gaps, values); });
          return;
        }
      const Context c = Context::of(evaluation, e.item);
      multiplier_columns(e, c, ports, columns, blocks.multipliers, values);
      const Vec<double, m> lambda = load<double, m>(evaluation.lambda + e.first_ae);
      for (int first = 0; first < columns.total; first += sweep_width) {
        Frames<SweepDual> frames;
        for (int i = 0; i < 2; ++i) frames[i] = read_moving_frame<Port>(ports, e.markers[i], columns.offset[i], first);
        const auto g = equations<SweepDual>(e.parameters, c, frames, evaluation.rate_level);
        const int count = std::min(sweep_width, columns.total - first);
        for (int k = 0; k < m; ++k)
          if (K::constrains(e.parameters, k))
            for (int j = 0; j < count; ++j) values[blocks.gaps[k * columns.total + first + j]] += scale * g[k].d[j];
        const auto forces = reaction<SweepDual>(e.parameters, c, frames, lambda);
        scatter_forces<Port, 2>(ports, e.markers, columns, first, 1.0, forces, blocks.forces, values);
      }
    });
  }

  bool output(int entry, OutputVariableType variable, const Vec3<double>&, const Evaluation& evaluation,
              const Ports& ports, std::vector<double>& values) const override {
    const Entry& e = entries_[entry];
    const auto frames = read(ports, e);
    const Context c = Context::of(evaluation, e.item);
    if (variable == OutputVariableType::ConstraintEquation) {
      const auto g = equations<double>(e.parameters, c, frames, evaluation.rate_level);
      values.assign(g.x.begin(), g.x.end());
      return true;
    }
    const auto lambda = load<double, m>(evaluation.lambda + e.first_ae);
    return K::output(e.parameters, c, frames[0], frames[1], lambda, variable, values);
  }

 private:
  struct Table {
    std::array<JointEquation, m> equations;
    const JointEquation& operator[](std::size_t k) const { return equations[k]; }
  };
  struct NoTable {};
  struct Entry {
    Parameters parameters;
    [[no_unique_address]] std::conditional_t<TabulatedJoint<K>, Table, NoTable> table;  // table for these parameters
    std::array<int, 2> markers{};
    std::array<PortOffsets, 2> offsets{};
    int item = -1, first_ae = -1, first_row = -1;

    void write_table() {
      if constexpr (TabulatedJoint<K>) table = {K::table(parameters)};
    }
  };

  // Joints that are fully described by their table compute gap and reaction together.
  static bool by_table(const Entry& e, const Evaluation& evaluation) {
    return is_active(e.parameters) && !at_rate_level(e.parameters, evaluation.rate_level);
  }
  void add_tables(std::size_t begin, std::size_t end, const Evaluation& evaluation, Ports& ports, double* r) const {
    each_group(begin, end, [&]<int L>(const Group<L>& group) {
      using S = Numbers<L>;
      struct Axes {
        Vec3<S> first, second;
      };
      std::array<Axes, m> table;
      for (std::size_t k = 0; k < m; ++k) {
        const auto axes = gathered<6>(group.each([&](std::size_t i) { return entries_[i].table[k].first.x.data(); }));
        table[k] = {segment<3>(axes, 0), segment<3>(axes, 3)};
      }
      const auto frame = [&](std::size_t marker) {
        const double* values = ports.values.data();
        return gathered<RigidFrame>(
            group.each([&](std::size_t i) { return &read_frame<Port>(values + entries_[i].offsets[marker].value); }));
      };
      const auto lambda =
          gathered<m>(group.each([&](std::size_t i) { return evaluation.lambda + entries_[i].first_ae; }));
      const auto sums = joint_sums<K::rows>(table, frame(0), frame(1), lambda);
      add_numbers(sums.gap, group.each([&](std::size_t i) { return r + entries_[i].first_row; }), group.count);
      for (std::size_t marker = 0; marker < 2; ++marker) {
        const auto places =
            group.each([&](std::size_t i) { return ports.forces.data() + entries_[i].offsets[marker].force; });
        add_numbers(joined(-sums.reaction[marker].force, -sums.reaction[marker].moment), places, group.count);
      }
    });
  }

  static bool at_rate_level(const Parameters& p, bool rate_level) {
    if constexpr (requires { p.velocityLevel; }) return rate_level || p.velocityLevel;
    return rate_level;
  }
  static double row_scale(const Weights& weights) { return 1 / (weights.q != 0 ? weights.q : weights.v); }
  template <class S>
  static Frames<S> read(const PortsOf<S>& ports, const Entry& e) {
    return {read_frame<Port>(ports, e.markers[0]), read_frame<Port>(ports, e.markers[1])};
  }

  template <class S>
  static void add_residual(const Entry& e, const EvaluationOf<S>& evaluation, PortsOf<S>& ports, S* r) {
    const S* lambda = evaluation.lambda + e.first_ae;
    S* gap = r + e.first_row;
    if (!is_active(e.parameters)) {
      for (int k = 0; k < m; ++k) gap[k] += lambda[k];
      return;
    }
    const auto frames = read(ports, e);
    const Context c = Context::of(evaluation, e.item);
    const auto g = equations<S>(e.parameters, c, frames, evaluation.rate_level);
    for (int k = 0; k < m; ++k) gap[k] += K::constrains(e.parameters, k) ? g[k] : lambda[k];
    add_forces<Port, 2>(ports, e.markers, -1.0, reaction<S>(e.parameters, c, frames, load<S, m>(lambda)));
  }

  // Starts of the blocks of one constraint: gaps by coordinates, multipliers transposed, coordinates by coordinates.
  struct BlockSlots {
    const int *gaps, *multipliers, *forces, *diagonal;
    BlockSlots(const int* first, int coordinates)
        : gaps(first),
          multipliers(gaps + m * coordinates),
          forces(multipliers + m * coordinates),
          diagonal(forces + coordinates * coordinates) {}
    const int* end() const { return diagonal + m; }
  };
  // Calls f(entry, columns, slots) for those that constrain something.
  template <class S, class F>
  void each_block(const PortsOf<S>& ports, S* values, const F& f) const {
    const int* slot = slots.data();
    for (const Entry& e : entries_) {
      const Columns<2> columns(ports, e.markers);
      const BlockSlots blocks(slot, columns.total);
      slot = blocks.end();
      if (add_diagonal(e, blocks, values)) f(e, columns, blocks);
    }
  }
  // Equation for multipliers of inactive constraints. Returns false if there are none.
  template <class S>
  static bool add_diagonal(const Entry& e, const BlockSlots& slots, S* values) {
    for (int k = 0; k < m; ++k)
      if (!K::constrains(e.parameters, k) || !is_active(e.parameters)) values[slots.diagonal[k]] += 1;
    return is_active(e.parameters);
  }

  template <class S>
  static Vec<S, m> equations(const Parameters& p, const Context& c, const Frames<S>& f, bool rate_level) {
    if constexpr (K::nonholonomic) {
      return K::template gap_rate<S>(p, c, f[0], f[1]);
    } else {
      return at_rate_level(p, rate_level) ? gap_rate<K, S>(p, c, f[0], f[1]) : gap<K, S>(p, c, f[0], f[1]);
    }
  }
  template <class S, class L>
  static std::array<typename Port::template Force<S>, 2> reaction(const Parameters& p, const Context& c,
                                                                  const Frames<S>& f, const Vec<L, m>& multipliers) {
    Vec<L, m> lambda = multipliers;
    for (int k = 0; k < m; ++k)
      if (!K::constrains(p, k)) lambda[k] = 0;
    if constexpr (StatesReaction<K>) {
      return K::template reaction<S>(p, c, f[0], f[1], lambda);
    } else {
      return virtual_work<K, S>(p, c, f[0], f[1], lambda);
    }
  }

  using Tangent = JointTangent<typename Frames<double>::value_type>;

  // Coordinates of the markers that vary the reaction: those that rotate a frame for a joint along fixed directions,
  // none for a linear constraint.
  static std::vector<bool> varying_reaction(const Ports& ports, const Entry& e) {
    std::vector<bool> turns;
    for (const int marker : e.markers) {
      const PortLayout& port = ports.ports[marker];
      const int still = LinearConstraint<K> ? port.n : K::fixed_directions ? port.translations : 0;
      for (int i = 0; i < port.n; ++i) turns.push_back(i >= still);
    }
    return turns;
  }

  static bool in_closed_form(const Entry& e, const Ports& ports) {
    if (!K::tabulated(e.parameters)) return false;
    if constexpr (requires { e.parameters.velocityLevel; })
      if (e.parameters.velocityLevel) return false;
    return Tangent::fits(ports, e.markers);
  }
  // Slots: gaps by coordinates, multipliers transposed, coordinates by coordinates.
  static void closed_form(const Entry& e, const Evaluation& evaluation, const Weights& weights, const Ports& ports,
                          const int* slots, double* values) {
    const Frames<double> frames = read(ports, e);
    Tangent tangent(ports, e.markers, frames);
    const int total = tangent.total();
    const double* lambda = evaluation.lambda + e.first_ae;
    for (int k = 0; k < m; ++k)
      if (K::constrains(e.parameters, k))
        tangent.add(e.table[static_cast<std::size_t>(k)], lambda[k], 1 / weights.q, slots + k * total,
                    slots + (m + k) * total, values);
    tangent.add_forces(slots + 2 * m * total, values);
  }

  template <class S>
  void add_linear_blocks(const EvaluationOf<S>& evaluation, const Weights& weights, const PortsOf<S>& ports,
                         S* values) const {
    each_block(ports, values, [&](const Entry& e, const Columns<2>&, const BlockSlots& blocks) {
      add_linear(e, ports, at_rate_level(e.parameters, evaluation.rate_level), row_scale(weights), blocks.gaps, values);
    });
  }
  // Slots: gaps by coordinates, multipliers transposed. Forces do not change with the coordinates.
  template <class S>
  static void add_linear(const Entry& e, const PortsOf<S>& ports, bool rate, double row_scale, const int* slots,
                         S* values) {
    const Columns<2> columns(ports, e.markers);
    const auto equations = K::linear(e.parameters);
    for (int k = 0; k < m; ++k) {
      const LinearEquation& equation = equations[static_cast<std::size_t>(k)];
      const int component = equation.component;
      for (int i = 0; i < 2; ++i) {
        const auto [n, translations] = std::pair(ports.ports[e.markers[i]].n, ports.ports[e.markers[i]].translations);
        const double factor = equation.factor[i];
        const int* gap = slots + k * columns.total + columns.offset[i];
        const int* multiplier = gap + m * columns.total;
        const S* derivative = ports.derivative(e.markers[i]) + (component + (rate ? Port::forces : 0)) * n;
        const S* jacobian = ports.jacobian(e.markers[i]) + component * n;
        const auto add = [&](int j) {
          values[gap[j]] += row_scale * factor * derivative[j];
          values[multiplier[j]] += factor * jacobian[j];
        };
        if (component < translations) add(component);
        for (int j = translations; j < n; ++j) add(j);
      }
    }
  }

  // Rows of the coordinates, columns of the multipliers: J^T of the reaction to each unit multiplier.
  static void multiplier_columns(const Entry& e, const Context& c, const Ports& ports, const Columns<2>& columns,
                                 const int* slots, double* values) {
    const auto frames = read(ports, e);
    for (int k = 0; k < m; ++k) {
      if (!K::constrains(e.parameters, k)) continue;
      Vec<double, m> unit;
      unit[k] = 1;
      const auto forces = reaction<double>(e.parameters, c, frames, unit);
      for (int i = 0; i < 2; ++i) {
        const int n = ports.ports[e.markers[i]].n;
        const double* jacobian = ports.jacobian(e.markers[i]);
        const double* force = reinterpret_cast<const double*>(&forces[i]);
        for (int j = 0; j < n; ++j) {
          double sum = 0;
          for (int f = 0; f < Port::forces; ++f) sum += jacobian[f * n + j] * force[f];
          values[slots[k * columns.total + columns.offset[i] + j]] += sum;
        }
      }
    }
  }

  std::vector<Entry> entries_;
};

template <class K, class Record>
struct PairConstraintPhysics final : ObjectPhysics {
  static_assert(PairConstraintKernel<K>);

  std::unique_ptr<Term> make_batch(std::span<const ItemType* const>) const override {
    return std::make_unique<ConstraintBatch<K, Record>>();
  }
  int algebraic_equations(const void*, std::span<const int>) const override { return K::equations; }
  Holding holds(const void* record) const override {
    if constexpr (LinearConstraint<K>) {
      const auto& p = static_cast<const Record*>(record)->parameters;
      if (!is_active(p)) return Holding::nothing;
      if (K::is_homogeneous(p)) return Holding::zero;
    }
    return Holding::unknown;
  }
  void check(const void*, const Placement& placement, const Ports& ports, const ItemLabel& item) const override {
    check_markers<typename K::Port>(placement, ports, item);
  }
};

// Selects the batch for two markers of one shape, or for any number of markers.
template <class K, class Record>
using ConstraintPhysics =
    std::conditional_t<requires { typename K::Port; }, PairConstraintPhysics<K, Record>, ManyPortsPhysics<K, Record>>;

}  // namespace dalembert
