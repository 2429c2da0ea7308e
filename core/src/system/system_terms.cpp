// Terms that are not items: their connection with an assembled system, and the update of patterns.
#include "dalembert/system/system_term.hpp"

#include "dalembert/system/parts.hpp"
#include "plan.hpp"

namespace dalembert {
namespace {

class ContainmentCheck final : public BlockVisitor {
 public:
  explicit ContainmentCheck(const Pattern& pattern) : pattern_(pattern) {}
  void entry(int row, int column) override { holds = holds && pattern_.contains(row, column); }
  bool holds = true;

 private:
  const Pattern& pattern_;
};

}  // namespace

// Markers under it are differentiated, and their forces pulled back, as if an item were connected.
void System::add(std::unique_ptr<SystemTerm> term) {
  SystemParts& parts = *parts_;
  for (const int marker : term->markers())
    parts.plan.connected.add(parts.markers[static_cast<std::size_t>(marker)].member.batch);
  parts.plan.connected.sort();
  for (RegionPlan& region : parts.plan.regions)
    for (const MarkerBatch* batch : region.moving)
      if (parts.plan.connected.contains(batch) &&
          std::ranges::find(region.differentiated, batch) == region.differentiated.end())
        region.differentiated.push_back(batch);
  sort_loads(parts);
  parts.plan.resting_evaluated = parts.knows_terms_with_equations = false;
  parts.plan.regions[Regions::whole].terms.push_back(term.get());
  bool& has_history = term->direct() ? parts.has_direct_history : parts.has_history;
  has_history = has_history || term->has_history();
  parts.has_switches = parts.has_switches || term->has_switches();
  parts.system_terms.push_back(term.get());
  parts.terms.push_back(std::move(term));
  parts.bound = nullptr;
  ports_hold(nullptr);
  searches_ = true;
  if (!parts.sparse_patterns.empty()) parts.add_sparse_pattern();
}

NodeFrame System::node_frame(int marker) const {
  const Membership<MarkerBatch>& member = parts_->markers[static_cast<std::size_t>(marker)].member;
  return member.batch->node_frame(member.entry);
}

// Asked for only where it is used: parameters may change at each step.
void System::find_nodes_of_terms() {
  for (SystemTerm* term : parts_->system_terms) term->find_nodes(*this);
  find_needed_markers(*parts_);
  parts_->knows_needed_markers = true;
}

bool System::search(const State& state, const Conditions& conditions) {
  SystemParts& parts = *parts_;
  const auto rests = [&](const SystemTerm* term) { return conditions.direct && term->direct(); };
  if (std::ranges::all_of(parts.system_terms, rests)) return false;
  ports_hold(nullptr);
  const Evaluation e = parts.evaluation(state, conditions);
  parts.update_ports(e);
  bool changed = false;
  for (SystemTerm* term : parts.system_terms)
    if (!rests(term)) changed |= term->search(e, parts.ports);
  if (!changed) return false;
  parts.bound = nullptr;
  const bool anew = std::exchange(forgotten_, false);
  if (parts.sparse_patterns.empty()) return false;
  ContainmentCheck check(parts.sparse_patterns.back());
  for (const SystemTerm* term : parts.system_terms) term->visit(check, parts.ports);
  if (check.holds && !anew) return false;
  // replaced in place: a running solver has a pointer to it
  parts.sparse_patterns.back() = parts.make_sparse_pattern();
  ++pattern_revisions_;
  return true;
}

void System::forget_searches() {
  for (SystemTerm* term : parts_->system_terms) forgotten_ |= term->forget();
}

SystemTerm& System::term(int number) { return *parts_->system_terms[static_cast<std::size_t>(number)]; }

const Ports& System::current_ports() {
  SystemParts& parts = *parts_;
  const State& now = state_of(states_, ConfigurationType::Current);
  if (parts.evaluating || (parts.recording && parts.recorded == &now)) return parts.ports;
  const bool written = std::exchange(lent_, lent_ && parts.kept_states.use_count() > 1);  // or was until now
  if (!written && frames_.number > 0 && frames_.writes == writes_ && frames_.touches == touches_) return parts.ports;
  parts.update_ports(parts.output_evaluation(now));
  parts.recorded = &now;
  ports_hold(nullptr);
  frames_ = {writes_, touches_, frames_.number + 1};
  return parts.ports;
}

std::uint64_t System::number_of_current_ports() const {
  return !lent_ && frames_.writes == writes_ && frames_.touches == touches_ ? frames_.number : 0;
}

void System::forces_of_term(int number, std::span<double> forces) {
  SystemParts& parts = *parts_;
  ports_hold(nullptr);
  Evaluation e = parts.evaluation(state(ConfigurationType::Current), {});
  e.direct = true;
  parts.update_ports(e);
  parts.ports.clear_forces();
  std::vector<double> r(static_cast<std::size_t>(sizes_.total()));
  term(number).residual(e, parts.ports, r.data());
  for (const RegionPlan& region : parts.plan.regions) {
    for (const MarkerBatch* batch : region.pulled) batch->pull_back(e, parts.ports, r.data());
    for (const RotatingNodeBatch* nodes : region.nodes) nodes->pull_back(e, parts.ports, r.data());
  }
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] = -r[i];
}

void System::forget_switches() {
  for (SystemTerm* term : parts_->system_terms) term->forget_switches();
}
void System::keep_history() {
  for (SystemTerm* term : parts_->system_terms) term->keep();
}
void System::restore_history() {
  for (SystemTerm* term : parts_->system_terms) term->restore();
}
void System::begin_history() {
  SystemParts& parts = *parts_;
  ports_hold(nullptr);
  const auto grows = [](const SystemTerm* term) { return term->has_history_of_steps(); };
  if (std::ranges::any_of(parts.system_terms, grows))
    parts.update_ports(parts.evaluation(state(ConfigurationType::Initial), {}));
  for (SystemTerm* term : parts.system_terms) term->begin_history(parts.ports);
}

std::vector<double> System::history() const {
  std::vector<double> numbers;
  for (const SystemTerm* term : parts_->system_terms) term->write_history(numbers);
  return numbers;
}

bool System::take_history(std::span<const double> numbers) {
  return std::ranges::all_of(parts_->system_terms, [&](SystemTerm* term) { return term->take_history(numbers); }) &&
         numbers.empty();
}

}  // namespace dalembert
