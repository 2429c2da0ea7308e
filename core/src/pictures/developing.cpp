// Shading and multisample resolve: outlines, lights, transparency, and the mean of the samples of each pixel.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <span>

#include "dalembert/pictures/picture.hpp"
#include "points.hpp"

namespace dalembert {
namespace {

constexpr int alike = 1600;  // of 32767: a twentieth of a radian where a surface faces the viewer

int component(std::uint32_t v) { return static_cast<std::int16_t>(static_cast<std::uint16_t>(v)); }

DALEMBERT_INLINE inline std::int32_t sum_of(FourWhole v) {
  v += __builtin_shufflevector(v, v, 2, 3, 0, 1);
  return v[0] + v[1];
}

// The sums of four numbers each.
DALEMBERT_INLINE inline FourWhole sums_of(FourWhole a, FourWhole b, FourWhole c, FourWhole d) {
  const FourWhole ab = __builtin_shufflevector(a, b, 0, 4, 1, 5) + __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const FourWhole cd = __builtin_shufflevector(c, d, 0, 4, 1, 5) + __builtin_shufflevector(c, d, 2, 6, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

// Sums of bytes of colors: red and blue side by side, and green.
struct Sum {
  std::uint32_t even = 0, odd = 0;
  void add(std::uint32_t color) { even += color & 0xff00ffu, odd += color >> 8 & 255; }
  DALEMBERT_INLINE void add(FourWhole colors) {
    even += static_cast<std::uint32_t>(sum_of(colors & four(0xff00ff))),
        odd += static_cast<std::uint32_t>(sum_of((colors >> 8) & four(255)));
  }
  // Mean of `count` colors; powers of two use shifts.
  DALEMBERT_INLINE std::uint32_t mean(std::uint32_t count) const {
    if (count == 1) return even | odd << 8;
    if (count == 4) return ((even + 0x20002u) >> 2 & 0xff00ffu) | ((odd + 2) >> 2) << 8;
    return (((even & 0xffff) + count / 2) / count) | (((odd + count / 2) / count) << 8) |
           ((((even >> 16) + count / 2) / count) << 16);
  }
};

void write(std::uint32_t color, std::uint8_t* pixel) {
  for (int channel = 0; channel < 3; ++channel) pixel[channel] = static_cast<std::uint8_t>(color >> 8 * channel);
}

}  // namespace

// Brightness of a surface; `shine` is the specular part.
float Picture::strength(const Point& normal, float& shine) const {
  float bright = lighting_.ambient;
  shine = 0;
  const float steps = static_cast<float>(shine_.size() - 1);
  for (std::size_t i = 0; i < lighting_.lights.size(); ++i) {
    const Light& light = lighting_.lights[i];
    const float facing = dot(normal, light.direction), half = dot(normal, halves_[i]);
    bright += light.diffuse * std::max(facing, 0.0f);
    if (facing > 0 && half > 0)
      shine += light.specular * shine_[static_cast<std::size_t>(std::min(half, 1.0f) * steps)];
  }
  return bright;
}

// Whether all samples of a pixel are to be lit, and their normals differ so little that one light will do for all of them; they have the
// mean of their colors and normals then. Samples: per direction, if it is known at compile time; 0: it is not.
template <int Samples>
bool Picture::join(std::size_t first) {
  const int samples = Samples > 0 ? Samples : samples_;
  Sum color;
  int x = 0, y = 0;
  const int x0 = component(normal_[first] & 0xffff), y0 = component(normal_[first] >> 16);
  for (int j = 0; j < samples; ++j) {
    for (int i = 0; i < samples; ++i) {
      const std::size_t k = first + static_cast<std::size_t>(j * columns_ + i);
      if (color_[k] < to_be_lit) return false;
      const int nx = component(normal_[k] & 0xffff), ny = component(normal_[k] >> 16);
      if (std::abs(nx - x0) > alike || std::abs(ny - y0) > alike) return false;
      x += nx, y += ny;
      color.add(color_[k]);
    }
  }
  const int count = samples * samples;
  const auto mean = [&](int sum) {
    return static_cast<std::uint32_t>(static_cast<std::uint16_t>(static_cast<std::int16_t>(sum / count)));
  };
  color_[first] = color.mean(static_cast<std::uint32_t>(count)) | to_be_lit;
  normal_[first] = mean(x) | mean(y) << 16;
  return true;
}

// The same for up to four pixels of four samples, side by side; returns those for which one light will do, by their bits.
std::uint32_t Picture::join_squares(std::size_t first, int count) {
  std::array<FourWhole, 4> colors, x, y;
  std::uint32_t joined = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto normals = load<FourWhole>(&normal_[first + 4 * i]);
    colors[i] = load<FourWhole>(&color_[first + 4 * i]), x[i] = (normals << 16) >> 16, y[i] = normals >> 16;
    const FourWhole dx = x[i] - four(x[i][0]), dy = y[i] - four(y[i][0]), limit = four(alike);
    joined |=
        (bits((colors[i] < FourWhole{}) & (dx <= limit) & (dx >= -limit) & (dy <= limit) & (dy >= -limit)) == 15 ? 1u
                                                                                                                 : 0u)
        << i;
  }
  if (joined == 0) return 0;
  const auto sums = [](const std::array<FourWhole, 4>& parts, const auto& of) {
    return sums_of(of(parts[0]), of(parts[1]), of(parts[2]), of(parts[3]));
  };
  const FourWhole even = sums(colors, [](FourWhole color) { return color & four(0xff00ff); });
  const FourWhole odd = sums(colors, [](FourWhole color) { return (color >> 8) & four(255); });
  const FourWhole color = (((even + four(0x20002)) >> 2) & four(0xff00ff)) | ((odd + four(2)) >> 2) << 8 |
                          four(static_cast<std::int32_t>(to_be_lit));
  const auto quarters = [](const std::array<FourWhole, 4>& parts) {  // towards zero
    const FourWhole sum = sums_of(parts[0], parts[1], parts[2], parts[3]);
    return (sum + ((sum >> 31) & four(3))) >> 2;
  };
  const FourWhole normal = (quarters(x) & four(0xffff)) | quarters(y) << 16;
  for (int i = 0; i < count; ++i) {
    if ((joined >> i & 1) == 0) continue;
    const std::size_t k = first + 4 * static_cast<std::size_t>(i);
    color_[k] = static_cast<std::uint32_t>(color[i]), normal_[k] = static_cast<std::uint32_t>(normal[i]);
  }
  return joined;
}

// The colors of surfaces in the light, in the place of their own: four side by side, each as `strength` has it for one.
void Picture::light_surfaces(std::size_t count) {
  const float steps = static_cast<float>(shine_.size() - 1);
  for (std::size_t first = 0; first < count; first += 4) {
    Surface* s = surfaces_.data() + first;
    const FourWhole colors{s[0].color, s[1].color, s[2].color, s[3].color},
        normals{s[0].normal, s[1].normal, s[2].normal, s[3].normal};
    const Four x = as_numbers((normals << 16) >> 16) / four(32767.0f), y = as_numbers(normals >> 16) / four(32767.0f);
    const Four z = -root(larger(four(0.0f), four(1.0f) - x * x - y * y));
    Four bright = four(lighting_.ambient), shine = four(0.0f);
    for (std::size_t i = 0; i < lighting_.lights.size(); ++i) {
      const Light& light = lighting_.lights[i];
      const Point d = light.direction, h = halves_[i];
      const Four facing = x * four(d.x) + y * four(d.y) + z * four(d.z),
                 half = x * four(h.x) + y * four(h.y) + z * four(h.z);
      bright += four(light.diffuse) * larger(facing, four(0.0f));
      const FourWhole shines = (facing > four(0.0f)) & (half > four(0.0f)),
                      step = shines ? whole(smaller(half, four(1.0f)) * four(steps)) : FourWhole{};
      const Four power{shine_[static_cast<std::size_t>(step[0])], shine_[static_cast<std::size_t>(step[1])],
                       shine_[static_cast<std::size_t>(step[2])], shine_[static_cast<std::size_t>(step[3])]};
      shine += shines ? four(light.specular) * power : four(0.0f);
    }
    FourWhole lit{};
    for (int shift = 0; shift < 24; shift += 8) {
      const Four channel = bright * as_numbers((colors >> shift) & 255) / four(255.0f) + shine;
      lit |= whole(smaller(larger(channel, four(0.0f)), four(1.0f)) * four(255.0f) + four(0.5f)) << shift;
    }
    for (int k = 0; k < 4; ++k) s[k].color = lit[k];
  }
}

// The mean of the samples of a pixel, of which `first` is the first one.
template <int Samples>
std::uint32_t Picture::mean(std::size_t first) const {
  const int samples = Samples > 0 ? Samples : samples_;
  Sum sum;
  if constexpr (Samples == 2) {
    const auto colors = load<FourWhole>(&color_[first]);
    if (bits(colors == four(colors[0])) == 15) return color_[first];
    sum.add(colors);
  } else {
    for (int j = 0; j < samples; ++j)
      for (int i = 0; i < samples; ++i) sum.add(color_[first + static_cast<std::size_t>(j * columns_ + i)]);
  }
  return sum.mean(static_cast<std::uint32_t>(samples * samples));
}

// All samples of a row of pixels, and their means; side by side, many have one color and normal. Samples keep their colors if something
// transparent is before them.
template <int Samples>
void Picture::light(int pixel_row, std::uint8_t* pixels) {
  const int samples = Samples > 0 ? Samples : samples_;
  Surface* surface = surfaces_.data();  // the last surface; the first one is preceded by an empty one
  *surface = {};
  Waiting* next = waiting_.data();
  const auto add = [&](std::size_t k, int column, Lit lit) {
    const Surface now{static_cast<std::int32_t>(color_[k]), static_cast<std::int32_t>(normal_[k])};
    if (!(now == *surface)) *++surface = now;
    *next++ = {k, static_cast<std::uint32_t>(surface - surfaces_.data()), column, lit};
  };
  std::uint32_t joined = 0;  // masks of four pixels, from the last multiple of 4 on
  for (int column = 0; column < width_; ++column) {
    const std::size_t first = sample(column * samples, pixel_row * samples);
    if constexpr (Samples == 2) {
      if (column % 4 == 0) joined = join_squares(first, std::min(width_ - column, 4));
      if (bits(load<FourWhole>(&color_[first]) < FourWhole{}) == 0) {
        write(mean<Samples>(first), pixels + 3 * column);
        continue;
      }
    }
    if (Samples == 2 ? (joined >> column % 4 & 1) != 0 : join<Samples>(first)) {
      add(first, column, Lit::pixel);
      continue;
    }
    for (int j = 0; j < samples; ++j)
      for (int i = 0; i < samples; ++i)
        if (const std::size_t k = sample(column * samples + i, pixel_row * samples + j); color_[k] >= to_be_lit)
          add(k, column, Lit::sample);
    *next++ = {first, 0, column, Lit::all_samples};
  }
  light_surfaces(static_cast<std::size_t>(surface - surfaces_.data()) + 1);
  for (const Waiting& w : std::span(waiting_.data(), next)) {
    if (w.lit == Lit::all_samples) {
      write(mean<Samples>(w.sample), pixels + 3 * w.column);
      continue;
    }
    const auto color = static_cast<std::uint32_t>(surfaces_[w.surface].color);
    if (w.lit == Lit::sample) {
      color_[w.sample] = color;
      continue;
    }
    write(color, pixels + 3 * w.column);
    if (sheets_.empty()) continue;
    for (int j = 0; j < samples; ++j)
      for (int i = 0; i < samples; ++i) color_[sample(w.column * samples + i, pixel_row * samples + j)] = color;
  }
}

// Darkens the outline of an item in front of another one, half a pixel wide, so that parts of equal color are
// distinguishable.
void Picture::outline(int pixel_row) {
  if (has_squares()) return outline_squares(pixel_row);
  for (int row = pixel_row * samples_; row < (pixel_row + 1) * samples_; ++row) outline_samples(row);
}

void Picture::outline_samples(int row) {
  const int reach = std::max(1, samples_ / 2 + samples_ % 2);
  if (row < reach || row >= rows_ - reach) return;
  const std::int32_t* item = item_.data() + row_start(row);
  const float* depth = depth_.data() + row_start(row);
  std::uint32_t* const color = color_.data() + row_start(row);
  constexpr std::ptrdiff_t block = 64;  // samples
  std::array<std::uint32_t, block> rim;
  for (std::ptrdiff_t begin = reach; begin < columns_ - reach; begin += block) {
    const std::ptrdiff_t end = std::min<std::ptrdiff_t>(begin + block, columns_ - reach);
    std::int32_t others = 0;  // zero: all around are of one item, as nearly everywhere
    for (std::ptrdiff_t side = -reach; side <= reach; ++side)
      for (std::ptrdiff_t k = begin - reach; k < end + reach; ++k) others |= item[side * columns_ + k] ^ item[begin];
    if (others == 0) continue;
    std::ranges::fill(rim, 0u);
    for (std::ptrdiff_t side = 1; side <= reach; ++side) {
      const std::ptrdiff_t above = side * columns_;
      const auto behind = [&](std::ptrdiff_t other, std::ptrdiff_t k) {
        return static_cast<std::uint32_t>(item[other] != item[k]) & static_cast<std::uint32_t>(depth[other] < depth[k]);
      };
      for (std::ptrdiff_t k = begin; k < end; ++k)
        rim[static_cast<std::size_t>(k - begin)] |=
            behind(k - side, k) | behind(k + side, k) | behind(k - above, k) | behind(k + above, k);
    }
    for (std::ptrdiff_t k = begin; k < end; ++k)
      color[k] = rim[static_cast<std::size_t>(k - begin)] != 0 && color[k] >= to_be_lit
                     ? (color[k] >> 1 & 0x7f7f7fu) | to_be_lit
                     : color[k];
  }
}

// The same for four samples of a pixel, side by side; there is no rim at the border of the picture.
void Picture::outline_squares(int pixel_row) {
  const std::ptrdiff_t length = 2 * columns_, up = pixel_row > 0 ? -length : 0,
                       down = pixel_row + 1 < height_ ? length : 0;
  const std::int32_t* item = item_.data() + row_start(2 * pixel_row);
  const float* depth = depth_.data() + row_start(2 * pixel_row);
  std::uint32_t* const color = color_.data() + row_start(2 * pixel_row);
  const FourWhole inner_rows{up != 0 ? -1 : 0, up != 0 ? -1 : 0, down != 0 ? -1 : 0, down != 0 ? -1 : 0};
  constexpr std::ptrdiff_t block = 128;  // samples
  for (std::ptrdiff_t begin = 0; begin < length; begin += block) {
    const std::ptrdiff_t end = std::min(begin + block, length);
    const std::int32_t* const from = item + std::max<std::ptrdiff_t>(begin - 4, 0);
    const std::ptrdiff_t count = item + std::min(end + 4, length) - from;
    FourWhole others{};  // zero: all around are of one item, as nearly everywhere
    const FourWhole one = four(from[0]);
    for (std::ptrdiff_t k = 0; k < count; k += 4)
      others |= (load<FourWhole>(from + k) ^ one) | (load<FourWhole>(from + up + k) ^ one) |
                (load<FourWhole>(from + down + k) ^ one);
    if (bits(others == FourWhole{}) == 15) continue;
    for (std::ptrdiff_t k = begin; k < end; k += 4) {
      const std::ptrdiff_t left = k > 0 ? k - 4 : k, right = k + 4 < length ? k + 4 : k;
      const auto items = load<FourWhole>(item + k);
      const auto depths = load<Four>(depth + k);
      const auto behind = [&](FourWhole other, Four nearness) { return (other != items) & (nearness < depths); };
      const FourWhole rim = behind(__builtin_shufflevector(load<FourWhole>(item + left), items, 1, 4, 3, 6),
                                   __builtin_shufflevector(load<Four>(depth + left), depths, 1, 4, 3, 6)) |
                            behind(__builtin_shufflevector(items, load<FourWhole>(item + right), 1, 4, 3, 6),
                                   __builtin_shufflevector(depths, load<Four>(depth + right), 1, 4, 3, 6)) |
                            behind(__builtin_shufflevector(load<FourWhole>(item + up + k), items, 2, 3, 4, 5),
                                   __builtin_shufflevector(load<Four>(depth + up + k), depths, 2, 3, 4, 5)) |
                            behind(__builtin_shufflevector(items, load<FourWhole>(item + down + k), 2, 3, 4, 5),
                                   __builtin_shufflevector(depths, load<Four>(depth + down + k), 2, 3, 4, 5));
      const FourWhole inner{left < k ? -1 : 0, right > k ? -1 : 0, left < k ? -1 : 0, right > k ? -1 : 0};
      const auto colors = load<FourWhole>(color + k);
      store_some(rim & inner & inner_rows & (colors < FourWhole{}),
                 ((colors >> 1) & four(0x7f7f7f)) | four(static_cast<std::int32_t>(to_be_lit)), color + k);
    }
  }
}

template <int Samples>
std::vector<std::uint8_t> Picture::developed() {
  const std::size_t width = 3 * static_cast<std::size_t>(width_);
  std::vector<std::uint8_t> image(width * static_cast<std::size_t>(height_));
  const std::size_t most =
      static_cast<std::size_t>(columns_) * static_cast<std::size_t>(samples_);  // samples of a row of pixels
  surfaces_.resize(most + 4), waiting_.resize(most + static_cast<std::size_t>(width_));
  std::uint8_t* pixels = image.data();
  for (int pixel_row = 0; pixel_row < height_; ++pixel_row, pixels += width) {
    outline(pixel_row);
    light<Samples>(pixel_row, pixels);  // while its samples are in the cache
  }
  if (sheets_.empty()) return image;
  std::ranges::stable_sort(sheets_, {}, &Sheet::nearness);
  for (const Sheet& sheet : sheets_) blend(sheet);
  sheets_.clear();
  pixels = image.data();
  for (int pixel_row = 0; pixel_row < height_; ++pixel_row)
    for (int column = 0; column < width_; ++column, pixels += 3)
      write(mean<Samples>(sample(column * samples_, pixel_row * samples_)), pixels);
  return image;
}

std::vector<std::uint8_t> Picture::develop() {
  begin();
  return samples_ == 1 ? developed<1>() : samples_ == 2 ? developed<2>() : developed<0>();
}

}  // namespace dalembert
