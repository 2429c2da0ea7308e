#include "dalembert/system/workers.hpp"

#include <chrono>
#include <utility>

namespace dalembert {
namespace {

constexpr std::uint64_t task_bits = 16, task_mask = (std::uint64_t{1} << task_bits) - 1;
std::uint64_t next_task(std::uint64_t part) { return part & task_mask; }
std::uint64_t end_of_tasks(std::uint64_t part) { return (part >> task_bits) & task_mask; }

// Waking a sleeping thread takes at least a tenth of a millisecond, as long as ten thousand items. Threads therefore
// stay awake between two rounds, like those of OpenMP runtimes.
constexpr std::chrono::milliseconds time_before_sleep{100};
constexpr int looks_between_times = 100;

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

Workers::Workers(int threads) : parts_(static_cast<std::size_t>(threads)) {
  for (std::size_t i = 0; i + 1 < parts_.size(); ++i) threads_.emplace_back([this, i] { work(i); });
}

Workers::~Workers() {
  stop_ = true;
  ++round_;  // without tasks: no thread takes one after the last
  round_.notify_all();
}

// Acquiring a task orders it after the start of the round, its end before the end of the round.
bool Workers::take(std::size_t thread, int& task) {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    auto& tasks = parts_[(thread + i) % parts_.size()].tasks;
    std::uint64_t part = tasks.load(std::memory_order_acquire);
    while (next_task(part) < end_of_tasks(part)) {
      if (!tasks.compare_exchange_weak(part, part + 1, std::memory_order_acq_rel)) continue;
      task = static_cast<int>(next_task(part));
      return true;
    }
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
  const std::uint32_t round = round_.load(std::memory_order_relaxed) + 1;
  const std::uint64_t count = static_cast<std::uint64_t>(tasks), parts = parts_.size();
  for (std::uint64_t i = 0; i < parts; ++i) {
    const std::uint64_t begin = count * i / parts, end = count * (i + 1) / parts;
    parts_[i].tasks.store((std::uint64_t{round} << (2 * task_bits)) | (end << task_bits) | begin,
                          std::memory_order_release);
  }
  round_.store(round, std::memory_order_release);
  round_.notify_all();
  for (int task = 0; take(parts_.size() - 1, task);) perform(task);
  while (done_.load(std::memory_order_acquire) < tasks) pause();
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void Workers::work(std::size_t thread) {
  using Clock = std::chrono::steady_clock;
  Clock::time_point idle_since = Clock::now();
  while (!stop_.load(std::memory_order_relaxed)) {
    const std::uint32_t seen = round_.load(std::memory_order_acquire);
    bool has_worked = false;
    for (int task = 0; take(thread, task); has_worked = true) perform(task);
    const Clock::time_point now = Clock::now();
    if (has_worked) idle_since = now;
    if (now - idle_since > time_before_sleep) {
      round_.wait(seen, std::memory_order_acquire);
      idle_since = Clock::now();
    }
    for (int look = 0; look < looks_between_times && round_.load(std::memory_order_relaxed) == seen; ++look) pause();
  }
}

}  // namespace dalembert
