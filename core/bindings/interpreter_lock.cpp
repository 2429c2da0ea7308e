#include "interpreter_lock.hpp"

#include <utility>

namespace dalembert {
namespace {

thread_local WithoutInterpreter* innermost = nullptr;

// Twice the time after which a waiting Python thread demands the lock, sys.getswitchinterval().
constexpr std::chrono::milliseconds turn{10};

}  // namespace

WithoutInterpreter::WithoutInterpreter() : outer_(std::exchange(innermost, this)) { give(); }

WithoutInterpreter::~WithoutInterpreter() {
  if (state_ != nullptr) take();
  innermost = outer_;
}

void WithoutInterpreter::look() {
  if (innermost == nullptr) return;
  WithoutInterpreter& scope = *innermost;
  const auto now = Clock::now();
  scope.keeps_ = now - std::exchange(scope.last_look_, now) < turn;
  if (scope.state_ == nullptr && now - scope.last_turn_ >= turn) {
    scope.give();
    scope.last_turn_ = now;
  }
}

bool WithoutInterpreter::is_kept() { return innermost != nullptr && innermost->state_ == nullptr; }

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
