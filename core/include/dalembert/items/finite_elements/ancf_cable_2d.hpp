// ObjectANCFCable2D, specs/finite_elements/ancf_cable_2d.toml
//
// Slope r' and its derivative r'' depend on three vectors only: the chord (r1 - r0) / L and both nodal slopes. Strains,
// forces and their derivatives are taken per integration point from r' and r'', and mapped to coordinates afterwards.
#pragma once

#include "dalembert/contracts/element.hpp"
#include "dalembert/contracts/user_function.hpp"
#include "dalembert/finite_elements/ancf_cable_2d_parameters.hpp"
#include "dalembert/items/finite_elements/ancf_cable_2d_rules.hpp"
#include "dalembert/math/lanes.hpp"
#include "dalembert/model/errors.hpp"

namespace dalembert {

struct ObjectANCFCable2D {
  using Parameters = ObjectANCFCable2DParameters;
  using Rule = ANCFCable2DRule;
  using Sample = Rule::Sample;
  static constexpr int size = 8;
  static constexpr bool constant_mass = true;

  // Strains at which a cross section carries no force.
  struct StressFree {
    double strain = 0, curvature = 0;
    bool operator==(const StressFree&) const = default;
  };
  struct Prepared {
    const Rule* rule = nullptr;
    double length = 1;
    Mat<double, 4, 4> mass;  // per plane coordinate of r0, r0', r1, r1'
    std::array<StressFree, 5> stretching;
    std::array<StressFree, 3> bending;
    bool operator==(const Prepared& o) const {
      return rule == o.rule && length == o.length && mass.x == o.mass.x && stretching == o.stretching && bending == o.bending;
    }
  };

  static void check(const Parameters& p, const ItemLabel& item) {
    if (!(p.physicsLength > 0))
      refuse(ErrorKind::value, {item, "physicsLength", "", std::to_string(p.physicsLength), "a positive length", ""});
    if (p.useReducedOrderIntegration < 0 || p.useReducedOrderIntegration > 2)
      refuse(ErrorKind::value,
             {item, "useReducedOrderIntegration", "", std::to_string(p.useReducedOrderIntegration), "0, 1 or 2", ""});
  }

  static Prepared prepare(const Parameters& p, const Vec<double, size>& reference) {
    Prepared k;
    k.rule = &ancf_cable_2d_rules[static_cast<std::size_t>(p.useReducedOrderIntegration)];
    k.length = p.physicsLength;
    k.mass = mass_matrix(p.physicsMassPerLength * p.physicsLength, p.physicsLength);
    for (int i = 0; i < k.rule->stretching_points; ++i)
      k.stretching[i] = stress_free(p, k.rule->stretching[i], reference);
    for (int i = 0; i < k.rule->bending_points; ++i) k.bending[i] = stress_free(p, k.rule->bending[i], reference);
    return k;
  }

  // User functions are called for one element at a time.
  static bool same_law(const Parameters& p, const Prepared& k, const Parameters& other_p, const Prepared& other_k) {
    const auto law = [](const Parameters& x) {
      return std::array{x.physicsAxialStiffness, x.physicsAxialDamping, x.physicsBendingStiffness, x.physicsBendingDamping};
    };
    const auto calls = [](const Parameters& x) { return x.axialForceUserFunction || x.bendingMomentUserFunction; };
    return !calls(p) && !calls(other_p) && law(p) == law(other_p) && k == other_k;
  }

  // M a and the virtual work of axial force and bending moment.
  template <class S>
  static Vec<S, size> residual(const Parameters& p, const Prepared& k, const Context& c,
                               const Coordinates<S, size>& x) {
    const Shape<S> shape(x.q, k.length), rate(x.v, k.length);
    std::array<Vec<S, 2>, 3> work{};
    for (int i = 0; i < k.rule->stretching_points; ++i) {
      const Sample& at = k.rule->stretching[i];
      const Vec<S, 2> n = stretching(p, c, at, k.stretching[i], axis(shape, rate, at, k.length));
      for (int j = 0; j < 3; ++j) work[j] += at.weight * k.length * at.slope[j] * n;
    }
    for (int i = 0; i < k.rule->bending_points; ++i) {
      const Sample& at = k.rule->bending[i];
      const Conjugates<S> m = bending(p, c, at, k.bending[i], axis(shape, rate, at, k.length));
      for (int j = 0; j < 3; ++j) work[j] += at.weight * (k.length * at.slope[j] * m.slope + at.bend[j] * m.bend);
    }
    Vec<S, size> r;
    for (int i = 0; i < 4; ++i) {
      const double factor = share(i, k.length);
      for (int d = 0; d < 2; ++d) {
        S sum = factor * work[part(i)][d];
        for (int j = 0; j < 4; ++j) sum += k.mass(i, j) * x.a[2 * j + d];
        r[2 * i + d] = sum;
      }
    }
    return r;
  }

  // The derivatives of the forces by r' and r'', found per point, times the shape functions.
  template <class T>
  static Mat<T, size, size> tangent(const Parameters& p, const Prepared& k, const Context& c, const Coordinates<T, size>& x,
                                    const Weights& w) {
    Blocks<T> blocks{};
    if (w.q != 0 || w.v != 0) {
      const Shape<T> shape(x.q, k.length), rate(x.v, k.length);
      if (p.axialForceUserFunction) {
        add_stretching<4>(p, k, c, shape, rate, w, blocks);
      } else {
        add_stretching<2>(p, k, c, shape, rate, w, blocks);
      }
      add_bending(p, k, c, shape, rate, w, blocks);
    }
    Mat<T, size, size> m;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const double factor = share(i, k.length) * share(j, k.length), inertia = w.a * k.mass(i, j);
        const Mat<T, 2, 2>& block = blocks[part(i)][part(j)];
        for (int d = 0; d < 2; ++d)
          for (int e = 0; e < 2; ++e) m(2 * i + d, 2 * j + e) = factor * block(d, e) + (d == e ? inertia : 0.0);
      }
    return m;
  }

  // The cross section at local[0], about the point local[1] away from the axis.
  template <class S>
  static Motion<S> motion(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local) {
    using std::sqrt;
    const double length = p.physicsLength;
    const auto shape = values(local[0] / length, length), slope = derivatives(local[0] / length, length);
    const Vec<S, 2> r = combine(shape, x.q), v = combine(shape, x.v), a = combine(shape, x.a);
    const Vec<S, 2> t = combine(slope, x.q), t_rate = combine(slope, x.v), t_rate2 = combine(slope, x.a);
    const S square = dot(t, t), scale = 1.0 / sqrt(square), cosine = scale * t[0], sine = scale * t[1], o(0);
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
  static Vec<S, size> pull_back(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local,
                                const Vec3<S>& force, const Vec3<S>& moment) {
    using std::sqrt;
    const auto shape = values(local[0] / p.physicsLength, p.physicsLength);
    const auto slope = derivatives(local[0] / p.physicsLength, p.physicsLength);
    const Vec<S, 2> t = combine(slope, x.q);
    const S square = dot(t, t);
    S m = moment[2];
    if (local[1] != 0) m -= (local[1] / sqrt(square)) * (t[1] * force[1] + t[0] * force[0]);
    m = m / square;
    Vec<S, size> r;
    for (int i = 0; i < 4; ++i) {
      r[2 * i] = shape[i] * force[0] - slope[i] * m * t[1];
      r[2 * i + 1] = shape[i] * force[1] + slope[i] * m * t[0];
    }
    return r;
  }
  // The integral of the shape functions, times mass and acceleration.
  template <class S>
  static Vec<S, size> mass_load(const Parameters& p, const Coordinates<S, size>&, const Vec3<S>& g) {
    const double length = p.physicsLength, mass = p.physicsMassPerLength * length;
    const std::array<double, 4> share{mass / 2, mass * length / 12, mass / 2, -mass * length / 12};
    Vec<S, size> r;
    for (int i = 0; i < size; ++i) r[i] = share[i / 2] * g[i % 2];
    return r;
  }

  static bool output(const Parameters& p, const Context& c, const Coordinates<double, size>& x,
                     const OutputRequest& request, std::vector<double>& values) {
    const double length = p.physicsLength;
    const Sample at = Rule::sample(request.local[0] / length, 0);
    const Axis<double> a = axis(Shape<double>(x.q, length), Shape<double>(x.v, length), at, length);
    const auto free = [&] { return stress_free(p, at, load<double, size>(request.reference.data())); };
    switch (request.variable) {
      case OutputVariableType::Rotation: values = {std::atan2(a.slope[1], a.slope[0])}; return true;
      case OutputVariableType::Director1: values = {a.slope[0], a.slope[1], 0}; return true;
      case OutputVariableType::StrainLocal: values = {strain(a) - request.local[1] * curvature(a)}; return true;
      case OutputVariableType::CurvatureLocal: values = {curvature(a)}; return true;
      case OutputVariableType::ForceLocal: values = {axial_force(p, c, at, free(), a, strain(a))}; return true;
      case OutputVariableType::TorqueLocal: values = {bending_moment(p, c, at, free(), a, curvature(a))}; return true;
      default: return false;
    }
  }

 private:
  // Chord and nodal slopes, or their rates.
  template <class S>
  struct Shape {
    std::array<Vec<S, 2>, 3> parts;
    Shape(const Vec<S, size>& q, double length)
        : parts{Vec<S, 2>{(q[4] - q[0]) * (1 / length), (q[5] - q[1]) * (1 / length)}, {q[2], q[3]}, {q[6], q[7]}} {}
    Vec<S, 2> at(const std::array<double, 3>& h) const { return h[0] * parts[0] + h[1] * parts[1] + h[2] * parts[2]; }
  };
  // r', r'' and their rates at one point of the axis.
  template <class S>
  struct Axis {
    Vec<S, 2> slope, bend, slope_rate, bend_rate;
  };
  // Conjugates of r' and r''.
  template <class S>
  struct Conjugates {
    Vec<S, 2> slope, bend;
  };
  template <class T>
  using Blocks = std::array<std::array<Mat<T, 2, 2>, 3>, 3>;

  // Which part r0, r0', r1, r1' belong to, and with what factor.
  static constexpr int part(int i) { return i == 1 ? 1 : i == 3 ? 2 : 0; }
  static constexpr double share(int i, double length) { return i == 0 ? -1 / length : i == 2 ? 1 / length : 1.0; }

  template <class S>
  static S planar_cross(const Vec<S, 2>& a, const Vec<S, 2>& b) {
    return a[0] * b[1] - a[1] * b[0];
  }
  template <class S>
  static Axis<S> axis(const Shape<S>& shape, const Shape<S>& rate, const Sample& at, double length) {
    return {shape.at(at.slope), (1 / length) * shape.at(at.bend), rate.at(at.slope), (1 / length) * rate.at(at.bend)};
  }

  template <class S>
  static S strain(const Axis<S>& a) {
    return norm(a.slope) - 1.0;
  }
  template <class S>
  static S strain_rate(const Axis<S>& a) {
    return dot(a.slope, a.slope_rate) / norm(a.slope);
  }
  template <class S>
  static S curvature(const Axis<S>& a) {
    return planar_cross(a.slope, a.bend) / dot(a.slope, a.slope);
  }
  template <class S>
  static S curvature_rate(const Axis<S>& a) {
    const S numerator = planar_cross(a.slope_rate, a.bend) + planar_cross(a.slope, a.bend_rate);
    return (numerator - 2.0 * curvature(a) * dot(a.slope, a.slope_rate)) / dot(a.slope, a.slope);
  }

  template <class S>
  static S axial_force(const Parameters& p, const Context& c, const Sample& at, const StressFree& free,
                       const Axis<S>& a, const S& strain) {
    if constexpr (OneNumber<S>)
      if (p.axialForceUserFunction)
        return call_scalar(p.axialForceUserFunction, c, S(at.position), strain, strain_rate(a), free.strain,
                         p.physicsAxialStiffness, p.physicsAxialDamping, curvature(a), curvature_rate(a),
                         free.curvature);
    const S force = p.physicsAxialStiffness * (strain - free.strain);
    return p.physicsAxialDamping == 0 ? force : force + p.physicsAxialDamping * strain_rate(a);
  }
  template <class S>
  static S bending_moment(const Parameters& p, const Context& c, const Sample& at, const StressFree& free,
                          const Axis<S>& a, const S& curvature) {
    if constexpr (OneNumber<S>)
      if (p.bendingMomentUserFunction)
        return call_scalar(p.bendingMomentUserFunction, c, S(at.position), curvature, curvature_rate(a), free.curvature,
                         p.physicsBendingStiffness, p.physicsBendingDamping, strain(a), strain_rate(a), free.strain);
    const S moment = p.physicsBendingStiffness * (curvature - free.curvature);
    return p.physicsBendingDamping == 0 ? moment : moment + p.physicsBendingDamping * curvature_rate(a);
  }

  // Axial force along the tangent.
  template <class S>
  static Vec<S, 2> stretching(const Parameters& p, const Context& c, const Sample& at, const StressFree& free,
                              const Axis<S>& a) {
    const S length = norm(a.slope);
    return (axial_force(p, c, at, free, a, S(length - 1.0)) / length) * a.slope;
  }
  // Bending moment times the derivatives of the curvature by r' and r''.
  template <class S>
  static Conjugates<S> bending(const Parameters& p, const Context& c, const Sample& at, const StressFree& free,
                               const Axis<S>& a) {
    const S scale = 1.0 / dot(a.slope, a.slope), curvature = scale * planar_cross(a.slope, a.bend);
    const S moment = scale * bending_moment(p, c, at, free, a, curvature), twice = 2.0 * curvature;
    return {{moment * (a.bend[1] - twice * a.slope[0]), -moment * (a.bend[0] + twice * a.slope[1])},
            {-moment * a.slope[1], moment * a.slope[0]}};
  }

  // Directions r'_x, r'_y, r''_x, r''_y, the first D of them; rates move along with their coordinates.
  template <int D, class T>
  static Axis<Dual<D, T>> directed(const Axis<T>& a, const Weights& w) {
    using Moving = Dual<D, T>;
    Axis<Moving> s;
    for (int d = 0; d < 2; ++d) {
      s.slope[d] = Moving::seed(a.slope[d], d, w.q);
      s.slope_rate[d] = Moving::seed(a.slope_rate[d], d, w.v);
      s.bend[d] = D > 2 ? Moving::seed(a.bend[d], (2 + d) % D, w.q) : Moving(a.bend[d]);
      s.bend_rate[d] = D > 2 ? Moving::seed(a.bend_rate[d], (2 + d) % D, w.v) : Moving(a.bend_rate[d]);
    }
    return s;
  }
  // The change of a force with the vector that has the factors `by_slope` in r' and `by_bend` in r''.
  template <int D, class T>
  static Mat<T, 2, 2> along(const Vec<Dual<D, T>, 2>& force, double by_slope, double by_bend) {
    Mat<T, 2, 2> m;
    for (int d = 0; d < 2; ++d)
      for (int e = 0; e < 2; ++e) {
        m(d, e) = by_slope * force[d].d[e];
        if constexpr (D > 2) m(d, e) += by_bend * force[d].d[2 + e];
      }
    return m;
  }
  template <class T>
  static void add(Mat<T, 2, 2>& block, double factor, const Mat<T, 2, 2>& change) {
    for (int i = 0; i < 4; ++i) block.x[i] += factor * change.x[i];
  }
  template <int D, class T>
  static void add_stretching(const Parameters& p, const Prepared& k, const Context& c, const Shape<T>& shape, const Shape<T>& rate,
                             const Weights& w, Blocks<T>& blocks) {
    for (int s = 0; s < k.rule->stretching_points; ++s) {
      const Sample& at = k.rule->stretching[s];
      const auto n = stretching(p, c, at, k.stretching[s], directed<D>(axis(shape, rate, at, k.length), w));
      for (int j = 0; j < 3; ++j) {
        const Mat<T, 2, 2> change = along(n, at.weight * k.length * at.slope[j], at.weight * at.bend[j]);
        for (int i = 0; i < 3; ++i) add(blocks[i][j], at.slope[i], change);
      }
    }
  }
  template <class T>
  static void add_bending(const Parameters& p, const Prepared& k, const Context& c, const Shape<T>& shape, const Shape<T>& rate,
                          const Weights& w, Blocks<T>& blocks) {
    for (int s = 0; s < k.rule->bending_points; ++s) {
      const Sample& at = k.rule->bending[s];
      const auto m = bending(p, c, at, k.bending[s], directed<4>(axis(shape, rate, at, k.length), w));
      for (int j = 0; j < 3; ++j) {
        const double by_slope = at.weight * at.slope[j], by_bend = at.weight / k.length * at.bend[j];
        const Mat<T, 2, 2> slope = along(m.slope, k.length * by_slope, k.length * by_bend),
                                bend = along(m.bend, by_slope, by_bend);
        for (int i = 0; i < 3; ++i) {
          add(blocks[i][j], at.slope[i], slope);
          add(blocks[i][j], at.bend[i], bend);
        }
      }
    }
  }

  static StressFree stress_free(const Parameters& p, const Sample& at, const Vec<double, size>& reference) {
    StressFree free{p.physicsReferenceAxialStrain, p.physicsReferenceCurvature};
    if (p.strainIsRelativeToReference == 0) return free;
    const Axis<double> a =
        axis(Shape<double>(reference, p.physicsLength), Shape<double>({}, p.physicsLength), at, p.physicsLength);
    free.strain += p.strainIsRelativeToReference * strain(a);
    free.curvature += p.strainIsRelativeToReference * curvature(a);
    return free;
  }

  // Integrals of products of shape functions.
  static Mat<double, 4, 4> mass_matrix(double mass, double length) {
    const double l = length, l2 = length * length;
    Mat<double, 4, 4> m{156, 22 * l, 54,  -13 * l, 22 * l,  4 * l2,  13 * l,  -3 * l2,
                        54,  13 * l, 156, -22 * l, -13 * l, -3 * l2, -22 * l, 4 * l2};
    for (double& entry : m.x) entry *= mass / 420;
    return m;
  }

  // Shape functions of r0, r0', r1, r1' and their derivatives along the axis.
  static std::array<double, 4> values(double xi, double length) {
    const double rest = 1 - xi;
    return {rest * rest * (1 + 2 * xi), length * xi * rest * rest, xi * xi * (3 - 2 * xi), -length * xi * xi * rest};
  }
  static std::array<double, 4> derivatives(double xi, double length) {
    const auto h = Rule::sample(xi, 0).slope;
    return {-h[0] / length, h[1], h[0] / length, h[2]};
  }
  template <class S>
  static Vec<S, 2> combine(const std::array<double, 4>& shape, const Vec<S, size>& q) {
    Vec<S, 2> r;
    for (int i = 0; i < 4; ++i)
      for (int d = 0; d < 2; ++d) r[d] += shape[i] * q[2 * i + d];
    return r;
  }
};

}  // namespace dalembert
