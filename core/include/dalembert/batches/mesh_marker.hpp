// Markers on mesh nodes of a super element; the type of element selects the implementation.
#pragma once

#include "dalembert/model/errors.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

// `mean_of` reads the parameters.
template <class Record, FrameShape shape, auto mean_of>
struct MeshMarkerPhysics : MarkerPhysics {
  static const auto& parameters(const void* record) { return static_cast<const Record*>(record)->parameters; }

  void check(const void* record, const Placement& on, const Ports&, const ItemLabel& item) const override {
    const auto& p = parameters(record);
    const int count = object_physics(*on.owner_type).mesh_nodes(on.owner, on);
    for (const int node : p.meshNodeNumbers)
      if (node < 0 || node >= count)
        refuse(ErrorKind::value,
               {item, "meshNodeNumbers", "", std::to_string(node),
                "mesh nodes from 0 to " + std::to_string(count - 1) + ", numbered within the super element", ""});
    if (p.weightingFactors.size() != p.meshNodeNumbers.size())
      refuse(ErrorKind::value,
             {item, "weightingFactors", "", std::to_string(p.weightingFactors.size()) + " numbers",
              std::to_string(p.meshNodeNumbers.size()) + " numbers, one for each of meshNodeNumbers", ""});
  }
  std::vector<int> coordinates(const void* record, const Placement& on) const override {
    return object_physics(*on.owner_type).mesh_coordinates(on.owner, on, parameters(record).meshNodeNumbers);
  }
  std::unique_ptr<MarkerBatch> make_batch(const ItemType& item, std::span<const ItemType* const> nodes) const override {
    return object_physics(item).make_mesh_marker(shape, nodes,
                                                 [](const void* record) { return mean_of(parameters(record)); });
  }

 private:
  static const ObjectPhysics& object_physics(const ItemType& type) {
    return dynamic_cast<const ObjectPhysics&>(*type.physics);
  }
};

}  // namespace dalembert
