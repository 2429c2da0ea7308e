// Checks of a model before assembly.
#include <algorithm>
#include <optional>
#include <unordered_map>

#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/model/model.hpp"
#include "dalembert/model/value_checks.hpp"
#include "dalembert/output/numbers.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {
namespace {

struct CapabilityName {
  Capability capability;
  std::string_view name;
};
constexpr CapabilityName capability_names[] = {
    {Capability::position, "Position"},        {Capability::orientation, "Orientation"},
    {Capability::coordinate, "Coordinate"},    {Capability::body_mass, "BodyMass"},
    {Capability::generic_ode2, "GenericODE2"}, {Capability::generic_data, "GenericData"},
    {Capability::position_2d, "Position2D"},   {Capability::orientation_2d, "Orientation2D"},
};

std::string join(const std::vector<std::string_view>& words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
  return text.empty() ? "nothing" : text;
}

std::vector<std::string_view> names_of(Capability capabilities) {
  std::vector<std::string_view> names;
  for (const CapabilityName& entry : capability_names)
    if (meets(capabilities, entry.capability)) names.push_back(entry.name);
  return names;
}

// Capabilities of item types, looked up once per type.
class Provisions {
 public:
  Capability of(const ItemType& type) {
    const auto [found, is_new] = known_.try_emplace(&type, Capability::none);
    if (!is_new) return found->second;
    for (const CapabilityName& entry : capability_names)
      if (provides(type, entry.name)) found->second = found->second | entry.capability;
    return found->second;
  }

 private:
  std::unordered_map<const ItemType*, Capability> known_;
};

bool is_body(const ItemType& type) {
  return type.category == "Body" || type.category == "FiniteElement" || type.category == "SuperElement";
}

class Checker {
 public:
  Checker(const Model& model, Provisions& provisions, ItemKind kind, int number)
      : model_(model), provisions_(provisions), kind_(kind), number_(number), item_(model.item(kind, number)) {}

  void run(const Row* changed = nullptr) const {
    const ItemType& type = *item_.type;
    if (changed != nullptr) return check_change(*changed);
    for (const Row& row : type.rows) {
      if (row.role != Role::parameter) continue;
      if (index_storage(row.storage).is_index) check_indices(row);
      if (row.size != 0) check_length(row, row.size, "");
      if (row.check >= Check::rotation) check_value(row);
    }
    if (kind_ == ItemKind::node) check_coordinates();
    if (kind_ == ItemKind::object) {
      check_ends();
      check_nodes();
    }
    if (kind_ == ItemKind::load) check_follower();
    if (type.physics != nullptr) type.physics->check_values(item_.record.get(), {model_, kind_, number_});
  }

 private:
  // Other items, and the connections of this item, have not changed.
  void check_change(const Row& row) const {
    if (row.size != 0) check_length(row, row.size, "");
    if (row.check >= Check::rotation) check_value(row);
    if (kind_ == ItemKind::node) check_coordinates();
    if (kind_ == ItemKind::load) check_follower();
    if (item_.type->physics != nullptr) item_.type->physics->check_values(item_.record.get(), {model_, kind_, number_});
  }

  bool works_without_data() const {
    const Physics* physics = item_.type->physics;
    return physics != nullptr && physics->works_without_data(item_.record.get());
  }

  [[noreturn]] void complain(const Row& row, std::string received, std::string expected, std::string advice) const {
    refuse(ErrorKind::value, {model_.describe(kind_, number_), std::string(row.name), "", std::move(received),
                              std::move(expected), std::move(advice)});
  }

  void check_indices(const Row& row) const {
    const ItemKind target = index_storage(row.storage).kind;
    for (const int value : index_values(row, item_.record.get())) {
      if (value == -1 && (row.optional || (row.storage == Storage::node && works_without_data()))) continue;
      if (value == -1) {
        complain(row, "the invalid index -1", "the number of " + with_article(kind_name(target)),
                 "Pass the index that Add" + std::string(kind_title(target)) +
                     "(...) returned; if that item was deleted, set another one or delete this item as well.");
      }
      const Item* found = model_.find_item(target, value);
      if (found == nullptr) {
        const int count = model_.count(target);
        const std::string noun(kind_name(target));
        complain(row, std::to_string(value),
                 count == 0 ? "an existing " + noun + ", and there is none"
                            : "a number from 0 to " + std::to_string(count - 1),
                 "Add the " + noun + " first and pass the index that Add" + std::string(kind_title(target)) +
                     "(...) returned.");
      }
      check_target(row, target, value, *found->type);
    }
  }

  // Checks that the referenced item provides the capabilities requested by this item.
  void check_target(const Row& row, ItemKind target, int value, const ItemType& found) const {
    const ItemType& type = *item_.type;
    Capability requested = Capability::none;
    if (target == ItemKind::node) requested = type.requested_node;
    if (target == ItemKind::marker) requested = type.requested_marker;
    if (requested != Capability::none && !meets(provisions_.of(found), requested)) {
      complain(
          row,
          model_.describe(target, value) + ", which provides " + join({found.provides.begin(), found.provides.end()}),
          with_article(kind_name(target)) + " that provides " + join(names_of(requested)),
          "Use another type of " + std::string(kind_name(target)) + " here");
    }
    if (target == ItemKind::object && row.name.starts_with("body") && !is_body(found)) {
      complain(row, model_.describe(target, value), "a body (also ground, a finite element or a super element)",
               "Markers and sensors of bodies do not work on connectors; use the index of a body");
    }
  }

  static std::string number_of_values(auto n) { return std::to_string(n) + (n == 1 ? " value" : " values"); }
  template <class Expected>
  void check_length(const Row& row, Expected expected, const std::string& why) const {
    visit(row, item_.record.get(), [&](const auto& value) {
      if constexpr (requires {
                      value.size();
                      value.begin();
                    }) {
        if (static_cast<int>(value.size()) != static_cast<int>(expected))
          complain(row, number_of_values(value.size()), number_of_values(expected) + why,
                   "Set the parameter with as many values");
      }
    });
  }

  // Values are checked when they are set; but defaults may have stayed, and arrays of items may be written to.
  void check_value(const Row& row) const {
    const Verdict verdict = judge(row, member(item_.record.get(), row));
    if (verdict.fit == Fit::wrong)
      complain(row, numbers(row), demand(row.check), verdict.problem + " " + advice(row.check));
  }
  std::string numbers(const Row& row) const {
    return visit(row, item_.record.get(), [](const auto& value) -> std::string {
      if constexpr (requires { value.x[0]; }) {
        std::string text;
        for (const double x : value.x) text += (text.empty() ? "[" : ", ") + format_number(x);
        return text + "]";
      } else {
        return "a list with such a value";
      }
    });
  }

  // Carrier of a marker: a node, ground, or a body with its own coordinates, whose points move relative to each
  // other.
  struct Carrier {
    enum class Kind { ground, node, other } kind = Kind::other;
    int number = -1;
    bool operator==(const Carrier&) const = default;
  };
  Carrier carrier(int marker) const {
    const Item& item = model_.item(ItemKind::marker, marker);
    int object = -1, node = -1;
    for (const Row& row : item.type->rows) {
      const IndexStorage index = index_storage(row.storage);
      if (!index.is_index || index.is_list) continue;
      (index.kind == ItemKind::object ? object : node) = index_values(row, item.record.get()).front();
    }
    const Item* body = model_.find_item(ItemKind::object, object);
    if (body != nullptr && provides(*body->type, "Ground")) return {Carrier::Kind::ground};
    if (body != nullptr && body->type->category == "Body")
      for (const Row& row : body->type->rows)
        if (row.storage == Storage::node) node = index_values(row, body->record.get()).front();
    const Item* carrying = model_.find_item(ItemKind::node, node);
    if (carrying == nullptr) return {};
    if (provides(*carrying->type, "Ground")) return {Carrier::Kind::ground};
    return {Carrier::Kind::node, node};
  }

  // An element between a node and itself has no length, and bodies of several nodes would count its coordinates twice.
  void check_nodes() const {
    for (const Row& row : item_.type->rows) {
      if (const IndexStorage index = index_storage(row.storage); !index.is_list || index.kind != ItemKind::node)
        continue;
      const auto nodes = index_values(row, item_.record.get());
      for (auto node = nodes.begin(); node != nodes.end(); ++node)
        if (std::find(nodes.begin(), node, *node) != node)
          complain(row, model_.describe(ItemKind::node, *node) + " twice", "different nodes",
                   "Give each node of the object once");
    }
  }

  // Both markers of a connector: two of them, and of a joint on different bodies.
  void check_ends() const {
    const ItemType& type = *item_.type;
    const auto row = std::ranges::find(type.rows, "markerNumbers", &Row::name);
    if (row == type.rows.end() || row->size != 2) return;
    const auto markers = index_values(*row, item_.record.get());
    if (markers[0] == markers[1])
      complain(*row, model_.describe(ItemKind::marker, markers[0]) + " twice", "two different markers",
               "Between a marker and itself there is nothing to connect");
    const bool holds = type.category == "Joint" || type.category == "Constraint";
    if (!holds || !meets(type.requested_marker, Capability::position)) return;
    const Carrier first = carrier(markers[0]), second = carrier(markers[1]);
    if (first.kind == Carrier::Kind::other || first != second) return;
    complain(*row,
             "two markers on " +
                 (first.kind == Carrier::Kind::node ? model_.describe(ItemKind::node, first.number) : "ground"),
             "markers on two bodies that move against each other", "A body cannot be joined to itself");
  }

  // A load that turns with its marker reads the marker's orientation.
  void check_follower() const {
    const auto* physics = static_cast<const LoadPhysics*>(item_.type->physics);
    if (!physics->body_fixed(item_.record.get())) return;
    const Row& row = *std::ranges::find(item_.type->rows, "markerNumber", &Row::name);
    const int marker = index_values(row, item_.record.get()).front();
    if (meets(provisions_.of(*model_.item(ItemKind::marker, marker).type), Capability::orientation)) return;
    complain(row, model_.describe(ItemKind::marker, marker) + ", which has no orientation",
             "with bodyFixed = True a marker that provides Orientation",
             "Use a marker of a rigid body, or bodyFixed = False");
  }

  // Generic nodes have a given number of coordinates; their start values have the same number, or none for zeros.
  void check_coordinates() const {
    const void* record = item_.record.get();
    for (const Row& count : item_.type->rows) {
      if (count.storage != Storage::integer || !count.name.starts_with("numberOf")) continue;
      const int n = *static_cast<const int*>(member(record, count));
      for (const Row& row : item_.type->rows) {
        if (row.storage != Storage::vector || row.role != Role::parameter) continue;
        if (static_cast<const std::vector<double>*>(member(record, row))->empty()) continue;
        check_length(row, n, " as " + std::string(count.name) + " is " + std::to_string(n));
      }
    }
  }

  const Model& model_;
  Provisions& provisions_;
  ItemKind kind_;
  int number_;
  const Item& item_;
};

// Objects with one node for their states: histories overwrite each other, and rates are added. Empty: there are none.
std::string doubt_of_shared_states(const Model& model) {
  const auto has_states = [&](int node) {
    const Item* found = model.find_item(ItemKind::node, node);
    return found != nullptr && (found->type->name == "NodeGenericData" || found->type->name == "NodeGenericODE1");
  };
  bool any = false;
  for (int i = 0; i < model.count(ItemKind::node) && !any; ++i) any = has_states(i);
  if (!any) return "";
  std::vector<int> users(static_cast<std::size_t>(model.count(ItemKind::node)), -1);
  for (int i = 0; i < model.count(ItemKind::object); ++i) {
    const Item& object = model.item(ItemKind::object, i);
    if (object.type->category != "Connector") continue;
    for (const Row& row : object.type->rows) {
      if (const IndexStorage index = index_storage(row.storage); !index.is_index || index.kind != ItemKind::node)
        continue;
      for (const int node : index_values(row, object.record.get())) {
        if (!has_states(node)) continue;
        int& user = users[static_cast<std::size_t>(node)];
        if (user >= 0 && user != i)
          return model.describe(ItemKind::object, i) + ": it shares " + model.describe(ItemKind::node, node) +
                 " with " + model.describe(ItemKind::object, user) +
                 ", so that their histories overwrite each other, or their rates are added; add a node for each.";
        user = i;
      }
    }
  }
  return "";
}

// The node of a marker, or the first node of its body; null: it has none.
const Item* node_under(const Model& model, int marker) {
  const Item* item = model.find_item(ItemKind::marker, marker);
  while (item != nullptr && item->type->kind != ItemKind::node) {
    const auto below = std::ranges::find_if(item->type->rows, [](const Row& row) {
      const IndexStorage index = index_storage(row.storage);
      return index.is_index && (index.kind == ItemKind::node || index.kind == ItemKind::object);
    });
    if (below == item->type->rows.end()) return nullptr;
    const auto numbers = index_values(*below, item->record.get());
    item = numbers.empty() ? nullptr : model.find_item(index_storage(below->storage).kind, numbers.front());
  }
  return item;
}

// Constant loads across the plane of a planar body; the plane carries them. Empty: there are none.
std::string doubt_of_loads_across(const Model& model) {
  for (int i = 0; i < model.count(ItemKind::load); ++i) {
    const Item& load = model.item(ItemKind::load, i);
    const auto* vector = member_of<Vec3<double>>(load, "loadVector");
    const auto* function = member_of<UserFunction>(load, "loadVectorUserFunction");
    if (vector == nullptr || function == nullptr || *function) continue;
    const bool turns = load.type->name == "LoadTorqueVector";
    if (turns ? (*vector)[0] == 0 && (*vector)[1] == 0 : (*vector)[2] == 0) continue;
    const Item* node =
        node_under(model, index_values(*find_row(*load.type, "markerNumber"), load.record.get()).front());
    if (node == nullptr || !provides(*node->type, "Position2D")) continue;
    return model.describe(ItemKind::load, i) + ": its component" + (turns ? "s along x and y have" : " along z has") +
           " no effect, because what it acts on moves in the xy plane.";
  }
  return "";
}

}  // namespace

void Model::check() const {
  Provisions provisions;
  for (int k = 0; k < item_kinds; ++k) {
    const ItemKind kind = static_cast<ItemKind>(k);
    for (int i = 0; i < count(kind); ++i) Checker(*this, provisions, kind, i).run();
  }
  for (std::size_t i = 0; i < term_sources_.size(); ++i) term_sources_[i]->check(*this, term_name(i));
}

void Model::check(std::span<const ItemChange> some) const {
  Provisions provisions;
  for (const ItemChange& change : some) Checker(*this, provisions, change.kind, change.number).run(change.row);
}

std::string Model::doubt() const {
  std::string first;
  int others = -1;
  for (int i = 0; i < count(ItemKind::object); ++i) {
    const Item& object = item(ItemKind::object, i);
    const std::string doubt = object.type->physics == nullptr ? "" : object.type->physics->doubt(object.record.get());
    if (doubt.empty()) continue;
    if (first.empty()) first = describe(ItemKind::object, i) + ": " + doubt + ".";
    ++others;
  }
  if (others > 0) first += " So have " + std::to_string(others) + " other objects.";
  for (const std::string& more : {doubt_of_shared_states(*this), doubt_of_loads_across(*this)})
    first += (first.empty() || more.empty() ? "" : " ") + more;
  return first;
}

}  // namespace dalembert
