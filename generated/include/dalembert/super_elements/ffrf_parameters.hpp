// Generated from specs/super_elements/ffrf.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// flexible body with the nodal coordinates of a finite element mesh in a floating frame of reference
struct ObjectFFRFParameters {
  std::vector<NodeIndex> nodeNumbers;
  MatrixContainer massMatrixFF;
  MatrixContainer stiffnessMatrixFF;
  MatrixContainer dampingMatrixFF;
  std::vector<double> forceVector;
  UserFunction forceUserFunction;
  UserFunction massMatrixUserFunction;
  bool computeFFRFterms = true;
  std::vector<int> coordinateIndexPerNode;
  bool objectIsInitialized = false;
  double physicsMass = 0.0;
  Mat<double, 3, 3> physicsInertia = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  Vec<double, 3> physicsCenterOfMass = {};
  DynamicMatrix<double> PHItTM;
  std::vector<double> referencePositions;
  std::vector<double> tempVector;
  std::vector<double> tempCoordinates;
  std::vector<double> tempCoordinates_t;
  DynamicMatrix<double> tempRefPosSkew;
  DynamicMatrix<double> tempVelSkew;
};

struct ObjectFFRFVisualization {
  bool show = true;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
  DynamicMatrix<int> triangleMesh;
  bool showNodes = false;
};

struct ObjectFFRFRecord {
  std::string name;
  ObjectFFRFParameters parameters;
  ObjectFFRFVisualization visualization;
};

}  // namespace dalembert
