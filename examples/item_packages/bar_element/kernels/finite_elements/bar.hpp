// ObjectBar, specs/finite_elements/bar.toml
#pragma once

#include "dalembert/contracts/strain_points.hpp"
#include "dalembert/finite_elements/bar_parameters.hpp"

namespace dalembert {

struct ObjectBar : NoDoubt {
  using Parameters = ObjectBarParameters;
  static constexpr int size = 6, node_size = 3;  // coordinates, and those of a node
  // Of the mass matrix, of the motion of points; without orientation, markers on it have a position only.
  static constexpr bool constant_mass = true, constant_jacobian = true, oriented = false;

  // What is found once, of the parameters.
  struct Constants {
    double length = 1, axial_stiffness = 0, mass = 0;
    bool operator==(const Constants&) const = default;
  };
  static Constants constants(const Parameters& p) {
    return {p.physicsLength, p.physicsAxialStiffness, p.physicsMassPerLength * p.physicsLength};
  }
  static void check(const Parameters& p, const ItemLabel& item) { check_element_length(p.physicsLength, item); }
  static double along(const Constants& k, const Vec3<double>& local) { return local[0] / k.length; }
  static bool damped(const Constants&) { return false; }
  static bool calls(const Parameters&) { return false; }  // functions of the user

  // Coordinates to the vectors that are interpolated, and back: here the chord (r1 - r0) / L alone.
  struct Map : NoLieRotations {
    static constexpr int dimension = 3, vectors = 1, size = 6;
    static constexpr bool linear = true, derives = true;

    template <class S>
    static Vectors<S, 3, 1> local(const Constants& k, const Coordinates<S, size>& x) {
      return {(1 / k.length) * (segment<3>(x.q, 3) - segment<3>(x.q, 0))};
    }
    template <class S>
    static Vectors<S, 3, 1> local_rate(const Constants& k, const Coordinates<S, size>& x) {
      return {(1 / k.length) * (segment<3>(x.v, 3) - segment<3>(x.v, 0))};
    }
    template <class S>
    static Vec<S, size> pull_back(const Constants& k, const Coordinates<S, size>&, const Vectors<S, 3, 1>& g) {
      return vector_of<size>([&](int i) { return share(i, k) * g[0][i % 3]; });
    }
    template <class T>
    static Mat<T, size, size> tangent(const Constants& k, const Coordinates<T, size>&, const Vectors<T, 3, 1>&,
                                      const Mat<T, 3, 3>& m, const Mat<T, 3, 3>&, const Weights&) {
      return matrix_of<size, size>([&](int i, int j) { return (share(i, k) * share(j, k)) * m(i % 3, j % 3); });
    }

   private:
    static double share(int i, const Constants& k) { return (i < 3 ? -1 : 1) / k.length; }
  };

  // A family of points with the same strains: |r'| - 1.
  struct Stretching {
    static constexpr int fields = 1, strains = 1, stresses = 1;
    static constexpr bool uses(int, int) { return true; }
    static constexpr ShapeNumbers<1, 1> shape(double) {  // r' is the chord, everywhere
      ShapeNumbers<1, 1> share{};
      share[0][0] = 1;
      return share;
    }
    static const auto& points(const Constants&) {
      static constexpr auto all = tabulated(gauss_1, shape);
      return all;
    }
    static double stiffness(const Constants& k) { return k.axial_stiffness; }
    static double damping(const Constants&) { return 0; }
    static Vec<double, 1> stress_free(const Parameters&, const Vec<double, 1>&) { return {0}; }
    template <class S>
    static Vec<S, 1> strain(const Constants&, const Vectors<S, 3, 1>& r) {
      return {norm(r[0]) - 1.0};
    }
    template <class S, class N>
    static Vectors<S, 3, 1> pull_back(const Constants&, const Vectors<S, 3, 1>& r, const Vec<N, 1>& force) {
      return {(force[0] * (1.0 / norm(r[0]))) * r[0]};
    }
  };
  using Families = std::tuple<Stretching>;
  using CallingFamilies = Families;

  // The mass of linear shape functions.
  template <class S>
  static Vec<S, size> inertia(const Constants& k, const Coordinates<S, size>& x) {
    return vector_of<size>([&](int i) { return (k.mass / 6) * (2.0 * x.a[i] + x.a[(i + 3) % 6]); });
  }
  template <class T>
  static void add_inertia_tangent(const Constants& k, const Coordinates<T, size>&, const Weights& w,
                                  Mat<T, size, size>& m) {
    for (int i = 0; i < size; ++i) {
      m(i, i) += w.a * k.mass / 3;
      m(i, (i + 3) % 6) += w.a * k.mass / 6;
    }
  }
  template <class S>
  static Vec<S, size> mass_load(const Parameters& p, const Coordinates<S, size>&, const Vec3<S>& g) {
    return vector_of<size>([&](int i) { return (0.5 * p.physicsMassPerLength * p.physicsLength) * g[i % 3]; });
  }

  // The axis at local[0].
  template <class S>
  static Motion<S> motion(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local) {
    const double end = local[0] / p.physicsLength;
    const auto between = [end](const Vec<S, size>& q) { return (1 - end) * segment<3>(q, 0) + end * segment<3>(q, 3); };
    return {.position = between(x.q), .velocity = between(x.v), .acceleration = between(x.a)};
  }
  template <class S>
  static Vec<S, size> pull_back(const Parameters& p, const Coordinates<S, size>&, const Vec3<double>& local,
                                const Vec3<S>& force, const Vec3<S>&) {
    const double end = local[0] / p.physicsLength;
    return joined((1 - end) * force, end * force);
  }

  template <class Section>
  static bool output(const Section& at, std::vector<double>& values) {
    switch (at.request.variable) {
      case OutputVariableType::StrainLocal: values = {at.template strain<0>()[0]}; return true;
      case OutputVariableType::ForceLocal: values = {at.template stress<0>()[0]}; return true;
      default: return false;
    }
  }
};

}  // namespace dalembert
