// What batches read while a residual or a tangent is evaluated, and where they write.
#pragma once

#include <span>
#include <vector>

namespace dalembert {

// One state, as the batches see it. Pointers into vectors of the whole system.
template <class S>
struct EvaluationOf {
  const S* q = nullptr;            // ODE2 totals: reference + displacement
  const S* u = nullptr;            // ODE2 displacements
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
  bool same_state = false;         // as in the evaluation before
  bool of_reference = false;       // of the reference configuration, for outputs
};
using Evaluation = EvaluationOf<double>;

// Directions of a tangent: dq = q, dv = v, da = a per unit of the increment of an ODE2 coordinate.
// Rows of constraints are divided by `q` (by `v` if q is 0), so that scaling all three scales the ODE2 rows only.
struct Weights {
  double q = 1, v = 0, a = 0;
  double y = 1, y_t = 0;  // ODE1 coordinates and their rates
};

}  // namespace dalembert
