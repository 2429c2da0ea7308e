#include "interpreter_lock.hpp"

#include <utility>

namespace dalembert {
namespace {

thread_local WithoutInterpreter* innermost = nullptr;

// The time after which Python threads take turns, sys.getswitchinterval().
constexpr std::chrono::milliseconds turn{5};

}  // namespace

WithoutInterpreter::WithoutInterpreter() : outer_(std::exchange(innermost, this)) { give(); }

WithoutInterpreter::~WithoutInterpreter() {
  if (state_ != nullptr) take();
  innermost = outer_;
}

void WithoutInterpreter::look() {
  if (innermost == nullptr) return;
  const auto now = Clock::now();
  innermost->keeps_ = now - std::exchange(innermost->last_look_, now) < turn;
  if (innermost->state_ == nullptr) innermost->give();
}

InterpreterLock::InterpreterLock(Afterwards afterwards) : scope_(innermost) {
  if (scope_ == nullptr) {
    state_ = PyGILState_Ensure();
  } else if (scope_->state_ != nullptr) {
    scope_->take();
    give_ = !scope_->keeps_ || afterwards == Afterwards::free;
  }
}

InterpreterLock::~InterpreterLock() {
  if (scope_ == nullptr) {
    PyGILState_Release(state_);
  } else if (give_) {
    scope_->give();
  }
}

}  // namespace dalembert
