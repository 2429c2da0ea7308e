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
  static constexpr int size = 8, node_size = 4;
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
      const Axis<S> a = axis(shape, rate, at, k.length);
      const Vec<S, 2> n = (at.weight * k.length * axial_force(p, c, at, k.stretching[i], a)) * strain_gradient(a).slope;
      for (int j = 0; j < 3; ++j) work[j] += at.slope[j] * n;
    }
    for (int i = 0; i < k.rule->bending_points; ++i) {
      const Sample& at = k.rule->bending[i];
      const Axis<S> a = axis(shape, rate, at, k.length);
      const S moment = at.weight * bending_moment(p, c, at, k.bending[i], a);
      const Gradient<S> g = curvature_gradient(a);
      const Vec<S, 2> by_slope = (k.length * moment) * g.slope, by_bend = moment * g.bend;
      for (int j = 0; j < 3; ++j) work[j] += at.slope[j] * by_slope + at.bend[j] * by_bend;
    }
    return vector_of<size>([&](int row) {
      const int i = row / 2, d = row % 2;
      S sum = share(i, k.length) * work[part(i)][d];
      for (int j = 0; j < 4; ++j) sum += k.mass(i, j) * x.a[2 * j + d];
      return sum;
    });
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
    return matrix_of<size, size>([&](int row, int column) {
      const int i = row / 2, j = column / 2, d = row % 2, e = column % 2;
      const T entry = share(i, k.length) * share(j, k.length) * blocks[part(i)][part(j)](d, e);
      return d == e ? T(entry + w.a * k.mass(i, j)) : entry;
    });
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
      case OutputVariableType::ForceLocal: values = {axial_force(p, c, at, free(), a)}; return true;
      case OutputVariableType::TorqueLocal: values = {bending_moment(p, c, at, free(), a)}; return true;
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
    using Scalar = S;
    Vec<S, 2> slope, bend, slope_rate, bend_rate;
  };
  // The derivatives of a number by r' and r''.
  template <class S>
  struct Gradient {
    Vec<S, 2> slope{}, bend{};
  };
  // An axis that moves along r'_x, r'_y, r''_x, r''_y, the first D of them; rates move along with their coordinates.
  template <int D, class T>
  struct MovingAxis {
    using Scalar = Dual<D, T>;
    const Axis<T>& at;
    const Weights& weights;
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
  static Gradient<S> strain_gradient(const Axis<S>& a) {
    return {.slope = (1.0 / norm(a.slope)) * a.slope};
  }
  template <class S>
  static S strain_rate(const Axis<S>& a) {
    return dot(strain_gradient(a).slope, a.slope_rate);
  }
  template <class S>
  static Gradient<S> strain_rate_gradient(const Axis<S>& a) {
    return {.slope = (1.0 / norm(a.slope)) * (a.slope_rate - strain_rate(a) * strain_gradient(a).slope)};
  }
  template <class S>
  static S curvature(const Axis<S>& a) {
    return (1.0 / dot(a.slope, a.slope)) * planar_cross(a.slope, a.bend);
  }
  template <class S>
  static Gradient<S> curvature_gradient(const Axis<S>& a) {
    const S scale = 1.0 / dot(a.slope, a.slope), twice = 2.0 * curvature(a);
    return {{scale * (a.bend[1] - twice * a.slope[0]), -scale * (a.bend[0] + twice * a.slope[1])},
            {-scale * a.slope[1], scale * a.slope[0]}};
  }
  template <class S>
  static S curvature_rate(const Axis<S>& a) {
    const Gradient<S> g = curvature_gradient(a);
    return dot(g.slope, a.slope_rate) + dot(g.bend, a.bend_rate);
  }
  template <class S>
  static Gradient<S> curvature_rate_gradient(const Axis<S>& a) {
    const Gradient<S> g = curvature_gradient(a);
    const S scale = 1.0 / dot(a.slope, a.slope), twice = 2.0 * scale, swelling = dot(a.slope, a.slope_rate);
    const Vec<S, 2> turned = swelling * g.slope + curvature_rate(a) * a.slope + curvature(a) * a.slope_rate;
    return {scale * Vec<S, 2>{a.bend_rate[1], -a.bend_rate[0]} - twice * turned,
            scale * Vec<S, 2>{-a.slope_rate[1], a.slope_rate[0]} - (twice * swelling) * g.bend};
  }

  template <int D, class T>
  static Dual<D, T> moving(const T& value, double by_first, const Gradient<T>& first, double by_second = 0, const Gradient<T>& second = {}) {
    Dual<D, T> s(value);
    for (int d = 0; d < D; ++d)
      s.d[d] = d < 2 ? by_first * first.slope[d] + by_second * second.slope[d] : by_first * first.bend[d - 2] + by_second * second.bend[d - 2];
    return s;
  }
  template <int D, class T>
  static Dual<D, T> strain(const MovingAxis<D, T>& a) {
    return moving<D>(strain(a.at), a.weights.q, strain_gradient(a.at));
  }
  template <int D, class T>
  static Dual<D, T> strain_rate(const MovingAxis<D, T>& a) {
    return moving<D>(strain_rate(a.at), a.weights.q, strain_rate_gradient(a.at), a.weights.v, strain_gradient(a.at));
  }
  template <int D, class T>
  static Dual<D, T> curvature(const MovingAxis<D, T>& a) {
    return moving<D>(curvature(a.at), a.weights.q, curvature_gradient(a.at));
  }
  template <int D, class T>
  static Dual<D, T> curvature_rate(const MovingAxis<D, T>& a) {
    return moving<D>(curvature_rate(a.at), a.weights.q, curvature_rate_gradient(a.at), a.weights.v, curvature_gradient(a.at));
  }

  // `A` is an axis that rests or moves.
  template <class A>
  static typename A::Scalar axial_force(const Parameters& p, const Context& c, const Sample& at, const StressFree& free, const A& a) {
    using S = typename A::Scalar;
    if constexpr (OneNumber<S>)
      if (p.axialForceUserFunction)
        return call_scalar(p.axialForceUserFunction, c, S(at.position), strain(a), strain_rate(a), free.strain,
                           p.physicsAxialStiffness, p.physicsAxialDamping, curvature(a), curvature_rate(a), free.curvature);
    const S force = p.physicsAxialStiffness * (strain(a) - free.strain);
    return p.physicsAxialDamping == 0 ? force : S(force + p.physicsAxialDamping * strain_rate(a));
  }
  template <class A>
  static typename A::Scalar bending_moment(const Parameters& p, const Context& c, const Sample& at, const StressFree& free, const A& a) {
    using S = typename A::Scalar;
    if constexpr (OneNumber<S>)
      if (p.bendingMomentUserFunction)
        return call_scalar(p.bendingMomentUserFunction, c, S(at.position), curvature(a), curvature_rate(a), free.curvature,
                           p.physicsBendingStiffness, p.physicsBendingDamping, strain(a), strain_rate(a), free.strain);
    const S moment = p.physicsBendingStiffness * (curvature(a) - free.curvature);
    return p.physicsBendingDamping == 0 ? moment : S(moment + p.physicsBendingDamping * curvature_rate(a));
  }

  template <class T>
  static Mat<T, 2, 2> outer(const Vec<T, 2>& a, const T& b0, const T& b1) {
    return {a[0] * b0, a[0] * b1, a[1] * b0, a[1] * b1};
  }
  template <class T>
  static void add(Mat<T, 2, 2>& block, double factor, const Mat<T, 2, 2>& change) {
    for (int i = 0; i < 4; ++i) block.x[i] += factor * change.x[i];
  }
  // The axial force acts along the tangent, which turns.
  template <int D, class T>
  static void add_stretching(const Parameters& p, const Prepared& k, const Context& c, const Shape<T>& shape, const Shape<T>& rate,
                             const Weights& w, Blocks<T>& blocks) {
    for (int s = 0; s < k.rule->stretching_points; ++s) {
      const Sample& at = k.rule->stretching[s];
      const Axis<T> a = axis(shape, rate, at, k.length);
      const Dual<D, T> n = axial_force(p, c, at, k.stretching[s], MovingAxis<D, T>{a, w});
      const Vec<T, 2> tangent = strain_gradient(a).slope;
      const T turn = w.q * n.value * (1.0 / norm(a.slope));
      Mat<T, 2, 2> by_slope = outer(tangent, n.d[0] - turn * tangent[0], n.d[1] - turn * tangent[1]);
      by_slope(0, 0) += turn;
      by_slope(1, 1) += turn;
      for (int j = 0; j < 3; ++j) {
        Mat<T, 2, 2> change{};
        add(change, at.weight * k.length * at.slope[j], by_slope);
        if constexpr (D > 2) add(change, at.weight * at.bend[j], outer(tangent, n.d[2], n.d[3]));
        for (int i = 0; i < 3; ++i) add(blocks[i][j], at.slope[i], change);
      }
    }
  }
  // The bending moment acts along the gradient of the curvature, whose derivative is symmetric.
  template <class T>
  static void add_bending(const Parameters& p, const Prepared& k, const Context& c, const Shape<T>& shape, const Shape<T>& rate,
                          const Weights& w, Blocks<T>& blocks) {
    for (int s = 0; s < k.rule->bending_points; ++s) {
      const Sample& at = k.rule->bending[s];
      const Axis<T> a = axis(shape, rate, at, k.length);
      const Dual<4, T> m = bending_moment(p, c, at, k.bending[s], MovingAxis<4, T>{a, w});
      const Gradient<T> g = curvature_gradient(a);
      const T turn = w.q * m.value * (1.0 / dot(a.slope, a.slope)), swell = 2.0 * turn * curvature(a);
      const Vec<T, 2> drift = (2.0 * turn) * a.slope;
      const T m0 = m.d[0] - drift[0], m1 = m.d[1] - drift[1];
      Mat<T, 2, 2> slope_by_slope = outer(g.slope, m0, m1) - outer(drift, g.slope[0], g.slope[1]);
      slope_by_slope(0, 0) -= swell;
      slope_by_slope(1, 1) -= swell;
      Mat<T, 2, 2> slope_by_bend = outer(g.slope, m.d[2], m.d[3]) - outer(drift, g.bend[0], g.bend[1]);
      Mat<T, 2, 2> bend_by_slope = outer(g.bend, m0, m1);
      slope_by_bend(0, 1) += turn;
      slope_by_bend(1, 0) -= turn;
      bend_by_slope(1, 0) += turn;
      bend_by_slope(0, 1) -= turn;
      const Mat<T, 2, 2> bend_by_bend = outer(g.bend, m.d[2], m.d[3]);
      for (int j = 0; j < 3; ++j) {
        const double by_slope = at.weight * at.slope[j], by_bend = at.weight / k.length * at.bend[j];
        Mat<T, 2, 2> slope{}, bend{};
        add(slope, k.length * by_slope, slope_by_slope);
        add(slope, k.length * by_bend, slope_by_bend);
        add(bend, by_slope, bend_by_slope);
        add(bend, by_bend, bend_by_bend);
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
