// Intersections of lines with convex shapes and planes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "meetings.hpp"

namespace dalembert {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

// A stretch of a line; empty if it ends before it begins.
struct Stretch {
  double begin = -nowhere, end = nowhere;
  // Restricts to height + s * slope <= 0.
  void below(double height, double slope) {
    if (slope > 0)
      end = std::min(end, -height / slope);
    else if (slope < 0)
      begin = std::max(begin, -height / slope);
    else if (height > 0)
      clear();
  }
  void clear() {
    begin = nowhere;
    end = -nowhere;
  }
  // Restricts to a distance of at most r from an axis, or from a point: `to` and `along` have no component along the
  // axis.
  void around(const Vec3<double>& to, const Vec3<double>& along, double r) {
    const double a = dot(along, along), b = dot(to, along), c = dot(to, to) - r * r, root = b * b - a * c;
    if (a == 0) {
      if (c > 0) clear();
      return;
    }
    if (root < 0) return clear();
    begin = std::max(begin, (-b - std::sqrt(root)) / a);
    end = std::min(end, (-b + std::sqrt(root)) / a);
  }
  double first() const { return begin <= end ? begin : nowhere; }
};

double first_in(const ConvexNow& now, const Line& line) {
  const ConvexShape& shape = *now.shape;
  Stretch in;
  if (shape.kind == ConvexKind::polytope) {
    for (std::size_t f = 0; f < now.normals.size(); ++f)
      in.below(dot(now.normals[f], line.start) - now.offsets[f], dot(now.normals[f], line.direction));
    return in.first();
  }
  const Vec3<double> to = line.start - now.corners[0];
  in.around(to - dot(to, now.axis) * now.axis, line.direction - dot(line.direction, now.axis) * now.axis, shape.radius);
  in.below(-dot(to, now.axis), -dot(line.direction, now.axis));
  in.below(dot(to, now.axis) - now.length, dot(line.direction, now.axis));
  double first = in.first();
  for (std::size_t end = 0; end < 2 && shape.kind == ConvexKind::capsule; ++end) {
    Stretch ball;
    ball.around(line.start - now.corners[end], line.direction, shape.radius);
    first = std::min(first, ball.first());
  }
  return first;
}

}  // namespace

void GeneralContact::hit_convex(const Line& line, const Ports& ports, LineHit& hit) const {
  const auto take = [&](double distance, const RigidFrame<double>& frame, int convex, int plane) {
    if (!(distance >= line.nearest && distance < hit.distance)) return;
    const Vec3<double> velocity =
        frame.velocity + cross(frame.angular_velocity, line.start + distance * line.direction - frame.position);
    hit = {distance, dot(line.direction, velocity), -1, -1, -1, convex, plane};
  };
  ConvexNow now;
  for (int c = 0; line.convex && c < static_cast<int>(set_->convex.size()); ++c) {
    const RigidFrame<double> frame = frame_of(set_->convex[static_cast<std::size_t>(c)].marker, ports);
    now.place(scene_.shape(c), frame);
    take(first_in(now, line), frame, c, -1);
  }
  for (int p = 0; line.planes && p < static_cast<int>(set_->planes.size()); ++p) {
    const ContactPlane& plane = set_->planes[static_cast<std::size_t>(p)];
    const RigidFrame<double> frame = frame_of(plane.marker, ports);
    const Vec3<double> normal = frame.rotation * plane.normal;
    const double slope = dot(normal, line.direction);
    if (slope != 0) take(dot(normal, out_of(frame, plane.point) - line.start) / slope, frame, -1, p);
  }
}

}  // namespace dalembert
