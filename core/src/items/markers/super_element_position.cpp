// MarkerSuperElementPosition, specs/markers/super_element_position.toml
#include "dalembert/batches/mesh_marker.hpp"
#include "dalembert/markers/super_element_position_parameters.hpp"

namespace dalembert {
namespace {

MeshMean point_mean(const MarkerSuperElementPositionParameters& p) {
  return {.nodes = p.meshNodeNumbers, .weights = p.weightingFactors};
}

}  // namespace

const Physics& marker_super_element_position_physics() {
  static const MeshMarkerPhysics<MarkerSuperElementPositionRecord, FrameShape::point, point_mean> physics;
  return physics;
}

}  // namespace dalembert
