// The factors of a tree of fronts as two contiguous streams, one for the forward and one for the backward
// substitution. Pivots are processed in groups of eight; the last group of a front has the rest. Each group has a
// multiple of four numbers in the vector of unknowns, four or eight: these positions are called slots.
#pragma once

#include <cstddef>

namespace dalembert {

inline constexpr int pivot_group = 8, half_group = pivot_group / 2;

struct FrontSize {
  int pivots, updates;
};

constexpr int group_slots(int pivots) { return pivots <= half_group ? half_group : pivot_group; }
// First pivot of the last group; negative if there are no pivots.
constexpr int last_group(int pivots) { return ((pivots + pivot_group - 1) / pivot_group - 1) * pivot_group; }
constexpr int slots(int pivots) {
  return pivots <= 0 ? 0 : last_group(pivots) + group_slots(pivots - last_group(pivots));
}

// Columns of inverse triangles are stored in halves of four numbers without zero halves: returns the offset of column
// j of up to eight, or the size of j columns.
constexpr int lower_column(int j, int height) { return j <= half_group ? height * j : half_group * (j + half_group); }
constexpr int upper_column(int j) { return j <= half_group ? half_group * j : pivot_group * (j - half_group / 2); }

struct StreamSizes {
  std::size_t lower, upper;
};
// Numbers that a front has in the streams.
//
// Lower, group by group: the inverse of L within the group, then the rows of L below it, those of the front's pivots and those
// that its parent takes over, in chunks of eight rows and at last four. Upper, from the last group to the first: the columns
// of U right of the group, then the inverse of U within the group.
StreamSizes stream_sizes(const FrontSize& front);

}  // namespace dalembert
