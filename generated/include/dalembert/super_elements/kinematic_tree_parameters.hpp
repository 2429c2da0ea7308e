// Generated from specs/super_elements/kinematic_tree.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/enums.hpp"
#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// open tree of rigid bodies in minimal coordinates, one joint coordinate per link
struct ObjectKinematicTreeParameters {
  NodeIndex nodeNumber;
  Vec<double, 3> gravity = {};
  Vec<double, 3> baseOffset = {};
  std::vector<JointType> jointTypes;
  std::vector<int> linkParents;
  std::vector<Mat<double, 3, 3>> jointTransformations;
  std::vector<Vec<double, 3>> jointOffsets;
  std::vector<Mat<double, 3, 3>> linkInertiasCOM;
  std::vector<Vec<double, 3>> linkCOMs;
  std::vector<double> linkMasses;
  std::vector<Vec<double, 3>> linkForces;
  std::vector<Vec<double, 3>> linkTorques;
  std::vector<double> jointForceVector;
  std::vector<double> jointPositionOffsetVector;
  std::vector<double> jointVelocityOffsetVector;
  std::vector<double> jointPControlVector;
  std::vector<double> jointDControlVector;
  UserFunction forceUserFunction;
  std::vector<std::string> linkNames;
  std::vector<std::string> jointNames;
};

struct ObjectKinematicTreeVisualization {
  bool show = true;
  bool showLinks = true;
  bool showJoints = true;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
  Opaque graphicsDataList;
};

struct ObjectKinematicTreeRecord {
  std::string name;
  ObjectKinematicTreeParameters parameters;
  ObjectKinematicTreeVisualization visualization;
};

}  // namespace dalembert
