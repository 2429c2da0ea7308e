// Fused steps of methods with one stage: one pass over memory after the forces, because memory limits the speed of
// large systems.
#include <array>
#include <cstddef>
#include <utility>

#include "dalembert/math/pack.hpp"
#include "dalembert/solvers/explicit.hpp"
#include "dalembert/system/large_vectors.hpp"

namespace dalembert {
namespace {

struct Motion {
  const double *negative_force, *factor;  // factors of the forces
  const double *start_q, *start_v;
  double *q, *v, *a;
  double step;
};

// Sums of squares in the order of math/sum_of_squares.hpp.
struct Squares {
  double of_v = 0, of_a = 0;
};

// Updates from the start of the step. Positions that are not updated by sums remain.
template <bool drifts>
Squares move(const Motion& motion, std::size_t begin, std::size_t end) {
  using P = Pack<4>;
  constexpr std::size_t wide = 8;
  std::array<double, wide> of_v{}, of_a{};
  const std::size_t whole = begin + (end - begin) / wide * wide;
  in_registers_of_four([m = motion, begin, whole, to_v = of_v.data(), to_a = of_a.data()] {
    P sum_v[2], sum_a[2];
    for (std::size_t i = begin; i < whole; i += wide)
      for (std::size_t half = 0; half < 2; ++half) {
        const std::size_t k = i + 4 * half;
        const P v = P::load(m.start_v + k), a = -P::load(m.negative_force + k) * P::load(m.factor + k);
        if constexpr (drifts) (P::load(m.start_q + k) + m.step * v).store(m.q + k);
        const P next = v + m.step * a;
        next.store(m.v + k);
        a.store(m.a + k);
        sum_v[half] += next * next;
        sum_a[half] += a * a;
      }
    for (std::size_t half = 0; half < 2; ++half) {
      sum_v[half].store(to_v + 4 * half);
      sum_a[half].store(to_a + 4 * half);
    }
  });
  for (std::size_t i = whole; i < end; ++i) {
    const double v = motion.start_v[i], a = -motion.negative_force[i] * motion.factor[i];
    if constexpr (drifts) motion.q[i] = motion.start_q[i] + motion.step * v;
    motion.v[i] = v + motion.step * a;
    motion.a[i] = a;
    of_v[i - whole] += motion.v[i] * motion.v[i];
    of_a[i - whole] += a * a;
  }
  const auto total = [](const std::array<double, wide>& s) {
    return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
  };
  return {total(of_v), total(of_a)};
}

// Divides the work into parts that do not depend on the number of threads.
template <bool drifts>
Squares move_all(const System& system, const Motion& motion, std::size_t count) {
  if (count < numbers_to_share) return move<drifts>(motion, 0, count);
  constexpr std::size_t parts = 64;
  std::array<Squares, parts> squares;
  each_stretch(system, parts, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      squares[i] = move<drifts>(motion, count * i / parts, count * (i + 1) / parts);
  });
  Squares sum;
  for (const Squares& part : squares) {
    sum.of_v += part.of_v;
    sum.of_a += part.of_a;
  }
  return sum;
}

}  // namespace

void ExplicitSolver::keep_motion() {
  const State& now = current();
  State& start = start_of_step();
  for (const auto part : {&State::q, &State::v, &State::a})
    copy_numbers(system(), (now.*part).data(), (now.*part).size(), (start.*part).data());
}

void ExplicitSolver::step_at_once() {
  State& now = current();
  now.time = start_of_step().time;
  std::span<const double> negative;
  try {
    const TimedPart time(timer, timer.ODE2RHS);
    negative = system().negative_forces(now, conditions_);
  } catch (...) {
    keep_motion();
    throw;
  }
  if (!masses_are_old())
    move_by_forces(negative);
  else if (!move_by_masses(negative))
    return;
  now.time = it.currentTime;
}

// The current state becomes the start: vectors are swapped, unless other objects refer to them.
void ExplicitSolver::move_by_forces(std::span<const double> negative) {
  const TimedPart time(timer, timer.newtonIncrement);
  State &now = current(), &start = start_of_step();
  const bool held = system().hold_states().use_count() > 2;  // by other objects than the system and this line
  if (held)
    keep_motion();
  else
    for (const auto part : {&State::q, &State::v, &State::a}) std::swap(now.*part, start.*part);
  const Motion motion{negative.data(), mass_.factors(), start.q.data(), start.v.data(),
                      now.q.data(),    now.v.data(),    now.a.data(),   it.currentStepSize};
  const Squares squares =
      all_on_group_ ? move_all<false>(system(), motion, now.v.size()) : move_all<true>(system(), motion, now.v.size());
  sum_of_v_ = squares.of_v;
  sum_of_a_ = squares.of_a;
  sums_known_ = true;
  if (!lie_) return;
  const WeightedVector change{it.currentStepSize, start.v.data()};
  system().compose(start.q, std::span(&change, 1), now.q);
}

// Uses masses that have just changed. Returns false if forces do not determine accelerations.
bool ExplicitSolver::move_by_masses(std::span<const double> negative) {
  State& now = current();
  keep_motion();
  Vector& a = stage_v_.front();
  each_number(system(), a.size(), [to = a.data(), from = negative.data()](std::size_t i) { to[i] = -from[i]; });
  if (!divide_by_masses(a)) return false;
  move_from_start(result_, now.q, now.v, now.y);
  copy_numbers(system(), a.data(), a.size(), now.a.data());
  return true;
}

}  // namespace dalembert
