// The methods of MainSystem that need the assembled system.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "conversion.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/model/references.hpp"
#include "item_arguments.hpp"
#include "main_system.hpp"
#include "python_errors.hpp"
#include "sequence.hpp"

namespace dalembert {
namespace {

using Class = py::class_<MainSystem, std::shared_ptr<MainSystem>>;

std::string called(const char* method) { return "mbs." + std::string(method) + "(...)"; }

// Enumerations are checked here, so that the text can name method and argument.
OutputVariableType variable_argument(const py::object& value, const char* method) {
  static const Enumeration variables("OutputVariableType");
  if (!variables.has(value.ptr()))
    refuse(ErrorKind::type, {called(method), "variableType", "", show(value.ptr()), "a member of OutputVariableType",
                             member_advice("OutputVariableType", value.ptr())});
  return static_cast<OutputVariableType>(Enumeration::number(value.ptr()));
}

ConfigurationType current_or(MainSystem& main, const py::object& value, const char* method) {
  if (value.is_none()) return ConfigurationType::Current;
  const ConfigurationType configuration = configuration_argument(value, [&] { return called(method); });
  if (configuration == ConfigurationType::Visualization) main.look_wanted = true;
  return configuration;
}

std::array<double, 3> position_argument(const py::object& value, const char* method) {
  std::array<double, 3> position{};
  if (read_plain_reals(value.ptr(), 1, position)) return position;
  try {
    const std::vector<double> values = read_reals(value.ptr());
    if (values.size() != position.size()) throw Refusal{ErrorKind::value, "3 numbers", ""};
    std::ranges::copy(values, position.begin());
  } catch (const Refusal& refusal) {
    refuse(refusal.kind, {called(method), "localPosition", "", show(value.ptr()), "3 finite numbers (unit m)", ""});
  }
  return position;
}

// Accepts a number; kinematic trees also accept the name of a link.
int mesh_node_argument(const MainSystem& main, int object, const py::object& value, const char* method) {
  if (PyUnicode_Check(value.ptr()))
    return number_of_link(main.model.item(ItemKind::object, object), Named::links, to_string(value.ptr()),
                          called(method), "meshNodeNumber");
  try {
    return read_integer(value.ptr());
  } catch (const Refusal& refusal) {
    refuse(refusal.kind,
           {called(method), "meshNodeNumber", "", show(value.ptr()), "an integer, or the name of a link", ""});
  }
}

py::object array(const std::vector<double>& values) {
  return new_array({static_cast<py::ssize_t>(values.size())}, values.data());
}
// A single value is returned as a number.
py::object number_or_array(const std::vector<double>& values) {
  return values.size() == 1 ? py::object(py::float_(values[0])) : array(values);
}

// Rigid transformations are returned as HT.
py::object output_value(OutputVariableType variable, const std::vector<double>& values) {
  if (variable != OutputVariableType::HomogeneousTransformation &&
      variable != OutputVariableType::HomogeneousTransformationLocal)
    return number_or_array(values);
  return py::module_::import("dalembert._geometry.rigid_transformation").attr("of_matrix")(array(values));
}

// Source of an output: the assembled system or, in the reference configuration, the item alone.
struct Source {
  Source(MainSystem& main, const char* method, ItemKind kind, int item, ConfigurationType configuration) {
    if (configuration == ConfigurationType::Reference && !main.consistent()) {
      excerpt = main.excerpts.of(main.model, kind, item);
      system = excerpt->system.get();
      number = excerpt->number;
    } else {
      system = &main.assembled(method);
      number = item;
    }
  }
  std::shared_ptr<const Excerpt> excerpt;  // valid for nested calls from user functions
  System* system = nullptr;
  int number = -1;
};

void register_assembly(Class& main_system) {
  const auto all = [](const char* method) { return [method](MainSystem& main) { main.assemble(method); }; };
  main_system.def("Assemble", all("Assemble"), "Check the model and build the system of equations from it.");
  // The interface has separate methods for the parts of Assemble. One of them performs all work that follows from the
  // items.
  const auto number = [](const char* method) {
    return [method](MainSystem& main) {
      require_idle(main, [&] { return called(method); });
      if (!main.consistent()) main.assemble(method);
    };
  };
  main_system.def("AssembleCoordinates", number("AssembleCoordinates"),
                  "A part of Assemble(): number the coordinates, if items have changed.");
  main_system.def("AssembleLTGLists", number("AssembleLTGLists"),
                  "A part of Assemble(): list the coordinates of objects, if items have changed.");
  main_system.def("AssembleInitializeSystemCoordinates", all("AssembleInitializeSystemCoordinates"),
                  "A part of Assemble(): take over reference and initial values of all nodes, and start from them.");
  main_system.def(
      "AssembleSystemInitialize", [](MainSystem& main) { main.assembled("AssembleSystemInitialize"); },
      "A part of Assemble(): take over changed parameters of the other items.");
}

void register_outputs(Class& main_system) {
  main_system.def(
      "GetNodeOutput",
      [](MainSystem& main, const py::object& node, const py::object& variable, const py::object& configuration) {
        const int number = item_number_argument(main, ItemKind::node, node.ptr(), "GetNodeOutput");
        const ConfigurationType in = current_or(main, configuration, "GetNodeOutput");
        const Source source(main, "GetNodeOutput", ItemKind::node, number, in);
        std::vector<double> values;
        const OutputVariableType asked = variable_argument(variable, "GetNodeOutput");
        source.system->node_output(source.number, asked, in, values);
        return output_value(asked, values);
      },
      py::arg("nodeNumber"), py::arg("variableType"), py::arg("configuration") = py::none(),
      "An output variable of a node, in the current configuration or another one; a number or an array, in the units "
      "of the node's page.");
  main_system.def(
      "GetObjectOutput",
      [](MainSystem& main, const py::object& object, const py::object& variable, const py::object& configuration) {
        const int number = item_number_argument(main, ItemKind::object, object.ptr(), "GetObjectOutput");
        std::vector<double> values;
        System& system = main.assembled("GetObjectOutput");
        const OutputVariableType asked = variable_argument(variable, "GetObjectOutput");
        system.object_output(number, asked, current_or(main, configuration, "GetObjectOutput"), values);
        return output_value(asked, values);
      },
      py::arg("objectNumber"), py::arg("variableType"), py::arg("configuration") = py::none(),
      "An output variable of an object, e.g. the force in a connector; a number or an array, in the units of its "
      "page.");
  main_system.def(
      "GetObjectOutputBody",
      [](MainSystem& main, const py::object& object, const py::object& variable, const py::object& position,
         const py::object& configuration) {
        const char* const method = "GetObjectOutputBody";
        const int number = item_number_argument(main, ItemKind::object, object.ptr(), method);
        const auto local = position_argument(position, method);
        const ConfigurationType in = current_or(main, configuration, method);
        const Source source(main, method, ItemKind::object, number, in);
        std::vector<double> values;
        const OutputVariableType asked = variable_argument(variable, method);
        source.system->body_output(source.number, asked, local, in, values);
        return output_value(asked, values);
      },
      py::arg("objectNumber"), py::arg("variableType"), py::arg("localPosition") = std::vector<double>{0, 0, 0},
      py::arg("configuration") = py::none(), "An output variable of a body at a local position.");
  main_system.def(
      "GetObjectOutputSuperElement",
      [](MainSystem& main, const py::object& object, const py::object& variable, const py::object& mesh_node,
         const py::object& configuration) {
        const char* const method = "GetObjectOutputSuperElement";
        const int number = item_number_argument(main, ItemKind::object, object.ptr(), method);
        std::vector<double> values;
        const OutputVariableType asked = variable_argument(variable, method);
        main.assembled(method).super_element_output(number, asked, mesh_node_argument(main, number, mesh_node, method),
                                                    current_or(main, configuration, method), values);
        return output_value(asked, values);
      },
      py::arg("objectNumber"), py::arg("variableType"), py::arg("meshNodeNumber"),
      py::arg("configuration") = py::none(), "An output variable of a super element at one of its mesh nodes.");
  main_system.def(
      "GetMarkerOutput",
      [](MainSystem& main, const py::object& marker, const py::object& variable, const py::object& configuration) {
        const int number = item_number_argument(main, ItemKind::marker, marker.ptr(), "GetMarkerOutput");
        const ConfigurationType in = current_or(main, configuration, "GetMarkerOutput");
        const Source source(main, "GetMarkerOutput", ItemKind::marker, number, in);
        std::vector<double> values;
        const OutputVariableType asked = variable_argument(variable, "GetMarkerOutput");
        source.system->marker_output(source.number, asked, in, values);
        return asked == OutputVariableType::HomogeneousTransformation ? output_value(asked, values) : array(values);
      },
      py::arg("markerNumber"), py::arg("variableType"), py::arg("configuration") = py::none(),
      "An output variable of a marker, such as its position (m).");
}

bool keeps_values(const Item& sensor) {
  const bool* stores = member_of<bool>(sensor, "storeInternal");
  return stores == nullptr || *stores;
}

void register_loads_and_sensors(Class& main_system) {
  main_system.def(
      "GetLoadValues",
      [](MainSystem& main, const py::object& load) {
        const int number = item_number_argument(main, ItemKind::load, load.ptr(), "GetLoadValues");
        System& system = main.assembled("GetLoadValues");
        std::vector<double> values;
        system.load_values(number, system.state(ConfigurationType::Current).time, values);
        return number_or_array(values);
      },
      py::arg("loadNumber"), "The value of a load at the current time.");
  main_system.def(
      "GetSensorValues",
      [](MainSystem& main, const py::object& sensor, const py::object& configuration) {
        const int number = item_number_argument(main, ItemKind::sensor, sensor.ptr(), "GetSensorValues");
        std::vector<double> values;
        main.assembled("GetSensorValues")
            .sensor_values(number, current_or(main, configuration, "GetSensorValues"), values);
        return number_or_array(values);
      },
      py::arg("sensorNumber"), py::arg("configuration") = py::none(),
      "The value of a sensor, in the current configuration or another one; a number or an array, in the units of its "
      "output variable.");
  main_system.def(
      "GetSensorStoredData",
      [](MainSystem& main, const py::object& sensor) -> py::object {
        const int number = item_number_argument(main, ItemKind::sensor, sensor.ptr(), "GetSensorStoredData");
        require_own_thread(main, "mbs.GetSensorStoredData(...)");
        SensorTable table = main.sensor_storage.table(number);
        if (table.rows() == 0 && !keeps_values(main.model.item(ItemKind::sensor, number))) {
          refuse(ErrorKind::value, {.item = main.model.describe(ItemKind::sensor, number),
                                    .problem = "it has stored no values, because it was added with storeInternal=False",
                                    .advice = "Add it with storeInternal=True."});
        }
        const std::array<py::ssize_t, 2> shape{table.rows(), table.columns};
        auto values = std::make_unique<std::vector<double>>(std::move(table.values));
        double* const first = values->data();
        const py::capsule owner(values.get(), [](void* kept) { delete static_cast<std::vector<double>*>(kept); });
        values.release();
        return py::array_t<double>(shape, first, owner);
      },
      py::arg("sensorNumber"), "Rows of time and values that a sensor with storeInternal=True has recorded.");
}

void register_indices(Class& main_system) {
  struct Entry {
    const char* method;
    const char* coordinates;
    System::Coordinates kind;
  };
  for (const Entry entry : {Entry{"GetNodeODE2Index", "ODE2", System::Coordinates::ode2},
                            Entry{"GetNodeODE1Index", "ODE1", System::Coordinates::ode1},
                            Entry{"GetNodeAEIndex", "algebraic", System::Coordinates::ae}}) {
    main_system.def(
        entry.method,
        [entry](MainSystem& main, const py::object& node) {
          const int number = item_number_argument(main, ItemKind::node, node.ptr(), entry.method);
          const int index = main.at_rest(entry.method).node_index(number, entry.kind);
          if (index < 0) {
            refuse(ErrorKind::value,
                   {called(entry.method), "",
                    main.model.describe(ItemKind::node, number) + " has no " + entry.coordinates + " coordinates", "",
                    "", "Ask for the coordinates that this type of node has."});
          }
          return index;
        },
        py::arg("nodeNumber"), "The first global coordinate of a node in the vector of the whole system.");
  }
}

}  // namespace

void register_main_system_assembled(Class& main_system) {
  register_assembly(main_system);
  register_outputs(main_system);
  register_loads_and_sensors(main_system);
  register_indices(main_system);
}

}  // namespace dalembert
