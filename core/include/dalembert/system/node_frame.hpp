#pragma once

namespace dalembert {

// Source of the frame of a marker at a node itself, and destination of its forces.
struct NodeFrame {
  int dof = -1;  // first displacement, where its position is stored; -1: not such a marker
  int rotating_node = -1;  // index among those of the ports, with the rotation and the forces; -1: no rotation
};

}  // namespace dalembert
