// ObjectBeamGeometricallyExact, specs/finite_elements/beam_geometrically_exact.toml
#pragma once

#include "dalembert/contracts/relative_frames.hpp"
#include "dalembert/finite_elements/beam_geometrically_exact_parameters.hpp"

namespace dalembert {

struct ObjectBeamGeometricallyExact : NoDoubt {
  using Parameters = ObjectBeamGeometricallyExactParameters;
  static constexpr int nodes = 2;

  static void check(const Parameters& p, const ItemLabel& item) { check_element_length(p.physicsLength, item); }

  struct Constants {
    double length = 1, node_mass = 0;
    Mat3<double> node_inertia;
    Mat<double, 6, 6> stiffness, damping;
    bool operator==(const Constants&) const = default;
  };
  static Constants constants(const Parameters& p) {
    const double half = 0.5 * p.physicsLength;
    const BeamSection& s = p.sectionData;
    return {p.physicsLength, half * s.massPerLength, half * s.inertia, s.stiffnessMatrix, s.dampingMatrix};
  }

  // One node relative to the other, d and phi, as a screw: the axis is a helix with constant strains.
  struct Screw {
    static constexpr int fields = 2, strains = 6, stresses = 6;
    using Shape = ShapeNumbers<2, 2>;
    static constexpr bool uses(int field, int vector) { return field == vector; }
    static constexpr Shape shape(double) { return {{{1, 0}, {0, 1}}}; }
    static const auto& points(const Constants&) {
      static constexpr StrainPoints<Shape> middle = tabulated<Shape>(gauss_1, &Screw::shape);
      return middle;
    }
    static const auto& stiffness(const Constants& k) { return k.stiffness; }
    static const auto& damping(const Constants& k) { return k.damping; }
    static Vec<double, 6> stress_free(const Parameters&, const Vec<double, 6>& of_reference) { return of_reference; }

    // Derivative of the axis in axes of the section, and curvature: both are constant along a screw.
    template <class S>
    static Vec<S, 6> strain(const Constants& k, const Vectors<S, 3, 2>& at) {
      return (1 / k.length) * joined(inverse_tangent_map(-at[1], at[0]), at[1]);
    }
    template <class S>
    static Vectors<S, 3, 2> pull_back(const Constants& k, const Vectors<S, 3, 2>& at, const Vec<S, 6>& stress) {
      const Vec3<S> n = (1 / k.length) * segment<3>(stress, 0), m = (1 / k.length) * segment<3>(stress, 3);
      return {inverse_tangent_map(at[1], n), m - inverse_tangent_gradient(-at[1], at[0], n)};
    }
  };

  // A point of a section, and the section's axes, seen from the first node; `s` from 0 to 1 along the screw.
  template <class S>
  static Pose<S> section(double s, const Vectors<S, 3, 2>& y, const Vec3<double>& local) {
    const Vec3<S> turn = s * y[1], slope = inverse_tangent_map(-y[1], y[0]);
    const Mat3<S> rotation = rotation_vector_rotation(turn);
    return {s * tangent_map(-turn, slope) + rotation * Vec3<double>{0, local[1], local[2]}, rotation};
  }
  static double place(double length, const Vec3<double>& local) { return 0.5 + local[0] / length; }

  template <class Node>
  struct On {
    using Parameters = ObjectBeamGeometricallyExactParameters;
    using Constants = ObjectBeamGeometricallyExact::Constants;
    using Map = RelativeFrames<Node, nodes>;
    using Families = std::tuple<Screw>;
    using CallingFamilies = Families;
    static constexpr int size = Map::size, node_size = Map::node_size;
    static constexpr bool constant_mass = Map::derives, constant_jacobian = false,
                          oriented = true;  // constant by spins

    static Constants constants(const Parameters& p) { return ObjectBeamGeometricallyExact::constants(p); }
    static bool calls(const Parameters&) { return false; }
    static bool damped(const Constants& k) { return k.damping != Mat<double, 6, 6>{}; }
    static double along(const Constants& k, const Vec3<double>& local) { return place(k.length, local); }

    // Half of the element turns with each node.
    template <class S>
    static Vec<S, size> inertia(const Constants& k, const Coordinates<S, size>& x) {
      typename Map::template Wrenches<S> w;
      for (int n = 0; n < nodes; ++n) {
        const SpinMotion<S> m = spin_motion<Node, S>(Map::of_node(x, n));
        w[n] = {k.node_mass * m.acceleration, k.node_inertia * m.spin_rate + cross(m.spin, k.node_inertia * m.spin)};
      }
      return Map::pull_back(x, w);
    }
    // Derivative on the group, where rates are spins.
    template <class T>
    static void add_inertia_tangent(const Constants& k, const Coordinates<T, size>& x, const Weights& w,
                                    Mat<T, size, size>& r) {
      for (int n = 0; n < nodes; ++n) {
        const Vec3<T> spin = segment<3>(x.v, n * node_size + 3);
        const Mat3<T> turn = w.a * k.node_inertia + w.v * (skew(spin) * k.node_inertia - skew(k.node_inertia * spin));
        for (int i = 0; i < 3; ++i) {
          r(n * node_size + i, n * node_size + i) += w.a * k.node_mass;
          for (int j = 0; j < 3; ++j) r(n * node_size + 3 + i, n * node_size + 3 + j) += turn(i, j);
        }
      }
    }
    template <class S>
    static Vec<S, size> mass_load(const Parameters& p, const Coordinates<S, size>& x, const Vec3<S>& g) {
      typename Map::template Wrenches<S> w{};
      for (auto& at_node : w) at_node.force = (0.5 * p.physicsLength * p.sectionData.massPerLength) * g;
      return Map::pull_back(x, w);
    }

    // Velocities are time derivatives with motion of both nodes; so are accelerations, which only outputs use.
    template <class S>
    static Motion<S> motion(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local) {
      constexpr bool twice = std::is_same_v<S, double>;
      using D = std::conditional_t<twice, Dual<1, Dual<1, S>>, Dual<1, S>>;
      const auto in_time = [](const S& value, const S& rate, const S& second) {
        D r;
        if constexpr (twice) {
          r.value.value = value;
          r.value.d[0] = r.d[0].value = rate;
          r.d[0].d[0] = second;
        } else {
          r.value = value;
          r.d[0] = rate;
        }
        return r;
      };
      std::array<Pose<D>, nodes> ends;
      for (int n = 0; n < nodes; ++n) {
        const SpinMotion<S> m = spin_motion<Node, S>(Map::of_node(x, n));
        const Mat3<S> spin = skew(m.spin), first = m.rotation * spin,
                      second = m.rotation * (spin * spin + skew(m.spin_rate));
        for (int i = 0; i < 3; ++i)
          ends[n].position[i] = in_time(x.q[n * node_size + i], x.v[n * node_size + i], x.a[n * node_size + i]);
        for (int i = 0; i < 9; ++i) ends[n].rotation.x[i] = in_time(m.rotation.x[i], first.x[i], second.x[i]);
      }
      const Pose<D> at = section(place(p.physicsLength, local), Map::seen_from_base(ends), local);
      const Vec3<D> point = ends[0].position + ends[0].rotation * at.position;
      const Mat3<D> axes = ends[0].rotation * at.rotation;
      const auto derivative = [](const D& a, int order) {
        if constexpr (twice)
          return order == 0 ? a.value.value : order == 1 ? a.value.d[0] : a.d[0].d[0];
        else
          return order == 0 ? a.value : order == 1 ? a.d[0] : S(0);
      };
      const auto of_point = [&](int order) { return vector_of<3>([&](int i) { return derivative(point[i], order); }); };
      const auto of_axes = [&](int order) {
        return matrix_of<3, 3>([&](int i, int j) { return derivative(axes(i, j), order); });
      };
      const Mat3<S> rotation = of_axes(0), back = transpose(rotation);
      return {.position = of_point(0),
              .velocity = of_point(1),
              .acceleration = of_point(2),
              .rotation = rotation,
              .angular_velocity = axis_of(of_axes(1) * back),
              .angular_acceleration = axis_of(of_axes(2) * back)};
    }
    // The wrench acts on the first node as on a rigid body, and on d and phi by their variations.
    template <class S>
    static Vec<S, size> pull_back(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local,
                                  const Vec3<S>& force, const Vec3<S>& moment) {
      using D = Dual<6, S>;
      const double s = place(p.physicsLength, local);
      const Mat3<S> rotation = Map::pose(x, 0).rotation;
      const Vec3<S> own_force = transposed_times(rotation, force), own_moment = transposed_times(rotation, moment);
      const Vectors<S, 3, 2> y = Map::local(constants(p), x);
      Vectors<D, 3, 2> moving;
      for (int i = 0; i < 6; ++i) moving[i / 3][i % 3] = D::seed(y[i / 3][i % 3], i);
      const Vec3<D> point = section(s, moving, local).position;
      const auto work = [&](int i) {
        return own_force[0] * point[0].d[i] + own_force[1] * point[1].d[i] + own_force[2] * point[2].d[i];
      };
      const Vectors<S, 3, 2> g{Vec3<S>{work(0), work(1), work(2)},
                               Vec3<S>{work(3), work(4), work(5)} + s * tangent_map(s * y[1], own_moment)};
      auto w = Map::wrenches(rotation, y, g);
      w[0].force += force;
      w[0].moment += own_moment + cross(section(s, y, local).position, own_force);
      return Map::pull_back(x, w);
    }

    template <class Section>
    static bool output(const Section& at, std::vector<double>& values) {
      const auto e = at.template elastic_strain<0>();
      switch (at.request.variable) {
        case OutputVariableType::StrainLocal: values = {e[0], 0, 0, 0, e[2], e[1]}; return true;
        case OutputVariableType::CurvatureLocal: values = {e[3], e[4], e[5]}; return true;
        case OutputVariableType::ForceLocal: {
          const auto stress = at.template stress<0>();
          values = {stress[0], stress[1], stress[2]};
          return true;
        }
        case OutputVariableType::TorqueLocal: {
          const auto stress = at.template stress<0>();
          values = {stress[3], stress[4], stress[5]};
          return true;
        }
        default: return false;
      }
    }

   private:
    // Axial vector of the skew-symmetric part.
    template <class S>
    static Vec3<S> axis_of(const Mat3<S>& m) {
      return {0.5 * (m(2, 1) - m(1, 2)), 0.5 * (m(0, 2) - m(2, 0)), 0.5 * (m(1, 0) - m(0, 1))};
    }
  };
};

}  // namespace dalembert
