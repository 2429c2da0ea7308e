// The bodies under markers of planar cables.
#pragma once

#include <string>

#include "dalembert/finite_elements/ancf_cable_2d_parameters.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// A planar ANCF cable: position and slope of its axis at both ends are its coordinates.
struct PlanarCable {
  static constexpr int coordinates = 8;
  double length = 1;  // of the axis, in the reference configuration without strain

  static PlanarCable of(const ItemType&, const void* record) {
    return {static_cast<const ObjectANCFCable2DRecord*>(record)->parameters.physicsLength};
  }
  static void check(const ItemType& body, const ItemLabel& marker) {
    if (body.name != "ObjectANCFCable2D")
      refuse(ErrorKind::value, {marker, "bodyNumber", "", "an " + std::string(body.name), "a planar cable, ObjectANCFCable2D", ""});
  }
  // Of its first point.
  static Motion<double> begin(const double* q, const double* v, const double* a) {
    return {.position = {q[0], q[1], 0}, .velocity = {v[0], v[1], 0}, .acceleration = {a[0], a[1], 0}};
  }
};

}  // namespace dalembert
