// LU factors of several small matrices at once, whose pivots lie in the same rows: digit by digit those of DenseLu.
#pragma once

#include <span>
#include <vector>

#include "dalembert/math/lane_block.hpp"
#include "elimination_list.hpp"

namespace dalembert {

class LaneFactors {
 public:
  // As EliminationList.
  LaneFactors(std::span<const int> row_of_step, std::span<const char> occupied);

  const std::vector<int>& row_of_step() const { return row_of_step_; }
  // `value(k)`: entry k of the matrices, by columns. Lanes that are not `wanted` keep their factors, if there are `others`.
  template <class F>
  void factorize(std::span<const bool> wanted, bool others, F&& value) {
    for (const EliminationList::Source& source : list_.sources) next_[source.to] = value(source.from);
    for (const std::uint16_t place : list_.fill) next_[place] = LaneBlock();
    eliminate();
    others ? take(wanted) : factors_.swap(next_);
  }
  // Whether DenseLu would keep the pivots of the last factorization; their reciprocals must be below this bound.
  bool usable(int lane, double largest_inverse) const;
  // The solutions for the right-hand sides with the entries `value(k)`, until the next call.
  template <class F>
  const std::vector<LaneBlock>& solve(F&& value) {
    for (std::size_t k = 0; k < work_.size(); ++k) work_[k] = value(row_of_step_[k]);
    substitute();
    return work_;
  }

 private:
  void eliminate();
  void substitute();
  void take(std::span<const bool> wanted);

  std::vector<int> row_of_step_;
  EliminationList list_;
  std::vector<LaneBlock> factors_,
      next_;  // entries of the list, then reciprocals of the pivots; `next_` are those of all lanes
  std::vector<LaneBlock> work_;
  LaneBlock growth_;
};

}  // namespace dalembert
