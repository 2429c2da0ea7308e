#pragma once

namespace dalembert {

// Where the frame of a marker at a node itself comes from, and where its forces go.
struct NodeFrame {
  int dof = -1;            // of the first displacement, which are its position; -1: it is no such marker
  int rotating_node = -1;  // among those of the ports, which has the rotation and takes the forces; -1: there is none
};

}  // namespace dalembert
