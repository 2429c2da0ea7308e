// Output of exu.Print and of the solvers: to the console, a file, both or nothing; and the switches of exu.special.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace dalembert {

// Write text as it is. Takes the GIL.
void write_console(const std::string& text);
// Writes a line "Warning: ...", unless exu.config.suppressWarnings is set. Takes the GIL.
void write_warning(const std::string& text);
// Warns, once for each name, about a setting or method that is accepted for compatibility but has no effect.
void tell_without_effect(const std::string& name, const std::string& reason);
// Checks the version of a dictionary that `where` reads: another version raises an error or a warning, according to
// exu.special.exceptions.dictionaryVersionMismatch.
void check_version(const pybind11::dict& data, const std::string& where);

// exu.special.solver
struct SolverSwitches {
  double timeout = -1;  // s of processor time; negative: none
  bool throwErrorWithCtrlC = false;
  bool multiThreadingLoadBalancing = true;
};
const SolverSwitches& solver_switches();

}  // namespace dalembert
