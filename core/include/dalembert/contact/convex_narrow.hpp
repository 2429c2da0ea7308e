// Where two convex things overlap: in closed forms of their features, without iterations, so that the same places give the same numbers.
#pragma once

#include <vector>

#include "dalembert/contact/convex_shape.hpp"
#include "dalembert/contact/convex_touch.hpp"
#include "dalembert/contact/triangle_tree.hpp"

namespace dalembert {

// A shape where it is now, in global axes.
struct ConvexNow {
  const ConvexShape* shape = nullptr;
  RigidFrame<double> frame;
  std::vector<Vec3<double>> corners, normals;
  std::vector<double> offsets;
  Vec3<double> centre, axis;  // of capsules and cylinders
  double length = 0;
  Box box;

  void place(const ConvexShape& of, const RigidFrame<double>& at);
  Vec3<double> into(const Vec3<double>& point) const { return transposed_times(frame.rotation, point - frame.position); }
  Vec3<double> inward(const Vec3<double>& direction) const { return transposed_times(frame.rotation, direction); }
  // The least product of a direction with a point of it.
  double lowest(const Vec3<double>& direction) const;
};

// A corner of a shape that may stand on a plane, or where an edge of it passes over a side.
struct Foot {
  Vec3<double> place;
  std::int64_t key = 0;
  int edge = 0;           // which one leads from here to the next
  double share = 1;
  int corner = -1;        // none: it lies on an edge
  int rim = -1;           // end of a cylinder's axis
  double cosine = 1, sine = 0;
};

// Keys of a pair: places of corners and ends, of faces that are clipped, of crossing edges, of mantles and of corners on them, then those of meshes. No shape has
// more edges than the first of these numbers.
namespace convex_keys {
constexpr std::int64_t edges = std::int64_t{1} << 20, second_owner = std::int64_t{1} << 43, crossing = std::int64_t{1} << 44, mantle = std::int64_t{1} << 45,
                       on_mantle = std::int64_t{1} << 46, mesh_edge = std::int64_t{1} << 50, mesh_corner = std::int64_t{1} << 51;
}  // namespace convex_keys

// What of a shape is lowest along a normal: of the faces at its lowest corner, the one that is most across.
void lowest_feet(const ConvexNow& shape, const Vec3<double>& normal, std::vector<Foot>& feet);
// As a touch with a plane, whose normal and point are given in the frame of their owner; `swapped`: the plane belongs to the first one.
ConvexTouch touch_of(const Foot& foot, const ConvexNow& shape, const Vec3<double>& local_normal, const Vec3<double>& local_point);

// All places of a pair; participants are filled in by the caller. Keys tell places apart.
class ConvexPairs {
 public:
  void with_plane(const ConvexNow& shape, const Vec3<double>& normal, const Vec3<double>& point, const RigidFrame<double>& owner, std::vector<ConvexTouch>& found);
  void between(const ConvexNow& a, const ConvexNow& b, std::vector<ConvexTouch>& found);

  // How deep two polytopes overlap, and along what: the least over all directions; negative: they do not.
  struct Overlap {
    double depth = -1;
    Vec3<double> normal;  // from a to b
    int face_a = -1, face_b = -1, edge_a = -1, edge_b = -1;
  };
  Overlap overlap(const ConvexNow& a, const ConvexNow& b) const;
  // How far feet of a shape are from a plane, of those that are not below it.
  double clearance(const ConvexNow& shape, const Vec3<double>& normal, const Vec3<double>& point);

 private:
  void faces(const ConvexNow& base, int face, const ConvexNow& other, bool swapped, std::vector<ConvexTouch>& found);
  void clip(const ConvexNow& base, int face);
  void prisms(const ConvexNow& a, const ConvexNow& b, const Overlap& at, std::vector<ConvexTouch>& found);
  // Round things: a ball, or the end of a capsule with this share and key; `swapped`: it is the second one.
  void ball(const ConvexNow& ball, const ConvexNow& other, bool swapped, double share, std::int64_t key, std::vector<ConvexTouch>& found, int end = 0) const;
  void capsules(const ConvexNow& a, const ConvexNow& b, std::vector<ConvexTouch>& found) const;
  void capsule_on_faces(const ConvexNow& capsule, const ConvexNow& other, bool swapped, std::vector<ConvexTouch>& found) const;
  void mantle_on_edges(const ConvexNow& round, const ConvexNow& other, bool swapped, std::vector<ConvexTouch>& found) const;
  void mantle_on_corners(const ConvexNow& round, const ConvexNow& other, bool swapped, std::vector<ConvexTouch>& found) const;
  // Whether two cylinders touch with their mantles: then by their axes.
  bool mantles(const ConvexNow& a, const ConvexNow& b, const Overlap& at, std::vector<ConvexTouch>& found) const;

  std::vector<Foot> feet_, kept_;
  std::vector<Vec3<double>> polygon_;
  std::vector<double> shares_;
};

// How far two shapes are from each other: the most that a direction tells in which faces, edges or corners may touch; 0: none separates them.
double clearance(const ConvexNow& a, const ConvexNow& b);

// Parameters of the points of two lines that are nearest to each other; parallel ones have none.
struct LinePair {
  double s = 0, t = 0, sine = 0;
};
LinePair nearest_of_lines(const Vec3<double>& x0, const Vec3<double>& d0, const Vec3<double>& x1, const Vec3<double>& d1);

}  // namespace dalembert
