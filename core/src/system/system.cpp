#include "dalembert/system/system.hpp"

#include <numeric>
#include <utility>

#include "dalembert/model/errors.hpp"
#include "dalembert/system/algebraic_coordinates.hpp"
#include "dalembert/system/parts.hpp"
#include "placing.hpp"
#include "plan.hpp"
#include "start_values.hpp"

namespace dalembert {

System::System() : parts_(std::make_unique<SystemParts>()), states_(parts_->states.data()) {}
System::~System() = default;

void System::assemble(const Model& model, const Division& division) {
  if (start_again(model, division)) return;
  model.check();
  auto parts = std::make_unique<SystemParts>();
  build(*parts, model, division);
  parts->check_sensors();
  sizes_ = parts->sizes;
  parts->total.assign(sizes_.ode2, 0);
  parts->static_signs.assign(sizes_.ae, -1);
  for (const auto& term : parts->terms) {
    if (const auto* coordinates = dynamic_cast<const AlgebraicCoordinates*>(term.get()))
      coordinates->mark(parts->static_signs);
    if (const auto* vectors = dynamic_cast<const UnitVectors*>(term.get())) vectors->list(parts->unit_vectors);
  }
  ports_hold(nullptr);
  // Behind the residual: zeros, for multipliers or displacements that are left out of an evaluation.
  parts->work.assign(sizes_.total() + std::max({sizes_.ode2, sizes_.ae, 1}), 0);
  parts_ = std::move(parts);
  states_ = parts_->states.data();
  assembled_ = true;
  late_ = nullptr;
  searches_ = pulled_ = false;
  for (std::size_t i = 0; i < model.term_sources().size(); ++i) {
    add(model.term_sources()[i]->make_term(parts_->ports, model.term_name(i)));
    parts_->system_terms.back()->enter(*this, model);
  }
  ++version_;
}

bool System::start_again(const Model& model, const Division& division) {
  SystemParts& parts = *parts_;
  const bool is_same = assembled_ && parts.structure == model.structure_changes() &&
                       parts.records == model.record_changes() && parts.division == division &&
                       model.term_sources().empty() && parts.system_terms.empty();
  if (!is_same || parts.kept_states.use_count() > 1) return false;  // others keep the states of the last assembly
  dalembert::start_again(parts);
  ports_hold(nullptr);
  parts.plan.resting_evaluated = parts.evaluating = parts.current_moved = parts.recording = false;
  parts.recorded = nullptr;
  parts.not_unique.clear();
  parts.workers.reset();
  std::ranges::fill(parts.work, 0.0);
  late_ = nullptr;
  ++version_;
  return true;
}

void System::use_threads(int count) {
  SystemParts& parts = *parts_;
  count = parts.functions_in_regions ? 1 : std::min(count, static_cast<int>(parts.plan.regions.size() + 1) / 2);
  if (count == threads()) return;
  parts.workers.reset();
  if (count > 1) parts.workers = std::make_unique<Workers>(count);
  for (SystemTerm* term : parts.system_terms) term->use_workers(parts.workers.get());
}
int System::threads() const { return parts_->workers ? parts_->workers->count() : 1; }

Workers* System::workers() const { return parts_->workers.get(); }

bool System::assembled() const { return assembled_; }

bool System::calls_user_functions() const {
  const auto calls = [](const auto& place) { return has_user_function(*place.type, place.record.get()); };
  if (parts_->loads_call_functions) return true;
  return parts_->others_take_functions &&
         (std::ranges::any_of(parts_->nodes, calls) || std::ranges::any_of(parts_->objects, calls));
}

std::shared_ptr<const void> System::hold_states() const {
  lent_ = true;
  return parts_->kept_states;
}

namespace {

// New parameters have to fit nodes and markers, as at Assemble().
void check_change(SystemParts& parts, const Model& model, Placing& placing, const ItemChange& change) {
  if (change.kind != ItemKind::object && change.kind != ItemKind::marker) return;
  const ItemLabel label{model, change.kind, change.number};
  const Item& changed = model.item(change.kind, change.number);
  const Placement& on = change.kind == ItemKind::object
                            ? placing.of_object(change.number)
                            : placing.of_marker(change.number, parts.markers[static_cast<std::size_t>(change.number)]);
  if (change.row != nullptr)
    return changed.type->physics->check_row(changed.record.get(), on, parts.ports, label, *change.row);
  changed.type->physics->check(changed.record.get(), on, parts.ports, label);
}

void refresh_entry(Term& batch, int entry, const void* record, const Row* row) {
  row == nullptr ? batch.refresh(entry, record) : batch.refresh_row(entry, record, *row);
}

std::vector<ItemChange> all_items(const Model& model) {
  std::vector<ItemChange> items;
  for (int k = 0; k < item_kinds; ++k)
    for (int i = 0; i < model.count(static_cast<ItemKind>(k)); ++i) items.push_back({{static_cast<ItemKind>(k), i}});
  return items;
}

}  // namespace

std::span<const MarkerSeat> SystemParts::markers_on(ItemKind kind, int number) {
  const auto each_seat = [this](auto&& f) {
    for (std::size_t m = 0; m < markers.size(); ++m) {
      const MarkerPlace& marker = markers[m];
      const auto on = marker.objects.of(references);
      for (std::size_t k = 0; k < on.size(); ++k)
        f(static_cast<std::size_t>(on[k]), MarkerSeat{static_cast<int>(m), static_cast<int>(k)});
      if (marker.object < 0 && marker.node >= 0)
        f(objects.size() + static_cast<std::size_t>(marker.node), MarkerSeat{static_cast<int>(m), 0});
    }
  };
  if (seats_end.empty()) {
    seats_end.assign(objects.size() + nodes.size() + 1, 0);
    each_seat([&](std::size_t owner, const MarkerSeat&) { ++seats_end[owner + 1]; });
    std::partial_sum(seats_end.begin(), seats_end.end(), seats_end.begin());
    seats.resize(seats_end.back());
    each_seat([&](std::size_t owner, const MarkerSeat& seat) { seats[seats_end[owner]++] = seat; });
  }
  const std::size_t owner = static_cast<std::size_t>(number) + (kind == ItemKind::node ? objects.size() : 0);
  const std::uint32_t first = owner == 0 ? 0 : seats_end[owner - 1];
  return std::span(seats).subspan(first, seats_end[owner] - first);
}

std::uint64_t System::renewed_constraints() {
  if (late_ != nullptr) refresh(*late_);
  return renewed_constraints_;
}

void System::refresh(const Model& model) {
  SystemParts& parts = *parts_;
  if (std::exchange(late_, nullptr) != nullptr && parts.structure == model.structure_changes())
    for (const auto& [load, coordinates] : model.load_dependencies()) add_load_dependencies(load, coordinates);
  if (!assembled_ || parts.structure != model.structure_changes() || parts.values == model.value_changes()) return;
  const auto known = model.changed_since(parts.values);
  const std::vector<ItemChange> all = known ? std::vector<ItemChange>() : all_items(model);
  const std::span<const ItemChange> changed = known ? *known : std::span<const ItemChange>(all);
  model.check(changed);
  static thread_local Placement memory;  // of the last refresh
  Placing placing(parts, std::move(memory));
  for (const ItemChange& change : changed) check_change(parts, model, placing, change);
  ports_hold(nullptr);
  parts.plan.resting_evaluated = false;
  const auto complete = [&](ObjectPlace& place, int number) {
    const auto& physics = static_cast<const ObjectPhysics&>(*place.type->physics);
    if (physics.completes())
      place.record =
          physics.completed(place.record.get(), placing.of_object(number), {model, ItemKind::object, number});
  };
  // Whether a load is constant depends on how its marker passes it on.
  const auto renew_markers = [&](std::span<const MarkerSeat> seats, const auto& renew) {
    static thread_local std::vector<char> before, after;
    const auto find_ways = [&](std::vector<char>& ways) {
      ways.clear();
      if (parts.loads.empty()) return;
      for (const MarkerSeat& seat : seats) {
        const auto& [batch, entry] = parts.markers[static_cast<std::size_t>(seat.marker)].member;
        for (const bool of_moments : {false, true}) ways.push_back(batch->passes_constantly(entry, of_moments) ? 1 : 0);
      }
    };
    find_ways(before);
    for (const MarkerSeat& seat : seats) renew(parts.markers[static_cast<std::size_t>(seat.marker)], seat.which);
    find_ways(after);
    if (before != after) parts.loads_are_sorted = false;
  };
  const auto tell_markers = [&](ItemKind kind, int number, const void* record) {
    renew_markers(parts.markers_on(kind, number), [&](const MarkerPlace& marker, int which) {
      marker.member.batch->refresh_owners(marker.member.entry, which, record);
    });
  };
  const auto passed_record = [](const MarkerPlace& marker, Vec3<double>& local) {
    FrameShape shape{};
    const bool frame =
        static_cast<const MarkerPhysics*>(marker.type->physics)->passes_frame(shape, local, marker.record.get());
    return frame ? static_cast<const void*>(&local) : marker.record.get();
  };
  // Items on a ground node have read its position.
  const auto move_resting = [&](int node) {
    parts.loads_are_sorted = false;
    for (std::size_t k = 0; k < parts.objects.size(); ++k) {
      const ObjectPlace& place = parts.objects[k];
      if (std::ranges::find(place.nodes.of(parts.references), node) == place.nodes.of(parts.references).end()) continue;
      const int object = static_cast<int>(k);
      place.member.batch->refresh_resting(place.member.entry, place.record.get(), placing.of_object(object));
      for (const auto& [number, which] : parts.markers_on(ItemKind::object, object)) {
        const MarkerPlace& marker = parts.markers[static_cast<std::size_t>(number)];
        Vec3<double> local;
        const void* record = passed_record(marker, local);
        marker.member.batch->refresh_resting(marker.member.entry, record, placing.of_marker(number, marker));
      }
    }
  };
  const auto renew = [&](ItemKind kind, int number, const Row* row) {
    const auto& record = model.item(kind, number).record;
    const auto i = static_cast<std::size_t>(number);
    switch (kind) {
      case ItemKind::node:  // its reference and initial values need another assembling, unless it rests
        parts.nodes[i].record = record;
        if (parts.nodes[i].sizes.ode2 > 0) break;
        tell_markers(kind, number, record.get());
        move_resting(number);
        break;
      case ItemKind::object:
        ++renewed_objects_;
        if (parts.objects[i].equations > 0) ++renewed_constraints_;
        parts.objects[i].record = record;
        complete(parts.objects[i], number);
        refresh_entry(*parts.objects[i].member.batch, parts.objects[i].member.entry, parts.objects[i].record.get(),
                      row);
        parts.look_for_functions(parts.objects[i]);
        tell_markers(kind, number, parts.objects[i].record.get());
        break;
      case ItemKind::marker: {
        parts.markers[i].record = record;
        const MarkerSeat seat{number, 0};
        renew_markers({&seat, 1}, [&](const MarkerPlace& marker, int) {
          Vec3<double> local;
          marker.member.batch->refresh(marker.member.entry, passed_record(marker, local));
        });
        break;
      }
      case ItemKind::load:
        if (has_user_function(*parts.loads[i].type, record.get()) !=
            has_user_function(*parts.loads[i].type, parts.loads[i].record.get()))
          parts.loads_are_sorted = false;
        parts.loads[i].record = record;
        parts.loads[i].member.batch->refresh(parts.loads[i].member.entry, record.get());
        parts.look_for_functions(parts.loads[i]);
        refresh_load_dependency(parts, number);
        break;
      case ItemKind::sensor: parts.sensors[i] = parts.place_sensor(model.item(kind, number)); break;
    }
  };
  for (const ItemChange& change : changed) renew(change.kind, change.number, change.row);
  memory = std::move(placing.last());
  parts.values = model.value_changes();
  if (!parts.loads_are_sorted) sort_loads(parts);
  parts.knows_needed_markers = false;
}

std::vector<std::pair<int, std::shared_ptr<const void>>> System::completed_records() const {
  std::vector<std::pair<int, std::shared_ptr<const void>>> records;
  for (const int number : parts_->completed)
    records.emplace_back(number, parts_->objects[static_cast<std::size_t>(number)].record);
  return records;
}

bool System::renew_sensors(const Model& model) {
  SystemParts& parts = *parts_;
  if (!assembled_ || parts.equations != model.equation_changes()) return false;
  model.check();
  std::vector<SensorPlace> sensors;
  for (const Item& item : model.items(ItemKind::sensor)) sensors.push_back(parts.place_sensor(item));
  sensors.swap(parts.sensors);
  try {
    parts.check_sensors();
  } catch (...) {
    sensors.swap(parts.sensors);
    throw;
  }
  auto& names = parts.given_names[static_cast<std::size_t>(ItemKind::sensor)];
  names.clear();
  for (const auto& [name, number] : model.names(ItemKind::sensor)) names.emplace(number, name);
  parts.structure = model.structure_changes();
  return true;
}

bool System::constant_mass_matrix() const {
  return std::ranges::none_of(parts_->terms,
                              [](const auto& term) { return term->has_mass() && !term->constant_mass(); });
}
bool System::has_lie_nodes() const { return !parts_->lie_blocks.empty(); }
std::span<const System::LieBlock> System::lie_blocks() const { return parts_->lie_blocks; }
std::span<const double> System::static_signs() const { return parts_->static_signs; }
bool System::has_discontinuities(const Conditions& conditions) const {
  if (parts_->has_history || (parts_->has_direct_history && !conditions.direct)) return true;
  return std::ranges::any_of(parts_->system_terms, [](const SystemTerm* term) { return term->has_history_of_steps(); });
}
bool System::has_switches() const { return parts_->has_switches; }

namespace {

int count_of(const Sizes& sizes, System::Coordinates kind) {
  return std::array{sizes.ode2, sizes.ode1, sizes.ae, sizes.data}[static_cast<std::size_t>(kind)];
}

}  // namespace

void SystemParts::list_coordinates(const ObjectPlace& object, System::Coordinates kind, std::vector<int>& list) const {
  list.clear();
  for (const int n : object.nodes.of(references))
    append_range(list, nodes[n].first(kind), count_of(nodes[n].sizes, kind));
  if (kind == System::Coordinates::ae) append_range(list, object.first_ae, object.equations);
  if (kind == System::Coordinates::ode2)
    for (const int marker : object.markers.of(references)) {
      const auto dofs = ports.marker_dofs(marker);
      list.insert(list.end(), dofs.begin(), dofs.end());
    }
}

std::vector<int> System::object_ltg(int object, Coordinates kind) const {
  std::vector<int> list;
  parts_->list_coordinates(parts_->objects.at(static_cast<std::size_t>(object)), kind, list);
  return list;
}

int System::node_index(int node, Coordinates kind) const {
  return parts_->nodes.at(static_cast<std::size_t>(node)).first(kind);
}

std::vector<int> System::node_ltg(int node, Coordinates kind) const {
  std::vector<int> ltg;
  append_range(ltg, node_index(node, kind), count_of(parts_->nodes[static_cast<std::size_t>(node)].sizes, kind));
  return ltg;
}

const ItemType& SystemParts::type_of(ItemKind kind, int number) const {
  const auto i = static_cast<std::size_t>(number);
  switch (kind) {
    case ItemKind::node: return *nodes[i].type;
    case ItemKind::object: return *objects[i].type;
    case ItemKind::marker: return *markers[i].type;
    case ItemKind::load: return *loads[i].type;
    case ItemKind::sensor: break;
  }
  return *sensors[i].type;
}

std::string SystemParts::describe(ItemKind kind, int number) const {
  const auto& entitled = titles[static_cast<std::size_t>(kind)];
  if (const auto title = entitled.find(number); title != entitled.end()) return title->second;
  const auto& names = given_names[static_cast<std::size_t>(kind)];
  const auto name = names.find(number);
  return describe_item(kind, number, name == names.end() ? "" : name->second, type_of(kind, number));
}

std::string System::describe_row(int row) const {
  const SystemParts& parts = *parts_;
  const auto within = [](int index, int first, int count) {
    return first >= 0 && index >= first && index < first + count;
  };
  const bool algebraic = row >= sizes_.first_ae(), ode1 = !algebraic && row >= sizes_.ode2;
  const int index = algebraic ? row - sizes_.first_ae() : ode1 ? row - sizes_.ode2 : row;
  for (std::size_t i = 0; i < parts.nodes.size(); ++i) {
    const NodePlace& n = parts.nodes[i];
    const int first = algebraic ? n.ae : ode1 ? n.ode1 : n.ode2;
    const int count = algebraic ? n.sizes.ae : ode1 ? n.sizes.ode1 : n.sizes.ode2;
    if (within(index, first, count))
      return parts.describe(ItemKind::node, static_cast<int>(i)) + (algebraic ? ", equation " : ", coordinate ") +
             std::to_string(index - first);
  }
  for (std::size_t i = 0; i < parts.objects.size(); ++i) {
    const ObjectPlace& object = parts.objects[i];
    if (algebraic && within(index, object.first_ae, object.equations))
      return parts.describe(ItemKind::object, static_cast<int>(i)) + ", equation " +
             std::to_string(index - object.first_ae);
  }
  return "row " + std::to_string(row);
}

std::vector<System::EquationOwner> System::equation_owners() const {
  const SystemParts& parts = *parts_;
  std::vector<EquationOwner> owners;
  const auto add = [&](bool of_node, std::size_t i, int first, int count) {
    if (first >= 0 && count > 0) owners.push_back({of_node, static_cast<int>(i), first, count});
  };
  for (std::size_t i = 0; i < parts.nodes.size(); ++i) add(true, i, parts.nodes[i].ae, parts.nodes[i].sizes.ae);
  for (std::size_t i = 0; i < parts.objects.size(); ++i)
    add(false, i, parts.objects[i].first_ae, parts.objects[i].equations);
  std::ranges::sort(owners, {}, &EquationOwner::first);
  return owners;
}

void System::reactions_are_known(std::span<const int> not_unique) {
  parts_->not_unique.assign(static_cast<std::size_t>(sizes_.ae), 0);
  for (const int k : not_unique) parts_->not_unique[static_cast<std::size_t>(k)] = 1;
}

void System::reactions_are_unknown() { parts_->not_unique.clear(); }

std::string System::describe(const EquationOwner& owner) const {
  return parts_->describe(owner.of_node ? ItemKind::node : ItemKind::object, owner.number);
}

}  // namespace dalembert
