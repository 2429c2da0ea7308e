// Files and messages of a solver.
#pragma once

#include <exception>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "control/solver_part.hpp"
#include "observers/dense_output.hpp"

namespace dalembert {

class OutputWriter : public SolverPart {
 public:
  explicit OutputWriter(Solver& solver) : SolverPart(solver) {}

  // Opens all files. A solution that goes on appends to files of these lengths.
  void open(std::span<const double> lengths);
  std::vector<double> lengths();  // of the solution file and of sensor files; negative: no file
  void write_headers();
  bool needs_steps() const;  // whether ends of steps have messages or rows

  // ---- the end of a step -------------------------------------------------------------------------------------------
  void write_end_of_step();
  void write_requested();  // at requested times within the step
  void write_coordinates();
  void print_progress(bool to_console, bool to_file);
  void announce_solution();

  // ---- messages ----------------------------------------------------------------------------------------------------
  void say(int level, std::string_view text);
  void warn(std::string_view text);
  void announce_end(const std::vector<std::string>& doubts);

  // ---- the end of a solution ---------------------------------------------------------------------------------------
  void write_footers();
  void close();
  // A file that could not be written: the first FileError of the run.
  void forget_error() { unwritten_ = nullptr; }
  void note_error(std::exception_ptr error) { unwritten_ = std::move(error); }
  const std::exception_ptr& error() const { return unwritten_; }
  std::string error_text() const;

 private:
  RunDescription run_description() const;
  void warn_of_files_written_twice();
  void write_sensors();
  void write_solution_row();
  void record_sensors(double time);
  double requested(double time, double period) const;
  template <class Write>
  void write_between(double period, Write&& write);
  template <class File>
  void close(File& file);

  SolutionFile solution_file_;
  SensorRecorder sensors_;
  OutputFile information_file_;
  StepInterpolation between_;
  std::exception_ptr unwritten_;
};

}  // namespace dalembert
