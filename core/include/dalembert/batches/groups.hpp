// Entries of a batch side by side, as many as registers hold: their numbers are gathered from memory into lanes, and
// results are scattered back lane by lane.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "dalembert/math/fixed.hpp"
#include "dalembert/math/pack.hpp"
#include "dalembert/math/wide_registers.hpp"

namespace dalembert {

// One number per lane for L entries; a plain number for a single entry.
template <int L>
struct NumbersOf {
  using Type = Pack<L>;
};
template <>
struct NumbersOf<1> {
  using Type = double;
};
template <int L>
using Numbers = typename NumbersOf<L>::Type;

// `count` entries from `first` on; lanes beyond repeat the last one.
template <int L>
struct Group {
  std::size_t first;
  int count;

  // Gathers of_entry(i) for the entry i of each lane.
  template <class F>
  DALEMBERT_INLINE auto each(const F& of_entry) const {
    return [&]<int... lane>(std::integer_sequence<int, lane...>) DALEMBERT_INLINE {
      return std::array{of_entry(first + static_cast<std::size_t>(std::min(lane, count - 1)))...};
    }(std::make_integer_sequence<int, L>{});
  }
  template <class F>
  DALEMBERT_INLINE Numbers<L> numbers(const F& of_entry) const {
    const std::array<double, L> all = each(of_entry);
    if constexpr (L == 1)
      return all[0];
    else
      return Pack<L>::of_each([&all](int lane) { return all[static_cast<std::size_t>(lane)]; });
  }
};

template <class F>
DALEMBERT_INLINE inline void each_group_of_four(std::size_t begin, std::size_t end, const F& f) {
  for (; begin + 1 < end; begin += 4) f(Group<4>{begin, static_cast<int>(std::min<std::size_t>(4, end - begin))});
  if (begin < end) f(Group<1>{begin, 1});
}

// Calls f(group) for groups that cover the entries [begin, end). Groups have one entry if there are no wide
// registers, or if entries cannot be computed together.
template <bool together = true, class F>
void each_group(std::size_t begin, std::size_t end, const F& f) {
  const auto one_by_one = [&] {
    for (std::size_t i = begin; i < end; ++i) f(Group<1>{i, 1});
  };
  if constexpr (!together)
    in_wide_registers(one_by_one);
  else if (has_wide_registers())
    run_in_wide_registers([&] { each_group_of_four(begin, end, f); });
  else
    run_in_any_registers(one_by_one);
}

// Calls f<first>, where up to four of `Count` numbers begin; the last four may overlap those before.
template <int Count, class F>
DALEMBERT_INLINE inline void each_four(const F& f) {
  static_assert(Count >= 4);
  [&]<int... four>(std::integer_sequence<int, four...>) DALEMBERT_INLINE {
    (f.template operator()<std::min(4 * four, Count - 4)>(), ...);
  }(std::make_integer_sequence<int, (Count + 3) / 4>{});
}

// `Count` numbers from each place.
template <int Count, class T, std::size_t L>
DALEMBERT_INLINE inline auto gathered(const std::array<T*, L>& from) {
  constexpr int lanes = static_cast<int>(L);
  if constexpr (lanes == 1) {
    return vector_of<Count>([&](int i) DALEMBERT_INLINE { return from[0][i]; });
  } else if constexpr (Count < 4) {
    return vector_of<Count>([&](int i) DALEMBERT_INLINE {
      return Pack<lanes>::of_each([&](int lane) { return from[static_cast<std::size_t>(lane)][i]; });
    });
  } else {
    const auto fours = vector_of<(Count + 3) / 4>([&](int four) DALEMBERT_INLINE {
      const int first = std::min(4 * four, Count - 4);
      return columns_of<lanes>(
          [&](int lane) DALEMBERT_INLINE { return Pack<4>::load(from[static_cast<std::size_t>(lane)] + first); });
    });
    return vector_of<Count>([&](int i) DALEMBERT_INLINE {
      const int four = i / 4;
      return fours[four][static_cast<std::size_t>(i - std::min(4 * four, Count - 4))];
    });
  }
}
template <template <class> class Record, std::size_t L>
DALEMBERT_INLINE inline auto gathered(const std::array<const Record<double>*, L>& from) {
  static_assert(sizeof(Record<double>) == Record<double>::count * sizeof(double));
  std::array<const double*, L> places;
  for (std::size_t lane = 0; lane < L; ++lane) places[lane] = reinterpret_cast<const double*>(from[lane]);
  return Record<Numbers<static_cast<int>(L)>>::of(gathered<Record<double>::count>(places));
}
// Writes `Count` numbers to each place; lanes that repeat an entry write the same.
template <int Count, class S, std::size_t L>
DALEMBERT_INLINE inline void store_numbers(const Vec<S, Count>& from, const std::array<double*, L>& to) {
  constexpr int lanes = static_cast<int>(L);
  if constexpr (lanes == 1) {
    for (int i = 0; i < Count; ++i) to[0][i] = from[i];
  } else {
    each_four<Count>([&]<int first>() DALEMBERT_INLINE {
      each_row<lanes>({from[first], from[first + 1], from[first + 2], from[first + 3]}, lanes,
                      [&](int lane, const Pack<4>& row)
                          DALEMBERT_INLINE { row.store(to[static_cast<std::size_t>(lane)] + first); });
    });
  }
}
// Adds the numbers of the first `count` lanes; lanes with the same address are added one after the other.
template <int Count, class S, std::size_t L>
DALEMBERT_INLINE inline void add_numbers(const Vec<S, Count>& from, const std::array<double*, L>& to, int count) {
  constexpr int lanes = static_cast<int>(L);
  if constexpr (lanes == 1) {
    for (int i = 0; i < Count; ++i) to[0][i] += from[i];
  } else if constexpr (Count < 4) {
    for (int lane = 0; lane < count; ++lane)
      for (int i = 0; i < Count; ++i) to[static_cast<std::size_t>(lane)][i] += from[i][lane];
  } else {
    each_four<Count>([&]<int first>() DALEMBERT_INLINE {
      constexpr int done = first % 4 == 0 ? 0 : 4 - Count % 4;  // numbers that the four before have added
      const auto number = [&](int i) DALEMBERT_INLINE { return i < done ? S(0.0) : from[first + i]; };
      each_row<lanes>({number(0), number(1), number(2), number(3)}, count,
                      [&](int lane, const Pack<4>& row)
                          DALEMBERT_INLINE { row.add_to(to[static_cast<std::size_t>(lane)] + first); });
    });
  }
}

}  // namespace dalembert
