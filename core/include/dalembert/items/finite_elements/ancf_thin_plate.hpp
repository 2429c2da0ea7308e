// ObjectANCFThinPlate, specs/finite_elements/ancf_thin_plate.toml
#pragma once

#include <algorithm>
#include <string>

#include "dalembert/contracts/strain_points.hpp"
#include "dalembert/finite_elements/ancf_thin_plate_parameters.hpp"
#include "dalembert/items/finite_elements/plate_shape.hpp"
#include "dalembert/math/slope_frame.hpp"

namespace dalembert {

struct ObjectANCFThinPlate : NoDoubt {
  using Given = ObjectANCFThinPlateParameters;
  static constexpr int size = 36, node_size = 9;
  static constexpr bool constant_mass = true, constant_jacobian = false, oriented = false;
  using Parameters = WithReference<Given, size>;

  static void check(const Given& p, const ItemLabel& item) {
    const auto one_or_four = [&](const char* name, std::size_t received) {
      if (received != 1 && received != 4)
        refuse(ErrorKind::value,
               {item, name, "", std::to_string(received) + " values", "one for the plate, or four for its nodes", ""});
    };
    one_or_four("physicsThickness", p.physicsThickness.size());
    one_or_four("physicsStrainCoefficients", p.physicsStrainCoefficients.size());
    one_or_four("physicsCurvatureCoefficients", p.physicsCurvatureCoefficients.size());
    if (!std::ranges::all_of(p.physicsThickness, [](double h) { return h > 0; }))
      refuse(ErrorKind::value,
             {item, "physicsThickness", "", "a value that is not positive", "positive thicknesses", ""});
    if (p.useReducedOrderIntegration > 1)
      refuse(ErrorKind::value,
             {item, "useReducedOrderIntegration", "", std::to_string(p.useReducedOrderIntegration), "0 or 1", ""});
  }

  // ---- geometry: places have two coordinates from -1 to 1 ------------------------------------------------------------------------
  using Place = Vec<double, 2>;
  static Place along(const auto&, const Vec3<double>& local) { return {local[0], local[1]}; }

  // Scales of a unit slope in x and y at each node, in halves.
  struct Scales {
    std::array<double, 4> x, y;
    bool operator==(const Scales&) const = default;
  };
  static Scales scales(const Parameters& p) {
    const auto side = [&p](int from) {
      return norm(segment<3>(p.reference, 9 * ((from + 1) % 4)) - segment<3>(p.reference, 9 * from));
    };
    const std::array<double, 4> x{side(0), side(0), side(2), side(2)}, y{side(3), side(1), side(1), side(3)};
    Scales s{};
    for (int n = 0; n < 4; ++n) {
      s.x[n] = p.slopesScalingX[n] > 0 ? p.slopesScalingX[n] : x[n];
      s.y[n] = p.slopesScalingY[n] > 0 ? p.slopesScalingY[n] : y[n];
    }
    return s;
  }
  using Shares = PlateShape::Shares;
  static Shares shares(const Scales& scales, const Place& at, int by_xi, int by_eta) {
    return PlateShape::shares(at[0], at[1], scales.x, scales.y, by_xi, by_eta);
  }
  template <class S>
  static Vec3<S> combined(const Shares& shape, const Vec<S, size>& q) {
    Vec3<S> sum;
    for (int i = 0; i < 12; ++i) sum += shape[i] * segment<3>(q, 3 * i);
    return sum;
  }
  // Interpolates nodal values, or a constant.
  template <class V>
  static auto at_place(const std::vector<V>& values, const Place& at) {
    if (values.size() == 1) return values[0];
    const auto nodes = PlateShape::bilinear(at[0], at[1]);
    V sum = nodes[0] * values[0];
    for (std::size_t n = 1; n < 4; ++n) sum = sum + nodes[n] * values[n];
    return sum;
  }

  // ---- strains -----------------------------------------------------------------------------------------------------------------------
  using Shape = ShapeNumbers<5, 12>;
  struct Constants {
    double length = 1;  // weights are areas
    double damping_by_mass = 0, damping_by_membrane = 0, damping_by_bending = 0;
    Scales scales{};
    Vec<double, size> reference{};
    std::vector<Mat3<double>> membrane, bending;
    std::array<std::array<double, 12>, 12> mass{};  // per direction
    StrainPoints<Shape, Place, 16> points{};
    bool operator==(const Constants&) const = default;
  };
  static Constants constants(const Parameters& p) {
    const double by_stiffness = p.stiffnessProportionalDamping, by_bending = p.bendingStiffnessProportionalDamping;
    Constants k{.damping_by_mass = p.physicsMassProportionalDamping,
                .damping_by_membrane = by_stiffness,
                .damping_by_bending = by_bending < 0 ? by_stiffness : by_bending,
                .scales = scales(p),
                .reference = p.reference,
                .membrane = p.physicsStrainCoefficients,
                .bending = p.physicsCurvatureCoefficients};
    each_point(p.useReducedOrderIntegration == 0 ? gauss_4 : gauss_3, [&](const Place& at, double weight) {
      k.points.at[k.points.count++] = {at, weight * Tangents(k, at).area, Surface::shape(k, at)};
    });
    each_point(gauss_5, [&](const Place& at, double weight) {
      const auto shape = shares(k.scales, at, 0, 0);
      const double mass = weight * Tangents(k, at).area * p.physicsDensity * at_place(p.physicsThickness, at);
      for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 12; ++j) k.mass[i][j] += mass * shape[i] * shape[j];
    });
    return k;
  }
  static bool calls(const Parameters&) { return false; }
  static bool damped(const Constants& k) { return k.damping_by_membrane != 0 || k.damping_by_bending != 0; }

  // All vectors of all nodes, as they are.
  struct Map : NoLieRotations {
    static constexpr int dimension = 3, vectors = 12, size = 36;
    static constexpr bool linear = true, derives = true;
    using K = Constants;

    template <class S>
    static Vectors<S, 3, 12> local(const K&, const Coordinates<S, size>& x) {
      return of_vector(x.q);
    }
    template <class S>
    static Vectors<S, 3, 12> local_rate(const K&, const Coordinates<S, size>& x) {
      return of_vector(x.v);
    }
    template <class S>
    static Vec<S, size> pull_back(const K&, const Coordinates<S, size>&, const Vectors<S, 3, 12>& g) {
      return vector_of<size>([&](int i) { return g[i / 3][i % 3]; });
    }
    template <class T>
    static Mat<T, size, size> tangent(const K&, const Coordinates<T, size>&, const Vectors<T, 3, 12>&,
                                      const Mat<T, size, size>& m, const Mat<T, size, size>&, const Weights&) {
      return m;
    }

   private:
    template <class S>
    static Vectors<S, 3, 12> of_vector(const Vec<S, size>& q) {
      Vectors<S, 3, 12> y;
      for (int i = 0; i < 12; ++i) y[i] = segment<3>(q, 3 * i);
      return y;
    }
  };

  // Strains and shear of the mid-surface, curvatures and twice the twist, with engineering factors, from r_x, r_y,
  // r_xx, r_yy, r_xy.
  struct Surface {
    static constexpr int fields = 5, strains = 6, stresses = 6;
    static constexpr bool uses(int, int) { return true; }
    static const auto& points(const Constants& k) { return k.points; }
    // Derivatives along axes in the tangent plane of the reference configuration, the first one along the first coordinate line.
    static Shape shape(const Constants& k, const Place& at) {
      const Tangents t(k, at);
      const auto xi = shares(k.scales, at, 1, 0), eta = shares(k.scales, at, 0, 1), xi_xi = shares(k.scales, at, 2, 0),
                 eta_eta = shares(k.scales, at, 0, 2), xi_eta = shares(k.scales, at, 1, 1);
      Shape s{};
      for (int i = 0; i < 12; ++i) {
        s[0][i] = t.xi_x * xi[i];
        s[1][i] = t.xi_y * xi[i] + t.eta_y * eta[i];
        s[2][i] = t.xi_x * t.xi_x * xi_xi[i];
        s[3][i] = t.xi_y * t.xi_y * xi_xi[i] + 2 * t.xi_y * t.eta_y * xi_eta[i] + t.eta_y * t.eta_y * eta_eta[i];
        s[4][i] = t.xi_x * (t.xi_y * xi_xi[i] + t.eta_y * xi_eta[i]);
      }
      return s;
    }
    static Mat<double, 6, 6> stiffness(const Constants& k, const Place& at) {
      return joined(at_place(k.membrane, at), at_place(k.bending, at));
    }
    static Mat<double, 6, 6> damping(const Constants& k, const Place& at) {
      return joined(k.damping_by_membrane * at_place(k.membrane, at), k.damping_by_bending * at_place(k.bending, at));
    }
    static Mat<double, 6, 6> joined(const Mat3<double>& membrane, const Mat3<double>& bending) {
      return matrix_of<6, 6>([&](int i, int j) {
        return i / 3 != j / 3 ? 0.0 : i < 3 ? membrane(i, j) : bending(i - 3, j - 3);
      });
    }
    static Vec<double, 6> stress_free(const Parameters& p, const Vec<double, 6>& of_reference) {
      return p.strainIsRelativeToReference * of_reference;
    }
    template <class S>
    static Vec<S, 6> strain(const Constants&, const Vectors<S, 3, 5>& r) {
      const Vec3<S> normal = cross(r[0], r[1]);
      const S square = dot(normal, normal), scale = 1.0 / (square * norm(normal));
      return {0.5 * (dot(r[0], r[0]) - 1.0), 0.5 * (dot(r[1], r[1]) - 1.0), dot(r[0], r[1]),
              scale * dot(normal, r[2]),     scale * dot(normal, r[3]),     2.0 * (scale * dot(normal, r[4]))};
    }
    template <class S>
    static Vectors<S, 3, 5> pull_back(const Constants&, const Vectors<S, 3, 5>& r, const Vec<S, 6>& stress) {
      const Vec3<S> normal = cross(r[0], r[1]);
      const S square = dot(normal, normal), scale = 1.0 / (square * norm(normal)), twist = 2.0 * stress[5];
      const Vec3<S> bent = stress[3] * r[2] + stress[4] * r[3] + twist * r[4];
      const Vec3<S> on_normal = scale * (bent - (3.0 * dot(bent, normal) / square) * normal),
                    by_curvature = scale * normal;
      return {stress[0] * r[0] + stress[2] * r[1] + cross(r[1], on_normal),
              stress[1] * r[1] + stress[2] * r[0] + cross(on_normal, r[0]), stress[3] * by_curvature,
              stress[4] * by_curvature, twist * by_curvature};
    }
  };
  using Families = std::tuple<Surface>;
  using CallingFamilies = Families;

  // ---- inertia -----------------------------------------------------------------------------------------------------------------------
  template <class S>
  static Vec<S, size> inertia(const Constants& k, const Coordinates<S, size>& x) {
    return vector_of<size>([&](int row) {
      S sum(0.0);
      for (int j = 0; j < 12; ++j)
        sum += k.mass[row / 3][j] * (x.a[3 * j + row % 3] + k.damping_by_mass * x.v[3 * j + row % 3]);
      return sum;
    });
  }
  template <class T>
  static void add_inertia_tangent(const Constants& k, const Coordinates<T, size>&, const Weights& w,
                                  Mat<T, size, size>& m) {
    const double weight = w.a + w.v * k.damping_by_mass;
    for (int i = 0; i < size; ++i)
      for (int j = i % 3; j < size; j += 3) m(i, j) = m(i, j) + weight * k.mass[i / 3][j / 3];
  }
  template <class S>
  static Vec<S, size> mass_load(const Parameters& p, const Coordinates<S, size>&, const Vec3<S>& g) {
    const Constants k = constants(p);
    return vector_of<size>([&](int i) {  // positions of all nodes move equally with the plate
      return S((k.mass[i / 3][0] + k.mass[i / 3][3] + k.mass[i / 3][6] + k.mass[i / 3][9]) * g[i % 3]);
    });
  }

  // ---- points: local[2] from -1 to 1 over the thickness, along the normal ---------------------------------------------------------------
  template <class S>
  static Motion<S> motion(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local) {
    const Place at{local[0], local[1]};
    const Scales scale = scales(p);
    const auto shape = shares(scale, at, 0, 0);
    Motion<S> m{
        .position = combined(shape, x.q), .velocity = combined(shape, x.v), .acceleration = combined(shape, x.a)};
    if (local[2] == 0) return m;
    const auto in_time = [&x](const Shares& s) {
      return moving(moving(combined(s, x.q), combined(s, x.v)), moving(combined(s, x.v), combined(s, x.a)));
    };
    const auto normal = cross(in_time(shares(scale, at, 1, 0)), in_time(shares(scale, at, 0, 1)));
    const auto arm = (0.5 * local[2] * at_place(p.physicsThickness, at) / norm(normal)) * normal;
    for (int i = 0; i < 3; ++i) {
      m.position[i] += arm[i].value.value;
      m.velocity[i] += arm[i].d[0].value;
      m.acceleration[i] += arm[i].d[0].d[0];
    }
    return m;
  }
  template <class S>
  static Vec<S, size> pull_back(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local,
                                const Vec3<S>& force, const Vec3<S>&) {
    const Place at{local[0], local[1]};
    const Scales scale = scales(p);
    const auto shape = shares(scale, at, 0, 0);
    if (local[2] == 0) return vector_of<size>([&](int i) { return shape[i / 3] * force[i % 3]; });
    const auto by_xi = shares(scale, at, 1, 0), by_eta = shares(scale, at, 0, 1);
    const Vec3<S> a = combined(by_xi, x.q), b = combined(by_eta, x.q), area = cross(a, b),
                  normal = (1.0 / norm(area)) * area;
    const Vec3<S> on_area =
        (0.5 * local[2] * at_place(p.physicsThickness, at) / norm(area)) * (force - dot(force, normal) * normal);
    const Vec3<S> on_a = cross(b, on_area), on_b = cross(on_area, a);
    return vector_of<size>(
        [&](int i) { return shape[i / 3] * force[i % 3] + by_xi[i / 3] * on_a[i % 3] + by_eta[i / 3] * on_b[i % 3]; });
  }

  template <class Section>
  static bool output(const Section& at, std::vector<double>& values) {
    const auto tell = [&values](const Vec3<double>& v) {
      values.assign(v.x.begin(), v.x.end());
      return true;
    };
    switch (at.request.variable) {
      case OutputVariableType::Director1: return tell(at.template fields<0>()[0]);
      case OutputVariableType::Director2: return tell(at.template fields<0>()[1]);
      case OutputVariableType::StrainLocal: return tell(segment<3>(at.template elastic_strain<0>(), 0));
      case OutputVariableType::CurvatureLocal: {
        const auto e = at.template elastic_strain<0>();
        return tell({e[4], -e[3], e[5]});
      }
      case OutputVariableType::ForceLocal: return tell(segment<3>(at.template stress<0>(), 0));
      case OutputVariableType::TorqueLocal: return tell(segment<3>(at.template stress<0>(), 3));
      case OutputVariableType::StressLocal: {
        const auto s = at.template stress<0>();
        const double h = at_place(at.p.physicsThickness, along(at.k, at.request.local)),
                     bend = -6 * at.request.local[2] / (h * h);
        const auto component = [&](int i) { return s[i] / h + bend * s[3 + i]; };
        values = {component(0), component(1), 0, 0, 0, component(2)};
        return true;
      }
      default: return false;
    }
  }

 private:
  // Reference configuration: area per unit of the local coordinates, and their derivatives in the tangent plane.
  struct Tangents {
    double area, xi_x, xi_y, eta_y;

    Tangents(const Constants& k, const Place& at) {
      const auto along_xi = combined(shares(k.scales, at, 1, 0), k.reference),
                 along_eta = combined(shares(k.scales, at, 0, 1), k.reference);
      area = norm(cross(along_xi, along_eta));
      const double length = norm(along_xi);
      xi_x = 1 / length;
      eta_y = length / area;
      xi_y = -dot(along_xi, along_eta) / (length * area);
    }
  };
  template <class Call>
  static void each_point(const QuadratureRule& rule, const Call& call) {
    for (int i = 0; i < rule.count; ++i)
      for (int j = 0; j < rule.count; ++j)
        call(Place{2 * rule.position[i] - 1, 2 * rule.position[j] - 1}, 4 * rule.weight[i] * rule.weight[j]);
  }
};

}  // namespace dalembert
