// Convex shapes in the frame of a marker. A capsule is a segment with a radius. A cylinder has rims and a lateral
// surface, and a surrounding prism whose ends support other shapes. All other shapes are polytopes of faces with any
// number of corners.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "dalembert/math/fixed.hpp"

namespace dalembert {

enum class ConvexKind { polytope, capsule, cylinder, ball };

// Definition of a shape: points and triangles with outward normals; for capsules and cylinders, the two ends of the
// axis and a radius.
struct ConvexDefinition {
  ConvexKind kind = ConvexKind::polytope;
  std::vector<Vec3<double>> points;
  std::vector<std::array<int, 3>> triangles;
  double radius = 0;
};

struct ConvexFace {
  Vec3<double> normal;  // outwards, of length one
  double offset = 0;    // its product with points of the face
  std::vector<int> corners;  // counterclockwise, seen from outside
  std::vector<double> shares;  // share of each corner in the load of the face
};
struct ConvexEdge {
  int begin = 0, end = 0, left = 0, right = 0;  // corners and faces
};

struct ConvexShape {
  ConvexKind kind = ConvexKind::polytope;
  std::vector<Vec3<double>> corners;
  std::vector<ConvexFace> faces;
  std::vector<ConvexEdge> edges;
  double radius = 0;  // margin of a capsule or ball around its corners; radius of a cylinder
  double lone = 1;    // the share of a place that is on no face
  Vec3<double> centre;  // bounding sphere
  double bound = 0;     // its radius

  // The radius that is added to corners.
  double rounding() const { return kind == ConvexKind::cylinder ? 0 : radius; }
};

// The reason why a shape is rejected; empty if it is valid. Coplanar `points` are rejected.
std::string fault_of(const ConvexDefinition& definition);
ConvexShape make_shape(const ConvexDefinition& definition);
ConvexDefinition box_definition(const Vec3<double>& centre, const Vec3<double>& size);

// Exterior angles of a polygon divided by a full turn: they sum to one, a split corner passes its share on, and a
// point on a straight side has none.
void find_corner_shares(std::span<const Vec3<double>> polygon, const Vec3<double>& normal, std::vector<double>& shares);

// Points of a rim that represent the cap of a cylinder, starting with the lowest one, with their shares at this sine
// of the tilt angle. While standing, all shares are equal, which gives isotropic tilting stiffness; when leaning, the
// lowest point has half, like an end of the lateral surface.
inline constexpr int cap_points = 8;
double cap_share(int point, double tilt);

// A direction of length one across an axis.
Vec3<double> any_across(const Vec3<double>& axis);

}  // namespace dalembert
