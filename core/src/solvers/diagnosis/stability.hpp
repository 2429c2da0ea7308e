// Linear stability of explicit methods: growth of the fastest vibration per step.
#pragma once

#include <functional>
#include <vector>

#include "dalembert/solvers/runge_kutta.hpp"
#include "dalembert/solvers/vibration.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

// Computes the fastest vibration of the system, linearized about `state` without accelerations and multipliers.
// `accelerate` computes constrained accelerations from forces, and returns false if it cannot. Coordinates of `held`
// remain zero.
Vibration fastest_vibration(System& system, const State& state, const Conditions& conditions,
                            const std::function<bool(std::vector<double>&)>& accelerate, const std::vector<int>& held);

// Returns the largest amplification of one step.
double amplification(const RungeKuttaMethod& method, const Vibration& vibration, double step_size);
double verlet_amplification(const Vibration& vibration, double step_size);

// Returns the step size, or the next smaller one for which the vibration grows by less than a hundredth per period; 0
// if there is no such step size.
double largest_stable_step(const Vibration& vibration, double step_size,
                           const std::function<double(double)>& amplified);

}  // namespace dalembert
