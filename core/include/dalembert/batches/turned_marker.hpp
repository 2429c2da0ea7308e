// Markers with a constant rotation of their own: the frames of other markers, turned.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "dalembert/math/tensors.hpp"
#include "dalembert/system/term.hpp"

namespace dalembert {

// Passes everything on to another batch, and then turns the rotation matrices that it has written: R becomes R L, and so
// do its derivatives. Positions, spins, forces and Jacobians stay.
class TurnedMarkers final : public MarkerBatch {
 public:
  explicit TurnedMarkers(std::unique_ptr<MarkerBatch> inner) : inner_(std::move(inner)) {}
  // The rotation of the next marker that is added.
  void next(const Mat3<double>& rotation) { next_ = rotation; }

  void reserve(int entries) override { inner_->reserve(entries); }
  void add(const void* record, const Placement& placement, const Ports& ports) override {
    inner_->add(record, placement, ports);
    entries_.push_back({placement.item, next_, {}, {}});
  }
  void refresh(int entry, const void* record) override { inner_->refresh(entry, record); }
  void refresh_row(int entry, const void* record, const Row& row) override { inner_->refresh_row(entry, record, row); }
  void refresh_resting(int entry, const void* record, const Placement& placement) override {
    inner_->refresh_resting(entry, record, placement);
  }
  void refresh_owner(int entry, const void* record) override { inner_->refresh_owner(entry, record); }
  void refresh_owners(int entry, int which, const void* record) override {
    inner_->refresh_owners(entry, which, record);
  }
  void visit(BlockVisitor& visitor, const Ports& ports) const override { inner_->visit(visitor, ports); }

  int value_count(const void* record, const Placement& placement) const override {
    return inner_->value_count(record, placement);
  }
  int force_count(const void* record, const Placement& placement) const override {
    return inner_->force_count(record, placement);
  }
  int translations() const override { return inner_->translations(); }

  void evaluate(const Evaluation& evaluation, Ports& ports) const override {
    for (const Entry& e : entries_) restore(e.frame, ports.frame(e.marker), 1);
    inner_->evaluate(evaluation, ports);
    for (const Entry& e : entries_) turn(e, e.frame, ports.frame(e.marker), 1);
  }
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const override {
    share_slots();
    const auto columns = [&](const Entry& e) { return ports.ports[static_cast<std::size_t>(e.marker)].n; };
    for (const Entry& e : entries_) restore(e.derivative, ports.derivative(e.marker), columns(e));
    inner_->evaluate_tangent(evaluation, weights, ports);
    for (const Entry& e : entries_) turn(e, e.derivative, ports.derivative(e.marker), columns(e));
  }
  void pull_back(const Evaluation& evaluation, Ports& ports, double* r) const override {
    inner_->pull_back(evaluation, ports, r);
  }
  bool constant_pull_back(bool of_moments) const override { return inner_->constant_pull_back(of_moments); }
  bool passes_constantly(int entry, bool of_moments) const override {
    return inner_->passes_constantly(entry, of_moments);
  }
  void geometric(const Evaluation& evaluation, const Weights& weights, const Ports& ports,
                 double* values) const override {
    share_slots();
    inner_->geometric(evaluation, weights, ports, values);
  }
  bool geometric_follows_tangent() const override { return inner_->geometric_follows_tangent(); }
  void post_newton(const Evaluation& evaluation, const Ports& ports, double* data) const override {
    inner_->post_newton(evaluation, ports, data);
  }
  bool has_history() const override { return inner_->has_history(); }
  bool motion(int entry, const Evaluation& evaluation, Motion<double>& m) const override {
    if (!inner_->motion(entry, evaluation, m)) return false;
    m.rotation = m.rotation * entries_[static_cast<std::size_t>(entry)].rotation;
    return true;
  }

 private:
  struct Entry {
    int marker;
    Mat3<double> rotation;
    mutable std::vector<double> frame,
        derivative;  // what `inner_` has written: it does not write constant entries again
  };
  static constexpr int first_of_rotation = 6;  // behind position and velocity

  static void restore(const std::vector<double>& kept, double* rows, int n) {
    std::ranges::copy(kept, rows + first_of_rotation * n);
  }
  // Nine rows with `n` columns each.
  static void turn(const Entry& e, std::vector<double>& kept, double* rows, int n) {
    double* const first = rows + first_of_rotation * n;
    kept.assign(first, first + 9 * n);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int column = 0; column < n; ++column) {
          double sum = 0;
          for (int k = 0; k < 3; ++k)
            sum += kept[static_cast<std::size_t>((3 * i + k) * n + column)] * e.rotation(k, j);
          first[(3 * i + j) * n + column] = sum;
        }
  }
  void share_slots() const {
    if (inner_->slots != slots) inner_->slots = slots;
  }

  std::unique_ptr<MarkerBatch> inner_;
  std::vector<Entry> entries_;
  Mat3<double> next_ = identity<double>();
};

}  // namespace dalembert
