// Linear stability of explicit methods: how the fastest vibration of a system grows from step to step.
#pragma once

#include <functional>
#include <vector>

#include "dalembert/solvers/runge_kutta.hpp"
#include "dalembert/solvers/vibration.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

// Of the system linearized about `state`, without accelerations and multipliers. `accelerate` makes accelerations of forces, as constraints
// allow; false: it cannot. Coordinates of `held` stay at zero.
Vibration fastest_vibration(System& system, const State& state, const Conditions& conditions, const std::function<bool(std::vector<double>&)>& accelerate,
                            const std::vector<int>& held);

// Largest factor by which one step changes the amplitude.
double amplification(const RungeKuttaMethod& method, const Vibration& vibration, double step_size);
double verlet_amplification(const Vibration& vibration, double step_size);

// The step size itself, or the next smaller one that lets the vibration grow by less than a hundredth in a period; 0: none does.
double largest_stable_step(const Vibration& vibration, double step_size, const std::function<double(double)>& amplified);

}  // namespace dalembert
