// Rasterization: samples that a triangle covers, and their stored data.
#include <algorithm>
#include <utility>

#include "dalembert/pictures/picture.hpp"
#include "points.hpp"

namespace dalembert {
namespace {

// A quantity that is linear over a triangle: its value in the middle of sample 0, 0, and its steps.
template <class T>
struct Linear {
  T value, dx, dy;
  DALEMBERT_INLINE T at(float x, float y) const { return value + x * dx + y * dy; }
};

// One component of a linear function over a triangle, at four positions.
DALEMBERT_INLINE inline Four component(const Linear<Four>& q, int i, Four x, Four y) {
  return four(q.value[i]) + x * four(q.dx[i]) + y * four(q.dy[i]);
}

constexpr Four steps{0, 1, 2, 3};

// Vertical order of three points, indexed by the results of pairwise comparisons.
constexpr std::array<std::array<std::uint8_t, 3>, 8> orders{
    {{2, 1, 0}, {2, 0, 1}, {1, 2, 0}, {}, {}, {0, 2, 1}, {1, 0, 2}, {0, 1, 2}}};
DALEMBERT_INLINE inline std::size_t is_before(Point a, Point b) {
  return static_cast<std::size_t>(a.y < b.y) |
         (static_cast<std::size_t>(a.y == b.y) & static_cast<std::size_t>(a.x < b.x));
}

// Covered samples of a tile as a bit mask: their center, and their indices.
struct Won {
  float x = 0, y = 0;
  std::array<std::int32_t, 4> flags{};
};
constexpr std::array<Won, 16> squares = [] {
  std::array<Won, 16> result{};
  for (std::size_t won = 1; won < 16; ++won) {
    float count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      if ((won >> k & 1) == 0) continue;
      count += 1, result[won].x += static_cast<float>(k % 2), result[won].y += static_cast<float>(k / 2);
      result[won].flags[k] = -1;
    }
    result[won].x /= count, result[won].y /= count;
  }
  return result;
}();

}  // namespace

// Coverage of a triangle per row of samples: one of its edges spans all rows, the other two share them. Edges have a
// canonical direction, so that adjacent triangles agree on every sample between them.
class Picture::Sides {
 public:
  explicit Sides(const Corners& v) {
    const Point &a = v[0]->place, &b = v[1]->place, &c = v[2]->place;
    const auto order = orders[is_before(a, b) | is_before(b, c) << 1 | is_before(a, c) << 2];
    const Point &first = v[order[0]]->place, &second = v[order[1]]->place, &third = v[order[2]]->place;
    low = first.y, high = third.y, middle_ = second.y;
    x_ = Four{first.x, first.x, second.x}, y_ = Four{first.y, first.y, second.y};
    const Four dx = Four{third.x, second.x, third.x} - x_, dy = Four{third.y, second.y, third.y} - y_;
    slope_ = dy > four(0.0f) ? dx / dy : four(0.0f);
  }
  DALEMBERT_INLINE std::pair<Four, Four> at(Four rows) const {
    const auto edge = [&](int i) { return four(x_[i]) + (rows - four(y_[i])) * four(slope_[i]); };
    const Four a = edge(0), b = rows < four(middle_) ? edge(1) : edge(2);
    return {b < a ? b : a, b < a ? a : b};
  }
  float low, high;

 private:
  Four x_, y_, slope_;  // values of the long edge, and of the upper and the lower short edge
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

// The samples of four rows between the edges of a triangle: the first one of each, and the one after the last.
DALEMBERT_INLINE inline std::pair<Four, Four> Picture::spans(const Sides& sides, Four rows) const {
  const auto [left, right] = sides.at(rows + four(0.5f));
  const Four end = four(static_cast<float>(columns_));
  return {first_samples(left, end), first_samples(right, end)};
}

// The samples of a triangle, pixel by pixel. Covered samples of a pixel are shaded together, at their center, which
// is inside of the triangle: shade(x, y) returns color and normal at four positions.
template <class Shade>
void Picture::cover(const Corners& v, const Plan& plan, std::int32_t item, Shade&& shade) {
  const auto near = plan.linear(v[0]->place.z, v[1]->place.z, v[2]->place.z);
  const Sides sides(v);
  const int end = first_sample(sides.high, rows_);
  std::array<std::size_t, 64> won;  // at most eight samples in each direction
  std::array<int, 8> begins, ends;
  for (int row = first_sample(sides.low, rows_); row < end;) {
    const int first = row, stop = std::min(row - row % samples_ + samples_, end);
    int left = columns_, right = 0;
    for (; row < stop; row += 4) {
      const auto [b, e] = spans(sides, four(static_cast<float>(row)) + steps);
      store(whole(b), &begins[static_cast<std::size_t>(row - first)]),
          store(whole(e), &ends[static_cast<std::size_t>(row - first)]);
    }
    row = stop;
    for (std::size_t j = 0; j < static_cast<std::size_t>(stop - first); ++j)
      if (begins[j] < ends[j]) left = std::min(left, begins[j]), right = std::max(right, ends[j]);
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
      const auto [color, normal] =
          shade(four(part * static_cast<float>(x_sum)), four(part * static_cast<float>(y_sum)));
      for (std::size_t i = 0; i < count; ++i)
        color_[won[i]] = static_cast<std::uint32_t>(color[0]), normal_[won[i]] = static_cast<std::uint32_t>(normal[0]);
    }
  }
}

// Pixels that wait for their color and normal.
struct Picture::Unshaded {
  static constexpr std::size_t most = 64;
  std::size_t count = 0;
  std::array<std::size_t, most> places;
  std::array<std::uint32_t, most> samples;  // bit mask of the samples
  std::array<float, most + 3> xs, ys;
};

// Not inlined: it would take registers from the loops that find pixels.
template <class Shade>
[[gnu::noinline]] void Picture::shade_pixels(Unshaded& pixels, const Shade& shade) {
  if (pixels.count == 0) return;
  const std::size_t last = pixels.count - 1;  // has company: four are shaded together
  store(four(pixels.xs[last]), &pixels.xs[last]), store(four(pixels.ys[last]), &pixels.ys[last]);
  for (std::size_t i = 0; i < pixels.count; i += 4) {
    const auto [color, normal] = shade(load<Four>(&pixels.xs[i]), load<Four>(&pixels.ys[i]));
#pragma GCC unroll 4
    for (std::size_t j = 0; j < 4; ++j) {
      if (i + j == pixels.count) break;
      const std::size_t k = pixels.places[i + j];
      const auto won = load<FourWhole>(squares[pixels.samples[i + j]].flags.data());
      store_some(won, four(color[j]), &color_[k]), store_some(won, four(normal[j]), &normal_[k]);
    }
  }
  pixels.count = 0;
}

// The same with two samples in each direction, all four of a pixel side by side, and four pixels shaded together.
template <class Shade>
void Picture::cover_squares(const Corners& v, const Plan& plan, std::int32_t item, Shade&& shade) {
  const auto near = plan.linear(v[0]->place.z, v[1]->place.z, v[2]->place.z);
  const Sides sides(v);
  const Four limits = first_samples(Four{sides.low, sides.high}, four(static_cast<float>(rows_)));
  const int first = static_cast<int>(limits[0]), end = static_cast<int>(limits[1]);
  constexpr int most = static_cast<int>(Unshaded::most);
  Unshaded pixels;
  float* const depth = depth_.data();
  std::int32_t* const items = item_.data();
  const std::uint32_t *const colors = color_.data(), *const normals =
                                                         normal_.data();  // brought to the cache while pixels wait
  for (int begin = first & ~1; begin < end; begin += 4) {
    const Four rows = four(static_cast<float>(begin)) + steps;
    const FourWhole are_inside = (rows >= four(static_cast<float>(first))) & (rows < four(static_cast<float>(end)));
    auto [begins, ends] = spans(sides, rows);
    begins = chosen(are_inside, begins, four(static_cast<float>(columns_))), ends = chosen(are_inside, ends, Four{});
    for (int row = begin; row < std::min(begin + 4, end); row += 2) {
      const Four b = __builtin_shufflevector(begins, begins, 0, 0, 1, 1),
                 e = __builtin_shufflevector(ends, ends, 0, 0, 1, 1);
      const Four down = (four(static_cast<float>(row)) + Four{0, 0, 1, 1}) * four(near.dy);
      begins = __builtin_shufflevector(begins, begins, 2, 3, 2, 3),
      ends = __builtin_shufflevector(ends, ends, 2, 3, 2, 3);
      const int left = static_cast<int>(std::min(b[0], b[2])) & ~1, right = static_cast<int>(std::max(e[0], e[2]));
      for (int from = left; from < right; from += 2 * most) {
        const int stop = std::min(from + 2 * most, right);
        if (pixels.count + static_cast<std::size_t>(stop - from + 1) / 2 > Unshaded::most) shade_pixels(pixels, shade);
        Four columns = four(static_cast<float>(from)) + Four{0, 1, 0, 1};
        std::size_t k = row_start(row) + 2 * static_cast<std::size_t>(from);
        for (int column = from; column < stop; column += 2, columns += four(2.0f), k += 4) {
          const auto known = load<Four>(depth + k);
          const Four n = four(near.value) + columns * four(near.dx) + down;
          const FourWhole won = (columns >= b) & (columns < e) & (n > known);
          const std::uint32_t which = bits(won);
          if (which == 0) continue;
          store(chosen(won, n, known), depth + k);
          store_some(won, four(item), items + k);
          const std::size_t i = pixels.count++;
          pixels.places[i] = k, pixels.samples[i] = which;
          __builtin_prefetch(colors + k, 1), __builtin_prefetch(normals + k, 1);
          pixels.xs[i] = static_cast<float>(column) + squares[which].x,
          pixels.ys[i] = static_cast<float>(row) + squares[which].y;
        }
      }
    }
  }
  shade_pixels(pixels, shade);
}

void Picture::add(const Corners& v, std::int32_t item) {
  const float opacity = v[0]->paint[3] / v[0]->weight();
  if (opacity < 0.999f) {
    if (opacity > 0.001f)
      sheets_.push_back({{*v[0], *v[1], *v[2]}, v[0]->place.z + v[1]->place.z + v[2]->place.z, item});
    return;
  }
  const Plan plan(v[0]->place, v[1]->place, v[2]->place);
  const auto covered = [&](auto&& shade) {
    samples_ == 2 ? cover_squares(v, plan, item, shade) : cover(v, plan, item, shade);
  };
  const bool has_one_color = v[0]->color == v[1]->color && v[0]->color == v[2]->color;
  const auto color = four(static_cast<std::int32_t>(v[0]->color));
  const auto paints = plan.linear(v[0]->paint, v[1]->paint, v[2]->paint);
  const bool is_parallel = perspective_ == 0;  // all weights are one
  const auto color_at = [&](Four x, Four y, const auto& weight_at) {
    Four r = component(paints, 0, x, y), g = component(paints, 1, x, y), b = component(paints, 2, x, y);
    if (!is_parallel) {
      const Four weight = weight_at(x, y);
      r /= weight, g /= weight, b /= weight;
    }
    return packed(r, g, b) | four(static_cast<std::int32_t>(to_be_lit));
  };
  // flat and without perspective: one normal for the triangle
  if (bits((v[0]->normal == v[1]->normal) & (v[0]->normal == v[2]->normal)) == 15) {
    const Four n = v[0]->normal;
    const FourWhole normal = packed_normal(four(n[0]), four(n[1]), four(n[2]));
    if (has_one_color)
      covered([&](Four, Four) { return std::pair(color, normal); });
    else
      covered(
          [&](Four x, Four y) { return std::pair(color_at(x, y, [&](Four, Four) { return four(n[3]); }), normal); });
    return;
  }
  const auto normals = plan.linear(v[0]->normal, v[1]->normal, v[2]->normal);
  const auto normal_at = [&](Four x, Four y) {
    return packed_normal(component(normals, 0, x, y), component(normals, 1, x, y), component(normals, 2, x, y));
  };
  const auto weight_at = [&](Four x, Four y) { return component(normals, 3, x, y); };
  if (has_one_color)
    covered([&](Four x, Four y) { return std::pair(color, normal_at(x, y)); });
  else
    covered([&](Four x, Four y) { return std::pair(color_at(x, y, weight_at), normal_at(x, y)); });
}

void Picture::blend(const Sheet& sheet) {
  const auto& v = sheet.corners;
  const Plan plan(v[0].place, v[1].place, v[2].place);
  const auto near = plan.linear(v[0].place.z, v[1].place.z, v[2].place.z);
  const auto normals = plan.linear(v[0].normal, v[1].normal, v[2].normal),
             paints = plan.linear(v[0].paint, v[1].paint, v[2].paint);
  const Sides sides({&v[0], &v[1], &v[2]});
  const int last = first_sample(sides.high, rows_);
  for (int row = first_sample(sides.low, rows_); row < last; ++row) {
    const auto [begins, ends] = spans(sides, four(static_cast<float>(row)));
    const int end = static_cast<int>(ends[0]);
    for (int x = static_cast<int>(begins[0]); x < end; ++x) {
      const float fx = static_cast<float>(x), fy = static_cast<float>(row);
      const std::size_t k = sample(x, row);
      if (near.at(fx, fy) <= depth_[k]) continue;
      const Four n = normals.at(fx, fy), paint = paints.at(fx, fy) / four(n[3]);
      float shine = 0;
      const float bright = strength(unpacked(packed_normal(Point{n[0], n[1], n[2]})), shine),
                  opacity = std::clamp(paint[3], 0.0f, 1.0f);
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
