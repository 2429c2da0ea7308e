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
constexpr std::size_t beyond = 15;  // samples that four side by side, or four pixels, may reach beyond the last one

constexpr std::size_t ahead = 8;  // triangles whose vertices are brought to the cache

constexpr std::size_t most_kept = std::size_t{4}
                                  << 20;  // samples, of 16 bytes; the memory of larger pictures is given back

}  // namespace

Picture::Picture(int width, int height, int samples, const Camera& camera, const Lighting& lighting)
    : width_(width),
      height_(height),
      samples_(samples),
      columns_(width * samples),
      rows_(height * samples),
      scale_(static_cast<float>(camera.scale * samples)),
      perspective_(static_cast<float>(camera.perspective)),
      view_(camera.view),
      lighting_(lighting),
      shine_(shine_steps + 1) {
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
  for (int row = 0; row < height_; ++row) {
    const float part = static_cast<float>(row) / static_cast<float>(std::max(height_ - 1, 1));
    std::fill_n(color_.data() + row_start(row * samples_), columns_ * samples_, packed(top + part * (bottom - top)));
  }
}

void Picture::begin() {
  if (!has_background_) background({1, 1, 1, 1}, {1, 1, 1, 1});
}

void Picture::clip(const Plane& plane) { planes_.push_back(plane); }

bool Picture::is_inside(const Point& eye) const {
  return std::ranges::all_of(planes_,
                             [&](const Plane& p) { return p.a * eye.x + p.b * eye.y + p.c * eye.z + p.d >= 0; });
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

// The corners of a mesh, before and after projection.
void Picture::project(const Mesh& mesh) {
  const std::size_t n = mesh.points.size() / 3;
  corners_.resize(n), vertices_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const float* c = mesh.colors.data() + 4 * i;
    corners_[i] = {to_eye(mesh.points.data() + 3 * i),
                   mesh.is_smooth() ? turned(mesh.normals.data() + 3 * i) : Point{},
                   {c[0], c[1], c[2], c[3]}};
    vertices_[i] = project(corners_[i]);
    vertices_[i].inside = is_inside(corners_[i].eye) && is_finite(vertices_[i].place);
  }
}

void Picture::triangles(const Mesh& mesh) {
  begin();
  project(mesh);
  const Corner* const corners = corners_.data();
  const Vertex* const vertices = vertices_.data();
  const bool smooth = mesh.is_smooth();
  const auto corner = [&](std::size_t t, std::size_t k) { return static_cast<std::size_t>(mesh.triangles[3 * t + k]); };
  const auto vertices_of = [&](std::size_t t) {
    return Corners{&vertices[corner(t, 0)], &vertices[corner(t, 1)], &vertices[corner(t, 2)]};
  };
  const auto flat = [&](std::size_t t) {
    const Point a = corners[corner(t, 0)].eye;
    return cross(corners[corner(t, 1)].eye - a, corners[corner(t, 2)].eye - a);
  };
  const auto faces_away = [&](std::size_t t) {
    if (smooth)
      return corners[corner(t, 0)].normal.z + corners[corner(t, 1)].normal.z + corners[corner(t, 2)].normal.z > 0;
    return (perspective_ == 0 ? flat(t).z : dot(flat(t), corners[corner(t, 0)].eye + Point{0, 0, 1 / perspective_})) >
           0;
  };
  // Back faces come last, because most of them are hidden.
  const std::size_t count = mesh.triangles.size() / 3;
  order_.resize(count);
  std::size_t facing = 0, away = count;
  for (std::size_t t = 0; t < count; ++t)
    if (!is_beside(vertices_of(t))) order_[faces_away(t) ? --away : facing++] = static_cast<std::uint32_t>(t);
  const std::span front(order_.data(), facing);
  std::span back(order_.data() + away, count - away);
  std::ranges::reverse(back);
  const Squares squares(columns_, rows_);
  const auto is_whole = [](const Corners& v) { return v[0]->inside && v[1]->inside && v[2]->inside; };
  Three turned;  // corners with other normals than their vertices
  const auto draw = [&](std::size_t t, float side) {
    Corners v = vertices_of(t);
    if (is_whole(v)) {
      if (!smooth || side < 0) {
        turned = {*v[0], *v[1], *v[2]};
        const Point n = smooth ? Point{} : side * flat(t);
        for (Vertex& vertex : turned)
          vertex.normal = smooth ? vertex.normal * Four{-1, -1, -1, 1} : vertex.weight() * Four{n.x, n.y, n.z, 1};
        v = {&turned[0], &turned[1], &turned[2]};
      }
      add(v, mesh.items[t]);
    } else if (!planes_.empty()) {
      std::array<Corner, 3> whole{corners[corner(t, 0)], corners[corner(t, 1)], corners[corner(t, 2)]};
      for (Corner& c : whole) c.normal = side * (smooth ? c.normal : flat(t));
      clipped(whole, mesh.items[t]);
    }
  };
  const auto draw_all = [&](std::span<std::uint32_t> list, float side) {
    std::vector<std::size_t> ends{list.size()};
    const bool are_many = list.size() >= Squares::many;
    if (are_many) ends = squares.sort(list, [&](std::uint32_t t) { return vertices[corner(t, 0)].place; });
    for (std::size_t square = 0, i = 0; square < ends.size(); ++square) {
      if (are_many && has_squares() && i < ends[square]) prefetch(squares, square + 1);
      for (; i < ends[square]; ++i) {
        const std::uint32_t soon = list[std::min(i + ahead, list.size() - 1)];
        for (std::size_t k = 0; k < 3; ++k) __builtin_prefetch(&vertices[corner(soon, k)]);
        draw(list[i], side);
      }
    }
  };
  draw_all(front, 1);
  if (back.size() >= Squares::many && has_squares()) {
    const std::vector<float> farthest = farthest_of(squares);
    const auto hidden = std::ranges::remove_if(back, [&](std::uint32_t t) {
      return is_whole(vertices_of(t)) && is_hidden(vertices_of(t), squares, farthest);
    });
    back = back.first(back.size() - hidden.size());
  }
  draw_all(back, -1);
}

// Prefetches the samples of a tile while the previous tile is drawn.
void Picture::prefetch(const Squares& squares, std::size_t square) const {
  constexpr int in_line = 16;  // samples of an array
  const auto across = static_cast<std::size_t>(squares.across());
  const int column = static_cast<int>(square % across) * Squares::side,
            row = static_cast<int>(square / across) * Squares::side;
  for (int y = row; y < std::min(row + Squares::side, rows_); y += 2) {
    const std::size_t first = sample(column, y), end = std::min(first + 2 * Squares::side, row_start(y + 2));
    for (std::size_t k = first; k < end; k += in_line) {
      __builtin_prefetch(depth_.data() + k, 1), __builtin_prefetch(item_.data() + k, 1);
      __builtin_prefetch(color_.data() + k, 1), __builtin_prefetch(normal_.data() + k, 1);
    }
  }
}

// Whether all of a triangle is on one side of the picture.
bool Picture::is_beside(const Corners& v) const {
  const Four across{0, 0, static_cast<float>(columns_), static_cast<float>(rows_)};
  const auto sides = [&](const Vertex& corner) {
    return Four{-corner.place.x, -corner.place.y, corner.place.x, corner.place.y} > across;
  };
  return v[0]->inside && v[1]->inside && v[2]->inside && bits(sides(*v[0]) & sides(*v[1]) & sides(*v[2])) != 0;
}

// The nearness of the farthest sample in each square.
std::vector<float> Picture::farthest_of(const Squares& squares) const {
  std::vector<float> result(static_cast<std::size_t>(squares.count()));
  for (int square = 0; square < squares.count(); ++square) {
    const int column = square % squares.across() * Squares::side, row = square / squares.across() * Squares::side;
    const int end = std::min(column + Squares::side, columns_), last = std::min(row + Squares::side, rows_);
    Four least = four(std::numeric_limits<float>::infinity());
    for (int y = row; y < last; y += 2) {
      const float* const to = depth_.data() + row_start(y) + 2 * end;
      for (const float* from = depth_.data() + sample(column, y); from < to; from += 4)
        least = smaller(least, load<Four>(from));
    }
    result[static_cast<std::size_t>(square)] = std::min({least[0], least[1], least[2], least[3]});
  }
  return result;
}

// Whether all samples of the squares in which a triangle lies are nearer.
bool Picture::is_hidden(const Corners& v, const Squares& squares, const std::vector<float>& farthest) const {
  const Point &a = v[0]->place, &b = v[1]->place, &c = v[2]->place;
  const FourWhole from = squares.of({std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), 0});
  const FourWhole to = squares.of({std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), 0});
  const float nearest = std::max({a.z, b.z, c.z});
  for (int row = from[1]; row <= to[1]; ++row)
    for (int column = from[0]; column <= to[0]; ++column)
      if (!(farthest[static_cast<std::size_t>(row * squares.across() + column)] > nearest)) return false;
  return true;
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
        rest.push_back(
            {a.eye + s * (b.eye - a.eye), a.normal + s * (b.normal - a.normal), a.paint + s * (b.paint - a.paint)});
      }
    }
    polygon.swap(rest);
  }
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Three v{project(polygon[0]), project(polygon[i - 1]), project(polygon[i])};
    if (std::ranges::all_of(v, [](const Vertex& corner) { return is_finite(corner.place); }))
      add({&v[0], &v[1], &v[2]}, item);
  }
}

std::vector<std::int32_t> Picture::items() const {
  std::vector<std::int32_t> result(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  std::size_t pixel = 0;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x)
      result[pixel++] = item_[sample(x * samples_ + samples_ / 2, y * samples_ + samples_ / 2)];
  return result;
}

}  // namespace dalembert
