// mbs.systemData: coordinates of all configurations and index tables of the assembled system.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>

#include "console.hpp"
#include "conversion.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/references.hpp"
#include "index_types.hpp"
#include "item_arguments.hpp"
#include "item_classes.hpp"
#include "main_system.hpp"
#include "module.hpp"
#include "python_errors.hpp"
#include "sequence.hpp"

namespace dalembert {
namespace {

using Configuration = ConfigurationType;
using Data = py::class_<SystemData>;
using Member = std::vector<double> State::*;

// The vectors of a state, by the words that method names are made of.
struct Coordinates {
  const char* name;  // "ODE2Coordinates_t"
  const char* key;   // of GetSystemStateDict
  Member member;
  int Sizes::* size;
  bool reference;  // the reference configuration has them
};
constexpr Coordinates coordinates[] = {
    {"ODE1Coordinates", "ODE1Coords", &State::y, &Sizes::ode1, true},
    {"ODE1Coordinates_t", "ODE1Coords_t", &State::y_t, &Sizes::ode1, false},
    {"ODE2Coordinates", "ODE2Coords", &State::q, &Sizes::ode2, true},
    {"ODE2Coordinates_t", "ODE2Coords_t", &State::v, &Sizes::ode2, false},
    {"ODE2Coordinates_tt", "ODE2Coords_tt", &State::a, &Sizes::ode2, false},
    {"AECoordinates", "AECoords", &State::lambda, &Sizes::ae, false},
    {"DataCoordinates", "dataCoords", &State::data, &Sizes::data, false},
};
const Coordinates& coordinates_of(Member member) {
  return *std::ranges::find(coordinates, member, &Coordinates::member);
}

// Members of GetSystemState, in this order.
constexpr Member state_members[] = {&State::q, &State::v, &State::y, &State::lambda, &State::data};

std::string full_name(const Label& method) { return "mbs.systemData." + method.text(); }

System& assembled(const SystemData& self, const Label& method) {
  return self.main->assembled([&] { return "systemData." + method.text(); });
}

// Solvers do not change it, or update it when other threads may read it.
bool rests(Configuration configuration) {
  return configuration == Configuration::Visualization || configuration == Configuration::Reference;
}

// Access for reading data that solvers do not change.
const System& at_rest(const SystemData& self, const Label& method) {
  return self.main->at_rest([&] { return "systemData." + method.text(); });
}

// The same for one configuration, which solvers may be changing.
const System& with(Configuration configuration, const SystemData& self, const Label& method) {
  if (configuration == Configuration::Visualization) self.main->look_wanted = true;
  return rests(configuration) ? at_rest(self, method) : assembled(self, method);
}

Configuration read_configuration(const py::object& value, const Label& method) {
  return configuration_argument(value, [&] { return full_name(method); });
}

bool has(const Coordinates& which, Configuration configuration) {
  return which.reference || configuration != Configuration::Reference;
}

int size_of(const System& system, const Coordinates& which, Configuration configuration) {
  return has(which, configuration) ? system.sizes().*which.size : 0;
}

// A copy, or a view of the system. After the next Assemble(), the view keeps the previous data.
py::array_t<double> array_of(const std::vector<double>& values, bool copy, const System& system) {
  const auto n = static_cast<py::ssize_t>(values.size());
  if (copy) return new_array({n}, values.data());
  using Held = std::shared_ptr<const void>;
  const py::capsule holder(new Held(system.hold_states()), [](void* held) { delete static_cast<Held*>(held); });
  return py::array_t<double>({n}, {static_cast<py::ssize_t>(sizeof(double))}, values.data(), holder);
}

py::array_t<double> get(const py::object& self, const Coordinates& which, const py::object& where, bool copy) {
  const auto method = [&] { return std::string("Get") + which.name; };
  const auto& data = self.cast<const SystemData&>();
  const Configuration configuration = read_configuration(where, method);
  const System& system = with(configuration, data, method);
  if (!has(which, configuration)) return py::array_t<double>(0);
  if (!copy && configuration == Configuration::Visualization) data.main->always_looked_at = true;
  return array_of(system.state(configuration).*which.member, copy, system);
}

// Numbers for one vector of a state, checked; nothing is written.
std::vector<double> read_coordinates(const System& system, const Coordinates& which, Configuration configuration,
                                     const py::object& value, const Label& method) {
  const int size = size_of(system, which, configuration);
  std::vector<double> numbers(static_cast<std::size_t>(size));
  if (read_plain_reals(value.ptr(), 1, numbers)) return numbers;
  const std::string expected =
      std::to_string(size) + " finite numbers, the " + std::string(which.name) + " of the assembled system";
  try {
    numbers = read_reals(value.ptr());
    if (static_cast<int>(numbers.size()) == size) return numbers;
  } catch (const Refusal& refusal) {
    refuse(refusal.kind,
           {.item = full_name(method), .received = show(value.ptr()), .expected = expected, .advice = refusal.advice});
  }
  refuse(ErrorKind::value, {.item = full_name(method), .received = show(value.ptr()), .expected = expected});
}

// Multipliers that a state of the system has, or zeros, keep their sign; that of others is not known.
MultiplierSign sign_of(const System& system, const std::vector<double>& lambda) {
  if (std::ranges::all_of(lambda, [](double x) { return x == 0; })) return MultiplierSign::motion;
  for (const Configuration c :
       {Configuration::Current, Configuration::Initial, Configuration::StartOfStep, Configuration::Visualization})
    if (const State& state = system.state(c); state.lambda == lambda) return state.sign;
  return MultiplierSign::unknown;
}

void set(const SystemData& self, const Coordinates& which, const py::object& value, const py::object& where) {
  const auto method = [&] { return std::string("Set") + which.name; };
  System& system = assembled(self, method);
  const Configuration configuration = read_configuration(where, method);
  const std::vector<double> numbers = read_coordinates(system, which, configuration, value, method);
  if (which.member == Member(&State::lambda)) system.state(configuration).sign = sign_of(system, numbers);
  // In place: views stay valid.
  std::ranges::copy(numbers, (system.state(configuration).*which.member).begin());
}

py::array_t<double> total(const SystemData& self, const py::object& where) {
  const Configuration configuration = read_configuration(where, "GetODE2CoordinatesTotal");
  const System& system = with(configuration, self, "GetODE2CoordinatesTotal");
  std::vector<double> sum = system.state(Configuration::Reference).q;
  if (configuration != Configuration::Reference)
    std::ranges::transform(sum, system.state(configuration).q, sum.begin(), std::plus<>());
  return new_array({static_cast<py::ssize_t>(sum.size())}, sum.data());
}

py::list system_state(const py::object& self, const py::object& where) {
  py::list state;
  for (const Member member : state_members) state.append(get(self, coordinates_of(member), where, true));
  return state;
}

void set_system_state(const SystemData& self, const py::object& value, const py::object& where) {
  constexpr const char* method = "SetSystemState";
  System& system = assembled(self, method);
  const Configuration configuration = read_configuration(where, method);
  constexpr std::size_t n = std::size(state_members);
  if (!py::isinstance<py::sequence>(value) || py::len(value) != n)
    refuse(ErrorKind::value,
           {.item = full_name(method),
            .received = show(value.ptr()),
            .expected = "a list of 5 vectors: ODE2 coordinates, their velocities, ODE1, AE and data coordinates"});
  std::array<std::vector<double>, n> numbers;
  for (std::size_t i = 0; i < n; ++i)
    numbers[i] = read_coordinates(system, coordinates_of(state_members[i]), configuration, value[py::int_(i)], method);
  for (std::size_t i = 0; i < n; ++i)
    if (state_members[i] == Member(&State::lambda)) system.state(configuration).sign = sign_of(system, numbers[i]);
  for (std::size_t i = 0; i < n; ++i)
    std::ranges::copy(numbers[i], (system.state(configuration).*state_members[i]).begin());
}

py::dict state_dictionary(const py::object& self, const py::object& where, bool reference) {
  py::dict state;
  for (const Coordinates& which : coordinates) state[which.key] = get(self, which, where, !reference);
  return state;
}

// ---- index tables
// ------------------------------------------------------------------------------------------------------

int item_number(const SystemData& self, ItemKind kind, const py::object& value, const Label& method) {
  ItemKind given = kind;
  int number = -1;
  const std::string noun(kind_name(kind));
  const std::string expected = "the number of " + std::string(kind == ItemKind::object ? "an " : "a ") + noun + ": " +
                               std::string(index_name(kind)) + ", int or name";
  if (PyUnicode_Check(value.ptr())) {
    number = number_of(self.main->model, kind, to_string(value.ptr()), full_name(method), noun + "Number");
  } else if (!read_index(value.ptr(), given, number)) {
    try {
      number = read_integer(value.ptr());
    } catch (const Refusal& refusal) {
      refuse(refusal.kind, {.item = full_name(method), .received = show(value.ptr()), .expected = expected});
    }
  }
  if (given != kind)
    refuse(ErrorKind::type, {.item = full_name(method), .received = show(value.ptr()), .expected = expected});
  if (self.main->model.find_item(kind, number) == nullptr)
    refuse(ErrorKind::index,
           {.item = full_name(method),
            .problem = "there is no " + noun + " " + std::to_string(number),
            .advice = "The system has " + std::to_string(self.main->model.count(kind)) + " " + noun + "s."});
  return number;
}

struct Table {
  const char* name;
  System::Coordinates kind;
};
constexpr Table tables[] = {{"ODE2", System::Coordinates::ode2},
                            {"ODE1", System::Coordinates::ode1},
                            {"AE", System::Coordinates::ae},
                            {"Data", System::Coordinates::data}};

void register_tables(Data& data) {
  for (const Table& table : tables) {
    const std::string object_method = std::string("GetObjectLTG") + table.name,
                      node_method = std::string("GetNodeLTG") + table.name;
    data.def(
        object_method.c_str(),
        [object_method, kind = table.kind](const SystemData& self, const py::object& number) {
          const System& system = at_rest(self, object_method);
          return system.object_ltg(item_number(self, ItemKind::object, number, object_method), kind);
        },
        py::arg("objectNumber"), "Global numbers of the object's coordinates.");
    data.def(
        node_method.c_str(),
        [node_method, kind = table.kind](const SystemData& self, const py::object& number) {
          const System& system = at_rest(self, node_method);
          return system.node_ltg(item_number(self, ItemKind::node, number, node_method), kind);
        },
        py::arg("nodeNumber"), "Global numbers of the node's coordinates.");
  }
}

// ---- loads that depend on coordinates
// ------------------------------------------------------------------------------------

void add_load_dependencies(const SystemData& self, const py::object& load, const py::object& value) {
  constexpr const char* method = "AddODE2LoadDependencies";
  System& system = assembled(self, method);
  const int number = item_number(self, ItemKind::load, load, method);
  const int size = system.sizes().ode2;
  std::vector<int> indices;
  try {
    const Items items(value.ptr(), "a list of global ODE2 coordinate numbers");
    for (Py_ssize_t i = 0; i < items.size(); ++i) {
      const int index = read_integer(items[i]);
      if (index < 0 || index >= size)
        refuse(ErrorKind::index, {.item = full_name(method),
                                  .parameter = "globalODE2coordinates",
                                  .received = std::to_string(index),
                                  .expected = "numbers from 0 to " + std::to_string(size - 1)});
      indices.push_back(index);
    }
  } catch (const Refusal& refusal) {
    refuse(refusal.kind, {.item = full_name(method),
                          .parameter = "globalODE2coordinates",
                          .received = show(value.ptr()),
                          .expected = refusal.expected});
  }
  self.main->add_load_dependencies(number, indices);
}

// ---- texts
// ---------------------------------------------------------------------------------------------------------------

void info(const SystemData& self) {
  const Model& model = self.main->model;
  std::string text;
  for (const ItemKind kind : {ItemKind::node, ItemKind::object, ItemKind::marker, ItemKind::load, ItemKind::sensor})
    for (int i = 0; i < model.count(kind); ++i) {
      const Item& item = model.item(kind, i);
      text += std::string(kind_name(kind)) + std::to_string(i) + ":\n    " +
              std::string(py::str(item_dictionary(*item.type, item.record.get(), model.name(kind, i), false))) + "\n";
    }
  write_console(text);
}

std::string list_text(std::span<const int> numbers) {
  std::string text = "[";
  for (std::size_t i = 0; i < numbers.size(); ++i) text += (i == 0 ? "" : ",") + std::to_string(numbers[i]);
  return text + "]";
}

void info_ltg(const SystemData& self) {
  System& system = assembled(self, "InfoLTG");
  std::string text;
  for (const Table& table : tables)
    for (int i = 0; i < self.main->model.count(ItemKind::object); ++i)
      text += "object " + std::to_string(i) + " " + table.name + " LTG=" + list_text(system.object_ltg(i, table.kind)) +
              "\n";
  for (int i = 0; i < self.main->model.count(ItemKind::load); ++i)
    if (const auto coordinates = system.load_dependencies(i); !coordinates.empty())
      text += "load " + std::to_string(i) + " ODE2 dependencies=" + list_text(coordinates) + "\n";
  write_console(text);
}

// ---- methods
// -------------------------------------------------------------------------------------------------------------

void register_numbers(Data& data) {
  for (const ItemKind kind : {ItemKind::load, ItemKind::marker, ItemKind::node, ItemKind::object, ItemKind::sensor}) {
    const std::string name = "NumberOf" + std::string(kind_title(kind)) + "s";
    data.def(
        name.c_str(), [kind](const SystemData& self) { return self.main->model.count(kind); }, "How many there are.");
  }
}

void register_sizes(Data& data, const py::object& current) {
  for (const auto& size : {std::pair{"ODE2Size", &State::q},
                           {"ODE1Size", &State::y},
                           {"AEsize", &State::lambda},
                           {"DataSize", &State::data}})
    data.def(
        size.first,
        [name = std::string(size.first), member = size.second](const SystemData& self, const py::object& where) {
          const System& system = at_rest(self, name);
          return size_of(system, coordinates_of(member), read_configuration(where, name));
        },
        py::arg("configurationType") = current, "Number of these coordinates.");
  // Data coordinates do not count, as in Exudyn.
  data.def(
      "SystemSize",
      [](const SystemData& self, const py::object& where) {
        const System& system = at_rest(self, "SystemSize");
        const Configuration configuration = read_configuration(where, "SystemSize");
        int size = 0;
        for (const Member member : {&State::q, &State::y, &State::lambda})
          size += size_of(system, coordinates_of(member), configuration);
        return size;
      },
      py::arg("configurationType") = current, "Number of ODE2, ODE1 and AE coordinates.");
}

void register_time(Data& data, const py::object& current) {
  data.def(
      "GetTime",
      [](const SystemData& self, const py::object& where) {
        const Configuration configuration = read_configuration(where, "GetTime");
        if (!self.main->system.assembled()) return 0.0;
        if (!rests(configuration)) require_own_thread(*self.main, "mbs.systemData.GetTime(...)");
        if (configuration == Configuration::Visualization) self.main->look_wanted = true;
        return self.main->system.state(configuration).time;
      },
      py::arg("configurationType") = current, "Time of a configuration, in s.");
  data.def(
      "SetTime",
      [](const SystemData& self, const py::object& time, const py::object& where) {
        System& system = assembled(self, "SetTime");
        try {
          system.state(read_configuration(where, "SetTime")).time = read_real(time.ptr());
        } catch (const Refusal& refusal) {
          refuse(refusal.kind, {.item = full_name("SetTime"),
                                .parameter = "newTime",
                                .received = show(time.ptr()),
                                .expected = refusal.expected});
        }
      },
      py::arg("newTime"), py::arg("configurationType") = current, "Set the time of a configuration, in s.");
}

void register_coordinates(Data& data, const py::object& current) {
  data.def("GetODE2CoordinatesTotal", &total, py::arg("configuration") = current,
           "ODE2 coordinates plus those of the reference configuration.");
  for (const Coordinates& which : coordinates) {
    data.def(
        (std::string("Get") + which.name).c_str(),
        [&which](const py::object& self, const py::object& where, bool copy) { return get(self, which, where, copy); },
        py::arg("configuration") = current, py::arg("copy") = true,
        "Coordinates as an array. copy=False: a view, which writes to the system until the next Assemble(); from then "
        "on it "
        "keeps what was there.");
    data.def((std::string("Set") + which.name).c_str(),
             [&which](const SystemData& self, const py::object& value, const py::object& where) {
               set(self, which, value, where);
             },
             py::arg("coordinates"), py::arg("configuration") = current,
             "Set coordinates: as many finite numbers as there are.");
  }
  // For copies of systems, whose multipliers are those of solutions.
  data.def(
      "_GetMultiplierSign",
      [](const SystemData& self, const py::object& where) {
        const auto method = [] { return std::string("_GetMultiplierSign"); };
        return static_cast<int>(assembled(self, method).state(read_configuration(where, method)).sign);
      },
      py::arg("configuration") = current, "0: of dynamics, 1: of statics, 2: not known.");
  data.def(
      "_SetMultiplierSign",
      [](const SystemData& self, int sign, const py::object& where) {
        const auto method = [] { return std::string("_SetMultiplierSign"); };
        assembled(self, method).state(read_configuration(where, method)).sign =
            static_cast<MultiplierSign>(std::clamp(sign, 0, 2));
      },
      py::arg("sign"), py::arg("configuration") = current, "Set what _GetMultiplierSign gave.");
  data.def("GetSystemState", &system_state, py::arg("configuration") = current,
           "Copies of [ODE2, ODE2_t, ODE1, AE, data] coordinates.");
  data.def("SetSystemState", &set_system_state, py::arg("systemStateList"), py::arg("configuration") = current,
           "Set a state of GetSystemState. An error changes nothing.");
  data.def("GetSystemStateDict", &state_dictionary, py::arg("configuration") = current, py::arg("reference") = false,
           "All coordinates by name; reference=True: views, see GetODE2Coordinates.");
}

}  // namespace

void register_system_data(py::module_& module) {
  const py::object current = enum_member("ConfigurationType", static_cast<std::uint32_t>(Configuration::Current));
  Data data(module, "SystemData", "Coordinates and index tables of a system.");
  register_numbers(data);
  register_sizes(data, current);
  register_time(data, current);
  register_coordinates(data, current);
  register_tables(data);
  data.def("AddODE2LoadDependencies", &add_load_dependencies, py::arg("loadNumber"), py::arg("globalODE2coordinates"),
           "Say that a load depends on ODE2 coordinates, e.g. in its user function. Known also after further "
           "Assemble(), until a "
           "node is deleted or replaced.");
  data.def("Info", &info, "Print all items.");
  data.def("InfoLTG", &info_ltg, "Print the index tables of objects, and the dependencies of loads.");
}

}  // namespace dalembert
