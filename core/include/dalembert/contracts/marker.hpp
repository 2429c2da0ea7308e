// Markers: a kernel has one of four forms.
//
//   the frame of a body or node:          `shape` and `local`, a position that moves with it
//   coordinates of a node or object:      `coordinates`, which of them, and `totals`, whether with reference values
//   a coordinate between two bodies:      `measure` and `forces` (batches/relative_marker.hpp)
//   numbers made of all coordinates:      `map` and `pull_back` (contracts/mapped_marker.hpp)
//
// No member is optional: one that is missing, misspelt or has another type does not compile.
#pragma once

#include <concepts>
#include <vector>

#include "dalembert/math/fixed.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

template <class K>
concept FrameMarkerKernel = requires(const typename K::Parameters& p) {
  requires std::same_as<decltype(K::shape), const FrameShape>;
  { K::local(p) } -> std::same_as<Vec3<double>>;
};
template <class K>
concept CoordinateMarkerKernel = requires(const typename K::Parameters& p) {
  { K::coordinates(p, 0) } -> std::same_as<std::vector<int>>;  // out of so many
  requires std::same_as<decltype(K::totals), const bool>;
};

}  // namespace dalembert
