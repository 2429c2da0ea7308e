// Solvers of variations of one model that step together: each has its own logic, and expensive parts are computed for
// all of them at once (lane_program.hpp). Results are bit-identical to single solutions.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "../linear/lane_factors.hpp"
#include "dalembert/math/lane_block.hpp"
#include "dalembert/math/traced.hpp"
#include "dalembert/solvers/second_order.hpp"
#include "lane_program.hpp"

namespace dalembert {

class Lockstep {
 public:
  static constexpr int most = block_lanes;

  // The reason why an initialized solver cannot join; empty if it can. Reasons are settings that change the
  // operations of a step, hooks, history, and items whose arithmetic cannot be traced.
  static std::string obstacle(SecondOrderSolver& solver);

  // Solves the steps of up to `most` initialized solvers. False for those that met something unusual: they are of no use
  // any more, and their systems are in the middle of it.
  std::vector<bool> solve_steps(std::span<SecondOrderSolver* const> solvers);

 private:
  struct Lane {
    SecondOrderSolver* solver = nullptr;
    bool here = false;
    double step_size = 0;           // that the constants are for
    std::vector<double> constants;  // constants of its trace
    LaneFactors* factors = nullptr;
    double norm = 0;  // norm of the residual
  };
  using Lanes = std::array<bool, most>;

  template <class F>
  void each(const Lanes& wanted, F&& f);
  template <class F>
  Lanes which(const Lanes& among, F&& f);
  Lanes all_here() const;
  bool note(Lane& lane);
  static bool is_usual(const SecondOrderSolver& solver);  // after an iteration
  void compile();
  void take_step(const Lanes& lanes);
  void iterate(const Lanes& lanes);
  void find_residuals(const Lanes& lanes);
  void renew_factors(const Lanes& lanes);
  void search_pivots(int lane);
  void factorize(const Lanes& lanes);
  void correct_motion(const Lanes& lanes);
  void find_increments(const Lanes& lanes);
  int matrix_output(int k) const;
  LaneFactors& factors_for(std::span<const int> row_of_step);

  Trace trace_;
  ConstantClasses classes_;
  LaneProgram program_;
  std::vector<std::unique_ptr<LaneFactors>> factors_;
  std::array<Lane, most> lanes_;
  std::vector<LaneProgram::Places>
      inputs_;  // the numbers of the states that noted equations depend on, where they stay
  int unknowns_ = 0;
  bool compiled_ = false;
};

}  // namespace dalembert
