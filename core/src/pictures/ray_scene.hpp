// Scene of the ray tracer: shapes in eye coordinates, and a bounding volume hierarchy.
#pragma once

#include <optional>

#include "ray_tree.hpp"

namespace dalembert {

struct RaySurface {
  // normal: interpolated; face: of the triangle itself; unit vectors towards the ray's origin
  Vec3<double> place, normal, face;
  Vec3<double> color;
  double opacity = 1, distance = 0;
  std::int32_t material = 0;
  bool is_lit = true;
  bool from_outside = true;  // the ray comes from where the normal of the shape points to
};

struct RayTracer::Scene {
  struct Triangle {
    std::array<std::uint32_t, 3> points;
    std::int32_t material;
    bool is_smooth;
  };
  struct Ball {
    Vec3<double> center;
    double radius;
    std::array<float, 4> color;
  };
  struct Rod {
    Vec3<double> begin, end;
    double radius;
    std::array<float, 4> color;
  };

  int width, height;
  double scale, perspective;
  Mat3<double> turn;
  Vec3<double> shift;
  std::vector<RayLight> lights;
  std::vector<RayMaterial> materials;
  RayOptions options;
  std::vector<Plane> planes;

  std::vector<Vec3<double>> points, normals;
  std::vector<std::array<float, 4>> colors;  // colors of the points
  std::vector<Triangle> triangles;
  std::vector<Ball> balls;
  std::vector<Rod> rods;
  RayTree tree;
  double size = 1;  // size of the scene
  double front = 0;  // in front of the scene: start of rays of a parallel projection

  Vec3<double> to_eye(const double* p) const { return turn * Vec3<double>{p[0], p[1], p[2]} + shift; }
  void finish();  // all shapes are there

  std::optional<RaySurface> find(Ray ray) const;
  // Fraction of light that passes along a ray.
  double passing(Ray ray) const;
  Ray first_ray(double x, double y) const;  // ray through a position in the picture, in pixels
  double small() const { return 1e-7 * size; }  // a step off a surface, so that a ray does not meet it again

 private:
  struct Meeting {
    double t = never, u = 0, v = 0;
  };
  bool is_cut_off(const Vec3<double>& place) const;
  Meeting meet_uncut(const Ray& ray, std::uint32_t shape) const;
  Meeting meet(const Ray& ray, std::uint32_t shape) const;
  bool is_rod(std::uint32_t shape) const { return shape >= triangles.size() + balls.size(); }
  const Ball& ball(std::uint32_t shape) const { return balls[shape - triangles.size()]; }
  const Rod& rod(std::uint32_t shape) const { return rods[shape - triangles.size() - balls.size()]; }
  double opacity(std::uint32_t shape, const Meeting& meeting) const;
  RaySurface surface(const Ray& ray, std::uint32_t shape, const Meeting& meeting) const;
};

inline Vec3<double> unit_of(const Vec3<double>& v) {
  const double length = norm(v);
  return length > 0 ? (1 / length) * v : Vec3<double>{0, 0, -1};
}

}  // namespace dalembert
