#include "dalembert/system/load_dependencies.hpp"

#include <algorithm>
#include <cmath>

#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/model/model.hpp"
#include "dalembert/system/parts.hpp"

namespace dalembert {
namespace {

void add_columns(LoadDependency& dependency, std::span<const int> coordinates) {
  for (const int i : coordinates)
    if (std::ranges::find(dependency.columns, i) == dependency.columns.end()) dependency.columns.push_back(i);
}

bool contains(const Pattern& pattern, const LoadDependency& dependency) {
  return std::ranges::all_of(dependency.columns, [&](int column) {
    return std::ranges::all_of(dependency.rows, [&](int row) { return pattern.contains(row, column); });
  });
}

// Sorted by loads.
auto place_of(SystemParts& parts, int number) {
  return std::ranges::lower_bound(parts.load_dependencies, number, {}, &LoadDependency::load);
}

LoadDependency& dependency_of(SystemParts& parts, int number) {
  const auto place = place_of(parts, number);
  if (place != parts.load_dependencies.end() && place->load == number) return *place;
  const LoadPlace& load = parts.loads[static_cast<std::size_t>(number)];
  const auto& physics = static_cast<const LoadPhysics&>(*load.type->physics);
  LoadDependency made;
  made.load = number;
  made.term = physics.make_batch(physics.body_fixed(load.record.get()));
  Placement placement;
  placement.item = number;
  placement.markers = {load.marker};
  made.term->add(load.record.get(), placement, parts.ports);
  const auto rows = parts.ports.marker_dofs(load.marker);
  made.rows.assign(rows.begin(), rows.end());
  made.columns = made.rows;
  parts.bound = nullptr;
  return *parts.load_dependencies.insert(place, std::move(made));
}

// The current state, moved along one or more coordinates; it comes back also when a user function throws.
class MovedState {
 public:
  MovedState(const System& system, SystemParts& parts)
      : system_(system),
        parts_(parts),
        state_(parts.state(ConfigurationType::Current)),
        saved_(state_),
        increment_(state_.q.size(), 0.0) {
    parts_.current_moved = true;
  }
  ~MovedState() {
    back();
    parts_.current_moved = false;
  }
  MovedState(const MovedState&) = delete;
  MovedState& operator=(const MovedState&) = delete;

  double size(int i, bool velocity) const {
    return std::abs((velocity ? saved_.v : saved_.q)[static_cast<std::size_t>(i)]);
  }
  void move(int i, double by, bool velocity) {
    const auto k = static_cast<std::size_t>(i);
    (velocity ? state_.v : state_.q)[k] += by;
    increment_[k] = velocity ? 0 : by;
    if (system_.has_lie_nodes()) system_.compose(saved_.q, increment_, state_.q);
  }
  void back() {
    state_.q = saved_.q;
    state_.v = saved_.v;
    std::ranges::fill(increment_, 0.0);
  }

 private:
  const System& system_;
  SystemParts& parts_;
  State& state_;
  const State saved_;
  std::vector<double> increment_;
};

// The block of one load.
class LoadDifferences {
 public:
  LoadDifferences(SystemParts& parts, const Evaluation& evaluation, const LoadDependency& dependency, MovedState& state)
      : parts_(parts),
        evaluation_(evaluation),
        dependency_(dependency),
        state_(state),
        r_(dependency.rows.size()),
        ahead_(r_),
        behind_(r_) {}

  void add(double weight, bool velocity, double* values) {
    if (weight == 0 || rests(velocity)) return;
    const std::size_t columns = dependency_.columns.size();
    for (std::size_t j = 0; j < columns; ++j) {
      const int coordinate = dependency_.columns[j];
      const double step = step_of(coordinate, velocity);
      moved_force(coordinate, step, velocity, ahead_);
      moved_force(coordinate, -step, velocity, behind_);
      for (std::size_t i = 0; i < r_.size(); ++i)
        values[dependency_.slots[i * columns + j]] += weight * (ahead_[i] - behind_[i]) / (2 * step);
    }
  }

 private:
  // The error of central differences is least for the third root of the precision of numbers.
  double step_of(int coordinate, bool velocity) const {
    return 6e-6 * std::max(1.0, state_.size(coordinate, velocity));
  }

  // Most loads depend only on time: they do not change when all coordinates are varied, by different steps.
  bool rests(bool velocity) {
    force(r_);
    for (std::size_t j = 0; j < dependency_.columns.size(); ++j) {
      const int coordinate = dependency_.columns[j];
      state_.move(coordinate, (1 + 0.618 * static_cast<double>(j)) * step_of(coordinate, velocity), velocity);
    }
    force(ahead_);
    state_.back();
    return ahead_ == r_;
  }
  void moved_force(int coordinate, double by, bool velocity, std::vector<double>& r) {
    state_.move(coordinate, by, velocity);
    force(r);
    state_.back();
  }
  // Adds the load to its rows.
  void force(std::vector<double>& r) {
    const MarkerPlace& marker =
        parts_.markers[static_cast<std::size_t>(parts_.loads[static_cast<std::size_t>(dependency_.load)].marker)];
    parts_.ports.clear_forces();
    for (const int row : dependency_.rows) parts_.work[static_cast<std::size_t>(row)] = 0;
    dependency_.term->residual(evaluation_, parts_.ports, parts_.work.data());
    marker.member.batch->pull_back(evaluation_, parts_.ports, parts_.work.data());
    for (const auto& nodes : parts_.rotating_nodes) nodes->pull_back(evaluation_, parts_.ports, parts_.work.data());
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = parts_.work[static_cast<std::size_t>(dependency_.rows[i])];
  }

  SystemParts& parts_;
  const Evaluation& evaluation_;
  const LoadDependency& dependency_;
  MovedState& state_;
  std::vector<double> r_, ahead_, behind_;
};

}  // namespace

void make_load_dependencies(SystemParts& parts, const Model& model) {
  for (int i = 0; i < static_cast<int>(parts.loads.size()); ++i)
    if (const LoadPlace& load = parts.loads[static_cast<std::size_t>(i)];
        has_user_function(*load.type, load.record.get()))
      dependency_of(parts, i);
  for (const auto& [load, coordinates] : model.load_dependencies())
    add_columns(dependency_of(parts, load), coordinates);
}

void refresh_load_dependency(SystemParts& parts, int number) {
  const LoadPlace& load = parts.loads[static_cast<std::size_t>(number)];
  const auto place = place_of(parts, number);
  if (place != parts.load_dependencies.end() && place->load == number) {
    place->term->refresh(0, load.record.get());
  } else if (has_user_function(*load.type, load.record.get())) {
    dependency_of(parts, number);
  }
}

void find_slots(LoadDependency& dependency, const Pattern& pattern) {
  dependency.slots.clear();
  if (!contains(pattern, dependency)) return;
  for (const int row : dependency.rows)
    for (const int column : dependency.columns) dependency.slots.push_back(pattern.slot(row, column));
}

void add_load_dependencies(System& system, SystemParts& parts, Evaluation evaluation, const Weights& weights,
                           bool by_velocities, double* values) {
  evaluation.same_state = false;
  const auto forces = parts.ports.forces;  // further tangents may follow the same residual
  const auto node_loads = parts.ports.node_loads;
  const auto point_forces = parts.ports.point_forces;
  MovedState state(system, parts);
  for (const LoadDependency& dependency : parts.load_dependencies) {
    if (dependency.slots.empty()) continue;
    LoadDifferences differences(parts, evaluation, dependency, state);
    differences.add(weights.q, false, values);
    if (by_velocities) differences.add(weights.v, true, values);
  }
  parts.ports.forces = forces;
  parts.ports.node_loads = node_loads;
  parts.ports.point_forces = point_forces;
}

void System::add_load_dependencies(int load, std::span<const int> coordinates) {
  SystemParts& parts = *parts_;
  add_columns(dependency_of(parts, load), coordinates);
  parts.bound = nullptr;
}

void System::complete_pattern() {
  SystemParts& parts = *parts_;
  if (parts.sparse_patterns.empty()) return;
  const auto known = [&](const LoadDependency& dependency) {
    return contains(parts.sparse_patterns.back(), dependency);
  };
  if (!std::ranges::all_of(parts.load_dependencies, known)) parts.add_sparse_pattern();
}

std::span<const int> System::load_dependencies(int load) const {
  const auto place = place_of(*parts_, load);
  if (place == parts_->load_dependencies.end() || place->load != load) return {};
  return place->columns;
}

}  // namespace dalembert
