// What must hold before a model can be assembled.
#include <algorithm>
#include <optional>
#include <unordered_map>

#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/model/model.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {
namespace {

struct CapabilityName {
  Capability capability;
  std::string_view name;
};
constexpr CapabilityName capability_names[] = {
    {Capability::position, "Position"},         {Capability::orientation, "Orientation"},
    {Capability::coordinate, "Coordinate"},     {Capability::body_mass, "BodyMass"},
    {Capability::generic_ode2, "GenericODE2"},  {Capability::generic_data, "GenericData"},
    {Capability::position_2d, "Position2D"},    {Capability::orientation_2d, "Orientation2D"},
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

// What item types provide, looked up once per type.
class Provisions {
 public:
  Capability of(const ItemType& type) {
    const auto [found, is_new] = known_.try_emplace(&type, Capability::none);
    if (is_new)
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

  void run() const {
    const ItemType& type = *item_.type;
    for (const Row& row : type.rows) {
      if (row.role != Role::parameter) continue;
      if (index_storage(row.storage).is_index) check_indices(row);
      if (row.size != 0) check_length(row, row.size, "");
    }
    if (kind_ == ItemKind::node) check_coordinates();
  }

 private:
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
                 count == 0 ? "an existing " + noun + ", and there is none" : "a number from 0 to " + std::to_string(count - 1),
                 "Add the " + noun + " first and pass the index that Add" + std::string(kind_title(target)) + "(...) returned.");
      }
      check_target(row, target, value, *found->type);
    }
  }

  // Does the item that a row refers to provide what this item requests?
  void check_target(const Row& row, ItemKind target, int value, const ItemType& found) const {
    const ItemType& type = *item_.type;
    Capability requested = Capability::none;
    if (target == ItemKind::node) requested = type.requested_node;
    if (target == ItemKind::marker) requested = type.requested_marker;
    if (requested != Capability::none && !meets(provisions_.of(found), requested)) {
      complain(row, model_.describe(target, value) + ", which provides " + join({found.provides.begin(), found.provides.end()}),
               with_article(kind_name(target)) + " that provides " + join(names_of(requested)),
               "Use another type of " + std::string(kind_name(target)) + " here");
    }
    if (target == ItemKind::object && row.name.starts_with("body") && !is_body(found)) {
      complain(row, model_.describe(target, value), "a body (also ground, a finite element or a super element)",
               "Markers and sensors of bodies do not work on connectors; use the index of a body");
    }
  }

  template <class Expected>
  void check_length(const Row& row, Expected expected, const std::string& why) const {
    visit(row, item_.record.get(), [&](const auto& value) {
      if constexpr (requires { value.size(); value.begin(); }) {
        if (static_cast<int>(value.size()) != static_cast<int>(expected))
          complain(row, std::to_string(value.size()) + " values", std::to_string(expected) + " values" + why,
                   "Set the parameter with as many values");
      }
    });
  }

  // Generic nodes state how many coordinates they have; their start values have as many, or none for zeros.
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

}  // namespace

void Model::check() const {
  Provisions provisions;
  for (int k = 0; k < item_kinds; ++k) {
    const ItemKind kind = static_cast<ItemKind>(k);
    for (int i = 0; i < count(kind); ++i) Checker(*this, provisions, kind, i).run();
  }
}

}  // namespace dalembert
