#include "dalembert/prototypes/spheres_in_box.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "dalembert/batches/port_sweep.hpp"

namespace dalembert {

template <class S>
struct SpheresInBox::Approach {
  S gap, rate;
  Vec3<S> direction;
};

// A wall is as far from a sphere as its plane.
template <class S>
SpheresInBox::Approach<S> SpheresInBox::approach(const Pair& pair, const PointFrame<S>& first, const PointFrame<S>& second) const {
  const double radius = p_.radii[static_cast<std::size_t>(pair.first)];
  if (is_wall(pair.second)) {
    const int side = pair.second - spheres(), axis = side % 3;
    const double sign = side < 3 ? 1 : -1, plane = (side < 3 ? p_.lower : p_.upper)[axis];
    Vec3<S> inward{};
    inward[axis] = S(sign);
    return {sign * (first.position[axis] - plane) - radius, sign * first.velocity[axis], inward};
  }
  const Vec3<S> span = first.position - second.position;
  const S distance = norm(span);
  const Vec3<S> direction = (1.0 / distance) * span;
  return {distance - (radius + p_.radii[static_cast<std::size_t>(pair.second)]), dot(direction, first.velocity - second.velocity), direction};
}

SpheresInBox::Approach<double> SpheresInBox::approach(const Pair& pair, const Ports& ports) const {
  const auto frame = [&](int sphere) { return read_frame<PointPort>(ports, p_.markers[static_cast<std::size_t>(sphere)]); };
  return approach(pair, frame(pair.first), is_wall(pair.second) ? PointFrame<double>{} : frame(pair.second));
}

template <class S>
Vec3<S> SpheresInBox::force(const Touch& touch, const Approach<S>& at) const {
  return ImpactLaw(p_, touch.impact).pressure(-at.gap, -at.rate) * at.direction;
}

// Spheres are sorted into cells that are as large as what they reach; a pair is looked for in the cells next to each other.
std::vector<SpheresInBox::Pair> SpheresInBox::within(double distance, const Ports& ports) const {
  std::vector<Pair> found;
  const int n = spheres();
  const double cell = 2 * std::ranges::max(p_.radii) + distance;
  std::array<std::int64_t, 3> count{};
  for (int k = 0; k < 3; ++k) count[k] = std::max<std::int64_t>(1, static_cast<std::int64_t>((p_.upper[k] - p_.lower[k]) / cell));
  const auto place = [&](int sphere) {
    std::array<std::int64_t, 3> at{};
    for (int k = 0; k < 3; ++k) {
      const double x = ports.frame(p_.markers[static_cast<std::size_t>(sphere)])[k] - p_.lower[k];
      at[k] = static_cast<std::int64_t>(std::clamp(std::floor(x / cell), 0.0, static_cast<double>(count[k] - 1)));
    }
    return at;
  };
  const auto number = [&](const std::array<std::int64_t, 3>& at) { return (at[0] * count[1] + at[1]) * count[2] + at[2]; };
  std::vector<std::pair<std::int64_t, int>> cells;
  for (int i = 0; i < n; ++i) cells.emplace_back(number(place(i)), i);
  std::ranges::sort(cells);
  const auto note = [&](int first, int second) {
    if (approach({first, second}, ports).gap <= distance) found.push_back({first, second});
  };
  for (int i = 0; i < n; ++i) {
    for (int wall = n; wall < n + 6; ++wall) note(i, wall);
    const auto centre = place(i);
    std::array<std::int64_t, 3> at{};
    for (at[0] = std::max<std::int64_t>(0, centre[0] - 1); at[0] <= std::min(count[0] - 1, centre[0] + 1); ++at[0])
      for (at[1] = std::max<std::int64_t>(0, centre[1] - 1); at[1] <= std::min(count[1] - 1, centre[1] + 1); ++at[1])
        for (at[2] = std::max<std::int64_t>(0, centre[2] - 1); at[2] <= std::min(count[2] - 1, centre[2] + 1); ++at[2])
          for (auto other = std::ranges::lower_bound(cells, std::pair(number(at), i + 1)); other != cells.end() && other->first == number(at); ++other)
            note(i, other->second);
  }
  return found;
}

bool SpheresInBox::search(const Evaluation&, const Ports& ports) {
  std::vector<Pair> found;
  if (p_.all_pairs) {
    for (int i = 0; i < spheres(); ++i)
      for (int j = i + 1; j < spheres() + 6; ++j) found.push_back({i, j});  // walls come after the spheres
  } else {
    found = within(p_.margin, ports);
  }
  return pairs_.renew(found);
}

namespace {

// Calls f(markers) with those of a pair, one or two of them.
template <class F>
void with_markers(const std::vector<int>& markers, int first, int second, F&& f) {
  const int a = markers[static_cast<std::size_t>(first)];
  if (second < static_cast<int>(markers.size())) f(std::array{a, markers[static_cast<std::size_t>(second)]});
  else f(std::array{a});
}

}  // namespace

void SpheresInBox::visit(BlockVisitor& visitor, const Ports& ports) const {
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    with_markers(p_.markers, pairs_[i].first, pairs_[i].second, [&]<std::size_t M>(const std::array<int, M>& markers) {
      const auto dofs = all_dofs<static_cast<int>(M)>(ports, markers);
      visitor.block(dofs, dofs);
    });
}

void SpheresInBox::residual(const Evaluation&, Ports& ports, double*) const {
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Pair& pair = pairs_[i];
    if (!pairs_.data(i).closed()) continue;
    const Vec3<double> f = force(pairs_.data(i), approach(pair, ports));
    add_vector(ports.force(p_.markers[static_cast<std::size_t>(pair.first)]), 1.0, f);
    if (!is_wall(pair.second)) add_vector(ports.force(p_.markers[static_cast<std::size_t>(pair.second)]), -1.0, f);
  }
}

void SpheresInBox::tangent(const Evaluation&, const Weights&, Ports& ports, double* values) const {
  const int* slot = slots.data();
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Pair& pair = pairs_[i];
    with_markers(p_.markers, pair.first, pair.second, [&]<std::size_t M>(const std::array<int, M>& markers) {
      const Columns<M> columns(ports, markers);
      for (int first = 0; pairs_.data(i).closed() && first < columns.total; first += sweep_width) {
        std::array<PointFrame<SweepDual>, 2> frames{};
        for (std::size_t m = 0; m < M; ++m) frames[m] = read_moving_frame<PointPort>(ports, markers[m], columns.offset[m], first);
        const Vec3<SweepDual> f = force(pairs_.data(i), approach(pair, frames[0], frames[1]));
        std::array<Force<SweepDual>, M> forces{};
        forces[0] = {f};
        if constexpr (M == 2) forces[1] = {-f};
        scatter_forces<PointPort, M>(ports, markers, columns, first, -1.0, forces, slot, values);
      }
      slot += columns.total * columns.total;
    });
  }
}

// A contact that opens or closes is an error, and so is one that nobody had looked for: the step is iterated.
PostNewton SpheresInBox::post_newton(const Evaluation&, const Ports& ports, const double*, double*, double*) {
  PostNewton verdict;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const auto at = approach(pairs_[i], ports);
    const Touch& start = pairs_.start(i);
    if ((at.gap < 0) != pairs_.data(i).closed()) verdict.error = std::max(verdict.error, p_.contactStiffness * std::abs(at.gap));
    pairs_.data(i) = {at.gap, !start.closed() && at.gap < 0 ? -at.rate : start.impact};
  }
  for (const Pair& pair : within(0, ports))
    if (!pairs_.contains(pair)) verdict.error = std::max(verdict.error, -p_.contactStiffness * approach(pair, ports).gap);
  return verdict;
}

}  // namespace dalembert
