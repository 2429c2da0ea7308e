// Bookkeeping of the solver that uses a system and of the running user functions. It determines which calls are
// allowed. Guarded by the lock of the interpreter, which all functions here require.
#pragma once

#include <memory>
#include <string>
#include <thread>

#include "label.hpp"

namespace dalembert {

class MainSystem;
class SolverWrapper;

// A user function while it runs. User functions of items run during an evaluation, those of the system and of solvers
// between two evaluations.
class RunningFunction {
 public:
  enum class Place { in_evaluation, between_evaluations };
  // Builds the description for an error: "user function 'springForceUserFunction' of object 3 ...".
  using Words = std::string (*)(const void* function, int item);

  // `main` belongs to the function.
  RunningFunction(const std::weak_ptr<MainSystem>& main, Place place, Words words, const void* function, int item = -1)
      : main_(main), place_(place), words_(words), function_(function), item_(item), before_(last_) {
    if (before_ != nullptr) before_->after_ = this;
    last_ = this;
  }
  ~RunningFunction() {
    (after_ != nullptr ? after_->before_ : last_) = before_;
    if (before_ != nullptr) before_->after_ = after_;
  }
  RunningFunction(const RunningFunction&) = delete;
  RunningFunction& operator=(const RunningFunction&) = delete;

  static bool any() { return last_ != nullptr; }
  // The innermost running function of a system in this thread, or in other threads; null if there is none.
  static const RunningFunction* here(const MainSystem& main);
  static const RunningFunction* elsewhere(const MainSystem& main);
  static bool in_evaluation_here(const MainSystem& main);
  std::string text() const { return words_(function_, item_); }

 private:
  template <class Wanted>
  static const RunningFunction* innermost(const MainSystem& main, Wanted&& wanted);

  // Threads alternate: the function that starts last need not end first.
  static inline RunningFunction* last_ = nullptr;

  const std::weak_ptr<MainSystem>& main_;
  const Place place_;
  const Words words_;
  const void* const function_;
  const int item_;
  const std::thread::id thread_ = std::this_thread::get_id();
  RunningFunction* before_;
  RunningFunction* after_ = nullptr;
};

// A solver at work on a system, during one call of it.
class Work {
 public:
  // Parts of a solution may be called by functions of the solver that is running; a whole one may not.
  enum class Extent { whole, part };

  // Refused if the system or the solver is in use.
  Work(const std::shared_ptr<MainSystem>& main, SolverWrapper& solver, const char* method, Extent extent);
  ~Work();
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  bool here() const { return thread_ == std::this_thread::get_id(); }
  bool of(const MainSystem& main) const { return main_.get() == &main; }
  const SolverWrapper& solver() const { return solver_; }
  std::string text() const;  // "it is being solved (static solver, SolveSystem)"

 private:
  const std::shared_ptr<MainSystem> main_;
  SolverWrapper& solver_;
  const char* const method_;
  const std::thread::id thread_ = std::this_thread::get_id();
  const Work* const outer_;
};

// Refuse `call`, e.g. "mbs.Assemble(...)", if the system is in use, by whomever, or by another thread than this one.
void require_idle(const MainSystem& main, const Label& call);
void require_own_thread(const MainSystem& main, const Label& call);

}  // namespace dalembert
