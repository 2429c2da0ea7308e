#include "dalembert/pictures/picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <utility>

#include "points.hpp"
#include "squares.hpp"

namespace dalembert {
namespace {

constexpr std::size_t shine_steps = 1024;
constexpr std::size_t beyond = 3;  // samples that four side by side may reach beyond the last one

constexpr std::size_t most_kept = std::size_t{4} << 20;  // samples, of 16 bytes; the memory of larger pictures is given back

}  // namespace

Picture::Picture(int width, int height, int samples, const Camera& camera, const Lighting& lighting)
    : width_(width), height_(height), samples_(samples), columns_(width * samples), rows_(height * samples),
      scale_(static_cast<float>(camera.scale * samples)), perspective_(static_cast<float>(camera.perspective)), view_(camera.view),
      lighting_(lighting), shine_(shine_steps + 1) {
  const std::size_t size = row_start(rows_) + beyond;
  exchange_memory();
  depth_.assign(size, -std::numeric_limits<float>::infinity());
  color_.resize(size);
  normal_.resize(size);
  item_.assign(size, -1);
  for (const Light& light : lighting_.lights) halves_.push_back(unit(light.direction + Point{0, 0, -1}));
  for (std::size_t i = 0; i <= shine_steps; ++i)
    shine_[i] = std::pow(static_cast<float>(i) / shine_steps, std::max(lighting_.shininess, 1.0f));
  if (perspective_ > 0) planes_.push_back({0, 0, perspective_, 0.98f});  // 1 + perspective z >= 0.02
}

Picture::~Picture() {
  if (depth_.size() <= most_kept && corners_.size() <= most_kept) exchange_memory();
}

void Picture::exchange_memory() {
  static std::mutex mutex;
  static Memory kept;
  const std::lock_guard lock(mutex);
  depth_.swap(kept.depth), color_.swap(kept.color), normal_.swap(kept.normal), item_.swap(kept.item);
  corners_.swap(kept.corners), vertices_.swap(kept.vertices), order_.swap(kept.order);
}

void Picture::background(const Paint& top, const Paint& bottom) {
  has_background_ = true;
  for (int row = 0; row < rows_; ++row) {
    const float part = static_cast<float>(row / samples_) / static_cast<float>(std::max(height_ - 1, 1));
    std::fill_n(color_.data() + row_start(row), columns_, packed(top + part * (bottom - top)));
  }
}

void Picture::begin() {
  if (!has_background_) background({1, 1, 1, 1}, {1, 1, 1, 1});
}

void Picture::clip(const Plane& plane) { planes_.push_back(plane); }

bool Picture::is_inside(const Point& eye) const {
  return std::ranges::all_of(planes_, [&](const Plane& p) { return p.a * eye.x + p.b * eye.y + p.c * eye.z + p.d >= 0; });
}

Point Picture::to_eye(const double* p) const {
  const auto row = [&](int i) {
    const double* m = view_.data() + 4 * i;
    return static_cast<float>(m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3]);
  };
  return {row(0), row(1), row(2)};
}

Point Picture::turned(const double* v) const {
  const auto row = [&](int i) {
    const double* m = view_.data() + 4 * i;
    return static_cast<float>(m[0] * v[0] + m[1] * v[1] + m[2] * v[2]);
  };
  return {row(0), row(1), row(2)};
}

Picture::Vertex Picture::project(const Corner& corner) const {
  const float weight = 1 / (1 + perspective_ * corner.eye.z);
  const Point& n = corner.normal;
  const Four paint{corner.paint.r, corner.paint.g, corner.paint.b, corner.paint.a};
  Vertex v;
  v.place = {0.5f * static_cast<float>(columns_) + scale_ * weight * corner.eye.x,
             0.5f * static_cast<float>(rows_) - scale_ * weight * corner.eye.y, nearness(corner.eye.z, weight)};
  v.color = packed(paint) | to_be_lit;
  v.normal = weight * Four{n.x, n.y, n.z, 1};
  v.paint = weight * paint;
  return v;
}

void Picture::triangles(const Mesh& mesh) {
  begin();
  const std::size_t n = mesh.points.size() / 3;
  corners_.resize(n), vertices_.resize(n);
  Corner* const corners = corners_.data();
  Vertex* const vertices = vertices_.data();
  const bool smooth = !mesh.normals.empty();
  for (std::size_t i = 0; i < n; ++i) {
    const float* c = mesh.colors.data() + 4 * i;
    corners[i] = {to_eye(mesh.points.data() + 3 * i), smooth ? turned(mesh.normals.data() + 3 * i) : Point{}, {c[0], c[1], c[2], c[3]}};
    vertices[i] = project(corners[i]);
    vertices[i].inside = is_inside(corners[i].eye);
  }
  order_.resize(mesh.triangles.size() / 3);
  std::iota(order_.begin(), order_.end(), 0u);
  if (order_.size() >= Squares::many)
    Squares(columns_, rows_).sort(order_, [&](std::uint32_t t) { return vertices[static_cast<std::size_t>(mesh.triangles[3 * std::size_t{t}])].place; });
  for (const std::size_t t : order_) {
    std::array<std::size_t, 3> index{};
    for (std::size_t k = 0; k < 3; ++k) index[k] = static_cast<std::size_t>(mesh.triangles[3 * t + k]);
    const Point &a = corners[index[0]].eye, &b = corners[index[1]].eye, &c = corners[index[2]].eye;
    const Point flat = smooth ? Point{} : cross(b - a, c - a);
    std::array<Point, 3> normals{};
    float away = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      normals[k] = smooth ? corners[index[k]].normal : flat;
      away += smooth || perspective_ == 0 ? normals[k].z : dot(normals[k], a + Point{0, 0, 1 / perspective_});
    }
    const float side = away > 0 ? -1.0f : 1.0f;
    Three v{vertices[index[0]], vertices[index[1]], vertices[index[2]]};
    if (v[0].inside && v[1].inside && v[2].inside) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Point normal = side * normals[k];
        v[k].normal = v[k].weight() * Four{normal.x, normal.y, normal.z, 1};
      }
      add(v, mesh.items[t]);
    } else if (!planes_.empty()) {
      std::array<Corner, 3> whole{corners[index[0]], corners[index[1]], corners[index[2]]};
      for (std::size_t k = 0; k < 3; ++k) whole[k].normal = side * normals[k];
      clipped(whole, mesh.items[t]);
    }
  }
}

// Sutherland and Hodgman: a triangle that loses corners to the planes has up to three more.
void Picture::clipped(const std::array<Corner, 3>& corners, std::int32_t item) {
  std::vector<Corner> polygon(corners.begin(), corners.end()), rest;
  for (const Plane& p : planes_) {
    const auto inside = [&](const Corner& c) { return p.a * c.eye.x + p.b * c.eye.y + p.c * c.eye.z + p.d; };
    if (std::ranges::all_of(polygon, [&](const Corner& c) { return inside(c) >= 0; })) continue;
    rest.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const float da = inside(a), db = inside(b);
      if (da >= 0) rest.push_back(a);
      if ((da >= 0) != (db >= 0)) {
        const float s = da / (da - db);
        rest.push_back({a.eye + s * (b.eye - a.eye), a.normal + s * (b.normal - a.normal), a.paint + s * (b.paint - a.paint)});
      }
    }
    polygon.swap(rest);
  }
  for (std::size_t i = 2; i < polygon.size(); ++i) add({project(polygon[0]), project(polygon[i - 1]), project(polygon[i])}, item);
}

std::vector<std::int32_t> Picture::items() const {
  const auto width = static_cast<std::size_t>(width_), height = static_cast<std::size_t>(height_), s = static_cast<std::size_t>(samples_);
  std::vector<std::int32_t> result(width * height);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) result[y * width + x] = item_[(y * s + s / 2) * width * s + x * s + s / 2];
  return result;
}

}  // namespace dalembert
