// NodeGenericODE2, NodeGenericODE1, NodeGenericAE, NodeGenericData: as many coordinates as their parameters say.
// specs/nodes/generic_ode2.toml, generic_ode1.toml, generic_ae.toml, generic_data.toml
#include <algorithm>
#include <memory>
#include <vector>

#include "dalembert/nodes/generic_ae_parameters.hpp"
#include "dalembert/nodes/generic_data_parameters.hpp"
#include "dalembert/nodes/generic_ode1_parameters.hpp"
#include "dalembert/nodes/generic_ode2_parameters.hpp"
#include "dalembert/system/algebraic_coordinates.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {
namespace {

// Start values; an empty list means zeros.
std::vector<double> filled(const std::vector<double>& values, int size) {
  std::vector<double> r(static_cast<std::size_t>(size), 0.0);
  std::copy_n(values.begin(), std::min(values.size(), r.size()), r.begin());
  return r;
}

struct GenericODE2 final : NodePhysics {
  static const auto& parameters(const void* record) { return static_cast<const NodeGenericODE2Record*>(record)->parameters; }
  Sizes sizes(const void* record) const override { return {.ode2 = parameters(record).numberOfODE2Coordinates}; }
  void values(const void* record, NodeValues& values) const override {
    const auto& p = parameters(record);
    values.reference = filled(p.referenceCoordinates, p.numberOfODE2Coordinates);
    values.displacement = filled(p.initialCoordinates, p.numberOfODE2Coordinates);
    values.velocity = filled(p.initialCoordinates_t, p.numberOfODE2Coordinates);
  }
};

struct GenericODE1 final : NodePhysics {
  static const auto& parameters(const void* record) { return static_cast<const NodeGenericODE1Record*>(record)->parameters; }
  Sizes sizes(const void* record) const override { return {.ode1 = parameters(record).numberOfODE1Coordinates}; }
  void values(const void* record, NodeValues& values) const override {
    const auto& p = parameters(record);
    values.reference_ode1 = filled(p.referenceCoordinates, p.numberOfODE1Coordinates);
    values.ode1 = filled(p.initialCoordinates, p.numberOfODE1Coordinates);
  }
};

// Algebraic variables that keep their initial values: y - y_ini = 0.
class KeptVariables final : public Term, public AlgebraicCoordinates {
 public:
  void add(const void* record, const Placement& placement, const Ports&) override {
    values_.push_back(start_of(record));
    first_.push_back(placement.first_ae);
    ae_offset_ = placement.ae_offset;
  }
  void refresh(int entry, const void* record) override { values_[static_cast<std::size_t>(entry)] = start_of(record); }
  void visit(BlockVisitor& visitor, const Ports&) const override {
    each([&](int i, double) { visitor.entry(ae_offset_ + i, ae_offset_ + i); });
  }
  void residual(const Evaluation& evaluation, Ports&, double* r) const override {
    each([&](int i, double start) { r[ae_offset_ + i] += evaluation.lambda[i] - start; });
  }
  void tangent(const Evaluation&, const Weights&, Ports&, double* values) const override {
    SlotCursor slot(slots.data(), values);
    each([&](int, double) { slot.add(1); });
  }
  void mark(std::span<double> signs) const override {
    each([&](int i, double) { signs[static_cast<std::size_t>(i)] = 1; });
  }

  static std::vector<double> start_of(const void* record) {
    const auto& p = static_cast<const NodeGenericAERecord*>(record)->parameters;
    return filled(p.initialCoordinates, p.numberOfAECoordinates);
  }

 private:
  template <class F>
  void each(F&& f) const {  // f(number of the variable, its start value)
    for (std::size_t entry = 0; entry < first_.size(); ++entry)
      for (std::size_t k = 0; k < values_[entry].size(); ++k) f(first_[entry] + static_cast<int>(k), values_[entry][k]);
  }

  std::vector<int> first_;
  std::vector<std::vector<double>> values_;
  int ae_offset_ = 0;
};

struct GenericAE final : NodePhysics {
  Sizes sizes(const void* record) const override {
    return {.ae = static_cast<const NodeGenericAERecord*>(record)->parameters.numberOfAECoordinates};
  }
  void values(const void* record, NodeValues& values) const override { values.algebraic = KeptVariables::start_of(record); }
  std::unique_ptr<Term> make_condition() const override { return std::make_unique<KeptVariables>(); }
};

struct GenericData final : NodePhysics {
  static const auto& parameters(const void* record) { return static_cast<const NodeGenericDataRecord*>(record)->parameters; }
  Sizes sizes(const void* record) const override { return {.data = parameters(record).numberOfDataCoordinates}; }
  void values(const void* record, NodeValues& values) const override {
    const auto& p = parameters(record);
    values.data = filled(p.initialCoordinates, p.numberOfDataCoordinates);
  }
};

}  // namespace

const Physics& node_generic_ode2_physics() {
  static const GenericODE2 physics;
  return physics;
}
const Physics& node_generic_ode1_physics() {
  static const GenericODE1 physics;
  return physics;
}
const Physics& node_generic_ae_physics() {
  static const GenericAE physics;
  return physics;
}
const Physics& node_generic_data_physics() {
  static const GenericData physics;
  return physics;
}

}  // namespace dalembert
