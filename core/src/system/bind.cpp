// Patterns of the system's matrices, and the places in their values that the batches write to.
#include "dalembert/system/parts.hpp"

namespace dalembert {
namespace {

class CouplingCollector final : public BlockVisitor {
 public:
  void entry(int row, int column) override { couplings.add(row, column); }
  void block(std::span<const int> rows, std::span<const int> columns) override { couplings.add(rows, columns); }
  void mirror(std::span<const int> rows, std::span<const int> columns) override { couplings.add(rows, columns); }
  Couplings couplings;
};

class SlotCollector final : public BlockVisitor {
 public:
  explicit SlotCollector(const Pattern& pattern) : pattern_(pattern) {}
  void entry(int row, int column) override { slots.push_back(pattern_.slot(row, column)); }
  void zero() override { slots.push_back(-1); }
  void block(std::span<const int> rows, std::span<const int> columns) override {
    const std::size_t first = slots.size();
    slots.resize(first + rows.size() * columns.size());
    for (std::size_t c = 0; c < columns.size(); ++c) {
      int* to = slots.data() + first + c;
      pattern_.for_each_slot(rows, columns[c], [&](int slot) {
        *to = slot;
        to += columns.size();
      });
    }
  }
  void mirror(std::span<const int> rows, std::span<const int> columns) override {
    for (const int row : rows) pattern_.for_each_slot(columns, row, [&](int slot) { slots.push_back(slot); });
  }
  std::vector<int> slots;

 private:
  const Pattern& pattern_;
};

}  // namespace

void SystemParts::bind(const Pattern& pattern) {
  if (bound == &pattern) return;
  const auto collect = [&](Batch& batch) {
    SlotCollector collector(pattern);
    batch.visit(collector, ports);
    batch.slots = std::move(collector.slots);
  };
  const bool mass_alone = mass_pattern && &pattern == &*mass_pattern;
  for (const auto& term : terms)
    if (!mass_alone || term->has_mass()) collect(*term);
  if (!mass_alone) {
    for (const auto& batch : marker_batches) collect(*batch);
    for (const auto& batch : rotating_nodes) collect(*batch);
    for (LoadDependency& dependency : load_dependencies) find_slots(dependency, pattern);
  }
  rate_slots.clear();
  for (int i = sizes.ode2; i < sizes.first_ae(); ++i) rate_slots.push_back(pattern.slot(i, i));
  bound = &pattern;
}

Pattern SystemParts::make_sparse_pattern() const {
  CouplingCollector collector;
  for (const auto& term : terms) term->visit(collector, ports);
  for (const auto& batch : marker_batches) batch->visit(collector, ports);
  for (const auto& batch : rotating_nodes) batch->visit(collector, ports);
  for (const LoadDependency& dependency : load_dependencies) collector.block(dependency.rows, dependency.columns);
  return Pattern::sparse(sizes.total(), collector.couplings);
}

const Pattern& System::pattern(bool dense) {
  SystemParts& parts = *parts_;
  if (dense) return parts.dense_pattern ? *parts.dense_pattern : parts.dense_pattern.emplace(Pattern::dense(sizes_.total()));
  if (parts.sparse_patterns.empty()) parts.add_sparse_pattern();
  return parts.sparse_patterns.back();
}

const Pattern& System::mass_pattern() {
  SystemParts& parts = *parts_;
  if (parts.mass_pattern) return *parts.mass_pattern;
  CouplingCollector collector;
  for (const auto& term : parts.terms)
    if (term->has_mass()) term->visit(collector, parts.ports);
  return parts.mass_pattern.emplace(Pattern::sparse(sizes_.total(), collector.couplings));
}

}  // namespace dalembert
