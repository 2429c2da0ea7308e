// The configurations of a system, as its nodes state them.
#pragma once

#include "dalembert/system/parts.hpp"

namespace dalembert {

class StartValues {
 public:
  // Makes room for the values of nodes of these sizes, and returns their sum.
  static Sizes make_room(std::span<const Sizes> nodes, SystemParts& parts);
  // Puts reference and initial values of a node behind those of the nodes before.
  void take(const NodePlace& node, SystemParts& parts);

 private:
  NodeValues values_;  // used again for every node
};

// Once the reference and initial values of all nodes are there: room for the coordinates of constraints, and all else starts
// from the initial configuration.
void complete_configurations(SystemParts& parts);

// All configurations as after an assembly of the same model; their vectors stay where they are.
void start_again(SystemParts& parts);

}  // namespace dalembert
