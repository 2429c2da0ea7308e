// ObjectJointALEMoving2D, specs/joints/ale_moving_2d.toml
#pragma once

#include "dalembert/items/joints/along_cable.hpp"
#include "dalembert/joints/ale_moving_2d_parameters.hpp"

namespace dalembert {

struct ObjectJointALEMoving2D : AlongCable<ObjectJointALEMoving2DParameters> {
  using Parameters = ObjectJointALEMoving2DParameters;

  // ---- unknowns: two multipliers -------------------------------------------------------------------------------------------------
  static int algebraic_equations(const Parameters&, std::span<const int>) { return 2; }
  static bool is_multiplier(const Parameters&, int) { return true; }
  static bool forces_follow_motion(const Parameters&) { return true; }

  template <class S>
  static void evaluate(const Parameters& p, const Context& c, Exchange<S>& x) {
    const std::span<const S> q = x.values(cable);
    const PointFrame<S>& point = x.template frame<PointPort>(body);
    const CubicHermite<S> weights(q[way] + (p.slidingOffset - offset(p, c.data)), length(x));
    const Vec<S, 2> slope = curve<2>(weights.slope, q.data());
    if (x.rate_level && !p.usePenaltyFormulation) {
      const Vec<S, 2> rate = curve<2>(weights.value, q.data() + speeds) + q[speeds + way] * slope;
      for (int i = 0; i < 2; ++i) x.equations[i] = rate[i] - point.velocity[i];
    } else {
      const Vec<S, 2> position = curve<2>(weights.value, q.data());
      for (int i = 0; i < 2; ++i) {
        x.equations[i] = position[i] - point.position[i];
        if (p.usePenaltyFormulation) x.equations[i] -= (1 / p.penaltyStiffness) * x.unknowns[i];
      }
    }
    // force on the material of the cable; the body receives the opposite
    const Vec<S, 2> force{-x.unknowns[0], -x.unknowns[1]};
    const std::span<S> on_cable = x.forces(cable);
    for (int i = 0; i < 2; ++i) {
      x.forces(body)[i] -= force[i];
      for (int j = 0; j < 4; ++j) on_cable[2 * j + i] += weights.value[j] * force[i];
    }
    on_cable[way] += dot(force, slope);
  }

  static constexpr bool has_history = true;
  static PostNewton update(const Parameters& p, const Context&, const Exchange<double>& x, const History& h) {
    return go_on(p, x, place(p, x), h.data).verdict;
  }
  static PostNewton settle(const Parameters& p, const Context&, const Exchange<double>& x, const History& h) {
    return leave(p, x, place(p, x), h.data);
  }
  static void find_switches(const Parameters& p, const Context& c, const Exchange<double>& x, Switches& switches) {
    find_switch(p, x, place(p, x), c.data, switches);
  }

  static bool output(const Parameters& p, const Context& c, const Exchange<double>& x, OutputVariableType variable,
                     std::vector<double>& values) {
    const PointFrame<double>& frame = x.frame<PointPort>(body);
    const std::span<const double> q = x.values(cable);
    switch (variable) {
      case OutputVariableType::Position: values.assign(frame.position.x.begin(), frame.position.x.end()); return true;
      case OutputVariableType::Velocity: values.assign(frame.velocity.x.begin(), frame.velocity.x.end()); return true;
      case OutputVariableType::SlidingCoordinate: values = {q[way] + p.slidingOffset}; return true;
      case OutputVariableType::Coordinates: values = {c.data[current_element], q[way]}; return true;
      case OutputVariableType::Coordinates_t: values = {q[speeds + way]}; return true;
      case OutputVariableType::Force: values = {x.unknowns[0], x.unknowns[1], 0}; return true;
      default: return false;
    }
  }

  static void check(const Parameters& p, const Connections& on) {
    on.require(on.gives<PointPort>(0), 0, "markerNumbers", "a marker with a position for the body");
    check_cables(p, on, "MarkerBodyCable2DCoordinates");
    on.require_data(1, "nodeNumbers");
    for (int i = 1; i < on.markers(); ++i) {
      const char* list = i == 1 ? "markerNumbers" : "slidingMarkerNumbers";
      on.require(on.coordinates(i) == way + 1, i, list,
                 "markers on cables whose material moves along, ObjectALEANCFCable2D");
      on.require(on.placement().dofs.size() == 1 && on.last_coordinate(i) == on.placement().dofs[0], i, list,
                 "markers on cables whose third node is the second one of nodeNumbers");
    }
    if (p.usePenaltyFormulation && !(p.penaltyStiffness > 0))
      on.refuse("penaltyStiffness", std::to_string(p.penaltyStiffness),
                "a positive stiffness, as usePenaltyFormulation asks for it");
  }

 private:
  static constexpr int way = 8, speeds = 9;  // among the numbers of a cable
  static double place(const Parameters& p, const Exchange<double>& x) { return x.values(cable)[way] + p.slidingOffset; }
};

}  // namespace dalembert
