// Pictures of the same scenes by rays: shadows, reflections, transparent and refracting materials. Each pixel depends
// only on the scene, so that any number of threads makes the same bytes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "dalembert/math/fixed.hpp"
#include "dalembert/pictures/picture.hpp"

namespace dalembert {

struct RayMaterial {
  Vec3<double> specular{}, emission{};
  double shininess = 32, reflectivity = 0, refraction = 1;  // refraction: index; 1: rays go straight on
};

// A light, in eye coordinates.
struct RayLight {
  Vec3<double> place;  // or the direction towards it
  bool at_infinity = true;
  double diffuse = 0, specular = 0;
  double shadow = 0;  // fraction of the light that an obstacle removes
  double radius = 0;  // radius of a spherical light; relative to the distance if it is at infinity
  std::array<double, 3> attenuation{1, 0, 0};  // 1, distance, its square
};

struct RayOptions {
  int samples = 1;  // samples of a pixel in each direction
  int threads = 1, tiles_per_thread = 12;
  int reflections = 2, transparencies = 2;  // that a ray follows
  int light_places = 1;  // number of sample positions per light for shadows
  double lift = 0;  // offset of lines towards the viewer
  double ambient = 1;
  Vec3<double> top{1, 1, 1}, bottom{1, 1, 1};  // colors of the background
  Vec3<double> around{0.4, 0.4, 0.4};  // color of reflected rays that leave the scene
  Vec3<double> fog{0.5, 0.5, 0.5};
  double fog_density = 0;  // 1 / length
};

class RayTracer {
 public:
  RayTracer(int width, int height, const Camera& camera, std::vector<RayLight> lights,
            std::vector<RayMaterial> materials, const RayOptions& options);
  ~RayTracer();

  int width() const;
  int height() const;
  int materials() const;  // how many

  void clip(const Plane& plane);
  // `materials`: a number for each triangle; the opacity is that of the colors.
  void triangles(const Mesh& mesh, std::span<const std::int32_t> materials);
  // Spheres have the first material.
  void spheres(std::span<const double> centers, std::span<const double> radii, std::span<const float> colors);
  // Neither lit nor casting shadows; the width is one in pixels at the center of the picture.
  void lines(std::span<const double> segments, std::span<const float> colors, double width);

  // 3 bytes per pixel, the upper row first.
  std::vector<std::uint8_t> develop();

  struct Scene;

 private:
  const std::unique_ptr<Scene> scene_;
};

}  // namespace dalembert
