// ObjectConnectorLaw, specs/connectors/law.toml: user functions of the relative motion of two markers and of states.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "dalembert/batches/user_vector.hpp"
#include "dalembert/connectors/law_parameters.hpp"
#include "dalembert/contracts/joint_frames.hpp"
#include "dalembert/contracts/many_ports.hpp"

namespace dalembert {

struct ObjectConnectorLaw : AllMarkersAct, NoAlgebraicEquations, NoSwitches {
  using Parameters = ObjectConnectorLawParameters;
  static constexpr bool has_history = true;

  template <class S>
  static void evaluate(const Parameters& p, const Context& c, Exchange<S>& x) {
    const Motion<S> motion(p, x);
    const std::vector<S> states = states_of(x, c.data, c);
    if (p.forceUserFunction) motion.apply(x, motion.call(p.forceUserFunction, c, states, motion.n));
    if (p.stateRateUserFunction && !x.unknowns.empty())
      std::ranges::copy(motion.call(p.stateRateUserFunction, c, states, x.unknowns.size()), x.equations.begin());
  }

  // The history at the end of the step follows from that at its start.
  static PostNewton update(const Parameters& p, const Context& c, const Exchange<double>& x, const History& history) {
    if (!p.historyUserFunction || c.data_count == 0) return {};
    const auto found = Motion<double>(p, x).call(p.historyUserFunction, c, states_of(x, history.start, c),
                                                 static_cast<std::size_t>(c.data_count));
    std::ranges::copy(found, history.data);
    return {};
  }

  static bool output(const Parameters& p, const Context& c, const Exchange<double>& x, OutputVariableType variable,
                     std::vector<double>& values) {
    const Motion<double> motion(p, x);
    switch (variable) {
      case OutputVariableType::Displacement: values.assign(motion.u.begin(), motion.u.begin() + motion.n); return true;
      case OutputVariableType::Velocity: values.assign(motion.v.begin(), motion.v.begin() + motion.n); return true;
      case OutputVariableType::Force:
        values.assign(motion.n, 0.0);
        if (p.activeConnector && p.forceUserFunction)
          values = motion.call(p.forceUserFunction, c, states_of(x, c.data, c), motion.n);
        return true;
      default: return false;
    }
  }

  static void check(const Parameters& p, const Connections& on) {
    const int n = p.numberOfCoordinates;
    if (n != coordinate && n != point && n != frame)
      on.refuse("numberOfCoordinates", std::to_string(n), "1 (coordinates), 3 (points) or 6 (frames)");
    for (int i = 0; i < 2; ++i)
      on.require(n == coordinate ? on.gives<ScalarPort>(i)
                 : n == point    ? on.gives<PointPort>(i)
                                 : on.gives<RigidPort>(i),
                 i, "markerNumbers",
                 n == coordinate ? "a marker of a single coordinate"
                 : n == point    ? "a marker of a point"
                                 : "a marker of a rigid frame");
    const Placement& at = on.placement();
    const int states = static_cast<int>(at.ode1.size()), expected = (states > 0 ? 1 : 0) + (at.data_count > 0 ? 1 : 0);
    if (at.nodes.empty() || static_cast<int>(at.nodes.size()) != expected || !at.dofs.empty())
      on.refuse("nodeNumbers", std::to_string(at.nodes.size()) + " nodes",
                "a NodeGenericODE1 (states), a NodeGenericData (history), or one of both");
    if (p.stateRateUserFunction && at.ode1.empty())
      on.refuse("nodeNumbers", "no NodeGenericODE1", "one for the states of stateRateUserFunction");
    if (p.historyUserFunction && at.data_count == 0)
      on.refuse("nodeNumbers", "no NodeGenericData", "one for historyUserFunction");
  }

 private:
  static constexpr int coordinate = 1, point = 3, frame = 6;

  // Position and velocity of the second marker relative to the first one, in global axes or in those of the joint frame.
  template <class S>
  struct Motion {
    std::size_t n;
    std::array<S, frame> u{}, v{};
    Mat3<S> A_0i;

    Motion(const Parameters& p, const Exchange<S>& x) : n(static_cast<std::size_t>(p.numberOfCoordinates)) {
      if (n == coordinate) {
        const ScalarFrame<S>&m0 = x.template frame<ScalarPort>(0), &m1 = x.template frame<ScalarPort>(1);
        u[0] = m1.value - m0.value, v[0] = m1.rate - m0.rate;
      } else if (n == point) {
        const PointFrame<S>&m0 = x.template frame<PointPort>(0), &m1 = x.template frame<PointPort>(1);
        set(0, m1.position - m0.position, m1.velocity - m0.velocity);
      } else {
        const RigidFrame<S>&m0 = x.template frame<RigidPort>(0), &m1 = x.template frame<RigidPort>(1);
        const JointAxes<S> axes(p, m0, m1);
        A_0i = axes.A_0i;
        set(0, transposed_times(A_0i, m1.position - m0.position), transposed_times(A_0i, m1.velocity - m0.velocity));
        set(3, tait_bryan_angles(transpose(A_0i) * axes.A_0j),
            transposed_times(A_0i, m1.angular_velocity - m0.angular_velocity));
      }
    }
    std::vector<S> call(const UserFunction& f, const Context& c, const std::vector<S>& states,
                        std::size_t results) const {
      return call_with_vectors<S>(f, c, {std::span(u).first(n), std::span(v).first(n), states}, results);
    }
    void apply(Exchange<S>& x, const std::vector<S>& f) const {
      const auto three = [&](std::size_t first) { return Vec3<S>{f[first], f[first + 1], f[first + 2]}; };
      if (n == coordinate) {
        x.apply(0, ScalarForce<S>{f[0]});
        x.apply(1, ScalarForce<S>{-f[0]});
      } else if (n == point) {
        x.apply(0, Force<S>{three(0)});
        x.apply(1, Force<S>{-three(0)});
      } else {
        const Vec3<S> force = A_0i * three(0), moment = A_0i * three(3);
        x.apply(0, Wrench<S>{force, moment});
        x.apply(1, Wrench<S>{-force, -moment});
      }
    }

   private:
    void set(int first, const Vec3<S>& position, const Vec3<S>& velocity) {
      for (int i = 0; i < 3; ++i) u[first + i] = position[i], v[first + i] = velocity[i];
    }
  };

  // The coordinates of the first-order node, followed by the data coordinates.
  template <class S>
  static std::vector<S> states_of(const Exchange<S>& x, const double* data, const Context& c) {
    std::vector<S> states(x.unknowns.begin(), x.unknowns.end());
    for (int i = 0; i < c.data_count; ++i) states.push_back(S(data[i]));
    return states;
  }
};

}  // namespace dalembert
