// Generated from specs/super_elements/ffrf_reduced_order.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/enums.hpp"
#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// flexible body with modal coordinates in a floating frame of reference
struct ObjectFFRFreducedOrderParameters {
  std::vector<NodeIndex> nodeNumbers;
  MatrixContainer massMatrixReduced;
  MatrixContainer stiffnessMatrixReduced;
  MatrixContainer dampingMatrixReduced;
  UserFunction forceUserFunction;
  UserFunction massMatrixUserFunction;
  bool computeFFRFterms = true;
  DynamicMatrix<double> modeBasis;
  DynamicMatrix<double> outputVariableModeBasis;
  OutputVariableType outputVariableTypeModeBasis = OutputVariableType::_None;
  std::vector<double> referencePositions;
  bool objectIsInitialized = false;
  double physicsMass = 0.0;
  Mat<double, 3, 3> physicsInertia = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  Vec<double, 3> physicsCenterOfMass = {};
  DynamicMatrix<double> mPsiTildePsi;
  DynamicMatrix<double> mPsiTildePsiTilde;
  DynamicMatrix<double> mPhitTPsi;
  DynamicMatrix<double> mPhitTPsiTilde;
  DynamicMatrix<double> mXRefTildePsi;
  DynamicMatrix<double> mXRefTildePsiTilde;
  Mat<double, 3, 3> physicsCenterOfMassTilde = {};
  std::vector<double> tempUserFunctionForce;
};

struct ObjectFFRFreducedOrderVisualization {
  bool show = true;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
  DynamicMatrix<int> triangleMesh;
  bool showNodes = false;
};

struct ObjectFFRFreducedOrderRecord {
  std::string name;
  ObjectFFRFreducedOrderParameters parameters;
  ObjectFFRFreducedOrderVisualization visualization;
};

}  // namespace dalembert
