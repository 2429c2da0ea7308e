#include "dalembert/control/laws.hpp"

#include <algorithm>
#include <limits>

#include "dalembert/math/aligned_vector.hpp"
#include "dalembert/trees/inverse_dynamics.hpp"

namespace dalembert {
namespace {

// Work space of the evaluating thread: laws are shared.
struct Room {
  std::vector<double> q, v, a;
  AlignedVector<LinkPlace<double>> places;
  AlignedVector<LinkMass<double>> masses;
  AlignedVector<LinkMotion<double>> motions;
  AlignedVector<LinkWrench<double>> wrenches;

  void make(std::size_t count) {
    q.resize(count);
    v.resize(count);
    a.resize(count);
  }
  void make_links(std::size_t count) {
    places.resize(count);
    masses.resize(count);
    motions.resize(count);
    wrenches.resize(count);
  }
};
Room& room_for(std::size_t count) {
  thread_local Room room;
  room.make(count);
  return room;
}

}  // namespace

// ---- motions ---------------------------------------------------------------------------------------------------------

DesiredMotion::DesiredMotion(std::size_t count, std::vector<double> times, std::vector<double> coefficients,
                             std::vector<double> ends)
    : count_(count), times_(std::move(times)), coefficients_(std::move(coefficients)), ends_(std::move(ends)) {}

void DesiredMotion::evaluate(double time, double* q, double* v, double* a) const {
  if (function_ != nullptr) return function_(time, static_cast<std::int64_t>(count_), q, v, a);
  if (times_.empty() || time < times_.front() || time > times_.back()) {
    const double* values = ends_.data() + (times_.empty() || time < times_.front() ? 0 : 3 * count_);
    std::copy_n(values, count_, q);
    std::copy_n(values + count_, count_, v);
    std::copy_n(values + 2 * count_, count_, a);
    return;
  }
  const auto after = std::upper_bound(times_.begin() + 1, times_.end() - 1, time);
  const auto piece = static_cast<std::size_t>(after - times_.begin()) - 1;
  const double t = time - times_[piece];
  const double* c = coefficients_.data() + 4 * count_ * piece;
  for (std::size_t i = 0; i < count_; ++i, c += 4) {
    q[i] = c[0] + t * (c[1] + t * (c[2] + t * c[3]));
    v[i] = c[1] + t * (2 * c[2] + t * 3 * c[3]);
    a[i] = 2 * c[2] + t * 6 * c[3];
  }
}

// ---- laws ------------------------------------------------------------------------------------------------------------

void ProportionalDerivative::forces(double time, int, std::span<const double> q, std::span<const double> v,
                                    std::span<double> f) const {
  Room& room = room_for(count());
  desired_->evaluate(time, room.q.data(), room.v.data(), room.a.data());
  for (std::size_t i = 0; i < f.size(); ++i)
    f[i] = feed_forward_[i] + gains_.stiffness[i] * (room.q[i] - q[i]) + gains_.damping[i] * (room.v[i] - v[i]);
}

void ComputedTorque::forces(double time, int, std::span<const double> q, std::span<const double> v,
                            std::span<double> f) const {
  Room& room = room_for(count());
  room.make_links(count());
  desired_->evaluate(time, room.q.data(), room.v.data(), room.a.data());
  for (std::size_t i = 0; i < f.size(); ++i)
    room.a[i] += gains_.stiffness[i] * (room.q[i] - q[i]) + gains_.damping[i] * (room.v[i] - v[i]);
  trees::place_links<double>(tree_, q.data(), room.places);
  trees::place_masses<double>(tree_, room.places, room.masses);
  trees::move_links<double>(tree_, room.places, v.data(), room.a.data(), -gravity_, room.motions);
  for (std::size_t i = 0; i < f.size(); ++i)
    room.wrenches[i] = trees::inertia_force(tree_.links[i], room.masses[i], room.motions[i]);
  trees::sum_to_base<double>(tree_, room.places, room.wrenches, [&](std::size_t i, double force) { f[i] = force; });
}

void CompiledLaw::forces(double time, int item, std::span<const double> q, std::span<const double> v,
                         std::span<double> f) const {
  function_(time, item, q.data(), std::ssize(q), v.data(), std::ssize(v), f.data(), std::ssize(f));
}

// ---- sampling --------------------------------------------------------------------------------------------------------

void SampledForces::begin(double time, std::size_t count) {
  begun_ = true;
  start_ = time;
  samples_ = 0;
  held_.assign(count, 0.0);
  waiting_.clear();
}

double SampledForces::next() const {
  return waiting_.empty() ? next_sample() : std::min(next_sample(), next_release());
}

bool SampledForces::release(double time) {
  bool changed = false;
  while (!waiting_.empty() && time > next_release() - same_time()) {
    changed = changed || held_ != waiting_.front();
    held_.swap(waiting_.front());
    waiting_.erase(waiting_.begin());
  }
  return changed;
}

std::vector<double> SampledForces::numbers() const {
  std::vector<double> numbers{start_, samples_, static_cast<double>(held_.size()),
                              static_cast<double>(waiting_.size())};
  numbers.insert(numbers.end(), held_.begin(), held_.end());
  for (const auto& forces : waiting_) numbers.insert(numbers.end(), forces.begin(), forces.end());
  return numbers;
}

void SampledForces::take_numbers(std::span<const double> numbers) {
  begun_ = true;
  start_ = numbers[0];
  samples_ = numbers[1];
  const auto count = static_cast<std::size_t>(numbers[2]), waiting = static_cast<std::size_t>(numbers[3]);
  auto from = numbers.begin() + 4;
  held_.assign(from, from + static_cast<std::ptrdiff_t>(count));
  waiting_.assign(waiting, std::vector<double>(count));
  for (auto& forces : waiting_) std::copy_n(from += static_cast<std::ptrdiff_t>(count), count, forces.begin());
}

}  // namespace dalembert
