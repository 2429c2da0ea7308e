// Assembly of batches from a model: numbers the coordinates, places every item, collects items of one kind.
#include <algorithm>
#include <limits>
#include <utility>

#include "batch_table.hpp"
#include "dalembert/batches/turned_marker.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/system/parts.hpp"
#include "naming_rows.hpp"
#include "placing.hpp"
#include "plan.hpp"
#include "start_values.hpp"

namespace dalembert {
namespace {

// Numbers of items by type, of which there are few.
class TypeCounts {
 public:
  void add(const ItemType* type) { ++counts_[place_of(type)].second; }
  int of(const ItemType* type) { return counts_[place_of(type)].second; }
  const std::vector<std::pair<const ItemType*, int>>& all() const { return counts_; }

 private:
  std::size_t place_of(const ItemType* type) {
    if (last_ < counts_.size() && counts_[last_].first == type) return last_;  // neighbours are mostly of one type
    last_ = static_cast<std::size_t>(std::ranges::find(counts_, type, &std::pair<const ItemType*, int>::first) -
                                     counts_.begin());
    if (last_ == counts_.size()) counts_.emplace_back(type, 0);
    return last_;
  }

  std::vector<std::pair<const ItemType*, int>> counts_;
  std::size_t last_ = 0;
};

class Builder {
 public:
  Builder(SystemParts& parts, const Model& model, const Division& division)
      : parts_(parts), model_(model), division_(division) {}

  void run() {
    reserve();
    name_items();
    divide();
    make_room_for_numbers();
    for (int i = 0; i < model_.count(ItemKind::node); ++i) place_node(i);
    for (int i = 0; i < model_.count(ItemKind::object); ++i) register_object(i);
    for (int i = 0; i < model_.count(ItemKind::marker); ++i) place_marker(i);
    number_constraints();
    for (int i = 0; i < model_.count(ItemKind::object); ++i) place_object(i);
    place_node_conditions();
    for (int i = 0; i < model_.count(ItemKind::load); ++i) place_load(i);
    for (const Item& item : model_.items(ItemKind::sensor)) parts_.sensors.push_back(parts_.place_sensor(item));
    for (const auto& term : parts_.terms) parts_.has_history = parts_.has_history || term->has_history();
    for (const auto& term : parts_.terms) parts_.has_switches = parts_.has_switches || term->has_switches();
    for (const auto& batch : parts_.marker_batches) parts_.has_history = parts_.has_history || batch->has_history();
    numbers_of(Regions::whole).rows.add(parts_.sizes.ode2, parts_.sizes.ode1);
    differentiated_.sort();
    parts_.division = division_;
    make_plan(parts_, {marker_batches_, terms_, rotating_, differentiated_}, division_);
    complete_configurations(parts_);
    parts_.structure = model_.structure_changes();
    parts_.equations = model_.equation_changes();
    parts_.values = model_.value_changes();
    parts_.records = model_.record_changes();
    memory_ = std::move(placing_.last());
  }

 private:
  void reserve() {
    const auto make_room = [&](auto& places, ItemKind kind) {
      places.reserve(static_cast<std::size_t>(model_.count(kind)));
    };
    make_room(parts_.nodes, ItemKind::node);
    make_room(parts_.objects, ItemKind::object);
    make_room(parts_.markers, ItemKind::marker);
    make_room(parts_.ports.ports, ItemKind::marker);
    make_room(parts_.loads, ItemKind::load);
    make_room(parts_.sensors, ItemKind::sensor);
    for (int k = 0; k < item_kinds; ++k)
      for (const Item& item : model_.items(static_cast<ItemKind>(k))) counts_.add(item.type);
    parts_.others_take_functions = std::ranges::any_of(counts_.all(), [](const auto& counted) {
      const ItemType& type = *counted.first;
      const auto is_function = [](const Row& row) { return row.storage == Storage::user_function; };
      return (type.kind == ItemKind::node || type.kind == ItemKind::object) &&
             std::ranges::any_of(type.rows, is_function);
    });
  }

  // Growing vectors item by item would copy them, and take twice their memory. The memory of markers is not yet
  // known: this estimate is right for points.
  void make_room_for_numbers() {
    const auto make_room = [](auto& list, int count) { list.reserve(static_cast<std::size_t>(count)); };
    const int markers = model_.count(ItemKind::marker), objects = model_.count(ItemKind::object);
    make_room(parts_.references, objects + markers + model_.count(ItemKind::load));
    start_values_.make_room(node_sizes_, parts_);
    make_room(parts_.ports.values, 6 * markers);
    make_room(parts_.ports.forces, 4 * markers);
    make_room(parts_.ports.dofs, 3 * markers);
    make_room(marker_regions_, markers);
  }

  static bool has_coordinates(const Placement& p) {
    return !p.dofs.empty() || !p.ode1.empty() || p.data_count > 0 || p.first_ae >= 0;
  }
  // Returns the place of the entry in its batch.
  int enter_term(GrowingBatch<Term>& growing, const void* record, const Placement& p) {
    growing.acts = growing.acts || has_coordinates(p) || !p.markers.empty();
    growing.batch->add(record, p, parts_.ports);
    if (growing.batch->has_tangent())
      for (const int marker : p.markers) differentiated_.add(parts_.markers[marker].member.batch);
    return growing.entries++;
  }

  void divide() {
    node_sizes_.reserve(parts_.nodes.capacity());
    std::int64_t sum = 0;
    for (const Item& item : model_.items(ItemKind::node)) {
      const int number = static_cast<int>(node_sizes_.size());
      const Sizes& n = node_sizes_.emplace_back(physics<NodePhysics>(item, number).sizes(item.record.get()));
      sum += std::int64_t{n.ode2} + n.ode1 + n.ae + n.data;
      if (sum > std::numeric_limits<int>::max())
        refuse(
            ErrorKind::value,
            {model_.describe(ItemKind::node, number), "", "with its coordinates the system has " + std::to_string(sum),
             "", "at most " + std::to_string(std::numeric_limits<int>::max()) + " coordinates of all kinds", ""});
    }
    regions_ = Regions(node_sizes_, division_.coordinates);
    parts_.plan.regions.resize(static_cast<std::size_t>(regions_.count()));
  }
  // Region of a placed item. Items that share coordinates other than ODE2 coordinates, or call user functions, come
  // last, on the thread of the solver.
  int region_of(ItemKind kind, int number) const {
    if (regions_.count() == 1) return Regions::whole;
    const Item& item = item_of(kind, number);
    if (has_user_function(*item.type, item.record.get())) return Regions::whole;
    int region = Regions::none;
    for (const int n : placement_.nodes) {
      const Sizes& sizes = parts_.nodes[n].sizes;
      if (sizes.ode1 > 0 || (sizes.ae > 0 && sizes.ode2 == 0)) return Regions::whole;
      region = Regions::around(region, regions_.of_node(n));
    }
    for (const int marker : placement_.markers)
      if (kind != ItemKind::marker) region = Regions::around(region, marker_regions_[marker]);
    return region;
  }

  RegionNumbers& numbers_of(int region) {
    return parts_.plan.regions[static_cast<std::size_t>(std::max(region, Regions::whole))].numbers;
  }

  void name_items() {
    for (int k = 0; k < item_kinds; ++k)
      for (const auto& [name, number] : model_.names(static_cast<ItemKind>(k)))
        parts_.given_names[k].emplace(number, name);
    parts_.titles = model_.titles();
  }

  const Item& item_of(ItemKind kind, int number) const { return model_.items(kind)[static_cast<std::size_t>(number)]; }

  // The kind of an item decides the class of its physics.
  template <class P>
  const P& physics(const Item& item, int number) const {
    if (item.type->physics == nullptr)
      refuse(ErrorKind::planned,
             {model_.describe(item.type->kind, number), "", "the physics of this item type is planned, not there yet",
              "", "", "Remove the item; its spec is " + std::string(item.type->spec)});
    return static_cast<const P&>(*item.type->physics);
  }
  static const ObjectPhysics& physics(const ObjectPlace& place) {
    return static_cast<const ObjectPhysics&>(*place.type->physics);
  }

  // Numbers that an item's parameters name, of one kind, in the order of the spec.
  Stretch refer(const Item& item, ItemKind kind) {
    static thread_local NamingRows naming_rows;  // types stay
    auto& numbers = parts_.references;
    Stretch named{static_cast<std::uint32_t>(numbers.size()), 0};
    for (const Row* row : naming_rows.of(*item.type, kind))
      for (const int number : index_values(*row, item.record.get()))
        if (number >= 0) numbers.push_back(number);
    named.count = static_cast<std::uint32_t>(numbers.size()) - named.first;
    return named;
  }

  void place_node(int number) {
    const Item& item = item_of(ItemKind::node, number);
    NodePlace place{item.type, &physics<NodePhysics>(item, number), item.record, {}};
    place.sizes = node_sizes_[static_cast<std::size_t>(number)];
    place.translations = place.physics->translations();
    const auto take = [](int& next, int count) { return count == 0 ? -1 : std::exchange(next, next + count); };
    place.ode2 = take(parts_.sizes.ode2, place.sizes.ode2);
    place.ode1 = take(parts_.sizes.ode1, place.sizes.ode1);
    place.ae = take(parts_.sizes.ae, place.sizes.ae);
    place.data = take(parts_.sizes.data, place.sizes.data);
    numbers_of(regions_.of_node(number)).coordinates.add(place.ode2, place.sizes.ode2);
    numbers_of(regions_.of_node(number)).rows.add(place.ode2, place.sizes.ode2);
    start_values_.take(place, parts_);
    place.rotating = place_rotating(place, number);
    if (place.physics->lie_rotation() >= 0) parts_.lie_blocks.push_back({place.ode2 + place.physics->lie_rotation()});
    parts_.nodes.push_back(std::move(place));
  }

  int place_rotating(const NodePlace& node, int number) {
    auto [batch, is_new] =
        rotating_.try_emplace({std::max(regions_.of_node(number), Regions::whole), node.type}, nullptr);
    if (is_new)
      if (auto made = node.physics->make_rotating(); made != nullptr) {
        batch->second = parts_.rotating_nodes.emplace_back(std::move(made)).get();
        make_room_for_rotating(counts_.of(node.type));
      }
    if (batch->second == nullptr) return -1;
    Placement p;
    append_range(p.dofs, node.ode2, node.sizes.ode2);
    p.rotating_node = static_cast<int>(parts_.ports.node_motions.size());
    numbers_of(regions_.of_node(number)).node_loads.add(p.rotating_node, 1);
    parts_.ports.add_rotating_node();
    batch->second->add(node.record.get(), p, parts_.ports);
    return p.rotating_node;
  }

  // Nodes of a type can be in several regions: there are no more than all nodes.
  void make_room_for_rotating(int count) {
    Ports& ports = parts_.ports;
    const std::size_t most =
        std::min(ports.node_motions.size() + static_cast<std::size_t>(count), parts_.nodes.capacity());
    ports.node_motions.reserve(most);
    ports.node_loads.reserve(most);
    ports.point_forces.reserve(most);
  }

  // An object's nodes and markers, before its markers' coordinates are known.
  void register_object(int number) {
    const Item& item = item_of(ItemKind::object, number);
    const auto& physics = this->physics<ObjectPhysics>(item, number);
    const Stretch nodes = refer(item, ItemKind::node), markers = refer(item, ItemKind::marker);
    parts_.objects.push_back({item.type, item.record, {}, nodes, markers});
    const bool has_markers = !markers.of(parts_.references).empty();
    if (has_markers && !physics.completes()) return;
    Placement& on_nodes = placing_.on(nodes.of(parts_.references));
    on_nodes.item = number;
    auto& record = parts_.objects.back().record;
    if (physics.completes()) {
      record = physics.completed(item.record.get(), on_nodes, {model_, ItemKind::object, number});
      parts_.completed.push_back(number);
    }
    if (!has_markers) check_object(number, on_nodes);  // checked before its markers read its parameters
  }

  void check_object(int number, const Placement& placement) {
    const ObjectPlace& place = parts_.objects[number];
    physics(place).check(place.record.get(), placement, parts_.ports, {model_, ItemKind::object, number});
  }

  void place_marker(int number) {
    const Item& item = item_of(ItemKind::marker, number);
    const auto& physics = this->physics<MarkerPhysics>(item, number);
    const Stretch named_nodes = refer(item, ItemKind::node), named_objects = refer(item, ItemKind::object);
    const auto nodes = named_nodes.of(parts_.references), objects = named_objects.of(parts_.references);
    MarkerPlace place{item.type, item.record, {}, -1, -1, named_objects};
    if (!objects.empty()) place.object = objects.front();
    if (!nodes.empty()) place.node = nodes.front();
    Placement& p = placing_.of_marker(number, place);
    FrameShape shape{};
    Vec3<double> local;
    const void* record = item.record.get();
    physics.check(record, p, parts_.ports, {model_, ItemKind::marker, number});
    marker_regions_.push_back(region_of(ItemKind::marker, number));
    const Row* const turn = row_of_turn(*item.type, record);
    const Mat3<double> rotation =
        turn == nullptr ? identity<double>() : *static_cast<const Mat3<double>*>(member(record, *turn));
    GrowingBatch<MarkerBatch>* growing = nullptr;
    if (physics.passes_frame(shape, local, record)) {
      record = &local;
      growing = &frame_batch(number, place, shape, p, turn != nullptr);
    } else {
      const std::vector<int> chosen = physics.coordinates(record, p);
      select(p, chosen, number);
      const auto make = [&] {
        return turned(physics.make_batch(*p.owner_type, placing_.node_types(p.nodes)), turn != nullptr);
      };
      const void* const variant = turn != nullptr ? static_cast<const void*>(turn) : item.type;
      growing = &batch_of(marker_batches_, variant, *p.owner_type, make, ItemKind::marker, number);
    }
    MarkerBatch& batch = *growing->batch;
    if (turn != nullptr) static_cast<TurnedMarkers&>(batch).next(rotation);
    const auto forces_before = static_cast<int>(parts_.ports.forces.size());
    parts_.ports.append(batch.value_count(record, p), batch.force_count(record, p), p.dofs, batch.translations());
    numbers_of(marker_regions_.back())
        .forces.add(forces_before, static_cast<int>(parts_.ports.forces.size()) - forces_before);
    growing->acts = growing->acts || has_coordinates(p);
    batch.add(record, p, parts_.ports);
    place.member = {&batch, growing->entries++};
    parts_.markers.push_back(std::move(place));
  }

  // The row of a marker's own rotation; nullptr if it does not turn its frame.
  static const Row* row_of_turn(const ItemType& type, const void* record) {
    const Row* row = find_row(type, "localRotation");
    return row == nullptr || *static_cast<const Mat3<double>*>(member(record, *row)) == identity<double>() ? nullptr
                                                                                                           : row;
  }
  static std::unique_ptr<MarkerBatch> turned(std::unique_ptr<MarkerBatch> batch, bool turns) {
    if (!turns || batch == nullptr) return batch;
    return std::make_unique<TurnedMarkers>(std::move(batch));
  }
  GrowingBatch<MarkerBatch>& frame_batch(int number, const MarkerPlace& place, FrameShape shape, const Placement& p,
                                         bool turns) {
    const auto make = [&] {
      return turned(place.object >= 0
                        ? physics(parts_.objects[place.object]).make_marker(shape, placing_.node_types(p.nodes))
                        : parts_.nodes[place.node].physics->make_marker(shape),
                    turns);
    };
    return batch_of(marker_batches_, tag(shape, turns), *p.owner_type, make, ItemKind::marker, number);
  }

  // Frame markers of one shape share batches for all types: the key contains the shape instead of the type.
  static const void* tag(FrameShape shape, bool turns) {
    static constexpr char tags[6] = {};
    return &tags[static_cast<int>(shape) + (turns ? 3 : 0)];
  }

  // Restricts the coordinates under a marker to the selected ones.
  void select(Placement& p, const std::vector<int>& chosen, int number) const {
    const std::vector<int> dofs = std::exchange(p.dofs, {});
    p.selected = static_cast<int>(chosen.size());
    for (const int i : chosen) {
      if (i >= 0 && i < static_cast<int>(dofs.size())) {
        p.dofs.push_back(dofs[i]);
      } else if (!dofs.empty()) {  // ground coordinates: fixed, not unknowns
        refuse(ErrorKind::value, {model_.describe(ItemKind::marker, number), "coordinate", "", std::to_string(i),
                                  "a coordinate from 0 to " + std::to_string(static_cast<int>(dofs.size()) - 1), ""});
      }
    }
  }

  // The batch for items of type `on`, or for the nodes of the placement.
  template <class B, class Make>
  GrowingBatch<B>& batch_of(BatchTable<B>& table, const void* variant, const ItemType& on, Make&& make, ItemKind kind,
                            int number) {
    key_.region = std::max(kind == ItemKind::marker ? marker_regions_.back() : region_of(kind, number), Regions::whole);
    key_.types.assign({variant, &on});
    for (const int n : placement_.nodes) key_.types.push_back(parts_.nodes[n].type);
    return table.find(key_, [&] {
      std::unique_ptr<B> batch = make();
      if (batch == nullptr) refuse_combination(kind, number, on.name);
      batch->reserve(regions_.expected(key_.region, counts_.of(item_of(kind, number).type)));
      return batch;
    });
  }
  template <class Make>
  GrowingBatch<Term>& term(const void* variant, const ItemType& type, Make&& make, int number) {
    return batch_of(terms_, variant, type, make, type.kind, number);
  }
  [[noreturn]] void refuse_combination(ItemKind kind, int number, std::string_view on) const {
    std::string nodes;
    bool turns = false;
    for (const int n : placement_.nodes) turns = turns || provides(*parts_.nodes[n].type, "Orientation");
    std::string advice = "See the pages of these items for what they accept";
    if (kind == ItemKind::marker && !turns && provides(*item_of(kind, number).type, "Orientation"))
      advice = std::string(on) +
               " has no orientation: forces act on markers of positions alone; "
               "torques, hinges and rotations need a rigid body, for example by mbs.CreateRigidBody(...)";
    for (const int n : placement_.nodes)
      if (parts_.nodes[n].type->name != on)
        nodes += (nodes.empty() ? "" : ", ") + std::string(parts_.nodes[n].type->name);
    refuse(ErrorKind::value,
           {model_.describe(kind, number), "",
            "this combination is not available: " + std::string(on) + (nodes.empty() ? "" : " with " + nodes), "", "",
            advice});
  }

  // Multipliers of the constraints follow those of the nodes.
  void number_constraints() {
    std::vector<int> marker_coordinates;
    for (ObjectPlace& place : parts_.objects) {
      marker_coordinates.clear();
      for (const int marker : place.markers.of(parts_.references))
        marker_coordinates.push_back(parts_.ports.ports[marker].forces);
      const int equations = physics(place).algebraic_equations(place.record.get(), marker_coordinates);
      place.equations = equations;
      if (equations > 0) place.first_ae = parts_.sizes.ae;
      parts_.sizes.ae += equations;
    }
  }

  void place_object(int number) {
    ObjectPlace& place = parts_.objects[number];
    const ObjectPhysics& physics = this->physics(place);
    Placement& p = placing_.of_object(number);
    for (const int marker : p.markers)
      if (!static_cast<const MarkerPhysics&>(*parts_.markers[marker].type->physics).has_rate())
        refuse(ErrorKind::value,
               {model_.describe(ItemKind::object, number), "markerNumbers",
                model_.describe(ItemKind::marker, marker) + " gives no velocity", "",
                "markers on coordinates of second order", "Markers on coordinates of first order take loads only"});
    if (!p.markers.empty()) check_object(number, p);
    auto& growing =
        term(place.type, *place.type, [&] { return physics.make_batch(placing_.node_types(p.nodes)); }, number);
    place.member = {growing.batch, enter_term(growing, place.record.get(), p)};
    note_run(place.member);
    numbers_of(growing.region).rows.add(p.ae_offset + p.first_ae, place.equations);
  }

  void note_run(const Membership<Term>& member) {
    auto& runs = parts_.object_runs;
    const bool follows = !runs.empty() && runs.back().first.batch == member.batch &&
                         runs.back().first.entry + runs.back().count == member.entry;
    if (!follows) runs.push_back({member, 0});
    ++runs.back().count;
  }

  void place_node_conditions() {
    for (int i = 0; i < static_cast<int>(parts_.nodes.size()); ++i) {
      const NodePlace& node = parts_.nodes[i];
      if (node.sizes.ae == 0) continue;
      Placement& p = placing_.on({&i, 1});
      p.item = i;
      p.first_ae = node.ae;
      auto& growing = term(node.type, *node.type, [&] { return node.physics->make_condition(); }, i);
      enter_term(growing, node.record.get(), p);
      numbers_of(growing.region).rows.add(p.ae_offset + p.first_ae, node.sizes.ae);
    }
  }

  void place_load(int number) {
    const Item& item = item_of(ItemKind::load, number);
    const auto& physics = this->physics<LoadPhysics>(item, number);
    const Stretch named = refer(item, ItemKind::marker);
    const auto markers = named.of(parts_.references);
    Placement& p = placing_.last();
    p.clear();
    p.item = number;
    p.markers.assign(markers.begin(), markers.end());
    const bool fixed = physics.body_fixed(item.record.get());
    const void* variant = fixed ? static_cast<const void*>(&physics) : item.type;
    auto& growing = term(variant, *item.type, [&] { return physics.make_batch(fixed); }, number);
    parts_.loads.push_back(
        {item.type, item.record, {growing.batch, enter_term(growing, item.record.get(), p)}, p.markers.front()});
  }

  SystemParts& parts_;
  const Model& model_;
  const Division division_;
  BatchTable<MarkerBatch> marker_batches_{parts_.marker_batches};
  BatchTable<Term> terms_{parts_.terms};
  RotatingBatches rotating_;
  Regions regions_;
  std::vector<Sizes> node_sizes_;
  std::vector<int> marker_regions_;
  BatchSet differentiated_;
  TypeCounts counts_;
  // Used again for every item.
  static inline thread_local Placement memory_;  // of the last assembly
  Placing placing_{parts_, std::move(memory_)};
  const Placement& placement_ = placing_.last();
  StartValues start_values_;
  BatchKey key_;
};

}  // namespace

void build(SystemParts& parts, const Model& model, const Division& division) {
  Builder(parts, model, division).run();
  make_load_dependencies(parts, model);
}

}  // namespace dalembert
