// Generated from specs/super_elements/generic_ode2.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// system of second order differential equations with constant matrices and user functions, on any nodes
struct ObjectGenericODE2Parameters {
  std::vector<NodeIndex> nodeNumbers;
  MatrixContainer massMatrix;
  MatrixContainer stiffnessMatrix;
  MatrixContainer dampingMatrix;
  std::vector<double> forceVector;
  UserFunction forceUserFunction;
  UserFunction massMatrixUserFunction;
  UserFunction jacobianUserFunction;
  std::vector<int> coordinateIndexPerNode;
  std::vector<double> tempCoordinates;
  std::vector<double> tempCoordinates_t;
  std::vector<double> tempCoordinates_tt;
};

struct ObjectGenericODE2Visualization {
  bool show = true;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
  DynamicMatrix<int> triangleMesh;
  bool showNodes = false;
  Opaque graphicsDataUserFunction;
};

struct ObjectGenericODE2Record {
  std::string name;
  ObjectGenericODE2Parameters parameters;
  ObjectGenericODE2Visualization visualization;
};

}  // namespace dalembert
