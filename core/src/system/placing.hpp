// Nodes and coordinates under an item, collected from placed items. A placement is overwritten by the next one.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "dalembert/system/parts.hpp"

namespace dalembert {

class Placing {
 public:
  // With the memory of a placement that is not used any more.
  explicit Placing(SystemParts& parts, Placement memory = {}) : parts_(parts), placement_(std::move(memory)) {}

  Placement& last() { return placement_; }
  std::vector<const ItemType*> node_types(std::span<const int> nodes) const {
    std::vector<const ItemType*> types;
    for (const int n : nodes) types.push_back(parts_.nodes[n].type);
    return types;
  }

  Placement& on(std::span<const int> nodes) {
    placement_.clear();
    placement_.nodes.assign(nodes.begin(), nodes.end());
    return on_its_nodes();
  }
  Placement& of_object(int number) {
    const ObjectPlace& place = parts_.objects[number];
    Placement& p = on(place.nodes.of(parts_.references));
    const auto markers = place.markers.of(parts_.references);
    p.item = number;
    p.markers.assign(markers.begin(), markers.end());
    for (const int marker : markers) p.marker_types.push_back(parts_.markers[marker].type);
    p.first_ae = place.first_ae;
    return p;
  }
  Placement& of_marker(int number, const MarkerPlace& place) {
    Placement& p = under(place.objects.of(parts_.references), place.node);
    p.item = number;
    p.markers = {number};
    p.owner = place.object >= 0 ? parts_.objects[place.object].record.get() : parts_.nodes[place.node].record.get();
    p.owner_type = place.object >= 0 ? parts_.objects[place.object].type : parts_.nodes[place.node].type;
    p.owner_number = place.object >= 0 ? place.object : place.node;
    return p;
  }

 private:
  // The placement of an item on these nodes, which lie in the placement already.
  Placement& on_its_nodes() {
    Placement& p = placement_;
    p.ae_offset = parts_.sizes.first_ae();
    p.ode1_offset = parts_.sizes.ode2;
    const double* reference = parts_.state(ConfigurationType::Reference).q.data();
    if (p.nodes.size() == 1) p.rotating_node = parts_.nodes[p.nodes.front()].rotating;
    for (const int n : p.nodes) {
      const NodePlace& node = parts_.nodes[n];
      append_range(p.dofs, node.ode2, node.sizes.ode2);
      append_range(p.ode1, node.ode1, node.sizes.ode1);
      p.node_sizes.push_back(node.sizes.ode2);
      p.node_records.push_back(node.record.get());
      if (node.sizes.data > 0) {
        p.first_data = node.data;
        p.data_count = node.sizes.data;
      }
      if (node.sizes.ode2 > 0)
        p.reference.insert(p.reference.end(), reference + node.ode2, reference + node.ode2 + node.sizes.ode2);
    }
    return p;
  }

  // Placement of a marker's objects, one after the other, and of its own node, if it has one.
  Placement& under(std::span<const int> objects, int node) {
    Placement& p = placement_;
    p.clear();
    for (const int o : objects) {
      const auto below = parts_.objects[o].nodes.of(parts_.references);
      p.nodes.insert(p.nodes.end(), below.begin(), below.end());
    }
    if (node >= 0) p.nodes.push_back(node);
    on_its_nodes();
    if (objects.size() < 2) return p;
    auto reference = p.reference.begin();
    for (const int o : objects) {
      const ObjectPlace& object = parts_.objects[o];
      const auto below = object.nodes.of(parts_.references);
      MarkerOwner& owner = p.owners.emplace_back();
      owner.type = object.type;
      owner.record = object.record.get();
      owner.nodes = node_types(below);
      for (const int n : below) {
        owner.node_records.push_back(parts_.nodes[n].record.get());
        owner.dofs += parts_.nodes[n].sizes.ode2;
      }
      owner.reference.assign(reference, reference + owner.dofs);
      reference += owner.dofs;
    }
    return p;
  }

  SystemParts& parts_;
  Placement placement_;
};

}  // namespace dalembert
