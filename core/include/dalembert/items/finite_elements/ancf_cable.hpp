// ObjectANCFCable, specs/finite_elements/ancf_cable.toml
#pragma once

#include "dalembert/finite_elements/ancf_cable_parameters.hpp"
#include "dalembert/items/finite_elements/ancf_cable_axis.hpp"

namespace dalembert {

struct ObjectANCFCable : AncfCableAxis<3> {
  using Parameters = ObjectANCFCableParameters;
  static constexpr bool constant_jacobian = true, oriented = false;

  // r' x r'' / r'^2
  struct Bending : Points {
    static constexpr int fields = 2, strains = 3, stresses = 3;
    static const auto& points(const Constants& k) { return k.rule->bending; }
    static double stiffness(const Constants& k) { return k.bending_stiffness; }
    static double damping(const Constants& k) { return k.bending_damping; }
    static Vec3<double> stress_free(const Parameters& p, const Vec3<double>& of_reference) {
      return p.strainIsRelativeToReference * of_reference;
    }
    template <class S>
    static Vec3<S> strain(const Constants& k, const Vectors<S, 3, 2>& r) {
      return ((1 / k.length) * (1.0 / dot(r[0], r[0]))) * cross(r[0], r[1]);
    }
    template <class S>
    static Vectors<S, 3, 2> pull_back(const Constants& k, const Vectors<S, 3, 2>& r, const Vec3<S>& moment) {
      const S scale = 1.0 / dot(r[0], r[0]);
      const Vec3<S> m = ((1 / k.length) * scale) * moment;
      const S swelling = 2.0 * scale * dot(m, cross(r[0], r[1]));
      return {cross(r[1], m) - swelling * r[0], cross(m, r[0])};
    }
  };
  using Families = std::tuple<Stretching, Bending>;
  using CallingFamilies = Families;
  static bool calls(const Parameters&) { return false; }

  // Motion of the axis at local[0]: there is no orientation, and points away from the axis have no position.
  template <class S>
  static Motion<S> motion(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local) {
    const auto shape = hermite::values(local[0] / p.physicsLength, p.physicsLength);
    return {.position = combined(shape, x.q), .velocity = combined(shape, x.v), .acceleration = combined(shape, x.a)};
  }
  template <class S>
  static Vec<S, size> pull_back(const Parameters& p, const Coordinates<S, size>&, const Vec3<double>& local,
                                const Vec3<S>& force, const Vec3<S>&) {
    const auto shape = hermite::values(local[0] / p.physicsLength, p.physicsLength);
    return vector_of<size>([&](int i) { return shape[i / 3] * force[i % 3]; });
  }

  template <class Section>
  static bool output(const Section& at, std::vector<double>& values) {
    const auto vector = [&values](const Vec3<double>& v) {
      values.assign(v.x.begin(), v.x.end());
      return true;
    };
    switch (at.request.variable) {
      case OutputVariableType::Director1: return vector(at.template fields<0>()[0]);
      case OutputVariableType::StrainLocal: values = {at.template strain<0>()[0]}; return true;
      case OutputVariableType::CurvatureLocal: return vector(at.template strain<1>());
      case OutputVariableType::ForceLocal: values = {at.template stress<0>()[0]}; return true;
      case OutputVariableType::TorqueLocal: return vector(at.template stress<1>());
      default: return false;
    }
  }
};

}  // namespace dalembert
