// Which constraint equations may follow from each other.
#pragma once

#include <span>
#include <vector>

#include "dalembert/system/pattern.hpp"

namespace dalembert {

// Equations, by their places in `rows`, such that combinations that vanish are those of the lists: of equations that act on common
// coordinates, directly or by way of others; or of those alone that lie on common loops of bodies, which holds where the nodes of joints feel
// equal and opposite forces. Entries are those of the columns of the multipliers; `nodes` are those of the ODE2 coordinates.
enum class BlocksOf { coordinates, loops };
struct ConstraintBlock {
  std::vector<int> rows;  // places in `rows`
  int hangs_on = -1;      // of loops: the node that lies between these and the ground, or whatever the rest is; -1: none
};
std::vector<ConstraintBlock> constraint_blocks(BlocksOf kind, const Pattern& pattern, std::span<const double> values, int first_ae,
                                               std::span<const int> nodes, std::span<const int> rows);

}  // namespace dalembert
