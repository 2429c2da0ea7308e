// Connectors and loads: kernels that turn the frames of their markers into forces on them.
#pragma once

#include <algorithm>
#include <concepts>
#include <functional>
#include <memory>
#include <span>
#include <utility>

#include "dalembert/batches/histories.hpp"
#include "dalembert/batches/span_laws.hpp"
#include "dalembert/batches/many_ports.hpp"
#include "dalembert/batches/port_sweep.hpp"
#include "dalembert/batches/span_tangent.hpp"
#include "dalembert/contracts/data_node.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/system/marker_forces.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

// forces(p, c, m0, m1): the forces that the connector applies to its markers, per marker. Loads have one marker.
template <class K, int M, class S>
auto kernel_forces(const typename K::Parameters& p, const Context& c,
                   const std::array<typename K::Port::template Frame<S>, M>& frames) {
  if constexpr (M == 1) {
    return std::array{K::template force<S>(p, c, frames[0])};
  } else {
    return K::template forces<S>(p, c, frames[0], frames[1]);
  }
}

template <class K, class Record, int M>
class PortBatch final : public Term, public MarkerForces {
 public:
  using Port = typename K::Port;

  void reserve(int entries) override {
    entries_.reserve(static_cast<std::size_t>(entries));
    if constexpr (SpanLawConnector<K>) spans_.reserve(static_cast<std::size_t>(entries));
  }
  void add(const void* record, const Placement& placement, const Ports& ports) override {
    Entry e;
    e.parameters = parameters_between_markers<typename K::Parameters, Record>(record);
    for (int m = 0; m < M; ++m) {
      e.markers[m] = placement.markers[m];
      e.offsets[m] = ports.offsets(placement.markers[m]);
    }
    e.item = placement.item;
    e.first_data = placement.first_data;
    e.data_count = placement.data_count;
    entries_.push_back(std::move(e));
    if constexpr (SpanLawConnector<K>) {
      spans_.add(entries_.back().markers, ports);
      take_law(static_cast<int>(entries_.size()) - 1);
    }
  }
  void refresh(int entry, const void* record) override {
    entries_[entry].parameters = parameters_between_markers<typename K::Parameters, Record>(record);
    if constexpr (SpanLawConnector<K>) take_law(entry);
  }
  void visit(BlockVisitor& visitor, const Ports& ports) const override {
    if constexpr (is_constant) return;
    for (const Entry& e : entries_) {
      const auto dofs = all_dofs<M>(ports, e.markers);
      visitor.block(dofs, dofs);
    }
  }

  void residual(const Evaluation& evaluation, Ports& ports, double*) const override {
    if constexpr (SpanLawConnector<K>) {
      spans_.add_forces(ports.values.data(), ports.forces.data());
      const auto by_number = [this](int entry) -> const Entry& { return entries_[entry]; };
      add_forces_of(spans_.without_law(), by_number, evaluation, ports, std::make_index_sequence<M>());
    } else {
      add_forces_of(entries_, std::identity(), evaluation, ports, std::make_index_sequence<M>());
    }
  }
  void add_marker_forces(int entry, const Evaluation& evaluation, Ports& ports) const override {
    add_forces_of(std::span(&entries_[static_cast<std::size_t>(entry)], 1), std::identity(), evaluation, ports,
                  std::make_index_sequence<M>());
  }
  void tangent(const Evaluation& evaluation, const Weights&, Ports& ports, double* values) const override {
    if constexpr (is_constant) return;
    const auto add = [&](const Entry& e, const Columns<M>& columns, const int* slot) {
      if (!add_in_closed_form(e, ports, slot, values)) sweep(e, evaluation, columns, ports, slot, values);
    };
    if constexpr (SpanLawConnector<K>) {
      spans_.add_tangents(ports, slots.data(), values, [&](int entry, const int* slot) __attribute__((noinline)) {
        return with_block(entries_[entry], ports, slot, add);
      });
    } else {
      each_block(ports, add);
    }
  }

  bool has_tangent() const override { return !is_constant; }
  bool has_moments() const override { return !std::is_same_v<Port, PointPort>; }

  bool traceable() const override {
    return is_traced && std::ranges::all_of(entries_, [](const Entry& e) { return has_closed_form(e.parameters); });
  }
  void trace(const TracedCall& call) const override {
    if constexpr (is_traced) {
      if (call.function == TracedCall::Function::residual)
        return add_forces_of(entries_, std::identity(), call.evaluation, call.ports, std::make_index_sequence<M>());
      if constexpr (!is_constant)
        each_block(call.ports, [&](const Entry& e, const Columns<M>&, const int* slot) {
          add_in_closed_form(e, call.ports, slot, call.sums);
        });
    }
  }

  // K::update(p, c, m0, m1, start, data): new history from the frames; returns the error and a recommended step size.
  PostNewton post_newton(const Evaluation& evaluation, const Ports& ports, const double* start, double* data,
                         double*) override {
    return Histories<History>::update(entries_, with_history(evaluation, ports, start, data));
  }
  bool has_history() const override { return has_update; }
  bool has_switches() const override { return History::has_switches; }
  void find_switches(const Evaluation& evaluation, const Ports& ports, Switches& switches) const override {
    Histories<History>::find_switches(
        entries_,
        [&](const Entry& e, const auto& call) {
          const auto frames = read(ports, e);
          call(context(evaluation, e), frames[0], frames[1]);
        },
        switches);
  }
  void switch_over(const Evaluation& evaluation, const Ports& ports, const double* before, double* data,
                   double*) override {
    Histories<History>::switch_over(entries_, with_history(evaluation, ports, before, data));
  }
  PostNewton settle(const Evaluation& evaluation, const Ports& ports, const double* start, double* data,
                    double*) override {
    return Histories<History>::settle(entries_, with_history(evaluation, ports, start, data));
  }

  bool output(int entry, OutputVariableType variable, const Vec3<double>&, const Evaluation& evaluation,
              const Ports& ports, std::vector<double>& values) const override {
    const Entry& e = entries_[entry];
    const auto frames = read(ports, e);
    if constexpr (M == 2)
      return K::output(e.parameters, context(evaluation, e), frames[0], frames[1], variable, values);
    else
      return false;
  }

 private:
  // Markers are spelt out, not looped over, so that frames and forces stay in registers.
  template <class S, std::size_t... m>
  static void add_forces_of(const auto& which, const auto& entry_of, const EvaluationOf<S>& evaluation,
                            PortsOf<S>& ports, std::index_sequence<m...>) {
    const S* values = ports.values.data();
    S* sums = ports.forces.data();
    Context c = Context::of(evaluation, -1);
    for (const auto& each : which) {
      const Entry& e = entry_of(each);
      if (!is_active(e.parameters)) continue;
      e.place(c, evaluation);
      const auto forces = kernel_forces<K, M, S>(e.parameters, c, {read_frame<Port>(values + e.offsets[m].value)...});
      (add_force(sums + e.offsets[m].force, 1.0, forces[m]), ...);
    }
  }

  static constexpr bool is_load = M == 1;
  // Loads have no history, and connectors are never constant.
  using History = std::conditional_t<is_load, NoPairHistory, K>;
  using Change = std::conditional_t<is_load, K, ReadsMarker>;
  static constexpr bool has_update = History::has_history, has_data = History::data_coordinates != 0,
                        is_constant = Change::is_constant;
  // Whether its arithmetic may be traced, if `has_closed_form` is also true.
  static constexpr bool is_traced = is_load || (!has_update && TracedSpanConnector<K>);

  struct Entry {
    typename K::Parameters parameters;
    std::array<int, M> markers{};
    std::array<PortOffsets, M> offsets{};
    int item = -1, first_data = -1, data_count = 0;

    // Builds the context of an entry.
    template <class S>
    void place(Context& c, const EvaluationOf<S>& evaluation) const {
      c.item = item;
      if constexpr (has_data) {
        c.data = first_data < 0 ? nullptr : evaluation.data + first_data;
        c.data_count = data_count;
      }
    }
  };

  auto with_history(const Evaluation& evaluation, const Ports& ports, const double* start, double* data) const {
    return [=, &evaluation, &ports](const Entry& e, const auto& call) {
      if (e.first_data < 0) return;
      const auto frames = read(ports, e);
      call(context(evaluation, e), frames[0], frames[1], start + e.first_data, data + e.first_data);
    };
  }
  static Context context(const Evaluation& evaluation, const Entry& e) {
    Context c = Context::of(evaluation, e.item);
    e.place(c, evaluation);
    return c;
  }
  template <class S>
  static std::array<typename Port::template Frame<S>, M> read(const PortsOf<S>& ports, const Entry& e) {
    std::array<typename Port::template Frame<S>, M> frames;
    for (int m = 0; m < M; ++m) frames[m] = read_frame<Port>(ports, e.markers[m]);
    return frames;
  }

  // Calls f(entry, columns, slots) for those that act, with the block of the tangent that is theirs.
  template <class S, class F>
  void each_block(const PortsOf<S>& ports, const F& f) const {
    const int* slot = slots.data();
    for (const Entry& e : entries_) slot = with_block(e, ports, slot, f);
  }
  template <class S, class F>
  static const int* with_block(const Entry& e, const PortsOf<S>& ports, const int* slot, const F& f) {
    const Columns<M> columns(ports, e.markers);
    if (is_active(e.parameters)) f(e, columns, slot);
    return slot + columns.total * columns.total;
  }
  static void sweep(const Entry& e, const Evaluation& evaluation, const Columns<M>& columns, Ports& ports,
                    const int* slot, double* values) {
    for (int first = 0; first < columns.total; first += sweep_width) {
      std::array<typename Port::template Frame<SweepDual>, M> frames;
      for (int m = 0; m < M; ++m) frames[m] = read_moving_frame<Port>(ports, e.markers[m], columns.offset[m], first);
      const auto forces = kernel_forces<K, M, SweepDual>(e.parameters, context(evaluation, e), frames);
      scatter_forces<Port, M>(ports, e.markers, columns, first, -1.0, forces, slot, values);
    }
  }

  // A load that does not read its marker adds nothing.
  static bool has_closed_form(const typename K::Parameters& p) {
    if constexpr (is_load)
      return !K::reads_marker(p);
    else if constexpr (SpanConnector<K>)
      return K::has_tangent(p);
    else
      return false;
  }
  template <class S>
  static bool add_in_closed_form(const Entry& e, const PortsOf<S>& ports, const int* slots, S* values) {
    if (!has_closed_form(e.parameters)) return false;
    if constexpr (SpanConnector<K>) {
      const auto frames = read(ports, e);
      add_span_tangent(ports, e.markers, K::tangent(e.parameters, frames[0], frames[1]), slots, values);
    }
    return true;
  }

  // Connectors with user functions have no law; an inactive connector has a law with zero force.
  void take_law(int entry)
    requires SpanLawConnector<K>
  {
    const typename K::Parameters& p = entries_[entry].parameters;
    if (!has_closed_form(p))
      spans_.drop_law(entry);
    else
      spans_.set_law(entry, is_active(p) ? K::law(p) : spans_.no_force);
  }

  std::vector<Entry> entries_;
  [[no_unique_address]] typename SpansOf<K>::Type spans_;
};

template <class K, class Record>
struct PairPhysics final : ObjectPhysics {
  static_assert(PairConnectorKernel<K>);

  std::unique_ptr<Term> make_batch(std::span<const ItemType* const>) const override {
    return std::make_unique<PortBatch<K, Record, 2>>();
  }
  bool works_without_data(const void* record) const override {
    return !K::needs_data(static_cast<const Record*>(record)->parameters);
  }
  void check(const void* record, const Placement& placement, const Ports& ports, const ItemLabel& item) const override {
    check_markers<typename K::Port>(placement, ports, item);
    int expected = K::data_coordinates;
    if constexpr (requires { K::check(static_cast<const Record*>(record)->parameters, item); }) {
      K::check(static_cast<const Record*>(record)->parameters, item);
      expected = K::data_of(static_cast<const Record*>(record)->parameters);
    }
    if (expected > 0 && !placement.nodes.empty() && placement.data_count != expected)
      refuse(ErrorKind::value,
             {item, "nodeNumber", "", "a node with " + std::to_string(placement.data_count) + " data coordinates",
              data_node_of(expected), ""});
  }
};

// Selects the batch for two markers of one shape, or for any number of markers.
template <class K, class Record>
using ConnectorPhysics =
    std::conditional_t<requires { typename K::Port; }, PairPhysics<K, Record>, ManyPortsPhysics<K, Record>>;

}  // namespace dalembert
