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
  void add(const std::array<PortOffsets, 2>& ports) {
    const int lane = static_cast<int>(count_++ % block_lanes);
    if (lane == 0) {
      if (!blocks_.empty()) laws_.share(blocks_.back().law);
      blocks_.emplace_back().law = laws_.add();
    }
    for (int m = 0; m < 2; ++m) {  // lanes that no entry follows add their nothing to the last one
      std::fill(blocks_.back().values[m].begin() + lane, blocks_.back().values[m].end(), ports[m].value);
      std::fill(blocks_.back().forces[m].begin() + lane, blocks_.back().forces[m].end(), ports[m].force);
    }
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

  // To the forces on the markers, one connector after the other. Frames and forces are taken in fours. Nothing is fused: the numbers
  // are those of one connector alone.
  void add_forces(const double* values, double* forces) const {
    const auto add = [&]<int L>() {
      for (const Block& block : blocks_)
        for (int first = 0; first < block_lanes; first += L) add_some<L>(laws_[block.law], block, first, values, forces);
    };
    if (numbers_in_register() == 2) run_in_any_registers([&] { add.template operator()<2>(); });
    else run_in_registers_of_four([&] { add.template operator()<4>(); });
  }

 private:
  static_assert(std::is_same_v<typename K::Port, PointPort>, "a frame is taken as the six numbers of a point");
  static constexpr int law_size = sizeof(Law) / sizeof(double);

  using LawBlocks = typename SharedBlocks<law_size>::Blocks;
  struct Block {
    int law = -1;  // place
    std::array<std::array<int, block_lanes>, 2> values{}, forces{};  // offsets, by marker
  };

  void place(int entry, const Law& law) {
    const auto* numbers = reinterpret_cast<const double*>(&law);
    auto& block = laws_.own(blocks_[static_cast<std::size_t>(entry) / block_lanes].law);
    for (int i = 0; i < law_size; ++i) block[i].at(entry % block_lanes) = numbers[i];
  }

  template <int L>
  static void add_some(const LawBlocks& laws, const Block& block, int first, const double* values, double* forces) {
    typename K::template Law<Pack<L>> law;
    for (int i = 0; i < law_size; ++i) reinterpret_cast<Pack<L>*>(&law)[i] = Pack<L>::load(reinterpret_cast<const double*>(&laws[i]) + first);
    const auto differences = [&](int number) {  // of four numbers of the frames
      return columns_of<L>([&](int lane) DALEMBERT_INLINE {
        const auto frame = [&](int m) DALEMBERT_INLINE { return Pack<4>::load(values + block.values[m][first + lane] + number); };
        return frame(1) - frame(0);
      });
    };
    const auto span = differences(0), rate = differences(2);  // which begins with the last number of the span
    const Vec3<Pack<L>> f = K::force(law, Vec3<Pack<L>>{span[0], span[1], span[2]}, Vec3<Pack<L>>{rate[1], rate[2], rate[3]});
    const auto rows = rows_from<L>({f[0], f[1], f[2], Pack<L>()});
    for (int lane = 0; lane < L; ++lane) {
      rows[lane].add_to(forces + block.forces[0][first + lane]);
      rows[lane].subtract_from(forces + block.forces[1][first + lane]);
    }
  }

  std::vector<Block> blocks_;
  SharedBlocks<law_size> laws_;
  std::size_t count_ = 0;
  std::set<int> without_law_;
};

// What a batch of connectors keeps besides: nothing, if its kernel has no laws.
template <class K>
struct SpansOf {
  struct Type {};
};
template <SpanLawConnector K>
struct SpansOf<K> {
  using Type = SpanLaws<K>;
};

}  // namespace dalembert
