// Gimbal lock of three angles: at 90 degrees of the second angle, the axes of the first and third rotation coincide.
//
// Close to it, both angles rotate by up to half a turn in opposite directions within a short time. Steps that are too
// large for this produce wrong motions. Torques about the lost direction do no work on the angles, so that these may be
// in equilibrium although the body is not.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dalembert/solvers/data.hpp"
#include "dalembert/solvers/hooks.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

class Model;

class LockingAngles {
 public:
  // Finds the angles of nodes and trees. `model` may be null.
  void begin(const System& system, const Model* model, const std::vector<LockingTurns>& turns);
  bool any() const { return !angles_.empty(); }
  // Registers angles for which the step was too large.
  void watch(System& system, const SolverIterationData& it);
  // Doubts about a finished motion, and about an equilibrium.
  std::vector<std::string> doubts(bool has_error_control) const;
  std::vector<std::string> doubts_of_equilibrium(System& system) const;
  // Adds advice on gimbal lock, found earlier or in the current state.
  void advise(System& system, std::vector<std::string>& advice) const;
  // Results of earlier steps, for restart files.
  static constexpr std::size_t numbers_per_lock = 4;
  void add_numbers(std::vector<double>& numbers) const;
  void take_numbers(std::span<const double> numbers);

 private:
  // Three successive rotations, of a node or of a tree in place of a ball joint.
  struct Angles {
    int node;  // -1 for a tree
    std::size_t first;  // first coordinate
  };
  struct Lock {
    std::size_t first;  // first coordinate
    StepCount steps;  // number of steps that were too large
    double time, second_angle;  // of the first of these steps
  };
  std::string text_of(const Angles& angles, double second_angle) const;

  const Model* model_ = nullptr;
  std::vector<LockingTurns> turns_;
  std::vector<Angles> angles_;
  std::vector<Lock> locks_;
};

}  // namespace dalembert
