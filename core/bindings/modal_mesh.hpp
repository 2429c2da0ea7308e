// Points and numbers of the mesh of an ObjectFFRFreducedOrder, for pictures that need not be exact to more than single precision.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <unordered_map>

#include "dalembert/pictures/modal_points.hpp"
#include "dalembert/pictures/mode_planes.hpp"
#include "dalembert/super_elements/ffrf_reduced_order_parameters.hpp"
#include "main_system.hpp"

namespace dalembert {

class ModalMesh {
 public:
  // Returns whether this is such an object. Its data is cached as long as its parameters do not change.
  bool find(const MainSystem& main, int object);
  std::size_t nodes() const { return nodes_; }
  // Points of the visualization state; `rows` are rotation and position of the object.
  void points(const MainSystem& main, std::span<const double, 12> rows, float* to);
  // The variable of the mode basis, and displacements; one component, or the norm (-1).
  bool has(OutputVariableType variable) const;
  void numbers(const MainSystem& main, OutputVariableType variable, int component, double* to);

 private:
  const ObjectFFRFreducedOrderParameters& parameters() const;
  std::span<const double> weights(const MainSystem& main) const;
  ModalPoints& points();
  void displacements(const MainSystem& main, int component, double* to);

  std::shared_ptr<const void> record_;
  int object_ = -1;
  System::Values totals_;
  std::size_t nodes_ = 0;
  int coordinates_ = -1;  // the first modal one
  std::optional<ModalPoints> points_;
  std::optional<ModePlanes> numbers_;
  int component_ = 0;
};

// The meshes of one system; their data is cached for all users.
class ModalMeshes {
 public:
  // Null for other objects.
  ModalMesh* find(const MainSystem& main, int object);

 private:
  std::unordered_map<int, ModalMesh> by_object_;
};

}  // namespace dalembert
