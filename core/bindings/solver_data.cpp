// Counters, flags and times of solvers as Python objects whose attributes can be read and written.
#include "solver_data.hpp"

#include <pybind11/stl.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/data.hpp"

namespace dalembert {

namespace {

std::string as_text(bool value) { return value ? "True" : "False"; }
std::string as_text(int value) { return std::to_string(value); }
std::string as_text(StepCount value) { return std::to_string(value); }
std::string as_text(double value) { return format_number(value); }

// Makes attributes of members, and a repr that lists them all.
template <class T>
class Fields {
 public:
  Fields(py::module_& module, const char* name, const char* doc) : class_(module, name, doc), name_(name) {
    class_.def(py::init<>());
  }
  template <class Member>
  Fields& add(const char* name, Member T::* member) {
    class_.def_readwrite(name, member);
    lines_->push_back([name, member](const T& object) { return std::string(name) + " = " + as_text(object.*member); });
    return *this;
  }
  py::class_<T>& finish() {
    const auto to_text = [lines = lines_, name = name_](const T& object) {
      std::string text = name + ":\n";
      for (const auto& line : *lines) text += "  " + line(object) + "\n";
      return text;
    };
    class_.def("__repr__", to_text).def("__str__", to_text);
    return class_;
  }

 private:
  py::class_<T> class_;
  std::string name_;
  std::shared_ptr<std::vector<std::function<std::string(const T&)>>> lines_ =
      std::make_shared<std::vector<std::function<std::string(const T&)>>>();
};

void register_iteration(py::module_& module) {
  using T = SolverIterationData;
  Fields<T>(module, "SolverIterationData", "Steps, iterations and step sizes of a solver.")
      .add("adaptiveStep", &T::adaptiveStep)
      .add("automaticStepSize", &T::automaticStepSize)
      .add("automaticStepSizeError", &T::automaticStepSizeError)
      .add("currentStepIndex", &T::currentStepIndex)
      .add("currentStepSize", &T::currentStepSize)
      .add("currentTime", &T::currentTime)
      .add("discontinuousIteration", &T::discontinuousIteration)
      .add("discontinuousIterationsCount", &T::discontinuousIterationsCount)
      .add("endTime", &T::endTime)
      .add("initialStepSize", &T::initialStepSize)
      .add("eventsCount", &T::eventsCount)
      .add("eventSolutions", &T::eventSolutions)
      .add("lastStepSize", &T::lastStepSize)
      .add("singularPositionSteps", &T::singularPositionSteps)
      .add("stepsAboveTolerance", &T::stepsAboveTolerance)
      .add("unsettledSteps", &T::unsettledSteps)
      .add("maxStepSize", &T::maxStepSize)
      .add("minStepSize", &T::minStepSize)
      .add("newtonJacobiCount", &T::newtonJacobiCount)
      .add("newtonSteps", &T::newtonSteps)
      .add("newtonStepsCount", &T::newtonStepsCount)
      .add("numberOfSteps", &T::numberOfSteps)
      .add("recommendedStepSize", &T::recommendedStepSize)
      .add("largestStepSize", &T::largestStepSize)
      .add("rejectedAutomaticStepSizeSteps", &T::rejectedAutomaticStepSizeSteps)
      .add("rejectedDiscontinuousSteps", &T::rejectedDiscontinuousSteps)
      .add("rejectedModifiedNewtonSteps", &T::rejectedModifiedNewtonSteps)
      .add("rejectedNewtonSteps", &T::rejectedNewtonSteps)
      .add("smallestStepSize", &T::smallestStepSize)
      .add("stagnatedNewtonSteps", &T::stagnatedNewtonSteps)
      .add("startTime", &T::startTime)
      .add("stepsAtMaximumStepSize", &T::stepsAtMaximumStepSize)
      .finish()
      .def("ToString", &T::to_string, "The statistics that displayStatistics shows.");
}

void register_convergence(py::module_& module) {
  using T = SolverConvergenceData;
  Fields<T>(module, "SolverConvergenceData", "Residuals, errors and flags of a solver.")
      .add("contractivity", &T::contractivity)
      .add("discontinuousIterationError", &T::discontinuousIterationError)
      .add("discontinuousIterationSuccessful", &T::discontinuousIterationSuccessful)
      .add("errorCoordinateFactor", &T::errorCoordinateFactor)
      .add("jacobianUpdateRequested", &T::jacobianUpdateRequested)
      .add("lastResidual", &T::lastResidual)
      .add("linearSolverCausingRow", &T::linearSolverCausingRow)
      .add("linearSolverFailed", &T::linearSolverFailed)
      .add("massMatrixNotInvertible", &T::massMatrixNotInvertible)
      .add("newtonConverged", &T::newtonConverged)
      .add("newtonSolutionDiverged", &T::newtonSolutionDiverged)
      .add("newtonStagnated", &T::newtonStagnated)
      .add("residual", &T::residual)
      .add("stepReductionFailed", &T::stepReductionFailed)
      .add("stopNewton", &T::stopNewton)
      .finish()
      .def("InitializeData", [](T& data) { data = T(); }, "Set all values back.");
}

void register_output(py::module_& module) {
  using T = SolverOutputData;
  Fields<T>(module, "SolverOutputData", "What a solver has written and how it ended.")
      .add("cpuLastTimePrinted", &T::cpuLastTimePrinted)
      .add("cpuSolverStartTime", &T::cpuSolverStartTime)
      .add("cpuStartTime", &T::cpuStartTime)
      .add("finishedSuccessfully", &T::finishedSuccessfully)
      .add("initializationSuccessful", &T::initializationSuccessful)
      .add("lastDiscontinuousIterationsCount", &T::lastDiscontinuousIterationsCount)
      .add("lastImageRecorded", &T::lastImageRecorded)
      .add("lastNewtonJacobiCount", &T::lastNewtonJacobiCount)
      .add("lastNewtonStepsCount", &T::lastNewtonStepsCount)
      .add("lastSensorsWritten", &T::lastSensorsWritten)
      .add("lastSolutionWritten", &T::lastSolutionWritten)
      .add("lastVerboseStepIndex", &T::lastVerboseStepIndex)
      .add("multiThreadingMode", &T::multiThreadingMode)
      .add("numberOfThreadsUsed", &T::numberOfThreadsUsed)
      .add("simulationStoppedByUser", &T::simulationStoppedByUser)
      .add("simulationStoppedByUserFunction", &T::simulationStoppedByUserFunction)
      .add("simulationTimeout", &T::simulationTimeout)
      .add("stepInformation", &T::stepInformation)
      .add("trusted", &T::trusted)
      .add("verboseMode", &T::verboseMode)
      .add("verboseModeFile", &T::verboseModeFile)
      .add("writeToSolutionFile", &T::writeToSolutionFile)
      .add("writeToSolverFile", &T::writeToSolverFile)
      .finish()
      .def("InitializeData", [](T& data) { data = T(); }, "Set all values back.");
}

void register_timer(py::module_& module) {
  using T = SolverTimer;
  Fields<T> fields(module, "CSolverTimer",
                   "Seconds spent in the parts of a solver; parts need displayComputationTime.");
  fields.add("AERHS", &T::AERHS)
      .add("errorEstimator", &T::errorEstimator)
      .add("factorization", &T::factorization)
      .add("integrationFormula", &T::integrationFormula)
      .add("jacobianAE", &T::jacobianAE)
      .add("jacobianODE1", &T::jacobianODE1)
      .add("jacobianODE2", &T::jacobianODE2)
      .add("jacobianODE2_t", &T::jacobianODE2_t)
      .add("massMatrix", &T::massMatrix)
      .add("newtonIncrement", &T::newtonIncrement)
      .add("ODE1RHS", &T::ODE1RHS)
      .add("ODE2RHS", &T::ODE2RHS)
      .add("overhead", &T::overhead)
      .add("postNewton", &T::postNewton)
      .add("python", &T::python)
      .add("reactionForces", &T::reactionForces)
      .add("realtimeIdleCPU", &T::realtimeIdleCPU)
      .add("total", &T::total)
      .add("totalJacobian", &T::totalJacobian)
      .add("useTimer", &T::useTimer)
      .add("visualization", &T::visualization)
      .add("writeSolution", &T::writeSolution)
      .finish()
      .def("Reset", &T::reset, py::arg("useSolverTimer"), "Set all times back.")
      .def(
          "StartTimer", [](const T&, double value) { return value - T::now(); }, py::arg("value"), "value minus now.")
      .def(
          "StopTimer", [](const T&, double value) { return value + T::now(); }, py::arg("value"), "value plus now.")
      .def("Sum", &T::sum, "Sum of all parts.")
      .def("ToString", &T::to_string, "All times as text.");
}

}  // namespace

py::dict diagnosis_dictionary(const Diagnosis& d) {
  using namespace py::literals;
  py::list values;
  for (const NamedValue& v : d.values)
    values.append(py::dict("vector"_a = v.vector, "index"_a = v.index, "value"_a = v.value, "items"_a = v.items));
  return py::dict("reason"_a = name_of(d.reason), "solverName"_a = d.solver, "stepIndex"_a = d.step, "time"_a = d.time,
                  "stepSize"_a = d.step_size, "loadFactor"_a = d.load_factor, "newtonSteps"_a = d.newton_iteration,
                  "residual"_a = d.residual, "relativeResidual"_a = d.relative_residual,
                  "relativeTolerance"_a = d.tolerance_relative, "absoluteTolerance"_a = d.tolerance_absolute,
                  "values"_a = values, "sources"_a = d.sources, "causingRow"_a = d.singular_row,
                  "causingItems"_a = d.singular_items, "dependentEquations"_a = d.dependent,
                  "freeDirections"_a = d.free, "advice"_a = d.advice);
}

py::dict redundancy_dictionary(const ConstraintRank& redundant, const System& system) {
  using namespace py::literals;
  py::list items;
  for (const ConstraintRank::Item& item : redundant.items(system))
    items.append(py::dict("object"_a = item.object, "item"_a = item.item, "equations"_a = item.equations,
                          "removable"_a = item.removable));
  return py::dict("count"_a = redundant.count(), "items"_a = items, "equations"_a = redundant.equations(),
                  "weakest"_a = redundant.weakest(), "certain"_a = redundant.certain());
}

void register_solver_data(py::module_& module) {
  register_iteration(module);
  register_convergence(module);
  register_output(module);
  register_timer(module);
}

}  // namespace dalembert
