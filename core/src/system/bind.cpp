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
    if (!mass_alone || (term->has_mass() && !is_without_matrix(*term))) collect(*term);
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
  if (dense)
    return parts.dense_pattern ? *parts.dense_pattern : parts.dense_pattern.emplace(Pattern::dense(sizes_.total()));
  if (parts.sparse_patterns.empty()) parts.add_sparse_pattern();
  return parts.sparse_patterns.back();
}

// Finds terms without other masses on their coordinates.
void SystemParts::find_masses_without_matrix() {
  const auto separate_solver = [](const Term& term) {
    const auto* solver = term.has_mass() ? dynamic_cast<const MassSolver*>(&term) : nullptr;
    return solver != nullptr && solver->is_separate() ? solver : nullptr;
  };
  if (std::ranges::none_of(terms, [&](const auto& term) { return separate_solver(*term) != nullptr; })) return;
  struct Counter final : BlockVisitor {
    explicit Counter(int coordinates) : users(static_cast<std::size_t>(coordinates), nullptr) {}
    void entry(int row, int) override { use(row); }
    void block(std::span<const int> rows, std::span<const int>) override {
      std::ranges::for_each(rows, [this](int row) { use(row); });
    }
    void use(int row) {
      const Term*& user = users[static_cast<std::size_t>(row)];
      if (user != nullptr && user != now) shared.push_back({user, now});
      user = now;
    }
    const Term* now = nullptr;
    std::vector<const Term*> users;  // by coordinate, the last term
    std::vector<std::pair<const Term*, const Term*>> shared;
  } counter(sizes.total());
  for (const auto& term : terms) {
    if (!term->has_mass()) continue;
    counter.now = term.get();
    term->visit(counter, ports);
    if (separate_solver(*term) != nullptr) without_matrix.push_back(term.get());
  }
  for (const auto& pair : counter.shared)
    std::erase_if(without_matrix, [&](const Term* term) { return term == pair.first || term == pair.second; });
  for (const Term* term : without_matrix) mass_solvers.push_back(separate_solver(*term));
  for (std::size_t i = 0; i < counter.users.size(); ++i)
    if (counter.users[i] != nullptr && is_without_matrix(*counter.users[i]))
      coordinates_without_matrix.push_back(static_cast<int>(i));
}

const Pattern& System::mass_pattern() {
  SystemParts& parts = *parts_;
  if (parts.mass_pattern) return *parts.mass_pattern;
  parts.find_masses_without_matrix();
  CouplingCollector collector;
  for (const auto& term : parts.terms)
    if (term->has_mass() && !parts.is_without_matrix(*term)) term->visit(collector, parts.ports);
  return parts.mass_pattern.emplace(Pattern::sparse(sizes_.total(), collector.couplings));
}

std::span<const int> System::coordinates_without_matrix() {
  mass_pattern();
  return parts_->coordinates_without_matrix;
}

}  // namespace dalembert
