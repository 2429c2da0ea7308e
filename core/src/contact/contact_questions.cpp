// Queries of lines and boxes.
#include "dalembert/contact/general_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "meetings.hpp"

namespace dalembert {

namespace {
constexpr int few_spheres = 16;
constexpr int lines_worth_a_tree = 50;  // testing all spheres for so many lines takes as long as building a tree
}  // namespace

GeneralContact::Items GeneralContact::items_in(const Box& box, const Ports& ports) const {
  Items items;
  renew_shapes();
  for (int i = 0; i < spheres(); ++i) {
    const double* x = ports.frame(sphere(i).marker);
    const double r = sphere(i).radius;
    if (box.overlaps({{x[0] - r, x[1] - r, x[2] - r}, {x[0] + r, x[1] + r, x[2] + r}})) items.spheres.push_back(i);
  }
  take_cables_of_system();
  for (std::size_t c = 0; c < cables_now_.size(); ++c)
    if (box.overlaps(cables_now_[c].box)) items.cables.push_back(static_cast<int>(c));
  for (std::size_t t = 0; t < set_->triangles.size(); ++t) {
    const RigidFrame<double> frame = frame_of(carrier(set_->triangles[t].carrier).marker, ports);
    Box around;
    for (const Vec3<double>& point : set_->triangles[t].points) around.add(out_of(frame, point));
    if (box.overlaps(around)) items.triangles.push_back(static_cast<int>(t));
  }
  ConvexNow now;
  for (std::size_t c = 0; c < set_->convex.size(); ++c) {
    now.place(scene_.shape(static_cast<int>(c)), frame_of(set_->convex[c].marker, ports));
    if (box.overlaps(now.box)) items.convex.push_back(static_cast<int>(c));
  }
  return items;
}

// Null if testing the lines one by one is faster.
const BoxTree* GeneralContact::spheres_for_lines(const Ports& ports, std::uint64_t number) const {
  if (number == 0 || spheres() < few_spheres) return nullptr;
  if (lines_.ports != number) lines_ = {number, 0, {}};
  if (++lines_.count < lines_worth_a_tree) return nullptr;
  if (!lines_.spheres.empty()) return &lines_.spheres;
  std::vector<Box> boxes(set_->spheres.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec3<double>& centre = read_frame<PointPort>(ports, set_->spheres[i].marker).position;
    const double r = set_->spheres[i].radius;
    boxes[i] = {centre - Vec3<double>{r, r, r}, centre + Vec3<double>{r, r, r}};
  }
  std::vector<int> all(boxes.size());
  std::iota(all.begin(), all.end(), 0);
  lines_.spheres.build(all, boxes);
  return &lines_.spheres;
}

// The first one of several at the same distance.
void GeneralContact::hit_spheres(const Line& line, const Ports& ports, std::uint64_t number, LineHit& hit) const {
  const auto look_at = [&](int i) {
    const PointFrame<double>& frame = read_frame<PointPort>(ports, sphere(i).marker);
    const double r = sphere(i).radius;
    const Vec3<double> to = frame.position - line.start;
    const double along = dot(to, line.direction),
                 aside = std::sqrt(std::max(0.0, dot(to - along * line.direction, to - along * line.direction)));
    if (aside > r + line.radius) return;
    const double off = std::max(0.0, aside - line.radius),
                 distance = along - std::sqrt(std::max(0.0, r * r - off * off));
    const bool first = distance < hit.distance || (distance == hit.distance && i < hit.sphere);
    if (distance >= line.nearest && first) hit = {distance, dot(line.direction, frame.velocity), i};
  };
  if (const BoxTree* tree = spheres_for_lines(ports, number)) {
    tree->each_along(line.start, line.direction, line.radius, line.nearest, [&] { return hit.distance; }, look_at);
  } else {
    for (int i = 0; i < spheres(); ++i) look_at(i);
  }
}

LineHit GeneralContact::first_hit(const Line& line, const Ports& ports, std::uint64_t number) const {
  LineHit hit;
  hit.distance = line.farthest;
  renew_shapes();
  if (line.spheres) hit_spheres(line, ports, number, hit);
  if (line.cables && line.direction[2] == 0) {  // planar lines only: other lines do not hit planar cables
    take_cables_of_system();
    for (std::size_t c = 0; c < cables_.size(); ++c) {
      const auto r = cables_[c].polynomials(cables_now_[c].q);
      const Vec3<double>& d = line.direction;
      std::array<double, 4> aside{};
      for (std::size_t k = 0; k < 4; ++k) aside[k] = d[0] * r[1][k] - d[1] * r[0][k];
      aside[0] -= d[0] * line.start[1] - d[1] * line.start[0];
      std::array<double, 6> zeros{};
      const int n = real_zeros(aside, 0, cables_[c].length, zeros);
      for (int k = 0; k < n; ++k) {
        const auto weights = cables_[c].weights(zeros[static_cast<std::size_t>(k)]);
        const Vec<double, 2> point = cables_[c].at(weights, cables_now_[c].q),
                             velocity = cables_[c].at(weights, cables_now_[c].v);
        const double distance = d[0] * (point[0] - line.start[0]) + d[1] * (point[1] - line.start[1]);
        if (distance >= line.nearest && distance < hit.distance)
          hit = {distance, d[0] * velocity[0] + d[1] * velocity[1], -1, static_cast<int>(c)};
      }
    }
  }
  hit_convex(line, ports, hit);
  if (!line.triangles) return hit;
  for (std::size_t c = 0; c < trees_.size(); ++c) {
    const RigidFrame<double> frame = read_frame<RigidPort>(ports, set_->carriers[c].marker);
    const Vec3<double> start = into(frame, line.start), direction = transposed_times(frame.rotation, line.direction);
    trees_[c].each_along(
        start, direction, 0, line.nearest, [&] { return hit.distance; },
        [&](int t) {
          const Triangle& corners = local_[static_cast<std::size_t>(t)];
          const Vec3<double> area = area_vector(corners);
          const double slope = dot(area, direction), square = dot(area, area);
          if (slope * slope <= 1e-28 * square) return;  // parallel to the plane
          const double distance = dot(area, corners[0] - start) / slope;
          if (!(distance >= line.nearest && distance < hit.distance)) return;
          const Vec3<double> point = start + distance * direction;
          for (std::size_t k = 0; k < 3; ++k)  // points on an edge belong to both triangles
            if (dot(area, cross(corners[(k + 1) % 3] - corners[k], point - corners[k])) < -1e-10 * square) return;
          const Vec3<double> velocity = frame.velocity + cross(frame.angular_velocity, frame.rotation * point);
          hit = {distance, dot(line.direction, velocity), -1, -1, t};
        });
  }
  return hit;
}

}  // namespace dalembert
