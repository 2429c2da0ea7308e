// Rank of the constraints at the start of a solution.
#include <utility>

#include "constraints/constraint_states.hpp"
#include "dalembert/solvers/constraint_solver.hpp"
#include "dalembert/solvers/solver.hpp"
#include "constraints/singular_positions.hpp"

namespace dalembert {

namespace {

constexpr double near_position = 1e-3;  // relative to the size of the model

}  // namespace

[[gnu::noinline]] void Solver::find_rank(const State& at) {
  ConstraintRank rank;
  bool remains_known = true;
  if (constraint_solver().active()) {
    const auto rank_at = [&](const State& state) {
      return ConstraintRank(
          *system_, state, conditions_,
          constraint_metric(*system_, state, conditions_, settings_->redundantConstraints.momentLength));
    };
    rank = rank_at(at);
    bool leaves = rank.count() == 0;
    // In a singular position, more equations depend on each other than near it.
    if (rank.count() > 0 && !is_static()) {
      ConstraintRank near = rank_at(singular_->moved_along_velocities(at, near_position));
      if (near.count() < rank.count()) {
        rank = std::move(near);
        // The first step, and a motion from rest, need the regularization.
        remains_known = leaves = it.currentStepIndex > 0 && largest(start_of_step().v) > at_rest;
      }
    }
    if (leaves && rank.count() == 0 && rank.certain() && !is_static()) solve_as_regular();
  }
  take_rank(std::move(rank));
  rank_known_ = remains_known;
}

// Announces redundant equations once.
void Solver::take_rank(ConstraintRank rank) {
  rank_ = std::move(rank);
  rank_known_ = true;
  system_->reactions_are_known(rank_.equations());
  if (rank_.count() == 0 || std::exchange(announced_rank_, true) || !verbose(1)) return;
  std::string text =
      "  " + std::to_string(rank_.count()) + " of " + std::to_string(rank_.equations_examined()) +
      " constraint equations follow from others; where reactions are not unique, the smallest are taken:\n";
  for (const auto& item : rank_.items(system()))
    text += "    " + item.item + ": " + std::to_string(item.removable) + " of " + std::to_string(item.equations) +
            " could be left out\n";
  say(1, text);
}

}  // namespace dalembert
