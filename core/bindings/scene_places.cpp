// Positions of items for pictures: arrays of all items of a kind in one call, with their own memory.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "alike.hpp"
#include "conversion.hpp"
#include "dalembert/pictures/contour.hpp"
#include "floating_frames.hpp"
#include "item_arguments.hpp"
#include "main_system.hpp"
#include "modal_mesh.hpp"
#include "picture_arrays.hpp"
#include "python_errors.hpp"
#include "record_watch.hpp"
#include "system_container.hpp"

namespace dalembert {
namespace {

// Asks one system; all of it needs the lock of the interpreter.
class ScenePlaces {
 public:
  explicit ScenePlaces(std::shared_ptr<MainSystem> main) : main_(std::move(main)) { changed(); }

  py::array rows(int kind, const py::object& configuration) {
    system("rows").poses(checked_kind(kind), read(configuration), poses_);
    // owned by the array: copying would take as long as computing half of it
    const auto rows = new LargeVector<double>(std::move(poses_.rows));
    const py::capsule owner(rows, [](void* memory) { delete static_cast<LargeVector<double>*>(memory); });
    return py::array_t<double>({static_cast<py::ssize_t>(rows->size() / 12), py::ssize_t{3}, py::ssize_t{4}},
                               rows->data(), owner);
  }
  // None: the object has no mesh nodes of its own, or they do not have this output.
  py::object mesh(int object, const py::object& variable, const py::object& configuration) {
    const int count = find_mesh("mesh", object, variable, configuration);
    if (count == 0) return py::none();
    return new_array({count, static_cast<py::ssize_t>(values_.size()) / count}, values_.data());
  }
  // One number per mesh node, see contour_numbers. Returns None in the same cases as mesh().
  py::object mesh_numbers(int object, const py::object& variable, int component, const py::object& configuration) {
    if (ModalMesh* const modal = modal_mesh(object, configuration); modal != nullptr && modal->has(asked(variable))) {
      py::array_t<double> result(static_cast<py::ssize_t>(modal->nodes()));
      modal->numbers(*main_, asked(variable), component, result.mutable_data());
      return result;
    }
    const int count = find_mesh("mesh_numbers", object, variable, configuration);
    if (count == 0) return py::none();
    py::array_t<double> result(count);
    contour_numbers(values_, values_.size() / static_cast<std::size_t>(count), component, result.mutable_data());
    return result;
  }
  // Positions of mesh nodes in single precision; `rows`: rotation and position of the object. None: ask mesh().
  py::object mesh_points(int object, const Numbers<double>& rows, const py::object& configuration) {
    ModalMesh* const modal = modal_mesh(object, configuration);
    if (modal == nullptr || rows.size() != 12) return py::none();
    py::array_t<float> result({static_cast<py::ssize_t>(modal->nodes()), py::ssize_t{3}});
    modal->points(*main_, std::span<const double, 12>(rows.data(), 12), result.mutable_data());
    return result;
  }
  std::vector<int> frames_of_sensors() { return floating_frames_of_sensors(main_->model); }
  // Position and rotation of the floating frame of a sensor's node, for each row that the sensor has stored; None: its values are global.
  py::object stored_frames(int sensor) {
    const SensorTable frames = main_->sensor_storage.frames(sensor);
    if (frames.columns == 0) return py::none();
    return py::array_t<double>({static_cast<py::ssize_t>(frames.rows()), static_cast<py::ssize_t>(frames.columns)},
                               frames.values.data());
  }
  // Returns, for each item of a kind, the first item with the same appearance.
  py::array look_alikes(int kind) {
    const std::vector<std::int32_t> first = alike(main_->model, checked_kind(kind));
    return py::array_t<std::int32_t>(static_cast<py::ssize_t>(first.size()), first.data());
  }
  py::list names(int kind, const Numbers<std::int32_t>& numbers) {
    const ItemKind of = checked_kind(kind);
    py::list result(static_cast<std::size_t>(numbers.size()));
    for (std::size_t i = 0; const std::int32_t number : all(numbers)) {
      if (number < 0 || number >= main_->model.count(of))
        throw py::index_error("_ScenePlaces.names(...): there is no such item");
      result[i++] = py::str(main_->model.name(of, number));
    }
    return result;
  }
  std::shared_ptr<ModalMeshes> modal_meshes() const { return modal_meshes_; }
  // Whether items have come, gone or other parameters since the last call.
  bool changed() { return watch_.look(main_->model); }

 private:
  static ItemKind checked_kind(int kind) {
    if (kind < 0 || kind >= item_kinds) throw py::value_error("_ScenePlaces: kind: expected 0 to 4");
    return static_cast<ItemKind>(kind);
  }
  // Puts an output of all mesh nodes in values_; returns how many nodes have it.
  int find_mesh(const char* method, int object, const py::object& variable, const py::object& configuration) {
    if (object < 0 || object >= main_->model.count(ItemKind::object))
      throw py::index_error("_ScenePlaces." + std::string(method) + "(...): there is no such object");
    return system(method).mesh_outputs(object, asked(variable), read(configuration), poses_.totals, values_);
  }
  static OutputVariableType asked(const py::object& variable) {
    return static_cast<OutputVariableType>(Enumeration::number(variable.ptr()));
  }
  // Returns None for other objects, and for states other than the visualization state.
  ModalMesh* modal_mesh(int object, const py::object& configuration) {
    ModalMesh* const modal = modal_meshes_->find(*main_, object);
    return modal != nullptr && read(configuration) == ConfigurationType::Visualization ? modal : nullptr;
  }
  System& system(const char* method) { return main_->assembled(method); }
  ConfigurationType read(const py::object& value) {
    const ConfigurationType configuration =
        configuration_argument(value, [] { return std::string("_ScenePlaces(...)"); });
    if (configuration == ConfigurationType::Visualization) main_->look_wanted = true;
    return configuration;
  }

  const std::shared_ptr<MainSystem> main_;
  System::Poses poses_;
  std::vector<double> values_;
  const std::shared_ptr<ModalMeshes> modal_meshes_ = std::make_shared<ModalMeshes>();
  RecordWatch watch_;
};

}  // namespace

void register_scene_places(py::module_& module) {
  py::class_<ModalMeshes, std::shared_ptr<ModalMeshes>>(module, "_ModalMeshes",
                                                        "Meshes of a system that deform by modes.");
  py::class_<ScenePlaces>(module, "_ScenePlaces", "Where the items of a system are, all of one kind at once.")
      .def(py::init<std::shared_ptr<MainSystem>>(), py::arg("mbs"))
      .def("rows", &ScenePlaces::rows, py::arg("kind"), py::arg("configuration"),
           "Rotation and position (n x 3 x 4) of all nodes (0), objects (1) or markers (2); nan where there is none.")
      .def("mesh", &ScenePlaces::mesh, py::arg("objectNumber"), py::arg("variableType"), py::arg("configuration"),
           "An output of all mesh nodes of a super element, row by row; None if it has none of its own.")
      .def("mesh_numbers", &ScenePlaces::mesh_numbers, py::arg("objectNumber"), py::arg("variableType"),
           py::arg("component"), py::arg("configuration"),
           "One number for each of these mesh nodes: a component of the output, or its length (-1).")
      .def("mesh_points", &ScenePlaces::mesh_points, py::arg("objectNumber"), py::arg("rows"), py::arg("configuration"),
           "Positions of these mesh nodes in single precision, of an object that stands as rows of rotation and "
           "position tell; None: mesh() may have them.")
      .def_property_readonly("modal_meshes", &ScenePlaces::modal_meshes, "Meshes of the system that deform by modes.")
      .def("frames_of_sensors", &ScenePlaces::frames_of_sensors,
           "For each sensor the node of the floating frame in whose components its values are; -1: they are global.")
      .def("stored_frames", &ScenePlaces::stored_frames, py::arg("sensorNumber"),
           "Position and rotation (n x 12) of the floating frame of a sensor's node, for each row that the sensor has "
           "stored; None: its values are global.")
      .def("alike", &ScenePlaces::look_alikes, py::arg("kind"),
           "For each item of a kind the number of the first one that has its type and equal parameters of "
           "visualization.")
      .def("names", &ScenePlaces::names, py::arg("kind"), py::arg("numbers"), "Names of items.")
      .def("changed", &ScenePlaces::changed, "Whether items have other parameters than at the last call.");
}

}  // namespace dalembert
