// Shapes on planes, and polytopes against each other: the direction of least overlap by the separating axis theorem (Gottschalk, Lin, Manocha 1996), edges
// only where their arcs on the Gauss map cross (Gregorius 2013), and a face of one clipped by the sides of a face of the other (Sutherland and Hodgman 1974).
#include "dalembert/contact/convex_narrow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dalembert {
namespace {

constexpr double steep = 0.7;  // cosine of the angle at which a cylinder stands on its cap
constexpr double upright = 1e-3;  // sine below which no point of a rim is the lowest one

void feet_of_cylinder(const ConvexNow& shape, const Vec3<double>& n, std::vector<Foot>& feet) {
  const double along = dot(n, shape.axis), tilt = std::sqrt(std::max(0.0, 1 - along * along)), r = shape.shape->radius;
  const bool lies = tilt > upright;
  Vec3<double> x = lies ? (1 / tilt) * (along * shape.axis - n) : shape.corners[2] - shape.corners[0];
  x = (1 / norm(x)) * x;
  const Vec3<double> y = cross(shape.axis, x);
  const auto add = [&](int end, int k, double cosine, double sine, double share) {
    feet.push_back({shape.corners[static_cast<std::size_t>(end)] + (r * cosine) * x + (r * sine) * y,
                    1 + end * cap_points + k, 1 + k, share, -1, lies ? end : -1, cosine, sine});
  };
  if (std::abs(along) < steep) {
    for (int end = 0; end < 2; ++end) add(end, 0, 1, 0, 0.5);
    return;
  }
  constexpr double diagonal = 0.70710678118654752440;
  constexpr double angles[cap_points][2] = {{1, 0},  {diagonal, diagonal},   {0, 1},  {-diagonal, diagonal},
                                            {-1, 0}, {-diagonal, -diagonal}, {0, -1}, {diagonal, -diagonal}};
  const int end = along > 0 ? 0 : 1;
  for (int i = 0; i < cap_points; ++i) {  // counterclockwise, seen from outside
    const int k = end == 1 ? i : (cap_points - i) % cap_points;
    add(end, k, angles[k][0], angles[k][1], cap_share(k, tilt));
  }
}

}  // namespace

void ConvexNow::place(const ConvexShape& of, const RigidFrame<double>& at) {
  shape = &of;
  frame = at;
  const auto out = [&](const Vec3<double>& point) { return at.position + at.rotation * point; };
  corners.clear();
  normals.clear();
  offsets.clear();
  box = {};
  for (const Vec3<double>& c : of.corners) corners.push_back(out(c));
  for (const ConvexFace& f : of.faces) {
    normals.push_back(at.rotation * f.normal);
    offsets.push_back(f.offset + dot(normals.back(), at.position));
  }
  centre = out(of.centre);
  if (of.kind == ConvexKind::capsule || of.kind == ConvexKind::cylinder) {
    axis = corners[1] - corners[0];
    length = norm(axis);
    axis = (1 / length) * axis;
  }
  const bool is_cylinder = of.kind == ConvexKind::cylinder;
  for (std::size_t c = 0; c < (is_cylinder ? 2 : corners.size()); ++c) box.add(corners[c]);
  for (int i = 0; i < 3; ++i) {
    const double r = is_cylinder ? of.radius * std::sqrt(std::max(0.0, 1 - axis[i] * axis[i])) : of.rounding();
    box.lower[i] -= r;
    box.upper[i] += r;
  }
}

double ConvexNow::lowest(const Vec3<double>& n) const {
  if (shape->kind == ConvexKind::cylinder) {
    const double along = dot(n, axis);
    return std::min(dot(n, corners[0]), dot(n, corners[1])) -
           shape->radius * std::sqrt(std::max(0.0, 1 - along * along));
  }
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3<double>& c : corners) least = std::min(least, dot(n, c));
  return least - shape->rounding();
}

void lowest_feet(const ConvexNow& now, const Vec3<double>& normal, std::vector<Foot>& feet) {
  feet.clear();
  const ConvexShape& shape = *now.shape;
  if (shape.kind == ConvexKind::cylinder) return feet_of_cylinder(now, normal, feet);
  if (shape.kind != ConvexKind::polytope) {
    for (int c = 0; c < static_cast<int>(now.corners.size()); ++c)
      feet.push_back(
          {now.corners[static_cast<std::size_t>(c)], 1 + c, 1 + c, 1.0 / static_cast<double>(now.corners.size()), c});
    return;
  }
  std::size_t corner = 0;
  for (std::size_t c = 1; c < now.corners.size(); ++c)
    if (dot(now.corners[c], normal) < dot(now.corners[corner], normal)) corner = c;
  std::size_t lowest = shape.faces.size();
  for (std::size_t f = 0; f < shape.faces.size(); ++f) {
    const std::vector<int>& around = shape.faces[f].corners;
    if (std::ranges::find(around, static_cast<int>(corner)) == around.end()) continue;
    if (lowest == shape.faces.size() || dot(now.normals[f], normal) < dot(now.normals[lowest], normal)) lowest = f;
  }
  const ConvexFace& face = shape.faces[lowest];
  for (std::size_t k = 0; k < face.corners.size(); ++k) {
    const int c = face.corners[k];
    feet.push_back({now.corners[static_cast<std::size_t>(c)], 1 + c, 1 + c, face.shares[k], c});
  }
}

ConvexTouch touch_of(const Foot& foot, const ConvexNow& shape, const Vec3<double>& local_normal,
                     const Vec3<double>& local_point) {
  ConvexTouch t;
  t.key = foot.key;
  t.share = foot.share;
  t.at1 = local_point;
  t.along1 = local_normal;
  if (foot.rim >= 0) {
    t.kind = ConvexTouch::Kind::rim_plane;
    t.at0 = shape.shape->corners[static_cast<std::size_t>(foot.rim)];
    t.along0 = shape.inward(shape.axis);
    t.radius0 = shape.shape->radius;
    t.cosine = foot.cosine;
    t.sine = foot.sine;
    return t;
  }
  t.at0 = foot.corner >= 0 ? shape.shape->corners[static_cast<std::size_t>(foot.corner)] : shape.into(foot.place);
  t.radius0 = shape.shape->rounding();
  return t;
}

LinePair nearest_of_lines(const Vec3<double>& x0, const Vec3<double>& d0, const Vec3<double>& x1,
                          const Vec3<double>& d1) {
  const Vec3<double> across = cross(d0, d1), span = x1 - x0;
  const double square = dot(across, across);
  if (!(square > 0)) return {};
  return {dot(cross(span, d1), across) / square, dot(cross(span, d0), across) / square, std::sqrt(square)};
}

void ConvexPairs::with_plane(const ConvexNow& shape, const Vec3<double>& normal, const Vec3<double>& point,
                             const RigidFrame<double>& owner, std::vector<ConvexTouch>& found) {
  const double level = dot(normal, point);
  if (!(shape.lowest(normal) < level)) return;
  lowest_feet(shape, normal, feet_);
  const Vec3<double> local_normal = transposed_times(owner.rotation, normal),
                     local_point = transposed_times(owner.rotation, point - owner.position);
  for (const Foot& foot : feet_)
    if (dot(normal, foot.place) - shape.shape->rounding() < level)
      found.push_back(touch_of(foot, shape, local_normal, local_point));
}

double ConvexPairs::clearance(const ConvexNow& shape, const Vec3<double>& normal, const Vec3<double>& point) {
  double least = std::numeric_limits<double>::infinity();
  lowest_feet(shape, normal, feet_);
  for (const Foot& foot : feet_) {
    const double height = dot(normal, foot.place - point) - shape.shape->rounding();
    if (height >= 0) least = std::min(least, height);
  }
  return least;
}

// Clips by the sides of a face, one after the other. A shape with only two points is a line.
void ConvexPairs::clip(const ConvexNow& base, int face) {
  const ConvexFace& f = base.shape->faces[static_cast<std::size_t>(face)];
  const Vec3<double>& normal = base.normals[static_cast<std::size_t>(face)];
  const bool is_line = feet_.size() == 2;
  bool cut = false;
  for (std::size_t k = 0; k < f.corners.size() && !feet_.empty(); ++k) {
    const Vec3<double>&begin = base.corners[static_cast<std::size_t>(f.corners[k])],
          &end = base.corners[static_cast<std::size_t>(f.corners[(k + 1) % f.corners.size()])];
    const Vec3<double> inward = cross(normal, end - begin);
    const int side = static_cast<int>(k) + 1;
    kept_.clear();
    for (std::size_t i = 0; i < feet_.size(); ++i) {
      const Foot &a = feet_[i], &b = feet_[(i + 1) % feet_.size()];
      const double from = dot(inward, a.place - begin), to = dot(inward, b.place - begin);
      if (from >= 0)
        kept_.push_back(a);
      else
        cut = true;
      if ((from >= 0) == (to >= 0) || (is_line && i == 1)) continue;
      Foot crossing = a;
      crossing.place = a.place + (from / (from - to)) * (b.place - a.place);
      crossing.key = (a.edge + convex_keys::edges) * 2 * convex_keys::edges + side;
      crossing.edge = from >= 0 ? -side : a.edge;
      crossing.corner = crossing.rim = -1;
      kept_.push_back(crossing);
    }
    feet_.swap(kept_);
  }
  if (!cut) return;
  if (feet_.size() == 1) {
    feet_[0].share = 0.5;  // endpoints of the remaining line
    return;
  }
  polygon_.clear();
  for (const Foot& foot : feet_) polygon_.push_back(foot.place);
  find_corner_shares(polygon_, -normal, shares_);
  for (std::size_t i = 0; i < feet_.size(); ++i) feet_[i].share = shares_[i];
}

void ConvexPairs::lowest_on_face(const ConvexNow& base, int face, const ConvexNow& other, bool swapped,
                                 std::vector<ConvexTouch>& found) {
  const auto f = static_cast<std::size_t>(face);
  lowest_feet(other, base.normals[f], feet_);
  const auto lowest =
      std::ranges::min_element(feet_, {}, [&](const Foot& foot) { return dot(base.normals[f], foot.place); });
  ConvexTouch t = touch_of(*lowest, other, base.shape->faces[f].normal,
                           base.shape->corners[static_cast<std::size_t>(base.shape->faces[f].corners[0])]);
  t.share = share_of_edges(base, other);
  t.swapped = swapped;
  if (swapped) t.key += convex_keys::second_owner;
  found.push_back(t);
}

// The other shape rests on a face of the base: with all of its points over the face, if at least one is in contact.
void ConvexPairs::faces(const ConvexNow& base, int face, const ConvexNow& other, bool swapped,
                        std::vector<ConvexTouch>& found) {
  const auto f = static_cast<std::size_t>(face);
  const Vec3<double>& normal = base.normals[f];
  lowest_feet(other, normal, feet_);
  clip(base, face);
  const Vec3<double>& local_normal = base.shape->faces[f].normal;
  const Vec3<double>& local_point = base.shape->corners[static_cast<std::size_t>(base.shape->faces[f].corners[0])];
  const auto overlaps = [&](const Foot& foot) {
    return dot(normal, foot.place) - other.shape->rounding() < base.offsets[f];
  };
  if (std::ranges::none_of(feet_, overlaps)) return;
  for (const Foot& foot : feet_) {
    ConvexTouch t = touch_of(foot, other, local_normal, local_point);
    t.swapped = swapped;
    if (swapped) t.key += convex_keys::second_owner;
    found.push_back(t);
  }
}

bool is_as_deep(const std::vector<ConvexTouch>& found, std::size_t begin, const ConvexNow& first,
                const ConvexNow& second, double depth) {
  // new contacts belong to the face
  const double enough = 0.99 * depth - 1e-9 * std::max(first.shape->bound, second.shape->bound);
  return enough <= 0 ||
         std::any_of(found.begin() + static_cast<std::ptrdiff_t>(begin), found.end(),
                     [&](const ConvexTouch& t) { return -meeting_of(t, first.frame, second.frame).gap >= enough; });
}

ConvexPairs::Overlap ConvexPairs::overlap(const ConvexNow& a, const ConvexNow& b, Overlap& of_faces) const {
  Overlap best;
  const auto best_face = [](const ConvexNow& base, const ConvexNow& other, int& face) {
    double depth = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < base.normals.size() && depth > 0; ++f) {
      const double here = base.offsets[f] - other.lowest(base.normals[f]);
      if (here >= depth) continue;
      depth = here;
      face = static_cast<int>(f);
    }
    return depth;
  };
  int face_a = -1, face_b = -1;
  const double depth_a = best_face(a, b, face_a);
  if (!(depth_a > 0)) return best;
  const double depth_b = best_face(b, a, face_b);
  if (!(depth_b > 0)) return best;
  const double size = std::max(a.shape->bound, b.shape->bound);
  if (depth_a <= depth_b * (1 + face_advantage) + 1e-9 * size) {
    best = {depth_a, a.normals[static_cast<std::size_t>(face_a)], face_a, -1, -1, -1};
  } else {
    best = {depth_b, -b.normals[static_cast<std::size_t>(face_b)], -1, face_b, -1, -1};
  }
  of_faces = best;
  for (std::size_t i = 0; i < a.shape->edges.size(); ++i) {
    const ConvexEdge& ea = a.shape->edges[i];
    const Vec3<double>&a0 = a.normals[static_cast<std::size_t>(ea.left)],
          &a1 = a.normals[static_cast<std::size_t>(ea.right)];
    const Vec3<double>& from_a = a.corners[static_cast<std::size_t>(ea.begin)];
    const Vec3<double> da = a.corners[static_cast<std::size_t>(ea.end)] - from_a, across_a = cross(a1, a0);
    for (std::size_t k = 0; k < b.shape->edges.size(); ++k) {
      const ConvexEdge& eb = b.shape->edges[k];
      const Vec3<double> b0 = -b.normals[static_cast<std::size_t>(eb.left)],
                         b1 = -b.normals[static_cast<std::size_t>(eb.right)];
      const double c0 = dot(b0, across_a), c1 = dot(b1, across_a);
      if (!(c0 * c1 < 0)) continue;
      const Vec3<double> across_b = cross(b1, b0);
      const double c2 = dot(a0, across_b), c3 = dot(a1, across_b);
      if (!(c2 * c3 < 0) || !(c0 * c3 > 0)) continue;
      const Vec3<double>& from_b = b.corners[static_cast<std::size_t>(eb.begin)];
      const Vec3<double> db = b.corners[static_cast<std::size_t>(eb.end)] - from_b;
      Vec3<double> normal = cross(da, db);
      const double length = norm(normal);
      if (!(length > 1e-9 * norm(da) * norm(db))) continue;
      normal = ((dot(normal, a0 + a1) > 0 ? 1 : -1) / length) * normal;
      const double depth = dot(normal, from_a - from_b);
      if (depth <= 0) return {};
      if (depth < best.depth) best = {depth, normal, -1, -1, static_cast<int>(i), static_cast<int>(k)};
    }
  }
  return best;
}

void ConvexPairs::between(const ConvexNow& a, const ConvexNow& b, std::vector<ConvexTouch>& found) {
  if (!a.box.overlaps(b.box)) return;
  const ConvexKind ka = a.shape->kind, kb = b.shape->kind;
  if (ka == ConvexKind::ball) return ball(a, b, false, 1, 0, found);
  if (kb == ConvexKind::ball) return ball(b, a, true, 1, 0, found);
  if (ka == ConvexKind::capsule && kb == ConvexKind::capsule) return capsules(a, b, found);
  if (ka == ConvexKind::capsule) return capsule_on_faces(a, b, false, found);
  if (kb == ConvexKind::capsule) return capsule_on_faces(b, a, true, found);
  if (ka == ConvexKind::cylinder && kb == ConvexKind::cylinder) return cylinders(a, b, found);
  if (ka == ConvexKind::cylinder) return cylinder_and_polytope(a, b, false, found);
  if (kb == ConvexKind::cylinder) return cylinder_and_polytope(b, a, true, found);
  polytopes(a, b, found);
}

// A face that is nearly perpendicular has priority: edges of two parallel faces cross at arbitrary positions.
void ConvexPairs::polytopes(const ConvexNow& a, const ConvexNow& b, std::vector<ConvexTouch>& found) {
  Overlap of_faces;
  const Overlap at = overlap(a, b, of_faces);
  if (!(at.depth > 0)) return;
  const std::size_t before = found.size();
  if (is_near_face(of_faces.normal, at.normal)) {
    if (of_faces.face_a >= 0)
      faces(a, of_faces.face_a, b, true, found);
    else
      faces(b, of_faces.face_b, a, false, found);
    if (is_as_deep(found, before, a, b, at.depth)) return;
    found.resize(before);
    if (at.face_a >= 0) return lowest_on_face(a, at.face_a, b, true, found);
    if (at.face_b >= 0) return lowest_on_face(b, at.face_b, a, false, found);
  }
  ConvexTouch t;
  const auto edge = [](const ConvexNow& shape, int number, Vec3<double>& point, Vec3<double>& direction) {
    const ConvexEdge& e = shape.shape->edges[static_cast<std::size_t>(number)];
    point = shape.shape->corners[static_cast<std::size_t>(e.begin)];
    direction = shape.shape->corners[static_cast<std::size_t>(e.end)] - point;
    direction = (1 / norm(direction)) * direction;
  };
  t.kind = ConvexTouch::Kind::lines;
  edge(a, at.edge_a, t.at0, t.along0);
  edge(b, at.edge_b, t.at1, t.along1);
  t.key = convex_keys::crossing + at.edge_a * convex_keys::edges + at.edge_b;
  t.cosine = dot(cross(a.frame.rotation * t.along0, b.frame.rotation * t.along1), at.normal) > 0 ? 1 : -1;
  t.share = share_of_edges(a, b);
  found.push_back(t);
}

}  // namespace dalembert
