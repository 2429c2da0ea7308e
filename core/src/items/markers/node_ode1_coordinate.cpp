// MarkerNodeODE1Coordinate, specs/markers/node_ode1_coordinate.toml: loads on right-hand sides of first order equations.
#include "dalembert/markers/node_ode1_coordinate_parameters.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {
namespace {

int coordinate_of(const void* record) {
  return static_cast<const MarkerNodeODE1CoordinateRecord*>(record)->parameters.coordinate;
}

// Value: the coordinate without its reference value; it has no rate.
class ODE1CoordinateBatch final : public MarkerBatch {
 public:
  int value_count(const void*, const Placement&) const override { return ScalarPort::values; }
  int force_count(const void*, const Placement&) const override { return ScalarPort::forces; }

  void add(const void* record, const Placement& placement, const Ports&) override {
    const int place = placement.ode1[coordinate_of(record)];
    entries_.push_back({placement.item, place, placement.ode1_offset + place});
  }
  void refresh(int, const void*) override {}
  void visit(BlockVisitor&, const Ports&) const override {}

  void evaluate(const Evaluation& evaluation, Ports& ports) const override {
    for (const Entry& e : entries_) ports.frame(e.marker)[0] = evaluation.y[e.place];
  }
  void evaluate_tangent(const Evaluation&, const Weights&, Ports&) const override {}
  void pull_back(const Evaluation&, Ports& ports, double* r) const override {
    for (const Entry& e : entries_) r[e.row] += *ports.force(e.marker);
  }
  void geometric(const Evaluation&, const Weights&, const Ports&, double*) const override {}

 private:
  struct Entry {
    int marker = -1, place = -1, row = -1;  // place: in the vector of ODE1 coordinates; row: in the system vector
  };
  std::vector<Entry> entries_;
};

struct NodeODE1Coordinate final : MarkerPhysics {
  void check(const void* record, const Placement& on, const Ports&, const ItemLabel& item) const override {
    const int count = static_cast<int>(on.ode1.size()), coordinate = coordinate_of(record);
    if (count == 0)
      refuse(ErrorKind::value,
             {item, "nodeNumber", "", "a " + std::string(on.owner_type->name), "a node with ODE1 coordinates", ""});
    if (coordinate < 0 || coordinate >= count)
      refuse(ErrorKind::value, {item, "coordinate", "", std::to_string(coordinate),
                                "a coordinate from 0 to " + std::to_string(count - 1), ""});
  }
  bool has_rate() const override { return false; }
  std::vector<int> coordinates(const void*, const Placement&) const override { return {}; }
  std::unique_ptr<MarkerBatch> make_batch(const ItemType&, std::span<const ItemType* const>) const override {
    return std::make_unique<ODE1CoordinateBatch>();
  }
};

}  // namespace

const Physics& marker_node_ode1_coordinate_physics() {
  static const NodeODE1Coordinate physics;
  return physics;
}

}  // namespace dalembert
