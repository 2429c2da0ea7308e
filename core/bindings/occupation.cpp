#include "occupation.hpp"

#include "dalembert/model/errors.hpp"
#include "main_system.hpp"
#include "solver_wrapper.hpp"

namespace dalembert {
namespace {

// Who uses the system, and where the call comes from.
std::string users_of(const MainSystem& main) {
  std::string text = main.work != nullptr ? main.work->text() : "its items are being evaluated";
  if (const auto* here = RunningFunction::here(main)) return text + ", and this call comes from " + here->text();
  if (main.work != nullptr && main.work->here()) return text + ", and this call comes from a function that it calls";
  if (const auto* elsewhere = RunningFunction::elsewhere(main)) text += ", at the moment in " + elsewhere->text();
  return text + ", in another thread";
}

[[noreturn]] void refuse_busy(const MainSystem& main, const Label& call, const std::string& advice) {
  refuse(ErrorKind::state,
         {.item = call.text(), .problem = "the system is in use: " + users_of(main), .advice = advice});
}

}  // namespace

template <class Wanted>
const RunningFunction* RunningFunction::innermost(const MainSystem& main, Wanted&& wanted) {
  const auto owner = main.weak_from_this();
  for (const RunningFunction* f = last_; f != nullptr; f = f->before_) {
    if (!f->main_.owner_before(owner) && !owner.owner_before(f->main_) && wanted(*f)) return f;
  }
  return nullptr;
}

const RunningFunction* RunningFunction::here(const MainSystem& main) {
  return innermost(main, [me = std::this_thread::get_id()](const RunningFunction& f) { return f.thread_ == me; });
}

const RunningFunction* RunningFunction::elsewhere(const MainSystem& main) {
  return innermost(main, [me = std::this_thread::get_id()](const RunningFunction& f) { return f.thread_ != me; });
}

bool RunningFunction::in_evaluation_here(const MainSystem& main) {
  if (!any()) return false;
  return innermost(main, [me = std::this_thread::get_id()](const RunningFunction& f) {
           return f.thread_ == me && f.place_ == Place::in_evaluation;
         }) != nullptr;
}

Work::Work(const std::shared_ptr<MainSystem>& main, SolverWrapper& solver, const char* method, Extent extent)
    : main_(main), solver_(solver), method_(method), outer_(solver.work) {
  const auto call = [method] { return std::string("solver.") + method + "(mbs, ...)"; };
  if (!main)
    refuse(ErrorKind::type,
           {.item = call(), .parameter = "mainSystem", .received = "None", .expected = "a MainSystem"});
  if (outer_ != nullptr && (!outer_->of(*main) || !outer_->here())) {
    refuse(ErrorKind::state, {.item = call(),
                              .problem = "the solver is at work on another system, or in another thread",
                              .advice = "Make a solver object of its own for each solution."});
  }
  const bool running_part = outer_ != nullptr && extent == Extent::part && !RunningFunction::in_evaluation_here(*main);
  if (!running_part) require_idle(*main, call);
  main->work = solver.work = this;
}

Work::~Work() {
  main_->work = solver_.work = outer_;
  if (outer_ != nullptr) return;
  main_->tap.pull({});
  main_->tap.take_pull([this](const std::optional<Pull>& none) { main_->system.pull(none); });
}

std::string Work::text() const { return "it is being solved (" + solver_.solver().name() + ", " + method_ + ")"; }

void require_idle(const MainSystem& main, const Label& call) {
  if (main.work == nullptr && !RunningFunction::any()) return;
  if (main.work == nullptr && RunningFunction::here(main) == nullptr && RunningFunction::elsewhere(main) == nullptr)
    return;
  refuse_busy(
      main, call,
      "Call it before or after. Meanwhile user functions may set parameters of items and coordinates, and change and "
      "solve a copy made by copy.copy(mbs).");
}

void require_own_thread(const MainSystem& main, const Label& call) {
  const bool solved_elsewhere = main.work != nullptr && !main.work->here();
  if (!solved_elsewhere && (!RunningFunction::any() || RunningFunction::elsewhere(main) == nullptr)) return;
  refuse_busy(
      main, call,
      "Leave it to a user function, e.g. that of mbs.SetPreStepUserFunction(...). Other threads may read items, the "
      "sizes and numbers of coordinates, and coordinates of ConfigurationType.Visualization, which are renewed every "
      "few "
      "milliseconds.");
}

}  // namespace dalembert
