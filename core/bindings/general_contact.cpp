// The Python class GeneralContact, which mbs.AddGeneralContact() returns, and its methods.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>

#include "console.hpp"
#include "conversion.hpp"
#include "general_contact_handle.hpp"
#include "index_types.hpp"
#include "item_arguments.hpp"
#include "python_errors.hpp"
#include "sequence.hpp"

namespace dalembert {
namespace {

struct ContactVisualization {};

py::object vector_out(const Vec3<double>& v) { return new_array({3}, v.x.data()); }
py::object matrix_out(const Mat3<double>& m) { return new_array({3, 3}, m.x.data()); }
py::object points_out(const Triangle& t) {
  double numbers[9];
  for (std::size_t i = 0; i < 9; ++i) numbers[i] = t[i / 3][static_cast<int>(i % 3)];
  return new_array({3, 3}, numbers);
}
py::array_t<int> integers_out(const std::vector<int>& numbers) {
  return py::array_t<int>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

// ---- adding spheres, shapes, triangles and cables -------------------------------------------------------------------

int add_sphere(const ContactHandle& self, const py::object& marker, double radius, double stiffness, double damping,
               int material) {
  constexpr const char* method = "AddSphereWithMarker";
  const int number = item_number_argument(*self.main, ItemKind::marker, marker.ptr(),
                                          [] { return std::string("GeneralContact.AddSphereWithMarker"); });
  const ContactSphere sphere{number, require(method, "radius", radius, true, "m"),
                             surface_of(method, stiffness, damping, material)};
  Model& model = self.main->restructure(ContactHandle::called(method));
  self.set->spheres.push_back(sphere);
  ++self.set->shapes;
  model.term_source_changed();
  return static_cast<int>(self.set->spheres.size()) - 1;
}

int add_cable(const ContactHandle& self, const py::object& object, double half_height, double stiffness, double damping,
              int material) {
  constexpr const char* method = "AddANCFCable";
  const int number = item_number_argument(*self.main, ItemKind::object, object.ptr(),
                                          [] { return std::string("GeneralContact.AddANCFCable"); });
  const ContactCable cable{number, require(method, "halfHeight", half_height, false, "m"),
                           surface_of(method, stiffness, damping, material)};
  Model& model = self.main->restructure(ContactHandle::called(method));
  self.set->cables.push_back(cable);
  model.term_source_changed();
  return static_cast<int>(self.set->cables.size()) - 1;
}

int add_triangles(const ContactHandle& self, const py::object& marker, double stiffness, double damping, int material,
                  const py::object& points, const py::object& triangles) {
  constexpr const char* method = "AddTrianglesRigidBodyBased";
  const int number = item_number_argument(*self.main, ItemKind::marker, marker.ptr(),
                                          [] { return std::string("GeneralContact.AddTrianglesRigidBodyBased"); });
  const ContactSurface surface = surface_of(method, stiffness, damping, material);
  const Array corners = table_argument<Array>(method, "pointList", points, 3);
  const Array numbers = table_argument<Array>(method, "triangleList", triangles, 3);
  const auto p = corners.unchecked<2>();
  const auto t = numbers.unchecked<2>();
  for (py::ssize_t i = 0; i < p.shape(0); ++i)
    for (py::ssize_t k = 0; k < 3; ++k)
      if (!std::isfinite(p(i, k)))
        refuse_value(method, "pointList[" + std::to_string(i) + "]", text_of(p(i, k)), "3 finite numbers (unit m)");
  std::vector<Triangle> added;
  for (py::ssize_t i = 0; i < t.shape(0); ++i) {
    Triangle one;
    const std::string parameter = "triangleList[" + std::to_string(i) + "]";
    for (py::ssize_t k = 0; k < 3; ++k) {
      const double index = t(i, k);
      if (!(index >= 0 && index < static_cast<double>(p.shape(0))) || index != std::floor(index))
        refuse_value(method, parameter, text_of(index),
                     "whole numbers from 0 to " + std::to_string(p.shape(0) - 1) + ", of points in pointList");
      const auto at = static_cast<py::ssize_t>(index);
      one[static_cast<std::size_t>(k)] = {p(at, 0), p(at, 1), p(at, 2)};
    }
    require_area(method, parameter, one);
    added.push_back(one);
  }
  return add_triangles_of_body(self, method, number, surface, added);
}

void set_friction_pairings(const ContactHandle& self, const py::object& pairings) {
  constexpr const char* method = "SetFrictionPairings";
  const Array table = friction_argument(method, pairings);
  require_own_thread(*self.main, ContactHandle::called(method));
  const int count = static_cast<int>(table.shape(0));
  if (count < self.set->materials)
    self.main->restructure(ContactHandle::called(method)).term_source_changed();  // Assemble checks the numbers
  self.set->friction.assign(table.data(), table.data() + table.size());
  if (count > self.set->materials) self.main->restructure(ContactHandle::called(method)).term_source_changed();
  self.set->materials = count;
  ++self.set->shapes;
}

void set_proportional_zone(const ContactHandle& self, double zone) {
  self.set->proportional_zone = require("SetFrictionProportionalZone", "frictionProportionalZone", zone, true, "m/s");
}

void set_bristles(const ContactHandle& self, double stiffness, double damping, double holding) {
  const ContactBristles bristles = bristles_from("SetFrictionBristles", {stiffness, damping, holding});
  require_own_thread(*self.main, ContactHandle::called("SetFrictionBristles"));
  self.set->bristles = bristles;
}

void reset(const ContactHandle& self, bool) {
  Model& model = self.main->restructure(ContactHandle::called("Reset"));
  const std::uint64_t shapes = self.set->shapes + 1;
  *self.set = ContactSet();
  self.set->shapes = shapes;
  model.term_source_changed();
}

// ---- spheres and triangles -------------------------------------------------------------------------------------------

py::dict get_sphere(const ContactHandle& self, int number, bool with_data) {
  require_number("GetSphereMarkerBased", number, self.set->spheres.size(), "sphere");
  const ContactSphere& sphere = self.set->spheres[static_cast<std::size_t>(number)];
  const Ports* ports = nullptr;
  const RigidFrame<double> frame = self.term("GetSphereMarkerBased", ports).frame_of(sphere.marker, *ports);
  py::dict result;
  result["position"] = vector_out(frame.position);
  result["orientation"] = matrix_out(frame.rotation);
  result["velocity"] = vector_out(frame.velocity);
  result["angularVelocity"] = vector_out(transposed_times(frame.rotation, frame.angular_velocity));
  if (!with_data) return result;
  result["markerIndex"] = py::reinterpret_steal<py::object>(make_index(ItemKind::marker, sphere.marker));
  result["contactStiffness"] = sphere.surface.stiffness;
  result["contactDamping"] = sphere.surface.damping;
  result["radius"] = sphere.radius;
  result["frictionMaterialIndex"] = sphere.surface.material;
  return result;
}

void set_sphere(const ContactHandle& self, int number, double stiffness, double damping, double radius, int material) {
  constexpr const char* method = "SetSphereMarkerBased";
  require_number(method, number, self.set->spheres.size(), "sphere");
  ContactSphere changed = self.set->spheres[static_cast<std::size_t>(number)];
  if (!(stiffness < 0)) changed.surface.stiffness = require(method, "contactStiffness", stiffness, true, "N/m");
  if (!(damping < 0)) changed.surface.damping = require(method, "contactDamping", damping, false, "Ns/m");
  if (!(radius < 0)) changed.radius = require(method, "radius", radius, true, "m");
  if (material >= self.set->materials)
    refuse_value(method, "frictionMaterialIndex", std::to_string(material),
                 "less than " + std::to_string(self.set->materials) + ", the size of frictionPairings");
  if (material >= 0) changed.surface.material = material;
  require_own_thread(*self.main, ContactHandle::called(method));
  self.set->spheres[static_cast<std::size_t>(number)] = changed;
  ++self.set->shapes;
}

py::dict get_triangle(const ContactHandle& self, int number) {
  require_number("GetTriangleRigidBodyBased", number, self.set->triangles.size(), "triangle");
  const ContactTriangle& triangle = self.set->triangles[static_cast<std::size_t>(number)];
  py::dict result;
  result["contactRigidBodyIndex"] = triangle.carrier;
  result["points"] = points_out(triangle.points);
  const Vec3<double> area = area_vector(triangle.points);
  result["normal"] = vector_out((1 / norm(area)) * area);
  return result;
}

void set_triangle(const ContactHandle& self, int number, const py::object& points, int carrier) {
  constexpr const char* method = "SetTriangleRigidBodyBased";
  require_number(method, number, self.set->triangles.size(), "triangle");
  const Array table = table_argument<Array>(method, "points", points, 3);
  if (table.shape(0) != 3) refuse_value(method, "points", show(points.ptr()), "3 points in rows");
  ContactTriangle changed = self.set->triangles[static_cast<std::size_t>(number)];
  const auto p = table.unchecked<2>();
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      if (!std::isfinite(p(i, k))) refuse_value(method, "points", show(points.ptr()), "finite numbers (unit m)");
      changed.points[static_cast<std::size_t>(i)][k] = p(i, k);
    }
  require_area(method, "points", changed.points);
  if (carrier >= static_cast<int>(self.set->carriers.size()))
    refuse_value(method, "contactRigidBodyIndex", std::to_string(carrier),
                 "less than " + std::to_string(self.set->carriers.size()) + ", the number of bodies with triangles");
  if (carrier >= 0) changed.carrier = carrier;
  require_own_thread(*self.main, ContactHandle::called(method));
  self.set->triangles[static_cast<std::size_t>(number)] = changed;
  ++self.set->shapes;
}

// ---- questions -------------------------------------------------------------------------------------------------------

py::object items_in_box(const ContactHandle& self, const py::object& lower, const py::object& upper) {
  constexpr const char* method = "GetItemsInBox";
  const Box box{vector_argument(method, "pMin", lower), vector_argument(method, "pMax", upper)};
  const Ports* ports = nullptr;
  const GeneralContact& term = self.term(method, ports);
  const GeneralContact::Items items = term.items_in(box, *ports);
  if (items.spheres.empty() && items.cables.empty() && items.triangles.empty() && items.convex.empty())
    return py::bool_(false);
  py::dict result;
  result["MarkerBasedSpheres"] = integers_out(items.spheres);
  result["TrigsRigidBodyBased"] = integers_out(items.triangles);
  result["ANCFCable2D"] = integers_out(items.cables);
  if (!self.set->convex.empty()) result["ConvexMarkerBased"] = integers_out(items.convex);
  return result;
}

ContactTypeIndex type_argument(const char* method, const py::object& value) {
  static const Enumeration types("ContactTypeIndex");
  if (!types.has(value.ptr()))
    refuse(ErrorKind::type,
           {ContactHandle::called(method), "typeIndex", "", show(value.ptr()), "a member of ContactTypeIndex", ""});
  return static_cast<ContactTypeIndex>(Enumeration::number(value.ptr()));
}

py::object shortest_distance(const ContactHandle& self, const py::object& start, const py::object& direction,
                             double nearest, double farthest, bool as_dictionary, double radius,
                             const py::object& type) {
  constexpr const char* method = "ShortestDistanceAlongLine";
  const auto of = type.is_none() ? ContactTypeIndex::IndexEndOfEnumList : type_argument(method, type);
  const bool all = of == ContactTypeIndex::IndexEndOfEnumList;
  Line line{vector_argument(method, "pStart", start),
            vector_argument(method, "direction", direction),
            nearest,
            farthest,
            require(method, "cylinderRadius", radius, false, "m"),
            all || of == ContactTypeIndex::IndexSpheresMarkerBased,
            all || of == ContactTypeIndex::IndexANCFCable2D,
            all || of == ContactTypeIndex::IndexTrigsRigidBodyBased,
            all || of == ContactTypeIndex::IndexConvexMarkerBased,
            all || of == ContactTypeIndex::IndexPlanesRigidBodyBased};
  const double length = norm(line.direction);
  if (!(length > 0)) refuse_value(method, "direction", show(direction.ptr()), "a vector that is not zero");
  if (!(nearest < farthest))
    refuse_value(method, "minDistance", text_of(nearest), "less than maxDistance, which is " + text_of(farthest));
  if (radius != 0 && of != ContactTypeIndex::IndexSpheresMarkerBased)
    refuse_value(method, "cylinderRadius", text_of(radius),
                 "0, or typeIndex=ContactTypeIndex.IndexSpheresMarkerBased: a cylinder finds spheres");
  line.direction = (1 / length) * line.direction;
  const Ports* ports = nullptr;
  const GeneralContact& term = self.term(method, ports);
  const LineHit hit = term.first_hit(line, *ports, self.main->system.number_of_current_ports());
  if (!as_dictionary) return py::float_(hit.distance);
  py::dict result;
  result["distance"] = hit.distance;
  result["velocityAlongLine"] = hit.velocity;
  result["itemIndex"] = std::max({hit.sphere, hit.cable, hit.triangle, hit.convex, hit.plane});
  const auto found = hit.sphere >= 0     ? ContactTypeIndex::IndexSpheresMarkerBased
                     : hit.cable >= 0    ? ContactTypeIndex::IndexANCFCable2D
                     : hit.triangle >= 0 ? ContactTypeIndex::IndexTrigsRigidBodyBased
                     : hit.convex >= 0   ? ContactTypeIndex::IndexConvexMarkerBased
                     : hit.plane >= 0    ? ContactTypeIndex::IndexPlanesRigidBodyBased
                                         : ContactTypeIndex::IndexEndOfEnumList;
  result["typeIndex"] = static_cast<int>(found);
  return result;
}

void update_contacts(const ContactHandle& self, const std::shared_ptr<MainSystem>& main) {
  if (main != self.main)
    refuse_value("UpdateContacts", "mainSystem", "another system", "the system that has this GeneralContact");
  const Ports* ports = nullptr;
  const_cast<GeneralContact&>(self.term("UpdateContacts", ports)).update(*ports);
}

py::array_t<int> active_contacts(const ContactHandle& self, const py::object& type, int number) {
  constexpr const char* method = "GetActiveContacts";
  const ContactTypeIndex of = type_argument(method, type);
  const std::size_t counts[] = {self.set->spheres.size(), self.set->cables.size(), self.set->triangles.size(), 0,
                                self.set->convex.size(),  self.set->planes.size()};
  if (of == ContactTypeIndex::IndexEndOfEnumList)
    refuse_value(method, "typeIndex", "IndexEndOfEnumList", "a kind of contact");
  const std::size_t count = counts[static_cast<std::size_t>(of)];
  if (number != -1) require_number(method, number, count, "contact item of this type, or -1");
  System& system = self.system(method);
  const auto& term = static_cast<const GeneralContact&>(system.term(self.number()));
  std::vector<int> result(number == -1 ? count : 0, 0);
  if (of == ContactTypeIndex::IndexTrigsRigidBodyBased || of == ContactTypeIndex::IndexPlanesRigidBodyBased)
    return integers_out(result);  // spheres and convex shapes list them
  const bool of_spheres = of == ContactTypeIndex::IndexSpheresMarkerBased;
  const int first = self.set->first_cable(), end = self.set->first_triangle();
  const auto add = [&](int owner, int other) {
    if (number == -1)
      ++result[static_cast<std::size_t>(owner)];
    else if (owner == number)
      result.push_back(other);
  };
  for (const GeneralContact::ConvexPair& pair : term.convex_pairs()) {
    const int begin = of_spheres ? 0 : self.set->first_convex(), size = static_cast<int>(count);
    for (const auto& [own, other] : {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)})
      if (own >= begin && own < begin + size) add(own - begin, pair.sticks ? other : -other);
  }
  if (of == ContactTypeIndex::IndexConvexMarkerBased) return integers_out(result);
  for (const HeldContact& contact : term.touching()) {
    const bool with_cable = contact.other >= first && contact.other < end;
    if (with_cable == of_spheres) continue;  // cables list spheres
    const int owner = of_spheres ? contact.sphere : contact.other - first,
              other = of_spheres ? contact.other : contact.sphere;
    add(owner, contact.sticks || with_cable ? other : -other);
  }
  return integers_out(result);
}

py::object contact_forces(const ContactHandle& self, bool) {
  System& system = self.system("GetSystemODE2RhsContactForces");
  require_idle(*self.main, ContactHandle::called("GetSystemODE2RhsContactForces"));
  std::vector<double> forces(static_cast<std::size_t>(system.sizes().ode2));
  system.forces_of_term(self.number(), forces);
  return new_array({static_cast<py::ssize_t>(forces.size())}, forces.data());
}

// Searched anew by a term of its own: nothing that a solver keeps is touched.
py::tuple pushes(const ContactHandle& self, const py::object& value) {
  constexpr const char* method = "_pushes";
  const ConfigurationType configuration =
      configuration_argument(value, [] { return std::string("GeneralContact._pushes(...)"); });
  System& system = self.system(method);
  require_own_thread(*self.main, ContactHandle::called(method));
  if (configuration == ConfigurationType::Visualization) self.main->look_wanted = true;
  std::vector<GeneralContact::Push> found;
  system.with_ports(configuration, [&](const Ports& ports) {
    GeneralContact term(self.set, ports, Model::term_name(static_cast<std::size_t>(self.number())));
    term.enter(system, self.main->model);
    term.take_bristles_of(static_cast<const GeneralContact&>(system.term(self.number())));
    found = term.pushes(ports, configuration);
  });
  const auto n = static_cast<py::ssize_t>(found.size());
  py::array_t<int> pairs({n, py::ssize_t{2}});
  std::vector<double> points, forces;
  for (py::ssize_t i = 0; i < n; ++i) {
    const GeneralContact::Push& push = found[static_cast<std::size_t>(i)];
    pairs.mutable_at(i, 0) = push.sphere;
    pairs.mutable_at(i, 1) = push.other;
    points.insert(points.end(), push.point.x.begin(), push.point.x.end());
    forces.insert(forces.end(), push.force.x.begin(), push.force.x.end());
  }
  return py::make_tuple(pairs, new_array({n, 3}, points.data()), new_array({n, 3}, forces.data()));
}

// ---- settings --------------------------------------------------------------------------------------------------------

void register_kept(py::class_<ContactHandle>& contact) {
  for (const KeptSetting& setting : kept_settings) {
    const std::string name = setting.name;
    const auto get = [setting, name](const ContactHandle& self) -> py::object {
      const auto found = self.set->without_effect.find(name);
      const double value = found == self.set->without_effect.end() ? setting.value : found->second;
      return setting.is_flag ? py::object(py::bool_(value != 0)) : py::object(py::int_(static_cast<long>(value)));
    };
    const auto put = [setting, name](const ContactHandle& self, auto value) {
      self.set->without_effect[name] = value;
      if (static_cast<double>(value) != setting.value && *setting.reason != 0)
        tell_without_effect("GeneralContact." + name, setting.reason);
    };
    const std::string reason = *setting.reason != 0 ? std::string(": ") + setting.reason : ", as it is done anyway";
    const std::string doc = "Kept, without effect" + reason + ".";
    if (setting.is_flag)
      contact.def_property(
          setting.name, get, [put](const ContactHandle& self, bool value) { put(self, value); }, doc.c_str());
    else
      contact.def_property(
          setting.name, get, [put](const ContactHandle& self, int value) { put(self, value); }, doc.c_str());
  }
}

void set_cells(const ContactHandle& self, const py::object& cells) {
  constexpr const char* method = "SetSearchTreeCellSize";
  const Vec3<double> numbers = vector_argument(method, "numberOfCells", cells);
  for (int i = 0; i < 3; ++i)
    if (!(numbers[i] >= 1) || numbers[i] != std::floor(numbers[i]))
      refuse_value(method, "numberOfCells", show(cells.ptr()), "3 whole numbers from 1");
  for (int i = 0; i < 3; ++i) self.set->cells[static_cast<std::size_t>(i)] = static_cast<int>(numbers[i]);
}

void set_box(const ContactHandle& self, const py::object& lower, const py::object& upper) {
  constexpr const char* method = "SetSearchTreeBox";
  const Vec3<double> from = vector_argument(method, "pMin", lower), to = vector_argument(method, "pMax", upper);
  for (int i = 0; i < 3; ++i)
    if (!(from[i] < to[i]))
      refuse_value(method, "pMax", show(upper.ptr()),
                   "components larger than those of pMin, " + std::string(show(lower.ptr())));
  for (int i = 0; i < 3; ++i) {
    self.set->box[static_cast<std::size_t>(i)] = from[i];
    self.set->box[static_cast<std::size_t>(i) + 3] = to[i];
  }
}

py::dict python_object(const ContactHandle& self) {
  const ContactSet& set = *self.set;
  py::dict result;
  result["isActive"] = set.active;
  result["sphereSphereContact"] = set.spheres_touch;
  result["frictionPairings"] = friction_out(set);
  result["frictionProportionalZone"] = set.proportional_zone;
  result["frictionBristles"] = bristles_out(set);
  result["minRelDistanceSpheresTriangles"] = set.nearest_relative_distance;
  result["globalContactIndexOffsets"] = integers_out({0, set.first_cable(), set.first_triangle(), set.first_convex()});
  result["numberOfSpheresMarkerBased"] = set.spheres.size();
  result["numberOfANCFCable2D"] = set.cables.size();
  result["numberOfTrigsRigidBodyBased"] = set.triangles.size();
  result["numberOfRigidBodyMarkerBased"] = set.carriers.size();
  result["numberOfConvexMarkerBased"] = set.convex.size();
  result["numberOfPlanesRigidBodyBased"] = set.planes.size();
  result["searchTreeSize"] = std::vector<int>(set.cells.begin(), set.cells.end());
  py::list box;
  box.append(new_array({3}, set.box.data()));
  box.append(new_array({3}, set.box.data() + 3));
  result["searchTreeBox"] = box;
  return result;
}

int contact_number(const MainSystem& main, int number, const char* method) {
  const int count = static_cast<int>(main.model.term_sources().size());
  if (number >= 0 && number < count) return number;
  refuse(ErrorKind::index, {"mbs." + std::string(method) + "(...)", "generalContactNumber", "", std::to_string(number),
                            "the number of a GeneralContact; there are " + std::to_string(count), ""});
}

// Methods of systems for general contact. They are registered after the class, so that help() shows its name.
void register_methods_of_systems(const py::module_& module) {
  auto main_system =
      py::reinterpret_borrow<py::class_<MainSystem, std::shared_ptr<MainSystem>>>(module.attr("MainSystem"));
  main_system.def(
      "AddGeneralContact",
      [](MainSystem& main) {
        auto set = std::make_shared<ContactSet>();
        main.restructure("mbs.AddGeneralContact()").add(set);
        return ContactHandle{main.shared_from_this(), set};
      },
      "Add contact of spheres and convex shapes with each other, with triangles and planes, to be filled by methods of "
      "the returned object.");
  main_system.def(
      "GetGeneralContact",
      [](MainSystem& main, int number) {
        const auto& source =
            main.model.term_sources()[static_cast<std::size_t>(contact_number(main, number, "GetGeneralContact"))];
        return ContactHandle{main.shared_from_this(), std::static_pointer_cast<ContactSet>(source)};
      },
      py::arg("generalContactNumber"), "A GeneralContact by its number, in the order in which they were added.");
  main_system.def(
      "DeleteGeneralContact",
      [](MainSystem& main, int number) {
        contact_number(main, number, "DeleteGeneralContact");
        main.restructure("mbs.DeleteGeneralContact(...)").remove_term_source(static_cast<std::size_t>(number));
      },
      py::arg("generalContactNumber"), "Delete a GeneralContact; the numbers behind it move up by one.");
  main_system.def(
      "NumberOfGeneralContacts", [](const MainSystem& main) { return main.model.term_sources().size(); },
      "How many GeneralContacts there are.");
}

}  // namespace

void register_general_contact(py::module_& module) {
  py::class_<ContactVisualization>(module, "VisuGeneralContact",
                                   "What GeneralContact.visualization is; there is nothing to set.")
      .def("Reset", [](const ContactVisualization&) {}, "Does nothing.");
  py::class_<ContactHandle> contact(module, "GeneralContact",
                                    "Contact of spheres and convex shapes with each other, with triangles and planes, "
                                    "and of spheres with cables; made by mbs.AddGeneralContact().");
  contact.def(py::init([](const py::args&, const py::kwargs&) -> std::unique_ptr<ContactHandle> {
    refuse(ErrorKind::state,
           {"GeneralContact()", "", "it belongs to a system", "", "", "Call mbs.AddGeneralContact()."});
  }));
  contact.def("AddSphereWithMarker", &add_sphere, py::arg("markerIndex"), py::arg("radius"),
              py::arg("contactStiffness"), py::arg("contactDamping"), py::arg("frictionMaterialIndex"),
              "Add a sphere around a marker; returns its number among the spheres.");
  contact.def(
      "AddTrianglesRigidBodyBased",
      [](const ContactHandle& self, const py::object& marker, double stiffness, double damping, int material,
         const py::object& points, const py::object& triangles,
         bool) { return add_triangles(self, marker, stiffness, damping, material, points, triangles); },
      py::arg("rigidBodyMarkerIndex"), py::arg("contactStiffness"), py::arg("contactDamping"),
      py::arg("frictionMaterialIndex"), py::arg("pointList"), py::arg("triangleList"),
      py::arg("staticTriangles") = false,
      "Add triangles in the frame of a marker; returns the number of the first of them.");
  contact.def("AddANCFCable", &add_cable, py::arg("objectIndex"), py::arg("halfHeight"), py::arg("contactStiffness"),
              py::arg("contactDamping"), py::arg("frictionMaterialIndex"),
              "Add an element of a planar cable, which touches spheres as circles in the plane; returns its number "
              "among the cables.");
  contact.def("SetFrictionPairings", &set_friction_pairings, py::arg("frictionPairings"),
              "Coefficients of friction of pairs of materials, a symmetric matrix.");
  contact.def("SetFrictionProportionalZone", &set_proportional_zone, py::arg("frictionProportionalZone"),
              "Slip (m/s) up to which friction grows with it.");
  contact.def("SetFrictionBristles", &set_bristles, py::arg("stiffnessRatio"), py::arg("dampingRatio") = 1.,
              py::arg("staticRatio") = 1.,
              "Tangential springs and dampers for static friction, relative to the normal ones; staticRatio is the "
              "ratio of static to sliding friction. A stiffness of zero switches them off.");
  contact.def("SetSearchTreeCellSize", &set_cells, py::arg("numberOfCells"),
              "Numbers of cells; kept, without effect: cells follow the sizes of spheres.");
  contact.def("SetSearchTreeBox", &set_box, py::arg("pMin"), py::arg("pMax"),
              "Corners of a box; kept, without effect: space has no bounds here.");
  contact.def("GetItemsInBox", &items_in_box, py::arg("pMin"), py::arg("pMax"),
              "Numbers of spheres and triangles whose boxes overlap with a box, by kind; False if there are none.");
  contact.def("GetSphereMarkerBased", &get_sphere, py::arg("localIndex"), py::arg("addData") = false,
              "Place and motion of a sphere in the current state.");
  contact.def("SetSphereMarkerBased", &set_sphere, py::arg("localIndex"), py::arg("contactStiffness") = -1.,
              py::arg("contactDamping") = -1., py::arg("radius") = -1., py::arg("frictionMaterialIndex") = -1,
              "Change a sphere; negative values keep the previous ones.");
  contact.def("GetTriangleRigidBodyBased", &get_triangle, py::arg("localIndex"),
              "Corners and normal of a triangle in the frame of its marker.");
  contact.def("SetTriangleRigidBodyBased", &set_triangle, py::arg("localIndex"), py::arg("points"),
              py::arg("contactRigidBodyIndex") = -1, "Move the corners of a triangle.");
  contact.def("ShortestDistanceAlongLine", &shortest_distance, py::arg("pStart") = std::vector<double>{0, 0, 0},
              py::arg("direction") = std::vector<double>{1, 0, 0}, py::arg("minDistance") = -1e-7,
              py::arg("maxDistance") = 1e7, py::arg("asDictionary") = false, py::arg("cylinderRadius") = 0,
              py::arg("typeIndex") = py::none(),
              "Distance (m) along a line to the first hit; maxDistance if there is no hit.");
  contact.def("UpdateContacts", &update_contacts, py::arg("mainSystem"), "Find the contacts of the current state.");
  contact.def("GetActiveContacts", &active_contacts, py::arg("typeIndex"), py::arg("itemIndex"),
              "What touched at the last search: global numbers, negative where it slips.");
  contact.def("GetSystemODE2RhsContactForces", &contact_forces, py::arg("copy") = false,
              "Generalised forces of contact in the current state.");
  contact.def(
      "_pushes", &pushes, py::arg("configuration"),
      "What pushes: sphere and the other by global numbers (n x 2), points (n x 3), forces on the spheres (n x 3).");
  contact.def("GetPythonObject", &python_object, "Settings and counts as a dictionary.");
  contact.def("Reset", &reset, py::arg("freeMemory") = true,
              "Remove all spheres and triangles, and set everything back.");
  contact.def_property(
      "isActive", [](const ContactHandle& self) { return self.set->active; },
      [](const ContactHandle& self, bool flag) { self.set->active = flag; }, "False: there are no forces.");
  contact.def_property(
      "sphereSphereContact", [](const ContactHandle& self) { return self.set->spheres_touch; },
      [](const ContactHandle& self, bool flag) {
        self.set->spheres_touch = flag;
        ++self.set->shapes;
      },
      "False: spheres touch triangles alone.");
  contact.def_property(
      "frictionProportionalZone", [](const ContactHandle& self) { return self.set->proportional_zone; },
      &set_proportional_zone, "Slip (m/s) up to which friction grows with it.");
  contact.def_property(
      "minRelDistanceSpheresTriangles", [](const ContactHandle& self) { return self.set->nearest_relative_distance; },
      [](const ContactHandle& self, double value) {
        self.set->nearest_relative_distance = require("minRelDistanceSpheresTriangles", "value", value, false, "1");
      },
      "Distance of a sphere's centre from a triangle, in radii, below which they do not touch.");
  contact.def_property_readonly(
      "visualization", [](const ContactHandle&) { return ContactVisualization(); }, "There is nothing to set.");
  contact.def("__repr__", [](const ContactHandle& self) {
    const auto count = [](std::size_t n, const char* what) { return std::to_string(n) + " " + what; };
    const ContactSet& set = *self.set;
    return "<GeneralContact: " + count(set.spheres.size(), "spheres, ") + count(set.cables.size(), "cables, ") +
           count(set.triangles.size(), "triangles, ") + count(set.convex.size(), "convex shapes, ") +
           count(set.planes.size(), "planes>");
  });
  register_convex_contact(contact);
  register_kept(contact);
  register_methods_of_systems(module);
}

}  // namespace dalembert
