// Connectors with a law, side by side: all that their forces depend on in blocks of eight, and the loop over the blocks.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <type_traits>
#include <vector>

#include "dalembert/batches/shared_blocks.hpp"
#include "dalembert/contracts/span_forces.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/math/pack.hpp"
#include "dalembert/math/wide_registers.hpp"
#include "dalembert/system/ports.hpp"

namespace dalembert {

template <SpanLawConnector K>
class SpanLaws {
 public:
  using Law = typename K::template Law<double>;

  static constexpr Law no_force{};

  void reserve(std::size_t entries) { blocks_.reserve((entries + block_lanes - 1) / block_lanes); }
  void add(const std::array<int, 2>& markers, const Ports& ports) {
    const int lane = static_cast<int>(count_++ % block_lanes);
    if (lane == 0) {
      if (!blocks_.empty()) laws_.share(blocks_.back().law);
      blocks_.emplace_back().law = laws_.add();
    }
    Block& block = blocks_.back();
    for (int m = 0; m < 2; ++m) {  // lanes that no entry follows add their nothing to the last one
      const PortLayout& port = ports.ports[markers[m]];
      std::fill(block.values[m].begin() + lane, block.values[m].end(), port.first_value);
      std::fill(block.forces[m].begin() + lane, block.forces[m].end(), port.first_force);
      if (is_point(port)) {
        std::fill(block.derivative.begin() + (block.has_points ? lane : 0), block.derivative.end(),
                  port.first_derivative);
        block.has_points = true;
      }
    }
    block.ends[lane] = ends_of(ports.ports[markers[0]], ports.ports[markers[1]]);
  }
  void set_law(int entry, const Law& law) {
    without_law_.erase(entry);
    place(entry, law);
  }
  void drop_law(int entry) {
    without_law_.insert(entry);
    place(entry, no_force);
  }
  // Entries that are not computed here.
  const std::set<int>& without_law() const { return without_law_; }

  // Adds the forces on the markers, one connector after the other. Frames and forces are processed in fours.
  void add_forces(const double* values, double* forces) const {
    const auto add = [&]<int L>() {
      for (const Block& block : blocks_)
        for (int first = 0; first < block_lanes; first += L)
          add_some<L>(laws_[block.law], block, first, values, forces);
    };
    in_fours(add);
  }

  // Adds to the matrix: values[slots[row * n + column]], one connector after the other. `add_other(entry, slots)`
  // handles connectors without a law or with other markers, and returns the end of their slots.
  template <class F>
  void add_tangents(const Ports& ports, const int* slots, double* values, const F& add_other) const {
    const auto add = [&]<int L>() {
      std::array<double, matrix_size * L> matrices;
      int entry = 0;
      for (const Block& block : blocks_)
        for (int first = 0; first < block_lanes && entry < static_cast<int>(count_); first += L) {
          if (block.has_points) find_matrices<L>(laws_[block.law], block, first, ports, matrices.data());
          for (int lane = 0; lane < L && entry < static_cast<int>(count_); ++lane, ++entry) {
            const Ends ends = has_law(entry) ? block.ends[first + lane] : Ends::other;
            const double* matrix = matrices.data() + matrix_size * lane;
            if (ends == Ends::both)
              slots = add_between_points(matrix, slots, values);
            else if (ends == Ends::one)
              slots = add_at_point(matrix, slots, values);
            else if (ends == Ends::other)
              slots = add_other(entry, slots);
          }
        }
    };
    in_fours(add);
  }

 private:
  // Ends that move like points, with three coordinates; other ends, or none.
  enum class Ends : char { both, one, none, other };
  static bool is_point(const PortLayout& port) { return port.n == 3 && port.translations == 3; }
  static Ends ends_of(const PortLayout& a, const PortLayout& b) {
    if (is_point(a) && is_point(b)) return Ends::both;
    if ((is_point(a) && b.n == 0) || (a.n == 0 && is_point(b))) return Ends::one;
    return a.n + b.n == 0 ? Ends::none : Ends::other;
  }
  // Operations are not fused: the numbers equal those of a single connector.
  template <class Loop>
  static void in_fours(const Loop& loop) {
    if (numbers_in_register() == 2)
      run_in_any_registers([&] { loop.template operator()<2>(); });
    else
      run_in_registers_of_four([&] { loop.template operator()<4>(); });
  }

  static_assert(std::is_same_v<typename K::Port, PointPort>, "a frame is taken as the six numbers of a point");
  static constexpr int law_size = sizeof(Law) / sizeof(double);

  using LawBlocks = typename SharedBlocks<law_size>::Blocks;
  struct Block {
    int law = -1;  // place
    std::array<std::array<int, block_lanes>, 2> values{}, forces{};  // offsets, by marker
    std::array<int, block_lanes> derivative{};  // offset, of a point that moves
    std::array<Ends, block_lanes> ends{};
    bool has_points = false;
  };

  void place(int entry, const Law& law) {
    const auto* numbers = reinterpret_cast<const double*>(&law);
    auto& block = laws_.own(blocks_[static_cast<std::size_t>(entry) / block_lanes].law);
    for (int i = 0; i < law_size; ++i) block[i].at(entry % block_lanes) = numbers[i];
  }

  // Some lanes of a block: their laws, and the way from the first marker to the second.
  template <int L>
  struct Some {
    typename K::template Law<Pack<L>> law;
    Vec3<Pack<L>> span, rate;

    DALEMBERT_INLINE Some(const LawBlocks& laws, const Block& block, int first, const double* values) {
      for (int i = 0; i < law_size; ++i)
        reinterpret_cast<Pack<L>*>(&law)[i] = Pack<L>::load(reinterpret_cast<const double*>(&laws[i]) + first);
      const auto differences = [&](int number) DALEMBERT_INLINE {  // differences of four numbers of the frames
        return columns_of<L>([&](int lane) DALEMBERT_INLINE {
          const auto frame = [&](int m) DALEMBERT_INLINE {
            return Pack<4>::load(values + block.values[m][first + lane] + number);
          };
          return frame(1) - frame(0);
        });
      };
      const auto spans = differences(0), rates = differences(2);  // start with the last number of the span
      span = {spans[0], spans[1], spans[2]};
      rate = {rates[1], rates[2], rates[3]};
    }
  };

  template <int L>
  static void add_some(const LawBlocks& laws, const Block& block, int first, const double* values, double* forces) {
    const Some<L> some(laws, block, first, values);
    const Vec3<Pack<L>> f = K::force(some.law, some.span, some.rate);
    const auto rows = rows_from<L>({f[0], f[1], f[2], Pack<L>()});
    for (int lane = 0; lane < L; ++lane) {
      rows[lane].add_to(forces + block.forces[0][first + lane]);
      rows[lane].subtract_from(forces + block.forces[1][first + lane]);
    }
  }

  // Points move with their coordinates along the axes: the derivative with respect to coordinates is the weighted
  // derivative with respect to span and rate. Ordered by lane, then row by row.
  static constexpr int matrix_size = 12;  // nine, stored in fours
  template <int L>
  static void find_matrices(const LawBlocks& laws, const Block& block, int first, const Ports& ports,
                            double* matrices) {
    const Some<L> some(laws, block, first, ports.values.data());
    const auto weight = [&](int component) DALEMBERT_INLINE {
      return Pack<L>::of_each([&](int lane) {
        return ports.derivatives[static_cast<std::size_t>(block.derivative[first + lane] + component)];
      });
    };
    const SpanTangent<3, Pack<L>> t = K::tangent(some.law, some.span, some.rate);
    const Pack<L> span_weight = weight(0), rate_weight = weight(9);
    const auto number = [&](int k) DALEMBERT_INLINE {
      return k < 9 ? span_weight * t.by_span.x[k] + rate_weight * t.by_rate.x[k] : Pack<L>();
    };
    for (int k = 0; k < matrix_size; k += 4) {
      const auto rows = rows_from<L>({number(k), number(k + 1), number(k + 2), number(k + 3)});
      for (int lane = 0; lane < L; ++lane) rows[lane].store(matrices + matrix_size * lane + k);
    }
  }
  static const int* add_at_point(const double* matrix, const int* slots, double* values) {
    for (int k = 0; k < 9; ++k) values[slots[k]] += matrix[k];
    return slots + 9;
  }
  static const int* add_between_points(const double* matrix, const int* slots, double* values) {
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) {
        const double number = matrix[3 * row + column];
        const int* slot = slots + 6 * row + column;
        values[slot[0]] += number;
        values[slot[3]] -= number;
        values[slot[18]] -= number;
        values[slot[21]] += number;
      }
    return slots + 36;
  }

  bool has_law(int entry) const { return without_law_.empty() || !without_law_.contains(entry); }

  std::vector<Block> blocks_;
  SharedBlocks<law_size> laws_;
  std::size_t count_ = 0;
  std::set<int> without_law_;
};

// Additional data of a batch of connectors; empty if its kernel has no laws.
template <class K>
struct SpansOf {
  struct Type {};
};
template <SpanLawConnector K>
struct SpansOf<K> {
  using Type = SpanLaws<K>;
};

}  // namespace dalembert
