// ObjectANCFCable2D, specs/finite_elements/ancf_cable_2d.toml
#pragma once

#include "dalembert/contracts/user_function.hpp"
#include "dalembert/finite_elements/ancf_cable_2d_parameters.hpp"
#include "dalembert/items/finite_elements/ancf_cable_axis.hpp"

namespace dalembert {

struct ObjectANCFCable2D : AncfCableAxis<2> {
  using Parameters = ObjectANCFCable2DParameters;
  static constexpr bool constant_jacobian = false, oriented = true;

  // Arguments of both user functions: data of the respective strain, then the other strain.
  template <class S>
  static Vec<S, 1> called(const UserFunction& f, const Context& c, double position, const Vec<S, 1>& e,
                          const Vec<S, 1>& e_t, const Vec<double, 1>& e_0, double stiffness, double damping,
                          const Vec<S, 1>& other, const Vec<S, 1>& other_t, const Vec<double, 1>& other_0) {
    if (!f) return {stiffness * (e[0] - e_0[0]) + damping * e_t[0]};
    return {call_scalar(f, c, S(position), e[0], e_t[0], e_0[0], stiffness, damping, other[0], other_t[0], other_0[0])};
  }
  struct AxialForce : Stretching {
    template <class... Strains>
    static auto read_stress(const Parameters& p, const Constants& k, const Context& c, double position, const auto& e,
                            const auto& e_t, const auto& e_0, const Strains&... other) {
      return called(p.axialForceUserFunction, c, position, e, e_t, e_0, k.axial_stiffness, k.axial_damping, other...);
    }
  };
  // (r'_x r''_y - r'_y r''_x) / r'^2
  struct Bending : Points {
    static constexpr int fields = 2, strains = 1, stresses = 1;
    static const auto& points(const Constants& k) { return k.rule->bending; }
    static double stiffness(const Constants& k) { return k.bending_stiffness; }
    static double damping(const Constants& k) { return k.bending_damping; }
    template <class P>
    static Vec<double, 1> stress_free(const P& p, const Vec<double, 1>& of_reference) {
      return {p.physicsReferenceCurvature + p.strainIsRelativeToReference * of_reference[0]};
    }
    template <class S>
    static Vec<S, 1> strain(const Constants& k, const Vectors<S, 2, 2>& r) {
      return {(1 / k.length) * ((1.0 / dot(r[0], r[0])) * planar_cross(r[0], r[1]))};
    }
    template <class S>
    static Vectors<S, 2, 2> pull_back(const Constants& k, const Vectors<S, 2, 2>& r, const Vec<S, 1>& moment) {
      const S scale = 1.0 / dot(r[0], r[0]), twice = 2.0 * (scale * planar_cross(r[0], r[1]));
      const S m = (1 / k.length) * (moment[0] * scale), minus = -m;
      return {Vec<S, 2>{m * (r[1][1] - twice * r[0][0]), minus * (r[1][0] + twice * r[0][1])},
              Vec<S, 2>{minus * r[0][1], m * r[0][0]}};
    }
  };
  struct BendingMoment : Bending {
    template <class... Strains>
    static auto read_stress(const Parameters& p, const Constants& k, const Context& c, double position, const auto& e,
                            const auto& e_t, const auto& e_0, const Strains&... other) {
      return called(p.bendingMomentUserFunction, c, position, e, e_t, e_0, k.bending_stiffness, k.bending_damping,
                    other...);
    }
  };
  using Families = std::tuple<Stretching, Bending>;
  using CallingFamilies = std::tuple<Reading<AxialForce, Bending>, Reading<BendingMoment, Stretching>>;
  static bool calls(const Parameters& p) { return p.axialForceUserFunction || p.bendingMomentUserFunction; }

  // The cross section at local[0], about the point local[1] away from the axis.
  template <class S>
  static Motion<S> motion(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local) {
    return section(p.physicsLength, x, local);
  }
  template <class S>
  static Vec<S, size> pull_back(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local,
                                const Vec3<S>& force, const Vec3<S>& moment) {
    return on_section(p.physicsLength, x, local, force, moment);
  }
  template <class S>
  static Motion<S> section(double length, const Coordinates<S, size>& x, const Vec3<double>& local) {
    const double xi = local[0] / length;
    const auto shape = hermite::values(xi, length), slope = hermite::slopes(xi, length);
    const Vec<S, 2> r = combined(shape, x.q), v = combined(shape, x.v), a = combined(shape, x.a);
    const Vec<S, 2> t = combined(slope, x.q), t_rate = combined(slope, x.v), t_rate2 = combined(slope, x.a);
    const S square = dot(t, t), scale = 1.0 / norm(t), cosine = scale * t[0], sine = scale * t[1], o(0);
    const S turn = planar_cross(t, t_rate) / square;
    const S turn_rate = planar_cross(t, t_rate2) / square - 2.0 * (dot(t, t_rate) / square) * turn;
    const Motion<S> axis{.position = {r[0], r[1], o},
                         .velocity = {v[0], v[1], o},
                         .acceleration = {a[0], a[1], o},
                         .rotation = {cosine, -sine, o, sine, cosine, o, o, o, S(1)},
                         .angular_velocity = {o, o, turn},
                         .angular_acceleration = {o, o, turn_rate}};
    if (local[1] == 0) return axis;
    return moved(axis, Vec3<S>{-local[1] * sine, local[1] * cosine, o});
  }
  template <class S>
  static Vec<S, size> on_section(double length, const Coordinates<S, size>& x, const Vec3<double>& local,
                                 const Vec3<S>& force, const Vec3<S>& moment) {
    const double xi = local[0] / length;
    const auto shape = hermite::values(xi, length), slope = hermite::slopes(xi, length);
    const Vec<S, 2> t = combined(slope, x.q);
    S m = moment[2];
    if (local[1] != 0) m -= (local[1] / norm(t)) * (t[1] * force[1] + t[0] * force[0]);
    m = m / dot(t, t);
    return vector_of<size>(
        [&](int i) { return shape[i / 2] * force[i % 2] + slope[i / 2] * (i % 2 ? m * t[0] : -(m * t[1])); });
  }

  template <class Section>
  static bool output(const Section& at, std::vector<double>& values) {
    const auto slope = at.template fields<0>()[0];
    switch (at.request.variable) {
      case OutputVariableType::Rotation: values = {std::atan2(slope[1], slope[0])}; return true;
      case OutputVariableType::Director1: values = {slope[0], slope[1], 0}; return true;
      case OutputVariableType::StrainLocal:
        values = {at.template strain<0>()[0] - at.request.local[1] * at.template strain<1>()[0]};
        return true;
      case OutputVariableType::CurvatureLocal: values = {at.template strain<1>()[0]}; return true;
      case OutputVariableType::ForceLocal: values = {at.template stress<0>()[0]}; return true;
      case OutputVariableType::TorqueLocal: values = {at.template stress<1>()[0]}; return true;
      default: return false;
    }
  }

 private:
  template <class S>
  static S planar_cross(const Vec<S, 2>& a, const Vec<S, 2>& b) {
    return a[0] * b[1] - a[1] * b[0];
  }
};

}  // namespace dalembert
