// Points, colors and normals of pictures, and how samples keep them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "dalembert/pictures/picture.hpp"

namespace dalembert {

inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point operator*(float s, Point a) { return {s * a.x, s * a.y, s * a.z}; }
inline float dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point cross(Point a, Point b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline Point unit(Point a) { return 1 / std::sqrt(std::max(dot(a, a), 1e-30f)) * a; }
inline Paint operator*(float s, Paint p) { return {s * p.r, s * p.g, s * p.b, s * p.a}; }
inline Paint operator+(Paint p, Paint q) { return {p.r + q.r, p.g + q.g, p.b + q.b, p.a + q.a}; }
inline Paint operator-(Paint p, Paint q) { return {p.r - q.r, p.g - q.g, p.b - q.b, p.a - q.a}; }

constexpr std::uint32_t to_be_lit = 0xff000000u;

// Red, green and blue of four colors.
DALEMBERT_INLINE inline FourWhole packed(Four r, Four g, Four b) {
  const auto bytes = [](Four part) {
    return whole(smaller(larger(part, four(0.0f)), four(1.0f)) * four(255.0f) + four(0.5f));
  };
  return bytes(r) | bytes(g) << 8 | bytes(b) << 16;
}
DALEMBERT_INLINE inline std::uint32_t packed(Four paint) {
  const FourWhole bytes = whole(smaller(larger(paint, four(0.0f)), four(1.0f)) * four(255.0f) + four(0.5f));
  return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8 |
         static_cast<std::uint32_t>(bytes[2]) << 16;
}
inline std::uint32_t packed(Paint p) { return packed(Four{p.r, p.g, p.b, 1}); }

// Four normals; towards the viewer, or edge-on where interpolation has turned them beyond.
DALEMBERT_INLINE inline FourWhole packed_normal(Four x, Four y, Four z) {
  z = smaller(z, four(0.0f));
  const Four part = four(1.0f) / root(larger(x * x + y * y + z * z, four(1e-30f)));
  return (whole(part * x * four(32767.0f)) & four(0xffff)) | whole(part * y * four(32767.0f)) << 16;
}
inline std::uint32_t packed_normal(Point n) {
  return static_cast<std::uint32_t>(packed_normal(four(n.x), four(n.y), four(n.z))[0]);
}
inline Point unpacked(std::uint32_t normal) {
  const auto part = [](std::uint32_t v) {
    return static_cast<float>(static_cast<std::int16_t>(static_cast<std::uint16_t>(v))) / 32767;
  };
  const float x = part(normal & 0xffff), y = part(normal >> 16);
  return {x, y, -std::sqrt(std::max(0.0f, 1 - x * x - y * y))};
}

// Points that are nowhere, or too far away for numbers of a picture, have no place in it.
inline bool is_finite(Point a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

// The first sample whose middle is at or behind `x`, within 0 and `end`; 0 if `x` is not a number. These are whole numbers.
DALEMBERT_INLINE inline Four first_samples(Four x, Four end) {
  const Four from = smaller(x - four(0.5f), end), below = as_numbers(whole(from));
  const FourWhole result = reinterpret_cast<FourWhole>(below < from ? below + four(1.0f) : below) & (x > four(0.5f));
  return reinterpret_cast<Four>(result);
}
inline int first_sample(float x, int end) {
  return static_cast<int>(first_samples(four(x), four(static_cast<float>(end)))[0]);
}

}  // namespace dalembert
