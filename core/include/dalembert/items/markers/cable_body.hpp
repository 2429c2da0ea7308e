// The bodies under markers of ANCF cables, in D dimensions.
#pragma once

#include <span>
#include <string>

#include "dalembert/finite_elements/ale_ancf_cable_2d_parameters.hpp"
#include "dalembert/finite_elements/ancf_cable_2d_parameters.hpp"
#include "dalembert/finite_elements/ancf_cable_parameters.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Position and slope of its axis at both ends are its coordinates, and perhaps the way of the material along the axis.
template <int D>
struct CableBody {
  double length = 1;  // length of the unstrained axis in the reference configuration
  bool moves_along = false;
  double way_in_reference = 0;

  int coordinates() const { return 4 * D + moves_along; }

  static CableBody of(const ItemType& body, const void* record, std::span<const double> reference) {
    const auto length = [record]<class Record>() {
      return static_cast<const Record*>(record)->parameters.physicsLength;
    };
    if (D == 3) return {length.template operator()<ObjectANCFCableRecord>()};
    if (is_ale(body)) return {length.template operator()<ObjectALEANCFCable2DRecord>(), true, reference[4 * D]};
    return {length.template operator()<ObjectANCFCable2DRecord>()};
  }
  static void check(const ItemType& body, const ItemLabel& marker) {
    if (body.name == (D == 2 ? "ObjectANCFCable2D" : "ObjectANCFCable") || (D == 2 && is_ale(body))) return;
    refuse(ErrorKind::value,
           {marker, "bodyNumber", "", "an " + std::string(body.name),
            D == 2 ? "a planar cable, ObjectANCFCable2D or ObjectALEANCFCable2D" : "a spatial cable, ObjectANCFCable",
            ""});
  }
  // Motion of its first point.
  static Motion<double> begin(const double* q, const double* v, const double* a) {
    const auto point = [](const double* x) { return Vec3<double>{x[0], x[1], D == 2 ? 0 : x[2]}; };
    return {.position = point(q), .velocity = point(v), .acceleration = point(a)};
  }

 private:
  static bool is_ale(const ItemType& body) { return body.name == "ObjectALEANCFCable2D"; }
};

}  // namespace dalembert
