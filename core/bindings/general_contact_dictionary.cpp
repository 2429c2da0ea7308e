// GeneralContact as a dictionary, for copies, pickles and files: numbers in columns, by the names of the arguments that brought them.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <limits>

#include "general_contact_checks.hpp"
#include "main_system.hpp"
#include "python_errors.hpp"

namespace dalembert {

Array friction_argument(const ValueSource& by, const py::object& pairings) {
  const Array table = Array::ensure(pairings);
  if (!table) PyErr_Clear();
  if (!table || table.ndim() != 2 || table.shape(0) != table.shape(1) || table.shape(0) == 0)
    refuse_value(by, "frictionPairings", show(pairings.ptr()), "a square matrix of coefficients of friction");
  const auto mu = table.unchecked<2>();
  for (py::ssize_t i = 0; i < mu.shape(0); ++i)
    for (py::ssize_t j = 0; j < mu.shape(1); ++j) {
      const std::string entry = "frictionPairings[" + std::to_string(i) + "," + std::to_string(j) + "]";
      if (!(mu(i, j) >= 0) || !std::isfinite(mu(i, j)))
        refuse_value(by, entry, text_of(mu(i, j)), "a coefficient of friction that is not negative");
      if (mu(i, j) != mu(j, i))
        refuse_value(by, entry, text_of(mu(i, j)), text_of(mu(j, i)) + ", as the other way round: action is reaction");
    }
  return table;
}

ContactBristles bristles_from(const ValueSource& by, const std::array<double, 3>& ratios) {
  if (!(ratios[2] >= 1) || !std::isfinite(ratios[2]))
    refuse_value(by, "staticRatio", text_of(ratios[2]), "a number from 1 (unit 1)");
  return {require(by, "stiffnessRatio", ratios[0], false, "1"), require(by, "dampingRatio", ratios[1], false, "1"),
          ratios[2]};
}

std::vector<double> bristles_out(const ContactSet& set) {
  return {set.bristles.stiffness, set.bristles.damping, set.bristles.holding};
}

py::array_t<double> friction_out(const ContactSet& set) {
  return new_array({set.materials, set.materials}, set.friction.data());
}

namespace {

constexpr const char* convex_axes[] = {"x", "y", "z"};
constexpr const char* plane_normals[] = {"normalX", "normalY", "normalZ"};
constexpr const char* plane_points[] = {"pointX", "pointY", "pointZ"};

// ---- writing ---------------------------------------------------------------------------------------------------------

// Makes a column from the results of f for each entry.
template <class Thing, class F>
auto column(const std::vector<Thing>& things, const F& f) {
  using Number = decltype(f(things[0]));
  py::array_t<Number> result(static_cast<py::ssize_t>(things.size()));
  std::ranges::transform(things, result.mutable_data(), f);
  return result;
}

template <class Thing>
void put_surfaces(py::dict& group, const std::vector<Thing>& things) {
  group["contactStiffness"] = column(things, [](const Thing& t) { return t.surface.stiffness; });
  group["contactDamping"] = column(things, [](const Thing& t) { return t.surface.damping; });
  group["frictionMaterialIndex"] = column(things, [](const Thing& t) { return t.surface.material; });
}

void put_convex(py::dict& result, const ContactSet& set) {
  py::dict shapes, points, triangles;
  std::vector<Vec3<double>> all_points;
  std::vector<std::array<int, 3>> all_triangles;
  for (const ContactConvex& c : set.convex) {
    all_points.insert(all_points.end(), c.definition.points.begin(), c.definition.points.end());
    all_triangles.insert(all_triangles.end(), c.definition.triangles.begin(), c.definition.triangles.end());
  }
  shapes["markerIndex"] = column(set.convex, [](const ContactConvex& c) { return c.marker; });
  shapes["kind"] = column(set.convex, [](const ContactConvex& c) { return static_cast<int>(c.definition.kind); });
  shapes["radius"] = column(set.convex, [](const ContactConvex& c) { return c.definition.radius; });
  shapes["points"] =
      column(set.convex, [](const ContactConvex& c) { return static_cast<int>(c.definition.points.size()); });
  shapes["triangles"] =
      column(set.convex, [](const ContactConvex& c) { return static_cast<int>(c.definition.triangles.size()); });
  put_surfaces(shapes, set.convex);
  for (int i = 0; i < 3; ++i) {
    points[convex_axes[i]] = column(all_points, [i](const Vec3<double>& p) { return p[i]; });
    triangles[convex_axes[i]] =
        column(all_triangles, [i](const std::array<int, 3>& t) { return t[static_cast<std::size_t>(i)]; });
  }
  result["convexShapes"] = shapes;
  result["convexPoints"] = points;
  result["convexTriangles"] = triangles;
}

void put_planes(py::dict& result, const ContactSet& set) {
  py::dict planes;
  planes["rigidBodyMarkerIndex"] = column(set.planes, [](const ContactPlane& p) { return p.marker; });
  for (int i = 0; i < 3; ++i) {
    planes[plane_normals[i]] = column(set.planes, [i](const ContactPlane& p) { return p.normal[i]; });
    planes[plane_points[i]] = column(set.planes, [i](const ContactPlane& p) { return p.point[i]; });
  }
  put_surfaces(planes, set.planes);
  result["planes"] = planes;
}

py::dict groups_of(const ContactSet& set) {
  py::dict spheres, cables, bodies, triangles;
  spheres["markerIndex"] = column(set.spheres, [](const ContactSphere& s) { return s.marker; });
  spheres["radius"] = column(set.spheres, [](const ContactSphere& s) { return s.radius; });
  put_surfaces(spheres, set.spheres);
  cables["objectIndex"] = column(set.cables, [](const ContactCable& c) { return c.object; });
  cables["halfHeight"] = column(set.cables, [](const ContactCable& c) { return c.half_height; });
  put_surfaces(cables, set.cables);
  bodies["rigidBodyMarkerIndex"] = column(set.carriers, [](const ContactCarrier& c) { return c.marker; });
  put_surfaces(bodies, set.carriers);
  triangles["contactRigidBodyIndex"] = column(set.triangles, [](const ContactTriangle& t) { return t.carrier; });
  std::vector<double> corners;
  for (const ContactTriangle& t : set.triangles)
    for (const Vec3<double>& point : t.points) corners.insert(corners.end(), point.x.begin(), point.x.end());
  triangles["points"] = new_array({static_cast<py::ssize_t>(set.triangles.size()), 3, 3}, corners.data());
  py::dict result;
  result["spheres"] = spheres;
  result["cables"] = cables;
  result["triangleBodies"] = bodies;
  result["triangles"] = triangles;
  if (!set.convex.empty()) put_convex(result, set);
  if (!set.planes.empty()) put_planes(result, set);
  return result;
}

py::dict dictionary_of(const ContactSet& set) {
  py::dict result = groups_of(set);
  result["frictionPairings"] = friction_out(set);
  result["frictionProportionalZone"] = set.proportional_zone;
  result["frictionBristles"] = bristles_out(set);
  result["minRelDistanceSpheresTriangles"] = set.nearest_relative_distance;
  result["isActive"] = set.active;
  result["sphereSphereContact"] = set.spheres_touch;
  result["searchTreeSize"] = std::vector<int>(set.cells.begin(), set.cells.end());
  result["searchTreeBox"] = std::vector<double>(set.box.begin(), set.box.end());
  for (const auto& [name, value] : set.without_effect) {
    const auto setting = std::ranges::find(kept_settings, name, &KeptSetting::name);
    result[name.c_str()] =
        setting->is_flag ? py::object(py::bool_(value != 0)) : py::object(py::int_(static_cast<long>(value)));
  }
  return result;
}

// ---- reading ---------------------------------------------------------------------------------------------------------

// Named columns of equal length; a missing group has none.
class Columns {
 public:
  Columns(const std::string& where, const py::dict& data, const char* group, std::vector<const char*> names)
      : where_(where), group_(group) {
    if (!data.contains(group)) return;
    const py::object entries = data[group];
    if (!py::isinstance<py::dict>(entries))
      refuse_value(ValueSource::at(where), group, show(entries.ptr()), "a dictionary");
    const auto given = py::reinterpret_borrow<py::dict>(entries);
    for (const auto& [key, value] : given) {
      const std::string name = py::str(key);
      if (std::ranges::find(names, name) == names.end())
        refuse_value(ValueSource::at(where), group_ + "." + name, "an unknown key", "keys " + all(names));
    }
    for (const char* name : names) {
      Array numbers = given.contains(name) ? Array::ensure(given[name]) : Array();
      if (!numbers) PyErr_Clear();
      const bool is_points = name == std::string("points") && group_ == "triangles";
      if (!given.contains(name) || !numbers || (numbers.size() > 0 && numbers.ndim() != (is_points ? 3 : 1)) ||
          (is_points && numbers.size() > 0 && (numbers.shape(1) != 3 || numbers.shape(2) != 3)))
        refuse_value(ValueSource::at(where), group_ + "." + name,
                     given.contains(name) ? show(py::object(given[name]).ptr()) : "nothing",
                     is_points ? "3 points with 3 coordinates for each triangle" : "a list of numbers");
      const std::size_t size = numbers.size() == 0 ? 0 : static_cast<std::size_t>(numbers.shape(0));
      if (columns_.empty()) size_ = size;
      if (size != size_)
        refuse_value(ValueSource::at(where), group_ + "." + name, "a list of length " + std::to_string(size),
                     "length " + std::to_string(size_) + ", as of " + names[0]);
      columns_.push_back(numbers);
    }
  }
  std::size_t size() const { return size_; }
  const double* numbers(std::size_t column) const { return columns_[column].data(); }
  double real(std::size_t column, std::size_t i) const { return columns_[column].data()[i]; }
  int whole(std::size_t column, std::size_t i, const char* name) const {
    const double x = real(column, i);
    if (std::abs(x) <= std::numeric_limits<int>::max() && x == std::floor(x)) return static_cast<int>(x);
    refuse_value(at(i), name, text_of(x), "a whole number");
  }
  ValueSource at(std::size_t i) const {
    return ValueSource::at(where_ + ": " + group_ + "[" + std::to_string(i) + "]");
  }
  // Reads the three columns from `first` on; the error label is only built on demand.
  ContactSurface surface(std::size_t first, std::size_t i) const {
    const double stiffness = real(first, i), damping = real(first + 1, i);
    const int material = whole(first + 2, i, "frictionMaterialIndex");
    if (stiffness > 0 && damping >= 0 && is_material(material) && std::isfinite(stiffness) && std::isfinite(damping))
      return {stiffness, damping, material};
    return surface_of(at(i), stiffness, damping, material);
  }

 private:
  static std::string all(const std::vector<const char*>& names) {
    std::string text;
    for (const char* name : names) text += (text.empty() ? "" : ", ") + std::string(name);
    return text;
  }
  std::string where_, group_;
  std::vector<Array> columns_;
  std::size_t size_ = 0;
};

void read_groups(const std::string& where, const py::dict& data, ContactSet& set) {
  const Columns spheres(where, data, "spheres",
                        {"markerIndex", "radius", "contactStiffness", "contactDamping", "frictionMaterialIndex"});
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const double radius = spheres.real(1, i);
    if (!(radius > 0) || !std::isfinite(radius)) require(spheres.at(i), "radius", radius, true, "m");
    set.spheres.push_back({spheres.whole(0, i, "markerIndex"), radius, spheres.surface(2, i)});
  }
  const Columns cables(where, data, "cables",
                       {"objectIndex", "halfHeight", "contactStiffness", "contactDamping", "frictionMaterialIndex"});
  for (std::size_t i = 0; i < cables.size(); ++i)
    set.cables.push_back({cables.whole(0, i, "objectIndex"),
                          require(cables.at(i), "halfHeight", cables.real(1, i), false, "m"), cables.surface(2, i)});
  const Columns bodies(where, data, "triangleBodies",
                       {"rigidBodyMarkerIndex", "contactStiffness", "contactDamping", "frictionMaterialIndex"});
  for (std::size_t i = 0; i < bodies.size(); ++i)
    set.carriers.push_back({bodies.whole(0, i, "rigidBodyMarkerIndex"), bodies.surface(1, i)});
  const Columns triangles(where, data, "triangles", {"contactRigidBodyIndex", "points"});
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const int body = triangles.whole(0, i, "contactRigidBodyIndex");
    if (body < 0 || body >= static_cast<int>(set.carriers.size()))
      refuse_value(triangles.at(i), "contactRigidBodyIndex", std::to_string(body),
                   "the number of one of the " + std::to_string(set.carriers.size()) + " triangleBodies");
    const double* p = triangles.numbers(1) + 9 * i;
    if (!std::all_of(p, p + 9, [](double x) { return std::isfinite(x); }))
      refuse_value(triangles.at(i), "points", "a number that is not finite", "finite numbers (unit m)");
    set.triangles.push_back(
        {body, {Vec3<double>{p[0], p[1], p[2]}, Vec3<double>{p[3], p[4], p[5]}, Vec3<double>{p[6], p[7], p[8]}}});
    require_area(triangles.at(i), "points", set.triangles.back().points);
  }
}

void read_convex(const std::string& where, const py::dict& data, ContactSet& set) {
  const Columns shapes(where, data, "convexShapes",
                       {"markerIndex", "kind", "radius", "points", "triangles", "contactStiffness", "contactDamping",
                        "frictionMaterialIndex"});
  const Columns points(where, data, "convexPoints", {convex_axes[0], convex_axes[1], convex_axes[2]}),
      triangles(where, data, "convexTriangles", {convex_axes[0], convex_axes[1], convex_axes[2]});
  std::size_t point = 0, triangle = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const int kind = shapes.whole(1, i, "kind"), own_points = shapes.whole(3, i, "points"),
              own_triangles = shapes.whole(4, i, "triangles");
    if (kind < 0 || kind > static_cast<int>(ConvexKind::cylinder))
      refuse_value(shapes.at(i), "kind", std::to_string(kind), "0 for polytopes, 1 for capsules, 2 for cylinders");
    ConvexDefinition d{
        static_cast<ConvexKind>(kind), {}, {}, require(shapes.at(i), "radius", shapes.real(2, i), kind > 0, "m")};
    if (own_points < 0 || point + static_cast<std::size_t>(own_points) > points.size())
      refuse_value(shapes.at(i), "points", std::to_string(own_points), "no more than are left of convexPoints");
    if (own_triangles < 0 || triangle + static_cast<std::size_t>(own_triangles) > triangles.size())
      refuse_value(shapes.at(i), "triangles", std::to_string(own_triangles),
                   "no more than are left of convexTriangles");
    if (kind > 0 && own_points != 2)
      refuse_value(shapes.at(i), "points", std::to_string(own_points), "2, the ends of the axis");
    for (int k = 0; k < own_points; ++k, ++point) {
      d.points.push_back({points.real(0, point), points.real(1, point), points.real(2, point)});
      if (!std::ranges::all_of(d.points.back().x, [](double x) { return std::isfinite(x); }))
        refuse_value(points.at(point), "x, y, z", "a number that is not finite", "finite numbers (unit m)");
    }
    for (int k = 0; k < own_triangles; ++k, ++triangle) {
      std::array<int, 3> t{};
      for (std::size_t c = 0; c < 3; ++c) {
        t[c] = triangles.whole(c, triangle, convex_axes[c]);
        if (t[c] < 0 || t[c] >= own_points)
          refuse_value(triangles.at(triangle), convex_axes[c], std::to_string(t[c]),
                       "the number of one of the " + std::to_string(own_points) + " points of its shape");
      }
      d.triangles.push_back(t);
    }
    const std::string fault = fault_of(d);
    if (!fault.empty()) refuse_value(shapes.at(i), "points", fault, "a convex body");
    set.convex.push_back({shapes.whole(0, i, "markerIndex"), std::move(d), shapes.surface(5, i)});
  }
}

void read_planes(const std::string& where, const py::dict& data, ContactSet& set) {
  std::vector<const char*> names{"rigidBodyMarkerIndex"};
  names.insert(names.end(), std::begin(plane_normals), std::end(plane_normals));
  names.insert(names.end(), std::begin(plane_points), std::end(plane_points));
  names.insert(names.end(), {"contactStiffness", "contactDamping", "frictionMaterialIndex"});
  const Columns planes(where, data, "planes", names);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Vec3<double> normal{planes.real(1, i), planes.real(2, i), planes.real(3, i)},
        point{planes.real(4, i), planes.real(5, i), planes.real(6, i)};
    if (!(std::abs(norm(normal) - 1) < 1e-9))
      refuse_value(planes.at(i), "normalX, normalY, normalZ", text_of(norm(normal)), "a vector of length 1");
    if (!std::isfinite(norm(point)))
      refuse_value(planes.at(i), "pointX, pointY, pointZ", text_of(norm(point)), "finite numbers (unit m)");
    set.planes.push_back({planes.whole(0, i, "rigidBodyMarkerIndex"), normal, point, planes.surface(7, i)});
  }
}

template <class T>
T entry_of(const std::string& where, const py::dict& data, const char* key, const T& otherwise, const char* expected) {
  if (!data.contains(key)) return otherwise;
  try {
    return py::object(data[key]).cast<T>();
  } catch (const py::cast_error&) {
    refuse_value(ValueSource::at(where), key, show(py::object(data[key]).ptr()), expected);
  }
}

std::shared_ptr<ContactSet> set_from(const std::string& where, const py::dict& data) {
  auto set = std::make_shared<ContactSet>();
  for (const auto& [key, value] : data) {
    constexpr const char* known[] = {"spheres",          "cables",
                                     "triangleBodies",   "triangles",
                                     "convexShapes",     "convexPoints",
                                     "convexTriangles",  "planes",
                                     "frictionPairings", "frictionProportionalZone",
                                     "frictionBristles", "minRelDistanceSpheresTriangles",
                                     "isActive",         "sphereSphereContact",
                                     "searchTreeSize",   "searchTreeBox"};
    const std::string name = py::str(key);
    if (std::ranges::find(known, name) != std::end(known)) continue;
    const auto setting = std::ranges::find(kept_settings, name, &KeptSetting::name);
    if (setting == std::end(kept_settings))
      refuse_value(ValueSource::at(where), name, "an unknown key", "a result of GetDictionary()");
    set->without_effect[name] = entry_of<double>(where, data, setting->name, 0, "a number");
  }
  read_groups(where, data, *set);
  read_convex(where, data, *set);
  read_planes(where, data, *set);
  const bool rubs = data.contains("frictionPairings") && py::len(data["frictionPairings"]) > 0;
  if (rubs) {
    const Array table = friction_argument(ValueSource::at(where), data["frictionPairings"]);
    set->materials = static_cast<int>(table.shape(0));
    set->friction.assign(table.data(), table.data() + table.size());
  }
  const auto real = [&](const char* key, double& value, bool positive, const char* unit) {
    value = require(ValueSource::at(where), key, entry_of(where, data, key, value, "a number"), positive, unit);
  };
  real("frictionProportionalZone", set->proportional_zone, true, "m/s");
  if (data.contains("frictionBristles")) {
    const auto given = entry_of(where, data, "frictionBristles", std::array<double, 3>{},
                                "3 numbers: ratios of stiffness, of damping and of static friction");
    set->bristles = bristles_from(ValueSource::at(where), given);
  }
  real("minRelDistanceSpheresTriangles", set->nearest_relative_distance, false, "1");
  set->active = entry_of(where, data, "isActive", set->active, "True or False");
  set->spheres_touch = entry_of(where, data, "sphereSphereContact", set->spheres_touch, "True or False");
  set->cells = entry_of(where, data, "searchTreeSize", set->cells, "3 whole numbers");
  set->box = entry_of(where, data, "searchTreeBox", set->box, "6 numbers");
  return set;
}

}  // namespace

py::list general_contact_dictionaries(const MainSystem& main) {
  py::list result;
  for (const auto& source : main.model.term_sources())
    result.append(dictionary_of(static_cast<const ContactSet&>(*source)));
  return result;
}

std::shared_ptr<SystemTermSource> general_contact_from(const py::handle& data, const std::string& where) {
  if (!py::isinstance<py::dict>(data)) refuse(ErrorKind::type, {where, "", "", show(data.ptr()), "a dictionary", ""});
  return set_from(where, py::reinterpret_borrow<py::dict>(data));
}

}  // namespace dalembert
