// ObjectContactCircleCable2D, specs/contacts/circle_cable_2d.toml
#pragma once

#include <cmath>

#include "dalembert/contacts/circle_cable_2d_parameters.hpp"
#include "dalembert/items/contacts/circle_on_cable.hpp"

namespace dalembert {

struct ObjectContactCircleCable2D : AllMarkersAct, NoAlgebraicEquations, SwitchesByUpdate, NoOutputs {
  using Parameters = ObjectContactCircleCable2DParameters;

  // A spring and a damper per segment, between the centre and the nearest point, while the gap of the last update is not positive.
  template <class S>
  static void evaluate(const Parameters& p, const Context& c, Exchange<S>& x) {
    for (int i = 0; i < p.numberOfContactSegments; ++i) {
      if (c.data[i] > 0) continue;
      const CircleOnCable<S> touch = nearest(p, x, i);
      const S rate = dot(touch.direction, touch.velocity);
      const S elastic = -(p.contactStiffness * touch.gap);
      const Vec<S, 2> force = -with_losses<S>(true, elastic, -p.contactDamping * rate) * touch.direction;
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
      const double gap = nearest(p, x, i).gap;
      if ((gap > 0) == (h.data[i] > 0)) continue;
      verdict.error += std::abs((gap - h.data[i]) * p.contactStiffness);
      h.data[i] = gap;
    }
    return verdict;
  }

  static int switch_count(const Parameters& p) { return 2 * p.numberOfContactSegments; }
  static void find_switches(const Parameters& p, const Context& c, const Exchange<double>& x, Switches& switches) {
    for (int i = 0; i < p.numberOfContactSegments; ++i) {
      const CircleOnCable<double> touch = nearest(p, x, i);
      const bool touches = !(c.data[i] > 0);
      switches.holds("contact", touches, touches ? -touch.gap : touch.gap);
      const double elastic = -p.contactStiffness * touch.gap;
      if (touches)
        switches.kink("pull", pull_margin(true, elastic, -p.contactDamping * dot(touch.direction, touch.velocity)));
      else
        switches.none();
    }
  }

  static void check(const Parameters& p, const Connections& on) {
    on.require(on.gives<PointPort>(circle), circle, "markerNumbers", "a marker with a position for the circle");
    check_circle_on_cable(on, cable, p.numberOfContactSegments);
    on.require_data(p.numberOfContactSegments);
  }

 private:
  enum Marker { circle = 0, cable = 1 };

  template <class S>
  static CircleOnCable<S> nearest(const Parameters& p, const Exchange<S>& x, int segment) {
    return {x.template frame<PointPort>(circle), CablePoints<S>(x.values(cable)), segment, p.circleRadius + p.offset};
  }
};

}  // namespace dalembert
