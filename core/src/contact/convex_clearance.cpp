// Distance of convex shapes by separating directions: the value of a direction is a lower bound of the distance, and
// exact for the direction between the two nearest features.
#include <algorithm>
#include <cmath>

#include "dalembert/contact/convex_narrow.hpp"

namespace dalembert {
namespace {

// Edges, and the axes of round shapes.
void list_lines(const ConvexNow& shape, std::vector<ConvexPairs::Line>& lines) {
  lines.clear();
  const auto add = [&](const Vec3<double>& begin, const Vec3<double>& end) {
    lines.push_back({begin, (1 / norm(end - begin)) * (end - begin)});
  };
  if (shape.shape->kind == ConvexKind::polytope)
    for (const ConvexEdge& e : shape.shape->edges)
      add(shape.corners[static_cast<std::size_t>(e.begin)], shape.corners[static_cast<std::size_t>(e.end)]);
  if (shape.length > 0) lines.push_back({shape.corners[0], shape.axis});
}

}  // namespace

double ConvexPairs::clearance(const ConvexNow& a, const ConvexNow& b) {
  double most = 0;
  // Evaluates a direction from a to b, or back.
  const auto look = [&](const Vec3<double>& direction) {
    const double length = norm(direction);
    if (!(length > 0)) return;
    for (const double way : {1 / length, -1 / length}) {
      const Vec3<double> normal = way * direction;
      most = std::max(most, b.lowest(normal) + a.lowest(-normal));
    }
  };
  for (const ConvexNow* shape : {&a, &b})
    for (const Vec3<double>& normal : shape->normals) look(normal);
  list_lines(a, lines_a_);
  list_lines(b, lines_b_);
  for (const Line& la : lines_a_)
    for (const Line& lb : lines_b_) look(cross(la.along, lb.along));
  for (const Vec3<double>& ca : a.corners)
    for (const Vec3<double>& cb : b.corners) look(cb - ca);
  const auto corners_and_lines = [&](const ConvexNow& shape, const std::vector<Line>& lines) {
    for (const Vec3<double>& corner : shape.corners)
      for (const Line& line : lines) look(corner - line.begin - dot(corner - line.begin, line.along) * line.along);
  };
  corners_and_lines(a, lines_b_);
  corners_and_lines(b, lines_a_);
  return most;
}

}  // namespace dalembert
