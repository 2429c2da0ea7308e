#include "dalembert/pictures/picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dalembert {
namespace {

constexpr std::uint32_t to_be_lit = 0xff000000u;
constexpr std::size_t shine_steps = 1024;
constexpr int alike = 1600;  // of 32767: a twentieth of a radian where a surface faces the viewer

Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point operator*(float s, Point a) { return {s * a.x, s * a.y, s * a.z}; }
float dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point cross(Point a, Point b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Point unit(Point a) { return 1 / std::sqrt(std::max(dot(a, a), 1e-30f)) * a; }
Paint operator*(float s, Paint p) { return {s * p.r, s * p.g, s * p.b, s * p.a}; }
Paint operator+(Paint p, Paint q) { return {p.r + q.r, p.g + q.g, p.b + q.b, p.a + q.a}; }
Paint operator-(Paint p, Paint q) { return {p.r - q.r, p.g - q.g, p.b - q.b, p.a - q.a}; }
bool same(Point a, Point b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

std::uint32_t byte(float value) { return static_cast<std::uint32_t>(std::clamp(value, 0.0f, 1.0f) * 255 + 0.5f); }
std::uint32_t packed(Paint p) { return byte(p.r) | byte(p.g) << 8 | byte(p.b) << 16; }

// Towards the viewer, or edge-on where interpolation has turned it beyond.
std::uint32_t packed(Point normal) {
  normal.z = std::min(normal.z, 0.0f);
  const Point n = unit(normal);
  const auto two_bytes = [](float v) { return static_cast<std::uint32_t>(static_cast<std::uint16_t>(static_cast<std::int16_t>(v * 32767))); };
  return two_bytes(n.x) | two_bytes(n.y) << 16;
}
Point unpacked(std::uint32_t normal) {
  const auto part = [](std::uint32_t v) { return static_cast<float>(static_cast<std::int16_t>(static_cast<std::uint16_t>(v))) / 32767; };
  const float x = part(normal & 0xffff), y = part(normal >> 16);
  return {x, y, -std::sqrt(std::max(0.0f, 1 - x * x - y * y))};
}

// Points that are nowhere, or too far away for numbers of a picture, have no place in it.
bool is_finite(Point a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

// The first sample whose middle is at or behind `x`, within 0 and `end`; 0 if `x` is not a number.
int first_sample(float x, int end) { return x > 0.5f ? static_cast<int>(std::min(std::ceil(x - 0.5f), static_cast<float>(end))) : 0; }

}  // namespace

// Where an edge crosses a row. Its end points come in one order, so that neighbours agree on every sample between them.
struct Picture::Edge {
  Edge(Point a, Point b) {
    if (std::pair(b.y, b.x) < std::pair(a.y, a.x)) std::swap(a, b);
    begin = a.y, end = b.y, x = a.x;
    slope = end > begin ? (b.x - a.x) / (end - begin) : 0;
  }
  bool crosses(float row) const { return begin <= row && row < end; }
  float at(float row) const { return x + (row - begin) * slope; }
  float begin, end, x, slope;
};

namespace {

// A quantity that is linear over a triangle: its value in the middle of sample 0, 0, and its steps.
template <class T>
struct Linear {
  T value, dx, dy;
  T at(float x, float y) const { return value + x * dx + y * dy; }
};

}  // namespace

class Picture::Plan {
 public:
  Plan(Point a, Point b, Point c)
      : a_(a), x1_(b.x - a.x), y1_(b.y - a.y), x2_(c.x - a.x), y2_(c.y - a.y) {
    const float area = x1_ * y2_ - x2_ * y1_;
    scale_ = std::abs(area) > 1e-4f ? 1 / area : 0;  // slivers have the values of their first corner
  }
  template <class T>
  Linear<T> linear(T a, T b, T c) const {
    const T u = b - a, v = c - a;
    const T dx = scale_ * (y2_ * u - y1_ * v), dy = scale_ * (x1_ * v - x2_ * u);
    return {a + (0.5f - a_.x) * dx + (0.5f - a_.y) * dy, dx, dy};
  }

 private:
  Point a_;
  float x1_, y1_, x2_, y2_, scale_;
};

Picture::Picture(int width, int height, int samples, const Camera& camera, const Lighting& lighting)
    : width_(width), height_(height), samples_(samples), columns_(width * samples), rows_(height * samples),
      scale_(static_cast<float>(camera.scale * samples)), perspective_(static_cast<float>(camera.perspective)), view_(camera.view),
      lighting_(lighting), shine_(shine_steps + 1) {
  const auto size = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  depth_.assign(size, -std::numeric_limits<float>::infinity());
  color_ = std::make_unique_for_overwrite<std::uint32_t[]>(size);
  normal_ = std::make_unique_for_overwrite<std::uint32_t[]>(size);  // read where something was drawn
  item_.assign(size, -1);
  for (const Light& light : lighting_.lights) halves_.push_back(unit(light.direction + Point{0, 0, -1}));
  for (std::size_t i = 0; i <= shine_steps; ++i)
    shine_[i] = std::pow(static_cast<float>(i) / shine_steps, std::max(lighting_.shininess, 1.0f));
  if (perspective_ > 0) planes_.push_back({0, 0, perspective_, 0.98f});  // 1 + perspective z >= 0.02
}

void Picture::background(const Paint& top, const Paint& bottom) {
  has_background_ = true;
  for (int row = 0; row < rows_; ++row) {
    const float part = static_cast<float>(row / samples_) / static_cast<float>(std::max(height_ - 1, 1));
    std::fill_n(color_.get() + static_cast<std::ptrdiff_t>(row) * columns_, columns_, packed(top + part * (bottom - top)));
  }
}

void Picture::begin() {
  if (!has_background_) background({1, 1, 1, 1}, {1, 1, 1, 1});
}

void Picture::clip(const Plane& plane) { planes_.push_back(plane); }

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
  return {{0.5f * static_cast<float>(columns_) + scale_ * weight * corner.eye.x,
           0.5f * static_cast<float>(rows_) - scale_ * weight * corner.eye.y, nearness(corner.eye.z, weight)},
          weight * corner.normal, weight * corner.paint, weight};
}

void Picture::triangles(const Mesh& mesh) {
  begin();
  const std::size_t n = mesh.points.size() / 3;
  std::vector<Corner> corners(n);
  std::vector<Vertex> vertices(n);
  const bool smooth = !mesh.normals.empty();
  for (std::size_t i = 0; i < n; ++i) {
    const float* c = mesh.colors.data() + 4 * i;
    corners[i] = {to_eye(mesh.points.data() + 3 * i), smooth ? turned(mesh.normals.data() + 3 * i) : Point{}, {c[0], c[1], c[2], c[3]}};
    vertices[i] = project(corners[i]);
  }
  for (std::size_t t = 0; t < mesh.triangles.size() / 3; ++t) {
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
    if (away > 0)
      for (Point& normal : normals) normal = -1.0f * normal;
    if (planes_.empty()) {
      std::array<Vertex, 3> v{vertices[index[0]], vertices[index[1]], vertices[index[2]]};
      for (std::size_t k = 0; k < 3; ++k) v[k].normal = v[k].weight * normals[k];
      add(v, mesh.items[t]);
    } else {
      std::array<Corner, 3> whole{corners[index[0]], corners[index[1]], corners[index[2]]};
      for (std::size_t k = 0; k < 3; ++k) whole[k].normal = normals[k];
      clipped(whole, mesh.items[t]);
    }
  }
}

// Sutherland and Hodgman: a triangle that loses corners to the planes has up to three more.
void Picture::clipped(std::array<Corner, 3> corners, std::int32_t item) {
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

// The samples of a row between the edges of a triangle: the first one, and the one after the last.
std::pair<int, int> Picture::span(std::span<const Edge, 3> edges, int row) const {
  const float middle = static_cast<float>(row) + 0.5f;
  float left = std::numeric_limits<float>::infinity(), right = -left;
  for (const Edge& edge : edges) {
    if (!edge.crosses(middle)) continue;
    left = std::min(left, edge.at(middle));
    right = std::max(right, edge.at(middle));
  }
  if (left > right) return {0, 0};
  return {first_sample(left, columns_), first_sample(right, columns_)};
}

// Rows and columns of samples whose middle is inside: write(row, first column, last column + 1).
template <class Write>
void Picture::fill(const std::array<Vertex, 3>& v, Write&& write) const {
  const Edge edges[] = {{v[0].place, v[1].place}, {v[1].place, v[2].place}, {v[2].place, v[0].place}};
  const auto [low, high] = std::minmax({v[0].place.y, v[1].place.y, v[2].place.y});
  const int end = first_sample(high, rows_);
  for (int row = first_sample(low, rows_); row < end; ++row) {
    const auto [begin, stop] = span(edges, row);
    if (begin < stop) write(row, begin, stop);
  }
}

// The samples of a triangle, pixel by pixel. Those that it wins in a pixel are shaded at once, in their middle, which is inside of it:
// shade(x, y) gives color and normal.
template <class Shade>
void Picture::cover(const std::array<Vertex, 3>& v, const Plan& plan, std::int32_t item, Shade&& shade) {
  const auto near = plan.linear(v[0].place.z, v[1].place.z, v[2].place.z);
  const Edge edges[] = {{v[0].place, v[1].place}, {v[1].place, v[2].place}, {v[2].place, v[0].place}};
  const auto [low, high] = std::minmax({v[0].place.y, v[1].place.y, v[2].place.y});
  const int end = first_sample(high, rows_);
  std::array<std::size_t, 64> won;  // at most eight samples in each direction
  std::array<int, 8> begins, ends;
  for (int row = first_sample(low, rows_); row < end;) {
    const int first = row, stop = std::min(row - row % samples_ + samples_, end);
    int left = columns_, right = 0;
    for (; row < stop; ++row) {
      const auto [b, e] = span(edges, row);
      begins[static_cast<std::size_t>(row - first)] = b, ends[static_cast<std::size_t>(row - first)] = e;
      if (b < e) left = std::min(left, b), right = std::max(right, e);
    }
    for (int column = left - left % samples_; column < right; column += samples_) {
      std::size_t count = 0;
      int x_sum = 0, y_sum = 0;
      for (int y = first; y < stop; ++y) {
        const auto j = static_cast<std::size_t>(y - first);
        const std::size_t start = static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_);
        const int last = std::min(column + samples_, ends[j]);
        for (int x = std::max(column, begins[j]); x < last; ++x) {
          const float n = near.at(static_cast<float>(x), static_cast<float>(y));
          const std::size_t k = start + static_cast<std::size_t>(x);
          if (n <= depth_[k]) continue;
          depth_[k] = n, item_[k] = item;
          won[count++] = k, x_sum += x, y_sum += y;
        }
      }
      if (count == 0) continue;
      const float part = 1 / static_cast<float>(count);
      const auto [color, normal] = shade(part * static_cast<float>(x_sum), part * static_cast<float>(y_sum));
      for (std::size_t i = 0; i < count; ++i) color_[won[i]] = color, normal_[won[i]] = normal;
    }
  }
}

void Picture::add(const std::array<Vertex, 3>& v, std::int32_t item) {
  if (!std::ranges::all_of(v, [](const Vertex& corner) { return is_finite(corner.place); })) return;
  const float opacity = v[0].paint.a / v[0].weight;
  if (opacity < 0.999f) {
    if (opacity > 0.001f) sheets_.push_back({v, v[0].place.z + v[1].place.z + v[2].place.z, item});
    return;
  }
  const Plan plan(v[0].place, v[1].place, v[2].place);
  const auto color_of = [](const Vertex& corner) { return packed(1 / corner.weight * corner.paint) | to_be_lit; };
  const std::uint32_t paint = color_of(v[0]);
  const bool one_paint = color_of(v[1]) == paint && color_of(v[2]) == paint;
  if (same(v[0].normal, v[1].normal) && same(v[0].normal, v[2].normal) && one_paint) {
    const std::uint32_t normal = packed(v[0].normal);
    cover(v, plan, item, [&](float, float) { return std::pair(paint, normal); });
    return;
  }
  const auto normals = plan.linear(v[0].normal, v[1].normal, v[2].normal);
  if (one_paint) {
    cover(v, plan, item, [&](float x, float y) { return std::pair(paint, packed(normals.at(x, y))); });
    return;
  }
  const auto paints = plan.linear(v[0].paint, v[1].paint, v[2].paint);
  const auto weights = plan.linear(v[0].weight, v[1].weight, v[2].weight);
  cover(v, plan, item, [&](float x, float y) {
    return std::pair(packed(1 / weights.at(x, y) * paints.at(x, y)) | to_be_lit, packed(normals.at(x, y)));
  });
}

// Discs with the depth and the normals of spheres; in perspective, their outline is that of a sphere seen along its own axis.
void Picture::spheres(std::span<const double> centers, std::span<const double> radii, std::span<const float> colors,
                      std::span<const std::int32_t> items) {
  begin();
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const auto r = static_cast<float>(radii[i]);
    const Point c = to_eye(centers.data() + 3 * i);
    if (1 + perspective_ * (c.z - r) < 0.02f || r <= 0) continue;
    if (std::ranges::any_of(planes_, [&](const Plane& p) { return p.a * c.x + p.b * c.y + p.c * c.z + p.d < 0; })) continue;
    const float* rgb = colors.data() + 4 * i;
    const std::uint32_t color = packed(Paint{rgb[0], rgb[1], rgb[2], 1}) | to_be_lit;
    const Vertex middle = project({c, {}, {}});
    const float size = scale_ * middle.weight * r, cx = middle.place.x, cy = middle.place.y;
    if (!is_finite(middle.place) || !std::isfinite(size)) continue;
    const int end = first_sample(cy + size, rows_);
    for (int row = first_sample(cy - size, rows_); row < end; ++row) {
      const float dy = (static_cast<float>(row) + 0.5f - cy) / size, chord = std::sqrt(std::max(0.0f, 1 - dy * dy)) * size;
      const int stop = first_sample(cx + chord, columns_);
      const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
      for (int x = first_sample(cx - chord, columns_); x < stop; ++x) {
        const float dx = (static_cast<float>(x) + 0.5f - cx) / size;
        const float dz = std::sqrt(std::max(0.0f, 1 - dx * dx - dy * dy)), z = c.z - r * dz;
        const float n = nearness(z, 1 / (1 + perspective_ * z));
        const std::size_t k = start + static_cast<std::size_t>(x);
        if (n <= depth_[k]) continue;
        depth_[k] = n, color_[k] = color, normal_[k] = packed(Point{dx, -dy, -dz}), item_[k] = items[i];
      }
    }
  }
}

// Samples within `half` of a segment, in steps along the axis in which it is longer: write(sample, nearness).
template <class Write>
void Picture::walk(Point a, Point b, float half, Write&& write) const {
  const float length = std::max(std::hypot(b.x - a.x, b.y - a.y), 1e-6f);
  const Point end = 0.5f * half / length * (b - a);  // segments of one line overlap a little
  a = a - Point{end.x, end.y, 0}, b = b + Point{end.x, end.y, 0};
  const bool flat = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
  if (!flat) std::swap(a.x, a.y), std::swap(b.x, b.y);
  if (b.x < a.x) std::swap(a, b);
  const float run = std::max(b.x - a.x, 1e-6f), slope = (b.y - a.y) / run, reach = half * std::sqrt(1 + slope * slope);
  const int length_limit = flat ? columns_ : rows_, side_limit = flat ? rows_ : columns_;
  const int stop = first_sample(b.x, length_limit);
  for (int i = first_sample(a.x, length_limit); i < stop; ++i) {
    const float s = (static_cast<float>(i) + 0.5f - a.x) / run, middle = a.y + s * (b.y - a.y);
    const int side_stop = first_sample(middle + reach, side_limit);
    for (int j = first_sample(middle - reach, side_limit); j < side_stop; ++j) {
      const auto row = static_cast<std::size_t>(flat ? j : i), column = static_cast<std::size_t>(flat ? i : j);
      write(row * static_cast<std::size_t>(columns_) + column, a.z + s * (b.z - a.z));
    }
  }
}

void Picture::lines(std::span<const double> segments, std::span<const float> colors, double width, double lift,
                    std::span<const std::int32_t> items) {
  begin();
  const float half = 0.5f * std::max(static_cast<float>(width * samples_), 1.0f);
  for (std::size_t i = 0; i < segments.size() / 6; ++i) {
    std::array<Point, 2> ends{to_eye(segments.data() + 6 * i), to_eye(segments.data() + 6 * i + 3)};
    float begin = 0, stop = 1;
    for (const Plane& p : planes_) {
      const auto inside = [&](Point c) { return p.a * c.x + p.b * c.y + p.c * c.z + p.d; };
      const float d0 = inside(ends[0]), d1 = inside(ends[1]);
      if (d0 < 0 && d1 < 0) stop = -1;
      if (d0 < 0 && d1 >= 0) begin = std::max(begin, d0 / (d0 - d1));
      if (d0 >= 0 && d1 < 0) stop = std::min(stop, d0 / (d0 - d1));
    }
    if (begin >= stop) continue;
    const Point whole = ends[1] - ends[0];
    ends = {ends[0] + begin * whole, ends[0] + stop * whole};
    std::array<Point, 2> places{};
    for (std::size_t k = 0; k < 2; ++k) {
      places[k] = project({ends[k], {}, {}}).place;
      const float z = ends[k].z - static_cast<float>(lift);
      places[k].z = nearness(z, 1 / std::max(1 + perspective_ * z, 0.01f));
    }
    if (!is_finite(places[0]) || !is_finite(places[1])) continue;
    const float* c = colors.data() + 4 * i;
    const std::uint32_t color = packed(Paint{c[0], c[1], c[2], 1});
    walk(places[0], places[1], half, [&](std::size_t k, float n) {
      if (n < depth_[k]) return;
      depth_[k] = n, color_[k] = color, item_[k] = items[i];
    });
  }
}

// How bright a surface is; `shine` is what it reflects besides.
float Picture::strength(float nx, float ny, float nz, float& shine) const {
  float bright = lighting_.ambient;
  shine = 0;
  for (std::size_t i = 0; i < lighting_.lights.size(); ++i) {
    const Light& light = lighting_.lights[i];
    const Point n{nx, ny, nz};
    const float facing = dot(n, light.direction), half = dot(n, halves_[i]);
    bright += light.diffuse * std::max(facing, 0.0f);
    if (facing > 0 && half > 0) shine += light.specular * shine_[static_cast<std::size_t>(std::min(half, 1.0f) * shine_steps)];
  }
  return bright;
}

// Whether all samples of a pixel are to be lit, and their normals differ so little that one light will do for all of them; they have the
// mean of their colors and normals then.
bool Picture::join(std::size_t first) {
  std::uint32_t even = 0, odd = 0;
  int x = 0, y = 0;
  const auto component = [](std::uint32_t v) { return static_cast<int>(static_cast<std::int16_t>(static_cast<std::uint16_t>(v))); };
  const int x0 = component(normal_[first] & 0xffff), y0 = component(normal_[first] >> 16);
  for (int j = 0; j < samples_; ++j) {
    for (int i = 0; i < samples_; ++i) {
      const std::size_t k = first + static_cast<std::size_t>(j * columns_ + i);
      if (color_[k] < to_be_lit) return false;
      const int nx = component(normal_[k] & 0xffff), ny = component(normal_[k] >> 16);
      if (std::abs(nx - x0) > alike || std::abs(ny - y0) > alike) return false;
      x += nx, y += ny;
      even += color_[k] & 0xff00ffu, odd += color_[k] >> 8 & 255;
    }
  }
  const auto count = static_cast<std::uint32_t>(samples_ * samples_);
  const auto mean = [n = samples_ * samples_](int sum) { return static_cast<std::uint32_t>(static_cast<std::uint16_t>(static_cast<std::int16_t>(sum / n))); };
  const std::uint32_t color = (((even & 0xffff) + count / 2) / count) | (((odd + count / 2) / count) << 8) | ((((even >> 16) + count / 2) / count) << 16);
  color_[first] = color | to_be_lit;
  normal_[first] = mean(x) | mean(y) << 16;
  return true;
}

// All samples of a row of pixels; side by side, many have one color and normal.
void Picture::light(int pixel_row) {
  const auto lit = [&](std::uint32_t color, std::uint32_t normal) {
    const Point n = unpacked(normal);
    float shine = 0;
    const float bright = strength(n.x, n.y, n.z, shine);
    const auto channel = [&](int shift) { return bright * static_cast<float>(color >> shift & 255) / 255 + shine; };
    return packed(Paint{channel(0), channel(8), channel(16), 1});
  };
  std::uint32_t last_color = 0, last_normal = 0, last = 0;
  for (int column = 0; column < columns_; column += samples_) {
    const std::size_t first = static_cast<std::size_t>(pixel_row * samples_) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    const bool is_one = join(first);
    for (int j = 0; j < samples_; ++j) {
      for (int i = 0; i < samples_; ++i) {
        const std::size_t k = first + static_cast<std::size_t>(j * columns_ + i);
        const std::uint32_t color = is_one ? color_[first] : color_[k], normal = is_one ? normal_[first] : normal_[k];
        if (is_one && i + j > 0) {
          color_[k] = last;
          continue;
        }
        if (color < to_be_lit) continue;
        if (color != last_color || normal != last_normal) last = lit(color, normal), last_color = color, last_normal = normal;
        color_[k] = last;
      }
    }
  }
}

// Darken the rim of what stands before something else of another item, half a pixel wide, so that parts of one color can be told apart.
void Picture::outline(int pixel_row) {
  const int reach = std::max(1, samples_ / 2 + samples_ % 2);
  const int stop = std::min((pixel_row + 1) * samples_, rows_ - reach);
  for (int row = std::max(pixel_row * samples_, reach); row < stop; ++row) {
    for (int column = reach; column + reach < columns_; ++column) {
      const std::size_t k = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
      if (color_[k] < to_be_lit) continue;
      const auto behind = [&](std::size_t other) { return item_[other] != item_[k] && depth_[other] < depth_[k]; };
      bool rim = false;
      for (int i = 1; i <= reach && !rim; ++i) {
        const auto side = static_cast<std::size_t>(i), above = side * static_cast<std::size_t>(columns_);
        rim = behind(k - side) || behind(k + side) || behind(k - above) || behind(k + above);
      }
      if (rim) color_[k] = (color_[k] >> 1 & 0x7f7f7fu) | to_be_lit;
    }
  }
}

void Picture::blend(const Sheet& sheet) {
  const auto& v = sheet.corners;
  const Plan plan(v[0].place, v[1].place, v[2].place);
  const auto near = plan.linear(v[0].place.z, v[1].place.z, v[2].place.z);
  const auto normals = plan.linear(v[0].normal, v[1].normal, v[2].normal);
  const auto paints = plan.linear(v[0].paint, v[1].paint, v[2].paint);
  const auto weights = plan.linear(v[0].weight, v[1].weight, v[2].weight);
  fill(v, [&](int row, int begin, int end) {
    const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
    for (int x = begin; x < end; ++x) {
      const float fx = static_cast<float>(x), fy = static_cast<float>(row);
      const std::size_t k = start + static_cast<std::size_t>(x);
      if (near.at(fx, fy) <= depth_[k]) continue;
      const Point n = unpacked(packed(normals.at(fx, fy)));
      const Paint paint = 1 / weights.at(fx, fy) * paints.at(fx, fy);
      float shine = 0;
      const float bright = strength(n.x, n.y, n.z, shine), opacity = std::clamp(paint.a, 0.0f, 1.0f);
      const auto channel = [&](int shift, float front) {
        const float behind = static_cast<float>(color_[k] >> shift & 255) / 255;
        return behind + opacity * (std::min(bright * front + shine, 1.0f) - behind);
      };
      color_[k] = packed(Paint{channel(0, paint.r), channel(8, paint.g), channel(16, paint.b), 1});
      item_[k] = sheet.item;
    }
  });
}

std::vector<std::uint8_t> Picture::develop() {
  begin();
  for (int row = 0; row < height_; ++row) outline(row), light(row);
  std::ranges::stable_sort(sheets_, {}, &Sheet::nearness);
  for (const Sheet& sheet : sheets_) blend(sheet);
  sheets_.clear();

  const auto width = static_cast<std::size_t>(width_), height = static_cast<std::size_t>(height_), s = static_cast<std::size_t>(samples_);
  std::vector<std::uint8_t> image(3 * width * height);
  const auto count = static_cast<std::uint32_t>(s * s);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      std::uint32_t even = 0, odd = 0;  // red and blue side by side, green
      for (std::size_t j = 0; j < s; ++j) {
        const std::uint32_t* row = color_.get() + (y * s + j) * width * s + x * s;
        for (std::size_t i = 0; i < s; ++i) even += row[i] & 0xff00ffu, odd += row[i] >> 8 & 255;
      }
      std::uint8_t* pixel = image.data() + 3 * (y * width + x);
      pixel[0] = static_cast<std::uint8_t>(((even & 0xffff) + count / 2) / count);
      pixel[1] = static_cast<std::uint8_t>((odd + count / 2) / count);
      pixel[2] = static_cast<std::uint8_t>(((even >> 16) + count / 2) / count);
    }
  }
  return image;
}

std::vector<std::int32_t> Picture::items() const {
  const auto width = static_cast<std::size_t>(width_), height = static_cast<std::size_t>(height_), s = static_cast<std::size_t>(samples_);
  std::vector<std::int32_t> result(width * height);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) result[y * width + x] = item_[(y * s + s / 2) * width * s + x * s + s / 2];
  return result;
}

}  // namespace dalembert
