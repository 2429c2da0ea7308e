// Where exu.Print and the solvers write: the console, a file, both or nothing; and the switches of exu.special.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace dalembert {

// Write text as it is. Takes the GIL.
void write_console(const std::string& text);
// "Warning: ..." as a line, unless exu.config.suppressWarnings is set. Takes the GIL.
void write_warning(const std::string& text);
// Of what is kept so that scripts run, although nothing depends on it: a warning, once for each name.
void tell_without_effect(const std::string& name, const std::string& reason);
// Of a dictionary that `where` is about to take over: another version is refused, or warned of, as
// exu.special.exceptions.dictionaryVersionMismatch says.
void check_version(const pybind11::dict& data, const std::string& where);

// exu.special.solver
struct SolverSwitches {
  double timeout = -1;  // s of processor time; negative: none
  bool throwErrorWithCtrlC = false;
  bool multiThreadingLoadBalancing = true;
};
const SolverSwitches& solver_switches();

}  // namespace dalembert
