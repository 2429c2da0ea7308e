// The cross section of a beam: its stiffness and mass, and its shape for drawing.
#pragma once

#include <vector>

#include "dalembert/enums.hpp"
#include "dalembert/math/fixed.hpp"

namespace dalembert {

// Per unit of length, in the frame of the cross section. Stiffness and damping: forces, then torques.
struct BeamSection {
  double massPerLength = 0;           // kg/m
  Mat<double, 3, 3> inertia;          // kg m
  Mat<double, 6, 6> stiffnessMatrix;  // N, N m, N m^2
  Mat<double, 6, 6> dampingMatrix;    // times s
  bool operator==(const BeamSection&) const = default;
};

// Used for drawing only.
struct BeamSectionGeometry {
  CrossSectionType crossSectionType = CrossSectionType::Polygon;
  double crossSectionRadiusY = 0, crossSectionRadiusZ = 0;  // m, circular
  std::vector<Vec<double, 2>> polygonalPoints;              // m, polygon
};

}  // namespace dalembert
