// Intersections of a ray with triangles, spheres and cylinders with round ends; lengths are measured from its origin
// in units of its direction.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "dalembert/pictures/ray_tracer.hpp"

namespace dalembert {

inline constexpr double never = std::numeric_limits<double>::infinity();

struct Ray {
  Vec3<double> origin, direction;  // a unit vector
  double begin = 0, end = never;

  Vec3<double> at(double t) const { return origin + t * direction; }
  bool has(double t) const { return t > begin && t < end; }
};

// The two places where a quadratic a t^2 + 2 b t + c is zero; `never` if it is not.
struct Crossings {
  double first = never, second = never;
  Crossings(double a, double b, double c) {
    const double d = b * b - a * c;
    if (d < 0 || a <= 0) return;
    const double root = std::sqrt(d);
    first = (-b - root) / a, second = (-b + root) / a;
  }
};

// Möller and Trumbore; u and v are the weights of the second and the third corner.
inline double meet_triangle(const Ray& ray, const Vec3<double>& corner, const Vec3<double>& u_edge,
                            const Vec3<double>& v_edge, double& u, double& v) {
  const Vec3<double> p = cross(ray.direction, v_edge);
  const double determinant = dot(u_edge, p);
  if (determinant == 0) return never;
  const Vec3<double> s = ray.origin - corner, q = cross(s, u_edge);
  u = dot(s, p) / determinant, v = dot(ray.direction, q) / determinant;
  const double t = dot(v_edge, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && ray.has(t) ? t : never;
}

inline double meet_sphere(const Ray& ray, const Vec3<double>& center, double radius) {
  const Vec3<double> s = ray.origin - center;
  const Crossings c(1, dot(s, ray.direction), dot(s, s) - radius * radius);
  return ray.has(c.first) ? c.first : ray.has(c.second) ? c.second : never;
}

// The part of a cylinder between its ends, and the spheres around these.
inline double meet_rod(const Ray& ray, const Vec3<double>& begin, const Vec3<double>& end, double radius) {
  const Vec3<double> axis = end - begin, s = ray.origin - begin;
  const double length2 = dot(axis, axis);
  double t = std::min(meet_sphere(ray, begin, radius), meet_sphere(ray, end, radius));
  if (length2 == 0) return t;
  const Vec3<double> across = ray.direction - (dot(ray.direction, axis) / length2) * axis,
                     offset = s - (dot(s, axis) / length2) * axis;
  const Crossings c(dot(across, across), dot(across, offset), dot(offset, offset) - radius * radius);
  for (const double side : {c.first, c.second}) {
    if (!ray.has(side) || side >= t) continue;
    const double along = dot(ray.at(side) - begin, axis);
    if (along >= 0 && along <= length2) t = side;
  }
  return t;
}

}  // namespace dalembert
