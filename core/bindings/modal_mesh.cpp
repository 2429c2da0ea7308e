#include "modal_mesh.hpp"

namespace dalembert {
namespace {

constexpr std::size_t outputs = 6;  // components per node, in the basis of the output variable

}  // namespace

bool ModalMesh::find(const MainSystem& main, int object) {
  const Item& item = main.model.item(ItemKind::object, object);
  if (item.type->name != "ObjectFFRFreducedOrder") return false;
  object_ = object;
  if (item.record != record_) {
    record_ = item.record;
    points_.reset();
    numbers_.reset();
    nodes_ = parameters().referencePositions.size() / 3;
  }
  coordinates_ = main.system.node_index(parameters().nodeNumbers.back().value, System::Coordinates::ode2);
  return nodes_ > 0 && coordinates_ >= 0;
}

void ModalMesh::points(const MainSystem& main, std::span<const double, 12> rows, float* to) {
  points().place(weights(main), rows, to);
}

ModalPoints& ModalMesh::points() {
  if (!points_) {
    const auto& p = parameters();
    const auto modes = static_cast<std::size_t>(p.modeBasis.columns);
    points_.emplace(
        nodes_, modes, [&](std::size_t node, std::size_t i) { return p.referencePositions[3 * node + i]; },
        [&](std::size_t node, std::size_t i, std::size_t mode) {
          return p.modeBasis.values[(3 * node + i) * modes + mode];
        });
  }
  return *points_;
}

bool ModalMesh::has(OutputVariableType variable) const {
  return variable == OutputVariableType::Displacement ||
         (variable != OutputVariableType::_None && variable == parameters().outputVariableTypeModeBasis);
}

void ModalMesh::numbers(const MainSystem& main, OutputVariableType variable, int component, double* to) {
  if (variable == OutputVariableType::Displacement) return displacements(main, component, to);
  const auto& p = parameters();
  if (!numbers_ || component != component_) {
    const auto columns = static_cast<std::size_t>(p.outputVariableModeBasis.columns);
    const std::size_t first = component < 0 ? 0 : static_cast<std::size_t>(component), count = component < 0 ? outputs
                                                                                               : first < outputs ? 1
                                                                                                                 : 0;
    numbers_.emplace(nodes_, count, columns / outputs, [&](std::size_t node, std::size_t i, std::size_t mode) {
      return p.outputVariableModeBasis.values[node * columns + outputs * mode + first + i];
    });
    component_ = component;
  }
  numbers_->numbers(weights(main), to);
}

void ModalMesh::displacements(const MainSystem& main, int component, double* to) {
  const auto rows = [&](ConfigurationType configuration) { return main.system.pose(object_, configuration, totals_); };
  points().displacements(weights(main), rows(ConfigurationType::Visualization), rows(ConfigurationType::Reference),
                         component, to);
}

const ObjectFFRFreducedOrderParameters& ModalMesh::parameters() const {
  return static_cast<const ObjectFFRFreducedOrderRecord*>(record_.get())->parameters;
}

std::span<const double> ModalMesh::weights(const MainSystem& main) const {
  return std::span(main.system.state(ConfigurationType::Visualization).q)
      .subspan(static_cast<std::size_t>(coordinates_));
}

ModalMesh* ModalMeshes::find(const MainSystem& main, int object) {
  if (object < 0 || object >= main.model.count(ItemKind::object) || !main.consistent()) return nullptr;
  ModalMesh& mesh = by_object_[object];
  return mesh.find(main, object) ? &mesh : nullptr;
}

}  // namespace dalembert
