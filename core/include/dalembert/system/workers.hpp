// Threads that wait for tasks and share them: tens of thousands of times per second, so they watch out for a while before
// they go to sleep.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <type_traits>
#include <vector>

namespace dalembert {

class Workers {
 public:
  // Total number of threads, including the calling one.
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int count() const { return static_cast<int>(threads_.size()) + 1; }

  // Calls task(i) for all i from 0 to tasks - 1 (at most 65535), on any thread, and returns after the last one. Each
  // thread starts with the same tasks every time, whose data may still be in its cache, and then helps the other
  // ones. Rethrows the exception of the first failing task.
  template <class Task>
  void run(int tasks, Task&& task) {
    call_ = [](void* task, int i) { (*static_cast<std::remove_reference_t<Task>*>(task))(i); };
    task_ = &task;
    run_all(tasks);
  }
  // Calls f(begin, end) for one stretch per thread; they make up [0, count).
  template <class F>
  void each_stretch(std::size_t count, const F& f) {
    const auto stretches = static_cast<std::size_t>(this->count());
    run(this->count(), [&](int i) {
      const auto number = static_cast<std::size_t>(i);
      f(count * number / stretches, count * (number + 1) / stretches);
    });
  }

 private:
  // The tasks with which one thread starts: the round, the next task and the end, in one number, so that a task is
  // taken in its round. In a cache line of its own.
  struct alignas(64) Part {
    std::atomic<std::uint64_t> tasks{0};
  };

  void run_all(int tasks);
  void work(std::size_t thread);
  bool take(std::size_t thread, int& task);
  void perform(int task);

  std::vector<Part> parts_;  // one per thread, the calling one last
  std::atomic<std::uint32_t> round_{0};
  std::atomic<int> done_{0};
  std::atomic<bool> stop_{false};
  void (*call_)(void*, int) = nullptr;
  void* task_ = nullptr;
  std::mutex mutex_;  // guards the following members
  int failed_ = 0;  // the first task that has failed, if there is an error
  std::exception_ptr error_;
  std::vector<std::jthread> threads_;
};

}  // namespace dalembert
