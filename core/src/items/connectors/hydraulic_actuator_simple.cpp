// ObjectConnectorHydraulicActuatorSimple, specs/connectors/hydraulic_actuator_simple.toml: forces on two points, and the
// pressures in its chambers as first order coordinates.
#include <array>
#include <utility>

#include "dalembert/batches/port_sweep.hpp"
#include "dalembert/connectors/hydraulic_actuator_simple_parameters.hpp"
#include "dalembert/contracts/line_of_action.hpp"
#include "dalembert/nodes/generic_ode1_parameters.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {
namespace {

using Parameters = ObjectConnectorHydraulicActuatorSimpleParameters;

const Parameters& parameters(const void* record) {
  return static_cast<const ObjectConnectorHydraulicActuatorSimpleRecord*>(record)->parameters;
}

template <class S>
LineOfAction<S> line_of(const Context& c, const std::array<PointFrame<S>, 2>& m) {
  if (coincide(m[0], m[1]))
    refuse_coinciding(c, "ObjectConnectorHydraulicActuatorSimple", "Keep the length of the actuator above zero");
  return {m[0], m[1]};
}

// Tension along the line between the points.
template <class S>
S tension(const Parameters& p, const LineOfAction<S>& line, const Vec<S, 2>& pressure) {
  return p.chamberCrossSection1 * pressure[1] - p.chamberCrossSection0 * pressure[0] + p.actuatorDamping * line.rate;
}

template <class S>
S signed_root(const S& x) {
  using std::sqrt;
  if (value_of(x) == 0) return S(0);
  return x < 0.0 ? -sqrt(-x) : sqrt(x);
}

struct Chamber {
  double area, sign, hose_volume, valve;  // sign: of its volume against the stroke

  Chamber(const Parameters& p, int k)
      : area(k == 0 ? p.chamberCrossSection0 : p.chamberCrossSection1),
        sign(k == 0 ? 1 : -1),
        hose_volume(k == 0 ? p.hoseVolume0 : p.hoseVolume1),
        valve(k == 0 ? p.valveOpening0 : p.valveOpening1) {}
};

// Rate of the pressure in one chamber, from the motion of the piston and the flow through its valve.
template <class S>
S pressure_rate(const Parameters& p, const Context& c, const Chamber& chamber, const LineOfAction<S>& line, const S& pressure) {
  S volume(chamber.hose_volume), compliance(1 / p.oilBulkModulus);
  if (p.useChamberVolumeChange) {
    const S stroke = line.length - p.offsetLength;
    const S swept = chamber.area * (chamber.sign > 0 ? stroke : p.strokeLength - stroke);
    volume += swept;
    if (value_of(volume) == 0)
      refuse(ErrorKind::value, {"object " + std::to_string(c.item) + " (ObjectConnectorHydraulicActuatorSimple)", "hoseVolume0",
                                "the volume of a chamber vanishes at time " + std::to_string(c.time), "", "",
                                "Increase hoseVolume0 and hoseVolume1, or keep the stroke within its limits"});
    if (p.cylinderBulkModulus != 0) compliance += swept / (volume * p.cylinderBulkModulus);
    if (p.hoseBulkModulus != 0) compliance += chamber.hose_volume / (volume * p.hoseBulkModulus);
  }
  const S drop = chamber.valve >= 0 ? p.systemPressure - pressure : pressure - p.tankPressure;
  const S flow = chamber.valve * p.nominalFlow * signed_root(drop);
  return (flow - chamber.sign * chamber.area * line.rate) / (compliance * volume);
}

class HydraulicActuatorBatch final : public Term {
 public:
  void add(const void* record, const Placement& placement, const Ports&) override {
    Entry e{parameters(record), {placement.markers[0], placement.markers[1]}, {}, {}, placement.item};
    for (int k = 0; k < 2; ++k) {
      e.places[k] = placement.ode1[k];
      e.rows[k] = placement.ode1_offset + placement.ode1[k];
    }
    entries_.push_back(std::move(e));
  }
  void refresh(int entry, const void* record) override { entries_[entry].parameters = parameters(record); }
  // One block: coordinates of the markers, then the pressures.
  void visit(BlockVisitor& visitor, const Ports& ports) const override {
    for (const Entry& e : entries_) {
      auto all = all_dofs<2>(ports, e.markers);
      all.insert(all.end(), e.rows.begin(), e.rows.end());
      visitor.block(all, all);
    }
  }

  void residual(const Evaluation& evaluation, Ports& ports, double* r) const override {
    for (const Entry& e : entries_) {
      if (!e.parameters.activeConnector) continue;
      const Law<double> law(e, evaluation, e.frames(ports), e.pressures(evaluation));
      add_forces<PointPort, 2>(ports, e.markers, 1.0, law.forces);
      for (int k = 0; k < 2; ++k) r[e.rows[k]] += law.rates[k];
    }
  }
  void tangent(const Evaluation& evaluation, const Weights& w, Ports& ports, double* values) const override {
    const int* slot = slots.data();
    for (const Entry& e : entries_) {
      Columns<2> columns(ports, e.markers);
      const int n = columns.total;
      columns.total += 2;
      if (e.parameters.activeConnector)
        for (int first = 0; first < columns.total; first += sweep_width) {
          std::array<PointFrame<SweepDual>, 2> frames;
          for (int m = 0; m < 2; ++m) frames[m] = read_moving_frame<PointPort>(ports, e.markers[m], columns.offset[m], first);
          const Vec<double, 2> at = e.pressures(evaluation);
          Vec<SweepDual, 2> pressure{SweepDual(at[0]), SweepDual(at[1])};
          for (int k = 0; k < 2; ++k)
            if (n + k >= first && n + k < first + sweep_width) pressure[k].d[n + k - first] = w.y;
          const Law<SweepDual> law(e, evaluation, frames, pressure);
          scatter_forces<PointPort, 2>(ports, e.markers, columns, first, -1.0, law.forces, slot, values);
          for (int k = 0; k < 2; ++k)
            for (int j = first; j < std::min(columns.total, first + sweep_width); ++j)
              values[slot[(n + k) * columns.total + j]] += law.rates[k].d[j - first];
        }
      slot += columns.total * columns.total;
    }
  }

  bool output(int entry, OutputVariableType variable, const Vec3<double>&, const Evaluation& evaluation, const Ports& ports,
              std::vector<double>& values) const override {
    const Entry& e = entries_[entry];
    const auto m = e.frames(ports);
    const LineOfAction<double> line = line_of(Context::of(evaluation, e.item), m);
    const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
    switch (variable) {
      case OutputVariableType::Distance: values = {line.length}; return true;
      case OutputVariableType::Displacement: vector(line.span); return true;
      case OutputVariableType::Velocity: vector(m[1].velocity - m[0].velocity); return true;
      case OutputVariableType::VelocityLocal: values = {line.rate}; return true;
      case OutputVariableType::Force:
        vector((e.parameters.activeConnector ? tension(e.parameters, line, e.pressures(evaluation)) : 0.0) * line.axis);
        return true;
      default: return false;
    }
  }

 private:
  struct Entry {
    Parameters parameters;
    std::array<int, 2> markers{};
    std::array<int, 2> places{}, rows{};  // of the pressures: in the vector of ODE1 coordinates, in the system vector
    int item = -1;

    std::array<PointFrame<double>, 2> frames(const Ports& ports) const {
      return {read_frame<PointPort>(ports, markers[0]), read_frame<PointPort>(ports, markers[1])};
    }
    Vec<double, 2> pressures(const Evaluation& evaluation) const { return {evaluation.y[places[0]], evaluation.y[places[1]]}; }
  };

  template <class S>
  struct Law {
    std::array<Force<S>, 2> forces;
    std::array<S, 2> rates;

    Law(const Entry& e, const Evaluation& evaluation, const std::array<PointFrame<S>, 2>& m, const Vec<S, 2>& pressure) {
      const Context c = Context::of(evaluation, e.item);
      const LineOfAction<S> line = line_of(c, m);
      const Vec3<S> f = tension(e.parameters, line, pressure) * line.axis;
      forces = {Force<S>{f}, Force<S>{-f}};
      for (int k = 0; k < 2; ++k) rates[k] = pressure_rate(e.parameters, c, Chamber(e.parameters, k), line, pressure[k]);
    }
  };

  std::vector<Entry> entries_;
};

struct HydraulicActuatorPhysics final : ObjectPhysics {
  std::unique_ptr<Term> make_batch(std::span<const ItemType* const>) const override { return std::make_unique<HydraulicActuatorBatch>(); }
  void check(const void*, const Placement& on, const Ports&, const ItemLabel& item) const override {
    const std::string expected = "a list with one NodeGenericODE1 of two coordinates, the pressures";
    if (on.nodes.size() != 1)
      refuse(ErrorKind::value, {item, "nodeNumbers", "", std::to_string(on.nodes.size()) + " nodes", expected, ""});
    if (on.ode1.size() != 2)
      refuse(ErrorKind::value, {item, "nodeNumbers", "", "a node with " + std::to_string(on.ode1.size()) + " ODE1 coordinates", expected, ""});
    for (const double x : static_cast<const NodeGenericODE1Record*>(on.node_records[0])->parameters.referenceCoordinates)
      if (x != 0)
        refuse(ErrorKind::value, {item, "nodeNumbers", "a reference coordinate of the node is " + std::to_string(x), "",
                                  "reference coordinates that are zero", "State the pressures at the start as initialCoordinates"});
  }
};

}  // namespace

const Physics& object_connector_hydraulic_actuator_simple_physics() {
  static const HydraulicActuatorPhysics physics;
  return physics;
}

}  // namespace dalembert
