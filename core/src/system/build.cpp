// From a model to batches: numbers the coordinates, places every item, collects items of one kind side by side.
#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/system/parts.hpp"

namespace dalembert {
namespace {

constexpr std::size_t of(System::Coordinates kind) { return static_cast<std::size_t>(kind); }

void append_range(std::vector<int>& list, int first, int count) {
  for (int i = 0; i < count; ++i) list.push_back(first + i);
}

// Numbers that an item's parameters name, of one kind, in the order of the spec.
std::vector<int> referenced(const Item& item, ItemKind kind) {
  std::vector<int> numbers;
  for (const Row& row : item.type->rows) {
    const IndexStorage storage = index_storage(row.storage);
    if (!storage.is_index || storage.kind != kind || row.role != Role::parameter) continue;
    for (const int number : index_values(row, item.record.get()))
      if (number >= 0) numbers.push_back(number);
  }
  return numbers;
}

class Builder {
 public:
  Builder(SystemParts& parts, const Model& model) : parts_(parts), model_(model) {}

  void run() {
    name_items();
    place_nodes();
    for (int i = 0; i < model_.count(ItemKind::object); ++i) register_object(i);
    for (int i = 0; i < model_.count(ItemKind::marker); ++i) place_marker(i);
    number_constraints();
    for (int i = 0; i < model_.count(ItemKind::object); ++i) place_object(i);
    place_node_conditions();
    for (int i = 0; i < model_.count(ItemKind::load); ++i) place_load(i);
    for (const Item& item : model_.items(ItemKind::sensor)) parts_.sensors.push_back({item.type, sensor_reader(*item.type), item.record});
    for (const auto& term : parts_.terms) {
      if (term->has_mass()) parts_.constant_mass = parts_.constant_mass && term->constant_mass();
      parts_.has_history = parts_.has_history || term->has_history();
    }
    for (const auto& batch : parts_.marker_batches) parts_.has_history = parts_.has_history || batch->has_history();
    make_plan();
    parts_.structure = model_.structure_changes();
    parts_.values = model_.value_changes();
  }

 private:
  using TypeList = std::vector<const ItemType*>;

  // Terms without an acting entry are left out: ground.
  void make_plan() {
    std::set<const Batch*> loads;
    for (const LoadPlace& load : parts_.loads) loads.insert(load.member.batch);
    EvaluationPlan& plan = parts_.plan;
    for (const auto& batch : parts_.marker_batches)
      (acting_.contains(batch.get()) ? plan.moving : plan.resting).push_back(batch.get());
    for (const MarkerBatch* batch : plan.moving)
      if (differentiated_.contains(batch) || batch->geometric_follows_tangent()) plan.differentiated.push_back(batch);
    for (const auto& term : parts_.terms)
      if (acting_.contains(term.get())) (loads.contains(term.get()) ? plan.loads : plan.terms).push_back(term.get());
  }
  static bool has_coordinates(const Placement& p) {
    return !p.dofs.empty() || !p.ode1.empty() || p.data_count > 0 || p.first_ae >= 0;
  }
  void enter(Batch& batch, const void* record, const Placement& p, bool acts) {
    if (acts) acting_.insert(&batch);
    batch.add(record, p, parts_.ports);
  }
  void enter_term(Term& term, const void* record, const Placement& p) {
    enter(term, record, p, has_coordinates(p) || !p.markers.empty());
    if (!term.has_tangent()) return;
    for (const int marker : p.markers) differentiated_.insert(parts_.markers[marker].member.batch);
  }

  void name_items() {
    for (int k = 0; k < item_kinds; ++k)
      for (int i = 0; i < model_.count(static_cast<ItemKind>(k)); ++i)
        parts_.given_names[k].push_back(model_.items(static_cast<ItemKind>(k))[i].name);
  }

  const Physics& physics(ItemKind kind, int number) const {
    const Item& item = model_.item(kind, number);
    if (item.type->physics == nullptr)
      refuse(ErrorKind::planned, {model_.describe(kind, number), "", "the physics of this item type is planned, not there yet", "",
                                  "", "Remove the item; its spec is " + std::string(item.type->spec)});
    return *item.type->physics;
  }

  void place_nodes() {
    for (int i = 0; i < model_.count(ItemKind::node); ++i) {
      const Item& item = model_.item(ItemKind::node, i);
      NodePlace place{item.type, &dynamic_cast<const NodePhysics&>(physics(ItemKind::node, i)), item.record, {}};
      place.sizes = place.physics->sizes(item.record.get());
      place.translations = place.physics->translations();
      const auto take = [](int& next, int count) { return count == 0 ? -1 : std::exchange(next, next + count); };
      place.ode2 = take(parts_.sizes.ode2, place.sizes.ode2);
      place.ode1 = take(parts_.sizes.ode1, place.sizes.ode1);
      place.ae = take(parts_.sizes.ae, place.sizes.ae);
      place.data = take(parts_.sizes.data, place.sizes.data);
      if (place.sizes.ode2 > 0) {
        NodeValues values;
        place.physics->values(item.record.get(), values);
        reference_.insert(reference_.end(), values.reference.begin(), values.reference.end());
      }
      place.rotation = place_rotation(place);
      if (place.physics->lie_rotation() >= 0) parts_.lie_blocks.push_back({place.ode2 + place.physics->lie_rotation()});
      parts_.nodes.push_back(std::move(place));
    }
  }

  int place_rotation(const NodePlace& node) {
    auto [batch, is_new] = rotations_.try_emplace(node.type, nullptr);
    if (is_new) {
      if (auto made = node.physics->make_rotations(); made != nullptr)
        batch->second = parts_.rotation_batches.emplace_back(std::move(made)).get();
    }
    if (batch->second == nullptr) return -1;
    std::vector<int> dofs;
    append_range(dofs, node.ode2, node.sizes.ode2);
    return batch->second->add(dofs, parts_.ports);
  }

  // An object's nodes and markers, before its markers' coordinates are known.
  void register_object(int number) {
    const Item& item = model_.item(ItemKind::object, number);
    physics(ItemKind::object, number);
    ObjectPlace place{item.type, item.record, {}, {}, referenced(item, ItemKind::node), referenced(item, ItemKind::marker)};
    for (const int n : place.nodes) {
      const NodePlace& node = parts_.nodes[n];
      append_range(place.ltg[of(System::Coordinates::ode2)], node.ode2, node.sizes.ode2);
      append_range(place.ltg[of(System::Coordinates::ode1)], node.ode1, node.sizes.ode1);
      append_range(place.ltg[of(System::Coordinates::ae)], node.ae, node.sizes.ae);
      append_range(place.ltg[of(System::Coordinates::data)], node.data, node.sizes.data);
    }
    parts_.objects.push_back(std::move(place));
  }

  TypeList node_types(const std::vector<int>& nodes) const {
    TypeList types;
    for (const int n : nodes) types.push_back(parts_.nodes[n].type);
    return types;
  }

  Placement placement_on(const std::vector<int>& nodes) const {
    Placement p;
    p.nodes = nodes;
    p.ae_offset = sizes_total_before_ae();
    p.ode1_offset = parts_.sizes.ode2;
    if (nodes.size() == 1) p.rotation = parts_.nodes[nodes.front()].rotation;
    for (const int n : nodes) {
      const NodePlace& node = parts_.nodes[n];
      append_range(p.dofs, node.ode2, node.sizes.ode2);
      append_range(p.ode1, node.ode1, node.sizes.ode1);
      p.node_sizes.push_back(node.sizes.ode2);
      p.node_records.push_back(node.record.get());
      if (node.sizes.data > 0) {
        p.first_data = node.data;
        p.data_count = node.sizes.data;
      }
      if (node.sizes.ode2 > 0)
        p.reference.insert(p.reference.end(), reference_.begin() + node.ode2, reference_.begin() + node.ode2 + node.sizes.ode2);
    }
    return p;
  }
  int sizes_total_before_ae() const { return parts_.sizes.ode2 + parts_.sizes.ode1; }

  void place_marker(int number) {
    const Item& item = model_.item(ItemKind::marker, number);
    const auto& physics = dynamic_cast<const MarkerPhysics&>(this->physics(ItemKind::marker, number));
    const std::vector<int> nodes = referenced(item, ItemKind::node), objects = referenced(item, ItemKind::object);
    MarkerPlace place{item.type, item.record, {}, -1, -1, objects};
    if (!objects.empty()) place.object = objects.front();
    if (!nodes.empty()) place.node = nodes.front();
    Placement p = placement_under(objects, nodes);
    p.item = number;
    p.markers = {number};
    const TypeList types = node_types(p.nodes);
    FrameShape shape{};
    Vec3<double> local;
    const void* record = item.record.get();
    p.owner = place.object >= 0 ? parts_.objects[place.object].record.get() : parts_.nodes[place.node].record.get();
    p.owner_type = place.object >= 0 ? parts_.objects[place.object].type : parts_.nodes[place.node].type;
    physics.check(record, p, parts_.ports, model_.describe(ItemKind::marker, number));
    if (physics.passes_frame(shape, local, record)) {
      record = &local;
      place.member.batch = &frame_batch(number, place, shape, types);
    } else {
      const std::vector<int> chosen = physics.coordinates(record, p);
      p.dofs = selected(p.dofs, chosen, number);
      p.selected = static_cast<int>(chosen.size());
      place.member.batch =
          &marker_batch({item.type, p.owner_type, types}, [&] { return physics.make_batch(*p.owner_type, types); }, number);
    }
    MarkerBatch& batch = *place.member.batch;
    place.member.entry = entries_[&batch]++;
    parts_.ports.append(batch.value_count(record, p), batch.force_count(record, p), p.dofs, batch.translations());
    enter(batch, record, p, has_coordinates(p));
    parts_.markers.push_back(std::move(place));
  }

  // What a marker's objects and nodes stand on, one after the other.
  Placement placement_under(const std::vector<int>& objects, const std::vector<int>& nodes) const {
    std::vector<int> all;
    for (const int o : objects) all.insert(all.end(), parts_.objects[o].nodes.begin(), parts_.objects[o].nodes.end());
    all.insert(all.end(), nodes.begin(), nodes.end());
    Placement p = placement_on(all);
    for (const int o : objects) {
      const ObjectPlace& object = parts_.objects[o];
      p.owners.push_back({object.type, object.record.get(), node_types(object.nodes), 0});
      for (const int n : object.nodes) p.owners.back().dofs += parts_.nodes[n].sizes.ode2;
    }
    return p;
  }

  MarkerBatch& frame_batch(int number, const MarkerPlace& place, FrameShape shape, const TypeList& types) {
    if (place.object >= 0) {
      const ObjectPlace& object = parts_.objects[place.object];
      const auto* owner = dynamic_cast<const ObjectPhysics*>(object.type->physics);
      return marker_batch({tag(shape), object.type, types}, [&] { return owner->make_marker(shape, types); }, number);
    }
    const NodePlace& node = parts_.nodes[place.node];
    return marker_batch({tag(shape), node.type, types}, [&] { return node.physics->make_marker(shape); }, number);
  }

  // Frame markers of one shape share batches whatever their type: the shape stands in for the type in the key.
  static const void* tag(FrameShape shape) {
    static constexpr char tags[3] = {};
    return &tags[static_cast<int>(shape)];
  }

  std::vector<int> selected(const std::vector<int>& dofs, const std::vector<int>& chosen, int number) const {
    std::vector<int> r;
    for (const int i : chosen) {
      if (i < 0 || i >= static_cast<int>(dofs.size())) {
        if (dofs.empty()) continue;  // coordinates of ground: none, they rest
        refuse(ErrorKind::value, {model_.describe(ItemKind::marker, number), "coordinate", "", std::to_string(i),
                                  "a coordinate from 0 to " + std::to_string(static_cast<int>(dofs.size()) - 1), ""});
      }
      r.push_back(dofs[i]);
    }
    return r;
  }

  using Key = std::tuple<const void*, const ItemType*, TypeList>;

  MarkerBatch& marker_batch(const Key& key, const std::function<std::unique_ptr<MarkerBatch>()>& make, int number) {
    auto& batch = marker_batches_[key];
    if (batch == nullptr) {
      auto made = make();
      if (made == nullptr) refuse_combination(ItemKind::marker, number, std::get<1>(key)->name, std::get<2>(key));
      parts_.marker_batches.push_back(std::move(made));
      batch = parts_.marker_batches.back().get();
    }
    return *batch;
  }
  Term& term(const Key& key, const std::function<std::unique_ptr<Term>()>& make, ItemKind kind, int number) {
    auto& batch = terms_[key];
    if (batch == nullptr) {
      auto made = make();
      if (made == nullptr) refuse_combination(kind, number, std::get<1>(key)->name, std::get<2>(key));
      parts_.terms.push_back(std::move(made));
      batch = parts_.terms.back().get();
    }
    return *batch;
  }
  [[noreturn]] void refuse_combination(ItemKind kind, int number, std::string_view on, const TypeList& types) const {
    std::string nodes;
    for (const ItemType* type : types) nodes += (nodes.empty() ? "" : ", ") + std::string(type->name);
    refuse(ErrorKind::value, {model_.describe(kind, number), "", "this combination is not available: " + std::string(on) +
                              (nodes.empty() ? "" : " with " + nodes), "", "", "See the pages of these items for what they accept"});
  }

  // Multipliers of the constraints follow those of the nodes.
  void number_constraints() {
    for (int i = 0; i < static_cast<int>(parts_.objects.size()); ++i) {
      ObjectPlace& place = parts_.objects[i];
      for (const int marker : place.markers) {
        const auto dofs = parts_.ports.marker_dofs(marker);
        auto& ltg = place.ltg[of(System::Coordinates::ode2)];
        ltg.insert(ltg.end(), dofs.begin(), dofs.end());
      }
      const auto& physics = dynamic_cast<const ObjectPhysics&>(*place.type->physics);
      std::vector<int> marker_coordinates;
      for (const int marker : place.markers) marker_coordinates.push_back(parts_.ports.ports[marker].forces);
      const int equations = physics.algebraic_equations(place.record.get(), marker_coordinates);
      append_range(place.ltg[of(System::Coordinates::ae)], parts_.sizes.ae, equations);
      parts_.sizes.ae += equations;
      first_ae_.push_back(equations == 0 ? -1 : parts_.sizes.ae - equations);
    }
  }

  void place_object(int number) {
    ObjectPlace& place = parts_.objects[number];
    const auto& physics = dynamic_cast<const ObjectPhysics&>(*place.type->physics);
    Placement p = placement_on(place.nodes);
    p.item = number;
    p.markers = place.markers;
    p.first_ae = first_ae_[number];
    for (const int marker : place.markers)
      if (!dynamic_cast<const MarkerPhysics&>(*parts_.markers[marker].type->physics).has_rate())
        refuse(ErrorKind::value, {model_.describe(ItemKind::object, number), "markerNumbers", model_.describe(ItemKind::marker, marker) + " gives no velocity", "",
                                  "markers on coordinates of second order", "Markers on coordinates of first order take loads only"});
    physics.check(place.record.get(), p, parts_.ports, model_.describe(ItemKind::object, number));
    const TypeList types = node_types(place.nodes);
    place.member.batch = &term({place.type, place.type, types}, [&] { return physics.make_batch(types); }, ItemKind::object, number);
    place.member.entry = entries_[place.member.batch]++;
    enter_term(*place.member.batch, place.record.get(), p);
  }

  void place_node_conditions() {
    for (int i = 0; i < static_cast<int>(parts_.nodes.size()); ++i) {
      const NodePlace& node = parts_.nodes[i];
      if (node.sizes.ae == 0) continue;
      Placement p = placement_on({i});
      p.item = i;
      p.first_ae = node.ae;
      Term& batch = term({node.type, node.type, {}}, [&] { return node.physics->make_condition(); }, ItemKind::node, i);
      enter_term(batch, node.record.get(), p);
    }
  }

  void place_load(int number) {
    const Item& item = model_.item(ItemKind::load, number);
    const auto& physics = dynamic_cast<const LoadPhysics&>(this->physics(ItemKind::load, number));
    LoadPlace place{item.type, item.record, {}};
    Placement p;
    p.item = number;
    p.markers = referenced(item, ItemKind::marker);
    const bool fixed = physics.body_fixed(item.record.get());
    const void* variant = fixed ? static_cast<const void*>(&physics) : item.type;
    place.member.batch = &term({variant, item.type, {}}, [&] { return physics.make_batch(fixed); }, ItemKind::load, number);
    place.member.entry = entries_[place.member.batch]++;
    place.marker = p.markers.front();
    enter_term(*place.member.batch, item.record.get(), p);
    parts_.loads.push_back(std::move(place));
  }

  SystemParts& parts_;
  const Model& model_;
  std::map<Key, MarkerBatch*> marker_batches_;
  std::map<Key, Term*> terms_;
  std::map<const ItemType*, RotationBatch*> rotations_;
  std::map<const Batch*, int> entries_;
  std::set<const Batch*> acting_, differentiated_;
  std::vector<int> first_ae_;
  std::vector<double> reference_;  // of the ODE2 coordinates
};

// Copy a node's own values into a stretch of a system vector.
void put(std::vector<double>& into, int first, const std::vector<double>& values) {
  if (first >= 0) std::copy(values.begin(), values.end(), into.begin() + first);
}

void set_configurations(SystemParts& parts) {
  State blank;
  blank.q.assign(parts.sizes.ode2, 0);
  blank.v = blank.a = blank.q;
  blank.y.assign(parts.sizes.ode1, 0);
  blank.y_t = blank.y;
  blank.lambda.assign(parts.sizes.ae, 0);
  blank.data.assign(parts.sizes.data, 0);
  parts.states.fill(blank);
  State& reference = parts.state(ConfigurationType::Reference);
  State& initial = parts.state(ConfigurationType::Initial);
  for (const NodePlace& node : parts.nodes) {
    NodeValues values;
    node.physics->values(node.record.get(), values);
    put(reference.q, node.ode2, values.reference);
    put(initial.q, node.ode2, values.displacement);
    put(initial.v, node.ode2, values.velocity);
    put(reference.y, node.ode1, values.reference_ode1);
    put(initial.y, node.ode1, values.ode1);
    put(initial.lambda, node.ae, values.algebraic);
    put(initial.data, node.data, values.data);
  }
  for (const ConfigurationType c : {ConfigurationType::Current, ConfigurationType::StartOfStep, ConfigurationType::Visualization})
    parts.state(c) = initial;
}

}  // namespace

void build(SystemParts& parts, const Model& model) {
  Builder(parts, model).run();
  make_load_dependencies(parts);
  set_configurations(parts);
}

}  // namespace dalembert
