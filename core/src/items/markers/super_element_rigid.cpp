// MarkerSuperElementRigid, specs/markers/super_element_rigid.toml
#include "dalembert/batches/mesh_marker.hpp"
#include "dalembert/markers/super_element_rigid_parameters.hpp"

namespace dalembert {
namespace {

MeshMean frame_mean(const MarkerSuperElementRigidParameters& p) {
  using enum MeshMean::Rotation;
  return {p.meshNodeNumbers, p.weightingFactors,
          std::array{linear, exponential, exact}[static_cast<std::size_t>(p.rotationsExponentialMap)],
          p.useAlternativeApproach, p.offset};
}

struct SuperElementRigid final : MeshMarkerPhysics<MarkerSuperElementRigidRecord, FrameShape::rigid, frame_mean> {
  void check(const void* record, const Placement& on, const Ports& ports, const ItemLabel& item) const override {
    const auto& p = parameters(record);
    if (p.meshNodeNumbers.empty())
      refuse(ErrorKind::value, {item, "meshNodeNumbers", "", "an empty list", "mesh nodes", ""});
    MeshMarkerPhysics::check(record, on, ports, item);
    if (p.rotationsExponentialMap < 0 || p.rotationsExponentialMap > 2)
      refuse(ErrorKind::value,
             {item, "rotationsExponentialMap", "", std::to_string(p.rotationsExponentialMap), "0, 1 or 2", ""});
  }
};

}  // namespace

const Physics& marker_super_element_rigid_physics() {
  static const SuperElementRigid physics;
  return physics;
}

}  // namespace dalembert
