// The frame of two vectors of any length: one axis along the first vector, another one normal to both.
#pragma once

#include <array>
#include <cmath>

#include "dalembert/math/dual.hpp"
#include "dalembert/math/fixed.hpp"

namespace dalembert {

template <class S>
struct SlopeFrame {
  Vec3<S> first, second;
  Vec3<S> lead, normal, side;  // unit vectors along first, second x first, and lead x normal
  S per_length, per_area;

  SlopeFrame(const Vec3<S>& a, const Vec3<S>& b) : first(a), second(b) {
    const Vec3<S> area = cross(b, a);
    per_length = 1.0 / norm(a);
    per_area = 1.0 / norm(area);
    lead = per_length * a;
    normal = per_area * area;
    side = cross(lead, normal);
  }
  // Angular velocity at rates of both vectors.
  Vec3<S> spin(const Vec3<S>& a, const Vec3<S>& b) const {
    const S roll = per_area * dot(cross(b, first) + cross(second, a), side);
    return per_length * cross(lead, a) + roll * lead;
  }
  // Forces on both vectors with the power of a moment.
  std::array<Vec3<S>, 2> pull_back(const Vec3<S>& moment) const {
    const S roll = per_area * dot(moment, lead);
    return {per_length * cross(moment, lead) + roll * cross(side, second), roll * cross(first, side)};
  }
  // How these forces change at rates of both vectors, while the moment does not.
  std::array<Vec3<S>, 2> pull_back_rate(const Vec3<S>& moment, const Vec3<S>& a, const Vec3<S>& b) const {
    const Vec3<S> area_rate = cross(b, first) + cross(second, a);
    // relative growth of length and area
    const S growth = per_length * dot(lead, a), area_growth = per_area * dot(normal, area_rate);
    const Vec3<S> lead_rate = per_length * a - growth * lead, normal_rate = per_area * area_rate - area_growth * normal;
    const Vec3<S> side_rate = cross(lead_rate, normal) + cross(lead, normal_rate);
    const S roll = per_area * dot(moment, lead), roll_rate = per_area * dot(moment, lead_rate) - area_growth * roll;
    const Vec3<S> lean = cross(moment, lead_rate) - growth * cross(moment, lead);
    return {per_length * lean + cross(roll_rate * side + roll * side_rate, second) + roll * cross(side, b),
            cross(first, roll_rate * side + roll * side_rate) + roll * cross(a, side)};
  }
};

// The same while both vectors change: derivatives are those along the rates.
template <class S>
Vec3<Dual<1, S>> moving(const Vec3<S>& v, const Vec3<S>& rate) {
  Vec3<Dual<1, S>> m;
  for (int i = 0; i < 3; ++i) {
    m[i].value = v[i];
    m[i].d[0] = rate[i];
  }
  return m;
}
template <class S>
Vec3<S> rate_of(const Vec3<Dual<1, S>>& v) {
  return {v[0].d[0], v[1].d[0], v[2].d[0]};
}

}  // namespace dalembert
