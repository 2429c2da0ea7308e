// A user pulls a point of a body towards a target while a solver runs.
#pragma once

#include "dalembert/math/fixed.hpp"

namespace dalembert {

// The pulled point of an object: one of its nodes, a node of its mesh, a point of one of its links, or of the body itself.
struct Grip {
  int object = -1;
  int node = -1;          // number in the system
  int part = -1;          // link of a kinematic tree, or mesh node
  Vec3<double> local{};   // of links and bodies
};

// A critically damped spring between point and target; its force is constant during a step.
struct Pull {
  Grip grip;
  Vec3<double> target{};
  double strength = 0;  // stiffness divided by mass, 1/s^2
};

struct PullForce {
  int row;
  double value;
};

}  // namespace dalembert
