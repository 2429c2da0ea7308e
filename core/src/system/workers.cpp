#include "dalembert/system/workers.hpp"

#include <utility>

namespace dalembert {
namespace {

constexpr std::uint64_t task_bits = 16, task_mask = (std::uint64_t{1} << task_bits) - 1;
std::uint64_t next_task(std::uint64_t round) { return round & task_mask; }
std::uint64_t task_count(std::uint64_t round) { return (round >> task_bits) & task_mask; }

// Looks at the clock of a waiting thread: some ten microseconds, several times what goes on between two rounds.
constexpr int looks_before_sleep = 4000;

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

Workers::Workers(int threads) {
  for (int i = 1; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

Workers::~Workers() {
  stop_ = true;
  round_.fetch_add(std::uint64_t{1} << (2 * task_bits));  // a round without tasks: nobody takes one after the last
  round_.notify_all();
}

// The acquisition of a task orders it after what the round began with, its end before the end of the round.
bool Workers::take(int& task) {
  std::uint64_t round = round_.load(std::memory_order_acquire);
  while (next_task(round) < task_count(round)) {
    if (!round_.compare_exchange_weak(round, round + 1, std::memory_order_acq_rel)) continue;
    task = static_cast<int>(next_task(round));
    return true;
  }
  return false;
}

void Workers::perform(int task) {
  try {
    call_(task_, task);
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    if (!error_ || task < failed_) {
      failed_ = task;
      error_ = std::current_exception();
    }
  }
  done_.fetch_add(1, std::memory_order_release);
}

void Workers::run_all(int tasks) {
  done_.store(0, std::memory_order_relaxed);
  const std::uint64_t number = (round_.load(std::memory_order_relaxed) >> (2 * task_bits)) + 1;
  round_.store((number << (2 * task_bits)) | (static_cast<std::uint64_t>(tasks) << task_bits), std::memory_order_release);
  round_.notify_all();
  for (int task = 0; take(task);) perform(task);
  while (done_.load(std::memory_order_acquire) < tasks) pause();
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void Workers::work() {
  int looks = 0;
  while (!stop_.load(std::memory_order_relaxed)) {
    const std::uint64_t seen = round_.load(std::memory_order_acquire);
    if (int task = 0; take(task)) {
      perform(task);
      looks = 0;
    } else if (++looks < looks_before_sleep) {
      pause();
    } else {
      round_.wait(seen, std::memory_order_acquire);
      looks = 0;
    }
  }
}

}  // namespace dalembert
