// Balls, capsules and lateral surfaces of cylinders: curved surfaces have contact along the line to the nearest point
// of the other shape.
#include <algorithm>
#include <cmath>
#include <limits>

#include "dalembert/contact/convex_narrow.hpp"

namespace dalembert {
namespace {

using Kind = ConvexTouch::Kind;
constexpr double within = 1e-6;  // tolerance of a direction beyond the arc of an edge

// A point that is nearest on an edge, as a part of its length.
double part_of_edge(const Vec3<double>& point, const Vec3<double>& begin, const Vec3<double>& end) {
  return std::clamp(dot(point - begin, end - begin) / dot(end - begin, end - begin), 0.0, 1.0);
}

// Whether a direction leads away from an edge between the two faces that meet there.
bool in_arc(const ConvexNow& shape, const ConvexEdge& e, const Vec3<double>& away) {
  const Vec3<double> along =
      shape.corners[static_cast<std::size_t>(e.end)] - shape.corners[static_cast<std::size_t>(e.begin)];
  const Vec3<double> left = cross(shape.normals[static_cast<std::size_t>(e.left)], along),
                     right = cross(along, shape.normals[static_cast<std::size_t>(e.right)]);
  return dot(away, left) <= within * norm(left) && dot(away, right) <= within * norm(right);
}

// The face over which a point is; -1: none. `inside`: the one that is nearest from inside, if the point is within the polytope.
int face_below(const ConvexNow& p, const Vec3<double>& x, bool& inside) {
  double highest = -std::numeric_limits<double>::infinity();
  int best = -1;
  for (std::size_t f = 0; f < p.normals.size(); ++f) {
    const double height = dot(p.normals[f], x) - p.offsets[f];
    if (height <= highest) continue;
    highest = height;
    best = static_cast<int>(f);
  }
  inside = highest <= 0;
  if (inside) return best;
  for (std::size_t f = 0; f < p.normals.size(); ++f) {
    if (!(dot(p.normals[f], x) - p.offsets[f] > 0)) continue;
    const std::vector<int>& corners = p.shape->faces[f].corners;
    bool over = true;
    for (std::size_t k = 0; k < corners.size() && over; ++k) {
      const Vec3<double>&begin = p.corners[static_cast<std::size_t>(corners[k])],
            &end = p.corners[static_cast<std::size_t>(corners[(k + 1) % corners.size()])];
      over = dot(cross(p.normals[f], end - begin), x - begin) >= 0;
    }
    if (over) return static_cast<int>(f);
  }
  return -1;
}

ConvexTouch on_face(const ConvexNow& p, int face, const Vec3<double>& at, double r, double share, std::int64_t key) {
  const ConvexFace& f = p.shape->faces[static_cast<std::size_t>(face)];
  return round_touch(Kind::point_plane, at, r, p.shape->corners[static_cast<std::size_t>(f.corners[0])], f.normal, 0,
                     share, key);
}

// The nearest part of a polytope; false: it is farther than r.
bool ball_on_polytope(const Vec3<double>& x, const Vec3<double>& at, double r, const ConvexNow& p, double share,
                      std::int64_t key, ConvexTouch& touch) {
  bool inside = false;
  const int face = face_below(p, x, inside);
  if (face >= 0) {
    touch = on_face(p, face, at, r, share, key);
    return inside || dot(p.normals[static_cast<std::size_t>(face)], x) - p.offsets[static_cast<std::size_t>(face)] < r;
  }
  double nearest = r;
  bool found = false;
  for (const ConvexEdge& e : p.shape->edges) {
    const Vec3<double>&begin = p.corners[static_cast<std::size_t>(e.begin)],
          &end = p.corners[static_cast<std::size_t>(e.end)];
    const double part = part_of_edge(x, begin, end), distance = norm(x - (begin + part * (end - begin)));
    if (!(distance < nearest) || distance == 0) continue;
    nearest = distance;
    found = true;
    const Vec3<double>& local = p.shape->corners[static_cast<std::size_t>(part < 1 ? e.begin : e.end)];
    if (part > 0 && part < 1)
      touch =
          round_touch(Kind::point_line, at, r, local, p.inward((1 / norm(end - begin)) * (end - begin)), 0, share, key);
    else
      touch = round_touch(Kind::points, at, r, local, {}, 0, share, key);
  }
  return found;
}

bool ball_on_cylinder(const Vec3<double>& x, const Vec3<double>& at, double r, const ConvexNow& c, double share,
                      std::int64_t key, ConvexTouch& touch) {
  const Vec3<double>& local = c.shape->corners[0];
  const Vec3<double> axis = c.inward(c.axis), to = x - c.corners[0];
  const double along = dot(to, c.axis), aside = norm(to - along * c.axis), radius = c.shape->radius,
               beyond = std::max(-along, along - c.length);
  const bool over_cap = aside <= radius && (beyond > 0 || -beyond < radius - aside);
  if (over_cap) {
    const bool top = along > 0.5 * c.length;
    touch = round_touch(Kind::point_plane, at, r, c.shape->corners[top ? 1 : 0], top ? axis : -axis, 0, share, key);
    return beyond < r;
  }
  if (beyond <= 0) {
    touch = round_touch(Kind::point_line, at, r, local, axis, radius, share, key);
    return aside < r + radius;
  }
  touch = round_touch(Kind::point_rim, at, r, c.shape->corners[along > 0 ? 1 : 0], axis, radius, share, key);
  return std::hypot(beyond, aside - radius) < r;
}

bool ball_on_capsule(const Vec3<double>& x, const Vec3<double>& at, double r, const ConvexNow& c, double share,
                     std::int64_t key, ConvexTouch& touch) {
  const double part = part_of_edge(x, c.corners[0], c.corners[1]), radius = c.shape->radius;
  const double distance = norm(x - (c.corners[0] + part * (c.corners[1] - c.corners[0])));
  if (part > 0 && part < 1)
    touch = round_touch(Kind::point_line, at, r, c.shape->corners[0], c.inward(c.axis), radius, share, key);
  else
    touch = round_touch(Kind::points, at, r, c.shape->corners[part < 1 ? 0 : 1], {}, radius, share, key);
  return distance < r + radius && distance > 0;
}

}  // namespace

ConvexTouch round_touch(ConvexTouch::Kind kind, const Vec3<double>& at, double radius, const Vec3<double>& at1,
                        const Vec3<double>& along1, double radius1, double share, std::int64_t key) {
  ConvexTouch t;
  t.kind = kind;
  t.at0 = at;
  t.at1 = at1;
  t.along1 = along1;
  t.radius0 = radius;
  t.radius1 = radius1;
  t.share = share;
  t.key = key;
  return t;
}

ConvexTouch line_touch(const ConvexNow& a, const Vec3<double>& at0, const Vec3<double>& along0, double radius0,
                       const ConvexNow& b, const Vec3<double>& at1, const Vec3<double>& along1, double radius1,
                       const Vec3<double>& normal, double share, std::int64_t key) {
  ConvexTouch t = round_touch(Kind::lines, a.into(at0), radius0, b.into(at1), b.inward(along1), radius1, share, key);
  t.along0 = a.inward(along0);
  t.cosine = dot(cross(along0, along1), normal) > 0 ? 1 : -1;
  return t;
}

void ConvexPairs::ball(const ConvexNow& ball, const ConvexNow& other, bool swapped, double share, std::int64_t key,
                       std::vector<ConvexTouch>& found, int end) const {
  const Vec3<double>&x = ball.corners[static_cast<std::size_t>(end)],
        &at = ball.shape->corners[static_cast<std::size_t>(end)];
  const double r = ball.shape->radius;
  ConvexTouch touch;
  bool touches = false;
  if (other.shape->kind == ConvexKind::polytope)
    touches = ball_on_polytope(x, at, r, other, share, key, touch);
  else if (other.shape->kind == ConvexKind::cylinder)
    touches = ball_on_cylinder(x, at, r, other, share, key, touch);
  else if (other.shape->kind == ConvexKind::capsule)
    touches = ball_on_capsule(x, at, r, other, share, key, touch);
  if (!touches) return;
  touch.swapped = swapped;
  found.push_back(touch);
}

// Crossing capsules have one contact point; parallel ones have two, at the ends of the common part. Each point has
// half of the stiffness.
void ConvexPairs::capsules(const ConvexNow& a, const ConvexNow& b, std::vector<ConvexTouch>& found) const {
  const LinePair lines = nearest_of_lines(a.corners[0], a.axis, b.corners[0], b.axis);
  if (lines.sine > parallel && lines.s > 0 && lines.s < a.length && lines.t > 0 && lines.t < b.length) {
    const Vec3<double> span = b.corners[0] + lines.t * b.axis - (a.corners[0] + lines.s * a.axis);
    if (!(norm(span) < a.shape->radius + b.shape->radius) || norm(span) == 0) return;
    found.push_back(line_touch(a, a.corners[0], a.axis, a.shape->radius, b, b.corners[0], b.axis, b.shape->radius, span,
                               0.5, convex_keys::mantle));
    return;
  }
  for (int end = 0; end < 2; ++end) ball(a, b, false, 0.5, 1 + end, found, end);
  for (int end = 0; end < 2; ++end) {
    ball(b, a, true, 0.5, 3 + end, found, end);
    if (!found.empty() && found.back().swapped && found.back().key == 3 + end && found.back().kind == Kind::points)
      found.pop_back();  // two ends: found from the other side
  }
}

// Its ends are balls with half of the stiffness each; its lateral surface is between them.
void ConvexPairs::capsule_on_faces(const ConvexNow& capsule, const ConvexNow& other, bool swapped,
                                   std::vector<ConvexTouch>& found) const {
  for (int end = 0; end < 2; ++end) ball(capsule, other, swapped, 0.5, 1 + end, found, end);
  if (other.shape->kind == ConvexKind::cylinder) {
    const LinePair lines = nearest_of_lines(capsule.corners[0], capsule.axis, other.corners[0], other.axis);
    const Vec3<double> span = other.corners[0] + lines.t * other.axis - (capsule.corners[0] + lines.s * capsule.axis);
    const double distance = norm(span), r0 = capsule.shape->radius, r1 = other.shape->radius;
    if (lines.sine > parallel && lines.s > 0 && lines.s < capsule.length && lines.t > 0 && lines.t < other.length &&
        distance < r0 + r1 && distance > 0) {
      found.push_back(line_touch(capsule, capsule.corners[0], capsule.axis, r0, other, other.corners[0], other.axis, r1,
                                 span, 0.5, convex_keys::mantle));
      found.back().swapped = swapped;
    }
    return capsule_on_rims(capsule, other, swapped, found);
  }
  mantle_on_edges(capsule, other, swapped, found);
  mantle_on_corners(capsule, other, swapped, found);
}

// A lateral surface crosses an edge at one point; if it is parallel to an edge, the points are the ends of the common
// part.
void ConvexPairs::mantle_on_edges(const ConvexNow& round, const ConvexNow& other, bool swapped,
                                  std::vector<ConvexTouch>& found) const {
  const double r = round.shape->radius;
  const std::vector<ConvexEdge>& edges = other.shape->edges;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Vec3<double>&begin = other.corners[static_cast<std::size_t>(edges[k].begin)],
          &end = other.corners[static_cast<std::size_t>(edges[k].end)];
    const double length = norm(end - begin);
    const Vec3<double> along = (1 / length) * (end - begin);
    const auto touches = [&](const Vec3<double>& away) {
      const double distance = norm(away);
      return distance < r && distance > 0 && in_arc(other, edges[k], (1 / distance) * away);
    };
    const std::int64_t key = convex_keys::mantle + 3 * static_cast<std::int64_t>(k) + 1;
    const LinePair lines = nearest_of_lines(round.corners[0], round.axis, begin, along);
    if (lines.sine > parallel) {
      if (!(lines.s > 0 && lines.s < round.length && lines.t > 0 && lines.t < length)) continue;
      const Vec3<double> away = round.corners[0] + lines.s * round.axis - (begin + lines.t * along);
      if (!touches(away)) continue;
      found.push_back(line_touch(round, round.corners[0], round.axis, r, other, begin, along, 0, -away, 0.5, key));
      found.back().swapped = swapped;
      continue;
    }
    if (round.shape->kind == ConvexKind::capsule) continue;  // its ends have found it
    const double from = dot(round.corners[0] - begin, along), to = dot(round.corners[1] - begin, along);
    const double first = std::max(0.0, std::min(from, to)), last = std::min(length, std::max(from, to));
    for (const double part : {first, last}) {
      const Vec3<double> place = begin + part * along, over = round.corners[0] - place;
      if (!(first < last) || !touches(over - dot(over, round.axis) * round.axis)) continue;
      found.push_back(round_touch(Kind::point_line, other.into(place), 0, round.shape->corners[0],
                                  round.inward(round.axis), r, 0.5, key + (part == first ? 1 : 2)));
      found.back().swapped = !swapped;
    }
  }
}

void ConvexPairs::mantle_on_corners(const ConvexNow& round, const ConvexNow& other, bool swapped,
                                    std::vector<ConvexTouch>& found) const {
  for (std::size_t c = 0; c < other.corners.size(); ++c) {
    const Vec3<double>& corner = other.corners[c];
    const double along = dot(corner - round.corners[0], round.axis);
    const Vec3<double> away = round.corners[0] + along * round.axis - corner;
    const double distance = norm(away);
    if (!(along > 0 && along < round.length) || !(distance < round.shape->radius) || distance == 0) continue;
    const bool nearest = std::ranges::all_of(other.shape->edges, [&](const ConvexEdge& e) {
      const int here = static_cast<int>(c);
      if (e.begin != here && e.end != here) return true;
      const Vec3<double> edge = other.corners[static_cast<std::size_t>(e.begin == here ? e.end : e.begin)] - corner;
      return dot(edge, away) < 0;
    });
    if (!nearest) continue;
    found.push_back(round_touch(Kind::point_line, other.shape->corners[c], 0, round.shape->corners[0],
                                round.inward(round.axis), round.shape->radius, 0.5,
                                convex_keys::on_mantle + static_cast<std::int64_t>(c)));
    found.back().swapped = !swapped;
  }
}

// Crossing surfaces have one contact point, parallel ones have two, at the ends of the common part.
void ConvexPairs::mantles(const ConvexNow& a, const ConvexNow& b, std::vector<ConvexTouch>& found) const {
  const double reach = a.shape->radius + b.shape->radius;
  const LinePair lines = nearest_of_lines(a.corners[0], a.axis, b.corners[0], b.axis);
  if (lines.sine > parallel) {
    const Vec3<double> span = b.corners[0] + lines.t * b.axis - (a.corners[0] + lines.s * a.axis);
    const double distance = norm(span);
    if (!(lines.s > 0 && lines.s < a.length && lines.t > 0 && lines.t < b.length) || distance == 0 ||
        !(distance < reach))
      return;
    found.push_back(line_touch(a, a.corners[0], a.axis, a.shape->radius, b, b.corners[0], b.axis, b.shape->radius, span,
                               0.5, convex_keys::mantle));
    return;
  }
  const double from = dot(b.corners[0] - a.corners[0], a.axis), to = dot(b.corners[1] - a.corners[0], a.axis);
  const double begin = std::max(0.0, std::min(from, to)), end = std::min(a.length, std::max(from, to));
  if (!(begin < end)) return;
  for (const double part : {begin, end}) {
    const Vec3<double> place = a.corners[0] + part * a.axis, over = place - b.corners[0];
    const double distance = norm(over - dot(over, b.axis) * b.axis);
    if (distance < reach && distance > 0)
      found.push_back(round_touch(Kind::point_line, a.into(place), a.shape->radius, b.shape->corners[0],
                                  b.inward(b.axis), b.shape->radius, 0.5, part == begin ? 1 : 2));
  }
}

}  // namespace dalembert
