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
  std::vector<double> algorithmic_accelerations;  // of the generalized alpha method; empty for others
  double step_size = 0;                           // of the next step
  std::vector<double> run;    // what the loop over steps, then the solver, has to know besides
  std::vector<double> events;  // what is known of event functions
  std::vector<double> history;  // of terms that are no items
  std::vector<double> files;  // lengths of the solution file and of files of sensors; negative: there is none
};

// The file before is kept with the ending .bck. Throws FileError; then nothing has changed.
void write_restart_file(const std::string& name, const RestartData& data);
// Throws FileError now if the file cannot be written later.
void check_restart_file(const std::string& name);
// Throws FileError, or ModelError with file and line if it is not, from start to end, what write_restart_file writes.
RestartData read_restart_file(const std::string& name);
// Throws ModelError if it belongs to another system.
void require_fitting(const RestartData& data, const State& system, const std::string& name);

}  // namespace dalembert
