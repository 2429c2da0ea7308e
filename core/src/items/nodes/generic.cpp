// NodeGenericODE2, NodeGenericODE1, NodeGenericData: nodes with a number of coordinates that is a parameter.
// specs/nodes/generic_ode2.toml, generic_ode1.toml, generic_data.toml
#include <algorithm>

#include "dalembert/nodes/generic_data_parameters.hpp"
#include "dalembert/nodes/generic_ode1_parameters.hpp"
#include "dalembert/nodes/generic_ode2_parameters.hpp"
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
  static const auto& parameters(const void* record) {
    return static_cast<const NodeGenericODE2Record*>(record)->parameters;
  }
  Sizes sizes(const void* record) const override { return {.ode2 = parameters(record).numberOfODE2Coordinates}; }
  void values(const void* record, NodeValues& values) const override {
    const auto& p = parameters(record);
    values.reference = filled(p.referenceCoordinates, p.numberOfODE2Coordinates);
    values.displacement = filled(p.initialCoordinates, p.numberOfODE2Coordinates);
    values.velocity = filled(p.initialCoordinates_t, p.numberOfODE2Coordinates);
  }
};

struct GenericODE1 final : NodePhysics {
  static const auto& parameters(const void* record) {
    return static_cast<const NodeGenericODE1Record*>(record)->parameters;
  }
  Sizes sizes(const void* record) const override { return {.ode1 = parameters(record).numberOfODE1Coordinates}; }
  void values(const void* record, NodeValues& values) const override {
    const auto& p = parameters(record);
    values.reference_ode1 = filled(p.referenceCoordinates, p.numberOfODE1Coordinates);
    values.ode1 = filled(p.initialCoordinates, p.numberOfODE1Coordinates);
  }
};

struct GenericData final : NodePhysics {
  static const auto& parameters(const void* record) {
    return static_cast<const NodeGenericDataRecord*>(record)->parameters;
  }
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
const Physics& node_generic_data_physics() {
  static const GenericData physics;
  return physics;
}

}  // namespace dalembert
