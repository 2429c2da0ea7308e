// Common part of joints that slide along a chain of cable elements: the position of a body on the cable, its rates,
// and its passage between elements.
#pragma once

#include <vector>

#include "dalembert/items/joints/along_cable.hpp"

namespace dalembert {

// `way_unknown`: number of the unknown that is the way within the step.
template <class P, int dimension, int way_unknown>
struct SlidingAlongCable : AlongCable<P> {
  using Base = AlongCable<P>;
  static constexpr int way = way_unknown;

  static bool is_multiplier(const P&, int k) { return k != way; }
  static bool forces_follow_motion(const P&) { return true; }

  static constexpr bool has_history = true;
  static PostNewton update(const P& p, const Context&, const Exchange<double>& x, const History& h) {
    return Base::take_over(p, x, h, h.algebraic[way]);
  }
  static PostNewton settle(const P& p, const Context&, const Exchange<double>& x, const History& h) {
    return Base::leave(p, x, h.data[Base::start_of_step] + x.unknowns[way], h.data);
  }
  static void find_switches(const P& p, const Context& c, const Exchange<double>& x, Switches& switches) {
    Base::find_switch(p, x, c.data[Base::start_of_step] + x.unknowns[way], c.data, switches);
  }

  // Position and velocity of the body, and its place along all elements.
  static bool output_of_motion(const Context& c, const Exchange<double>& x, OutputVariableType variable,
                               std::vector<double>& values) {
    const PointFrame<double>& frame = x.frame<PointPort>(Base::body);
    switch (variable) {
      case OutputVariableType::Position: values.assign(frame.position.x.begin(), frame.position.x.end()); return true;
      case OutputVariableType::Velocity: values.assign(frame.velocity.x.begin(), frame.velocity.x.end()); return true;
      case OutputVariableType::SlidingCoordinate: values = {c.data[Base::start_of_step] + x.unknowns[way]}; return true;
      default: return false;
    }
  }

  // The cable at a place, against the body.
  template <class S>
  struct Cable {
    using Vector = Vec<S, dimension>;
    CubicHermite<S> weights;
    Vector slope, bend, gap;

    Cable(const P& p, const Context& c, const Exchange<S>& x, const S& way)
        : weights(way + Base::start(p, c), Base::length(x)),
          slope(curve<dimension>(weights.slope, x.values(Base::cable).data())),
          bend(curve<dimension>(weights.bend, x.values(Base::cable).data())),
          gap(curve<dimension>(weights.value, x.values(Base::cable).data()) -
              segment<dimension>(x.template frame<PointPort>(Base::body).position, 0)) {}

    // Velocity of the cable against the body, and rate of its slope, both at a fixed place; how fast the body slides.
    struct Rates {
      Vector gap, slope;
      S slide;
    };
    Rates rates(const Exchange<S>& x) const {
      const S* v = x.values(Base::cable).data() + x.selected(Base::cable);
      Rates r{
          curve<dimension>(weights.value, v) - segment<dimension>(x.template frame<PointPort>(Base::body).velocity, 0),
          curve<dimension>(weights.slope, v), S(0)};
      r.slide = -dot(r.gap, slope) / dot(slope, slope);
      return r;
    }
    // Nearest to the body, after one step of Newton's method.
    S nearest(const S& way) const { return way - dot(gap, slope) / (dot(slope, slope) + dot(gap, bend)); }
  };
};

}  // namespace dalembert
