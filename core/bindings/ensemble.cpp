// The compiled part of mbs.SolveVariations(...): arrays to varied values and back; the threads run without the interpreter.
#include "dalembert/solvers/diagonally_implicit.hpp"
#include "dalembert/solvers/ensemble.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>

#include "console.hpp"
#include "controllers.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/solvers/explicit.hpp"
#include "dalembert/solvers/second_order.hpp"
#include "dalembert/solvers/static.hpp"
#include "index_types.hpp"
#include "item_arguments.hpp"
#include "item_classes.hpp"
#include "main_system.hpp"
#include "module.hpp"
#include "python_callback.hpp"
#include "python_errors.hpp"
#include "sequence.hpp"
#include "settings.hpp"
#include "symbolic.hpp"

namespace dalembert {
namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

constexpr const char* method = "SolveVariations";
const std::string call = "mbs.SolveVariations(...)";

// The vectors of a state, by the words that methods of systemData are made of.
struct Part {
  const char* name;
  std::vector<double> State::* member;
};
constexpr Part parts[] = {{"ODE2", &State::q},     {"ODE2_t", &State::v},  {"ODE2_tt", &State::a}, {"ODE1", &State::y},
                          {"ODE1_t", &State::y_t}, {"AE", &State::lambda}, {"Data", &State::data}};

std::unique_ptr<Solver> make_solver(const std::string& kind) {
  if (kind == "static") return std::make_unique<StaticSolver>();
  if (kind == "diagonally implicit") return std::make_unique<DiagonallyImplicitSolver>();
  if (kind == "explicit") return std::make_unique<ExplicitSolver>();
  return std::make_unique<SecondOrderSolver>();
}

// ---- items that need the interpreter --------------------------------------------------------------------------------

void refuse_function(const std::string& problem) {
  refuse(ErrorKind::state, {.item = call,
                            .problem = problem,
                            .advice = "Write it with dalembert.symbolic or as a C function, or use "
                                      "dalembert.processing.ParameterVariation, which runs "
                                      "Python in several processes."});
}

void refuse_python_functions(const MainSystem& main) {
  for (const auto& [name, function] : main.user_functions)
    if (!function.is_none()) refuse_function("variations call no " + name + "UserFunction, which the system has");
  for (int k = 0; k < item_kinds; ++k) {
    const ItemKind kind = static_cast<ItemKind>(k);
    for (int i = 0; i < main.model.count(kind); ++i) {
      const Item& item = main.model.item(kind, i);
      for (const Row& row : item.type->rows) {
        if (row.storage != Storage::user_function || row.role == Role::visualization) continue;
        const auto& function = *static_cast<const UserFunction*>(member(item.record.get(), row));
        if (function && is_sampled(*function.callback))
          refuse(
              ErrorKind::state,
              {.item = call,
               .problem = main.model.describe(kind, i) +
                          " has a sampled controller, and variations are solved in steps that do not wait for samples",
               .advice = "Use its law without sampling, or dalembert.processing.ParameterVariation"});
        if (needs_interpreter(function))
          refuse_function(main.model.describe(kind, i) + " has the Python function " + in_quotes(row.name) +
                          ", and variations are solved without the interpreter");
      }
    }
  }
}

// ---- varied values -----------------------------------------------------------------------------------------------------

bool numeric(Storage storage) {
  switch (storage) {
    case Storage::text:
    case Storage::output_variable:
    case Storage::joint_types:
    case Storage::beam_section:
    case Storage::user_function:
    case Storage::opaque:
    case Storage::enumeration: return false;
    default: return true;
  }
}

// Calls `write(value)` for each row of `values`; a rejection names the variation.
template <class Write>
void each_variation(const py::sequence& values, Write&& write) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    const py::object value = values[k];
    try {
      write(static_cast<int>(k), value.ptr());
    } catch (const ModelError& error) {
      throw ModelError(error.kind(), call + ", variation " + std::to_string(k) + ": " + error.what());
    }
  }
}

// A constant of a recorded function, of which other constants may vary as well: those that were read before.
void read_constant(const Model& model, ItemKind kind, int number, const RecordedConstant& constant,
                   const py::sequence& given, int variations, std::vector<VariedParameter>& parameters) {
  VariedParameter p{kind, number, &constant.row, make_varied_values(Storage::user_function, variations)};
  const auto same = [&](const VariedParameter& other) {
    return other.kind == p.kind && other.number == p.number && other.row == p.row;
  };
  const auto last = std::find_if(parameters.rbegin(), parameters.rend(), same);
  each_variation(given, [&](int k, PyObject* value) {
    UserFunction function{constant.function};
    if (last != parameters.rend()) last->values->write(k, &function);
    double x = 0;
    try {
      x = read_real(value);
    } catch (const Refusal& refusal) {
      refuse(refusal.kind, {model.describe(p.kind, p.number), std::string(constant.row.name) + "." + constant.name, "",
                            show(value), "a finite number", ""});
    }
    function = read_user_function(with_constant(*function.callback, constant.name, x).ptr(), constant.row);
    p.values->keep(k, &function);
  });
  parameters.push_back(std::move(p));
}

void read_parameter(const MainSystem& main, const py::tuple& entry, int variations,
                    std::vector<VariedParameter>& parameters) {
  VariedParameter p;
  const py::object index = entry[0];
  if (!read_index(index.ptr(), p.kind, p.number))
    refuse(ErrorKind::type,
           {.item = call,
            .parameter = "parameters",
            .received = show(entry.ptr()),
            .expected = "(index of an item, name of a parameter)",
            .advice = "Use the index that AddObject(...) or AddNode(...) returned: it knows its kind."});
  p.number = item_number_argument(main, p.kind, index.ptr(), method);
  const Item& item = main.model.item(p.kind, p.number);
  const std::string where = main.model.describe(p.kind, p.number), name = entry[1].cast<std::string>();
  if (const auto constants = constants_named(main.model, p.kind, p.number, name); !constants.empty()) {
    for (const RecordedConstant& constant : constants)
      read_constant(main.model, p.kind, p.number, constant, py::sequence(entry[2]), variations, parameters);
    return;
  }
  p.row = find_row(*item.type, name);
  if (p.row == nullptr)
    refuse(ErrorKind::value,
           {where, "", "there is no parameter " + in_quotes(name), "", "", suggest_parameter(*item.type, name)});
  if (p.row->internal)
    refuse(ErrorKind::value, {where, name, "cannot be set", "", "", "It is computed by the system."});
  if (p.row->role != Role::parameter || !numeric(p.row->storage))
    refuse(ErrorKind::type, {where, name, "cannot be varied", "", "a parameter that is made of numbers", ""});
  p.values = make_varied_values(p.row->storage, variations);
  const std::shared_ptr<void> scratch = item.type->record.copy(item.record.get());
  each_variation(py::sequence(entry[2]), [&](int k, PyObject* value) {
    set_member(class_of(*item.type), *p.row, value, scratch.get(), where);
    p.values->keep(k, member(scratch.get(), *p.row));
  });
  parameters.push_back(std::move(p));
}

// The parameter at a dotted path, as attributes would find it.
SettingsField find_setting(SettingsView view, std::string_view path) {
  for (;;) {
    const std::size_t dot = path.find('.');
    const std::string_view name = path.substr(0, dot);
    const SettingsField field = find_field(view, name);
    if (!field) refuse_unknown(view, name);
    if (dot == std::string_view::npos || field.row != nullptr || field.without_effect) return field;
    view = field.child != nullptr ? field.view.child(*field.child) : field.view;
    path.remove_prefix(dot + 1);
  }
}

VariedSetting read_setting(const SimulationSettings& simulation, const py::tuple& entry, int variations) {
  const SettingsTree tree{&simulation_settings_group(), record_operations<SimulationSettings>(), simulation_aliases()};
  const auto scratch = std::make_shared<SimulationSettings>(simulation);
  const auto path = entry[0].cast<std::string>();
  const SettingsField field = find_setting({&tree, tree.group, scratch, scratch.get(), ""}, path);
  if (field.row == nullptr || !numeric(field.row->storage))
    refuse(ErrorKind::type,
           {.item = call,
            .parameter = "settings",
            .received = in_quotes(path),
            .expected = "the path of a setting that is made of numbers, e.g. 'timeIntegration.endTime'"});
  const void* place = member(field.view.data, *field.row);
  VariedSetting s{
      static_cast<std::size_t>(static_cast<const char*>(place) - reinterpret_cast<const char*>(scratch.get())),
      make_varied_values(field.row->storage, variations)};
  each_variation(py::sequence(entry[1]), [&](int k, PyObject* value) {
    write_setting(field.view, *field.row, value);
    s.values->keep(k, place);
  });
  return s;
}

VariedCoordinates read_coordinates(const State& initial, const py::tuple& entry, int variations) {
  const auto name = entry[0].cast<std::string>();
  const auto values = entry[1].cast<Array>();
  std::vector<std::string_view> known;
  for (const Part& part : parts) {
    known.push_back(part.name);
    if (name != part.name) continue;
    const auto size = static_cast<py::ssize_t>((initial.*part.member).size());
    if (values.ndim() != 2 || values.shape(1) != size || values.shape(0) != variations)
      refuse(ErrorKind::value,
             {.item = call,
              .parameter = "initialCoordinates[" + in_quotes(name) + "]",
              .received = "an array of shape " + py::repr(entry[1].attr("shape")).cast<std::string>(),
              .expected = "shape (" + std::to_string(variations) + ", " + std::to_string(size) + ")",
              .advice = "A row for each variation, a column for each coordinate of the assembled system."});
    return {part.member, {values.data(), values.data() + values.size()}};
  }
  refuse(ErrorKind::value, {.item = call,
                            .parameter = "initialCoordinates",
                            .received = in_quotes(name),
                            .advice = suggestion(name, known)});
}

// ---- results as arrays -------------------------------------------------------------------------------------------------

Array missing(std::vector<py::ssize_t> shape) {
  Array array(std::move(shape));
  std::fill_n(array.mutable_data(), array.size(), std::numeric_limits<double>::quiet_NaN());
  return array;
}

// Returns one row per variation; variations without values are NaN.
template <class Values>
Array table(const std::vector<VariationResult>& results, py::ssize_t columns, Values&& values_of) {
  Array array = missing({static_cast<py::ssize_t>(results.size()), columns});
  for (std::size_t k = 0; k < results.size(); ++k) {
    const std::vector<double>& values = values_of(results[k]);
    if (static_cast<py::ssize_t>(values.size()) == columns)
      std::ranges::copy(values, array.mutable_data(static_cast<py::ssize_t>(k)));
  }
  return array;
}

// Times and values of all sensors, row by row; shorter histories are padded with NaN.
std::pair<Array, py::array_t<int>> history_arrays(const std::vector<VariationResult>& results,
                                                  const std::vector<int>& sensors, py::ssize_t columns) {
  const auto rows_of = [&](const VariationResult& r) {
    return sensors.empty() || r.histories.empty() ? 0 : r.histories[static_cast<std::size_t>(sensors.front())].rows();
  };
  int most = 0;
  py::array_t<int> rows(static_cast<py::ssize_t>(results.size()));
  for (std::size_t k = 0; k < results.size(); ++k) {
    rows.mutable_at(static_cast<py::ssize_t>(k)) = rows_of(results[k]);
    most = std::max(most, rows_of(results[k]));
  }
  Array array = missing({static_cast<py::ssize_t>(results.size()), most, columns + 1});
  for (std::size_t k = 0; k < results.size(); ++k) {
    for (int i = 0; i < rows_of(results[k]); ++i) {
      double* out = array.mutable_data(static_cast<py::ssize_t>(k), i, 0);
      for (std::size_t s = 0; s < sensors.size(); ++s) {
        const SensorTable& t = results[k].histories[static_cast<std::size_t>(sensors[s])];
        const double* row = t.values.data() + static_cast<std::size_t>(i) * static_cast<std::size_t>(t.columns);
        if (s == 0) *out++ = row[0];
        out = std::copy_n(row + 1, t.columns - 1, out);
      }
    }
  }
  return {array, rows};
}

py::dict arrays(const std::vector<VariationResult>& results, const Ensemble& ensemble, const State& initial,
                int columns) {
  py::dict all;
  const auto n = static_cast<py::ssize_t>(results.size());
  py::array_t<bool> success(n);
  py::array_t<double> times(n);
  py::list messages, warnings, alone;
  for (py::ssize_t k = 0; k < n; ++k) {
    const VariationResult& r = results[static_cast<std::size_t>(k)];
    success.mutable_at(k) = r.solved;
    alone.append(r.alone);
    times.mutable_at(k) = r.time;
    messages.append(r.message);
    warnings.append(r.warnings);
  }
  all["success"] = success;
  all["alone"] = alone;
  all["messages"] = messages;
  all["warnings"] = warnings;
  all["endTimes"] = times;
  all["sensorValues"] = table(results, columns, [](const VariationResult& r) -> const auto& { return r.values; });
  const auto [histories, rows] = history_arrays(results, ensemble.sensors, columns);
  all["sensorHistories"] = histories;
  all["historyRows"] = rows;
  py::dict states;
  for (const Part& part : parts) {
    if (!ensemble.states) break;
    const auto size = static_cast<py::ssize_t>((initial.*part.member).size());
    states[part.name] =
        table(results, size, [&](const VariationResult& r) -> const auto& { return r.state.*part.member; });
  }
  all["coordinates"] = states;
  return all;
}

py::dict solve(const std::shared_ptr<MainSystem>& main, const py::object& settings, const std::string& kind,
               int variations, const py::list& parameters, const py::list& varied_settings, const py::list& coordinates,
               const std::vector<int>& sensors, bool histories, bool states, int threads) {
  require_idle(*main, call);
  System& system = main->assembled(method);
  refuse_python_functions(*main);
  Ensemble ensemble{.variations = variations,
                    .simulation = *simulation_settings_of(settings),
                    .sensors = sensors,
                    .histories = histories,
                    .states = states,
                    .timeout = solver_switches().timeout};
  ensemble.make_solver = [kind] { return make_solver(kind); };
  const State initial = system.state(ConfigurationType::Initial);
  for (const auto& entry : parameters) read_parameter(*main, entry.cast<py::tuple>(), variations, ensemble.parameters);
  for (const auto& entry : varied_settings)
    ensemble.settings.push_back(read_setting(ensemble.simulation, entry.cast<py::tuple>(), variations));
  for (const auto& entry : coordinates)
    ensemble.coordinates.push_back(read_coordinates(initial, entry.cast<py::tuple>(), variations));
  int columns = 0;
  for (const int sensor : sensors) {
    std::vector<double> values;
    system.sensor_values(sensor, ConfigurationType::Initial, values);
    columns += static_cast<int>(values.size());
  }
  std::vector<VariationResult> results;
  {
    const Model model = main->model;
    const py::gil_scoped_release release;
    results = solve_ensemble(ensemble, model, initial, threads, [] {
      const py::gil_scoped_acquire gil;
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    });
  }
  return arrays(results, ensemble, initial, columns);
}

}  // namespace

void register_ensemble(py::module_& module) {
  module.def("_SolveVariations", &solve, py::arg("mbs"), py::arg("simulationSettings"), py::arg("solver"),
             py::arg("variations"), py::arg("parameters"), py::arg("settings"), py::arg("initialCoordinates"),
             py::arg("sensors"), py::arg("histories"), py::arg("states"), py::arg("threads"),
             "What mbs.SolveVariations calls: lists of tuples with arrays in, a dictionary of arrays out.");
}

}  // namespace dalembert
