// Common part of MarkerBodyCable2DCoordinates and MarkerBodyBeamShape: all coordinates of a cable, their rates and
// its length; the displacement of the material along the axis is relative to the reference configuration.
#pragma once

#include <algorithm>

#include "dalembert/contracts/mapped_marker.hpp"
#include "dalembert/items/markers/cable_body.hpp"

namespace dalembert {

template <class P, int D>
struct CableCoordinates {
  using Parameters = P;
  using Constants = CableBody<D>;

  static void check_body(const P&, const Placement& on, const ItemLabel& item) {
    Constants::check(*on.owner_type, item);
  }
  static Constants prepare(const P&, const ItemType& body, const void* record, std::span<const double> reference) {
    return Constants::of(body, record, reference);
  }

  static int values(const P&, const Constants& cable) { return 2 * cable.coordinates() + 1; }
  static int forces(const P&, const Constants& cable) { return cable.coordinates(); }
  static bool constant_pull_back(const P&) { return true; }
  template <class S>
  static void map(const P&, const Constants& cable, const S* q, const S* v, S* values) {
    S* const totals = values;
    values = std::copy_n(q, cable.coordinates(), values);
    if (cable.moves_along) totals[4 * D] -= cable.way_in_reference;
    values = std::copy_n(v, cable.coordinates(), values);
    *values = S(cable.length);
  }
  template <class S>
  static void pull_back(const P&, const Constants& cable, const S*, const S* force, S* generalised) {
    for (int i = 0; i < cable.coordinates(); ++i) generalised[i] += force[i];
  }
  static Motion<double> origin(const Constants&, const double* q, const double* v, const double* a) {
    return Constants::begin(q, v, a);
  }
};

}  // namespace dalembert
