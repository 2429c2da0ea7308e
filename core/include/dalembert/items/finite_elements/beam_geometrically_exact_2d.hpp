// ObjectBeamGeometricallyExact2D, specs/finite_elements/beam_geometrically_exact_2d.toml
#pragma once

#include <cmath>
#include <string>

#include "dalembert/contracts/strain_points.hpp"
#include "dalembert/finite_elements/beam_geometrically_exact_2d_parameters.hpp"
#include "dalembert/math/pack_functions.hpp"

namespace dalembert {

struct ObjectBeamGeometricallyExact2D : NoDoubt {
  using Parameters = ObjectBeamGeometricallyExact2DParameters;
  static constexpr std::array node_counts{2, 3};

  static void check(const Parameters& p, const ItemLabel& item) {
    check_element_length(p.physicsLength, item);
    if (p.nodeNumbers.size() != 2 && p.nodeNumbers.size() != 3)
      refuse(ErrorKind::value,
             {item, "nodeNumbers", "", std::to_string(p.nodeNumbers.size()) + " nodes", "two or three", ""});
  }

  // Shares of evenly spaced nodes in a polynomial through them, and in its derivative; xi from 0 to 1.
  template <int nodes>
  static constexpr std::array<double, nodes> shares(double xi) {
    if constexpr (nodes == 2)
      return {1 - xi, xi};
    else
      return {(1 - xi) * (1 - 2 * xi), 4 * xi * (1 - xi), xi * (2 * xi - 1)};
  }
  template <int nodes>
  static constexpr std::array<double, nodes> slopes(double xi) {
    if constexpr (nodes == 2)
      return {-1, 1};
    else
      return {4 * xi - 3, 4 - 8 * xi, 4 * xi - 1};
  }

  // Position and angle have the same interpolation. The number of points is one less than that of nodes, which avoids
  // shear locking.
  template <int nodes>
  struct On {
    static constexpr int size = 3 * nodes, node_size = 3, points = nodes - 1;
    static constexpr bool constant_mass = true, constant_jacobian = false, oriented = true;
    using Parameters = WithReference<ObjectBeamGeometricallyExact2DParameters, size>;

    struct Constants {
      double length = 1, mass = 0, inertia = 0;
      Mat3<double> stiffness, damping;
      // Difference between the section angle and the interpolated nodal angles, at each point.
      std::array<double, points> offset{};
      bool operator==(const Constants&) const = default;
    };
    static Constants constants(const Parameters& p) {
      Constants k{.length = p.physicsLength,
                  .mass = p.physicsLength * p.physicsMassPerLength,
                  .inertia = p.physicsLength * p.physicsCrossSectionInertia,
                  .stiffness = diagonal(p.physicsAxialStiffness, p.physicsShearStiffness, p.physicsBendingStiffness),
                  .damping = diagonal(p.physicsAxialDamping, p.physicsShearDamping, p.physicsBendingDamping)};
      for (int i = 0; i < points; ++i) k.offset[i] = offset(p, rule.position[i]);
      return k;
    }
    static bool calls(const Parameters&) { return false; }
    static bool damped(const Constants& k) { return k.damping != Mat3<double>{}; }
    static double along(const Constants& k, const Vec3<double>& local) { return 0.5 + local[0] / k.length; }

    // The coordinates themselves, one by one.
    struct Map : NoLieRotations {
      static constexpr int dimension = 1, size = 3 * nodes, vectors = size;
      static constexpr bool linear = true, derives = true;
      template <class S>
      using Local = Vectors<S, 1, vectors>;

      template <class S>
      static Local<S> local(const Constants&, const Coordinates<S, size>& x) {
        return of_vector(x.q);
      }
      template <class S>
      static Local<S> local_rate(const Constants&, const Coordinates<S, size>& x) {
        return of_vector(x.v);
      }
      template <class S>
      static Vec<S, size> pull_back(const Constants&, const Coordinates<S, size>&, const Local<S>& g) {
        return vector_of<size>([&](int i) { return g[i][0]; });
      }
      template <class T>
      static Mat<T, size, size> tangent(const Constants&, const Coordinates<T, size>&, const Local<T>&,
                                        const Mat<T, size, size>& m, const Mat<T, size, size>&, const Weights&) {
        return m;
      }

     private:
      template <class S>
      static Local<S> of_vector(const Vec<S, size>& q) {
        Local<S> y;
        for (int i = 0; i < size; ++i) y[i][0] = q[i];
        return y;
      }
    };

    // Axial strain, shear strain and curvature, of L x', L y', angle and L times its derivative.
    template <int point>
    struct At {
      static constexpr int fields = 4, strains = 3, stresses = 3;
      using Shape = ShapeNumbers<fields, size>;
      static constexpr bool uses(int field, int vector) { return vector % 3 == std::min(field, 2); }
      static constexpr Shape shape(double xi) {
        const auto value = shares<nodes>(xi), slope = slopes<nodes>(xi);
        Shape s{};
        for (int n = 0; n < nodes; ++n) {
          for (int f = 0; f < fields; ++f) s[f][3 * n + std::min(f, 2)] = f == 2 ? value[n] : slope[n];
        }
        return s;
      }
      static const auto& points(const Constants&) {
        static constexpr StrainPoints<Shape> own{
            .count = 1, .at = {{{rule.position[point], rule.weight[point], shape(rule.position[point])}}}};
        return own;
      }
      static const auto& stiffness(const Constants& k) { return k.stiffness; }
      static const auto& damping(const Constants& k) { return k.damping; }
      static Vec3<double> stress_free(const Parameters& p, const Vec3<double>&) {
        return {0, 0, p.physicsReferenceCurvature};
      }

      template <class S>
      static Vec3<S> strain(const Constants& k, const Vectors<S, 1, fields>& at) {
        const auto [s, c] = sine_cosine(S(at[2][0] + k.offset[point]));
        const S x = (1 / k.length) * at[0][0], y = (1 / k.length) * at[1][0];
        return {c * x + s * y - 1.0, c * y - s * x, (1 / k.length) * at[3][0]};
      }
      template <class S>
      static Vectors<S, 1, fields> pull_back(const Constants& k, const Vectors<S, 1, fields>& at,
                                             const Vec3<S>& stress) {
        const auto [s, c] = sine_cosine(S(at[2][0] + k.offset[point]));
        const S x = (1 / k.length) * at[0][0], y = (1 / k.length) * at[1][0];
        const S &axial = stress[0], &shear = stress[1];
        const S force_x = c * axial - s * shear, force_y = s * axial + c * shear;
        return {Vec<S, 1>{(1 / k.length) * force_x}, Vec<S, 1>{(1 / k.length) * force_y},
                Vec<S, 1>{x * -force_y + y * force_x}, Vec<S, 1>{(1 / k.length) * stress[2]}};
      }
    };
    template <class Points>
    struct EachPoint;
    template <int... point>
    struct EachPoint<std::integer_sequence<int, point...>> {
      using Type = std::tuple<At<point>...>;
    };
    using Families = typename EachPoint<std::make_integer_sequence<int, points>>::Type;
    using CallingFamilies = Families;

    template <class S>
    static Vec<S, size> inertia(const Constants& k, const Coordinates<S, size>& x) {
      return vector_of<size>([&](int row) {
        S sum = mass(k, row, row % 3) * x.a[row % 3];
        for (int j = 1; j < nodes; ++j) sum += mass(k, row, 3 * j + row % 3) * x.a[3 * j + row % 3];
        return sum;
      });
    }
    template <class T>
    static void add_inertia_tangent(const Constants& k, const Coordinates<T, size>&, const Weights& w,
                                    Mat<T, size, size>& m) {
      for (int i = 0; i < size; ++i)
        for (int j = i % 3; j < size; j += 3) m(i, j) = m(i, j) + w.a * mass(k, i, j);
    }
    template <class S>
    static Vec<S, size> mass_load(const Parameters& p, const Coordinates<S, size>&, const Vec3<S>& g) {
      return vector_of<size>([&](int i) {
        return i % 3 == 2 ? S(0) : S((p.physicsLength * p.physicsMassPerLength * integrals[i / 3]) * g[i % 3]);
      });
    }

    // The cross section at local[0], about the point local[1] away from the axis.
    template <class S>
    static Motion<S> motion(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local) {
      const double xi = 0.5 + local[0] / p.physicsLength;
      const Vec3<S> q = combined(xi, x.q), v = combined(xi, x.v), a = combined(xi, x.a);
      const S o(0);
      const Motion<S> axis{.position = {q[0], q[1], o},
                           .velocity = {v[0], v[1], o},
                           .acceleration = {a[0], a[1], o},
                           .rotation = planar_rotation(S(q[2] + offset(p, xi))),
                           .angular_velocity = {o, o, v[2]},
                           .angular_acceleration = {o, o, a[2]}};
      if (local[1] == 0) return axis;
      return moved(axis, Vec3<S>(local[1] * column(axis.rotation, 1)));
    }
    template <class S>
    static Vec<S, size> pull_back(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local,
                                  const Vec3<S>& force, const Vec3<S>& moment) {
      using std::cos;
      using std::sin;
      const double xi = 0.5 + local[0] / p.physicsLength;
      S turn = moment[2];
      if (local[1] != 0) {
        const S angle = combined(xi, x.q)[2] + offset(p, xi);
        turn -= local[1] * (cos(angle) * force[0] + sin(angle) * force[1]);
      }
      const auto share = shares<nodes>(xi);
      return vector_of<size>([&](int i) { return S(share[i / 3] * (i % 3 == 2 ? turn : force[i % 3])); });
    }

    template <class Section>
    static bool output(const Section& at, std::vector<double>& values) {
      Section here = at;
      here.k.offset[0] = offset(at.p, along(at.k, at.request.local));
      switch (at.request.variable) {
        case OutputVariableType::Rotation:
          values = {0, 0, combined(along(at.k, at.request.local), at.x.q)[2] + here.k.offset[0]};
          return true;
        case OutputVariableType::StrainLocal: {
          const auto e = here.template strain<0>();
          values = {e[0], 0, 0, 0, 0, e[1]};
          return true;
        }
        case OutputVariableType::CurvatureLocal: values = {0, 0, here.template elastic_strain<0>()[2]}; return true;
        case OutputVariableType::ForceLocal: {
          const auto force = here.template stress<0>();
          values = {force[0], force[1], 0};
          return true;
        }
        case OutputVariableType::TorqueLocal: values = {0, 0, here.template stress<0>()[2]}; return true;
        default: return false;
      }
    }

   private:
    static constexpr QuadratureRule rule = points == 1 ? gauss_1 : gauss_2;

    // Integrals of the shares, and of their products.
    static constexpr std::array<double, nodes> integrals = [] {
      std::array<double, nodes> sum{};
      for (int i = 0; i < gauss_3.count; ++i)
        for (int n = 0; n < nodes; ++n) sum[n] += gauss_3.weight[i] * shares<nodes>(gauss_3.position[i])[n];
      return sum;
    }();
    static constexpr std::array<std::array<double, nodes>, nodes> products = [] {
      std::array<std::array<double, nodes>, nodes> sum{};
      for (int i = 0; i < gauss_3.count; ++i) {
        const auto share = shares<nodes>(gauss_3.position[i]);
        for (int n = 0; n < nodes; ++n)
          for (int m = 0; m < nodes; ++m) sum[n][m] += gauss_3.weight[i] * share[n] * share[m];
      }
      return sum;
    }();
    static double mass(const Constants& k, int i, int j) {
      return (i % 3 == 2 ? k.inertia : k.mass) * products[i / 3][j / 3];
    }

    static Mat3<double> diagonal(double a, double b, double c) { return {a, 0, 0, 0, b, 0, 0, 0, c}; }

    // Reference angles of the nodes are optional: by default, sections are normal to the reference axis.
    static double offset(const Parameters& p, double xi) {
      if (p.includeReferenceRotations) return 0;
      const auto slope = slopes<nodes>(xi);
      double x = 0, y = 0;
      for (int n = 0; n < nodes; ++n) {
        x += slope[n] * p.reference[3 * n];
        y += slope[n] * p.reference[3 * n + 1];
      }
      return std::atan2(y, x) - combined(xi, p.reference)[2];
    }
    // Position and angle out of q, v or a.
    template <class S>
    static Vec3<S> combined(double xi, const Vec<S, size>& q) {
      const auto share = shares<nodes>(xi);
      return vector_of<3>([&](int d) {
        S sum = share[0] * q[d];
        for (int n = 1; n < nodes; ++n) sum += share[n] * q[3 * n + d];
        return sum;
      });
    }
  };
};

}  // namespace dalembert
