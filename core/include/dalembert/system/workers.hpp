// Threads that wait for tasks and share them: tens of thousands of times per second, so they watch out for a while before
// they go to sleep.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <type_traits>
#include <vector>

namespace dalembert {

class Workers {
 public:
  // So many threads in all, the calling one among them.
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int count() const { return static_cast<int>(threads_.size()) + 1; }

  // Calls task(i) for all i from 0 to tasks - 1 (at most 65535), in any order and on any thread, and returns when all are
  // done. What the first of them that fails throws is thrown here.
  template <class Task>
  void run(int tasks, Task&& task) {
    call_ = [](void* task, int i) { (*static_cast<std::remove_reference_t<Task>*>(task))(i); };
    task_ = &task;
    run_all(tasks);
  }

 private:
  void run_all(int tasks);
  void work();
  bool take(int& task);
  void perform(int task);

  // The round, how many tasks it has and which is next, in one number: a task is taken in the round that it belongs to.
  std::atomic<std::uint64_t> round_{0};
  std::atomic<int> done_{0};
  std::atomic<bool> stop_{false};
  void (*call_)(void*, int) = nullptr;
  void* task_ = nullptr;
  std::mutex mutex_;  // of what follows
  int failed_ = 0;    // the first task that has failed, if there is an error
  std::exception_ptr error_;
  std::vector<std::jthread> threads_;
};

}  // namespace dalembert
