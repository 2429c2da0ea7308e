#include "dalembert/solvers/step_controller.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dalembert {

namespace {

constexpr double smallest_factor = 0.2;  // of the step size, after a step with a large error
// Smaller increases do not pay for a factorization and the loss of accuracy of algorithmic accelerations.
constexpr double not_worth_it = 1.2;
constexpr double last_stretch = 1.1;     // the remaining time is one step if it is at most this many steps long
constexpr int most_above_tolerance = 100;  // in succession; a jump is passed in a few steps

}  // namespace

void StepController::start(const StepFactors& factors) {
  factors_ = factors;
  it_.currentStepSize = it_.automaticStepSize ? it_.initialStepSize : it_.maxStepSize;
  equal_ = EqualSteps();
  since_rejection_ = 0;
  above_tolerance_ = 0;
  rejected_by_error_ = false;
  prescribed_step_ = -1;
}

void StepController::resume(double size, std::span<const double> numbers) {
  it_.currentStepSize = size;
  equal_ = {numbers[0], numbers[1], numbers[2], static_cast<StepCount>(numbers[3])};
  since_rejection_ = static_cast<StepCount>(numbers[4]);
  above_tolerance_ = static_cast<int>(numbers[5]);
}

std::array<double, StepController::restart_size> StepController::restart_numbers() const {
  return {equal_.start,
          equal_.size,
          equal_.time,
          static_cast<double>(equal_.before),
          static_cast<double>(since_rejection_),
          static_cast<double>(above_tolerance_)};
}

// The first attempt of a step gets the remaining size; other attempts keep the size that was chosen for them.
double StepController::prescribed_end() {
  const double now = it_.currentTime,
               round_off = 8 * std::numeric_limits<double>::epsilon() * std::max(std::abs(now), std::abs(ends_.back()));
  const auto next = std::ranges::upper_bound(ends_, now + round_off);
  const double end = next == ends_.end() ? it_.endTime : *next;
  if (std::exchange(prescribed_step_, it_.currentStepIndex) != it_.currentStepIndex) it_.currentStepSize = end - now;
  return it_.currentStepSize == end - now ? end : now + it_.currentStepSize;
}

double StepController::end_of_step() {
  if (!ends_.empty()) [[unlikely]]
    return prescribed_end();
  double& h = it_.currentStepSize;
  if (h != equal_.size || it_.currentTime != equal_.time) [[unlikely]] {
    equal_ = {.start = it_.currentTime, .size = h, .before = it_.currentStepIndex - 1};
  }
  double time = static_cast<double>(it_.currentStepIndex - equal_.before) * h + equal_.start;
  const double round_off =
      8 * std::numeric_limits<double>::epsilon() * std::max(std::abs(it_.startTime), std::abs(it_.endTime));
  if (const double beyond = time - it_.endTime; beyond > -round_off) [[unlikely]] {
    if (beyond > round_off) h = it_.endTime - it_.currentTime;
    time = it_.endTime;
  }
  return equal_.time = time;
}

void StepController::reject(double failed, double factor) {
  const double recommended = it_.recommendedStepSize;
  const double next =
      recommended != -1 ? std::min(0.75 * failed, recommended) : std::min(it_.currentStepSize, factor * failed);
  it_.currentStepSize = std::max(it_.minStepSize, next);
}

void StepController::repeat_by_error() {
  ++it_.rejectedAutomaticStepSizeSteps;
  rejected_by_error_ = true;
}

void StepController::shrink_by_error(double factor) {
  repeat_by_error();
  it_.currentStepSize = std::max(it_.minStepSize, it_.currentStepSize * factor);
}

void StepController::reject_by_error(double wanted) {
  shrink_by_error(std::isfinite(wanted) ? std::clamp(wanted, smallest_factor, 1.0) : smallest_factor);
}

void StepController::accept(double wanted) {
  const double h = it_.currentStepSize, factor = std::clamp(wanted, smallest_factor, factors_.largest_increase);
  const double next = std::clamp(factor > 1 && factor < not_worth_it ? h : h * factor, it_.minStepSize,
                                 std::max(it_.minStepSize, it_.maxStepSize));
  const double rest = it_.endTime - it_.currentTime;
  it_.currentStepSize = next < rest && rest < last_stretch * next ? rest : next;
}

void StepController::propose(double size) {
  const double largest = std::min(it_.maxStepSize, it_.currentStepSize * factors_.largest_increase);
  it_.currentStepSize = std::min(largest, std::max(it_.minStepSize, size));
}

void StepController::recover() {
  it_.currentStepSize = std::min(it_.maxStepSize, factors_.increase * it_.currentStepSize);
}

bool StepController::is_recovered() {
  ++since_rejection_;
  const bool easy = it_.newtonSteps + it_.discontinuousIteration <= factors_.recovery_iterations;
  if (since_rejection_ < factors_.recovery_steps || !easy) return false;
  since_rejection_ = 0;
  return true;
}

void StepController::count_accepted(double size) {
  it_.smallestStepSize = it_.largestStepSize == 0 ? size : std::min(it_.smallestStepSize, size);
  it_.largestStepSize = std::max(it_.largestStepSize, size);
  if (size >= it_.maxStepSize) ++it_.stepsAtMaximumStepSize;
}

bool StepController::hold_above_tolerance() {
  if (++above_tolerance_ > most_above_tolerance) return false;
  ++it_.stepsAboveTolerance;
  return true;
}

}  // namespace dalembert
