// ObjectContactCircleCable2D, specs/contacts/circle_cable_2d.toml
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "dalembert/contacts/circle_cable_2d_parameters.hpp"
#include "dalembert/contracts/many_ports.hpp"

namespace dalembert {

struct ObjectContactCircleCable2D : AllMarkersAct, NoAlgebraicEquations, NoOutputs {
  using Parameters = ObjectContactCircleCable2DParameters;

  // A spring and a damper per segment, between the centre and the nearest point, while the gap of the last update is not positive.
  template <class S>
  static void evaluate(const Parameters& p, const Context& c, Exchange<S>& x) {
    for (int i = 0; i < p.numberOfContactSegments; ++i) {
      if (c.data[i] > 0) continue;
      const Touch<S> touch(p, x, i);
      const Vec<S, 2> force = (p.contactStiffness * touch.gap + p.contactDamping * touch.rate) * touch.direction;
      x.apply(circle, force);
      const std::span<S> on_cable = x.forces(cable);
      for (int d = 0; d < 2; ++d) {
        on_cable[2 * i + d] -= (1.0 - touch.place) * force[d];
        on_cable[2 * i + 2 + d] -= touch.place * force[d];
      }
    }
  }

  // Contact that opens or closes is an error, and the gap is kept then.
  static constexpr bool has_history = true;
  static PostNewton update(const Parameters& p, const Context&, const Exchange<double>& x, const History& h) {
    PostNewton verdict;
    for (int i = 0; i < p.numberOfContactSegments; ++i) {
      const double gap = Touch<double>(p, x, i).gap;
      if ((gap > 0) == (h.data[i] > 0)) continue;
      verdict.error += std::abs((gap - h.data[i]) * p.contactStiffness);
      h.data[i] = gap;
    }
    return verdict;
  }

  static void check(const Parameters& p, const Connections& on) {
    on.require(on.gives<PointPort>(circle), circle, "markerNumbers", "a marker with a position for the circle");
    on.require(on.type(cable).name == "MarkerBodyCable2DShape", cable, "markerNumbers", "a MarkerBodyCable2DShape for the cable");
    const int segments = on.coordinates(cable) / 2 - 1;
    if (segments != p.numberOfContactSegments)
      on.refuse("numberOfContactSegments", std::to_string(p.numberOfContactSegments), std::to_string(segments) + ", as marker m1 has");
    on.require_data(segments);
  }

 private:
  enum Marker { circle = 0, cable = 1 };

  // Where a segment is nearest to the circle.
  template <class S>
  struct Touch {
    S place{}, gap{}, rate{};  // place: from 0 to 1 along the segment
    Vec<S, 2> direction{};     // from the centre to the segment; zero if they coincide

    Touch(const Parameters& p, const Exchange<S>& x, int segment) {
      const PointFrame<S>& centre = x.template frame<PointPort>(circle);
      const std::span<const S> values = x.values(cable);
      const std::size_t first = 2 * static_cast<std::size_t>(segment), rates = values.size() / 2;
      const auto pair = [&](std::size_t i) { return Vec<S, 2>{values[i], values[i + 1]}; };
      const auto planar = [](const Vec3<S>& v) { return Vec<S, 2>{v[0], v[1]}; };
      const Vec<S, 2> start = pair(first) - planar(centre.position), line = pair(first + 2) - pair(first);
      if (const S square = dot(line, line); value_of(square) > 0) place = -dot(start, line) / square;
      if (place < 0.0) place = S(0);
      if (place > 1.0) place = S(1);
      const Vec<S, 2> span = start + place * line;
      const S square = dot(span, span);
      const double clearance = -p.circleRadius - p.offset;
      gap = S(clearance);
      if (value_of(square) == 0) return;
      using std::sqrt;
      const S distance = sqrt(square);
      direction = (1.0 / distance) * span;
      gap = distance + clearance;
      const Vec<S, 2> velocity = pair(rates + first) + place * (pair(rates + first + 2) - pair(rates + first)) - planar(centre.velocity);
      rate = dot(direction, velocity);
    }
  };
};

}  // namespace dalembert
