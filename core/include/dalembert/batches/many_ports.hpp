// Connectors and constraints between any number of markers (contracts/many_ports.hpp), side by side.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "dalembert/batches/histories.hpp"
#include "dalembert/batches/port_sweep.hpp"
#include "dalembert/contracts/many_ports.hpp"
#include "dalembert/system/algebraic_coordinates.hpp"
#include "dalembert/system/marker_forces.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

template <ManyPortsKernel K, class Record>
class ManyPortsBatch final : public Term, public AlgebraicCoordinates, public MarkerForces {
 public:
  using Parameters = typename K::Parameters;

  void add(const void* record, const Placement& placement, const Ports& ports) override {
    Entry e;
    e.parameters = parameters_between_markers<Parameters, Record>(record);
    e.item = placement.item;
    e.first_data = placement.first_data;
    e.data_count = placement.data_count;
    e.first_ae = placement.first_ae;
    for (const int marker : placement.markers)
      e.coordinates.push_back(ports.ports[static_cast<std::size_t>(marker)].forces);
    e.algebraic = K::algebraic_equations(e.parameters, e.coordinates);
    for (int k = 0; k < e.algebraic; ++k) e.rows.push_back(placement.ae_offset + placement.first_ae + k);
    e.first_order = placement.ode1;
    for (const int i : placement.ode1) e.rows.push_back(placement.ode1_offset + i);
    const ActingMarkers acting = K::acting(e.parameters, static_cast<int>(placement.markers.size()));
    for (const int position : acting.always) e.markers.push_back(placement.markers[static_cast<std::size_t>(position)]);
    e.always = static_cast<int>(e.markers.size());
    for (const int position : acting.alternatives)
      e.markers.push_back(placement.markers[static_cast<std::size_t>(position)]);
    e.is_full = K::forces_follow_motion(e.parameters);
    for (int i = 0; i < e.cases(); ++i) {
      e.first_slots.push_back(next_slot_);
      int coordinates = 0;
      e.each_marker(i, [&](int marker) { coordinates += ports.ports[marker].n; });
      next_slot_ += Block(e, coordinates).size();
    }
    entries_.push_back(std::move(e));
  }
  void refresh(int entry, const void* record) override {
    Entry& e = entries_[static_cast<std::size_t>(entry)];
    e.parameters = parameters_between_markers<Parameters, Record>(record);
    if (K::algebraic_equations(e.parameters, e.coordinates) != e.algebraic ||
        K::forces_follow_motion(e.parameters) != e.is_full)
      refuse(ErrorKind::state, {"object " + std::to_string(e.item), "",
                                "its equations have changed their number or their kind since the system was assembled",
                                "", "", "Use mbs.ModifyObject(...), then mbs.Assemble()"});
  }
  // Each alternative has rows and columns for the coordinates of its markers, followed by the unknowns of the item.
  void visit(BlockVisitor& visitor, const Ports& ports) const override {
    std::vector<int> all;
    for (const Entry& e : entries_)
      for (int i = 0; i < e.cases(); ++i) {
        all.clear();
        e.each_marker(i, [&](int marker) {
          const auto dofs = ports.marker_dofs(marker);
          all.insert(all.end(), dofs.begin(), dofs.end());
        });
        const std::size_t coordinates = all.size();
        all.insert(all.end(), e.rows.begin(), e.rows.end());
        visitor.block(std::span(all).first(coordinates),
                      e.is_full ? std::span<const int>(all) : std::span<const int>(e.rows));
        visitor.block(e.rows, all);
      }
  }
  void mark(std::span<double> signs) const override {
    for (const Entry& e : entries_)
      for (int k = 0; k < e.algebraic; ++k)
        if (!K::is_multiplier(e.parameters, k)) signs[static_cast<std::size_t>(e.first_ae + k)] = 1;
  }

  void residual(const Evaluation& evaluation, Ports& ports, double* r) const override {
    for (const Entry& e : entries_) {
      take_unknowns(e, evaluation);
      if (is_active(e.parameters)) {
        auto x = exchange(e, evaluation, ports, ports.forces.data());
        K::template evaluate<double>(e.parameters, context(e, evaluation), x);
      } else {
        std::copy_n(unknowns_.begin(), e.algebraic, equations_.begin());
      }
      for (std::size_t k = 0; k < e.rows.size(); ++k) r[e.rows[k]] += equations_[k];
    }
  }
  void add_marker_forces(int entry, const Evaluation& evaluation, Ports& ports) const override {
    const Entry& e = entries_[static_cast<std::size_t>(entry)];
    if (!is_active(e.parameters)) return;
    take_unknowns(e, evaluation);
    auto x = exchange(e, evaluation, ports, ports.forces.data());
    K::template evaluate<double>(e.parameters, context(e, evaluation), x);
  }
  void tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports, double* values) const override {
    for (const Entry& e : entries_) {
      const Context c = context(e, evaluation);
      if (is_active(e.parameters)) {
        sweep(e, c, evaluation, weights, ports, values);
      } else {
        const Block block(e, place_markers(e, 0, ports));
        for (int k = 0; k < e.algebraic; ++k)
          values[slots[static_cast<std::size_t>(e.first_slots[0] + block.unknown(k, block.coordinates + k))]] += 1;
      }
    }
  }

  PostNewton post_newton(const Evaluation& evaluation, const Ports& ports, const double* start, double* data,
                         double* lambda) override {
    return Histories<K>::update(entries_, with_history(evaluation, ports, start, data, lambda));
  }
  bool has_history() const override { return K::has_history; }
  bool has_switches() const override { return K::has_switches; }
  void find_switches(const Evaluation& evaluation, const Ports& ports, Switches& switches) const override {
    Histories<K>::find_switches(
        entries_,
        [&](const Entry& e, const auto& call) {
          take_unknowns(e, evaluation);
          call(context(e, evaluation), exchange(e, evaluation, ports, nullptr));
        },
        switches);
  }
  void switch_over(const Evaluation& evaluation, const Ports& ports, const double* before, double* data,
                   double* lambda) override {
    Histories<K>::switch_over(entries_, with_history(evaluation, ports, before, data, lambda));
  }
  PostNewton settle(const Evaluation& evaluation, const Ports& ports, const double* start, double* data,
                    double* lambda) override {
    return Histories<K>::settle(entries_, with_history(evaluation, ports, start, data, lambda));
  }

  bool output(int entry, OutputVariableType variable, const Vec3<double>&, const Evaluation& evaluation,
              const Ports& ports, std::vector<double>& values) const override {
    const Entry& e = entries_[static_cast<std::size_t>(entry)];
    const Context c = context(e, evaluation);
    auto x = reading(e, evaluation, ports);
    if (variable == OutputVariableType::ConstraintEquation && e.algebraic > 0) {
      if (is_active(e.parameters)) K::template evaluate<double>(e.parameters, c, x);
      const auto& equations = is_active(e.parameters) ? equations_ : unknowns_;
      values.assign(equations.begin(), equations.begin() + e.algebraic);
      return true;
    }
    return K::output(e.parameters, c, x, variable, values);
  }

 private:
  struct Entry {
    Parameters parameters;
    std::vector<int> markers;  // always acting markers, then the alternatives
    std::vector<int> rows;  // rows of its equations in the system
    std::vector<int> first_order;  // positions of the first-order unknowns in the vector of ODE1 coordinates
    std::vector<int> first_slots;  // by alternative
    std::vector<int> coordinates;  // number of selected coordinates for each marker of its list
    int always = 0, algebraic = 0;
    bool is_full = true;           // forces change with the coordinates
    int item = -1, first_data = -1, data_count = 0, first_ae = -1;

    int cases() const { return std::max(1, static_cast<int>(markers.size()) - always); }
    // Calls f(marker) for those that act if `chosen` does.
    template <class F>
    void each_marker(int chosen, F&& f) const {
      for (int i = 0; i < always; ++i) f(markers[static_cast<std::size_t>(i)]);
      if (static_cast<int>(markers.size()) > always) f(markers[static_cast<std::size_t>(always + chosen)]);
    }
  };

  // Position of the entries of one alternative among its slots.
  struct Block {
    int coordinates, columns, left;  // left: the first column that rows of coordinates have
    Block(const Entry& e, int n)
        : coordinates(n), columns(n + static_cast<int>(e.rows.size())), left(e.is_full ? 0 : n) {}
    int size() const { return unknown(columns - coordinates, 0); }
    int coordinate(int row, int column) const { return row * (columns - left) + column - left; }
    int unknown(int row, int column) const { return coordinates * (columns - left) + row * columns + column; }
  };

  static Context context(const Entry& e, const Evaluation& evaluation) {
    return Context::of(evaluation, e.item, e.first_data, e.data_count);
  }

  auto with_history(const Evaluation& evaluation, const Ports& ports, const double* start, double* data,
                    double* lambda) const {
    return [=, this, &evaluation, &ports](const Entry& e, const auto& call) {
      take_unknowns(e, evaluation);
      const int first = std::max(e.first_data, 0);
      call(context(e, evaluation), exchange(e, evaluation, ports, nullptr),
           History{
               start + first, data + first, {lambda + std::max(e.first_ae, 0), static_cast<std::size_t>(e.algebraic)}});
    };
  }
  void take_unknowns(const Entry& e, const Evaluation& evaluation) const {
    unknowns_.clear();
    for (int k = 0; k < e.algebraic; ++k) unknowns_.push_back(evaluation.lambda[e.first_ae + k]);
    for (const int i : e.first_order) unknowns_.push_back(evaluation.y[i]);
    equations_.assign(e.rows.size(), 0.0);
  }
  // Frames are read in the ports themselves. The unknowns have been taken.
  Exchange<double> exchange(const Entry& e, const Evaluation& evaluation, const Ports& ports, double* forces) const {
    places_.clear();
    e.each_marker(K::alternative(e.parameters, context(e, evaluation)), [&](int marker) {
      const PortLayout& port = ports.ports[marker];
      places_.push_back({port.first_value, port.values, port.first_force, port.forces, port.n > 0});
    });
    Exchange<double> x(places_, ports.values.data(), forces);
    x.unknowns = unknowns_;
    x.equations = equations_;
    x.rate_level = evaluation.rate_level;
    return x;
  }
  // Forces that are made go nowhere.
  Exchange<double> reading(const Entry& e, const Evaluation& evaluation, const Ports& ports) const {
    take_unknowns(e, evaluation);
    forces_.assign(ports.forces.size(), 0.0);
    return exchange(e, evaluation, ports, forces_.data());
  }

  // Collects the differentiated numbers of the acting markers side by side. Returns the number of coordinates that
  // move them.
  int place_markers(const Entry& e, int chosen, const Ports& ports) const {
    acting_.clear();
    moving_places_.clear();
    typename Exchange<SweepDual>::Place next;
    int coordinates = 0;
    e.each_marker(chosen, [&](int marker) {
      const PortLayout& port = ports.ports[marker];
      next.values = port.values;
      next.forces = port.forces;
      next.moves = port.n > 0;
      moving_places_.push_back(next);
      acting_.push_back({marker, coordinates});
      next.value += port.values;
      next.force += port.forces;
      coordinates += port.n;
    });
    moving_values_.resize(static_cast<std::size_t>(next.value));
    moving_forces_.resize(static_cast<std::size_t>(next.force));
    return coordinates;
  }

  void sweep(const Entry& e, const Context& c, const Evaluation& evaluation, const Weights& weights, const Ports& ports,
             double* values) const {
    const int chosen = K::alternative(e.parameters, c);
    const Block block(e, place_markers(e, chosen, ports));
    const int* slot = slots.data() + e.first_slots[static_cast<std::size_t>(chosen)];
    take_unknowns(e, evaluation);
    for (int first = 0; first < block.columns; first += sweep_width) {
      move_frames(ports, first);
      move_unknowns(e, weights, block.coordinates, first);
      Exchange<SweepDual> x(moving_places_, moving_values_.data(), moving_forces_.data());
      x.unknowns = moving_unknowns_;
      x.equations = moving_equations_;
      x.rate_level = evaluation.rate_level;
      K::template evaluate<SweepDual>(e.parameters, c, x);
      for (std::size_t i = 0; i < acting_.size(); ++i) scatter(ports, i, block, first, slot, values);
      add_equations(e, weights, block, first, slot, values);
    }
  }

  // Seeds derivatives for the columns [first, first + sweep_width).
  void move_frames(const Ports& ports, int first) const {
    for (std::size_t i = 0; i < acting_.size(); ++i) {
      const auto [marker, offset] = acting_[i];
      const int n = ports.ports[marker].n;
      const int begin = std::max(0, first - offset), end = std::min(n, first - offset + sweep_width);
      const double *from = ports.frame(marker), *derivative = ports.derivative(marker);
      SweepDual* to = moving_values_.data() + moving_places_[i].value;
      for (int v = 0; v < moving_places_[i].values; ++v) {
        to[v] = SweepDual(from[v]);
        for (int k = begin; k < end; ++k) to[v].d[static_cast<std::size_t>(k + offset - first)] = derivative[v * n + k];
      }
    }
    std::ranges::fill(moving_forces_, SweepDual());
  }
  void move_unknowns(const Entry& e, const Weights& weights, int coordinates, int first) const {
    moving_unknowns_.assign(unknowns_.begin(), unknowns_.end());
    moving_equations_.assign(e.rows.size(), SweepDual());
    for (int k = 0; k < static_cast<int>(e.rows.size()); ++k)
      if (const int column = coordinates + k - first; column >= 0 && column < sweep_width)
        moving_unknowns_[static_cast<std::size_t>(k)].d[static_cast<std::size_t>(column)] =
            k < e.algebraic ? 1 : weights.y;
  }
  // values -= J^T force.d in the rows of one marker.
  void scatter(const Ports& ports, std::size_t i, const Block& block, int first, const int* slot,
               double* values) const {
    const auto [marker, offset] = acting_[i];
    const int begin = std::max(0, block.left - first), end = std::min(sweep_width, block.columns - first);
    if (begin >= end) return;
    const int n = ports.ports[marker].n, forces = moving_places_[i].forces;
    const double* jacobian = ports.jacobian(marker);
    const SweepDual* force = moving_forces_.data() + moving_places_[i].force;
    for (int row = 0; row < n; ++row) {
      std::array<double, sweep_width> sum{};
      for (int f = 0; f < forces; ++f)
        if (const double j = jacobian[f * n + row]; j != 0)
          for (int k = 0; k < sweep_width; ++k) sum[k] += j * force[f].d[k];
      for (int k = begin; k < end; ++k) values[slot[block.coordinate(offset + row, first + k)]] -= sum[k];
    }
  }
  // Rows of constraints are divided by the weight of the coordinates.
  void add_equations(const Entry& e, const Weights& weights, const Block& block, int first, const int* slot,
                     double* values) const {
    const double scale = 1 / (weights.q != 0 ? weights.q : weights.v);
    const int count = std::min(sweep_width, block.columns - first);
    for (int row = 0; row < static_cast<int>(e.rows.size()); ++row)
      for (int k = 0; k < count; ++k) {
        const double factor = row < e.algebraic && first + k < block.coordinates ? scale : 1;
        values[slot[block.unknown(row, first + k)]] +=
            factor * moving_equations_[static_cast<std::size_t>(row)].d[static_cast<std::size_t>(k)];
      }
  }

  struct Acting {
    int marker, offset;  // offset: position of its coordinates among all coordinates
  };

  std::vector<Entry> entries_;
  int next_slot_ = 0;
  // Work space: a batch is evaluated by one thread at a time.
  mutable std::vector<Exchange<double>::Place> places_;
  mutable std::vector<Exchange<SweepDual>::Place> moving_places_;
  mutable std::vector<Acting> acting_;
  mutable std::vector<double> unknowns_, equations_, forces_;
  mutable std::vector<SweepDual> moving_values_, moving_forces_, moving_unknowns_, moving_equations_;
};

template <class K, class Record>
struct ManyPortsPhysics final : ObjectPhysics {
  static_assert(ManyPortsKernel<K>, "see core/include/dalembert/contracts/many_ports.hpp");

  std::unique_ptr<Term> make_batch(std::span<const ItemType* const>) const override {
    return std::make_unique<ManyPortsBatch<K, Record>>();
  }
  int algebraic_equations(const void* record, std::span<const int> marker_coordinates) const override {
    return K::algebraic_equations(static_cast<const Record*>(record)->parameters, marker_coordinates);
  }
  void check(const void* record, const Placement& placement, const Ports& ports, const ItemLabel& item) const override {
    K::check(static_cast<const Record*>(record)->parameters, Connections(placement, ports, item));
  }
};

}  // namespace dalembert
