#include "dalembert/contact/contact_set.hpp"

#include <algorithm>

#include "dalembert/contact/general_contact.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/model.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {
namespace {

bool gives(const Item& marker, std::string_view what) {
  const auto& words = marker.type->provides;
  return std::ranges::find(words, what) != words.end() && std::ranges::find(words, "Coordinate") == words.end();
}

void check_marker(const Model& model, const std::string& name, const std::string& owner, int marker,
                  std::string_view what, const char* expected) {
  if (model.find_item(ItemKind::marker, marker) == nullptr)
    refuse(ErrorKind::index,
           {name, owner, "", std::to_string(marker),
            "the number of a marker; there are " + std::to_string(model.count(ItemKind::marker)), ""});
  if (!gives(model.item(ItemKind::marker, marker), what))
    refuse(ErrorKind::value, {name, owner, "", model.describe(ItemKind::marker, marker), expected, ""});
}

}  // namespace

void ContactSet::check(const Model& model, const std::string& name) const {
  int largest = -1;
  const auto check_all = [&](const auto& things, const char* called, const char* parameter, std::string_view what,
                             const char* expected) {
    for (std::size_t i = 0; i < things.size(); ++i) {
      check_marker(model, name, called + std::to_string(i) + ": " + parameter, things[i].marker, what, expected);
      largest = std::max(largest, things[i].surface.material);
    }
  };
  constexpr const char* turning = "a marker with an orientation, such as MarkerBodyRigid";
  check_all(spheres, "sphere ", "markerIndex", "Position",
            "a marker with a position, such as MarkerBodyPosition or MarkerBodyRigid");
  check_all(carriers, "triangles ", "rigidBodyMarkerIndex", "Orientation", turning);
  check_all(convex, "convex shape ", "markerIndex", "Orientation", turning);
  check_all(planes, "plane ", "rigidBodyMarkerIndex", "Orientation", turning);
  for (std::size_t i = 0; i < cables.size(); ++i) {
    const int object = cables[i].object;
    const std::string owner = "cable " + std::to_string(i) + ": objectIndex";
    if (model.find_item(ItemKind::object, object) == nullptr)
      refuse(ErrorKind::index,
             {name, owner, "", std::to_string(object),
              "the number of an object; there are " + std::to_string(model.count(ItemKind::object)), ""});
    if (model.item(ItemKind::object, object).type->name != "ObjectANCFCable2D")
      refuse(ErrorKind::value, {name, owner, "", model.describe(ItemKind::object, object), "an ObjectANCFCable2D", ""});
    largest = std::max(largest, cables[i].surface.material);
  }
  if (largest >= materials)
    refuse(ErrorKind::value, {name, "frictionMaterialIndex", "", std::to_string(largest),
                              "less than " + std::to_string(materials) + ", the size of frictionPairings",
                              "Call SetFrictionPairings(...) with a row and a column for every material."});
}

std::unique_ptr<SystemTerm> ContactSet::make_term(const Ports& ports, const std::string& name) const {
  const auto check_port = [&](int marker, bool turns) {
    const PortLayout& port = ports.ports[static_cast<std::size_t>(marker)];
    const bool rigid = port.values == RigidPort::values && port.forces == RigidPort::forces,
               point = port.values == PointPort::values && port.forces == PointPort::forces;
    if (!rigid && (turns || !point))
      refuse(ErrorKind::value, {name, "", "marker " + std::to_string(marker) + " gives no frame that contact acts on",
                                "", "", "Use MarkerBodyRigid, MarkerNodeRigid or markers of positions."});
  };
  for (const ContactSphere& s : spheres) check_port(s.marker, false);
  for (const ContactCarrier& c : carriers) check_port(c.marker, true);
  for (const ContactConvex& c : convex) check_port(c.marker, true);
  for (const ContactPlane& p : planes) check_port(p.marker, true);
  return std::make_unique<GeneralContact>(std::static_pointer_cast<const ContactSet>(shared_from_this()), ports, name);
}

void ContactSet::shift_references(ItemKind kind, int removed, const std::string& name, std::vector<std::string>& lost) {
  const auto shift = [&](int& number, const std::string& owner) {
    if (number > removed) {
      --number;
    } else if (number == removed) {
      number = -1;
      lost.push_back(name + ": " + owner + " referred to the deleted " + std::string(kind_name(kind)) + " " +
                     std::to_string(removed) + " and is invalid now");
    }
  };
  if (kind == ItemKind::object)
    for (std::size_t i = 0; i < cables.size(); ++i) shift(cables[i].object, "cable " + std::to_string(i));
  if (kind != ItemKind::marker) return;
  for (std::size_t i = 0; i < spheres.size(); ++i) shift(spheres[i].marker, "sphere " + std::to_string(i));
  for (std::size_t i = 0; i < carriers.size(); ++i)
    shift(carriers[i].marker, "the body of triangles " + std::to_string(i));
  for (std::size_t i = 0; i < convex.size(); ++i) shift(convex[i].marker, "convex shape " + std::to_string(i));
  for (std::size_t i = 0; i < planes.size(); ++i) shift(planes[i].marker, "plane " + std::to_string(i));
}

}  // namespace dalembert
