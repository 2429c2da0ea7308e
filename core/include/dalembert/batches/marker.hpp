// Markers with the frame of a body or a node, and markers that select coordinates of a node.
#pragma once

#include <concepts>
#include <memory>
#include <utility>
#include <vector>

#include "dalembert/batches/mapped_marker.hpp"
#include "dalembert/batches/relative_marker.hpp"
#include "dalembert/contracts/marker.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

// Values: selected coordinates, then their rates. The force on each goes straight to its coordinate.
class CoordinateMarkerBatch : public MarkerBatch {
 public:
  // `totals`: the whole coordinate vector of a node or object, with reference values; it is empty on ground. Otherwise a
  // single coordinate, which is zero on ground.
  explicit CoordinateMarkerBatch(bool totals) : totals_(totals) {}
  int value_count(const void* record, const Placement& placement) const override;
  int force_count(const void* record, const Placement& placement) const override;
  bool shows_coordinates() const override { return true; }
  void add(const void* record, const Placement& placement, const Ports& ports) override;
  void refresh(int, const void*) override {}
  void visit(BlockVisitor&, const Ports&) const override {}
  void evaluate(const Evaluation& evaluation, Ports& ports) const override;
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const override;
  void pull_back(const Evaluation& evaluation, Ports& ports, double* r) const override;
  bool constant_pull_back(bool) const override { return true; }
  void geometric(const Evaluation&, const Weights&, const Ports&, double*) const override {}
  bool traceable() const override { return true; }
  void trace(const TracedCall& call) const override;

 private:
  template <class S>
  void find_values(const EvaluationOf<S>& evaluation, PortsOf<S>& ports) const;
  template <class S>
  void differentiate(const Weights& weights, PortsOf<S>& ports) const;
  template <class S>
  void subtract_forces(const PortsOf<S>& ports, S* r) const;
  struct Entry {
    int marker = -1;
    PortOffsets port;
    std::size_t first = 0, count = 0;  // its stretch of `dofs_`
  };
  int count(const Placement& placement) const;

  std::vector<Entry> entries_;
  std::vector<int> dofs_;
  bool totals_;
};

template <class K, class Record>
struct MarkerPhysicsOf final : MarkerPhysics {
  static_assert(FrameMarkerKernel<K> || CoordinateMarkerKernel<K> || RelativeMarkerKernel<K> || MappedMarkerKernel<K>,
                "see core/include/dalembert/contracts/marker.hpp");

  void check(const void* record, const Placement& on, const Ports&, const ItemLabel& item) const override {
    if constexpr (RelativeMarkerKernel<K>)
      check_relative_marker(static_cast<const Record*>(record)->parameters, on, item);
    if constexpr (MappedMarkerKernel<K>) K::check_body(static_cast<const Record*>(record)->parameters, on, item);
  }
  bool works_without_data(const void*) const override { return RelativeMarkerKernel<K>; }

  bool passes_frame(FrameShape& shape, Vec3<double>& local, const void* record) const override {
    if constexpr (FrameMarkerKernel<K>) {
      shape = K::shape;
      local = K::local(static_cast<const Record*>(record)->parameters);
      return true;
    }
    return false;
  }
  std::vector<int> coordinates(const void* record, const Placement& on) const override {
    if constexpr (CoordinateMarkerKernel<K>)
      return K::coordinates(static_cast<const Record*>(record)->parameters, static_cast<int>(on.dofs.size()));
    return all_positions(on.dofs);
  }
  std::unique_ptr<MarkerBatch> make_batch(const ItemType&, std::span<const ItemType* const>) const override {
    if constexpr (RelativeMarkerKernel<K>) {
      return std::make_unique<RelativeMarkerBatch<K, Record>>();
    } else if constexpr (MappedMarkerKernel<K>) {
      return std::make_unique<MappedMarkerBatch<K, Record>>();
    } else if constexpr (CoordinateMarkerKernel<K>) {
      return std::make_unique<CoordinateMarkerBatch>(K::totals);
    }
    return nullptr;
  }
};

}  // namespace dalembert
