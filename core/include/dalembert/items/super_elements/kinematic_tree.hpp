// ObjectKinematicTree, specs/super_elements/kinematic_tree.toml: the tree that its parameters describe.
#pragma once

#include "dalembert/super_elements/kinematic_tree_parameters.hpp"
#include "dalembert/trees/tree.hpp"

namespace dalembert {

inline TreeLink link_of(const ObjectKinematicTreeParameters& p, std::size_t i) {
  const int joint = static_cast<int>(p.jointTypes[i]), first_slide = static_cast<int>(JointType::PrismaticX);
  const Vec3<double>& centre = p.linkCOMs[i];
  const double mass = p.linkMasses[i];
  Mat3<double> inertia = p.linkInertiasCOM[i];
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) inertia(row, column) -= mass * centre[row] * centre[column];
    inertia(row, row) += mass * dot(centre, centre);
  }
  return {.parent = p.linkParents[i],
          .slides = joint >= first_slide,
          .axis = (joint - static_cast<int>(JointType::RevoluteX)) % 3,
          .orientation = p.jointTransformations[i],
          .offset = p.jointOffsets[i],
          .mass = mass,
          .moment = mass * centre,
          .inertia = inertia};
}

inline Tree tree_of(const ObjectKinematicTreeParameters& p) {
  Tree tree{{}, p.baseOffset};
  for (std::size_t i = 0; i < p.jointTypes.size(); ++i) tree.links.push_back(link_of(p, i));
  return tree;
}

}  // namespace dalembert
