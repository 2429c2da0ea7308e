// Spheres and lines of pictures.
#include <algorithm>
#include <cmath>
#include <utility>

#include "dalembert/pictures/picture.hpp"
#include "points.hpp"
#include "squares.hpp"

namespace dalembert {

void Picture::spheres(std::span<const double> centers, std::span<const double> radii, std::span<const float> colors,
                      std::span<const std::int32_t> items) {
  begin();
  LargeVector<Ball> balls;
  balls.reserve(radii.size());
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const auto r = static_cast<float>(radii[i]);
    const Point c = to_eye(centers.data() + 3 * i);
    if (1 + perspective_ * (c.z - r) < 0.02f || r <= 0 || !is_inside(c)) continue;
    const float* rgb = colors.data() + 4 * i;
    const Vertex middle = project({c, {}, {}});
    const float size = scale_ * middle.weight() * r;
    if (is_finite(middle.place) && std::isfinite(size))
      balls.push_back({middle.place.x, middle.place.y, size, c.z, r,
                       packed(Paint{rgb[0], rgb[1], rgb[2], 1}) | to_be_lit, items[i]});
  }
  if (balls.size() >= Squares::many)
    Squares(columns_, rows_).sort(std::span(balls), [](const Ball& ball) { return Point{ball.x, ball.y, 0}; });
  for (const Ball& ball : balls) sphere(ball);
}

// A disc with the depth and the normals of a sphere, four samples at a time, of a pixel or of a row; with
// perspective, its outline is that of a sphere on the optical axis.
void Picture::sphere(const Ball& ball) {
  const auto [cx, cy, size, middle, radius, color, item] = ball;
  const float part = 1 / size, nearest = middle - radius;
  const Four front = four(nearness(nearest, 1 / (1 + perspective_ * nearest)));
  const int begin = first_sample(cx - size, columns_), stop = first_sample(cx + size, columns_);
  const int first = first_sample(cy - size, rows_), end = first_sample(cy + size, rows_);
  const int wide = has_squares() ? 2 : 4, high = 4 / wide;
  const FourWhole right = has_squares() ? FourWhole{0, 1, 0, 1} : FourWhole{0, 1, 2, 3},
                  down = has_squares() ? FourWhole{0, 0, 1, 1} : FourWhole{};
  for (int row = first / high * high; row < end; row += high) {
    const FourWhole rows = four(row) + down, are_inside = (rows >= four(first)) & (rows < four(end));
    const Four dy = (as_numbers(rows) + four(0.5f) - four(cy)) * four(part);
    for (int x = has_squares() ? begin & ~1 : begin; x < stop; x += wide) {
      const std::size_t k = sample(x, row);
      const auto known = load<Four>(&depth_[k]);
      if (bits(front > known) == 0) continue;
      const FourWhole columns = four(x) + right;
      const Four dx = (as_numbers(columns) + four(0.5f - cx)) * four(part), rest = four(1.0f) - dy * dy - dx * dx;
      const Four dz = root(larger(rest, four(0.0f))), z = four(middle) - four(radius) * dz;
      const Four n = perspective_ > 0 ? four(1.0f) / (four(1.0f) + four(perspective_) * z) : -z;
      const FourWhole won =
          (rest > four(0.0f)) & are_inside & (columns >= four(begin)) & (columns < four(stop)) & (n > known);
      if (bits(won) == 0) continue;
      store(won ? n : known, &depth_[k]);
      store_some(won, four(static_cast<std::int32_t>(color)), &color_[k]);
      store_some(won, (whole(dx * four(32767.0f)) & four(0xffff)) | whole(-dy * four(32767.0f)) << 16, &normal_[k]);
      store_some(won, four(item), &item_[k]);
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
      write(flat ? sample(i, j) : sample(j, i), a.z + s * (b.z - a.z));
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
    const Point all = ends[1] - ends[0];
    ends = {ends[0] + begin * all, ends[0] + stop * all};
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

}  // namespace dalembert
