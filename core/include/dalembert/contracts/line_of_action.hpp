// The line of action of a force between two points; it is undefined for coinciding points.
#pragma once

#include <string>

#include "dalembert/contracts/context.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/model/errors.hpp"

namespace dalembert {

[[noreturn]] inline void refuse_coinciding(const Context& c, const std::string& type, const std::string& advice) {
  refuse(ErrorKind::value,
         {"object " + std::to_string(c.item) + " (" + type + ")", "markerNumbers",
          "its markers coincide at time " + std::to_string(c.time) + ", so that its force has no direction", "", "",
          advice});
}

template <class S>
struct LineOfAction {
  Vec3<S> span, axis;
  S length, rate;

  // The points must not coincide.
  LineOfAction(const PointFrame<S>& m0, const PointFrame<S>& m1) : span(m1.position - m0.position), length(norm(span)) {
    axis = (1.0 / length) * span;
    rate = dot(axis, m1.velocity - m0.velocity);
  }
};

template <class S>
bool coincide(const PointFrame<S>& m0, const PointFrame<S>& m1) {
  for (int i = 0; i < 3; ++i)
    if (value_of(m0.position[i]) != value_of(m1.position[i])) return false;
  return true;
}

}  // namespace dalembert
