// Points of a mesh that deforms by modes in a frame, and how far they are from where they rest, for pictures.
#pragma once

#include <span>
#include <vector>

#include "dalembert/pictures/mode_planes.hpp"

namespace dalembert {

class ModalPoints {
 public:
  using Rows = std::span<const double, 12>;  // rotation and position of a frame, 3 x 4

  // rest(node, component) and of_mode(node, component, mode).
  template <class Rest, class OfMode>
  ModalPoints(std::size_t nodes, std::size_t modes, const Rest& rest, const OfMode& of_mode)
      : planes_(nodes, 3, modes, of_mode), rest_(3 * nodes) {
    float* to = rest_.data();
    for (std::size_t first = 0; first < nodes; first += ModePlanes::block)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < planes_.size_of_block(first); ++k) *to++ = static_cast<float>(rest(first + k, i));
  }

  // x, y and z of each node.
  void place(std::span<const double> weights, Rows frame, float* to);
  // A component of the displacement of each node, or the norm (-1); at_rest: the frame of the undeformed mesh.
  void displacements(std::span<const double> weights, Rows frame, Rows at_rest, int component, double* to);

 private:
  void deform(std::span<const double> weights);

  ModePlanes planes_;
  LargeVector<float> rest_;  // by block and component
  LargeVector<float> deformation_;  // for the weights that follow, in the same order
  std::vector<double> weights_;
};

}  // namespace dalembert
