// Convex shapes in the frame of a marker. A capsule is a segment with a radius, a cylinder has rims and a mantle besides a prism around it, whose ends are
// what others stand on; everything else is a polytope of faces with any number of corners.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "dalembert/math/fixed.hpp"

namespace dalembert {

enum class ConvexKind { polytope, capsule, cylinder, ball };

// What a shape is made of: triangles with normals outwards, of points; of capsules and cylinders, the two ends of the axis, and a radius.
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
  std::vector<double> shares;  // of each corner, of what the whole face bears
};
struct ConvexEdge {
  int begin = 0, end = 0, left = 0, right = 0;  // corners and faces
};

struct ConvexShape {
  ConvexKind kind = ConvexKind::polytope;
  std::vector<Vec3<double>> corners;
  std::vector<ConvexFace> faces;
  std::vector<ConvexEdge> edges;
  double radius = 0;  // of a capsule or ball, by which it is larger than its corners; of a cylinder
  double lone = 1;    // the share of a place that is on no face
  Vec3<double> centre;  // of a ball around all of it
  double bound = 0;     // its radius

  // The radius that is added to corners.
  double rounding() const { return kind == ConvexKind::cylinder ? 0 : radius; }
};

// Where the shape is refused: empty if it is a body. `points` that lie in one plane are none.
std::string fault_of(const ConvexDefinition& definition);
ConvexShape make_shape(const ConvexDefinition& definition);
ConvexDefinition box_definition(const Vec3<double>& centre, const Vec3<double>& size);

// How far a polygon turns at each corner, of a full turn: they add up to one, a corner that is cut into two hands on what it has, and one on a straight side has none.
void find_corner_shares(std::span<const Vec3<double>> polygon, const Vec3<double>& normal, std::vector<double>& shares);

// Points of one rim that stand for the cap of a cylinder, the first one where it is lowest, with what each bears at a tilt of this sine. Standing, all bear the
// same, and resist tilting in every direction alike; leaning, the lowest one bears half, as it does of a mantle.
inline constexpr int cap_points = 8;
double cap_share(int point, double tilt);

// A direction of length one across an axis.
Vec3<double> any_across(const Vec3<double>& axis);

}  // namespace dalembert
