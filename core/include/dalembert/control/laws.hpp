// Laws of controllers: forces from time, coordinates and velocities, all of one object, and the motion that it is to follow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "dalembert/trees/tree.hpp"

namespace dalembert {

// Coordinates with velocities and accelerations, as pieces of cubic polynomials in time or as a C function.
class DesiredMotion {
 public:
  using Function = void (*)(double time, std::int64_t count, double* q, double* v, double* a);
  // There is one more time than pieces. Each piece and coordinate has four coefficients, lowest power first, of the
  // time since its start. The rows of `ends` hold before and after: coordinates, velocities, accelerations before,
  // and the same after.
  DesiredMotion(std::size_t count, std::vector<double> times, std::vector<double> coefficients,
                std::vector<double> ends);
  DesiredMotion(std::size_t count, Function function) : count_(count), function_(function) {}

  std::size_t count() const { return count_; }
  void evaluate(double time, double* q, double* v, double* a) const;

 private:
  std::size_t count_;
  std::vector<double> times_, coefficients_, ends_;
  Function function_ = nullptr;
};

class ControlLaw {
 public:
  virtual ~ControlLaw() = default;
  virtual std::size_t count() const = 0;  // of coordinates; 0: any
  // Coordinates include reference values. Called from several threads.
  virtual void forces(double time, int item, std::span<const double> q, std::span<const double> v,
                      std::span<double> f) const = 0;
};

// Gains of coordinate and velocity errors, per coordinate.
struct Gains {
  std::vector<double> stiffness, damping;  // one number per coordinate
};

// f = f0 + P (q_d - q) + D (v_d - v)
class ProportionalDerivative final : public ControlLaw {
 public:
  ProportionalDerivative(std::shared_ptr<const DesiredMotion> desired, Gains gains, std::vector<double> feed_forward)
      : desired_(std::move(desired)), gains_(std::move(gains)), feed_forward_(std::move(feed_forward)) {}
  std::size_t count() const override { return desired_->count(); }
  void forces(double time, int item, std::span<const double> q, std::span<const double> v,
              std::span<double> f) const override;

 private:
  std::shared_ptr<const DesiredMotion> desired_;
  Gains gains_;
  std::vector<double> feed_forward_;
};

// Forces that the accelerations a_d + D (v_d - v) + P (q_d - q) need in a tree (J. Y. S. Luh, M. W. Walker, R. P. C. Paul, 1980).
class ComputedTorque final : public ControlLaw {
 public:
  ComputedTorque(Tree tree, const Vec3<double>& gravity, std::shared_ptr<const DesiredMotion> desired, Gains gains)
      : tree_(std::move(tree)), gravity_(gravity), desired_(std::move(desired)), gains_(std::move(gains)) {}
  std::size_t count() const override { return desired_->count(); }
  void forces(double time, int item, std::span<const double> q, std::span<const double> v,
              std::span<double> f) const override;

 private:
  Tree tree_;
  Vec3<double> gravity_;
  std::shared_ptr<const DesiredMotion> desired_;
  Gains gains_;
};

// A C function of the user, with the arguments of a forceUserFunction.
class CompiledLaw final : public ControlLaw {
 public:
  using Function = void (*)(double time, std::int64_t item, const double* q, std::int64_t, const double* v,
                            std::int64_t, double* f, std::int64_t);
  explicit CompiledLaw(Function function) : function_(function) {}
  std::size_t count() const override { return 0; }
  void forces(double time, int item, std::span<const double> q, std::span<const double> v,
              std::span<double> f) const override;

 private:
  Function function_;
};

// Samples at equal intervals, beginning with the start of a solution; the output of the law acts after the dead time,
// until the next output.
class SampledForces {
 public:
  SampledForces(double period, double dead_time) : period_(period), dead_time_(dead_time) {}

  void begin(double time, std::size_t count);
  bool begun() const { return begun_; }
  std::span<const double> held() const { return held_; }
  // When it measures or acts next.
  double next() const;
  // Performs due actions by `law(forces)`. Returns whether the forces change at this time.
  template <class Law>
  bool act(double time, const Law& law) {
    if (time > next_sample() - same_time()) {
      waiting_.emplace_back(held_.size());
      law(std::span<double>(waiting_.back()));
      ++samples_;
    }
    return release(time);
  }

  // All that is known, for a restart file.
  std::vector<double> numbers() const;
  void take_numbers(std::span<const double> numbers);

 private:
  double same_time() const { return 1e-9 * period_; }
  double next_sample() const { return start_ + samples_ * period_; }
  double next_release() const {
    return start_ + (samples_ - static_cast<double>(waiting_.size())) * period_ + dead_time_;
  }
  bool release(double time);

  double period_, dead_time_;
  bool begun_ = false;
  double start_ = 0, samples_ = 0;
  std::vector<double> held_;
  std::vector<std::vector<double>> waiting_;  // oldest first
};

}  // namespace dalembert
