// Coordinates that an explicit integrator may fix instead of solving constraint equations.
#include "dalembert/system/parts.hpp"

namespace dalembert {

std::optional<std::vector<int>> System::fixed_coordinates() const {
  std::vector<int> fixed, tied;
  for (const NodePlace& node : parts_->nodes)
    if (node.sizes.ae > 0) return std::nullopt;
  for (const ObjectPlace& object : parts_->objects) {
    if (object.equations == 0) continue;
    const Holding holding = static_cast<const ObjectPhysics&>(*object.type->physics).holds(object.record.get());
    if (holding == Holding::nothing) continue;
    parts_->list_coordinates(object, Coordinates::ode2, tied);
    if (holding == Holding::unknown || object.equations != 1 || tied.size() != 1) return std::nullopt;
    fixed.push_back(tied.front());
  }
  return fixed;
}

}  // namespace dalembert
