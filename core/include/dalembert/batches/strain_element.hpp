// Sums of residual and tangent of elements with quadrature (contracts/strain_points.hpp): makes an assembled element
// from the definitions of its kernel.
#pragma once

#include <algorithm>
#include <utility>

#include "dalembert/contracts/strain_points.hpp"
#include "dalembert/math/dual.hpp"
#include "dalembert/math/pack.hpp"

namespace dalembert {

// ---- one point --------------------------------------------------------------------------------------------------------
template <class F, class Shape, class S, int D, std::size_t V>
Vectors<S, D, F::fields> interpolated(const Shape& shape, const std::array<Vec<S, D>, V>& local) {
  Vectors<S, D, F::fields> fields{};
  for (int f = 0; f < F::fields; ++f)
    for (int v = 0; v < static_cast<int>(V); ++v)
      if (F::uses(f, v)) fields[f] += shape[f][v] * local[v];
  return fields;
}

// The rate of the strains is their derivative along the rates of the fields: elements need not state it.
template <class F, class K, class S, int D, std::size_t N>
Vec<S, F::strains> strain_rate(const K& k, const std::array<Vec<S, D>, N>& fields,
                               const std::array<Vec<S, D>, N>& rates) {
  std::array<Vec<Dual<1, S>, D>, N> moving;
  for (std::size_t f = 0; f < N; ++f)
    for (int d = 0; d < D; ++d) {
      moving[f][d].value = fields[f][d];
      moving[f][d].d[0] = rates[f][d];
    }
  const auto strain = F::strain(k, moving);
  return vector_of<F::strains>([&](int i) { return strain[i].d[0]; });
}

// Numbers of which those from `begin` on, as many as there are directions, have a direction of their own.
template <int directions, class T, int D, std::size_t N>
auto moving_from(int begin, const std::array<Vec<T, D>, N>& a, double weight) {
  std::array<Vec<Dual<directions, T>, D>, N> s;
  for (int n = 0; n < static_cast<int>(N); ++n)
    for (int d = 0; d < D; ++d) {
      s[n][d] = Dual<directions, T>(a[n][d]);
      if (const int i = n * D + d - begin; i >= 0 && i < directions) s[n][d].d[i] = T(weight);
    }
  return s;
}

// ---- all points of an element --------------------------------------------------------------------------------------------
template <class E>
struct StrainElement {
  static_assert(StrainKernel<E>, "see core/include/dalembert/contracts/strain_points.hpp");
  using Parameters = typename E::Parameters;
  using Constants = typename E::Constants;
  using Map = typename E::Map;
  static constexpr int size = Map::size, node_size = E::node_size, dimension = Map::dimension,
                       numbers = dimension * Map::vectors;
  static constexpr ElementTraits traits{.constant_mass = E::constant_mass,
                                        .constant_jacobian = E::constant_jacobian,
                                        .oriented = E::oriented,
                                        .tangent = Map::derives};
  static constexpr auto lie_rotations = Map::lie_rotations;
  template <class S>
  using Local = Vectors<S, dimension, Map::vectors>;
  template <class S>
  using LocalMatrix = Mat<S, numbers, numbers>;

  // Strains without stress at the points of each family.
  template <class Families>
  struct FreeStrainsOf;
  template <class... F>
  struct FreeStrainsOf<std::tuple<F...>> {
    template <class One>
    static constexpr std::size_t most =
        std::tuple_size_v<std::remove_cvref_t<decltype(One::points(std::declval<const Constants&>()).at)>>;
    using Type = std::tuple<std::array<Vec<double, F::strains>, most<F>>...>;
  };
  struct Prepared {
    Constants constants;
    typename FreeStrainsOf<typename E::Families>::Type free;
    typename FreeStrainsOf<typename E::CallingFamilies>::Type free_where_called;
    bool operator==(const Prepared&) const = default;
  };

  static Prepared prepare(const Parameters& p, const Vec<double, size>& reference) {
    Prepared k{.constants = E::constants(p), .free = {}, .free_where_called = {}};
    const Local<double> y = Map::local(k.constants, Coordinates<double, size>{.q = reference, .v = {}, .a = {}});
    const auto fill = [&]<class F>(auto& free) {
      for (int i = 0; i < F::points(k.constants).count; ++i)
        free[i] = stress_free<F>(p, k.constants, F::points(k.constants).at[i].shape, y);
    };
    each_of<typename E::Families>(k.free, fill);
    each_of<typename E::CallingFamilies>(k.free_where_called, fill);
    return k;
  }

  // User functions are called for one element at a time. Elements with more local vectors than a beam are also
  // computed one at a time, because their tangents would take minutes to compile. Eight lanes save 9 % of the time of
  // planar cables, and nothing for beams in space.
  static constexpr int most_lanes = numbers <= 8 ? 8 : 4;
  static bool same_law(const Parameters& p, const Prepared& k, const Parameters& other_p, const Prepared& other)
    requires(Map::linear && numbers <= 15)
  {
    return !E::calls(p) && !E::calls(other_p) && k == other;
  }

  // Inertia forces and the sum of w B' stress over all points.
  template <class S>
  static Vec<S, size> residual(const Parameters& p, const Prepared& k, const Context& c,
                               const Coordinates<S, size>& x) {
    const Local<S> y = Map::local(k.constants, x);
    Local<S> forces{};
    damped_or_not<S>(p, k, [&]<bool damped>() {
      Local<S> rate{};
      if constexpr (damped) rate = Map::local_rate(k.constants, x);
      each_family<S>(
          p, k, [&]<class F>(const auto& free) { add_forces<F, damped>(p, k.constants, c, free, y, rate, forces); });
    });
    Vec<S, size> r = Map::pull_back(k.constants, x, forces);
    r += E::inertia(k.constants, x);
    return r;
  }

  // The sum of w (B' C B + geometric part): one sweep of dual numbers through strain, law and pull-back at each
  // point.
  template <class T>
  static Mat<T, size, size> tangent(const Parameters& p, const Prepared& k, const Context& c,
                                    const Coordinates<T, size>& x, const Weights& w)
    requires Map::derives
  {
    Mat<T, size, size> r = tangent_of_stresses(p, k, c, x, w);
    E::add_inertia_tangent(k.constants, x, w, r);
    return r;
  }

  // Energy of the strains, sum of w strain' C strain / 2; false: user functions state no energy.
  static bool strain_energy(const Parameters& p, const Prepared& k, const Vec<double, size>& q, double& energy) {
    if (E::calls(p)) return false;
    const Local<double> y = Map::local(k.constants, Coordinates<double, size>{.q = q, .v = {}, .a = {}});
    energy = 0;
    each_of<typename E::Families>(k.free, [&]<class F>(const auto& free) {
      for (int i = 0; i < F::points(k.constants).count; ++i) {
        const auto& point = F::points(k.constants).at[i];
        const Vec<double, F::strains> strain = F::strain(k.constants, interpolated<F>(point.shape, y)) - free[i];
        energy += 0.5 * point.weight * k.constants.length *
                  dot(strain, stiffness_at<F>(k.constants, point.position) * strain);
      }
    });
    return true;
  }

  template <class S>
  static Motion<S> motion(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local) {
    return E::motion(p, x, local);
  }
  template <class S>
  static Vec<S, size> pull_back(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local,
                                const Vec3<S>& force, const Vec3<S>& moment) {
    return E::pull_back(p, x, local, force, moment);
  }
  template <class S>
  static Vec<S, size> mass_load(const Parameters& p, const Coordinates<S, size>& x, const Vec3<S>& g) {
    return E::mass_load(p, x, g);
  }

  // Fields, strains and stresses at any point, for outputs; `family` counts E::Families.
  struct Section {
    const Parameters& p;
    const Context& c;
    const Coordinates<double, size>& x;
    const OutputRequest& request;
    Constants k = E::constants(p);

    template <int family>
    auto fields() const {
      using F = std::tuple_element_t<family, typename E::Families>;
      return interpolated<F>(shape_at<F>(k, E::along(k, request.local)), Map::local(k, x));
    }
    template <int family>
    auto strain() const {
      return std::tuple_element_t<family, typename E::Families>::strain(k, fields<family>());
    }
    // The part of the strain that has a stress.
    template <int family>
    auto elastic_strain() const {
      using F = std::tuple_element_t<family, typename E::Families>;
      return strain<family>() - free_strain<F>();
    }
    template <int family>
    auto stress() const {
      return E::calls(p) ? stress_in<std::tuple_element_t<family, typename E::CallingFamilies>>()
                         : stress_in<std::tuple_element_t<family, typename E::Families>>();
    }

   private:
    template <class F>
    auto stress_in() const {
      const auto place = E::along(k, request.local);
      const auto shape = shape_at<F>(k, place);
      const auto at = interpolated<F>(shape, Map::local(k, x)), rates = interpolated<F>(shape, Map::local_rate(k, x));
      return stress_at<F, true>(p, k, c, place, free_strain<F>(), at, rates);
    }
    template <class F>
    auto free_strain() const {
      const Coordinates<double, size> reference{.q = load<double, size>(request.reference.data()), .v = {}, .a = {}};
      return stress_free<F>(p, k, shape_at<F>(k, E::along(k, request.local)), Map::local(k, reference));
    }
  };
  static bool output(const Parameters& p, const Context& c, const Coordinates<double, size>& x,
                     const OutputRequest& request, std::vector<double>& values) {
    return E::output(Section{p, c, x, request}, values);
  }

 private:
  template <class T>
  static Mat<T, size, size> tangent_of_stresses(const Parameters& p, const Prepared& k, const Context& c,
                                                const Coordinates<T, size>& x, const Weights& w) {
    if (w.q == 0 && w.v == 0) return {};
    const Local<T> y = Map::local(k.constants, x);
    Local<T> forces{};
    LocalMatrix<T> m{}, damping{};
    damped_or_not<T>(p, k, [&]<bool damped>() {
      // Stress is the derivative of an energy.
      constexpr bool symmetric = !damped && one_strain_each(static_cast<const typename E::Families*>(nullptr));
      Local<T> rate{};
      if constexpr (damped) rate = Map::local_rate(k.constants, x);
      each_family<T>(p, k, [&]<class F>(const auto& free) {
        add_tangent<F, damped, symmetric>(p, k.constants, c, free, y, rate, w, forces, m);
        if constexpr (damped && !Map::linear) {
          Local<T> ignored{};
          add_tangent<F, damped, false>(p, k.constants, c, free, y, rate, Weights{.q = 0, .v = 1, .a = 0}, ignored,
                                        damping);
        }
      });
      if constexpr (symmetric)
        for (int i = 0; i < numbers; ++i)
          for (int j = i + 1; j < numbers; ++j) m(i, j) = m(j, i);
    });
    return Map::tangent(k.constants, x, forces, m, damping, w);
  }

  // ---- families ----
  template <class... F>
  static consteval bool one_strain_each(const std::tuple<F...>*) {
    return ((F::strains == 1 && !LawFamily<F, E>) && ...);
  }
  template <class Families, class Free, class Call>
  static void each_of(Free& free, const Call& call) {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      (call.template operator()<std::tuple_element_t<i, Families>>(std::get<i>(free)), ...);
    }(std::make_index_sequence<std::tuple_size_v<Families>>{});
  }
  template <class S, class Call>
  static void each_family(const Parameters& p, const Prepared& k, const Call& call) {
    if constexpr (OneNumber<S>)
      if (E::calls(p)) return each_of<typename E::CallingFamilies>(k.free_where_called, call);
    each_of<typename E::Families>(k.free, call);
  }
  template <class S, class Call>
  static void damped_or_not(const Parameters& p, const Prepared& k, const Call& call) {
    E::damped(k.constants) || E::calls(p) ? call.template operator()<true>() : call.template operator()<false>();
  }

  template <class F, class Shape>
  static Vec<double, F::strains> stress_free(const Parameters& p, const Constants& k, const Shape& shape,
                                             const Local<double>& reference) {
    return F::stress_free(p, F::strain(k, interpolated<F>(shape, reference)));
  }

  // ---- points ----
  template <class F, bool damped, class Fields, class Free>
  static auto stress_at(const Parameters& p, const Constants& k, const Context& c, const PlaceOf<F, Constants>& place,
                        const Free& free, const Fields& at, const Fields& rates) {
    const auto strain = F::strain(k, at);
    if constexpr (LawFamily<F, E>) {
      return F::stress(p, k, c, place, strain, strain_rate<F>(k, at, rates), free);
    } else {
      auto stress = stiffness_at<F>(k, place) * (strain - free);
      if constexpr (damped) stress += damping_at<F>(k, place) * strain_rate<F>(k, at, rates);
      return stress;
    }
  }
  // Forces on the fields of a point, times its weight.
  template <class F, bool damped, class Point, class Fields, class Free>
  static Fields forces_at(const Parameters& p, const Constants& k, const Context& c, const Point& point,
                          const Free& free, const Fields& at, const Fields& rates) {
    return F::pull_back(k, at,
                        (point.weight * k.length) * stress_at<F, damped>(p, k, c, point.position, free, at, rates));
  }

  template <class F, bool damped, class Free, class S>
  static void add_forces(const Parameters& p, const Constants& k, const Context& c, const Free& free, const Local<S>& y,
                         const Local<S>& rate, Local<S>& forces) {
    const auto& points = F::points(k);
    for (int i = 0; i < points.count; ++i) {
      const auto& shape = points.at[i].shape;
      const auto force =
          forces_at<F, damped>(p, k, c, points.at[i], free[i], interpolated<F>(shape, y), interpolated<F>(shape, rate));
      for (int f = 0; f < F::fields; ++f)
        for (int v = 0; v < Map::vectors; ++v)
          if (F::uses(f, v)) forces[v] += shape[f][v] * force[f];
    }
  }

  // Lane-parallel sweeps use few directions at once: more directions exceed the registers, and take minutes to
  // compile.
  template <class T>
  static constexpr int directions_at_once(int all) {
    if (OneNumber<T> || all <= 12) return all;
    const int sweeps = (all + 5) / 6;
    return (all + sweeps - 1) / sweeps;
  }

  // Forces on the local vectors, and their derivatives with respect to these along the weights. Directions are the
  // numbers of the fields, or those of the local vectors if these are fewer. Only the lower half of a symmetric
  // matrix is computed.
  template <class F, bool damped, bool symmetric, class Free, class T>
  static void add_tangent(const Parameters& p, const Constants& k, const Context& c, const Free& free,
                          const Local<T>& y, const Local<T>& rate, const Weights& w, Local<T>& forces,
                          LocalMatrix<T>& m) {
    const auto& points = F::points(k);
    for (int i = 0; i < points.count; ++i) {
      const auto& shape = points.at[i].shape;
      const auto force_at = [&](const auto& at, const auto& rates) {
        return forces_at<F, damped>(p, k, c, points.at[i], free[i], at, rates);
      };
      if constexpr (Map::vectors <= F::fields) {
        constexpr int directions = directions_at_once<T>(numbers);
        for (int begin = 0; begin < numbers; begin += directions) {
          const auto force = force_at(interpolated<F>(shape, moving_from<directions>(begin, y, w.q)),
                                      interpolated<F>(shape, moving_from<directions>(begin, rate, w.v)));
          each_row<F>(shape, [&](int row, int f, int d, double share) {
            if (begin == 0) forces[row / dimension][d] += share * force[f][d].value;
            const int end = std::min(symmetric ? row + 1 : numbers, begin + directions);
            for (int j = begin; j < end; ++j) m(row, j) += share * force[f][d].d[j - begin];
          });
        }
      } else {
        constexpr int all = dimension * F::fields, directions = directions_at_once<T>(all);
        const auto at = interpolated<F>(shape, y), rates = interpolated<F>(shape, rate);
        Mat<T, all, all> by_field;
        for (int begin = 0; begin < all; begin += directions) {
          const auto force =
              force_at(moving_from<directions>(begin, at, w.q), moving_from<directions>(begin, rates, w.v));
          for (int row = 0; row < all; ++row)
            for (int j = begin; j < std::min(all, begin + directions); ++j)
              by_field(row, j) = force[row / dimension][row % dimension].d[j - begin];
          if (begin == 0)
            for (int v = 0; v < Map::vectors; ++v)
              for (int d = 0; d < dimension; ++d)
                forces[v][d] += sum_of_shares<F, T>(shape, v, [&](int f) { return force[f][d].value; });
        }
        // Force on field f times its share in local vector v, summed over the fields.
        const auto by_local = matrix_of<all, numbers>([&](int row, int column) {
          return sum_of_shares<F, T>(shape, column / dimension,
                                     [&](int e) { return by_field(row, dimension * e + column % dimension); });
        });
        for (int v = 0; v < Map::vectors; ++v)
          for (int d = 0; d < dimension; ++d)
            for (int j = 0; j < (symmetric ? dimension * v + d + 1 : numbers); ++j)
              m(dimension * v + d, j) +=
                  sum_of_shares<F, T>(shape, v, [&](int f) { return by_local(dimension * f + d, j); });
      }
    }
  }
  // The sum of field values times the shares of a local vector in them.
  template <class F, class T, class Shape, class Of>
  static T sum_of_shares(const Shape& shape, int vector, const Of& of) {
    T sum(0.0);
    bool first = true;
    for (int f = 0; f < F::fields; ++f)
      if (F::uses(f, vector)) {
        sum = first ? T(shape[f][vector] * of(f)) : T(sum + shape[f][vector] * of(f));
        first = false;
      }
    return sum;
  }
  // Calls f(number, field, component, share) for each number of the local vectors and each field that it has a share in.
  template <class F, class Shape, class Call>
  static void each_row(const Shape& shape, const Call& call) {
    for (int f = 0; f < F::fields; ++f)
      for (int v = 0; v < Map::vectors; ++v)
        if (F::uses(f, v))
          for (int d = 0; d < dimension; ++d) call(dimension * v + d, f, d, shape[f][v]);
  }
};

// The element that a kernel with coordinates of its own makes.
template <class E>
struct ElementOf {
  using Type = E;
};
template <class E>
  requires requires { typename E::Families; }
struct ElementOf<E> {
  using Type = StrainElement<E>;
};

}  // namespace dalembert
