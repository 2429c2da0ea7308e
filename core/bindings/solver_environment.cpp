#include "solver_environment.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <thread>

#include "compiled_callback.hpp"
#include "console.hpp"
#include "controllers.hpp"
#include "conversion.hpp"
#include "dalembert/model/member.hpp"
#include "floating_frames.hpp"
#include "interpreter_lock.hpp"
#include "python_callback.hpp"
#include "python_errors.hpp"

namespace dalembert {

namespace {

// Calls one of the main system's functions with the system, the time and further arguments. Afterwards the system
// uses the parameters that the function has changed.
class SystemFunction {
 public:
  SystemFunction(const std::shared_ptr<MainSystem>& main, std::string name)
      : main_(main), name_(std::move(name)), function_(main->user_function(name_)) {}
  ~SystemFunction() {
    const py::gil_scoped_acquire gil;
    function_ = py::object();
  }
  SystemFunction(const SystemFunction&) = delete;
  SystemFunction& operator=(const SystemFunction&) = delete;

  template <class Read, class... Arguments>
  auto call(Read&& read, double time, Arguments... arguments) const {
    const InterpreterLock lock(InterpreterLock::Afterwards::may_be_kept);
    const auto main = main_.lock();
    const std::array objects{object_of(main), object_of(time), object_of(arguments)...};
    std::array<PyObject*, std::tuple_size_v<decltype(objects)>> passed;
    std::ranges::transform(objects, passed.begin(), [](const py::object& object) { return object.ptr(); });
    const RunningFunction known(main_, RunningFunction::Place::between_evaluations, &words, this);
    PyObject* raw = PyObject_Vectorcall(function_.ptr(), passed.data(), passed.size(), nullptr);
    if (raw == nullptr) throw_python_error("in " + words(this, -1) + ", at time " + std::to_string(time));
    const py::object result = py::reinterpret_steal<py::object>(raw);
    main->assembled(name_);
    try {
      return read(result);
    } catch (const py::cast_error&) {
      refuse_result(result, time);
    }
  }

  template <class T>
  static py::object object_of(const T& x) {
    if constexpr (std::is_same_v<T, py::object>)
      return x;
    else
      return py::cast(x);
  }

  [[noreturn]] void refuse_result(const py::object& result, double time) const {
    const char* expected = name_ == "PostNewton"       ? "a list [error, recommended step size]"
                           : name_ == "Events"         ? "a list of numbers, or of pairs (number, direction)"
                           : name_ == "SystemJacobian" ? "a MatrixContainer"
                                                       : "True to go on, or False to stop";
    refuse(ErrorKind::value, {words(this, -1) + ", at time " + std::to_string(time), "", "",
                              show(result.ptr()) + " as result", expected, "Return it at the end of the function."});
  }

 private:
  static std::string words(const void* function, int) {
    return "mbs." + static_cast<const SystemFunction*>(function)->name_ + "UserFunction";
  }

  std::weak_ptr<MainSystem> main_;
  std::string name_;
  py::object function_;
};

// A compiled C function, which is called directly and kept alive. Empty if the user's function is not compiled.
template <class Result, class... Parameters>
std::function<Result(Parameters...)> c_function(const MainSystem& main, const char* name) {
  py::object owner = main.user_function(name);
  const void* address = compiled_system_function(owner.ptr(), name);
  if (address == nullptr) return nullptr;
  const auto release = [](py::object* object) {
    const py::gil_scoped_acquire gil;
    delete object;
  };
  return [function = reinterpret_cast<Result (*)(Parameters...)>(const_cast<void*>(address)),
          owner = std::shared_ptr<py::object>(new py::object(owner), release)](Parameters... parameters) {
    return function(parameters...);
  };
}

// True or False, as the function returns it; nothing is neither.
template <class... Arguments>
bool ask_whether_to_go_on(const SystemFunction& function, double time, Arguments... arguments) {
  return function.call(
      [&](const py::object& result) {
        if (result.is_none()) function.refuse_result(result, time);
        return result.cast<bool>();
      },
      time, arguments...);
}

std::function<bool(double)> step_function(const std::shared_ptr<MainSystem>& main, const char* name) {
  if (main->user_function(name).is_none()) return nullptr;
  if (auto function = c_function<std::int64_t, double>(*main, name))
    return [function = std::move(function)](double time) { return function(time) != 0; };
  const auto function = std::make_shared<SystemFunction>(main, name);
  return [function](double time) { return ask_whether_to_go_on(*function, time); };
}

std::vector<MatrixEntry> read_entries(const py::object& result) {
  MatrixContainer matrix;
  Row row{};
  row.storage = Storage::matrix_container;
  try {
    from_python(result.ptr(), row, &matrix);
  } catch (const Refusal&) {
    throw py::cast_error();
  }
  std::vector<MatrixEntry> entries;
  for (const auto& t : matrix.triplets) entries.push_back({t.row, t.column, t.value});
  const auto columns = static_cast<std::size_t>(matrix.columns);
  for (std::size_t i = 0; matrix.dense && i < matrix.values.size(); ++i) {
    if (const double value = matrix.values[i]; value != 0)
      entries.push_back({static_cast<int>(i / columns), static_cast<int>(i % columns), value});
  }
  return entries;
}

// Numbers, or pairs of a number and the direction in which its sign has to change.
std::vector<EventValue> read_events(const py::object& result) {
  if (PySequence_Check(result.ptr()) == 0 || PyUnicode_Check(result.ptr())) throw py::cast_error();
  std::vector<EventValue> values;
  for (const py::handle entry : result) {
    if (py::isinstance<py::tuple>(entry) || py::isinstance<py::list>(entry)) {
      const auto [value, direction] = entry.cast<std::pair<double, int>>();
      values.push_back({value, direction});
    } else {
      values.push_back({entry.cast<double>(), 0});
    }
  }
  return values;
}

void add_event_actions(SolverHooks& hooks, const std::shared_ptr<MainSystem>& main) {
  if (hooks.events && !main->user_function("EventAction").is_none()) {
    hooks.event_action = [function = std::make_shared<SystemFunction>(main, "EventAction")](double time, int event,
                                                                                            int direction) {
      return ask_whether_to_go_on(*function, time, event, direction);
    };
  }
  if (main->user_function("ItemEventAction").is_none()) return;
  hooks.item_event_action = [function = std::make_shared<SystemFunction>(main, "ItemEventAction")](
                                double time, const SolverHooks::ItemEvent& event) {
    const InterpreterLock lock(InterpreterLock::Afterwards::may_be_kept);
    const py::object item = event.part.empty() ? py::object(py::int_(event.object)) : py::object(py::str(event.part));
    return ask_whether_to_go_on(*function, time, item, event.what, event.direction);
  };
}

void add_user_functions(SolverHooks& hooks, const std::shared_ptr<MainSystem>& main) {
  hooks.pre_step = step_function(main, "PreStep");
  hooks.post_step = step_function(main, "PostStep");
  if (auto function = c_function<void, double, double*>(*main, "PostNewton")) {
    hooks.post_newton = [function = std::move(function)](double time) {
      std::array<double, 2> result{0, -1};
      function(time, result.data());
      return result;
    };
  } else if (!main->user_function("PostNewton").is_none()) {
    hooks.post_newton = [function = std::make_shared<SystemFunction>(main, "PostNewton")](double time) {
      return function->call([](const py::object& result) { return result.cast<std::array<double, 2>>(); }, time);
    };
  }
  if (!main->user_function("PreNewtonResidual").is_none()) {
    hooks.pre_newton_residual = [function = std::make_shared<SystemFunction>(main, "PreNewtonResidual")](
                                    double time, int newton, int discontinuous) {
      function->call([](const py::object&) { return 0; }, time, newton, discontinuous);
    };
  }
  if (!main->user_function("Events").is_none()) {
    hooks.events = [function = std::make_shared<SystemFunction>(main, "Events")](double time) {
      return function->call(&read_events, time);
    };
  }
  add_event_actions(hooks, main);
  if (!main->user_function("SystemJacobian").is_none()) {
    hooks.system_jacobian = [function = std::make_shared<SystemFunction>(main, "SystemJacobian")](double time, double q,
                                                                                                  double v, double y) {
      return function->call(&read_entries, time, q, v, y);
    };
  }
}

void add_schedule(SolverHooks& hooks, const std::shared_ptr<MainSystem>& main) {
  hooks.schedule = schedule_of(main);
  if (hooks.schedule && !hooks.pre_step) hooks.pre_step = [](double) { return true; };
}

// Reads the gimbal-lock data of recognised trees (mbs.sys["lockingTurns"]): names of joints, nodes, and their first
// coordinates.
void add_locking_turns(SolverHooks& hooks, const std::shared_ptr<MainSystem>& main) {
  if (!main->sys.contains("lockingTurns") || !main->consistent()) return;
  for (const py::handle entry : main->sys["lockingTurns"]) {
    const auto [name, node, coordinate] = entry.cast<std::tuple<std::string, int, int>>();
    if (node >= main->model.count(ItemKind::node)) continue;
    const int first = main->system.node_index(node, System::Coordinates::ode2);
    hooks.locking_turns.push_back({name, static_cast<std::size_t>(first + coordinate)});
  }
}

// Progress output. On a terminal one line is overwritten; otherwise, for example in files, a line is written after 10
// s and then every 30 s. A solver marks progress by a leading '\r'.
class Progress {
 public:
  void print(std::string_view text) {
    const bool passing = text.starts_with('\r');
    if (passing && overwrites()) {
      const std::string line(text.substr(1));
      write_console('\r' + line + std::string(shown_ > line.size() ? shown_ - line.size() : 0, ' '));
      shown_ = line.size();
    } else if (!passing) {
      // The last line of progress takes the place of those before.
      const bool takes_place = shown_ > 0 && text.starts_with("STEP");
      const std::string before = shown_ == 0   ? ""
                                 : takes_place ? '\r' + std::string(shown_, ' ') + '\r'
                                               : std::string("\n");
      shown_ = 0;
      write_console(before + std::string(text));
    } else if (const Clock::time_point now = Clock::now(); now >= next_) {
      next_ = now + std::chrono::seconds(30);
      write_console(std::string(text.substr(1)) + '\n');
    }
  }

 private:
  using Clock = std::chrono::steady_clock;

  // A terminal, or a notebook.
  static bool overwrites() {
    const py::gil_scoped_acquire gil;
    const py::object out = py::module_::import("sys").attr("stdout");
    if (py::hasattr(out, "isatty") && out.attr("isatty")().cast<bool>()) return true;
    return py::str(py::type::of(out).attr("__module__")).cast<std::string>().starts_with("ipykernel");
  }

  std::size_t shown_ = 0;  // letters of the line that stands open
  Clock::time_point next_ = Clock::now() + std::chrono::seconds(10);
};

void add_console(SolverHooks& hooks) {
  hooks.print = [progress = std::make_shared<Progress>()](std::string_view text) { progress->print(text); };
  hooks.warn = [](std::string_view text) { write_warning(std::string(text)); };
}

// A picture of recordImagesInterval.
void record(const std::shared_ptr<MainSystem>& main) {
  const std::weak_ptr<MainSystem> weak = main;
  const auto words = [](const void*, int) -> std::string { return "recordImagesInterval"; };
  const RunningFunction known(weak, RunningFunction::Place::between_evaluations, words, &weak);
  py::module_::import("dalembert._pictures.recording").attr("record")(py::cast(main));
}

// Performs requests of viewers on the solver's thread, for example user functions of keys.
void do_what_viewers_ask(const std::shared_ptr<MainSystem>& main) {
  main->tap.ask(false);
  const std::weak_ptr<MainSystem> weak = main;
  const auto words = [](const void*, int) -> std::string { return "a function of the viewer"; };
  const RunningFunction known(weak, RunningFunction::Place::between_evaluations, words, &weak);
  py::module_::import("dalembert._live.calls").attr("run")(py::cast(main));
}

// Polls for Ctrl-C. Getting the interpreter lock can take milliseconds while another thread runs Python, for example
// a viewer. Polling takes at most a hundredth of the time, and at least two polls per second.
class Interruption {
 public:
  explicit Interruption(const std::shared_ptr<MainSystem>& main) : main_(*main), weak_(main) {}

  bool operator()() {
    WithoutInterpreter::look();
    const auto now = Clock::now();
    if (WithoutInterpreter::is_kept() || now >= next_ || main_.tap.paused() || main_.tap.asks()) {
      wait();
      const auto end = Clock::now();
      next_ = end + std::clamp<Clock::duration>(100 * (end - now), std::chrono::milliseconds(50),
                                                std::chrono::milliseconds(500));
    }
    return main_.stop_requested;
  }

 private:
  using Clock = std::chrono::steady_clock;

  // Waits while a viewer pauses the solver; otherwise polls once.
  void wait() {
    for (;;) {
      {
        const InterpreterLock lock;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (const auto locked = weak_.lock(); locked && locked->tap.asks()) do_what_viewers_ask(locked);
      }
      if (!main_.tap.paused() || main_.stop_requested) return;
      main_.tap.offer(main_.system.state(ConfigurationType::Current), [](const auto& copy) { copy(); });
      std::optional<py::gil_scoped_release> free;
      if (WithoutInterpreter::is_kept()) free.emplace();
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }

  MainSystem& main_;  // the solver's Work keeps it
  const std::weak_ptr<MainSystem> weak_;
  Clock::time_point next_{};
};

void add_interruption(SolverHooks& hooks, const std::shared_ptr<MainSystem>& main) {
  const std::weak_ptr<MainSystem> weak = main;
  hooks.interrupted = [interruption = std::make_shared<Interruption>(main)] { return (*interruption)(); };
  hooks.jacobian_update_requested = [&requested = main->jacobian_update_requested] {
    return requested.load(std::memory_order_relaxed) && requested.exchange(false);
  };
  hooks.show = [weak, &wanted = main->look_wanted, &seen = *main](bool record_image, const SolverHooks::Look& look) {
    seen.tap.offer(seen.system.state(ConfigurationType::Current), look);
    seen.tap.take_pull([&seen = seen](const std::optional<Pull>& pull) { seen.system.pull(pull); });
    if (!record_image && !wanted.load(std::memory_order_relaxed)) return;
    const InterpreterLock lock;  // other threads may read it
    const auto locked = weak.lock();
    if (!locked) return;
    look([&] { locked->show_current(); });
    if (record_image) record(locked);
  };
}

// "Node number = 3": description of the sensor's item in the header of its file.
std::string measured_item(const Item& sensor) {
  std::string text(sensor.type->type_name);
  for (const Row& row : sensor.type->rows) {
    if (!index_storage(row.storage).is_index || index_storage(row.storage).is_list) continue;
    return text + " number = " + std::to_string(*static_cast<const int*>(member(sensor.record.get(), row)));
  }
  return text;
}

std::vector<SensorChannel> sensor_channels(const Model& model) {
  const std::vector<int> frames = floating_frames_of_sensors(model);
  std::vector<SensorChannel> channels;
  for (const Item& sensor : model.items(ItemKind::sensor)) {
    SensorChannel& channel = channels.emplace_back();
    if (const auto* name = member_of<std::string>(sensor, "fileName")) channel.file_name = *name;
    if (const auto* write = member_of<bool>(sensor, "writeToFile")) channel.write_to_file = *write;
    if (const auto* store = member_of<bool>(sensor, "storeInternal")) channel.store_internal = *store;
    const auto* variable = member_of<OutputVariableType>(sensor, "outputVariableType");
    channel.variable = variable_name(variable ? *variable : OutputVariableType::_None);
    channel.measured = measured_item(sensor);
    channel.frame_node = frames[channels.size() - 1];
  }
  return channels;
}

}  // namespace

SolverEnvironment make_environment(const std::shared_ptr<MainSystem>& main) {
  SolverEnvironment environment;
  add_user_functions(environment.hooks, main);
  add_schedule(environment.hooks, main);
  add_locking_turns(environment.hooks, main);
  add_console(environment.hooks);
  add_interruption(environment.hooks, main);
  environment.hooks.timeout = solver_switches().timeout;
  environment.sensors = sensor_channels(main->model);
  environment.sensor_storage = &main->sensor_storage;
  environment.model = &main->model;
  environment.build = std::string(DALEMBERT_VERSION) + "; Python" + std::to_string(PY_MAJOR_VERSION) + "." +
                      std::to_string(PY_MINOR_VERSION) + "." + std::to_string(PY_MICRO_VERSION);
  return environment;
}

}  // namespace dalembert
