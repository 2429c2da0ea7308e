// The part of a connector or constraint that its residual adds to the ports: what it exerts on its markers.
#pragma once

#include "dalembert/system/evaluation.hpp"
#include "dalembert/system/ports.hpp"

namespace dalembert {

class MarkerForces {
 public:
  virtual ~MarkerForces() = default;
  // Adds the forces of one entry to those of its markers (`ports.forces`), and changes nothing else.
  virtual void add_marker_forces(int entry, const Evaluation& evaluation, Ports& ports) const = 0;
};

}  // namespace dalembert
