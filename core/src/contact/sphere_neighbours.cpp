#include "dalembert/contact/sphere_neighbours.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "dalembert/math/pack.hpp"
#include "dalembert/math/wide_registers.hpp"

namespace dalembert {
namespace {

using P = Pack<4>;
constexpr std::size_t lanes = 4;
constexpr int spheres_to_share = 2000, stretches_of_threads = 64;
constexpr double farthest_cell = 1e6;

// Calls f(stretch, begin, end) for stretches that make up [0, count).
template <class F>
void share_stretches(Workers* workers, std::size_t stretches, std::size_t count, const F& f) {
  share_tasks(workers, static_cast<int>(stretches), [&](int task) {
    const auto stretch = static_cast<std::size_t>(task);
    f(stretch, count * stretch / stretches, count * (stretch + 1) / stretches);
  });
}

// Spheres in cells of one size, sorted by cells: a row of cells is contiguous in memory, and a loop over all cells in
// order also reads the adjacent rows in order. Memory is proportional to the number of spheres, not to the volume, so
// that space has no bounds.
class SortedCells {
 public:
  LargeVector<std::uint64_t> cells;
  LargeVector<int> spheres;
  LargeVector<double> x, y, z, radius;  // and some more to read

  // Cells that spheres between two corners lie in.
  SortedCells(double size, const SphereAt& lower, const SphereAt& upper)
      : per_length_(1 / (size * (1 + 1e-9))), lowest_{index(lower.x) - 1, index(lower.y) - 1, index(lower.z) - 1} {
    const auto bits = [](std::int64_t from, std::int64_t to) {
      return std::bit_width(static_cast<std::uint64_t>(to + 1 - from));
    };
    bits_of_z_ = bits(lowest_[2], index(upper.z));
    bits_of_y_ = bits(lowest_[1], index(upper.y));
    bits_ = bits_of_z_ + bits_of_y_ + bits(lowest_[0], index(upper.x));
  }
  // The way from a cell to another one in these directions.
  std::int64_t way(int along_x, int along_y) const {
    return ((std::int64_t{along_x} << bits_of_y_) + along_y) << bits_of_z_;
  }

  void fill(std::span<const SphereAt> all, std::span<const int> members, Workers* workers, std::size_t stretches) {
    cells.resize(members.size());
    spheres.resize(members.size());
    share_stretches(workers, stretches, members.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        spheres[k] = members[k];
        cells[k] = cell_of(all[static_cast<std::size_t>(members[k])]);
      }
    });
    sort();
    for (LargeVector<double>* numbers : {&x, &y, &z, &radius}) {
      numbers->resize(members.size() + lanes);
      std::fill(numbers->end() - lanes, numbers->end(), 0.0);
    }
    share_stretches(workers, stretches, members.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const SphereAt& s = all[static_cast<std::size_t>(spheres[k])];
        x[k] = s.x;
        y[k] = s.y;
        z[k] = s.z;
        radius[k] = s.radius;
      }
    });
  }

 private:
  // Coordinates beyond the range of integers are in the outermost cells, as is NaN.
  std::int64_t index(double x) const {
    const double cell = std::floor(x * per_length_);
    return static_cast<std::int64_t>(cell > -farthest_cell ? std::min(cell, farthest_cell) : -farthest_cell);
  }
  std::uint64_t cell_of(const SphereAt& s) const {
    const auto of = [&](double x, std::size_t axis) { return static_cast<std::uint64_t>(index(x) - lowest_[axis]); };
    return (((of(s.x, 0) << bits_of_y_) | of(s.y, 1)) << bits_of_z_) | of(s.z, 2);
  }
  // Digit by digit.
  void sort() {
    constexpr int digit = 11;
    LargeVector<std::uint64_t> other_cells(cells.size());
    LargeVector<int> other_spheres(cells.size());
    for (int shift = 0; shift < bits_; shift += digit) {
      std::array<std::uint32_t, (1 << digit) + 1> begins{};
      const auto digit_of = [shift](std::uint64_t cell) { return (cell >> shift) & ((1 << digit) - 1); };
      for (const std::uint64_t cell : cells) ++begins[digit_of(cell) + 1];
      std::partial_sum(begins.begin(), begins.end(), begins.begin());
      for (std::size_t k = 0; k < cells.size(); ++k) {
        const std::uint32_t to = begins[digit_of(cells[k])]++;
        other_cells[to] = cells[k];
        other_spheres[to] = spheres[k];
      }
      cells.swap(other_cells);
      spheres.swap(other_spheres);
    }
  }

  double per_length_;
  std::array<std::int64_t, 3> lowest_;  // there is a cell before the first one, and after the last one
  int bits_of_z_ = 0, bits_of_y_ = 0, bits_ = 0;
};

// Pairs of some consecutive spheres with those in the adjacent rows.
class Search {
 public:
  // Both are in the same cells.
  Search(const SortedCells& seekers, const SortedCells& among, double margin)
      : seekers_(seekers), among_(among), margin_(margin), same_(&seekers == &among) {}

  template <class Pair>
  DALEMBERT_INLINE void operator()(std::size_t begin, std::size_t end, LargeVector<Pair>& found) const {
    if (begin == end) return;
    std::array<Row, 9> rows;
    std::size_t count = 0;  // number of preceding candidates among the same spheres
    for (int row = same_ ? own_row : 0; row < 9; ++row)
      rows[count++] = row_at(among_.way(row / 3 - 1, row % 3 - 1), seekers_.cells[begin]);
    std::size_t pairs = found.size();
    for (std::size_t k = begin; k < end; ++k) {
      std::size_t most = pairs + lanes;
      for (std::size_t r = 0; r < count; ++r) {
        rows[r].go_to(seekers_.cells[k], among_.cells);
        most += rows[r].end - rows[r].begin;
      }
      if (found.size() < most) found.resize(2 * most);
      for (std::size_t r = 0; r < count; ++r)
        pairs = look(k, same_ && r == 0 ? k + 1 : rows[r].begin, rows[r].end, found.data(), pairs);
    }
    found.resize(pairs);
  }

 private:
  static constexpr int own_row = 4;
  // Range of three cells in a row.
  struct Row {
    std::uint64_t way;
    std::size_t begin, end;
    DALEMBERT_INLINE void go_to(std::uint64_t cell, const LargeVector<std::uint64_t>& cells) {
      const std::uint64_t middle = cell + way;
      while (begin < cells.size() && cells[begin] + 1 < middle) ++begin;
      end = std::max(end, begin);
      while (end < cells.size() && cells[end] <= middle + 1) ++end;
    }
  };
  Row row_at(std::int64_t way, std::uint64_t cell) const {
    const std::uint64_t middle = cell + static_cast<std::uint64_t>(way);
    const auto at = static_cast<std::size_t>(std::ranges::lower_bound(among_.cells, middle - 1) - among_.cells.begin());
    return {static_cast<std::uint64_t>(way), at, at};
  }
  template <class Pair>
  DALEMBERT_INLINE std::size_t look(std::size_t k, std::size_t first, std::size_t last, Pair* found,
                                    std::size_t pairs) const {
    const int sphere = seekers_.spheres[k];
    const P x(seekers_.x[k]), y(seekers_.y[k]), z(seekers_.z[k]), reach(seekers_.radius[k] + margin_);
    for (std::size_t i = first; i < last; i += lanes) {
      const auto in = [i](const LargeVector<double>& numbers) DALEMBERT_INLINE { return P::load(numbers.data() + i); };
      const P dx = in(among_.x) - x, dy = in(among_.y) - y, dz = in(among_.z) - z, least = in(among_.radius) + reach;
      const P::Mask near = (dx * dx + dy * dy + dz * dz).x <= (least * least).x;
      if (P::is_none(near)) continue;
      for (std::size_t lane = 0; lane < std::min(lanes, last - i); ++lane) {
        const int other = among_.spheres[i + lane];
        found[pairs] = {std::min(sphere, other), std::max(sphere, other)};
        pairs += near[lane] != 0 ? 1 : 0;
      }
    }
    return pairs;
  }

  const SortedCells &seekers_, &among_;
  double margin_;
  bool same_;
};

// The corners of a bounding box; NaN counts as infinitely far away.
std::pair<SphereAt, SphereAt> corners(std::span<const SphereAt> spheres) {
  constexpr double far = std::numeric_limits<double>::infinity();
  SphereAt lower{far, far, far, 0}, upper{-far, -far, -far, 0};
  for (const SphereAt& s : spheres)
    for (const auto axis : {&SphereAt::x, &SphereAt::y, &SphereAt::z}) {
      lower.*axis = std::isnan(s.*axis) ? -far : std::min(lower.*axis, s.*axis);
      upper.*axis = std::max(upper.*axis, s.*axis);
    }
  return {lower, upper};
}

}  // namespace

void SphereNeighbours::clear(std::size_t spheres) {
  first_.assign(spheres + 1, 0);
  seconds_.clear();
}

// Spheres of similar size search in their own cells, and search larger spheres in the cells of these.
void SphereNeighbours::build(std::span<const SphereAt> spheres, double margin, Workers* workers) {
  const int n = static_cast<int>(spheres.size());
  if (n < 2) return clear(spheres.size());
  double smallest = spheres[0].radius;
  for (const SphereAt& s : spheres) smallest = std::min(smallest, s.radius);
  std::map<int, std::vector<int>> levels;
  double radius = 0;  // mostly that of the one before
  std::vector<int>* level_of_radius = nullptr;
  for (int i = 0; i < n; ++i) {
    if (const double now = spheres[static_cast<std::size_t>(i)].radius; now != radius) {
      radius = now;
      level_of_radius = &levels[std::min(40, std::ilogb(radius / smallest))];
      if (level_of_radius->empty()) level_of_radius->reserve(spheres.size());
    }
    level_of_radius->push_back(i);
  }
  const std::size_t stretches = n < spheres_to_share ? 1 : stretches_of_threads;
  found_.resize(stretches);
  for (LargeVector<Pair>& found : found_) found.clear();
  const auto [lower, upper] = corners(spheres);
  for (auto other = levels.begin(); other != levels.end(); ++other) {
    double largest = 0;
    for (const int i : other->second) largest = std::max(largest, spheres[static_cast<std::size_t>(i)].radius);
    SortedCells among(2 * largest + margin, lower, upper), seekers = among;
    among.fill(spheres, other->second, workers, stretches);
    for (auto level = levels.begin(); level != std::next(other); ++level) {
      if (level != other) seekers.fill(spheres, level->second, workers, stretches);
      const Search search(level == other ? among : seekers, among, margin);
      share_stretches(workers, stretches, level->second.size(),
                      [&](std::size_t stretch, std::size_t begin, std::size_t end) {
                        in_registers_of_four([&, begin, end] { search(begin, end, found_[stretch]); });
                      });
    }
  }
  sort_pairs(spheres.size(), workers);
}

// Sorts by the first sphere, and then by the second one.
void SphereNeighbours::sort_pairs(std::size_t spheres, Workers* workers) {
  first_.assign(spheres + 2, 0);  // one more than needed: each number is shifted to the start of the next one
  for (const LargeVector<Pair>& found : found_)
    for (const Pair& pair : found) ++first_[static_cast<std::size_t>(pair.first) + 2];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  seconds_.resize(first_.back());
  for (const LargeVector<Pair>& found : found_)
    for (const Pair& pair : found) seconds_[first_[static_cast<std::size_t>(pair.first) + 1]++] = pair.second;
  first_.pop_back();
  share_stretches(workers, found_.size(), spheres, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      std::sort(seconds_.begin() + static_cast<std::ptrdiff_t>(first_[i]),
                seconds_.begin() + static_cast<std::ptrdiff_t>(first_[i + 1]));
  });
}

}  // namespace dalembert
