// Markers of contacts that are points or frames: points do not turn, and need no moments.
#pragma once

#include "dalembert/contracts/many_ports.hpp"

namespace dalembert {

template <class S>
RigidFrame<S> body_frame(const Exchange<S>& x, int marker) {
  if (x.selected(marker) == RigidPort::forces) return x.template frame<RigidPort>(marker);
  const PointFrame<S>& point = x.template frame<PointPort>(marker);
  return {point.position, point.velocity, identity<S>(), {}};
}

// Adds a force at a point that is `arm` away from the marker.
template <class S>
void push(Exchange<S>& x, int marker, const Vec3<S>& arm, const Vec3<S>& force) {
  if (x.selected(marker) == RigidPort::forces)
    x.apply(marker, Wrench<S>{force, cross(arm, force)});
  else
    x.apply(marker, Force<S>{force});
}

// Friction has moments.
inline void require_body_port(const Connections& on, int marker, double friction) {
  if (friction != 0)
    on.require(on.gives<RigidPort>(marker), marker, "markerNumbers",
               "a marker with an orientation, for there is friction (dynamicFriction)");
  else
    on.require(on.gives<PointPort>(marker), marker, "markerNumbers", "a marker with a position");
}

}  // namespace dalembert
