// Functions and objects of the module itself: Print and its switches, versions, dictionaries for users.
#include <cstdlib>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <set>
#include <thread>

#include "console.hpp"
#include "conversion.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/value_checks.hpp"
#include "dalembert/output/output_file.hpp"
#include "module.hpp"

namespace dalembert {
namespace {

struct Config {
  bool suppressWarnings = false, linalgOutputFormatPython = true;
  int outputPrecision = 6, printDelayMilliSeconds = 0;
  bool printFlushAlways = false, printToConsole = true;
  bool printToFile = false, printToFileAppend = false, flushFileAlways = false;
  std::string printFileName;
  OutputFile file;
};

struct Exceptions {
  bool dictionaryVersionMismatch = true, dictionaryNonCopyable = true;
};
struct Special {
  SolverSwitches solver;
  Exceptions exceptions;
};
struct Experimental {
  int eigenFullPivotLUsolverDebugLevel = 0;
  bool markerSuperElementRigidTexpSO3 = true;
};

Config& config() {
  static Config instance;
  return instance;
}
Special& special() {
  static Special instance;
  return instance;
}

// The file that mirrors the console is closed at its first error, which is reported once.
void write_to_file(const std::string& text, bool flush) {
  Config& c = config();
  try {
    c.file.text() += text;
    flush ? c.file.flush() : c.file.written();
  } catch (const FileError&) {
    c.printToFile = false;
    throw;
  }
}

void end_writing_to_file() {
  config().printToFile = false;
  config().file.close();
}

// A closed pipe, such as that of head, does not end the solution: further output, and output left in buffers, is
// discarded.
void leave_to_nobody(const py::object& out) {
  if (!out.is(py::module_::import("sys").attr("__stdout__"))) return;
  const py::module_ os = py::module_::import("os");
  const py::object nobody = os.attr("open")(os.attr("devnull"), os.attr("O_WRONLY"));
  os.attr("dup2")(nobody, out.attr("fileno")());
  os.attr("close")(nobody);
}

void write_to_stdout(const std::string& text, bool flush) {
  const py::object out = py::module_::import("sys").attr("stdout");
  if (out.is_none()) return;
  try {
    out.attr("write")(text);
    if (flush) out.attr("flush")();
  } catch (const py::error_already_set& error) {
    if (!error.matches(PyExc_BrokenPipeError)) throw;
    leave_to_nobody(out);
  }
}

// A list that gets the texts of warnings, or None.
py::object& warning_list() {
  static auto* list = new py::object(py::none());  // never destroyed: the interpreter may have ended
  return *list;
}

// The GIL is held.
void write(const std::string& text, bool flush) {
  Config& c = config();
  if (c.printToConsole) write_to_stdout(text, flush || c.printFlushAlways);
  if (c.printToFile) write_to_file(text, flush || c.flushFileAlways || c.printFlushAlways);
  if (c.printDelayMilliSeconds > 0) {
    const py::gil_scoped_release release;
    std::this_thread::sleep_for(std::chrono::milliseconds(c.printDelayMilliSeconds));
  }
}

// Works like Python's print; `file` is accepted and ignored, because SetWriteToFile has this purpose.
void print(const py::args& values, const py::kwargs& options) {
  for (const auto& [key, value] : options) {
    const auto name = key.cast<std::string>();
    if (name != "sep" && name != "end" && name != "flush" && name != "file")
      refuse(ErrorKind::type,
             {.item = "exu.Print", .problem = "unknown argument '" + name + "'", .expected = "sep, end or flush"});
  }
  const auto option = [&](const char* name, const char* fallback) {
    if (!options.contains(name) || options[name].is_none()) return std::string(fallback);
    return options[name].cast<std::string>();
  };
  const std::string separator = option("sep", " ");
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) text += (i == 0 ? "" : separator) + std::string(py::str(values[i]));
  write(text + option("end", "\n"), options.contains("flush") && options["flush"].cast<bool>());
}

void set_write_to_file(const std::string& filename, bool write_file, bool append, bool flush_always) {
  Config& c = config();
  if (write_file && filename.empty())
    refuse(ErrorKind::value, {.item = "exu.SetWriteToFile",
                              .parameter = "filename",
                              .problem = "is empty",
                              .advice = "Pass flagWriteToFile=False to end writing."});
  end_writing_to_file();
  c.printFileName = filename;
  c.printToFileAppend = append;
  c.flushFileAlways = flush_always;
  if (!write_file) return;
  c.file.open(output_path(filename), append, "file of exu.SetWriteToFile");
  c.printToFile = true;
}

std::string version(bool details) {
  std::string text = DALEMBERT_VERSION;
  if (!details) return text;
  const py::module_ platform = py::module_::import("platform");
  return text + "; Python" + platform.attr("python_version")().cast<std::string>() + "; " +
         platform.attr("system")().cast<std::string>() + " FLOAT64";
}

void help() {
  print(py::make_tuple("dalembert: dynamics of flexible multibody systems.\n"
                       "  SC = dalembert.SystemContainer(); mbs = SC.AddSystem()    a system to which items are added\n"
                       "  mbs.Assemble(); mbs.SolveDynamic()                        its solution\n"
                       "  help(dalembert.NodePoint), help(mbs.AddNode)              on items and methods"),
        py::kwargs());
}

// Check of arguments of Python functions: applies a parameter check, "rotation", "color" or "unit_vector", to an
// array of numbers.
std::string problem_of(const std::string& check,
                       const py::array_t<double, py::array::c_style | py::array::forcecast>& value) {
  const bool rotation = check == "rotation", color = check == "color";
  if (value.size() != (rotation ? 9 : color ? 4 : 3)) throw std::logic_error("_problem_of: wrong number of values");
  if (color) {
    const Verdict verdict = judge_color(load<double, 4>(value.data()));
    return verdict.problem.empty() ? "" : verdict.problem + " " + advice(Check::color);
  }
  if (!rotation) return judge_unit_vector(load<double, 3>(value.data())).problem;
  Mat3<double> matrix;
  std::copy_n(value.data(), 9, matrix.x.begin());
  return judge_rotation(matrix).problem;
}

// Counters of allocations are not kept: zeros, so that scripts that compare them run.
std::vector<int> allocation_counts(bool write_output) {
  if (write_output) write("allocations are not counted\n", false);
  return std::vector<int>(7, 0);
}

template <class T>
std::string attributes_text(const T& object, const std::vector<const char*>& names) {
  const py::object instance = py::cast(object, py::return_value_policy::reference);
  std::string text;
  for (const char* name : names)
    text += std::string(text.empty() ? "" : "\n") + name + " = " + std::string(py::str(instance.attr(name)));
  return text;
}

template <class Owner, class Value>
void add_idle_switch(py::class_<Owner>& owner, const std::string& where, const char* name, Value Owner::* member,
                     const std::string& reason) {
  owner.def_property(
      name, [member](const Owner& self) { return self.*member; },
      [=](Owner& self, Value value) {
        self.*member = value;
        if (value != Owner().*member) tell_without_effect(where + name, reason);
      },
      ("No effect: " + reason + ".").c_str());
}

void register_config(py::module_& module) {
  py::class_<Config> c(module, "Config", "Switches for output and warnings, as exu.config.");
  c.def(
      "Version", [](const Config&, bool details) { return version(details); }, py::arg("addDetails") = false,
      "Version of this package.");
  c.def_readwrite("suppressWarnings", &Config::suppressWarnings, "True: no warnings.");
  const std::string precision = "solvers show as many digits as simulationSettings.outputPrecision says";
  c.def_property(
      "outputPrecision", [](const Config& self) { return self.outputPrecision; },
      [precision](Config& self, int digits) {
        if (digits < 1 || digits > 17)
          refuse(ErrorKind::value, {.item = "exu.config",
                                    .parameter = "outputPrecision",
                                    .received = std::to_string(digits),
                                    .expected = "1 to 17 digits"});
        self.outputPrecision = digits;
        if (digits != Config().outputPrecision) tell_without_effect("exu.config.outputPrecision", precision);
      },
      ("No effect: " + precision + ".").c_str());
  add_idle_switch(c, "exu.config.", "linalgOutputFormatPython", &Config::linalgOutputFormatPython,
                  "vectors and matrices are always shown as Python writes them");
  c.def_property(
      "printDelayMilliSeconds", [](const Config& self) { return self.printDelayMilliSeconds; },
      [](Config& self, int delay) {
        if (delay < 0)
          refuse(ErrorKind::value, {.item = "exu.config",
                                    .parameter = "printDelayMilliSeconds",
                                    .received = std::to_string(delay),
                                    .expected = "a number that is not negative"});
        self.printDelayMilliSeconds = delay;
      },
      "Pause after each output, in ms.");
  c.def_readwrite("printFlushAlways", &Config::printFlushAlways, "Flush after each output.");
  c.def_readwrite("printToConsole", &Config::printToConsole, "Whether Print and solvers write to the console.");
  c.def_readonly("printToFile", &Config::printToFile, "Whether output goes to a file, see SetWriteToFile.");
  c.def_readonly("printFileName", &Config::printFileName, "Name of that file.");
  c.def_readonly("printToFileAppend", &Config::printToFileAppend, "Whether that file is continued.");
  c.def_property(
      "outputDirectory", [](const Config&) { return output_directory(); },
      [](const Config&, std::string directory) { output_directory() = std::move(directory); },
      "Folder of files of solvers, sensors and SetWriteToFile; '' for none. At the start it is that of the environment "
      "variable "
      "DALEMBERT_OUTPUTDIRECTORY or EXUDYN_OUTPUTDIRECTORY.");
  for (const char* variable : {"EXUDYN_OUTPUTDIRECTORY", "DALEMBERT_OUTPUTDIRECTORY"})
    if (const char* given = std::getenv(variable)) output_directory() = given;
  c.def("__repr__", [](const Config& self) {
    return attributes_text(self, {"outputDirectory", "suppressWarnings", "outputPrecision", "linalgOutputFormatPython",
                                  "printDelayMilliSeconds", "printFlushAlways", "printToConsole", "printToFile",
                                  "printFileName", "printToFileAppend"});
  });
  module.attr("config") = py::cast(config(), py::return_value_policy::reference);
}

void register_special(py::module_& module) {
  py::class_<SolverSwitches> solver(module, "SpecialSolver", "Switches for solvers, as exu.special.solver.");
  solver.def_readwrite("timeout", &SolverSwitches::timeout,
                       "A solver stops after so many seconds, with a warning, and returns False; negative: never.");
  const std::string of_solver = "exu.special.solver.";
  add_idle_switch(solver, of_solver, "throwErrorWithCtrlC", &SolverSwitches::throwErrorWithCtrlC,
                  "Ctrl-C in a solver always raises KeyboardInterrupt");
  add_idle_switch(solver, of_solver, "multiThreadingLoadBalancing", &SolverSwitches::multiThreadingLoadBalancing,
                  "threads that are ready always take over work of others");
  solver.def("__repr__", [](const SolverSwitches& self) {
    return attributes_text(self, {"timeout", "throwErrorWithCtrlC", "multiThreadingLoadBalancing"});
  });
  py::class_<Exceptions> exceptions(module, "SpecialExceptions",
                                    "What is refused in dictionaries of systems, as exu.special.exceptions.");
  exceptions.def_readwrite("dictionaryVersionMismatch", &Exceptions::dictionaryVersionMismatch,
                           "True: SetDictionary rejects dictionaries of another version; False: it only warns.");
  add_idle_switch(exceptions, "exu.special.exceptions.", "dictionaryNonCopyable", &Exceptions::dictionaryNonCopyable,
                  "dictionaries of systems hold their variables themselves, not copies");
  exceptions.def("__repr__", [](const Exceptions& self) {
    return attributes_text(self, {"dictionaryVersionMismatch", "dictionaryNonCopyable"});
  });
  py::class_<Special> s(module, "Special", "Rarely needed switches, as exu.special.");
  s.def_readonly("solver", &Special::solver, "Switches for solvers.");
  s.def_readonly("exceptions", &Special::exceptions, "What is refused in dictionaries of systems.");
  s.def(
      "InfoStat", [](const Special&, bool write_output) { return allocation_counts(write_output); },
      py::arg("writeOutput") = true, "Seven zeros: allocations are not counted.");
  module.attr("special") = py::cast(special(), py::return_value_policy::reference);
  py::class_<Experimental> experimental(module, "Experimental",
                                        "Switches of the reference's development, as exu.experimental.");
  add_idle_switch(experimental, "exu.experimental.", "eigenFullPivotLUsolverDebugLevel",
                  &Experimental::eigenFullPivotLUsolverDebugLevel,
                  "the diagnosis of a failed factorization is in the SolverError");
  add_idle_switch(experimental, "exu.experimental.", "markerSuperElementRigidTexpSO3",
                  &Experimental::markerSuperElementRigidTexpSO3, "derivatives of such markers are always exact");
  module.attr("experimental") = py::cast(Experimental{});
}

// Functions of earlier interfaces; their docstrings name the replacements.
void register_earlier_functions(py::module_& module) {
  module.def("GetVersionString", &version, py::arg("addDetails") = false, "Earlier name of config.Version.");
  module.def(
      "SetOutputPrecision", [](int digits) { core_module().attr("config").attr("outputPrecision") = digits; },
      py::arg("numberOfDigits"), "Earlier form of config.outputPrecision.");
  module.def(
      "SetLinalgOutputFormatPython", [](bool flag) { config().linalgOutputFormatPython = flag; },
      py::arg("flagPythonFormat"), "Earlier form of config.linalgOutputFormatPython.");
  module.def(
      "SetPrintDelayMilliSeconds",
      [](int delay) { core_module().attr("config").attr("printDelayMilliSeconds") = delay; },
      py::arg("delayMilliSeconds"), "Earlier form of config.printDelayMilliSeconds.");
  module.def(
      "SetWriteToConsole", [](bool flag) { config().printToConsole = flag; }, py::arg("flag"),
      "Earlier form of config.printToConsole.");
  module.def(
      "SuppressWarnings", [](bool flag) { config().suppressWarnings = flag; }, py::arg("flag"),
      "Earlier form of config.suppressWarnings.");
  module.def(
      "_collect_warnings", [](py::object list) { warning_list() = std::move(list); }, py::arg("list"),
      "Append the texts of warnings to this list instead of writing them; None: write them.");
  module.def("InfoStat", &allocation_counts, py::arg("writeOutput") = true, "Earlier name of special.InfoStat.");
  for (const char* name : {"StartRenderer", "IsRendererActive", "DoRendererIdleTasks"})
    module.def(name, [](const py::args&, const py::kwargs&) { return false; }, "Does nothing: there is no renderer.");
  module.def("StopRenderer", [](const py::args&, const py::kwargs&) {}, "Does nothing: there is no renderer.");
}

}  // namespace

void write_console(const std::string& text) {
  const py::gil_scoped_acquire gil;
  write(text, false);
}

void write_warning(const std::string& text) {
  const py::gil_scoped_acquire gil;
  if (const py::object& list = warning_list(); !list.is_none()) {
    list.attr("append")(text);
    return;
  }
  if (!config().suppressWarnings) write("Warning: " + text + "\n", false);
}

void tell_without_effect(const std::string& name, const std::string& reason) {
  static std::set<std::string> told;
  if (told.insert(name).second) write_warning(name + " has no effect: " + reason);
}

void check_version(const py::dict& data, const std::string& where) {
  if (!data.contains("__version__")) return;
  const auto made_by = py::str(data["__version__"]).cast<std::string>();
  if (made_by == DALEMBERT_VERSION) return;
  if (special().exceptions.dictionaryVersionMismatch)
    refuse(ErrorKind::value,
           {.item = where,
            .parameter = "__version__",
            .received = made_by,
            .expected = DALEMBERT_VERSION,
            .advice = "To read it all the same, set exu.special.exceptions.dictionaryVersionMismatch = False."});
  write_warning(where + ": version " + made_by + " has made this dictionary, not " DALEMBERT_VERSION);
}

const SolverSwitches& solver_switches() { return special().solver; }

void register_module_functions(py::module_& module) {
  module.def("Help", &help, "Show where to begin.");
  module.def("Print", &print, "Print as Python does, to where exu.config and SetWriteToFile say.");
  module.def(
      "SetWriteToFile", &set_write_to_file, py::arg("filename"), py::arg("flagWriteToFile") = true,
      py::arg("flagAppend") = false, py::arg("flagFlushAlways") = false,
      "Write all output to a file as well, or end that (flagWriteToFile=False), which closes the file. An OSError if "
      "that is not possible, also later, by what prints; then the file has ended.");
  py::module_::import("atexit").attr("register")(py::cpp_function(&end_writing_to_file));  // while errors can be shown
  module.def("_problem_of", &problem_of, py::arg("check"), py::arg("value"), py::pos_only(),
             "What is wrong with a rotation or a unit vector; empty if nothing is.");
  register_config(module);
  register_special(module);
  register_earlier_functions(module);
  module.attr("variables") = py::dict();  // free for users
  module.attr("sys") = py::dict();  // for utilities
}

}  // namespace dalembert
