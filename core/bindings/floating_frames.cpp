#include "floating_frames.hpp"

#include <unordered_map>

#include "dalembert/model/member.hpp"

namespace dalembert {

std::vector<int> floating_frames_of_sensors(const Model& model) {
  std::unordered_map<int, int> frames;  // by node
  for (const Item& object : model.items(ItemKind::object)) {
    if (object.type->type_name != "FFRF") continue;
    const auto& nodes = *member_of<std::vector<NodeIndex>>(object, "nodeNumbers");
    for (std::size_t i = 1; i < nodes.size(); ++i) frames[nodes[i].value] = nodes[0].value;
  }
  std::vector<int> result;
  for (const Item& sensor : model.items(ItemKind::sensor)) {
    const auto* node = member_of<NodeIndex>(sensor, "nodeNumber");
    const auto known = node == nullptr ? frames.end() : frames.find(node->value);
    result.push_back(known == frames.end() ? -1 : known->second);
  }
  return result;
}

}  // namespace dalembert
