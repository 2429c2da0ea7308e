#include "ray_scene.hpp"

#include <algorithm>

namespace dalembert {
namespace {

Vec3<double> rgb(const std::array<float, 4>& c) { return {double{c[0]}, double{c[1]}, double{c[2]}}; }

bool is_finite(const Vec3<double>& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

}  // namespace

void RayTracer::Scene::finish() {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size() + balls.size() + rods.size());
  for (const Triangle& t : triangles) {
    Box& box = boxes.emplace_back();
    for (const std::uint32_t point : t.points) box.add(points[point]);
  }
  for (const Ball& b : balls) boxes.emplace_back().add(b.center, b.radius);
  for (const Rod& r : rods) {
    Box& box = boxes.emplace_back();
    box.add(r.begin, r.radius), box.add(r.end, r.radius);
  }
  Box all;
  for (const Box& box : boxes) all.add(box);
  if (!boxes.empty()) size = std::max(norm(all.high - all.low), 1e-300), front = all.low[2] - 1e-6 * size;
  tree.build(boxes);
}

Ray RayTracer::Scene::first_ray(double x, double y) const {
  const double right = (x - 0.5 * width) / scale, up = (0.5 * height - y) / scale;
  if (perspective <= 0) {
    return {{right, up, front}, {0, 0, 1}, 0, never};
  }
  const Vec3<double> direction = unit_of({right, up, 1 / perspective});
  return {{0, 0, -1 / perspective}, direction, 0.02 / (perspective * direction[2]), never};
}

bool RayTracer::Scene::is_cut_off(const Vec3<double>& e) const {
  return std::ranges::any_of(planes, [&](const Plane& p) {
    return double{p.a} * e[0] + double{p.b} * e[1] + double{p.c} * e[2] + double{p.d} < 0;
  });
}

RayTracer::Scene::Meeting RayTracer::Scene::meet_uncut(const Ray& ray, std::uint32_t shape) const {
  Meeting m;
  if (shape < triangles.size()) {
    const auto& [a, b, c] = triangles[shape].points;
    m.t = meet_triangle(ray, points[a], points[b] - points[a], points[c] - points[a], m.u, m.v);
  } else if (!is_rod(shape)) {
    m.t = meet_sphere(ray, ball(shape).center, ball(shape).radius);
  } else {
    m.t = meet_rod(ray, rod(shape).begin, rod(shape).end, rod(shape).radius);
  }
  return m;
}

// The inner side of a round shape is seen where the outer one is cut off.
RayTracer::Scene::Meeting RayTracer::Scene::meet(const Ray& ray, std::uint32_t shape) const {
  Meeting m = meet_uncut(ray, shape);
  if (planes.empty()) return m;
  Ray rest = ray;
  while (m.t < never && is_cut_off(ray.at(m.t))) {
    rest.begin = m.t;
    m = meet_uncut(rest, shape);
  }
  return m;
}

double RayTracer::Scene::opacity(std::uint32_t shape, const Meeting& m) const {
  if (shape >= triangles.size()) return double{ball(shape).color[3]};
  const auto& [a, b, c] = triangles[shape].points;
  return (1 - m.u - m.v) * double{colors[a][3]} + m.u * double{colors[b][3]} + m.v * double{colors[c][3]};
}

RaySurface RayTracer::Scene::surface(const Ray& ray, std::uint32_t shape, const Meeting& m) const {
  RaySurface s;
  s.distance = m.t, s.place = ray.at(m.t);
  if (is_rod(shape)) {
    s.color = rgb(rod(shape).color), s.is_lit = false, s.normal = s.face = -ray.direction;
    return s;
  }
  s.opacity = std::clamp(opacity(shape, m), 0.0, 1.0);
  if (shape < triangles.size()) {
    const Triangle& t = triangles[shape];
    const auto& [a, b, c] = t.points;
    s.face = unit_of(cross(points[c] - points[a], points[b] - points[a]));  // eye coordinates are left-handed
    const double w = 1 - m.u - m.v;
    s.color = w * rgb(colors[a]) + m.u * rgb(colors[b]) + m.v * rgb(colors[c]);
    s.normal = t.is_smooth ? unit_of(w * normals[a] + m.u * normals[b] + m.v * normals[c]) : s.face;
    if (dot(s.normal, s.face) < 0) s.face = -s.face;
    s.material = t.material;
  } else {
    s.normal = s.face = unit_of(s.place - ball(shape).center);
    s.color = rgb(ball(shape).color);
  }
  s.from_outside = dot(ray.direction, s.face) <= 0;
  if (!s.from_outside) s.face = -s.face, s.normal = -s.normal;
  return s;
}

std::optional<RaySurface> RayTracer::Scene::find(Ray ray) const {
  Meeting nearest;
  double distance = never;  // start of lines on the ray
  std::uint32_t found = 0;
  tree.pass(ray, [&](std::uint32_t shape) {
    const Meeting m = meet(ray, shape);
    const double d = is_rod(shape) ? m.t - options.lift : m.t;
    if (d < distance) nearest = m, distance = d, found = shape, ray.end = d + options.lift;
    return false;
  });
  if (distance == never) return std::nullopt;
  return surface(ray, found, nearest);
}

double RayTracer::Scene::passing(Ray ray) const {
  double part = 1;
  tree.pass(ray, [&](std::uint32_t shape) {
    if (is_rod(shape)) return false;
    const Meeting m = meet(ray, shape);
    if (m.t < never) part *= 1 - std::clamp(opacity(shape, m), 0.0, 1.0);
    return part < 1.0 / 512;  // less than a byte of color shows
  });
  return part < 1.0 / 512 ? 0 : part;
}

RayTracer::RayTracer(int width, int height, const Camera& camera, std::vector<RayLight> lights,
                     std::vector<RayMaterial> materials, const RayOptions& options)
    : scene_(std::make_unique<Scene>()) {
  Scene& s = *scene_;
  s.width = width, s.height = height, s.scale = camera.scale, s.perspective = camera.perspective;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) s.turn(i, k) = camera.view[static_cast<std::size_t>(4 * i + k)];
    s.shift[i] = camera.view[static_cast<std::size_t>(4 * i + 3)];
  }
  s.lights = std::move(lights), s.materials = std::move(materials), s.options = options;
}

RayTracer::~RayTracer() = default;

int RayTracer::width() const { return scene_->width; }
int RayTracer::height() const { return scene_->height; }
int RayTracer::materials() const { return static_cast<int>(scene_->materials.size()); }

void RayTracer::clip(const Plane& plane) { scene_->planes.push_back(plane); }

void RayTracer::triangles(const Mesh& mesh, std::span<const std::int32_t> materials) {
  Scene& s = *scene_;
  const std::size_t start = s.points.size(), count = mesh.points.size() / 3;
  const bool is_smooth = !mesh.normals.empty();
  for (std::size_t i = 0; i < count; ++i) {
    s.points.push_back(s.to_eye(mesh.points.data() + 3 * i));
    const double* n = mesh.normals.data() + 3 * i;
    s.normals.push_back(is_smooth ? s.turn * Vec3<double>{n[0], n[1], n[2]} : Vec3<double>{});
    const float* c = mesh.colors.data() + 4 * i;
    s.colors.push_back({c[0], c[1], c[2], c[3]});
  }
  for (std::size_t i = 0; i < materials.size(); ++i) {
    std::array<std::uint32_t, 3> index{};
    for (std::size_t k = 0; k < 3; ++k)
      index[k] = static_cast<std::uint32_t>(start + static_cast<std::size_t>(mesh.triangles[3 * i + k]));
    if (std::ranges::all_of(index, [&](std::uint32_t p) { return is_finite(s.points[p]); }))
      s.triangles.push_back({index, materials[i], is_smooth});
  }
}

void RayTracer::spheres(std::span<const double> centers, std::span<const double> radii, std::span<const float> colors) {
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const Vec3<double> center = scene_->to_eye(centers.data() + 3 * i);
    const float* c = colors.data() + 4 * i;
    if (is_finite(center) && std::isfinite(radii[i]) && radii[i] > 0)
      scene_->balls.push_back({center, radii[i], {c[0], c[1], c[2], c[3]}});
  }
}

void RayTracer::lines(std::span<const double> segments, std::span<const float> colors, double width) {
  for (std::size_t i = 0; i < segments.size() / 6; ++i) {
    const Vec3<double> a = scene_->to_eye(segments.data() + 6 * i), b = scene_->to_eye(segments.data() + 6 * i + 3);
    const float* c = colors.data() + 4 * i;
    if (is_finite(a) && is_finite(b))
      scene_->rods.push_back({a, b, 0.5 * width / scene_->scale, {c[0], c[1], c[2], c[3]}});
  }
}

}  // namespace dalembert
