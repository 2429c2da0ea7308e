// Nearest point of a segment of a planar cable to a circle: shared by contacts of circles and cables.
#pragma once

#include <algorithm>
#include <string>

#include "dalembert/contracts/many_ports.hpp"
#include "dalembert/laws/touch.hpp"

namespace dalembert {

// Points of a MarkerBodyCable2DShape, and how far the material lies along them.
template <class S>
class CablePoints {
 public:
  CablePoints(std::span<const S> values) : values_(values) {}
  Vec<S, 2> position(int i) const { return pair(2 * i); }
  Vec<S, 2> velocity(int i) const { return pair(way_at() + 1 + 2 * i); }  // velocity of the axis
  // Length of the material in the reference configuration.
  const S& segment_length() const { return values_[values_.size() - 1]; }
  const S& way() const { return values_[static_cast<std::size_t>(way_at())]; }
  // Velocity of the material relative to the axis, and the derivative of its position with respect to its
  // displacement.
  const S& way_rate() const { return values_[static_cast<std::size_t>(2 * way_at() + 1)]; }
  Vec<S, 2> along(int i) const { return pair(2 * (way_at() + 1) + 2 * i); }
  // Place of the way among the forces.
  int way_at() const { return static_cast<int>(values_.size() - 3) / 3; }

 private:
  Vec<S, 2> pair(int i) const {
    return {values_[static_cast<std::size_t>(i)], values_[static_cast<std::size_t>(i) + 1]};
  }

  std::span<const S> values_;
};

template <class S>
struct CircleOnCable {
  S place{}, gap{};  // place: from 0 to 1 along the segment
  // direction: from the center to the segment, zero if they coincide; velocity: of the segment relative to the center
  Vec<S, 2> direction{}, velocity{};

  // The gap is the distance to the centre of the circle less a radius.
  CircleOnCable(const PointFrame<S>& centre, const CablePoints<S>& cable, int segment, double radius) {
    const auto planar = [](const Vec3<S>& v) { return Vec<S, 2>{v[0], v[1]}; };
    const Vec<S, 2> start = cable.position(segment) - planar(centre.position),
                    line = cable.position(segment + 1) - cable.position(segment);
    if (const S square = dot(line, line); value_of(square) > 0) place = -dot(start, line) / square;
    if (place < 0.0) place = S(0);
    if (place > 1.0) place = S(1);
    const Vec<S, 2> span = start + place * line;
    direction = dalembert::direction(span);
    gap = dot(direction, span) - radius;
    velocity = cable.velocity(segment) + place * (cable.velocity(segment + 1) - cable.velocity(segment)) -
               planar(centre.velocity);
  }
};

inline void check_circle_on_cable(const Connections& on, int cable, int segments) {
  on.require(on.type(cable).name == "MarkerBodyCable2DShape", cable, "markerNumbers",
             "a MarkerBodyCable2DShape for the cable");
  const int given = (on.coordinates(cable) - 1) / 2 - 1;  // number of positions; the rest are displacements
  if (given != segments)
    on.refuse("numberOfContactSegments", std::to_string(segments), std::to_string(given) + ", as marker m1 has");
}

}  // namespace dalembert
