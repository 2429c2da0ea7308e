// Input and output of batches during the evaluation of a residual or a tangent.
#pragma once

#include <span>
#include <vector>

namespace dalembert {

// One state as the batches see it: pointers into vectors of the whole system.
template <class S>
struct EvaluationOf {
  const S* q = nullptr;            // ODE2 totals: reference + displacement
  const S* u = nullptr;            // ODE2 displacements
  const double* reference = nullptr;
  const S* v = nullptr;
  const S* a = nullptr;
  const S* y = nullptr;            // ODE1
  const S* y_t = nullptr;
  const S* lambda = nullptr;
  const double* data = nullptr;
  double time = 0;
  double load_factor = 1;          // static solver: loads grow with it
  double step_size = 0;
  bool rate_level = false;         // constraints as time derivatives of their gaps (index 2)
  bool inertia = true;             // false: static, accelerations and velocities play no part
  bool direct = false;  // explicit integration: forces depend only on this state, contacts are not fixed by a search
  bool same_state = false;  // same state as in the previous evaluation
  // terms that can read nodes directly do so, and compute totals: these markers have no other readers
  bool reads_nodes = false;
  bool of_reference = false;  // reference configuration, for outputs
};
using Evaluation = EvaluationOf<double>;

// Weights are seeds. An implicit step needs one combination of three matrices, q dr/dq + v dr/dv + a dr/da, and none of them
// by itself: coordinates enter the residual as dual numbers (math/dual.hpp) whose derivatives are the weights.
//
//     coordinate j      value    derivative j    the others
//     q[j]              q_j      weights.q       0
//     v[j]              v_j      weights.v       0
//     a[j]              a_j      weights.a       0
//
//     r(q, v, a)        r_i      q dr_i/dq_j + v dr_i/dv_j + a dr_i/da_j        row i, column j, in one sweep
//
// Weights {1, 0, 0} give the stiffness matrix, {0, 1, 0} that of damping, {0, 0, 1} the mass matrix.
//
// Rows of constraints are divided by `q` (by `v` if q is 0), so that scaling all three scales the ODE2 rows only.
struct Weights {
  double q = 1, v = 0, a = 0;
  double y = 1, y_t = 0;  // ODE1 coordinates and their rates
};

}  // namespace dalembert
