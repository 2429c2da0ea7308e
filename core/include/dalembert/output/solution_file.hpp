// The file of all coordinates over time: header, one row per written step, footer; as text or binary.
#pragma once

#include <string>

#include "dalembert/output/output_file.hpp"
#include "dalembert/simulation_settings.hpp"
#include "dalembert/solvers/data.hpp"
#include "dalembert/system/state.hpp"

namespace dalembert {

// Program and model, for the headers of files.
struct RunDescription {
  std::string solver_name;
  bool is_static = false;
  std::string version = "1.11.0";  // version of the file layout
  std::string build;               // version of program, Python and platform
};

class SolutionFile {
 public:
  void open(const SimulationSettings& settings);
  // Goes on where the file had this length, without another header.
  void resume(const SimulationSettings& settings, double length);
  double length() { return file_.length(); }
  bool is_open() const { return file_.is_open(); }
  void write_header(const SimulationSettings& settings, const RunDescription& run, const Sizes& sizes);
  void write_row(const SimulationSettings& settings, const State& state);
  // `footer` is the text that write_footer of text files appends.
  void write_footer(const std::string& footer, const SolverIterationData& it, const SolverConvergenceData& conv);
  void close() { file_.close(); }
  const OutputFile& file() const { return file_; }

  // The name of the file, with a default ending.
  static std::string name(const SimulationSettings& settings);

 private:
  void write_text_header(const SimulationSettings& settings, const RunDescription& run, const Sizes& sizes);
  void write_binary_header(const SimulationSettings& settings, const RunDescription& run, const Sizes& sizes);

  OutputFile file_;
  bool is_static_ = false, binary_ = false, single_precision_ = false, headed_ = false;
};

// Statistics at the end of a run, as comment lines.
std::string solution_footer(const SolverIterationData& it, const SolverConvergenceData& conv, double seconds);

}  // namespace dalembert
