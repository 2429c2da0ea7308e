// Cylinders, exactly: the direction in which they overlap least with another shape is one of a finite number, or the least one along a curve of them.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "dalembert/contact/convex_narrow.hpp"

namespace dalembert {
namespace {

using Kind = ConvexTouch::Kind;
constexpr double all_around = 2 * std::numbers::pi;

int cap_face(const ConvexNow& cylinder, int end) {
  const Vec3<double> outwards = end == 1 ? cylinder.axis : -cylinder.axis;
  const auto face =
      std::ranges::find_if(cylinder.normals, [&](const Vec3<double>& n) { return dot(n, outwards) > 0.5; });
  return static_cast<int>(face - cylinder.normals.begin());
}

// The direction of least depth among those tested, until one of them separates the shapes.
class LeastOverlap {
 public:
  using Overlap = ConvexPairs::RoundOverlap;
  LeastOverlap(const ConvexNow& cylinder, const ConvexNow& other) : cylinder_(cylinder), other_(other) {}

  void look(Overlap& least, const Vec3<double>& normal, ConvexPairs::RoundFeature own, ConvexPairs::OtherFeature others,
            int end, int number) {
    const double depth = -(cylinder_.lowest(-normal) + other_.lowest(normal));
    apart_ = apart_ || !(depth > 0);
    if (depth < least.depth) least = {depth, normal, own, others, end, number};
  }
  bool apart() const { return apart_; }
  static Overlap none() { return {.depth = std::numeric_limits<double>::infinity(), .normal = {}}; }

 private:
  const ConvexNow &cylinder_, &other_;
  bool apart_ = false;
};

bool at_first(double first, double second, double size) { return first <= second * (1 + face_advantage) + 1e-9 * size; }

// The direction in which two rims overlap least: downhill from the best one of some, by Newton's method where it is one.
Vec3<double> between_rims(const Rim<double>& a, const Rim<double>& b) {
  constexpr int around = 12, most_steps = 60, most_halves = 30;
  constexpr double upward[] = {0.3, 0.7, 0.93};
  const Vec3<double> w = a.centre - b.centre, x = any_across(a.axis), y = cross(a.axis, x);
  const auto overlap = [&](const Vec3<double>& u) {
    return dot(w, u) + a.radius * norm(cross(a.axis, u)) + b.radius * norm(cross(b.axis, u));
  };
  double least = std::numeric_limits<double>::infinity();
  Vec3<double> u = a.axis;
  const auto take_if_less = [&](const Vec3<double>& other) {
    const double here = overlap(other);
    if (!(here < least)) return false;
    least = here;
    u = other;
    return true;
  };
  for (int k = 0; k < around; ++k)
    for (const double up : upward) {
      const double angle = all_around * k / around, aside = std::sqrt(1 - up * up);
      take_if_less(up * a.axis + (aside * std::cos(angle)) * x + (aside * std::sin(angle)) * y);
    }
  for (int turn = 0; turn < most_steps; ++turn) {
    const auto at = rim_normals::between_rims(a, b, w, u);
    const Vec3<double> pull = w + a.radius * a.reach(u).out + b.radius * b.reach(u).out;
    const double gs = dot(at.s, pull), gt = dot(at.t, pull),
                 steepest = std::abs(at.curvature[0]) + std::abs(at.curvature[1]) + std::abs(at.curvature[2]);
    Vec3<double> step = at.is_least() ? at.step(gs, gt) : (-1 / steepest) * (gs * at.s + gt * at.t);
    const double length = norm(step);
    if (!(length > rim_normals::rounding)) break;
    step = rim_normals::not_longer(step, length);
    bool falls = false;
    for (int half = 0; half < most_halves && !falls; ++half, step = 0.5 * step)
      falls = take_if_less(direction(u + step));
    if (!falls) break;
  }
  return normal_of_rims(a, b, u);
}

}  // namespace

ConvexTouch rim_touch(const ConvexNow& cylinder, int end, const Vec3<double>& at1, const Vec3<double>& along1,
                      double radius1, const Vec3<double>& normal, double share, std::int64_t key) {
  ConvexTouch t = round_touch(Kind::rim_line, cylinder.shape->corners[static_cast<std::size_t>(end)],
                              cylinder.shape->radius, at1, along1, radius1, share, key);
  t.along0 = cylinder.inward(rim_of(cylinder, end).axis);
  t.nearby = cylinder.inward(normal);
  return t;
}
ConvexTouch rim_touch(const ConvexNow& cylinder, int end, const ConvexNow& other, const Vec3<double>& at,
                      const Vec3<double>& along, double radius, const Vec3<double>& normal) {
  return rim_touch(cylinder, end, other.into(at), other.inward(along), radius, normal, share_of_edges(cylinder, other),
                   convex_keys::rim + end);
}

void ConvexPairs::cylinder_and_polytope(const ConvexNow& cylinder, const ConvexNow& other, bool swapped,
                                        std::vector<ConvexTouch>& found) {
  LeastOverlap overlaps(cylinder, other);
  RoundOverlap face = LeastOverlap::none(), cap = face;
  for (std::size_t f = 0; f < other.normals.size() && !overlaps.apart(); ++f)
    overlaps.look(face, -other.normals[f], RoundFeature::cap, OtherFeature::face, 0, static_cast<int>(f));
  for (int end = 0; end < 2; ++end)
    overlaps.look(cap, rim_of(cylinder, end).axis, RoundFeature::cap, OtherFeature::corner, end, 0);
  if (overlaps.apart()) return;
  const double size = std::max(cylinder.shape->bound, other.shape->bound);
  const RoundOverlap &own = swapped ? face : cap, &others = swapped ? cap : face,
                     &of_faces = at_first(own.depth, others.depth, size) ? own : others;
  RoundOverlap least = of_faces;
  struct Edge {
    Vec3<double> begin, along;
  };
  const auto edge_of = [&](std::size_t k) {
    const ConvexEdge& e = other.shape->edges[k];
    const Vec3<double>&begin = other.corners[static_cast<std::size_t>(e.begin)],
          &end = other.corners[static_cast<std::size_t>(e.end)];
    return Edge{begin, (1 / norm(end - begin)) * (end - begin)};
  };
  for (std::size_t k = 0; k < other.shape->edges.size() && !overlaps.apart(); ++k) {
    const ConvexEdge& e = other.shape->edges[k];
    const Edge edge = edge_of(k);
    const Vec3<double> from = -other.normals[static_cast<std::size_t>(e.left)];
    const double angle = angle_around(edge.along, from, -other.normals[static_cast<std::size_t>(e.right)]);
    const Vec3<double> across = cross(cylinder.axis, edge.along);
    const double sine = norm(across);
    for (const double way : {1.0, -1.0}) {
      if (!(sine > 1e-9)) break;
      const Vec3<double> u = (way / sine) * across;
      const double there = angle_around(edge.along, from, u);
      if (there * angle >= 0 && std::abs(there) <= std::abs(angle))
        overlaps.look(least, u, RoundFeature::mantle, OtherFeature::edge, 0, static_cast<int>(k));
    }
    for (int end = 0; end < 2; ++end) {
      const Rim<double> rim = rim_of(cylinder, end);
      each_least_overlap(rim, edge.begin, edge.along, from, angle, [&](const Vec3<double>& u) {
        if (dot(u, rim.axis) > 0)
          overlaps.look(least, u, RoundFeature::rim, OtherFeature::edge, end, static_cast<int>(k));
      });
    }
  }
  for (std::size_t c = 0; c < other.corners.size() && !overlaps.apart(); ++c) {
    const Vec3<double> to = other.corners[c] - cylinder.corners[0], aside = to - dot(to, cylinder.axis) * cylinder.axis;
    if (const double distance = norm(aside); distance > 0)
      overlaps.look(least, (1 / distance) * aside, RoundFeature::mantle, OtherFeature::corner, 0, static_cast<int>(c));
  }
  if (overlaps.apart()) return;
  const RoundOverlap at = is_near_face(of_faces.normal, least.normal) ? of_faces : least;
  const std::size_t before = found.size();
  if (at.other == OtherFeature::face)
    faces(other, at.other_number, cylinder, swapped, found);
  else if (at.own == RoundFeature::cap)
    faces(cylinder, cap_face(cylinder, at.own_end), other, !swapped, found);
  else if (at.own == RoundFeature::mantle) {
    mantle_on_edges(cylinder, other, swapped, found);
    mantle_on_corners(cylinder, other, swapped, found);
    if (found.size() > before) return;
  }
  if (is_as_deep(found, before, swapped ? other : cylinder, swapped ? cylinder : other, least.depth)) return;
  found.resize(before);
  if (least.other == OtherFeature::face) return lowest_on_face(other, least.other_number, cylinder, swapped, found);
  if (least.own == RoundFeature::cap)
    return lowest_on_face(cylinder, cap_face(cylinder, least.own_end), other, !swapped, found);
  const double r = cylinder.shape->radius, share = share_of_edges(cylinder, other);
  if (least.other == OtherFeature::corner) {
    const auto c = static_cast<std::size_t>(least.other_number);
    found.push_back(round_touch(Kind::point_line, other.shape->corners[c], 0, cylinder.shape->corners[0],
                                cylinder.inward(cylinder.axis), r, share, convex_keys::on_mantle + least.other_number));
    found.back().swapped = !swapped;
    return;
  }
  const Edge edge = edge_of(static_cast<std::size_t>(least.other_number));
  if (least.own == RoundFeature::rim) {
    found.push_back(rim_touch(cylinder, least.own_end, other, edge.begin, edge.along, 0, least.normal));
    found.back().key += 2 * std::int64_t{least.other_number};
  } else {
    found.push_back(line_touch(cylinder, cylinder.corners[0], cylinder.axis, r, other, edge.begin, edge.along, 0,
                               least.normal, share, convex_keys::mantle + 3 * std::int64_t{least.other_number} + 1));
  }
  found.back().swapped = swapped;
}

void ConvexPairs::cylinders(const ConvexNow& a, const ConvexNow& b, std::vector<ConvexTouch>& found) {
  LeastOverlap overlaps(a, b);
  RoundOverlap of_a = LeastOverlap::none(), of_b = of_a;
  for (int end = 0; end < 2; ++end) {
    overlaps.look(of_a, rim_of(a, end).axis, RoundFeature::cap, OtherFeature::corner, end, 0);
    overlaps.look(of_b, -rim_of(b, end).axis, RoundFeature::rim, OtherFeature::cap, 0, end);
  }
  if (overlaps.apart()) return;
  const RoundOverlap& of_faces =
      at_first(of_a.depth, of_b.depth, std::max(a.shape->bound, b.shape->bound)) ? of_a : of_b;
  RoundOverlap least = of_faces;
  const Vec3<double> across = cross(a.axis, b.axis);
  const double sine = norm(across);
  for (const double way : {1.0, -1.0})
    if (sine > 1e-9) overlaps.look(least, (way / sine) * across, RoundFeature::mantle, OtherFeature::mantle, 0, 0);
  for (int end = 0; end < 2 && !overlaps.apart(); ++end) {
    const Rim<double> rim_a = rim_of(a, end), rim_b = rim_of(b, end);
    each_least_overlap(rim_a, b.corners[0], b.axis, any_across(b.axis), all_around, [&](const Vec3<double>& u) {
      if (dot(u, rim_a.axis) >= 0) overlaps.look(least, u, RoundFeature::rim, OtherFeature::mantle, end, 0);
    });
    each_least_overlap(rim_b, a.corners[0], a.axis, any_across(a.axis), all_around, [&](const Vec3<double>& u) {
      if (dot(u, rim_b.axis) >= 0) overlaps.look(least, -u, RoundFeature::mantle, OtherFeature::rim, 0, end);
    });
  }
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 2 && !overlaps.apart(); ++k) {
      const Rim<double> rim_a = rim_of(a, i), rim_b = rim_of(b, k);
      const Vec3<double> u = between_rims(rim_a, rim_b);
      if (dot(u, rim_a.axis) > 0 && dot(u, rim_b.axis) < 0)
        overlaps.look(least, u, RoundFeature::rim, OtherFeature::rim, i, k);
    }
  if (overlaps.apart()) return;
  const bool on_face = is_near_face(of_faces.normal, least.normal);
  const std::size_t before = found.size();
  if (on_face && &of_faces == &of_a)
    faces(a, cap_face(a, of_a.own_end), b, true, found);
  else if (on_face)
    faces(b, cap_face(b, of_b.other_number), a, false, found);
  else if (sine <= parallel || (least.own == RoundFeature::mantle && least.other == OtherFeature::mantle)) {
    mantles(a, b, found);
    if (found.size() > before) return;
  }
  if (is_as_deep(found, before, a, b, least.depth)) return;
  found.resize(before);
  if (least.own == RoundFeature::cap) return lowest_on_face(a, cap_face(a, least.own_end), b, true, found);
  if (least.other == OtherFeature::cap) return lowest_on_face(b, cap_face(b, least.other_number), a, false, found);
  const double ra = a.shape->radius, rb = b.shape->radius;
  if (least.own == RoundFeature::mantle && least.other == OtherFeature::mantle) {
    found.push_back(line_touch(a, a.corners[0], a.axis, ra, b, b.corners[0], b.axis, rb, least.normal,
                               share_of_edges(a, b), convex_keys::mantle));
  } else if (least.other == OtherFeature::mantle) {
    found.push_back(rim_touch(a, least.own_end, b, b.corners[0], b.axis, rb, least.normal));
  } else if (least.own == RoundFeature::mantle) {
    found.push_back(rim_touch(b, least.other_number, a, a.corners[0], a.axis, ra, -least.normal));
    found.back().swapped = true;
    found.back().key += 2;
  } else {
    const Rim<double> rim_b = rim_of(b, least.other_number);
    found.push_back(rim_touch(a, least.own_end, b, rim_b.centre, rim_b.axis, rb, least.normal));
    found.back().kind = Kind::rims;
    found.back().key += 4 + 2 * least.other_number;
  }
}

// The middle of a capsule is a line, outside of the cylinder: they are nearest to each other in this direction.
void ConvexPairs::capsule_on_rims(const ConvexNow& capsule, const ConvexNow& cylinder, bool swapped,
                                  std::vector<ConvexTouch>& found) const {
  const double r = capsule.shape->radius;
  for (int end = 0; end < 2; ++end) {
    const Rim<double> rim = rim_of(cylinder, end);
    each_least_overlap(
        rim, capsule.corners[0], capsule.axis, any_across(capsule.axis), all_around, [&](const Vec3<double>& u) {
          const auto reach = rim.reach(u);
          const Vec3<double> place = rim.centre + rim.radius * reach.out - capsule.corners[0];
          const double distance = -dot(u, place), along = dot(place, capsule.axis);
          if (!(dot(u, rim.axis) > 0 && distance > 0 && distance < r && along > 0 && along < capsule.length)) return;
          found.push_back(rim_touch(cylinder, end, capsule, capsule.corners[0], capsule.axis, r, u));
          found.back().swapped = !swapped;
        });
  }
}

}  // namespace dalembert
