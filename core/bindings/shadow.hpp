// A copy of a system in which viewers evaluate outputs, independently of solvers that use the system.
#pragma once

#include <memory>

#include "main_system.hpp"
#include "record_watch.hpp"

namespace dalembert {

// All of it needs the lock of the interpreter.
class Shadow {
 public:
  explicit Shadow(const std::shared_ptr<MainSystem>& original);

  // Changes since the last call. The state of a running solver is requested, and arrives with a later call.
  struct News {
    bool state = false, items = false, structure = false;
  };
  News follow(Tap::Part wanted);
  // Whether the state is known, not only where items are.
  bool complete() const { return is_complete_; }
  const std::shared_ptr<MainSystem>& system() const { return system_; }
  // Grips the point of an object that is nearest to `point`, in the state that is shown. Pulls reach a running solver.
  void grab(int object, const Vec3<double>& point, int link);
  void pull(const Vec3<double>& target, double strength);
  void release();
  std::optional<Vec3<double>> gripped() const;
  // Calls f if the original still exists.
  template <class F>
  void tell(F&& f) {
    if (const auto original = original_.lock()) f(*original);
  }

 private:
  bool renew_items(const MainSystem& original);
  void copy_items(const MainSystem& original);
  bool follow_state(MainSystem& original, Tap::Part wanted);
  static std::uint64_t contacts_of(const MainSystem& original);

  const std::weak_ptr<MainSystem> original_;
  const std::shared_ptr<MainSystem> system_ = std::make_shared<MainSystem>();
  RecordWatch watch_;  // watches the original
  std::uint64_t structure_ = ~std::uint64_t{0}, version_ = 0, contacts_ = 0;
  bool assembled_ = false, is_complete_ = true;
  std::optional<Grip> grip_;
};

void register_shadow(py::module_& module);

}  // namespace dalembert
