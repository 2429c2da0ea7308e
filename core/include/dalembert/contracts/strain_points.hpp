// Elements with quadrature: the strain is the cut. A point of an element corresponds to a marker of a body, and the law of the section to a connector.
//
//   coordinates --Map--> local vectors --shape numbers--> fields at a point --strain--> law --pull_back--> ... and back
//
//   Cable:  r0, r0', r1, r1'  ->  chord, r0', r1'  ->  r', r''  ->  axial strain, curvature  ->  force, moment
//
// An element states its map, its families of points and its inertia; a family states its points, its strains, the transpose of
// their derivative, and its law. All sums over points stand in batches/strain_element.hpp, for every element. No member is optional: a missing or misspelt member does not compile.
#pragma once

#include <concepts>
#include <span>
#include <tuple>
#include <vector>

#include "dalembert/contracts/context.hpp"
#include "dalembert/contracts/element.hpp"
#include "dalembert/math/fixed.hpp"
#include "dalembert/math/quadrature.hpp"
#include "dalembert/model/errors.hpp"

namespace dalembert {

// Check of elements whose length is undefined.
inline void check_element_length(double length, const ItemLabel& item) {
  if (!(length > 0))
    refuse(ErrorKind::value, {item, "physicsLength", "", std::to_string(length), "a positive length", ""});
}

template <class S, int D, int N>
using Vectors = std::array<Vec<S, D>, N>;

// Shares of local vectors in fields.
template <int Fields, int LocalVectors>
using ShapeNumbers = std::array<std::array<double, LocalVectors>, Fields>;

// Position and weight run from 0 to 1 along the element. A position on a surface has two coordinates, and weights are
// areas.
template <class Shape, class Place = double>
struct StrainPoint {
  Place position{};
  double weight = 0;
  Shape shape{};
  bool operator==(const StrainPoint&) const = default;
};
template <class Shape, class Place = double, std::size_t most = QuadratureRule::most>
struct StrainPoints {
  int count = 0;
  std::array<StrainPoint<Shape, Place>, most> at{};
  bool operator==(const StrainPoints&) const = default;
};
template <class Shape>
constexpr StrainPoints<Shape> tabulated(const QuadratureRule& rule, Shape (*shape)(double)) {
  StrainPoints<Shape> points{.count = rule.count};
  for (int i = 0; i < rule.count; ++i) points.at[i] = {rule.position[i], rule.weight[i], shape(rule.position[i])};
  return points;
}

template <class F, class K>
using PlaceOf = std::remove_cvref_t<decltype(F::points(std::declval<const K&>()).at[0].position)>;
// Families whose shapes or law vary between elements or positions define the variation.
template <class F, class K>
auto shape_at(const K& k, const PlaceOf<F, K>& place) {
  if constexpr (requires { F::shape(k, place); })
    return F::shape(k, place);
  else
    return F::shape(place);
}
template <class F, class K>
  requires requires(const K& k) { F::stiffness(k); }
decltype(auto) stiffness_at(const K& k, const PlaceOf<F, K>&) {
  return F::stiffness(k);
}
template <class F, class K>
  requires requires(const K& k, const PlaceOf<F, K>& place) { F::stiffness(k, place); }
auto stiffness_at(const K& k, const PlaceOf<F, K>& place) {
  return F::stiffness(k, place);
}
template <class F, class K>
  requires requires(const K& k) { F::damping(k); }
decltype(auto) damping_at(const K& k, const PlaceOf<F, K>&) {
  return F::damping(k);
}
template <class F, class K>
  requires requires(const K& k, const PlaceOf<F, K>& place) { F::damping(k, place); }
auto damping_at(const K& k, const PlaceOf<F, K>& place) {
  return F::damping(k, place);
}

// Definition of a point with a linear law; S is a number, dual numbers, or lane-parallel numbers.
template <class F, class E>
concept LinearFamily = requires(const typename E::Constants& k, const PlaceOf<F, typename E::Constants>& place) {
  k.length * Vec<double, F::strains>{};
  {
    stiffness_at<F>(k, place) * Vec<double, F::strains>{}
  } -> std::same_as<Vec<double, F::strains>>;  // stress by strain
  // derivative with respect to the rate of strain
  { damping_at<F>(k, place) * Vec<double, F::strains>{} } -> std::same_as<Vec<double, F::strains>>;
};
// A law of its own, such as a function of the user; `free` are the strains without stress.
template <class F, class E>
concept LawFamily = requires(const typename E::Parameters& p, const typename E::Constants& k, const Context& c,
                             const PlaceOf<F, typename E::Constants>& place, const Vec<double, F::strains>& strain) {
  F::stress(p, k, c, place, strain, strain, strain);  // position, strain, its rate, free
};
template <class F, class E>
concept StrainFamily = (LinearFamily<F, E> || LawFamily<F, E>) &&
                       requires(const typename E::Parameters& p, const typename E::Constants& k,
                                const PlaceOf<F, typename E::Constants>& place, const Vec<double, F::strains>& strain,
                                const Vectors<double, E::Map::dimension, F::fields>& fields) {
                         {
                           F::uses(0, 0)
                         } -> std::same_as<bool>;  // field, local vector: false where this share is always zero
                         { F::points(k).count } -> std::convertible_to<int>;
                         // at any position
                         {
                           shape_at<F>(k, place)
                         } -> std::same_as<std::remove_cvref_t<decltype(F::points(k).at[0].shape)>>;
                         { F::strain(k, fields) } -> std::same_as<Vec<double, F::strains>>;
                         // The strains without stress, from those of the reference configuration.
                         { F::stress_free(p, strain) } -> std::same_as<Vec<double, F::strains>>;
                       };
// stress . d(strain) = pull_back(stress) . d(fields)
template <class F, class E>
concept PullsBack =
    requires(const typename E::Constants& k, const Vectors<double, E::Map::dimension, F::fields>& fields,
             const Vec<double, F::stresses>& stress) {
      { F::pull_back(k, fields, stress) } -> std::same_as<Vectors<double, E::Map::dimension, F::fields>>;
    };

// Map from coordinates to the interpolated vectors, and back.
template <class M, class K>
concept StrainMap =
    requires(const K& k, const Coordinates<double, M::size>& x, const Vectors<double, M::dimension, M::vectors>& y,
             const Mat<double, M::dimension * M::vectors, M::dimension * M::vectors>& m, const Weights& w) {
      { M::local(k, x) } -> std::same_as<Vectors<double, M::dimension, M::vectors>>;
      { M::local_rate(k, x) } -> std::same_as<Vectors<double, M::dimension, M::vectors>>;
      { M::pull_back(k, x, y) } -> std::same_as<Vec<double, M::size>>;
      { M::linear } -> std::convertible_to<bool>;
      { M::lie_rotations.size() };  // see ElementKernel
      requires !M::linear || M::derives;
      // False: dual numbers pass through the whole element, one direction per coordinate. True: the map defines its
      // derivative, J'mJ + d(J')y; `m` derives forces along the weights, `damping` with respect to rates only.
      requires !M::derives || requires {
        { M::tangent(k, x, y, m, m, w) } -> std::same_as<Mat<double, M::size, M::size>>;
      };
    };

namespace detail {
template <class E, class Families>
inline constexpr bool all_families = false;
template <class E, class... F>
inline constexpr bool all_families<E, std::tuple<F...>> = ((StrainFamily<F, E> && PullsBack<F, E>) && ...);
}  // namespace detail

template <class E>
concept StrainKernel =
    StrainMap<typename E::Map, typename E::Constants> && detail::all_families<E, typename E::Families> &&
    detail::all_families<E, typename E::CallingFamilies> &&  // where `calls`; the same ones if there are no functions
    requires(const typename E::Parameters& p, const typename E::Constants& k,
             const Coordinates<double, E::Map::size>& x, const Vec3<double>& v, const Weights& w,
             Mat<double, E::Map::size, E::Map::size>& m) {
      { E::constants(p) } -> std::same_as<typename E::Constants>;
      { k == k } -> std::same_as<bool>;
      { k.length } -> std::convertible_to<double>;  // weights are fractions of this length
      { E::calls(p) } -> std::same_as<bool>;
      { E::damped(k) } -> std::same_as<bool>;
      E::along(k, v);  // the place of a local position, from 0 to 1 along a line
      { E::inertia(k, x) } -> std::same_as<Vec<double, E::Map::size>>;
      requires !E::Map::derives || requires { E::add_inertia_tangent(k, x, w, m); };
      { E::node_size } -> std::convertible_to<int>;
      { E::motion(p, x, v) } -> std::same_as<Motion<double>>;
      { E::pull_back(p, x, v, v, v) } -> std::same_as<Vec<double, E::Map::size>>;
      { E::mass_load(p, x, v) } -> std::same_as<Vec<double, E::Map::size>>;
      { E::constant_mass } -> std::convertible_to<bool>;
      { E::constant_jacobian } -> std::convertible_to<bool>;  // of its points
      { E::oriented } -> std::convertible_to<bool>;  // else markers have a position only
    };

// A law that reads the strains of another family at its own points. The first fields of both are the same.
template <class Own, class Other>
struct Reading {
  using More = std::conditional_t<(Own::fields < Other::fields), Other, Own>;
  static constexpr int fields = More::fields, strains = Own::strains + Other::strains, stresses = Own::stresses;
  static constexpr bool uses(int field, int vector) { return More::uses(field, vector); }
  static constexpr auto shape(double xi) { return Own::shape(xi); }
  template <class K>
  static const auto& points(const K& k) {
    return Own::points(k);
  }
  template <class K, class S, int D>
  static Vec<S, strains> strain(const K& k, const Vectors<S, D, fields>& at) {
    return joined(Own::strain(k, fields_of<Own>(at)), Other::strain(k, fields_of<Other>(at)));
  }
  template <class P>
  static Vec<double, strains> stress_free(const P& p, const Vec<double, strains>& of_reference) {
    return joined(Own::stress_free(p, first(of_reference)), Other::stress_free(p, rest(of_reference)));
  }
  template <class P, class K, class S>
  static Vec<S, stresses> stress(const P& p, const K& k, const Context& c, double position,
                                 const Vec<S, strains>& strain, const Vec<S, strains>& rate,
                                 const Vec<double, strains>& free) {
    return Own::read_stress(p, k, c, position, first(strain), first(rate), first(free), rest(strain), rest(rate),
                            rest(free));
  }
  template <class K, class S, int D>
  static Vectors<S, D, fields> pull_back(const K& k, const Vectors<S, D, fields>& at, const Vec<S, stresses>& stress) {
    const auto force = Own::pull_back(k, fields_of<Own>(at), stress);
    Vectors<S, D, fields> all{};
    for (int f = 0; f < Own::fields; ++f) all[f] = force[f];
    return all;
  }

 private:
  template <class F, class S, int D>
  static Vectors<S, D, F::fields> fields_of(const Vectors<S, D, fields>& at) {
    Vectors<S, D, F::fields> first;
    for (int f = 0; f < F::fields; ++f) first[f] = at[f];
    return first;
  }
  template <class S>
  static Vec<S, Own::strains> first(const Vec<S, strains>& a) {
    return segment<Own::strains>(a, 0);
  }
  template <class S>
  static Vec<S, Other::strains> rest(const Vec<S, strains>& a) {
    return segment<Other::strains>(a, Own::strains);
  }
};

}  // namespace dalembert
