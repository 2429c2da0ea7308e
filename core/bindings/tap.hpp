// Between a solver and viewers: the state that they see, a copy made on request between two steps; and where they pull.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>

#include "dalembert/solvers/data.hpp"
#include "dalembert/system/pull.hpp"
#include "dalembert/system/state.hpp"

namespace dalembert {

class Tap {
 public:
  // The part of a state that viewers need. Positions follow from time, coordinates and data, which are a third of the
  // state in systems of bodies.
  enum class Part : std::uint8_t { none, places, all };

  // ---- the solver's thread, which waits neither for a viewer nor for Python ---------------------------------------------
  // `look(copy)`: a copy with multipliers.
  template <class Look>
  void offer(const State& current, Look&& look) {
    const Part wanted = wanted_.load(std::memory_order_relaxed);
    if (wanted == Part::none) return;
    const double begin = SolverTimer::now();
    if (next_ == 0) next_ = begin + rarity * expected_time(current);
    if (begin < next_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock) return;
    if (wanted == Part::all)
      look([&] { copy_ = current; });
    else
      copy_.time = current.time, copy_.q = current.q, copy_.y = current.y, copy_.data = current.data;
    part_ = wanted;
    wanted_.store(Part::none, std::memory_order_relaxed);
    const double end = SolverTimer::now();
    filled_ = end;
    next_ = end + rarity * (end - begin);
  }
  // Calls f(pull) if a viewer has changed it.
  template <class F>
  void take_pull(F&& f) {
    if (!pulls_anew_.load(std::memory_order_relaxed)) return;
    const std::lock_guard lock(pull_mutex_);
    pulls_anew_.store(false, std::memory_order_relaxed);
    f(pull_);
  }
  bool paused() const { return paused_.load(std::memory_order_relaxed); }
  bool asks() const { return asks_.load(std::memory_order_relaxed); }

  // ---- a viewer's thread ------------------------------------------------------------------------------------------------
  void want(Part part) { wanted_.store(part, std::memory_order_relaxed); }
  // Returns the available part; none if there is no new state. A state that is older than the last picture took is
  // skipped once, because a newer one is about to come.
  Part take(State& target) {
    const std::lock_guard lock(mutex_);
    if (filled_ == 0) return Part::none;
    const bool is_old = !has_left_ && SolverTimer::now() - filled_ > old;
    filled_ = 0;
    has_left_ = is_old;
    if (is_old) {
      want(part_);
      return Part::none;
    }
    const bool fits = copy_.q.size() == target.q.size() && copy_.y.size() == target.y.size() &&
                      copy_.data.size() == target.data.size() &&
                      (part_ != Part::all || copy_.lambda.size() == target.lambda.size());
    if (!fits) return Part::none;  // left from before the system was assembled anew
    if (part_ == Part::all)
      std::swap(target, copy_);
    else
      target.time = copy_.time, target.q.swap(copy_.q), target.y.swap(copy_.y), target.data.swap(copy_.data);
    return part_;
  }
  void pause(bool flag) { paused_.store(flag, std::memory_order_relaxed); }
  // Empty: no more.
  void pull(const std::optional<Pull>& pull) {
    const std::lock_guard lock(pull_mutex_);
    pull_ = pull;
    pulls_anew_.store(true, std::memory_order_relaxed);
  }
  // Requests that the solver's thread performs viewer requests between two steps.
  void ask(bool flag) { asks_.store(flag, std::memory_order_relaxed); }

 private:
  static constexpr double old = 0.05;  // s: more than the interval between pictures
  static constexpr double rarity =
      110;  // copies take less than a hundredth of the solver's time, the first one included

  // Expected time of the first copy, which allocates new memory.
  static double expected_time(const State& s) {
    std::size_t numbers = 0;
    for (const auto* part : {&s.q, &s.v, &s.a, &s.y, &s.y_t, &s.lambda, &s.data}) numbers += part->size();
    return static_cast<double>(numbers * sizeof(double)) / 2e9;
  }

  std::atomic<Part> wanted_ = Part::none;
  std::atomic<bool> paused_ = false, asks_ = false;
  std::atomic<bool> pulls_anew_ = false;
  std::mutex pull_mutex_;
  std::optional<Pull> pull_;
  std::mutex mutex_;
  State copy_;
  Part part_ = Part::none;  // the available part
  double filled_ = 0;  // when; 0: there is nothing to be taken
  bool has_left_ = false;
  double next_ = 0;  // used by the solver's thread
};

}  // namespace dalembert
