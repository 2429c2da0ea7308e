// Mesh nodes under a marker, and the places on their body that are weighted means of them.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "dalembert/contracts/frame_place.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

struct MeshNodes {
  struct Shape {
    int node, coordinate;  // among these nodes; among the coordinates of the marker
    Vec3<double> by;       // how far the coordinate moves the node
  };
  std::vector<Vec3<double>> rest;  // positions in the frame
  std::vector<Shape> shapes;
  int coordinates = 0;
};

// Mesh nodes that are nodes of the system: their numbers within the body, which has nodes of these types.
MeshNodes mesh_of_nodes(std::span<const int> numbers, const Placement& on, std::span<const ItemType* const> types);
// Positions in Placement::dofs of the coordinates that move such nodes, each of them once.
std::vector<int> coordinates_of_nodes(const Placement& on, std::span<const int> numbers);

// The weighted mean position of the mesh nodes; rejects a changed number of nodes. Optionally with a rotation, which
// the nodes must determine.
FramePlace mean_place(const MeshNodes& mesh, const MeshMean& mean, int marker);

}  // namespace dalembert
