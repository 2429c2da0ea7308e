// MarkerBodyCable2DCoordinates, specs/markers/body_cable_2d_coordinates.toml
#pragma once

#include <algorithm>

#include "dalembert/contracts/mapped_marker.hpp"
#include "dalembert/items/markers/planar_cable.hpp"
#include "dalembert/markers/body_cable_2d_coordinates_parameters.hpp"

namespace dalembert {

struct MarkerBodyCable2DCoordinates {
  using Parameters = MarkerBodyCable2DCoordinatesParameters;
  using Constants = PlanarCable;

  static void check_body(const Parameters&, const Placement& on, const ItemLabel& item) { PlanarCable::check(*on.owner_type, item); }
  static Constants prepare(const Parameters&, const ItemType& body, const void* record) { return PlanarCable::of(body, record); }

  // All coordinates, their rates and the length of the cable.
  static constexpr int n = PlanarCable::coordinates, length = 2 * n;
  static int values(const Parameters&) { return 2 * n + 1; }
  static int forces(const Parameters&) { return n; }
  static bool constant_pull_back(const Parameters&) { return true; }
  template <class S>
  static void map(const Parameters&, const Constants& cable, const S* q, const S* v, S* values) {
    std::copy_n(q, n, values);
    std::copy_n(v, n, values + n);
    values[length] = S(cable.length);
  }
  template <class S>
  static void pull_back(const Parameters&, const Constants&, const S*, const S* force, S* generalised) {
    for (int i = 0; i < n; ++i) generalised[i] += force[i];
  }
  static Motion<double> origin(const Constants&, const double* q, const double* v, const double* a) { return PlanarCable::begin(q, v, a); }
};

}  // namespace dalembert
