// Which coordinates an explicit integrator may hold fixed instead of solving constraint equations.
#include "dalembert/constraints/coordinate_parameters.hpp"
#include "dalembert/system/parts.hpp"

namespace dalembert {

std::optional<std::vector<int>> System::fixed_coordinates() const {
  std::vector<int> fixed, tied;
  for (const NodePlace& node : parts_->nodes)
    if (node.sizes.ae > 0) return std::nullopt;
  for (const ObjectPlace& object : parts_->objects) {
    if (object.equations == 0) continue;
    if (object.type->name != "ObjectConnectorCoordinate") return std::nullopt;
    const auto& p = static_cast<const ObjectConnectorCoordinateRecord*>(object.record.get())->parameters;
    if (!p.activeConnector) continue;
    parts_->list_coordinates(object, Coordinates::ode2, tied);
    if (tied.size() != 1 || p.offset != 0 || p.offsetUserFunction || p.offsetUserFunction_t) return std::nullopt;
    fixed.push_back(tied.front());
  }
  return fixed;
}

}  // namespace dalembert
