// Parts of messages for pages that change their shape or their colors: meshes that deform by modes, and balls at nodes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dalembert/pictures/contour.hpp"
#include "dalembert/pictures/moving_parts.hpp"
#include "main_system.hpp"
#include "modal_mesh.hpp"

namespace dalembert {

class ColoredParts {
 public:
  // Mapping of numbers to colors.
  struct Rule {
    OutputVariableType variable = OutputVariableType::_None;
    int component = 0;
    bool automatic = false, grows = false;  // whether the range is that of the numbers, and also that of all before
    NumberRange limits, shown;  // unless it is automatic, and before
    std::vector<std::uint8_t> table;  // same layout as contour_shades
  };

  ColoredParts(std::shared_ptr<MainSystem> main, std::shared_ptr<ModalMeshes> meshes, Rule rule)
      : main_(std::move(main)), meshes_(std::move(meshes)), rule_(std::move(rule)) {}
  // Both return the number of the part.
  std::size_t add_mesh(int object);
  // of one moving part, at its unrotated points
  std::size_t add_ball(int node, int group, std::span<const double> local);
  void color(std::size_t part) { parts_[part].numbers.resize(parts_[part].points); }

  // Finds the numbers and their range; false if they, or the points, are not to be had in this way.
  bool find(const MovingParts& moving);
  const NumberRange& range() const { return rule_.shown; }
  std::size_t points(std::size_t part) const { return parts_[part].points; }
  void write_points(std::size_t part, float* to);
  void write_shades(std::size_t part, std::uint8_t* to) const;

 private:
  struct Part {
    int object, node, group;  // either object or node is -1
    std::size_t points;
    std::vector<double> local;
    std::array<double, 12> rows;  // pose of the object or of the moving part
    LargeVector<double> numbers;  // empty: it has no colors
  };
  bool find_mesh(Part& part);
  bool find_ball(Part& part, const MovingParts& moving);

  const std::shared_ptr<MainSystem> main_;
  const std::shared_ptr<ModalMeshes> meshes_;
  Rule rule_;
  std::vector<Part> parts_;
  System::Values values_;
};

}  // namespace dalembert
