// Evaluation plan: the batches of each region, in their order.
#pragma once

#include <map>
#include <utility>

#include "batch_table.hpp"
#include "dalembert/system/parts.hpp"

namespace dalembert {

// By region and type of the nodes; null for types that do not rotate.
using RotatingBatches = std::map<std::pair<int, const ItemType*>, RotatingNodeBatch*>;

struct GrownBatches {
  const BatchTable<MarkerBatch>& markers;
  const BatchTable<Term>& terms;
  const RotatingBatches& rotating;
  const BatchSet& differentiated;  // whose derivatives a term asks for
};

// Requires the regions with their data.
void make_plan(SystemParts& parts, const GrownBatches& grown, const Division& division);

// Finds constant loads, which depend on parameters: repeated after a change of parameters.
void sort_loads(SystemParts& parts);
// Finds the terms that System::gaps evaluates.
void find_terms_with_equations(SystemParts& parts);
// Finds markers that are needed if terms read nodes themselves.
void find_needed_markers(SystemParts& parts);

}  // namespace dalembert
