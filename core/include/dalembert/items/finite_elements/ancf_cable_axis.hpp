// Common part of ObjectANCFCable and ObjectANCFCable2D, specs/finite_elements/ancf_cable.toml and ancf_cable_2d.toml:
// a cubic axis on two nodes with position and slope, in D dimensions. Strains depend on r' and r'', that is on three
// vectors only: the chord (r1 - r0) / L and both nodal slopes.
#pragma once

#include "dalembert/contracts/strain_points.hpp"
#include "dalembert/math/hermite.hpp"

namespace dalembert {

template <int D>
struct AncfCableAxis : NoDoubt {
  static constexpr int size = 4 * D, node_size = 2 * D;
  static constexpr bool constant_mass = true;

  using Shape = ShapeNumbers<2, 3>;  // factors for r' and L r''
  static constexpr Shape hermite_shape(double xi) { return {hermite::slope(xi), hermite::bend(xi)}; }
  struct Rule {
    StrainPoints<Shape> stretching, bending;
  };
  // Indexed by the parameter useReducedOrderIntegration.
  static constexpr std::array<Rule, 3> rules{
      {{tabulated(gauss_5, hermite_shape), tabulated(gauss_3, hermite_shape)},
       {tabulated(gauss_4, hermite_shape), tabulated(gauss_2, hermite_shape)},
       {tabulated(lobatto_3, hermite_shape), tabulated(gauss_2, hermite_shape)}}};

  struct Constants {
    const Rule* rule = nullptr;
    double length = 1, axial_stiffness = 0, bending_stiffness = 0, axial_damping = 0, bending_damping = 0;
    std::array<std::array<double, 4>, 4> mass;  // per direction, of r0, r0', r1, r1'
    bool operator==(const Constants&) const = default;
  };
  template <class P>
  static Constants constants(const P& p) {
    Constants k{.rule = &rules[static_cast<std::size_t>(p.useReducedOrderIntegration)],
                .length = p.physicsLength,
                .axial_stiffness = p.physicsAxialStiffness,
                .bending_stiffness = p.physicsBendingStiffness,
                .axial_damping = p.physicsAxialDamping,
                .bending_damping = p.physicsBendingDamping,
                .mass = hermite::products(p.physicsLength)};
    for (auto& row : k.mass)
      for (double& entry : row) entry *= p.physicsMassPerLength;
    return k;
  }
  static bool damped(const Constants& k) { return k.axial_damping != 0 || k.bending_damping != 0; }
  static double along(const Constants& k, const Vec3<double>& local) { return local[0] / k.length; }

  template <class P>
  static void check(const P& p, const ItemLabel& item) {
    check_element_length(p.physicsLength, item);
    if (p.useReducedOrderIntegration < 0 || p.useReducedOrderIntegration > 2)
      refuse(ErrorKind::value,
             {item, "useReducedOrderIntegration", "", std::to_string(p.useReducedOrderIntegration), "0, 1 or 2", ""});
  }

  struct Map : NoLieRotations {
    static constexpr int dimension = D, vectors = 3, size = 4 * D;
    static constexpr bool linear = true, derives = true;

    template <class S>
    static Vectors<S, D, 3> local(const Constants& k, const Coordinates<S, size>& x) {
      return of_vector(k, x.q);
    }
    template <class S>
    static Vectors<S, D, 3> local_rate(const Constants& k, const Coordinates<S, size>& x) {
      return of_vector(k, x.v);
    }
    template <class S>
    static Vec<S, size> pull_back(const Constants& k, const Coordinates<S, size>&, const Vectors<S, D, 3>& g) {
      return vector_of<size>([&](int i) { return share(i / D, k.length) * g[vector(i / D)][i % D]; });
    }
    template <class T>
    static Mat<T, size, size> tangent(const Constants& k, const Coordinates<T, size>&, const Vectors<T, D, 3>&,
                                      const Mat<T, 3 * D, 3 * D>& m, const Mat<T, 3 * D, 3 * D>&, const Weights&) {
      return matrix_of<size, size>([&](int i, int j) {
        return (share(i / D, k.length) * share(j / D, k.length)) *
               m(D * vector(i / D) + i % D, D * vector(j / D) + j % D);
      });
    }

   private:
    // Assigns r0, r0', r1, r1' to a vector, with a factor.
    static constexpr int vector(int i) { return i == 1 ? 1 : i == 3 ? 2 : 0; }
    static constexpr double share(int i, double length) { return i == 0 ? -1 / length : i == 2 ? 1 / length : 1.0; }
    template <class S>
    static Vectors<S, D, 3> of_vector(const Constants& k, const Vec<S, size>& q) {
      const auto part = [&](int i) { return segment<D>(q, D * i); };
      return {(1 / k.length) * (part(2) - part(0)), part(1), part(3)};
    }
  };

  struct Points {
    static constexpr bool uses(int, int) { return true; }
    static constexpr Shape shape(double xi) { return hermite_shape(xi); }
  };
  // |r'| - 1
  struct Stretching : Points {
    static constexpr int fields = 1, strains = 1, stresses = 1;
    static const auto& points(const Constants& k) { return k.rule->stretching; }
    static double stiffness(const Constants& k) { return k.axial_stiffness; }
    static double damping(const Constants& k) { return k.axial_damping; }
    template <class P>
    static Vec<double, 1> stress_free(const P& p, const Vec<double, 1>& of_reference) {
      return {p.physicsReferenceAxialStrain + p.strainIsRelativeToReference * of_reference[0]};
    }
    template <class S>
    static Vec<S, 1> strain(const Constants&, const Vectors<S, D, 1>& r) {
      return {norm(r[0]) - 1.0};
    }
    template <class S, class N>
    static Vectors<S, D, 1> pull_back(const Constants&, const Vectors<S, D, 1>& r, const Vec<N, 1>& force) {
      return {(force[0] * (1.0 / norm(r[0]))) * r[0]};
    }
  };

  template <class S>
  static Vec<S, size> inertia(const Constants& k, const Coordinates<S, size>& x) {
    return vector_of<size>([&](int row) {
      const auto& mass = k.mass[row / D];
      S sum = mass[0] * x.a[row % D];
      for (int j = 1; j < 4; ++j) sum += mass[j] * x.a[D * j + row % D];
      return sum;
    });
  }
  template <class T>
  static void add_inertia_tangent(const Constants& k, const Coordinates<T, size>&, const Weights& w,
                                  Mat<T, size, size>& m) {
    for (int i = 0; i < size; ++i)
      for (int j = i % D; j < size; j += D) m(i, j) = m(i, j) + w.a * k.mass[i / D][j / D];
  }
  // The integral of the shape functions, times mass and acceleration.
  template <class P, class S>
  static Vec<S, size> mass_load(const P& p, const Coordinates<S, size>&, const Vec3<S>& g) {
    const auto shares = hermite::integrals(p.physicsLength);
    return vector_of<size>([&](int i) { return (p.physicsMassPerLength * shares[i / D]) * g[i % D]; });
  }

  // r or r' from q, v or a.
  template <class S>
  static Vec<S, D> combined(const std::array<double, 4>& shape, const Vec<S, size>& q) {
    return vector_of<D>([&](int d) {
      return shape[0] * q[d] + shape[1] * q[D + d] + shape[2] * q[2 * D + d] + shape[3] * q[3 * D + d];
    });
  }
};

}  // namespace dalembert
