// MarkerBodyCable2DShape, specs/markers/body_cable_2d_shape.toml
#pragma once

#include "dalembert/contracts/mapped_marker.hpp"
#include "dalembert/items/markers/cable_body.hpp"
#include "dalembert/markers/body_cable_2d_shape_parameters.hpp"
#include "dalembert/math/cubic_hermite.hpp"

namespace dalembert {

struct MarkerBodyCable2DShape {
  using Parameters = MarkerBodyCable2DShapeParameters;
  using Constants = CableBody<2>;

  static void check_body(const Parameters&, const Placement& on, const ItemLabel& item) {
    CableBody<2>::check(*on.owner_type, item);
  }
  static Constants prepare(const Parameters&, const ItemType& body, const void* record,
                           std::span<const double> reference) {
    return CableBody<2>::of(body, record, reference);
  }

  // Positions of all points and the way of the material along the axis; their rates; how positions change along the axis, where the material moves;
  // the length of a segment without strain.
  static int points(const Parameters& p) { return p.numberOfSegments + 1; }
  static int values(const Parameters& p, const Constants&) { return 6 * points(p) + 3; }
  static int forces(const Parameters& p, const Constants&) { return 2 * points(p) + 1; }
  static bool constant_pull_back(const Parameters& p) { return p.verticalOffset == 0; }

  // Points of the axis, moved along its normal, which turns with the slope.
  template <class S>
  static void map(const Parameters& p, const Constants& cable, const S* q, const S* v, S* values) {
    const int way = 2 * points(p);
    S *position = values, *velocity = position + way + 1, *along = velocity + way + 1;
    along[way] = S(cable.length / p.numberOfSegments);
    position[way] = cable.moves_along ? q[8] : S(0);
    velocity[way] = cable.moves_along ? v[8] : S(0);
    for (int i = 0; i < points(p); ++i, position += 2, velocity += 2, along += 2) {
      const CubicHermite<double> at = place(p, cable, i);
      Vec<S, 2> r = curve<2>(at.value, q), r_rate = curve<2>(at.value, v), r_along{};
      if (cable.moves_along) r_along = curve<2>(at.slope, q);
      if (p.verticalOffset != 0) {
        const Vec<S, 2> slope = curve<2>(at.slope, q);
        const S offset = p.verticalOffset / norm(slope);
        const auto turn = [&](const Vec<S, 2>& change) {
          return (slope[0] * change[1] - slope[1] * change[0]) / dot(slope, slope);
        };
        r += offset * Vec<S, 2>{-slope[1], slope[0]};
        r_rate -= (offset * turn(curve<2>(at.slope, v))) * slope;
        if (cable.moves_along) r_along -= (offset * turn(curve<2>(at.bend, q))) * slope;
      }
      for (int d = 0; d < 2; ++d) position[d] = r[d], velocity[d] = r_rate[d], along[d] = r_along[d];
    }
  }
  template <class S>
  static void pull_back(const Parameters& p, const Constants& cable, const S* q, const S* force, S* generalised) {
    if (cable.moves_along) generalised[8] += force[2 * points(p)];
    for (int i = 0; i < points(p); ++i, force += 2) {
      const CubicHermite<double> at = place(p, cable, i);
      Vec<S, 2> couple{};  // on the slope, from the lever arm of the offset
      if (p.verticalOffset != 0) {
        const Vec<S, 2> slope = curve<2>(at.slope, q);
        const S square = dot(slope, slope),
                moment = -p.verticalOffset / norm(slope) * (slope[0] * force[0] + slope[1] * force[1]);
        couple = (moment / square) * Vec<S, 2>{-slope[1], slope[0]};
      }
      for (int j = 0; j < 4; ++j)
        for (int d = 0; d < 2; ++d) generalised[2 * j + d] += at.value[j] * force[d] + at.slope[j] * couple[d];
    }
  }
  static Motion<double> origin(const Constants&, const double* q, const double* v, const double* a) {
    return CableBody<2>::begin(q, v, a);
  }

 private:
  static CubicHermite<double> place(const Parameters& p, const Constants& cable, int point) {
    return {cable.length * point / p.numberOfSegments, cable.length};
  }
};

}  // namespace dalembert
