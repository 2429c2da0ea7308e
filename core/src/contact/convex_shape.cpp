#include "dalembert/contact/convex_shape.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace dalembert {
namespace {

constexpr int prism_sides = 32;
constexpr double flat = 1e-9;  // smaller sines and relative lengths count as zero

double size_of(const std::vector<Vec3<double>>& points) {
  double size = 0;
  for (const Vec3<double>& p : points) size = std::max(size, norm(p - points[0]));
  return size;
}

// Triangles in one plane make one face; its corners are sorted around their mean.
void add_faces(const ConvexDefinition& from, ConvexShape& shape) {
  const double size = size_of(from.points);
  std::vector<Vec3<double>> normals;
  std::vector<std::vector<int>> members;
  for (const auto& t : from.triangles) {
    const auto at = [&](std::size_t k) { return from.points[static_cast<std::size_t>(t[k])]; };
    const Vec3<double> area = cross(at(1) - at(0), at(2) - at(0));
    if (!(norm(area) > flat * size * size * 1e-3)) continue;
    const Vec3<double> normal = (1 / norm(area)) * area;
    std::size_t f = 0;
    for (; f < normals.size(); ++f)
      if (norm(normals[f] - normal) < 1e-6 &&
          std::abs(dot(normal, at(0) - from.points[static_cast<std::size_t>(members[f][0])])) < 1e-7 * size)
        break;
    if (f == normals.size()) {
      normals.push_back(normal);
      members.emplace_back();
    }
    members[f].insert(members[f].end(), t.begin(), t.end());
  }
  for (std::size_t f = 0; f < normals.size(); ++f) {
    std::vector<int>& corners = members[f];
    std::ranges::sort(corners);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    Vec3<double> mean;
    for (const int c : corners)
      mean += (1.0 / static_cast<double>(corners.size())) * from.points[static_cast<std::size_t>(c)];
    const Vec3<double> first = from.points[static_cast<std::size_t>(corners[0])] - mean,
                       second = cross(normals[f], first);
    std::ranges::sort(corners, {}, [&](int c) {
      const Vec3<double> to = from.points[static_cast<std::size_t>(c)] - mean;
      return std::atan2(dot(to, second), dot(to, first));
    });
    ConvexFace face{normals[f], dot(normals[f], mean), corners, {}};
    std::vector<Vec3<double>> polygon;
    for (const int c : corners) polygon.push_back(from.points[static_cast<std::size_t>(c)]);
    find_corner_shares(polygon, face.normal, face.shares);
    shape.faces.push_back(face);
  }
}

void add_edges(ConvexShape& shape) {
  std::map<std::pair<int, int>, int> known;
  for (std::size_t f = 0; f < shape.faces.size(); ++f) {
    const std::vector<int>& corners = shape.faces[f].corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const int a = corners[k], b = corners[(k + 1) % corners.size()];
      const auto other = known.find({b, a});
      if (other != known.end())
        shape.edges.push_back({b, a, other->second, static_cast<int>(f)});
      else
        known[{a, b}] = static_cast<int>(f);
    }
  }
  std::ranges::sort(shape.edges, {}, [](const ConvexEdge& e) { return std::pair(e.begin, e.end); });
}

// Corners that no face has, such as points within a face, go.
void drop_unused(ConvexShape& shape) {
  std::vector<int> number(shape.corners.size(), -1);
  for (const ConvexFace& face : shape.faces)
    for (const int c : face.corners) number[static_cast<std::size_t>(c)] = 0;
  std::vector<Vec3<double>> kept;
  for (std::size_t c = 0; c < number.size(); ++c) {
    if (number[c] < 0) continue;
    number[c] = static_cast<int>(kept.size());
    kept.push_back(shape.corners[c]);
  }
  for (ConvexFace& face : shape.faces)
    for (int& c : face.corners) c = number[static_cast<std::size_t>(c)];
  shape.corners = kept;
}

// Inscribed in the cylinder: bodies on its ends rest on the cylinder.
ConvexDefinition prism_of(const ConvexDefinition& cylinder) {
  const Vec3<double> axis = cylinder.points[1] - cylinder.points[0], unit = (1 / norm(axis)) * axis;
  const Vec3<double> x = any_across(unit), y = cross(unit, x);
  const double half = std::numbers::pi / prism_sides, r = cylinder.radius;
  ConvexDefinition prism;
  for (int end = 0; end < 2; ++end)
    for (int k = 0; k < prism_sides; ++k) {
      const double angle = 2 * half * k;
      prism.points.push_back(cylinder.points[static_cast<std::size_t>(end)] + (r * std::cos(angle)) * x +
                             (r * std::sin(angle)) * y);
    }
  const int n = prism_sides;
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    prism.triangles.push_back({k, next, n + next});
    prism.triangles.push_back({k, n + next, n + k});
    if (k >= 1 && k + 1 < n) {
      prism.triangles.push_back({0, k + 1, k});
      prism.triangles.push_back({n, n + k, n + k + 1});
    }
  }
  return prism;
}

}  // namespace

Vec3<double> any_across(const Vec3<double>& axis) {
  int least = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(axis[i]) < std::abs(axis[least])) least = i;
  Vec3<double> unit;
  unit[least] = 1;
  const Vec3<double> across = cross(axis, unit);
  return (1 / norm(across)) * across;
}

void find_corner_shares(std::span<const Vec3<double>> polygon, const Vec3<double>& normal,
                        std::vector<double>& shares) {
  const std::size_t n = polygon.size();
  shares.assign(n, 1.0 / static_cast<double>(n));
  if (n < 3) return;
  double size = 0;
  for (const Vec3<double>& p : polygon) size = std::max(size, norm(p - polygon[0]));
  const auto side = [&](std::size_t k) { return polygon[(k + 1) % n] - polygon[k % n]; };
  // A side without length leads where the next one does, so that all of the turn belongs to its begin.
  const auto is_none = [&](std::size_t k) { return !(norm(side(k)) > flat * size); };
  double sum = 0;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t next = k;
    while (next < k + n && is_none(next)) ++next;
    const Vec3<double> before = side(k + n - 1), after = side(next);
    shares[k] = is_none(k + n - 1) ? 0 : std::abs(std::atan2(dot(normal, cross(before, after)), dot(before, after)));
    sum += shares[k];
  }
  for (double& share : shares) share = sum > 0 ? share / sum : 1.0 / static_cast<double>(n);
}

double cap_share(int point, double tilt) {
  constexpr double standing = 0.1, leaning = 0.5, alike = 1.0 / cap_points;
  const double x = std::clamp((tilt - standing) / (leaning - standing), 0.0, 1.0), blend = x * x * (3 - 2 * x);
  const double lowest = alike + (0.5 - alike) * blend;
  return point == 0 ? lowest : (1 - lowest) / (cap_points - 1);
}

std::string fault_of(const ConvexDefinition& d) {
  const double size = d.points.empty() ? 0 : size_of(d.points);
  if (d.kind != ConvexKind::polytope) return size > 0 || d.kind == ConvexKind::ball ? "" : "an axis without length";
  if (d.points.size() < 4) return std::to_string(d.points.size()) + " points";
  if (!(size > 0)) return "points in one place";
  ConvexShape shape;
  add_faces(d, shape);
  Vec3<double> mean;
  for (const Vec3<double>& p : d.points) mean += (1.0 / static_cast<double>(d.points.size())) * p;
  if (shape.faces.size() < 4) return "points in one plane";
  for (const ConvexFace& face : shape.faces) {
    if (!(face.offset - dot(face.normal, mean) > flat * size))
      return "points in one plane, or a triangle that does not face outwards";
    for (const Vec3<double>& p : d.points)
      if (dot(face.normal, p) > face.offset + 1e-6 * size) return "a point outside of a triangle: not convex";
  }
  add_edges(shape);
  std::size_t sides = 0;
  for (const ConvexFace& face : shape.faces) sides += face.corners.size();
  return sides == 2 * shape.edges.size() ? "" : "triangles that do not close";
}

ConvexShape make_shape(const ConvexDefinition& definition) {
  ConvexShape shape;
  shape.kind = definition.kind;
  shape.radius = definition.radius;
  shape.corners = definition.points;
  if (definition.kind == ConvexKind::cylinder) {
    const ConvexDefinition prism = prism_of(definition);
    shape.corners = prism.points;
    add_faces(prism, shape);
  } else if (definition.kind == ConvexKind::polytope) {
    add_faces(definition, shape);
    drop_unused(shape);
  } else if (definition.kind == ConvexKind::capsule) {
    shape.edges.push_back({0, 1, -1, -1});
  }
  if (!shape.faces.empty()) add_edges(shape);
  double shares = 0, count = 0;
  for (const ConvexFace& face : shape.faces) {
    shares += 1;
    count += static_cast<double>(face.corners.size());
  }
  if (definition.kind == ConvexKind::polytope) shape.lone = shares / count;
  if (definition.kind == ConvexKind::cylinder || definition.kind == ConvexKind::capsule) shape.lone = 0.5;
  Vec3<double> lower = shape.corners[0], upper = lower;
  for (const Vec3<double>& p : shape.corners)
    for (int i = 0; i < 3; ++i) {
      lower[i] = std::min(lower[i], p[i]);
      upper[i] = std::max(upper[i], p[i]);
    }
  shape.centre = 0.5 * (lower + upper);
  for (const Vec3<double>& p : shape.corners) shape.bound = std::max(shape.bound, norm(p - shape.centre));
  shape.bound += shape.rounding();
  if (definition.kind == ConvexKind::cylinder) {  // its ends come first, as those of a capsule do
    shape.corners.insert(shape.corners.begin(), definition.points.begin(), definition.points.end());
    for (ConvexFace& face : shape.faces)
      for (int& c : face.corners) c += 2;
    for (ConvexEdge& edge : shape.edges) {
      edge.begin += 2;
      edge.end += 2;
    }
  }
  return shape;
}

ConvexDefinition box_definition(const Vec3<double>& centre, const Vec3<double>& size) {
  ConvexDefinition box;
  for (int k = 0; k < 8; ++k)
    box.points.push_back({centre[0] + (k & 1 ? 0.5 : -0.5) * size[0], centre[1] + (k & 2 ? 0.5 : -0.5) * size[1],
                          centre[2] + (k & 4 ? 0.5 : -0.5) * size[2]});
  box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return box;
}

}  // namespace dalembert
