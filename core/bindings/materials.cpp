// GraphicsMaterialList: the materials that scripts define for a renderer. They are kept; nothing is drawn with them.
#include <pybind11/stl.h>

#include "containers.hpp"
#include "conversion.hpp"
#include "dalembert/model/errors.hpp"
#include "python_errors.hpp"

namespace dalembert {
namespace {

constexpr int default_materials = 10;

struct GraphicsMaterialList {
  std::vector<py::object> materials;  // VSettingsMaterial
};

py::object material_class() { return core_module().attr("VSettingsMaterial"); }

void reset_materials(GraphicsMaterialList& list) {
  const py::object raytracer = core_module().attr("VisualizationSettings")().attr("raytracer");
  const py::object copy = py::module_::import("copy").attr("copy");
  list.materials.clear();
  for (int i = 0; i < default_materials; ++i)
    list.materials.push_back(copy(raytracer.attr(("material" + std::to_string(i)).c_str())));
}

// A copy of a material, or one made of a dictionary.
py::object as_material(const py::object& value) {
  if (py::isinstance(value, material_class())) return py::module_::import("copy").attr("copy")(value);
  if (!py::isinstance<py::dict>(value))
    refuse(ErrorKind::type, {.item = "GraphicsMaterialList",
                             .received = show(value.ptr()),
                             .expected = "a VSettingsMaterial or a dictionary"});
  py::object material = material_class()();
  material.attr("SetDictionary")(value);
  return material;
}

std::size_t position_of(const GraphicsMaterialList& list, const py::object& index_or_name) {
  if (py::isinstance<py::str>(index_or_name)) {
    for (std::size_t i = 0; i < list.materials.size(); ++i)
      if (py::object(list.materials[i].attr("name")).equal(index_or_name)) return i;
    std::vector<std::string> names;
    for (const py::object& material : list.materials) names.push_back(material.attr("name").cast<std::string>());
    const std::vector<std::string_view> known(names.begin(), names.end());
    const auto name = index_or_name.cast<std::string>();
    refuse(ErrorKind::value, {.problem = "there is no material " + in_quotes(name), .advice = suggestion(name, known)});
  }
  const auto n = static_cast<py::ssize_t>(list.materials.size());
  const py::ssize_t index = PyNumber_AsSsize_t(index_or_name.ptr(), PyExc_IndexError);
  if (index == -1 && PyErr_Occurred() != nullptr) throw py::error_already_set();
  if (index < -n || index >= n)
    refuse(ErrorKind::index, {.problem = "there is no material " + std::to_string(index),
                              .advice = "The list has " + std::to_string(n) + " materials."});
  return static_cast<std::size_t>(index < 0 ? index + n : index);
}

}  // namespace

void register_materials(py::module_& module) {
  using List = GraphicsMaterialList;
  py::class_<List> list(module, "GraphicsMaterialList", "Materials for drawing, by number or name.");
  const auto get = [](const List& self, const py::object& key) { return self.materials[position_of(self, key)]; };
  list.def(py::init([] {
    List self;
    reset_materials(self);
    return self;
  }));
  list.def("Reset", &reset_materials, "Go back to the ten default materials.");
  list.def(
      "Append",
      [](List& self, const py::object& material) {
        self.materials.push_back(as_material(material));
        return self.materials.size() - 1;
      },
      py::arg("material"), "Append a material (VSettingsMaterial or dictionary); return its number.");
  list.def("New", [](List&) { return material_class()(); }, "A new material with defaults; it is not in the list.");
  list.def(
      "Set",
      [](List& self, const py::object& key, const py::object& material) {
        self.materials[position_of(self, key)] = as_material(material);
      },
      py::arg("indexOrName"), py::arg("material"), "Replace a material.");
  list.def("Get", get, py::arg("indexOrName"), "The material itself: changes of it stay.");
  list.def(
      "GetDict", [get](const List& self, const py::object& key) { return get(self, key).attr("GetDictionary")(); },
      py::arg("indexOrName"), "The material as a dictionary.");
  list.def("__len__", [](const List& self) { return self.materials.size(); });
  list.def("__getitem__", get);
  list.def("__repr__", [](const List& self) { return py::str(py::cast(self.materials)); });
}

}  // namespace dalembert
