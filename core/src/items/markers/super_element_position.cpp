// MarkerSuperElementPosition, specs/markers/super_element_position.toml
#include "dalembert/batches/mesh_marker.hpp"
#include "dalembert/markers/super_element_position_parameters.hpp"

namespace dalembert {

const Physics& marker_super_element_position_physics() {
  static const MeshMarkerPhysics<MarkerSuperElementPositionRecord, FrameShape::point> physics;
  return physics;
}

}  // namespace dalembert
