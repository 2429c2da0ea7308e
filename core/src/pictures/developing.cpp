// From samples to an image: rims, light, what is transparent, and the mean of the samples of each pixel.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "dalembert/pictures/picture.hpp"
#include "points.hpp"

namespace dalembert {
namespace {

constexpr int alike = 1600;  // of 32767: a twentieth of a radian where a surface faces the viewer

int component(std::uint32_t v) { return static_cast<std::int16_t>(static_cast<std::uint16_t>(v)); }

// Sums of bytes of colors: red and blue side by side, and green.
struct Sum {
  std::uint32_t even = 0, odd = 0;
  void add(std::uint32_t color) { even += color & 0xff00ffu, odd += color >> 8 & 255; }
  // Of that many colors; two are divided at once where that is a shift.
  DALEMBERT_INLINE std::uint32_t mean(std::uint32_t count) const {
    if (count == 1) return even | odd << 8;
    if (count == 4) return ((even + 0x20002u) >> 2 & 0xff00ffu) | ((odd + 2) >> 2) << 8;
    return (((even & 0xffff) + count / 2) / count) | (((odd + count / 2) / count) << 8) | ((((even >> 16) + count / 2) / count) << 16);
  }
};

}  // namespace

// How bright a surface is; `shine` is what it reflects besides.
float Picture::strength(const Point& normal, float& shine) const {
  float bright = lighting_.ambient;
  shine = 0;
  const float steps = static_cast<float>(shine_.size() - 1);
  for (std::size_t i = 0; i < lighting_.lights.size(); ++i) {
    const Light& light = lighting_.lights[i];
    const float facing = dot(normal, light.direction), half = dot(normal, halves_[i]);
    bright += light.diffuse * std::max(facing, 0.0f);
    if (facing > 0 && half > 0) shine += light.specular * shine_[static_cast<std::size_t>(std::min(half, 1.0f) * steps)];
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
  const auto mean = [&](int sum) { return static_cast<std::uint32_t>(static_cast<std::uint16_t>(static_cast<std::int16_t>(sum / count))); };
  color_[first] = color.mean(static_cast<std::uint32_t>(count)) | to_be_lit;
  normal_[first] = mean(x) | mean(y) << 16;
  return true;
}

// All samples of a row of pixels; side by side, many have one color and normal.
template <int Samples>
void Picture::light(int pixel_row) {
  const int samples = Samples > 0 ? Samples : samples_;
  const auto lit = [&](std::uint32_t color, std::uint32_t normal) {
    float shine = 0;
    const float bright = strength(unpacked(normal), shine);
    const auto channel = [&](int shift) { return bright * static_cast<float>(color >> shift & 255) / 255 + shine; };
    return packed(Four{channel(0), channel(8), channel(16), 1});
  };
  std::uint32_t last_color = 0, last_normal = 0, last = 0;
  for (int column = 0; column < columns_; column += samples) {
    const std::size_t first = row_start(pixel_row * samples) + static_cast<std::size_t>(column);
    if constexpr (Samples == 2)
      if (bits(load_square<FourWhole>(&color_[first], &color_[first + static_cast<std::size_t>(columns_)]) < FourWhole{}) == 0) continue;
    const bool is_one = join<Samples>(first);
    for (int j = 0; j < samples; ++j) {
      for (int i = 0; i < samples; ++i) {
        const std::size_t k = first + static_cast<std::size_t>(j * columns_ + i);
        if (is_one && i + j > 0) {
          color_[k] = last;
          continue;
        }
        const std::uint32_t color = color_[k], normal = normal_[k];
        if (color < to_be_lit) continue;
        if (color != last_color || normal != last_normal) last = lit(color, normal), last_color = color, last_normal = normal;
        color_[k] = last;
      }
    }
  }
}

// Darken the rim of what stands before something else of another item, half a pixel wide, so that parts of one color can be told apart.
void Picture::outline(int row) {
  const int reach = std::max(1, samples_ / 2 + samples_ % 2);
  if (row < reach || row >= rows_ - reach) return;
  const std::ptrdiff_t begin = reach, end = columns_ - reach;
  const std::int32_t* item = item_.data() + row_start(row);
  const float* depth = depth_.data() + row_start(row);
  std::uint32_t *rim = rim_.data(), *color = color_.data() + row_start(row);
  std::ranges::fill(rim_, 0u);
  for (std::ptrdiff_t side = 1; side <= reach; ++side) {
    const std::ptrdiff_t above = side * columns_;
    const auto behind = [&](std::ptrdiff_t other, std::ptrdiff_t k) {
      return static_cast<std::uint32_t>(item[other] != item[k]) & static_cast<std::uint32_t>(depth[other] < depth[k]);
    };
    for (std::ptrdiff_t k = begin; k < end; ++k) rim[k] |= behind(k - side, k) | behind(k + side, k) | behind(k - above, k) | behind(k + above, k);
  }
  for (std::ptrdiff_t k = begin; k < end; ++k)
    color[k] = rim[k] != 0 && color[k] >= to_be_lit ? (color[k] >> 1 & 0x7f7f7fu) | to_be_lit : color[k];
}

template <int Samples>
void Picture::average(int pixel_row, std::uint8_t* pixels) const {
  const int samples = Samples > 0 ? Samples : samples_;
  const std::uint32_t* first = color_.data() + row_start(pixel_row * samples);
  for (int x = 0; x < width_; ++x, first += samples, pixels += 3) {
    Sum sum;
    for (int j = 0; j < samples; ++j)
      for (int i = 0; i < samples; ++i) sum.add(first[j * columns_ + i]);
    const std::uint32_t mean = sum.mean(static_cast<std::uint32_t>(samples * samples));
    for (int channel = 0; channel < 3; ++channel) pixels[channel] = static_cast<std::uint8_t>(mean >> 8 * channel);
  }
}

template <int Samples>
std::vector<std::uint8_t> Picture::developed() {
  for (int pixel_row = 0; pixel_row < height_; ++pixel_row) {
    for (int row = pixel_row * samples_; row < (pixel_row + 1) * samples_; ++row) outline(row);
    light<Samples>(pixel_row);
  }
  std::ranges::stable_sort(sheets_, {}, &Sheet::nearness);
  for (const Sheet& sheet : sheets_) blend(sheet);
  sheets_.clear();
  const std::size_t width = 3 * static_cast<std::size_t>(width_);
  std::vector<std::uint8_t> image(width * static_cast<std::size_t>(height_));
  for (int pixel_row = 0; pixel_row < height_; ++pixel_row) average<Samples>(pixel_row, image.data() + width * static_cast<std::size_t>(pixel_row));
  return image;
}

std::vector<std::uint8_t> Picture::develop() {
  begin();
  return samples_ == 1 ? developed<1>() : samples_ == 2 ? developed<2>() : developed<0>();
}

}  // namespace dalembert
