#include "dalembert/output/solution_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "dalembert/output/numbers.hpp"
#include "dalembert/output/rounded_text.hpp"

namespace dalembert {

namespace {

constexpr const char* purpose = "solution file";

// Numbers of exported coordinates: nODE2, nVel2, nAcc2, nODE1, nVel1, nAlgebraic, nData.
std::array<int, 7> exported(const SimulationSettings& settings, bool is_static, const Sizes& sizes) {
  const auto& s = settings.solutionSettings;
  const auto if_dynamic = [is_static](bool wanted, int n) { return wanted && !is_static ? n : 0; };
  return {sizes.ode2,
          if_dynamic(s.exportVelocities, sizes.ode2),
          if_dynamic(s.exportAccelerations, sizes.ode2),
          sizes.ode1,
          if_dynamic(s.exportODE1Velocities, sizes.ode1),
          s.exportAlgebraicCoordinates ? sizes.ae : 0,
          s.exportDataCoordinates ? sizes.data : 0};
}

int total(const std::array<int, 7>& counts) {
  int sum = 0;
  for (const int n : counts) sum += n;
  return sum;
}

StepCount planned_steps(const SimulationSettings& settings, bool is_static) {
  return is_static ? settings.staticSolver.numberOfLoadSteps
                   : static_cast<StepCount>(std::llround(settings.timeIntegration.numberOfSteps));
}

template <std::size_t N>
std::string list(const std::array<int, N>& numbers) {
  std::string text = "[";
  for (const int n : numbers) {
    if (text.size() > 1) text += ',';
    text += std::to_string(n);
  }
  text += ']';
  return text;
}

template <class T>
void append_bytes(std::string& text, const T& value) {
  text.append(reinterpret_cast<const char*>(&value), sizeof value);
}
// The layout has 32 bits for integers; counts beyond them end there.
void append_int(std::string& text, StepCount value) {
  constexpr StepCount most = std::numeric_limits<std::int32_t>::max();
  append_bytes(text, static_cast<std::int32_t>(std::min(value, most)));
}
void append_string(std::string& text, const std::string& value) {
  append_int(text, static_cast<int>(value.size()));
  text += value;
}
template <class T, std::size_t N>
void append_ints(std::string& text, const std::array<T, N>& values) {
  append_int(text, static_cast<int>(N));
  for (const T x : values) append_int(text, x);
}
void append_reals(std::string& text, const std::vector<double>& values, bool single) {
  if (!single) {
    text.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
    return;
  }
  for (const double x : values) append_bytes(text, static_cast<float>(x));
}

// Calls `f` with every exported vector of a row, in the order of the columns.
template <class F>
void each_column(const SimulationSettings& settings, bool is_static, const State& state, F&& f) {
  const auto& s = settings.solutionSettings;
  f(state.q);
  if (s.exportVelocities && !is_static) f(state.v);
  if (s.exportAccelerations && !is_static) f(state.a);
  f(state.y);
  if (s.exportODE1Velocities && !is_static) f(state.y_t);
  if (s.exportAlgebraicCoordinates) f(state.lambda);
  if (s.exportDataCoordinates) f(state.data);
}

}  // namespace

std::string SolutionFile::name(const SimulationSettings& settings) {
  std::string name = settings.solutionSettings.coordinatesSolutionFileName;
  if (!name.empty() && name.find('.') == std::string::npos) {
    name += settings.solutionSettings.binarySolutionFile ? ".sol" : ".txt";
  }
  return name;
}

void SolutionFile::open(const SimulationSettings& settings) {
  const auto& s = settings.solutionSettings;
  binary_ = s.binarySolutionFile;
  single_precision_ = s.outputPrecision < 8;
  headed_ = !s.writeFileHeader;
  file_.open(output_path(name(settings)), s.appendToFile && !binary_, purpose);
}

void SolutionFile::resume(const SimulationSettings& settings, double length) {
  binary_ = settings.solutionSettings.binarySolutionFile;
  single_precision_ = settings.solutionSettings.outputPrecision < 8;
  headed_ = true;
  file_.resume(output_path(name(settings)), length, purpose);
}

void SolutionFile::write_header(const SimulationSettings& settings, const RunDescription& run, const Sizes& sizes) {
  is_static_ = run.is_static;
  if (!file_.is_open() || headed_) return;
  binary_ ? write_binary_header(settings, run, sizes) : write_text_header(settings, run, sizes);
  file_.written();
}

void SolutionFile::write_text_header(const SimulationSettings& settings, const RunDescription& run,
                                     const Sizes& sizes) {
  const auto& s = settings.solutionSettings;
  const auto counts = exported(settings, run.is_static, sizes);
  std::string& t = file_.text();
  t += "#dalembert " + run.solver_name + (run.is_static ? " static" : "") + " solver solution file\n";
  t += "#simulation started=" + date_and_time() + "\n#columns contain: time";
  if (sizes.ode2) t += ", ODE2 displacements";
  if (sizes.ode2 && counts[1]) t += ", ODE2 velocities";
  if (sizes.ode2 && counts[2]) t += ", ODE2 accelerations";
  if (sizes.ode1) t += ", ODE1 coordinates";
  if (counts[4]) t += ", ODE1 velocities";
  if (counts[5]) t += ", AE coordinates";
  if (counts[6]) t += ", Data coordinates";
  t += "\n#number of system coordinates [nODE2, nODE1, nAlgebraic, nData] = " +
       list(std::array{sizes.ode2, sizes.ode1, sizes.ae, sizes.data});
  t += "\n#number of written coordinates [nODE2, nVel2, nAcc2, nODE1, nVel1, nAlgebraic, nData] = " + list(counts);
  t += "\n#total columns exported  (excl. time) = " + std::to_string(total(counts));
  t += run.is_static ? "\n#number of load steps (planned) = " : "\n#number of time steps (planned) = ";
  t += std::to_string(planned_steps(settings, run.is_static)) + "\n#version = " + run.build + "\n#\n";
  if (s.solutionInformation.empty()) return;
  std::string information = s.solutionInformation;
  for (char& c : information) c = c == '\n' ? '_' : c;
  t += "#solution information = " + information + "\n";
}

void SolutionFile::write_binary_header(const SimulationSettings& settings, const RunDescription& run,
                                       const Sizes& sizes) {
  std::string& t = file_.text();
  t += "EXUBIN\n";  // the identifier by which readers know this layout
  t += static_cast<char>(sizeof(std::int32_t));
  t += static_cast<char>(single_precision_ ? sizeof(float) : sizeof(double));
  t += static_cast<char>(sizeof(void*));
  t += static_cast<char>(std::endian::native == std::endian::big);
  t.append(5, '\0');
  append_string(t, run.version);
  append_string(t, "Mode0000");
  append_string(t, "dalembert " + run.solver_name + (run.is_static ? " static" : "") + " solver solution file");
  append_string(t, date_and_time());
  append_ints(t, std::array{sizes.ode2, sizes.ode1, sizes.ae, sizes.data});
  const auto counts = exported(settings, run.is_static, sizes);
  append_ints(t, counts);
  append_int(t, total(counts));
  append_int(t, planned_steps(settings, run.is_static));
  append_string(t, settings.solutionSettings.solutionInformation);
  append_string(t, "EndOfHeader");
}

void SolutionFile::write_row(const SimulationSettings& settings, const State& state) {
  std::string& t = file_.text();
  std::size_t values = 0;
  if (binary_) {
    each_column(settings, is_static_, state, [&](const auto& x) { values += x.size(); });
    append_int(t, static_cast<int>(values) + 1);
    append_reals(t, {state.time}, single_precision_);
    each_column(settings, is_static_, state, [&](const auto& x) { append_reals(t, x, single_precision_); });
  } else {
    const int precision = settings.solutionSettings.outputPrecision;
    append_rounded(t, state.time, precision);
    each_column(settings, is_static_, state, [&](const auto& x) {
      values += x.size();
      append_rounded(t, x, precision);
    });
    t += '\n';
  }
  const auto& s = settings.solutionSettings;
  if (s.flushFilesImmediately || values >= static_cast<std::size_t>(s.flushFilesDOF)) file_.flush();
  file_.written();
}

std::string solution_footer(const SolverIterationData& it, const SolverConvergenceData& conv, double seconds) {
  std::string t = "#simulation finished=" + date_and_time() + "\n#Solver Info: cpuTime=" + format_number(seconds);
  const auto entry = [&t](const char* name, StepCount value) {
    t += std::string(",") + name + "=" + std::to_string(value);
  };
  entry("stepReductionFailed(or step failed)", conv.stepReductionFailed);
  entry("discontinuousIterationSuccessful", conv.discontinuousIterationSuccessful);
  entry("newtonSolutionDiverged", conv.newtonSolutionDiverged);
  entry("massMatrixNotInvertible", conv.massMatrixNotInvertible);
  entry("total time steps", it.currentStepIndex - 1);
  entry("total Newton iterations", it.newtonStepsCount);
  entry("total Newton jacobians", it.newtonJacobiCount);
  return t + "\n";
}

void SolutionFile::write_footer(const std::string& footer, const SolverIterationData& it,
                                const SolverConvergenceData& conv) {
  if (!file_.is_open()) return;
  std::string& t = file_.text();
  if (!binary_) {
    t += footer;
    return;
  }
  append_int(t, -1);
  append_string(t, "simulation finished=");
  append_string(t, date_and_time());
  append_ints(t, std::array{StepCount{conv.stepReductionFailed}, StepCount{conv.discontinuousIterationSuccessful},
                            StepCount{conv.newtonSolutionDiverged}, StepCount{conv.massMatrixNotInvertible},
                            it.currentStepIndex - 1, it.newtonStepsCount, it.newtonJacobiCount});
  append_string(t, "EXUEND");
}

}  // namespace dalembert
