// The lock of the Python interpreter (GIL): free while compiled code works, held while a user function runs.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>

namespace dalembert {

// Scope in which a thread runs without Python. InterpreterLock takes the lock (GIL) during a user function. Taking
// and releasing the lock costs more than a small user function. The lock may therefore stay with this thread between
// two of them, as long as look() is called every few milliseconds. Other threads run there and, as in any Python
// program, inside functions. A lock that is released and taken again at once is not noticed by waiting threads. It is
// therefore kept for longer than Python's switch interval, and releasing it waits until another thread has taken it.
// The constructor needs the lock.
class WithoutInterpreter {
 public:
  WithoutInterpreter();
  ~WithoutInterpreter();
  WithoutInterpreter(const WithoutInterpreter&) = delete;
  WithoutInterpreter& operator=(const WithoutInterpreter&) = delete;

  // Gives the lock to threads that have waited for it, and keeps it from now on if the last look was not long ago.
  static void look();
  // Whether the thread that asks has the lock at the moment.
  static bool is_kept();

 private:
  friend class InterpreterLock;
  using Clock = std::chrono::steady_clock;

  void give() { state_ = PyEval_SaveThread(); }
  void take() {
    PyEval_RestoreThread(state_);
    state_ = nullptr;
  }

  WithoutInterpreter* outer_;  // scope of a solver whose user function runs this one
  PyThreadState* state_ = nullptr;  // null: the lock is held
  bool keeps_ = false;
  Clock::time_point last_look_ = Clock::now();
  Clock::time_point last_turn_ = last_look_;  // last time that other threads could run
};

// While one lives, Python may be used.
class InterpreterLock {
 public:
  enum class Afterwards { free, may_be_kept };
  explicit InterpreterLock(Afterwards afterwards = Afterwards::free);
  ~InterpreterLock();
  InterpreterLock(const InterpreterLock&) = delete;
  InterpreterLock& operator=(const InterpreterLock&) = delete;

 private:
  WithoutInterpreter* scope_;    // null: not inside of one
  bool give_ = false;  // whether the lock goes back to the scope
  PyGILState_STATE state_{};  // used if there is no scope
};

}  // namespace dalembert
