// The whole state of a running integration in a file, from which it can be continued bit for bit.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "dalembert/system/state.hpp"

namespace dalembert {

struct RestartData {
  std::string solver;  // its name
  State state;
  std::vector<double> algorithmic_accelerations;  // used by generalized alpha; otherwise empty
  double step_size = 0;  // size of the next step
  std::vector<double> run;  // further data of the step loop, then of the solver
  std::vector<double> events;  // data of event functions
  std::vector<double> history;  // history of terms that are not items
  std::vector<double> files;  // lengths of the solution file and of sensor files; negative: no file
};

// The file before is kept with the ending .bck. Throws FileError; then nothing has changed.
void write_restart_file(const std::string& name, const RestartData& data);
// Throws FileError now if the file cannot be written later.
void check_restart_file(const std::string& name);
// Throws FileError, or ModelError with file and line if the contents are not exactly those of write_restart_file.
RestartData read_restart_file(const std::string& name);
// Throws ModelError if it belongs to another system.
void require_fitting(const RestartData& data, const State& system, const std::string& name);

}  // namespace dalembert
