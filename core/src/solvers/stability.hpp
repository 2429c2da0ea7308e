// Linear stability of explicit methods: how the fastest vibration of a system grows from step to step.
#pragma once

#include <functional>
#include <vector>

#include "dalembert/solvers/mass_operator.hpp"
#include "dalembert/solvers/runge_kutta.hpp"

namespace dalembert {

// x_tt + damping x_t + frequency^2 x = 0
struct Vibration {
  double frequency = 0;  // rad/s; 0: there is none
  double damping = 0;    // 1/s
  int coordinate = -1;   // which moves most
};

// Of the system linearized about `state`, with coordinates held at zero. `mass` is left with the factors of this state.
Vibration fastest_vibration(System& system, State state, const Conditions& conditions, MassOperator& mass, const std::vector<int>& held);

// Largest factor by which one step changes the amplitude.
double amplification(const RungeKuttaMethod& method, const Vibration& vibration, double step_size);
double verlet_amplification(const Vibration& vibration, double step_size);

// The step size itself, or the next smaller one that lets the vibration grow by less than a hundredth in a period; 0: none does.
double largest_stable_step(const Vibration& vibration, double step_size, const std::function<double(double)>& amplified);

}  // namespace dalembert
