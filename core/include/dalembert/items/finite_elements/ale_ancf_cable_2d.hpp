// ObjectALEANCFCable2D, specs/finite_elements/ale_ancf_cable_2d.toml
#pragma once

#include "dalembert/batches/strain_element.hpp"
#include "dalembert/finite_elements/ale_ancf_cable_2d_parameters.hpp"
#include "dalembert/items/finite_elements/ancf_cable_2d.hpp"

namespace dalembert {

// A planar cable whose material moves along the axis by the last coordinate.
struct ObjectALEANCFCable2D : NoDoubt, NoLieRotations {
  using Parameters = ObjectALEANCFCable2DParameters;
  using Cable = ObjectANCFCable2D;
  using Axis = AncfCableAxis<2>;
  static constexpr std::array<std::string_view, 3> node_items{"NodePoint2DSlope1", "NodePoint2DSlope1",
                                                              "NodeGenericODE2"};
  static constexpr int size = 9, way = 8;
  static constexpr ElementTraits traits{};

  static void check(const Parameters& p, const ItemLabel& item) {
    Axis::check(p, item);
    if (p.physicsMovingMassFactor > 1)
      refuse(ErrorKind::value, {item, "physicsMovingMassFactor", "", std::to_string(p.physicsMovingMassFactor),
                                "0 to 1, a share of the mass", ""});
  }

  // Products of r0, r0', r1, r1' in one direction.
  using Products = std::array<std::array<double, 4>, 4>;
  struct Prepared {
    Axis::Constants cable;
    double moving_mass = 0;  // mass of the whole element
    // Times the moving mass per length: integrals of r times r' and of r' times r'; products of these at the end minus those at the begin.
    Products value_slope{}, slope_slope{}, end_value_slope{}, end_slope_slope{};
    std::array<Vec<double, 1>, QuadratureRule::most> free_stretch{}, free_bend{};
    bool operator==(const Prepared&) const = default;
  };
  static Prepared prepare(const Parameters& p, const Vec<double, size>& reference) {
    Prepared k{.cable = Axis::constants(p)};
    const double length = p.physicsLength, mass = p.physicsMassPerLength * p.physicsMovingMassFactor;
    k.moving_mass = mass * length;
    const auto add = [](Products& to, double weight, const std::array<double, 4>& a, const std::array<double, 4>& b) {
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) to[i][j] += weight * a[i] * b[j];
    };
    for (int i = 0; i < gauss_4.count; ++i) {
      const auto value = hermite::values(gauss_4.position[i], length),
                 slope = hermite::slopes(gauss_4.position[i], length);
      add(k.value_slope, mass * length * gauss_4.weight[i], value, slope);
      add(k.slope_slope, mass * length * gauss_4.weight[i], slope, slope);
    }
    for (const int end : {0, 1}) {
      const auto value = hermite::values(end, length), slope = hermite::slopes(end, length);
      add(k.end_value_slope, end == 1 ? mass : -mass, value, slope);
      add(k.end_slope_slope, end == 1 ? mass : -mass, slope, slope);
    }
    const auto y = Axis::Map::local(k.cable, cable_of(Coordinates<double, size>{.q = reference, .v = {}, .a = {}}));
    free_strains<Axis::Stretching>(p, k.cable, y, k.free_stretch);
    free_strains<Cable::Bending>(p, k.cable, y, k.free_bend);
    return k;
  }

  template <class S>
  static Vec<S, size> residual(const Parameters& p, const Prepared& k, const Context&, const Coordinates<S, size>& x) {
    const Coordinates<S, 8> cable = cable_of(x);
    Elastic<S> elastic;
    add_elastic<Axis::Stretching>(p, k, k.free_stretch, x, elastic);
    add_elastic<Cable::Bending>(p, k, k.free_bend, x, elastic);
    Vec<S, 8> r = Axis::Map::pull_back(k.cable, cable, elastic.forces);
    r += Axis::inertia(k.cable, cable);
    S along = elastic.along;
    add_convection(p, k, x, r, along);
    return joined(r, Vec<S, 1>{along});
  }

  static bool strain_energy(const Parameters&, const Prepared& k, const Vec<double, size>& q, double& energy) {
    const auto y = Axis::Map::local(k.cable, cable_of(Coordinates<double, size>{.q = q, .v = {}, .a = {}}));
    energy = 0;
    const auto add = [&]<class F>(const auto& free) {
      const auto& points = F::points(k.cable);
      for (int i = 0; i < points.count; ++i) {
        const double strain = F::strain(k.cable, interpolated<F>(points.at[i].shape, y))[0] - free[i][0];
        energy += 0.5 * points.at[i].weight * k.cable.length * F::stiffness(k.cable) * strain * strain;
      }
    };
    add.template operator()<Axis::Stretching>(k.free_stretch);
    add.template operator()<Cable::Bending>(k.free_bend);
    return true;
  }

  // Motion of the axis, which does not move with the material.
  template <class S>
  static Motion<S> motion(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local) {
    return Cable::section(p.physicsLength, cable_of(x), local);
  }
  template <class S>
  static Vec<S, size> pull_back(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local,
                                const Vec3<S>& force, const Vec3<S>& moment) {
    return joined(Cable::on_section(p.physicsLength, cable_of(x), local, force, moment), Vec<S, 1>{S(0)});
  }
  // Weight also pulls the material along, from one end to the other.
  template <class S>
  static Vec<S, size> mass_load(const Parameters& p, const Coordinates<S, size>& x, const Vec3<S>& g) {
    const double moving = p.physicsMassPerLength * p.physicsMovingMassFactor;
    const S along = moving * ((x.q[4] - x.q[0]) * g[0] + (x.q[5] - x.q[1]) * g[1]);
    return joined(Axis::mass_load(p, cable_of(x), g), Vec<S, 1>{along});
  }

  static bool output(const Parameters& p, const Context&, const Coordinates<double, size>& x,
                     const OutputRequest& request, std::vector<double>& values) {
    const Section at{p, x, request};
    switch (request.variable) {
      case OutputVariableType::Velocity:
      case OutputVariableType::VelocityLocal: {
        // The material: that of the section, and its way along the line at this distance from the axis.
        const Motion<double> m = motion(p, x, request.local);
        const Vec<double, 2> slope = at.template fields<0>()[0];
        const double stretch = x.v[way] * (1 - request.local[1] * at.template strain<1>()[0] / norm(slope));
        const Vec3<double> velocity = m.velocity + stretch * Vec3<double>{slope[0], slope[1], 0};
        const Vec3<double> shown =
            request.variable == OutputVariableType::Velocity ? velocity : transposed_times(m.rotation, velocity);
        values.assign(shown.x.begin(), shown.x.end());
        return true;
      }
      default: return Cable::output(at, values);
    }
  }

 private:
  template <class S>
  static Coordinates<S, 8> cable_of(const Coordinates<S, size>& x) {
    return {segment<8>(x.q, 0), segment<8>(x.v, 0), segment<8>(x.a, 0)};
  }
  template <class F, class Free>
  static void free_strains(const Parameters& p, const Axis::Constants& k, const Vectors<double, 2, 3>& y, Free& free) {
    for (int i = 0; i < F::points(k).count; ++i)
      free[i] = F::stress_free(p, F::strain(k, interpolated<F>(F::points(k).at[i].shape, y)));
  }

  // Strains, seen from the material: when it moves on, fields at a point change by their derivatives along the axis.
  template <class F, class S>
  struct Point {
    Vectors<S, 2, F::fields> fields, along, rates;

    Point(const Parameters& p, const Axis::Constants& k, const Axis::Shape& shape, const Coordinates<S, size>& x) {
      static constexpr std::array<double, 3> third{-12, 6, 6};  // derivative of hermite::bend
      const auto y = Axis::Map::local(k, cable_of(x)), y_t = Axis::Map::local_rate(k, cable_of(x));
      fields = interpolated<F>(shape, y);
      rates = interpolated<F>(shape, y_t);
      for (int f = 0; f < F::fields; ++f) {
        const auto& of = f == 0 ? shape[1] : third;
        along[f] = (1 / k.length) * (of[0] * y[0] + of[1] * y[1] + of[2] * y[2]);
        if (p.physicsMovingMassFactor == 1) rates[f] += x.v[way] * along[f];  // else a resting part is damped
      }
    }
  };
  template <class F, class S>
  static Vec<S, 1> stress(const Axis::Constants& k, const Point<F, S>& at, const Vec<double, 1>& free) {
    Vec<S, 1> stress = F::stiffness(k) * (F::strain(k, at.fields) - free);
    if (F::damping(k) != 0) stress += F::damping(k) * strain_rate<F>(k, at.fields, at.rates);
    return stress;
  }
  // Forces on the local vectors of the cable, and on the displacement of the material.
  template <class S>
  struct Elastic {
    Vectors<S, 2, 3> forces{};
    S along{0.0};
  };
  template <class F, class Free, class S>
  static void add_elastic(const Parameters& p, const Prepared& k, const Free& free, const Coordinates<S, size>& x,
                          Elastic<S>& sum) {
    const auto& points = F::points(k.cable);
    for (int i = 0; i < points.count; ++i) {
      const auto& shape = points.at[i].shape;
      const Point<F, S> at(p, k.cable, shape, x);
      const auto force =
          F::pull_back(k.cable, at.fields, (points.at[i].weight * k.cable.length) * stress<F>(k.cable, at, free[i]));
      for (int f = 0; f < F::fields; ++f) {
        for (int v = 0; v < 3; ++v) sum.forces[v] += shape[f][v] * force[f];
        if (p.physicsAddALEvariation) sum.along += dot(force[f], at.along[f]);
      }
    }
  }

  // The other terms of the acceleration r_tt + 2 r'_t s_t + r'' s_t^2 + r' s_tt of the material, and all of it along the axis.
  template <class S>
  static void add_convection(const Parameters& p, const Prepared& k, const Coordinates<S, size>& x, Vec<S, 8>& r,
                             S& along) {
    const S &speed = x.v[way], square = speed * speed;
    const bool couples =
        p.physicsUseCouplingTerms;  // accelerations of cable and material; else that of the material has a mass of its own
    if (!couples) along += k.moving_mass * x.a[way];
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        for (int d = 0; d < 2; ++d) {
          const S &qi = x.q[2 * i + d], &qj = x.q[2 * j + d], &vj = x.v[2 * j + d];
          r[2 * i + d] += k.value_slope[i][j] * (2.0 * speed * vj) +
                          (k.end_value_slope[i][j] - k.slope_slope[i][j]) * (square * qj);
          along += k.slope_slope[i][j] * (2.0 * speed * qi * vj) + (0.5 * k.end_slope_slope[i][j]) * (square * qi * qj);
          if (!couples) continue;
          r[2 * i + d] += k.value_slope[i][j] * (x.a[way] * qj);
          along += k.value_slope[i][j] * (x.a[2 * i + d] * qj) + k.slope_slope[i][j] * (x.a[way] * qi * qj);
        }
  }

  // Data for outputs of the cable.
  struct Section {
    const Parameters& p;
    const Coordinates<double, size>& x;
    const OutputRequest& request;
    Axis::Constants k = Axis::constants(p);

    template <int family>
    using Family = std::conditional_t<family == 0, Axis::Stretching, Cable::Bending>;
    template <int family>
    Point<Family<family>, double> point() const {
      return {p, k, Axis::hermite_shape(Axis::along(k, request.local)), x};
    }
    template <int family>
    Vectors<double, 2, Family<family>::fields> fields() const {
      return point<family>().fields;
    }
    template <int family>
    Vec<double, 1> strain() const {
      return Family<family>::strain(k, fields<family>());
    }
    template <int family>
    Vec<double, 1> stress() const {
      using F = Family<family>;
      const Coordinates<double, size> reference{.q = load<double, size>(request.reference.data()), .v = {}, .a = {}};
      const auto of_reference =
          F::strain(k, Point<F, double>(p, k, Axis::hermite_shape(Axis::along(k, request.local)), reference).fields);
      return ObjectALEANCFCable2D::stress<F>(k, point<family>(), F::stress_free(p, of_reference));
    }
  };
};

}  // namespace dalembert
