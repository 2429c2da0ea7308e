#include "plan.hpp"

#include <algorithm>
#include <iterator>
#include <unordered_set>

#include "dalembert/system/system_term.hpp"

namespace dalembert {
namespace {

// Regions of one size, which follow each other in the tree; the smallest come last there and first here.
void list_sizes(EvaluationPlan& plan, const Division& division) {
  const std::span<const RegionPlan> all = plan.regions;
  for (std::size_t count = (all.size() + 1) / 2; count > 0; count /= 2) {
    const auto regions = all.subspan(count - 1, count);
    int entries = 0;
    for (const RegionPlan& region : regions) entries += region.entries;
    plan.sizes.push_back({regions, entries >= division.entries});
  }
}

}  // namespace

// Terms without an acting entry are left out: ground.
void make_plan(SystemParts& parts, const GrownBatches& grown, const Division& division) {
  EvaluationPlan& plan = parts.plan;
  const auto region_of = [&](const auto* growing) -> RegionPlan* {
    return growing->acts ? &plan.regions[static_cast<std::size_t>(growing->region)] : nullptr;
  };
  for (const auto& [key, batch] : grown.rotating)
    if (batch != nullptr) plan.regions[static_cast<std::size_t>(key.first)].nodes.push_back(batch);
  for (const auto* growing : grown.markers.in_order()) {
    RegionPlan* region = region_of(growing);
    (region != nullptr ? region->moving : plan.resting).push_back(growing->batch);
    if (region == nullptr) continue;
    region->entries += growing->entries;
    if (grown.differentiated.contains(growing->batch) || growing->batch->geometric_follows_tangent())
      region->differentiated.push_back(growing->batch);
  }
  BatchSet loads;
  for (const LoadPlace& load : parts.loads) loads.add(load.member.batch);
  loads.sort();
  for (const auto* growing : grown.terms.in_order()) {
    RegionPlan* region = region_of(growing);
    if (region == nullptr) continue;
    region->entries += growing->entries;
    (loads.contains(growing->batch) ? region->loads : region->terms).push_back(growing->batch);
  }
  list_sizes(plan, division);
  for (const ObjectPlace& object : parts.objects)
    for (const int marker : object.markers.of(parts.references))
      plan.connected.add(parts.markers[static_cast<std::size_t>(marker)].member.batch);
  plan.connected.sort();
  sort_loads(parts);
}

void sort_loads(SystemParts& parts) {
  BatchSet passing_forces, passing_all, pulled, loaded, changing;
  const auto batch_of = [&](int marker) { return parts.markers[static_cast<std::size_t>(marker)].member.batch; };
  for (const auto& batch : parts.marker_batches) {
    if (batch->constant_pull_back(false)) passing_forces.add(batch.get());
    if (batch->constant_pull_back(true)) passing_all.add(batch.get());
  }
  passing_forces.sort();
  passing_all.sort();
  parts.loads_call_functions = false;
  for (const LoadPlace& load : parts.loads) {
    const Term* batch = load.member.batch;
    const auto& passing = batch->has_moments() ? passing_all : passing_forces;
    const bool calls = has_user_function(*load.type, load.record.get());
    parts.loads_call_functions |= calls;
    if (batch->has_tangent() || calls || !passing.contains(batch_of(load.marker))) changing.add(batch);
  }
  changing.sort();
  for (const LoadPlace& load : parts.loads)
    (changing.contains(load.member.batch) ? pulled : loaded).add(batch_of(load.marker));
  for (const Batch* batch : parts.plan.connected.all()) pulled.add(batch);
  pulled.sort();
  loaded.sort();
  parts.loads_are_sorted = true;
  ConstantLoads& constant = parts.plan.constant;
  constant = {};
  for (RegionPlan& region : parts.plan.regions) {
    region.changing_loads.clear();
    region.pulled.clear();
    for (const Term* load : region.loads)
      (changing.contains(load) ? region.changing_loads : constant.loads).push_back(load);
    for (const MarkerBatch* batch : region.moving) {
      if (pulled.contains(batch)) region.pulled.push_back(batch);
      if (loaded.contains(batch)) constant.markers.push_back(batch);
    }
  }
}

void find_terms_with_equations(SystemParts& parts) {
  std::unordered_set<const Batch*>
      plain;  // batches of objects alone that neither have equations nor nodes with equations
  const auto has_equations = [&](const ObjectPlace& object) {
    const auto nodes = object.nodes.of(parts.references);
    return object.equations > 0 || std::ranges::any_of(nodes, [&](int node) {
             return parts.nodes[static_cast<std::size_t>(node)].sizes.ae > 0;
           });
  };
  for (const ObjectPlace& object : parts.objects) plain.insert(object.member.batch);
  for (const ObjectPlace& object : parts.objects)
    if (has_equations(object)) plain.erase(object.member.batch);
  for (RegionPlan& region : parts.plan.regions) {
    region.with_equations.clear();
    std::ranges::copy_if(region.terms, std::back_inserter(region.with_equations),
                         [&](const Term* term) { return !plain.contains(term); });
  }
  parts.knows_terms_with_equations = true;
}

void find_needed_markers(SystemParts& parts) {
  std::unordered_set<const MarkerBatch*> needed;
  const auto need = [&](int marker) { needed.insert(parts.markers[static_cast<std::size_t>(marker)].member.batch); };
  for (const ObjectPlace& object : parts.objects)
    for (const int marker : object.markers.of(parts.references)) need(marker);
  std::unordered_set<const Batch*> changing;
  for (const RegionPlan& region : parts.plan.regions)
    changing.insert(region.changing_loads.begin(), region.changing_loads.end());
  for (const LoadPlace& load : parts.loads)
    if (!changing.empty() && changing.contains(load.member.batch)) need(load.marker);
  for (const SystemTerm* term : parts.system_terms)
    for (std::size_t k = 0; k < term->markers().size(); ++k)
      if (term->needs_port(k)) need(term->markers()[k]);
  parts.leaves_markers_to_terms = parts.needs_totals = false;
  const auto reads_totals = [](const auto* batch) { return batch->reads_totals(); };
  const auto among_needed = [&](const MarkerBatch* batch) { return needed.contains(batch); };
  for (RegionPlan& region : parts.plan.regions) {
    region.needed.clear();
    region.needed_pulled.clear();
    std::ranges::copy_if(region.moving, std::back_inserter(region.needed), among_needed);
    std::ranges::copy_if(region.pulled, std::back_inserter(region.needed_pulled), among_needed);
    parts.leaves_markers_to_terms |= region.needed.size() < region.moving.size();
    parts.needs_totals |= !region.needed.empty() || std::ranges::any_of(region.nodes, reads_totals) ||
                          std::ranges::any_of(region.terms, reads_totals);
  }
}

}  // namespace dalembert
