#include "dalembert/contact/sphere_neighbours.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace dalembert {

namespace {
constexpr int cells_around = 27, own_cell = 13;  // its number among them
constexpr int spheres_to_share = 2000, stretches_of_threads = 64;
}  // namespace

// Spheres of similar size in cells that are as large as what they reach; cells are found by a hash, so that space has no bounds.
// Sorted by cells: what lies in one cell lies side by side in memory.
struct SphereNeighbours::Grid {
  struct Entry {
    SphereAt at;
    std::uint64_t cell;
    int sphere;
  };
  double size = 0;
  std::vector<Entry> entries;
  std::vector<std::uint32_t> begins;
  int shift = 0;

  using Place = std::array<std::int64_t, 3>;
  // So far away that whole numbers end, cells become larger: the outermost one has all that is beyond.
  std::int64_t index(double x) const { return static_cast<std::int64_t>(std::clamp(std::floor(x / size), -1e6, 1e6)) + (1 << 20); }
  Place place(const SphereAt& s) const { return {index(s.x), index(s.y), index(s.z)}; }
  static std::uint64_t number(const Place& p) {
    return (static_cast<std::uint64_t>(p[0]) << 42) | (static_cast<std::uint64_t>(p[1]) << 21) | static_cast<std::uint64_t>(p[2]);
  }
  std::size_t bucket(std::uint64_t cell) const { return static_cast<std::size_t>((cell * 0x9E3779B97F4A7C15ull) >> shift); }

  void fill(std::span<const SphereAt> spheres, std::span<const int> members) {
    const std::size_t n = members.size(), buckets = std::bit_ceil(2 * n + 2);
    shift = 64 - std::countr_zero(buckets);
    begins.assign(buckets + 1, 0);
    std::vector<std::uint64_t> cells(n);
    for (std::size_t i = 0; i < n; ++i) {
      cells[i] = number(place(spheres[static_cast<std::size_t>(members[i])]));
      ++begins[bucket(cells[i]) + 1];
    }
    for (std::size_t b = 1; b < begins.size(); ++b) begins[b] += begins[b - 1];
    entries.resize(n);
    std::vector<std::uint32_t> next(begins.begin(), begins.end() - 1);
    for (std::size_t i = 0; i < n; ++i)
      entries[next[bucket(cells[i])]++] = {spheres[static_cast<std::size_t>(members[i])], cells[i], members[i]};
  }
};

void SphereNeighbours::clear(std::size_t spheres) {
  first_.assign(spheres + 1, 0);
  seconds_.clear();
}

// Each sphere looks for others of its own grid, in its cell and in one half of the cells around, and of grids with larger spheres.
void SphereNeighbours::build(std::span<const SphereAt> spheres, double margin, Workers* workers) {
  const int n = static_cast<int>(spheres.size());
  clear(spheres.size());
  if (n < 2) return;
  double smallest = spheres[0].radius;
  for (const SphereAt& s : spheres) smallest = std::min(smallest, s.radius);
  const auto level_of = [&](double radius) { return std::min(40, std::ilogb(radius / smallest)); };
  std::vector<std::vector<int>> members;
  for (int i = 0; i < n; ++i) {
    const auto level = static_cast<std::size_t>(level_of(spheres[static_cast<std::size_t>(i)].radius));
    if (level >= members.size()) members.resize(level + 1);
    members[level].push_back(i);
  }
  std::vector<Grid> grids(members.size());
  for (std::size_t level = 0; level < members.size(); ++level) {
    double largest = 0;
    for (const int i : members[level]) largest = std::max(largest, spheres[static_cast<std::size_t>(i)].radius);
    grids[level].size = 2 * largest + margin;
    if (!members[level].empty()) grids[level].fill(spheres, members[level]);
  }
  const auto look = [&](const Grid& grid, const SphereAt& a, int sphere, std::uint64_t cell, bool own, std::vector<Pair>& found) {
    const std::size_t b = grid.bucket(cell);
    for (std::uint32_t k = grid.begins[b]; k < grid.begins[b + 1]; ++k) {
      const Grid::Entry& other = grid.entries[k];
      if (other.cell != cell || (own && other.sphere <= sphere)) continue;
      const double dx = other.at.x - a.x, dy = other.at.y - a.y, dz = other.at.z - a.z, reach = a.radius + other.at.radius + margin;
      if (dx * dx + dy * dy + dz * dz <= reach * reach) found.push_back({std::min(sphere, other.sphere), std::max(sphere, other.sphere)});
    }
  };
  const int stretches = workers == nullptr || n < spheres_to_share ? 1 : stretches_of_threads;
  found_.resize(static_cast<std::size_t>(stretches));
  auto search = [&](int stretch) {
    std::vector<Pair>& found = found_[static_cast<std::size_t>(stretch)];
    found.clear();
    for (std::size_t level = 0; level < grids.size(); ++level) {
      const std::vector<Grid::Entry>& all = grids[level].entries;
      const auto bound = [&](int s) { return all.size() * static_cast<std::size_t>(s) / static_cast<std::size_t>(stretches); };
      for (std::size_t other = level; other < grids.size(); ++other) {
        const Grid& grid = grids[other];
        if (grid.entries.empty()) continue;
        for (std::size_t e = bound(stretch); e < bound(stretch + 1); ++e) {
          const Grid::Entry& entry = all[e];
          const Grid::Place centre = grid.place(entry.at);
          for (int around = other == level ? own_cell : 0; around < cells_around; ++around) {
            const Grid::Place place{centre[0] + around / 9 - 1, centre[1] + around / 3 % 3 - 1, centre[2] + around % 3 - 1};
            look(grid, entry.at, entry.sphere, Grid::number(place), other == level && around == own_cell, found);
          }
        }
      }
    }
  };
  if (stretches == 1) search(0);
  else workers->run(stretches, search);
  for (const std::vector<Pair>& found : found_)
    for (const Pair& pair : found) ++first_[static_cast<std::size_t>(pair.first) + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  seconds_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const std::vector<Pair>& found : found_)
    for (const Pair& pair : found) seconds_[next[static_cast<std::size_t>(pair.first)]++] = pair.second;
  for (int i = 0; i < n; ++i) {
    int* const begin = seconds_.data() + first_[static_cast<std::size_t>(i)];
    std::sort(begin, seconds_.data() + first_[static_cast<std::size_t>(i) + 1]);
  }
}

}  // namespace dalembert
