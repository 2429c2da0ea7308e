#include "dalembert/contact/convex_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace dalembert {
namespace {

using Kind = ConvexTouch::Kind;
constexpr double blunt = 1e-4;   // sine of the angle between triangles up to which an edge does not stick out
constexpr double slack = 0.02;  // tolerance of directions beyond the arc of an edge

using Place = std::array<double, 3>;
Place place_of(const Vec3<double>& p) { return {p[0] + 0.0, p[1] + 0.0, p[2] + 0.0}; }  // no negative zero

std::int64_t edge_key(int number) { return convex_keys::mesh_edge + number * convex_keys::edges; }

struct Side {
  int triangle = -1;
  std::size_t edge = 0;
};

}  // namespace

void ConvexMesh::build(const std::vector<int>& members, const std::vector<Triangle>& all,
                       const std::vector<Facet>& facets) {
  edges_.clear();
  corners_.clear();
  std::map<std::pair<Place, Place>, std::vector<Side>> sides;
  for (const int t : members)
    for (std::size_t k = 0; k < 3; ++k) {
      Place a = place_of(all[static_cast<std::size_t>(t)][k]),
            b = place_of(all[static_cast<std::size_t>(t)][(k + 1) % 3]);
      if (b < a) std::swap(a, b);
      sides[{a, b}].push_back({t, k});
    }
  std::map<Place, std::vector<Vec3<double>>> ends;  // directions of protruding edges at a position
  std::vector<std::pair<int, int>> owners;            // triangle and number
  for (const auto& [ab, around] : sides) {
    const Vec3<double> a{ab.first[0], ab.first[1], ab.first[2]}, b{ab.second[0], ab.second[1], ab.second[2]};
    const auto facet = [&](std::size_t i) -> const Facet& {
      return facets[static_cast<std::size_t>(around[i].triangle)];
    };
    const std::size_t last = around.size() == 2 ? 1 : 0;
    // The other triangle falls away from the plane of the first one.
    if (last == 1 && !(dot(facet(0).normal, facet(1).inward[around[1].edge]) < -blunt)) continue;
    Edge edge{a,
              direction(b - a),
              norm(b - a),
              {facet(0).inward[around[0].edge], facet(last).inward[around[last].edge]},
              {facet(0).normal, facet(last).normal}};
    owners.emplace_back(around[0].triangle, static_cast<int>(edges_.size()));
    edges_.push_back(edge);
    ends[ab.first].push_back(edge.along);
    ends[ab.second].push_back(-edge.along);
  }
  const auto list = [&](std::vector<std::size_t>& first, std::vector<int>& numbers) {
    std::ranges::sort(owners);
    first.assign(all.size() + 1, 0);
    numbers.clear();
    for (const auto& [triangle, number] : owners) {
      ++first[static_cast<std::size_t>(triangle) + 1];
      numbers.push_back(number);
    }
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  };
  list(first_edge_, edge_list_);
  owners.clear();
  std::map<Place, std::pair<int, Corner>> around;
  for (const int t : members)
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle& corners = all[static_cast<std::size_t>(t)];
      const auto ways = ends.find(place_of(corners[k]));
      if (ways == ends.end()) continue;
      if (ways->second.size() == 2 && dot(ways->second[0], ways->second[1]) < -1 + 1e-9)
        continue;  // within a straight edge
      auto [at, is_new] = around.try_emplace(place_of(corners[k]), t, Corner{corners[k], {}, {}});
      at->second.first = std::min(at->second.first, t);
      at->second.second.normal += facets[static_cast<std::size_t>(t)].normal;
      at->second.second.edges.push_back(direction(corners[(k + 1) % 3] - corners[k]));
      at->second.second.edges.push_back(direction(corners[(k + 2) % 3] - corners[k]));
    }
  for (const auto& [place, corner] : around) {
    if (norm(corner.second.normal) < blunt) continue;
    owners.emplace_back(corner.first, static_cast<int>(corners_.size()));
    corners_.push_back(corner.second);
    corners_.back().normal = direction(corner.second.normal);
  }
  list(first_corner_, corner_list_);
}

// A corner that is below several triangles stands on the one that it is least deep in.
void ConvexMesh::on_facet(const ConvexNow& shape, const Facet& facet, Scratch& scratch) {
  if (!(facet.height(shape.centre) > 0) || !(shape.lowest(facet.normal) < dot(facet.normal, facet.corner))) return;
  lowest_feet(shape, facet.normal, scratch.feet);
  std::vector<Candidate>& candidates = scratch.candidates;
  const double r = shape.shape->rounding(), least = -1e-9 * shape.shape->bound;
  for (const Foot& foot : scratch.feet) {
    const double depth = r - facet.height(foot.place);
    if (!(depth > 0) || facet.within_edges(foot.place) < least) continue;
    const auto known = std::ranges::find(candidates, foot.key, &Candidate::key);
    const Candidate here{foot.key, depth, touch_of(foot, shape, facet.normal, facet.corner)};
    if (known == candidates.end())
      candidates.push_back(here);
    else if (depth < known->depth)
      *known = here;
  }
}

void ConvexMesh::on_edge(const ConvexNow& shape, const Edge& edge, int number, std::vector<ConvexTouch>& found) const {
  double deepest = shape.shape->bound;  // it leaves one of the triangles on the shortest way
  for (const Vec3<double>& normal : edge.normal)
    deepest = std::min(deepest, 1.001 * (dot(normal, edge.begin) - shape.lowest(normal)));
  if (!(deepest > 0)) return;
  if (shape.shape->kind == ConvexKind::cylinder) return rims_on_edge(shape, edge, number, deepest, found);
  for (std::size_t k = 0; k < shape.shape->edges.size(); ++k) {
    const ConvexEdge& e = shape.shape->edges[k];
    const Vec3<double>&begin = shape.corners[static_cast<std::size_t>(e.begin)],
          &end = shape.corners[static_cast<std::size_t>(e.end)];
    const double length = norm(end - begin);
    const Vec3<double> along = (1 / length) * (end - begin);
    const LinePair lines = nearest_of_lines(begin, along, edge.begin, edge.along);
    if (!(lines.sine > 1e-6) || !(lines.s > 0 && lines.s < length && lines.t > 0 && lines.t < edge.length)) continue;
    Vec3<double> up = direction(cross(along, edge.along));
    if (dot(up, edge.normal[0] + edge.normal[1]) < 0) up = -up;
    const double gap = dot(up, begin + lines.s * along - (edge.begin + lines.t * edge.along));
    if (!(gap < 0) || gap < -deepest || dot(up, edge.inward[0]) > slack || dot(up, edge.inward[1]) > slack) continue;
    const Vec3<double> left = direction(cross(shape.normals[static_cast<std::size_t>(e.left)], along)),
                       right = direction(cross(along, shape.normals[static_cast<std::size_t>(e.right)]));
    if (dot(-up, left) > slack || dot(-up, right) > slack) continue;
    ConvexTouch t;
    t.kind = Kind::lines;
    t.at0 = shape.into(begin);
    t.along0 = shape.inward(along);
    t.at1 = edge.begin;
    t.along1 = edge.along;
    t.cosine = dot(cross(along, edge.along), up) < 0 ? 1 : -1;  // towards the mesh
    t.share = shape.shape->lone;
    t.key = edge_key(number) + static_cast<std::int64_t>(k);
    found.push_back(t);
  }
}

void ConvexMesh::rims_on_edge(const ConvexNow& shape, const Edge& edge, int number, double deepest,
                              std::vector<ConvexTouch>& found) {
  const bool is_border = edge.normal[0] == edge.normal[1];
  const double whole = angle_around(edge.along, -edge.normal[0], is_border ? edge.inward[0] : -edge.normal[1]),
               more = whole < 0 ? -slack : slack;
  const Vec3<double> from = std::cos(more) * -edge.normal[0] - std::sin(more) * cross(edge.along, -edge.normal[0]);
  for (int end = 0; end < 2; ++end) {
    const Rim<double> rim = rim_of(shape, end);
    each_least_overlap(rim, edge.begin, edge.along, from, whole + 2 * more, [&](const Vec3<double>& u) {
      const Vec3<double> place = rim.centre + rim.radius * rim.reach(u).out - edge.begin;
      const double depth = dot(u, place), along = dot(place, edge.along);
      if (!(dot(u, rim.axis) > 0 && depth > 0 && depth <= deepest && along > 0 && along < edge.length)) return;
      found.push_back(
          rim_touch(shape, end, edge.begin, edge.along, 0, u, shape.shape->lone, edge_key(number) + 3 + end));
    });
  }
}

// Mantles of capsules and cylinders, and ends of capsules.
void ConvexMesh::round_on_edge(const ConvexNow& shape, const Edge& edge, int number,
                               std::vector<ConvexTouch>& found) const {
  const double r = shape.shape->radius;
  const auto away = [&](const Vec3<double>& from) {
    const double distance = norm(from);
    return distance < r && distance > 0 && dot(from, edge.inward[0]) <= slack * distance &&
           dot(from, edge.inward[1]) <= slack * distance && dot(from, edge.normal[0] + edge.normal[1]) > 0;
  };
  const LinePair lines = nearest_of_lines(shape.corners[0], shape.axis, edge.begin, edge.along);
  if (lines.sine > 1e-6 && lines.s > 0 && lines.s < shape.length && lines.t > 0 && lines.t < edge.length) {
    const Vec3<double> up = shape.corners[0] + lines.s * shape.axis - (edge.begin + lines.t * edge.along);
    if (away(up)) {
      ConvexTouch t;
      t.kind = Kind::lines;
      t.at0 = shape.shape->corners[0];
      t.along0 = shape.inward(shape.axis);
      t.radius0 = r;
      t.at1 = edge.begin;
      t.along1 = edge.along;
      t.cosine = dot(cross(shape.axis, edge.along), up) < 0 ? 1 : -1;
      t.share = shape.shape->lone;
      t.key = edge_key(number);
      found.push_back(t);
    }
  }
  if (shape.shape->kind != ConvexKind::capsule) return;
  for (int end = 0; end < 2; ++end) {
    const Vec3<double>& x = shape.corners[static_cast<std::size_t>(end)];
    const double part = dot(x - edge.begin, edge.along);
    const Vec3<double> up = x - (edge.begin + part * edge.along);
    if (!(part > 0 && part < edge.length) || !away(up) || dot(up, edge.inward[0]) > -1e-9 * r ||
        dot(up, edge.inward[1]) > -1e-9 * r)
      continue;  // else over a face
    ConvexTouch t;
    t.kind = Kind::point_line;
    t.at0 = shape.shape->corners[static_cast<std::size_t>(end)];
    t.radius0 = r;
    t.at1 = edge.begin;
    t.along1 = edge.along;
    t.share = 0.5;
    t.key = edge_key(number) + 1 + end;
    found.push_back(t);
  }
}

void ConvexMesh::on_corner(const ConvexNow& shape, const Corner& corner, int number,
                           std::vector<ConvexTouch>& found) const {
  ConvexTouch t;
  t.swapped = true;  // the point is of the mesh
  t.at0 = corner.place;
  t.share = shape.shape->lone;
  t.key = convex_keys::mesh_corner + number;
  const double r = shape.shape->radius;
  if (shape.shape->kind == ConvexKind::polytope) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < shape.normals.size(); ++f) {
      const double depth = shape.offsets[f] - dot(shape.normals[f], corner.place);
      if (!(depth > 0)) return;
      if (depth >= least || dot(shape.normals[f], corner.normal) >= 0) continue;
      least = depth;
      t.along1 = shape.shape->faces[f].normal;
      t.at1 = shape.shape->corners[static_cast<std::size_t>(shape.shape->faces[f].corners[0])];
    }
    if (least < shape.shape->bound) found.push_back(t);
    return;
  }
  const double along = dot(corner.place - shape.corners[0], shape.axis);
  const Vec3<double> up = shape.corners[0] + along * shape.axis - corner.place;
  const double aside = norm(up);
  if (!(along > 0 && along < shape.length) || !(aside < r) || aside == 0) {
    if (shape.shape->kind != ConvexKind::capsule) return;
    for (int end = 0; end < 2; ++end) {
      const Vec3<double> from = shape.corners[static_cast<std::size_t>(end)] - corner.place;
      if (!(norm(from) < r) || norm(from) == 0 || dot(from, corner.normal) <= 0) continue;
      if (!std::ranges::all_of(corner.edges, [&](const Vec3<double>& e) { return dot(e, from) < 0; })) continue;
      t.swapped = false;
      t.kind = Kind::points;
      t.at0 = shape.shape->corners[static_cast<std::size_t>(end)];
      t.radius0 = r;
      t.at1 = corner.place;
      t.share = 0.5;
      found.push_back(t);
    }
    return;
  }
  const double beyond = std::min(along, shape.length - along);
  if (shape.shape->kind == ConvexKind::cylinder && beyond < r - aside) {
    const bool top = along > 0.5 * shape.length;
    if (dot(top ? shape.axis : -shape.axis, corner.normal) >= 0) return;
    t.at1 = shape.shape->corners[top ? 1 : 0];
    t.along1 = shape.inward(top ? shape.axis : -shape.axis);
    found.push_back(t);
    return;
  }
  if (dot(up, corner.normal) <= 0) return;
  if (shape.shape->kind == ConvexKind::capsule &&
      !std::ranges::all_of(corner.edges, [&](const Vec3<double>& e) { return dot(e, up) < slack * aside; }))
    return;
  t.kind = Kind::point_line;
  t.at1 = shape.shape->corners[0];
  t.along1 = shape.inward(shape.axis);
  t.radius1 = r;
  found.push_back(t);
}

void ConvexMesh::find(const ConvexNow& shape, std::span<const int> near, const std::vector<Triangle>& all,
                      const std::vector<Facet>& facets, Scratch& scratch, std::vector<ConvexTouch>& found) const {
  scratch.candidates.clear();
  const bool is_round = shape.shape->kind != ConvexKind::polytope;
  for (const int number : near) {
    const auto t = static_cast<std::size_t>(number);
    Box box;
    for (const Vec3<double>& point : all[t]) box.add(point);
    if (!shape.box.overlaps(box)) continue;
    on_facet(shape, facets[t], scratch);
    for (std::size_t k = first_edge_[t]; k < first_edge_[t + 1]; ++k) {
      const int e = edge_list_[k];
      if (is_round) round_on_edge(shape, edges_[static_cast<std::size_t>(e)], e, found);
      if (shape.shape->kind != ConvexKind::capsule) on_edge(shape, edges_[static_cast<std::size_t>(e)], e, found);
    }
    for (std::size_t k = first_corner_[t]; k < first_corner_[t + 1]; ++k)
      on_corner(shape, corners_[static_cast<std::size_t>(corner_list_[k])], corner_list_[k], found);
  }
  for (const Candidate& c : scratch.candidates) found.push_back(c.touch);
}

double ConvexMesh::clearance(const ConvexNow& shape, std::span<const int> near, const std::vector<Facet>& facets,
                             Scratch& scratch) {
  double least = std::numeric_limits<double>::infinity();
  for (const int number : near) {
    const Facet& facet = facets[static_cast<std::size_t>(number)];
    if (!(facet.height(shape.centre) > 0)) continue;
    lowest_feet(shape, facet.normal, scratch.feet);
    for (const Foot& foot : scratch.feet) {
      const double height = facet.height(foot.place) - shape.shape->rounding();
      if (height >= 0 && facet.within_edges(foot.place) >= 0) least = std::min(least, height);
    }
  }
  return least;
}

}  // namespace dalembert
