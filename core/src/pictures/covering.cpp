// Which samples a triangle covers, and what they keep of it.
#include <algorithm>
#include <utility>

#include "dalembert/pictures/picture.hpp"
#include "points.hpp"

namespace dalembert {
namespace {

// Where an edge is at a row; its end points come in one order, so that neighbours agree on every sample between them.
struct Edge {
  Edge() = default;
  Edge(Point a, Point b) : begin(a.y), x(a.x), slope(b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0) {}
  float at(float row) const { return x + (row - begin) * slope; }
  float begin = 0, x = 0, slope = 0;
};

// A quantity that is linear over a triangle: its value in the middle of sample 0, 0, and its steps.
template <class T>
struct Linear {
  T value, dx, dy;
  DALEMBERT_INLINE T at(float x, float y) const { return value + x * dx + y * dy; }
};

// One component of a quantity that is linear over a triangle, at four places.
DALEMBERT_INLINE inline Four component(const Linear<Four>& q, int i, Four x, Four y) { return four(q.value[i]) + x * four(q.dx[i]) + y * four(q.dy[i]); }

constexpr Four square_x{0, 1, 0, 1}, square_y{0, 0, 1, 1};

// The middle of those samples of a square that are won, by their bits.
struct Middle {
  float x, y;
};
constexpr std::array<Middle, 16> middles = [] {
  std::array<Middle, 16> result{};
  for (std::size_t won = 1; won < 16; ++won) {
    float count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      if ((won >> k & 1) == 0) continue;
      count += 1, result[won].x += static_cast<float>(k % 2), result[won].y += static_cast<float>(k / 2);
    }
    result[won].x /= count, result[won].y /= count;
  }
  return result;
}();

}  // namespace

// Between which samples of a row a triangle lies: one of its edges passes all of its rows, the other two share them.
class Picture::Sides {
 public:
  explicit Sides(const Three& v) {
    std::array<Point, 3> p{v[0].place, v[1].place, v[2].place};
    const auto order = [&p](std::size_t i, std::size_t j) {
      if (std::pair(p[j].y, p[j].x) < std::pair(p[i].y, p[i].x)) std::swap(p[i], p[j]);
    };
    order(0, 1), order(1, 2), order(0, 1);
    low = p[0].y, high = p[2].y, middle_ = p[1].y;
    long_ = Edge(p[0], p[2]), upper_ = Edge(p[0], p[1]), lower_ = Edge(p[1], p[2]);
  }
  std::pair<float, float> at(float row) const {
    const float a = long_.at(row), b = row < middle_ ? upper_.at(row) : lower_.at(row);
    return std::minmax(a, b);
  }
  float low, high;

 private:
  Edge long_, upper_, lower_;
  float middle_;
};

class Picture::Plan {
 public:
  Plan(Point a, Point b, Point c) : a_(a), x1_(b.x - a.x), y1_(b.y - a.y), x2_(c.x - a.x), y2_(c.y - a.y) {
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

// The samples of a row between the edges of a triangle: the first one, and the one after the last.
DALEMBERT_INLINE inline std::pair<int, int> Picture::span(const Sides& sides, int row) const {
  const auto [left, right] = sides.at(static_cast<float>(row) + 0.5f);
  return {first_sample(left, columns_), first_sample(right, columns_)};
}

// The samples of a triangle, pixel by pixel. Those that it wins in a pixel are shaded at once, in their middle, which is inside of it:
// shade(x, y) gives color and normal at four places.
template <class Shade>
void Picture::cover(const Three& v, const Plan& plan, std::int32_t item, Shade&& shade) {
  const auto near = plan.linear(v[0].place.z, v[1].place.z, v[2].place.z);
  const Sides sides(v);
  const int end = first_sample(sides.high, rows_);
  std::array<std::size_t, 64> won;  // at most eight samples in each direction
  std::array<int, 8> begins, ends;
  for (int row = first_sample(sides.low, rows_); row < end;) {
    const int first = row, stop = std::min(row - row % samples_ + samples_, end);
    int left = columns_, right = 0;
    for (; row < stop; ++row) {
      const auto [b, e] = span(sides, row);
      begins[static_cast<std::size_t>(row - first)] = b, ends[static_cast<std::size_t>(row - first)] = e;
      if (b < e) left = std::min(left, b), right = std::max(right, e);
    }
    for (int column = left - left % samples_; column < right; column += samples_) {
      std::size_t count = 0;
      int x_sum = 0, y_sum = 0;
      for (int y = first; y < stop; ++y) {
        const auto j = static_cast<std::size_t>(y - first);
        const std::size_t start = row_start(y);
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
      const auto [color, normal] = shade(four(part * static_cast<float>(x_sum)), four(part * static_cast<float>(y_sum)));
      for (std::size_t i = 0; i < count; ++i)
        color_[won[i]] = static_cast<std::uint32_t>(color[0]), normal_[won[i]] = static_cast<std::uint32_t>(normal[0]);
    }
  }
}

// The same with two samples in each direction, all four of a pixel side by side, and four pixels shaded together.
template <class Shade>
void Picture::cover_squares(const Three& v, const Plan& plan, std::int32_t item, Shade&& shade) {
  const auto near = plan.linear(v[0].place.z, v[1].place.z, v[2].place.z);
  const Sides sides(v);
  const int first = first_sample(sides.low, rows_), end = first_sample(sides.high, rows_);
  constexpr std::size_t most = 32;
  std::array<std::size_t, most> places;  // of pixels that wait for their color
  std::array<std::uint32_t, most> samples;
  std::array<float, most> xs, ys;
  std::size_t waiting = 0;
  const auto shade_all = [&] {
    for (std::size_t i = waiting; i % 4 != 0; ++i) xs[i] = xs[waiting - 1], ys[i] = ys[waiting - 1];
    for (std::size_t i = 0; i < waiting; i += 4) {
      const auto [color, normal] = shade(load_row<Four>(&xs[i]), load_row<Four>(&ys[i]));
      for (std::size_t j = 0; j < 4 && i + j < waiting; ++j) {
        const std::size_t k = places[i + j], below = k + static_cast<std::size_t>(columns_);
        const FourWhole won = (four(static_cast<std::int32_t>(samples[i + j])) & FourWhole{1, 2, 4, 8}) != FourWhole{};
        const auto keep = [&](std::uint32_t* to, std::int32_t value) {
          store_square(won ? four(value) : load_square<FourWhole>(to + k, to + below), to + k, to + below);
        };
        keep(color_.data(), color[j]), keep(normal_.data(), normal[j]);
      }
    }
    waiting = 0;
  };
  for (int row = first & ~1; row < end; row += 2) {
    const auto [b0, e0] = row >= first ? span(sides, row) : std::pair(columns_, 0);
    const auto [b1, e1] = row + 1 < end ? span(sides, row + 1) : std::pair(columns_, 0);
    const int left = std::min(b0, b1) & ~1, right = std::max(e0, e1);
    const FourWhole begins{b0, b0, b1, b1}, ends{e0, e0, e1, e1};
    const Four y = four(static_cast<float>(row)) + square_y;
    const std::size_t start = row_start(row);
    for (int column = left; column < right; column += 2) {
      const Four x = four(static_cast<float>(column)) + square_x;
      const FourWhole columns = whole(x);
      const std::size_t k = start + static_cast<std::size_t>(column), below = k + static_cast<std::size_t>(columns_);
      const Four known = load_square<Four>(&depth_[k], &depth_[below]);
      const Four n = near.value + x * near.dx + y * near.dy;
      const FourWhole won = (columns >= begins) & (columns < ends) & (n > known);
      const std::uint32_t which = bits(won);
      if (which == 0) continue;
      store_square(won ? n : known, &depth_[k], &depth_[below]);
      store_square(won ? four(item) : load_square<FourWhole>(&item_[k], &item_[below]), &item_[k], &item_[below]);
      places[waiting] = k, samples[waiting] = which;
      xs[waiting] = static_cast<float>(column) + middles[which].x, ys[waiting] = static_cast<float>(row) + middles[which].y;
      if (++waiting == most) shade_all();
    }
  }
  if (waiting > 0) shade_all();
}

void Picture::add(const Three& v, std::int32_t item) {
  if (!is_finite(v[0].place) || !is_finite(v[1].place) || !is_finite(v[2].place)) return;
  const float opacity = v[0].paint[3] / v[0].weight();
  if (opacity < 0.999f) {
    if (opacity > 0.001f) sheets_.push_back({v, v[0].place.z + v[1].place.z + v[2].place.z, item});
    return;
  }
  const Plan plan(v[0].place, v[1].place, v[2].place);
  const auto covered = [&](auto&& shade) { samples_ == 2 ? cover_squares(v, plan, item, shade) : cover(v, plan, item, shade); };
  const bool has_one_color = v[0].color == v[1].color && v[0].color == v[2].color;
  const auto color = four(static_cast<std::int32_t>(v[0].color));
  const auto paints = plan.linear(v[0].paint, v[1].paint, v[2].paint);
  const auto color_at = [&](Four x, Four y, Four weight) {
    return packed(component(paints, 0, x, y) / weight, component(paints, 1, x, y) / weight, component(paints, 2, x, y) / weight) |
           four(static_cast<std::int32_t>(to_be_lit));
  };
  if (bits((v[0].normal == v[1].normal) & (v[0].normal == v[2].normal)) == 15) {  // flat, seen from far away: one normal for all of it
    const Four n = v[0].normal, weight = four(v[0].weight());
    const FourWhole normal = packed_normal(four(n[0]), four(n[1]), four(n[2]));
    if (has_one_color)
      covered([&](Four, Four) { return std::pair(color, normal); });
    else
      covered([&](Four x, Four y) { return std::pair(color_at(x, y, weight), normal); });
    return;
  }
  const auto normals = plan.linear(v[0].normal, v[1].normal, v[2].normal);
  const auto normal_at = [&](Four x, Four y) { return packed_normal(component(normals, 0, x, y), component(normals, 1, x, y), component(normals, 2, x, y)); };
  if (has_one_color)
    covered([&](Four x, Four y) { return std::pair(color, normal_at(x, y)); });
  else
    covered([&](Four x, Four y) { return std::pair(color_at(x, y, component(normals, 3, x, y)), normal_at(x, y)); });
}

void Picture::blend(const Sheet& sheet) {
  const auto& v = sheet.corners;
  const Plan plan(v[0].place, v[1].place, v[2].place);
  const auto near = plan.linear(v[0].place.z, v[1].place.z, v[2].place.z);
  const auto normals = plan.linear(v[0].normal, v[1].normal, v[2].normal), paints = plan.linear(v[0].paint, v[1].paint, v[2].paint);
  const Sides sides(v);
  const int last = first_sample(sides.high, rows_);
  for (int row = first_sample(sides.low, rows_); row < last; ++row) {
    const auto [begin, end] = span(sides, row);
    const std::size_t start = row_start(row);
    for (int x = begin; x < end; ++x) {
      const float fx = static_cast<float>(x), fy = static_cast<float>(row);
      const std::size_t k = start + static_cast<std::size_t>(x);
      if (near.at(fx, fy) <= depth_[k]) continue;
      const Four n = normals.at(fx, fy), paint = paints.at(fx, fy) / four(n[3]);
      float shine = 0;
      const float bright = strength(unpacked(packed_normal(Point{n[0], n[1], n[2]})), shine), opacity = std::clamp(paint[3], 0.0f, 1.0f);
      const auto channel = [&](int shift, float front) {
        const float behind = static_cast<float>(color_[k] >> shift & 255) / 255;
        return behind + opacity * (std::min(bright * front + shine, 1.0f) - behind);
      };
      color_[k] = packed(Paint{channel(0, paint[0]), channel(8, paint[1]), channel(16, paint[2]), 1});
      item_[k] = sheet.item;
    }
  }
}

}  // namespace dalembert
