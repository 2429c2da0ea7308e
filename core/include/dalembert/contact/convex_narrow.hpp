// Overlap of two convex shapes: closed forms of their features, without iterations, so that equal positions give
// equal numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "dalembert/contact/convex_shape.hpp"
#include "dalembert/contact/convex_touch.hpp"
#include "dalembert/contact/box_tree.hpp"

namespace dalembert {

// A shape where it is now, in global axes.
struct ConvexNow {
  const ConvexShape* shape = nullptr;
  RigidFrame<double> frame;
  std::vector<Vec3<double>> corners, normals;
  std::vector<double> offsets;
  Vec3<double> centre, axis;  // axis of capsules and cylinders
  double length = 0;
  Box box;

  void place(const ConvexShape& of, const RigidFrame<double>& at);
  Vec3<double> into(const Vec3<double>& point) const {
    return transposed_times(frame.rotation, point - frame.position);
  }
  Vec3<double> inward(const Vec3<double>& direction) const { return transposed_times(frame.rotation, direction); }
  // The least product of a direction with a point of it.
  double lowest(const Vec3<double>& direction) const;
};

// A corner of a shape that may stand on a plane, or where an edge of it passes over a side.
struct Foot {
  Vec3<double> place;
  std::int64_t key = 0;
  int edge = 0;  // edge from here to the next one
  double share = 1;
  int corner = -1;        // none: it lies on an edge
  int rim = -1;           // end of a cylinder's axis
  double cosine = 1, sine = 0;
};

// Keys of a pair: places of corners and ends, of faces that are clipped, of crossing edges, of mantles and of corners on them, of rims, then those of meshes. No shape has
// more edges than the first of these numbers.
namespace convex_keys {
constexpr std::int64_t edges = std::int64_t{1} << 20, second_owner = std::int64_t{1} << 43,
                       crossing = std::int64_t{1} << 44, mantle = std::int64_t{1} << 45,
                       on_mantle = std::int64_t{1} << 46, rim = std::int64_t{1} << 47,
                       mesh_edge = std::int64_t{1} << 50, mesh_corner = std::int64_t{1} << 51,
                       end = std::int64_t{1} << 52;
static_assert(end == 2 * mesh_corner && end < std::int64_t{1} << 53, "files keep keys as doubles");
}  // namespace convex_keys

// The lowest part of a shape along a normal: among the faces at its lowest corner, the one most perpendicular to the
// normal.
void lowest_feet(const ConvexNow& shape, const Vec3<double>& normal, std::vector<Foot>& feet);
// Makes a touch with a plane, whose normal and point are given in the frame of their owner; `swapped`: the plane
// belongs to the first shape.
ConvexTouch touch_of(const Foot& foot, const ConvexNow& shape, const Vec3<double>& local_normal,
                     const Vec3<double>& local_point);

// All contact points of a pair; the caller fills in the participants. Keys identify the points.
class ConvexPairs {
 public:
  void with_plane(const ConvexNow& shape, const Vec3<double>& normal, const Vec3<double>& point,
                  const RigidFrame<double>& owner, std::vector<ConvexTouch>& found);
  void between(const ConvexNow& a, const ConvexNow& b, std::vector<ConvexTouch>& found);

  // Penetration depth and direction of two polytopes, the minimum over all directions; negative if they are
  // separated.
  struct Overlap {
    double depth = -1;
    Vec3<double> normal;  // points from a to b
    int face_a = -1, face_b = -1, edge_a = -1, edge_b = -1;
  };
  // `of_faces`: the least over directions across faces.
  Overlap overlap(const ConvexNow& a, const ConvexNow& b, Overlap& of_faces) const;
  // Features of a cylinder and the other shape with the least overlap.
  enum class RoundFeature { cap, mantle, rim };
  enum class OtherFeature { face, edge, corner, cap, mantle, rim };
  struct RoundOverlap {
    double depth = 0;
    Vec3<double> normal;  // points from the cylinder to the other shape
    RoundFeature own = RoundFeature::cap;
    OtherFeature other = OtherFeature::corner;
    int own_end = 0,
        other_number = 0;  // the end of the cylinder's axis; that of the other's axis, or its face, edge or corner
  };
  // How far feet of a shape are from a plane, of those that are not below it.
  double clearance(const ConvexNow& shape, const Vec3<double>& normal, const Vec3<double>& point);
  // Lower bound of the distance of two shapes: the maximum over directions of possible face, edge or corner contacts;
  // 0 if none separates them.
  double clearance(const ConvexNow& a, const ConvexNow& b);

  struct Line {
    Vec3<double> begin, along;  // unit vectors
  };

 private:
  void faces(const ConvexNow& base, int face, const ConvexNow& other, bool swapped, std::vector<ConvexTouch>& found);
  void clip(const ConvexNow& base, int face);
  void polytopes(const ConvexNow& a, const ConvexNow& b, std::vector<ConvexTouch>& found);
  // Round things: a ball, or the end of a capsule with this share and key; `swapped`: it is the second one.
  void ball(const ConvexNow& ball, const ConvexNow& other, bool swapped, double share, std::int64_t key,
            std::vector<ConvexTouch>& found, int end = 0) const;
  void capsules(const ConvexNow& a, const ConvexNow& b, std::vector<ConvexTouch>& found) const;
  void capsule_on_faces(const ConvexNow& capsule, const ConvexNow& other, bool swapped,
                        std::vector<ConvexTouch>& found) const;
  void mantle_on_edges(const ConvexNow& round, const ConvexNow& other, bool swapped,
                       std::vector<ConvexTouch>& found) const;
  void mantle_on_corners(const ConvexNow& round, const ConvexNow& other, bool swapped,
                         std::vector<ConvexTouch>& found) const;
  // Two cylinders that touch with their mantles.
  void mantles(const ConvexNow& a, const ConvexNow& b, std::vector<ConvexTouch>& found) const;
  // `swapped`: the cylinder is the second one.
  void cylinder_and_polytope(const ConvexNow& cylinder, const ConvexNow& other, bool swapped,
                             std::vector<ConvexTouch>& found);
  void cylinders(const ConvexNow& a, const ConvexNow& b, std::vector<ConvexTouch>& found);
  // A single contact point at the deepest position.
  void lowest_on_face(const ConvexNow& base, int face, const ConvexNow& other, bool swapped,
                      std::vector<ConvexTouch>& found);
  void capsule_on_rims(const ConvexNow& capsule, const ConvexNow& cylinder, bool swapped,
                       std::vector<ConvexTouch>& found) const;

  std::vector<Foot> feet_, kept_;
  std::vector<Vec3<double>> polygon_;
  std::vector<double> shares_;
  std::vector<Line> lines_a_, lines_b_;
};

// The rim at an end of a cylinder, with its axis outwards.
inline Rim<double> rim_of(const ConvexNow& cylinder, int end) {
  return {cylinder.corners[static_cast<std::size_t>(end)], end == 1 ? cylinder.axis : -cylinder.axis,
          cylinder.shape->radius};
}
// Calls f(normal) for directions from the rim to a line, perpendicular to it, with locally least overlap, within a
// signed `angle` around the line from `from`.
template <class F>
void each_least_overlap(const Rim<double>& rim, const Vec3<double>& point, const Vec3<double>& along,
                        const Vec3<double>& from, double angle, const F& f) {
  constexpr double step = 0.4;  // curves are that smooth
  const Vec3<double> w = rim.centre - point, across = cross(along, from);
  const auto direction = [&](double x) { return std::cos(x) * from + std::sin(x) * across; };
  const auto slope = [&](const Vec3<double>& u) {
    const Vec3<double> in_plane = u - dot(u, rim.axis) * rim.axis;
    const double sine = norm(in_plane);
    return dot(cross(along, u), w) + (sine > 0 ? rim.radius / sine * dot(cross(along, u), in_plane) : 0.0);
  };
  const int count = std::max(2, static_cast<int>(std::ceil(std::abs(angle) / step)));
  const double sign = angle < 0 ? -1 : 1, part = std::abs(angle) / count;
  double before = sign * slope(from);
  for (int k = 1; k <= count; ++k) {
    const double now = sign * slope(direction(sign * k * part));
    // Newton's method, with bisection if it leaves the interval that contains the minimum
    if (before < 0 && now >= 0) {
      double low = (k - 1) * part, high = k * part, x = 0.5 * (low + high), change = part;
      for (int turn = 0; turn < 60 && change > rim_normals::rounding; ++turn) {
        const rim_normals::Newton1 at = rim_normals::across_line(rim, w, along, direction(sign * x));
        (sign * at.slope < 0 ? low : high) = x;
        const double next = x - sign * at.slope / at.curvature,
                     better = at.curvature > 0 && next > low && next < high ? next : 0.5 * (low + high);
        change = std::abs(better - x);
        x = better;
      }
      f(direction(sign * x));
    }
    before = now;
  }
}
// The signed angle around `along` from one direction across it to another.
inline double angle_around(const Vec3<double>& along, const Vec3<double>& from, const Vec3<double>& to) {
  return std::atan2(dot(along, cross(from, to)), dot(from, to));
}
// Sine below which two lines lie side by side.
inline constexpr double parallel = 0.05;
// The first shape contributes a point with a radius, in its own axes like all data.
ConvexTouch round_touch(ConvexTouch::Kind kind, const Vec3<double>& at, double radius, const Vec3<double>& at1,
                        const Vec3<double>& along1, double radius1, double share, std::int64_t key);
// Both features are parts of lines, in global axes: the axis of a cylinder, an edge of a polytope.
ConvexTouch line_touch(const ConvexNow& a, const Vec3<double>& at0, const Vec3<double>& along0, double radius0,
                       const ConvexNow& b, const Vec3<double>& at1, const Vec3<double>& along1, double radius1,
                       const Vec3<double>& normal, double share, std::int64_t key);
// A rim of the first shape and a line of another one, each in its own axes; the normal is in global axes.
ConvexTouch rim_touch(const ConvexNow& cylinder, int end, const Vec3<double>& at1, const Vec3<double>& along1,
                      double radius1, const Vec3<double>& normal, double share, std::int64_t key);
// The same with a line of a convex shape, in global axes.
ConvexTouch rim_touch(const ConvexNow& cylinder, int end, const ConvexNow& other, const Vec3<double>& at,
                      const Vec3<double>& along, double radius, const Vec3<double>& normal);

// An edge contact becomes a face contact up to this sine of the angle between both; faces of the first shape have
// priority by this advantage.
inline constexpr double near_face = 0.1, face_advantage = 1e-3;
inline bool is_near_face(const Vec3<double>& normal, const Vec3<double>& least) {
  return norm(cross(least, normal)) < near_face && dot(least, normal) > 0;
}
// Whether the points from `begin` on represent the penetration depth: the deepest point may be outside of the face,
// and rims are approximated by chords.
bool is_as_deep(const std::vector<ConvexTouch>& found, std::size_t begin, const ConvexNow& first,
                const ConvexNow& second, double depth);
// Share of a contact point without parallel faces.
inline double share_of_edges(const ConvexNow& a, const ConvexNow& b) { return 0.5 * (a.shape->lone + b.shape->lone); }

// Parameters of the nearest points of two lines; undefined for parallel lines.
struct LinePair {
  double s = 0, t = 0, sine = 0;
};
LinePair nearest_of_lines(const Vec3<double>& x0, const Vec3<double>& d0, const Vec3<double>& x1,
                          const Vec3<double>& d1);

}  // namespace dalembert
