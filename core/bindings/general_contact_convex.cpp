// Convex shapes, planes and height fields of GeneralContact.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>

#include "general_contact_handle.hpp"
#include "index_types.hpp"
#include "item_arguments.hpp"

namespace dalembert {
namespace {

int marker_argument(const ContactHandle& self, const char* method, const py::object& marker) {
  return item_number_argument(*self.main, ItemKind::marker, marker.ptr(),
                              [&] { return "GeneralContact." + std::string(method); });
}

int add_convex(const ContactHandle& self, const char* method, int marker, ConvexDefinition definition,
               const ContactSurface& surface) {
  Model& model = self.main->restructure(ContactHandle::called(method));
  self.set->convex.push_back({marker, std::move(definition), surface});
  ++self.set->shapes;
  model.term_source_changed();
  return static_cast<int>(self.set->convex.size()) - 1;
}

int add_box(const ContactHandle& self, const py::object& marker, const py::object& size, double stiffness,
            double damping, int material, const py::object& centre) {
  constexpr const char* method = "AddBoxWithMarker";
  const int number = marker_argument(self, method, marker);
  const Vec3<double> sides = vector_argument(method, "size", size);
  for (int i = 0; i < 3; ++i)
    if (!(sides[i] > 0)) refuse_value(method, "size", show(size.ptr()), "3 positive numbers (unit m)");
  return add_convex(self, method, number, box_definition(vector_argument(method, "centerPoint", centre), sides),
                    surface_of(method, stiffness, damping, material));
}

int add_round(const ContactHandle& self, const char* method, ConvexKind kind, const py::object& marker, double radius,
              const py::object& along, double stiffness, double damping, int material, const py::object& from) {
  const int number = marker_argument(self, method, marker);
  const Vec3<double> axis = vector_argument(method, "vAxis", along),
                     begin = from.is_none() ? -0.5 * axis : vector_argument(method, "pAxis", from);
  ConvexDefinition definition{kind, {begin, begin + axis}, {}, require(method, "radius", radius, true, "m")};
  if (!(norm(axis) > 0)) refuse_value(method, "vAxis", show(along.ptr()), "a vector that is not zero (unit m)");
  return add_convex(self, method, number, std::move(definition), surface_of(method, stiffness, damping, material));
}

// Computes the triangles of a convex hull by scipy (Qhull), with outward normals, and the points that are corners.
ConvexDefinition hull_of(const char* method, const Array& points, const py::object& given) {
  const auto refuse_points = [&](const std::string& what) {
    refuse_value(method, "pointList", what, "at least 4 points that are not in one plane");
  };
  if (points.shape(0) < 4) refuse_points(std::to_string(points.shape(0)) + " points");
  py::object hull;
  try {
    hull = py::module_::import("scipy.spatial").attr("ConvexHull")(points);
  } catch (py::error_already_set& error) {
    if (!error.matches(py::module_::import("scipy.spatial").attr("QhullError"))) throw;
    refuse_points("points in one plane, " + std::string(show(given.ptr())));
  }
  const Array corners = Array::ensure(hull.attr("vertices")), triangles = Array::ensure(hull.attr("simplices")),
              planes = Array::ensure(hull.attr("equations"));
  ConvexDefinition definition;
  std::vector<int> number(static_cast<std::size_t>(points.shape(0)), -1);
  std::vector<double> sorted(corners.data(), corners.data() + corners.size());
  std::ranges::sort(sorted);
  const auto p = points.unchecked<2>();
  for (const double c : sorted) {
    const auto at = static_cast<py::ssize_t>(c);
    number[static_cast<std::size_t>(at)] = static_cast<int>(definition.points.size());
    definition.points.push_back({p(at, 0), p(at, 1), p(at, 2)});
  }
  for (py::ssize_t i = 0; i < triangles.shape(0); ++i) {
    std::array<int, 3> t{};
    for (py::ssize_t k = 0; k < 3; ++k)
      t[static_cast<std::size_t>(k)] = number[static_cast<std::size_t>(triangles.at(i, k))];
    const auto at = [&](std::size_t k) { return definition.points[static_cast<std::size_t>(t[k])]; };
    const Vec3<double> outwards{planes.at(i, 0), planes.at(i, 1), planes.at(i, 2)};
    if (dot(cross(at(1) - at(0), at(2) - at(0)), outwards) < 0) std::swap(t[1], t[2]);
    definition.triangles.push_back(t);
  }
  const std::string fault = fault_of(definition);
  if (!fault.empty()) refuse_points(fault);
  return definition;
}

int add_hull(const ContactHandle& self, const py::object& marker, const py::object& points, double stiffness,
             double damping, int material) {
  constexpr const char* method = "AddConvexHullWithMarker";
  const int number = marker_argument(self, method, marker);
  const Array table = table_argument<Array>(method, "pointList", points, 3);
  for (py::ssize_t i = 0; i < table.shape(0); ++i)
    for (py::ssize_t k = 0; k < 3; ++k)
      if (!std::isfinite(table.at(i, k)))
        refuse_value(method, "pointList[" + std::to_string(i) + "]", text_of(table.at(i, k)),
                     "3 finite numbers (unit m)");
  const ContactSurface surface = surface_of(method, stiffness, damping, material);
  return add_convex(self, method, number, hull_of(method, table, points), surface);
}

int add_plane(const ContactHandle& self, const py::object& marker, const py::object& normal, double stiffness,
              double damping, int material, const py::object& point) {
  constexpr const char* method = "AddPlane";
  const int number = marker_argument(self, method, marker);
  const Vec3<double> up = vector_argument(method, "normal", normal);
  if (!(norm(up) > 0)) refuse_value(method, "normal", show(normal.ptr()), "a vector that is not zero");
  const ContactPlane plane{number, (1 / norm(up)) * up, vector_argument(method, "point", point),
                           surface_of(method, stiffness, damping, material)};
  Model& model = self.main->restructure(ContactHandle::called(method));
  self.set->planes.push_back(plane);
  ++self.set->shapes;
  model.term_source_changed();
  return static_cast<int>(self.set->planes.size()) - 1;
}

// Two triangles for each cell of a grid, with normals upwards.
int add_height_field(const ContactHandle& self, const py::object& marker, const py::object& heights,
                     const py::object& cell, double stiffness, double damping, int material, const py::object& origin) {
  constexpr const char* method = "AddHeightField";
  const int number = marker_argument(self, method, marker);
  const ContactSurface surface = surface_of(method, stiffness, damping, material);
  Array table = Array::ensure(heights);
  if (!table) PyErr_Clear();
  if (!table || table.ndim() != 2 || table.shape(0) < 2 || table.shape(1) < 2)
    refuse_value(method, "heights", show(heights.ptr()), "an array with at least 2 rows, of x, and 2 columns, of y");
  std::array<double, 2> size{};
  try {
    const std::vector<double> numbers = read_reals(cell.ptr());
    if (numbers.size() == 2) std::ranges::copy(numbers, size.begin());
  } catch (const Refusal&) {
  }
  if (!(size[0] > 0 && size[1] > 0) || !std::isfinite(size[0] + size[1]))
    refuse_value(method, "cellSize", show(cell.ptr()), "2 positive numbers, along x and y (unit m)");
  const Vec3<double> from = vector_argument(method, "origin", origin);
  const auto h = table.unchecked<2>();
  const auto point = [&](py::ssize_t i, py::ssize_t k) {
    if (!std::isfinite(h(i, k)))
      refuse_value(method, "heights[" + std::to_string(i) + "," + std::to_string(k) + "]", text_of(h(i, k)),
                   "a finite number (unit m)");
    return Vec3<double>{from[0] + static_cast<double>(i) * size[0], from[1] + static_cast<double>(k) * size[1],
                        from[2] + h(i, k)};
  };
  std::vector<Triangle> added;
  for (py::ssize_t i = 0; i + 1 < h.shape(0); ++i)
    for (py::ssize_t k = 0; k + 1 < h.shape(1); ++k) {
      added.push_back({point(i, k), point(i + 1, k), point(i + 1, k + 1)});
      added.push_back({point(i, k), point(i + 1, k + 1), point(i, k + 1)});
    }
  return add_triangles_of_body(self, method, number, surface, added);
}

// Uses a separate term, so that the solver's own term does not change.
py::dict places(const ContactHandle& self) {
  const Ports* ports = nullptr;
  const GeneralContact& own = self.term("GetConvexContacts", ports);
  GeneralContact term(self.set, *ports, Model::term_name(static_cast<std::size_t>(self.number())));
  term.take_bristles_of(own);
  const std::vector<GeneralContact::ConvexPlace> found = term.convex_places(*ports);
  const auto n = static_cast<py::ssize_t>(found.size());
  py::array_t<int> pairs({n, py::ssize_t{2}});
  std::vector<double> points, normals, forces, gaps, shares;
  for (py::ssize_t i = 0; i < n; ++i) {
    const GeneralContact::ConvexPlace& place = found[static_cast<std::size_t>(i)];
    pairs.mutable_at(i, 0) = place.first;
    pairs.mutable_at(i, 1) = place.second;
    points.insert(points.end(), place.point.x.begin(), place.point.x.end());
    normals.insert(normals.end(), place.normal.x.begin(), place.normal.x.end());
    forces.insert(forces.end(), place.force.x.begin(), place.force.x.end());
    gaps.push_back(place.gap);
    shares.push_back(place.share);
  }
  py::dict result;
  result["pairs"] = pairs;
  result["points"] = new_array({n, 3}, points.data());
  result["normals"] = new_array({n, 3}, normals.data());
  result["forces"] = new_array({n, 3}, forces.data());
  result["gaps"] = new_array({n}, gaps.data());
  result["shares"] = new_array({n}, shares.data());
  return result;
}

}  // namespace

void register_convex_contact(py::class_<ContactHandle>& contact) {
  const std::vector<double> zero{0, 0, 0};
  contact.def("AddBoxWithMarker", &add_box, py::arg("markerIndex"), py::arg("size"), py::arg("contactStiffness"),
              py::arg("contactDamping"), py::arg("frictionMaterialIndex"), py::arg("centerPoint") = zero,
              "Add a box in the axes of a marker; returns its number among the convex shapes.");
  const auto add_round_shape = [&](const char* method, ConvexKind kind, const char* text) {
    contact.def(
        method,
        [method, kind](const ContactHandle& self, const py::object& marker, double radius, const py::object& along,
                       double stiffness, double damping, int material, const py::object& from) {
          return add_round(self, method, kind, marker, radius, along, stiffness, damping, material, from);
        },
        py::arg("markerIndex"), py::arg("radius"), py::arg("vAxis"), py::arg("contactStiffness"),
        py::arg("contactDamping"), py::arg("frictionMaterialIndex"), py::arg("pAxis") = py::none(), text);
  };
  add_round_shape("AddCylinderWithMarker", ConvexKind::cylinder,
                  "Add a cylinder along vAxis from pAxis, by default around the marker; returns its number among the "
                  "convex shapes.");
  add_round_shape("AddCapsuleWithMarker", ConvexKind::capsule,
                  "Add all that is nearer than the radius to a segment along vAxis from pAxis, by default around the "
                  "marker; returns its number among the convex shapes.");
  contact.def("AddConvexHullWithMarker", &add_hull, py::arg("markerIndex"), py::arg("pointList"),
              py::arg("contactStiffness"), py::arg("contactDamping"), py::arg("frictionMaterialIndex"),
              "Add the convex hull of points in the frame of a marker; returns its number among the convex shapes.");
  contact.def("AddPlane", &add_plane, py::arg("rigidBodyMarkerIndex"), py::arg("normal"), py::arg("contactStiffness"),
              py::arg("contactDamping"), py::arg("frictionMaterialIndex"), py::arg("point") = zero,
              "Add the half-space below a plane in the frame of a marker, for spheres and convex shapes; returns its "
              "number among the planes.");
  contact.def("AddHeightField", &add_height_field, py::arg("rigidBodyMarkerIndex"), py::arg("heights"),
              py::arg("cellSize"), py::arg("contactStiffness"), py::arg("contactDamping"),
              py::arg("frictionMaterialIndex"), py::arg("origin") = zero,
              "Add triangles of a grid of heights, rows along x and columns along y from origin; returns the number of "
              "the first of them.");
  contact.def("GetConvexContacts", &places,
              "Where convex shapes and planes touch in the current state: pairs by global numbers, points, normals "
              "from the first to the second, forces on the first, gaps, shares of the stiffness.");
}

}  // namespace dalembert
