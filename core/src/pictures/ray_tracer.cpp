// Light along rays: scattering, reflection and transmission of surfaces (Whitted's model).
#include "dalembert/pictures/ray_tracer.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>

#include "ray_scene.hpp"

namespace dalembert {
namespace {

Vec3<double> between(const Vec3<double>& a, const Vec3<double>& b, double part) { return a + part * (b - a); }
Vec3<double> mirrored(const Vec3<double>& d, const Vec3<double>& normal) { return d - (2 * dot(d, normal)) * normal; }

// Snell's law; nullopt for total reflection.
std::optional<Vec3<double>> refracted(const Vec3<double>& d, const Vec3<double>& normal, double ratio) {
  const double c = -dot(d, normal), rest = 1 - ratio * ratio * (1 - c * c);
  if (rest < 0) return std::nullopt;
  return unit_of(ratio * d + (ratio * c - std::sqrt(rest)) * normal);
}

// Points of a disc normal to a direction, evenly distributed like sunflower seeds.
Vec3<double> place_on_disc(const Vec3<double>& direction, double radius, int number, int count) {
  if (count == 1 || radius <= 0) return {};
  const Vec3<double> other = std::abs(direction[0]) < 0.6 ? Vec3<double>{1, 0, 0} : Vec3<double>{0, 1, 0};
  const Vec3<double> x = unit_of(cross(direction, other)), y = cross(direction, x);
  const double r = radius * std::sqrt((number + 0.5) / count),
               angle = number * std::numbers::pi * (3 - 2.2360679774997896);
  return r * (std::cos(angle) * x + std::sin(angle) * y);
}

// How often a ray may go on.
struct Left {
  int reflections, transparencies;
};

class Tracer {
 public:
  Tracer(const RayTracer::Scene& scene) : scene_(scene), o_(scene.options) {}

  // `behind`: color of a ray without intersection.
  Vec3<double> look(const Ray& ray, Left left, const Vec3<double>& behind) const {
    const auto found = scene_.find(ray);
    if (!found) return behind;
    const RaySurface& s = *found;
    Vec3<double> color = s.is_lit ? lit(s, ray) : s.color;
    const RayMaterial& material = scene_.materials[static_cast<std::size_t>(s.material)];
    if (s.is_lit && material.reflectivity > 0 && left.reflections > 0) {
      const Ray on{s.place + scene_.small() * s.face, mirrored(ray.direction, s.normal)};
      color = between(color, look(on, {left.reflections - 1, left.transparencies}, o_.around), material.reflectivity);
    }
    if (s.opacity < 1 && left.transparencies > 0) {
      const Ray on = transmitted(s, ray, material.refraction);
      color = between(look(on, {left.reflections, left.transparencies - 1}, behind), color, s.opacity);
    }
    return o_.fog_density > 0 ? between(o_.fog, color, std::exp(-o_.fog_density * s.distance)) : color;
  }

 private:
  Ray transmitted(const RaySurface& s, const Ray& ray, double index) const {
    const Ray straight{s.place - scene_.small() * s.face, ray.direction};
    if (index == 1 || index <= 0) return straight;
    const auto direction = refracted(ray.direction, s.normal, s.from_outside ? 1 / index : index);
    if (!direction) return {s.place + scene_.small() * s.face, mirrored(ray.direction, s.normal)};
    return {straight.origin, *direction};
  }

  Vec3<double> lit(const RaySurface& s, const Ray& ray) const {
    const RayMaterial& material = scene_.materials[static_cast<std::size_t>(s.material)];
    Vec3<double> color = o_.ambient * s.color + material.emission;
    for (const RayLight& light : scene_.lights) {
      const Vec3<double> way = light.at_infinity ? light.place : light.place - s.place;
      const Vec3<double> direction = unit_of(way);
      const double facing = dot(s.normal, direction);
      if (facing <= 0) continue;
      double strength = 1;
      if (!light.at_infinity) {
        const double d = norm(way);
        strength = 1 / std::max(light.attenuation[0] + d * (light.attenuation[1] + d * light.attenuation[2]), 1e-12);
      }
      if (light.shadow > 0) strength *= 1 - std::min(light.shadow, 1.0) * (1 - reaching(s, light));
      const double half = dot(s.normal, unit_of(direction - ray.direction));
      color += (strength * light.diffuse * facing) * s.color;
      if (half > 0)
        color += (strength * light.specular * std::pow(half, std::max(material.shininess, 1.0))) * material.specular;
    }
    return color;
  }

  // Fraction of a light that reaches a surface.
  double reaching(const RaySurface& s, const RayLight& light) const {
    const Vec3<double> start = s.place + scene_.small() * s.face;
    const Vec3<double> middle = light.at_infinity ? unit_of(light.place) : light.place - start;
    const int count = light.radius > 0 ? o_.light_places : 1;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
      const Vec3<double> way = middle + place_on_disc(unit_of(middle), light.radius, i, count);
      sum += scene_.passing({start, unit_of(way), 0, light.at_infinity ? never : norm(way)});
    }
    return sum / count;
  }

  const RayTracer::Scene& scene_;
  const RayOptions& o_;
};

}  // namespace

std::vector<std::uint8_t> RayTracer::develop() {
  Scene& s = *scene_;
  s.finish();
  const RayOptions& o = s.options;
  const Tracer tracer(s);
  std::vector<std::uint8_t> image(3 * static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height));
  const auto row = [&](int y) {
    const Vec3<double> behind = between(o.top, o.bottom, static_cast<double>(y) / std::max(s.height - 1, 1));
    std::uint8_t* pixel = image.data() + 3 * static_cast<std::size_t>(s.width) * static_cast<std::size_t>(y);
    for (int x = 0; x < s.width; ++x, pixel += 3) {
      Vec3<double> sum{};
      for (int j = 0; j < o.samples; ++j) {
        for (int i = 0; i < o.samples; ++i) {
          const Ray ray = s.first_ray(x + (i + 0.5) / o.samples, y + (j + 0.5) / o.samples);
          const Vec3<double> color = tracer.look(ray, {o.reflections, o.transparencies}, behind);
          for (int k = 0; k < 3; ++k) sum[k] += std::clamp(color[k], 0.0, 1.0);
        }
      }
      for (int k = 0; k < 3; ++k) pixel[k] = static_cast<std::uint8_t>(255 * sum[k] / (o.samples * o.samples) + 0.5);
    }
  };
  // Each idle thread takes the next part of the picture; the assignment has no influence on the bytes.
  const int threads = std::clamp(o.threads, 1, s.height),
            parts = std::min(threads * std::max(o.tiles_per_thread, 1), s.height);
  std::atomic<int> next = 0;
  const auto work = [&] {
    for (int part = next++; part < parts; part = next++)
      for (int y = s.height * part / parts; y < s.height * (part + 1) / parts; ++y) row(y);
  };
  {
    std::vector<std::jthread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back(work);
    work();
  }
  return image;
}

}  // namespace dalembert
