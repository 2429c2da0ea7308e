// BeamSection and BeamSectionGeometry.
#include <pybind11/numpy.h>

#include "containers.hpp"
#include "conversion.hpp"
#include "dalembert/model/member.hpp"
#include "python_errors.hpp"

namespace dalembert {
namespace {

// One attribute: named, read, written.
template <class Section>
struct Attribute {
  const char* name;
  const char* doc;
  py::object (*get)(const Section&);
  void (*set)(Section&, PyObject*);
};

void write_member(const Row& row, PyObject* value, void* member, const char* section) {
  try {
    from_python(value, row, member);
  } catch (const Refusal& refusal) {
    refuse(refusal.kind, {.item = section,
                          .parameter = std::string(row.name),
                          .received = show(value),
                          .expected = refusal.expected,
                          .advice = refusal.advice});
  }
}

template <int N>
py::object matrix_array(const Mat<double, N, N>& m) {
  return py::array_t<double>({N, N}, m.x.data());
}

constexpr Row real_row(std::string_view name) {
  return {.name = name, .storage = Storage::real, .offset = 0, .role = Role::parameter, .check = Check::non_negative};
}

const Attribute<BeamSection> section_attributes[] = {
    {"dampingMatrix", "Damping (6 x 6): forces and torques per rate of strain and curvature.",
     [](const BeamSection& s) { return matrix_array(s.dampingMatrix); },
     [](BeamSection& s, PyObject* value) {
       write_member({.name = "dampingMatrix", .storage = Storage::matrix6, .offset = 0, .role = Role::parameter}, value,
                    &s.dampingMatrix, "BeamSection");
     }},
    {"inertia", "Inertia (3 x 3) of the cross section per length, in kg m.",
     [](const BeamSection& s) { return matrix_array(s.inertia); },
     [](BeamSection& s, PyObject* value) {
       write_member({.name = "inertia", .storage = Storage::matrix3, .offset = 0, .role = Role::parameter}, value,
                    &s.inertia, "BeamSection");
     }},
    {"massPerLength", "Mass per length, in kg/m.",
     [](const BeamSection& s) -> py::object { return py::float_(s.massPerLength); },
     [](BeamSection& s, PyObject* value) {
       write_member(real_row("massPerLength"), value, &s.massPerLength, "BeamSection");
     }},
    {"stiffnessMatrix", "Stiffness (6 x 6): forces and torques per strain and curvature.",
     [](const BeamSection& s) { return matrix_array(s.stiffnessMatrix); },
     [](BeamSection& s, PyObject* value) {
       write_member({.name = "stiffnessMatrix", .storage = Storage::matrix6, .offset = 0, .role = Role::parameter},
                    value, &s.stiffnessMatrix, "BeamSection");
     }},
};

void set_type(BeamSectionGeometry& g, PyObject* value) {
  if (!py::isinstance(value, core_module().attr("CrossSectionType")))
    refuse(ErrorKind::type, {.item = "BeamSectionGeometry",
                             .parameter = "crossSectionType",
                             .received = show(value),
                             .expected = "a member of CrossSectionType"});
  g.crossSectionType = static_cast<CrossSectionType>(py::handle(value).cast<std::uint32_t>());
}

void set_points(BeamSectionGeometry& g, PyObject* value) {
  g.polygonalPoints = core_module().attr("Vector2DList")(py::handle(value)).cast<EntryList<Vec<double, 2>>>().entries;
}

const Attribute<BeamSectionGeometry> geometry_attributes[] = {
    {"crossSectionRadiusY", "Radius of a circular cross section along y, in m.",
     [](const BeamSectionGeometry& g) -> py::object { return py::float_(g.crossSectionRadiusY); },
     [](BeamSectionGeometry& g, PyObject* value) {
       write_member(real_row("crossSectionRadiusY"), value, &g.crossSectionRadiusY, "BeamSectionGeometry");
     }},
    {"crossSectionRadiusZ", "Radius of a circular cross section along z, in m.",
     [](const BeamSectionGeometry& g) -> py::object { return py::float_(g.crossSectionRadiusZ); },
     [](BeamSectionGeometry& g, PyObject* value) {
       write_member(real_row("crossSectionRadiusZ"), value, &g.crossSectionRadiusZ, "BeamSectionGeometry");
     }},
    {"crossSectionType", "Polygon or Circular.",
     [](const BeamSectionGeometry& g) {
       return enum_member("CrossSectionType", static_cast<std::uint32_t>(g.crossSectionType));
     },
     set_type},
    {"polygonalPoints", "Points (y, z) of a polygon, in m.",
     [](const BeamSectionGeometry& g) -> py::object { return py::cast(EntryList<Vec<double, 2>>{g.polygonalPoints}); },
     set_points},
};

template <class Section, std::size_t N>
void register_section(py::module_& module, const char* name, const char* doc,
                      const Attribute<Section> (&attributes)[N]) {
  const std::span<const Attribute<Section>> rows(attributes);
  const auto get_dictionary = [rows](const Section& section) {
    py::dict values;
    for (const auto& row : rows) values[row.name] = row.get(section);
    return values;
  };
  const auto set_dictionary = [rows, name](Section& section, const py::dict& values) {
    Section changed = section;
    for (const auto& [key, value] : values) {
      const auto word = py::cast<std::string>(key);
      const auto found = std::ranges::find(rows, word, &Attribute<Section>::name);
      std::vector<std::string_view> known;
      for (const auto& row : rows) known.emplace_back(row.name);
      if (found == rows.end())
        refuse(ErrorKind::name, {.problem = std::string(name) + " has no parameter " + in_quotes(word),
                                 .advice = suggestion(word, known)});
      found->set(changed, value.ptr());
    }
    section = std::move(changed);
  };
  py::class_<Section> section(module, name, doc);
  section.def(py::init<>());
  for (const auto& row : rows)
    section.def_property(
        row.name, [&row](const Section& s) { return row.get(s); },
        [&row](Section& s, const py::object& value) { row.set(s, value.ptr()); }, row.doc);
  section.def("GetDictionary", get_dictionary, "All attributes as a dictionary.");
  section.def("SetDictionary", set_dictionary, py::arg("d"),
              "Set the attributes that a dictionary names. An error changes nothing.");
  section.def("__repr__", [get_dictionary, name](const Section& s) {
    return std::string(name) + std::string(py::str(get_dictionary(s)));
  });
  section.def("__copy__", [](const Section& s) { return Section(s); });
  section.def("__deepcopy__", [](const Section& s, const py::dict&) { return Section(s); });
  section.def(py::pickle(get_dictionary, [set_dictionary](const py::dict& values) {
    Section s;
    set_dictionary(s, values);
    return s;
  }));
}

}  // namespace

void register_beam_sections(py::module_& module) {
  register_section<BeamSection>(module, "BeamSection", "Mechanical properties of the cross section of a beam.",
                                section_attributes);
  register_section<BeamSectionGeometry>(module, "BeamSectionGeometry",
                                        "Shape of the cross section of a beam, for drawing.", geometry_attributes);
}

}  // namespace dalembert
