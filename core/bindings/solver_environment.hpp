// The connection of a solver with Python: user functions of the main system, console, interruption, sensors.
#pragma once

#include <memory>

#include "dalembert/solvers/solver.hpp"
#include "main_system.hpp"

namespace dalembert {

// Hooks and sensors as they are set in `main` now, which must outlive them. Functions take the GIL when they need it.
SolverEnvironment make_environment(const std::shared_ptr<MainSystem>& main);

}  // namespace dalembert
