// Generated from specs/settings/simulation_settings.toml by codegen/templates/settings.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/simulation_settings.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace dalembert {
namespace {

constexpr std::array<Row, 8> NewtonNumericalDifferentiationSettings_rows{{
    {.name = "addReferenceCoordinatesToEpsilon", .storage = Storage::boolean, .offset = offsetof(NewtonNumericalDifferentiationSettings, addReferenceCoordinatesToEpsilon), .role = Role::parameter},
    {.name = "doSystemWideDifferentiation", .storage = Storage::boolean, .offset = offsetof(NewtonNumericalDifferentiationSettings, doSystemWideDifferentiation), .role = Role::parameter},
    {.name = "forAE", .storage = Storage::boolean, .offset = offsetof(NewtonNumericalDifferentiationSettings, forAE), .role = Role::parameter},
    {.name = "forODE2", .storage = Storage::boolean, .offset = offsetof(NewtonNumericalDifferentiationSettings, forODE2), .role = Role::parameter},
    {.name = "forODE2connectors", .storage = Storage::boolean, .offset = offsetof(NewtonNumericalDifferentiationSettings, forODE2connectors), .role = Role::parameter},
    {.name = "jacobianConnectorDerivative", .storage = Storage::boolean, .offset = offsetof(NewtonNumericalDifferentiationSettings, jacobianConnectorDerivative), .role = Role::parameter},
    {.name = "minimumCoordinateSize", .storage = Storage::real, .offset = offsetof(NewtonNumericalDifferentiationSettings, minimumCoordinateSize), .role = Role::parameter, .check = Check::non_negative, .unit = "various"},
    {.name = "relativeEpsilon", .storage = Storage::real, .offset = offsetof(NewtonNumericalDifferentiationSettings, relativeEpsilon), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
}};
constexpr std::array<std::string_view, 4> NewtonNumericalDifferentiationSettings_flags_of_addReferenceCoordinatesToEpsilon{"doSystemWideDifferentiation", "forAE", "forODE2", "forODE2connectors"};
constexpr std::array<std::string_view, 4> NewtonNumericalDifferentiationSettings_flags_of_minimumCoordinateSize{"doSystemWideDifferentiation", "forAE", "forODE2", "forODE2connectors"};
constexpr std::array<std::string_view, 4> NewtonNumericalDifferentiationSettings_flags_of_relativeEpsilon{"doSystemWideDifferentiation", "forAE", "forODE2", "forODE2connectors"};
constexpr std::array<SettingRule, 4> NewtonNumericalDifferentiationSettings_rules{{
    {.name = "addReferenceCoordinatesToEpsilon", .acts_with = NewtonNumericalDifferentiationSettings_flags_of_addReferenceCoordinatesToEpsilon},
    {.name = "jacobianConnectorDerivative", .no_effect = "exact derivatives always include the change of the directions of forces, at no cost worth saving"},
    {.name = "minimumCoordinateSize", .lower = 0.0, .lower_open = true, .words = "greater than 0", .acts_with = NewtonNumericalDifferentiationSettings_flags_of_minimumCoordinateSize},
    {.name = "relativeEpsilon", .lower = 0.0, .upper = 1.0, .lower_open = true, .upper_open = true, .words = "greater than 0 and less than 1", .acts_with = NewtonNumericalDifferentiationSettings_flags_of_relativeEpsilon},
}};
constexpr SettingsGroup NewtonNumericalDifferentiationSettings_group{"NewtonNumericalDifferentiationSettings", NewtonNumericalDifferentiationSettings_rows, {}, NewtonNumericalDifferentiationSettings_rules};

constexpr std::array<Row, 13> NewtonSettings_rows{{
    {.name = "absoluteTolerance", .storage = Storage::real, .offset = offsetof(NewtonSettings, absoluteTolerance), .role = Role::parameter, .check = Check::non_negative, .unit = "various"},
    {.name = "adaptInitialResidual", .storage = Storage::boolean, .offset = offsetof(NewtonSettings, adaptInitialResidual), .role = Role::parameter},
    {.name = "maximumSolutionNorm", .storage = Storage::real, .offset = offsetof(NewtonSettings, maximumSolutionNorm), .role = Role::parameter, .check = Check::non_negative, .unit = "various"},
    {.name = "maxIterations", .storage = Storage::integer, .offset = offsetof(NewtonSettings, maxIterations), .role = Role::parameter, .check = Check::non_negative},
    {.name = "maxModifiedNewtonIterations", .storage = Storage::integer, .offset = offsetof(NewtonSettings, maxModifiedNewtonIterations), .role = Role::parameter, .check = Check::non_negative},
    {.name = "maxModifiedNewtonRestartIterations", .storage = Storage::integer, .offset = offsetof(NewtonSettings, maxModifiedNewtonRestartIterations), .role = Role::parameter, .check = Check::non_negative},
    {.name = "modifiedNewtonContractivity", .storage = Storage::real, .offset = offsetof(NewtonSettings, modifiedNewtonContractivity), .role = Role::parameter, .check = Check::positive, .unit = "1"},
    {.name = "modifiedNewtonJacUpdatePerStep", .storage = Storage::boolean, .offset = offsetof(NewtonSettings, modifiedNewtonJacUpdatePerStep), .role = Role::parameter},
    {.name = "newtonResidualMode", .storage = Storage::integer, .offset = offsetof(NewtonSettings, newtonResidualMode), .role = Role::parameter, .check = Check::non_negative},
    {.name = "relativeTolerance", .storage = Storage::real, .offset = offsetof(NewtonSettings, relativeTolerance), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "useModifiedNewton", .storage = Storage::boolean, .offset = offsetof(NewtonSettings, useModifiedNewton), .role = Role::parameter},
    {.name = "useNewtonSolver", .storage = Storage::boolean, .offset = offsetof(NewtonSettings, useNewtonSolver), .role = Role::parameter},
    {.name = "weightTolerancePerCoordinate", .storage = Storage::boolean, .offset = offsetof(NewtonSettings, weightTolerancePerCoordinate), .role = Role::parameter},
}};
constexpr std::array<std::string_view, 1> NewtonSettings_flags_of_maxModifiedNewtonIterations{"useModifiedNewton"};
constexpr std::array<std::string_view, 1> NewtonSettings_flags_of_maxModifiedNewtonRestartIterations{"useModifiedNewton"};
constexpr std::array<std::string_view, 1> NewtonSettings_flags_of_modifiedNewtonContractivity{"useModifiedNewton"};
constexpr std::array<std::string_view, 1> NewtonSettings_flags_of_modifiedNewtonJacUpdatePerStep{"useModifiedNewton"};
constexpr std::array<SettingRule, 8> NewtonSettings_rules{{
    {.name = "maximumSolutionNorm", .lower = 0.0, .lower_open = true, .words = "greater than 0"},
    {.name = "maxIterations", .lower = 1.0, .words = "at least 1"},
    {.name = "maxModifiedNewtonIterations", .acts_with = NewtonSettings_flags_of_maxModifiedNewtonIterations},
    {.name = "maxModifiedNewtonRestartIterations", .acts_with = NewtonSettings_flags_of_maxModifiedNewtonRestartIterations},
    {.name = "modifiedNewtonContractivity", .acts_with = NewtonSettings_flags_of_modifiedNewtonContractivity},
    {.name = "modifiedNewtonJacUpdatePerStep", .acts_with = NewtonSettings_flags_of_modifiedNewtonJacUpdatePerStep},
    {.name = "newtonResidualMode", .lower = 0.0, .upper = 1.0, .words = "from 0 to 1"},
    {.name = "relativeTolerance", .lower = 0.0, .upper = 1.0, .words = "from 0 to 1"},
}};
constexpr std::array<SettingsChild, 1> NewtonSettings_children{{
    {"numericalDifferentiation", &NewtonNumericalDifferentiationSettings_group, offsetof(NewtonSettings, numericalDifferentiation)},
}};
constexpr SettingsGroup NewtonSettings_group{"NewtonSettings", NewtonSettings_rows, NewtonSettings_children, NewtonSettings_rules};

constexpr std::array<Row, 4> DiscontinuousSettings_rows{{
    {.name = "ignoreMaxIterations", .storage = Storage::boolean, .offset = offsetof(DiscontinuousSettings, ignoreMaxIterations), .role = Role::parameter},
    {.name = "iterationTolerance", .storage = Storage::real, .offset = offsetof(DiscontinuousSettings, iterationTolerance), .role = Role::parameter, .check = Check::non_negative, .unit = "various"},
    {.name = "maxIterations", .storage = Storage::integer, .offset = offsetof(DiscontinuousSettings, maxIterations), .role = Role::parameter, .check = Check::non_negative},
    {.name = "useRecommendedStepSize", .storage = Storage::boolean, .offset = offsetof(DiscontinuousSettings, useRecommendedStepSize), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 1> DiscontinuousSettings_rules{{
    {.name = "maxIterations", .lower = 1.0, .words = "at least 1"},
}};
constexpr SettingsGroup DiscontinuousSettings_group{"DiscontinuousSettings", DiscontinuousSettings_rows, {}, DiscontinuousSettings_rules};

constexpr std::array<Row, 2> ContinuationSettings_rows{{
    {.name = "ifAvailable", .storage = Storage::boolean, .offset = offsetof(ContinuationSettings, ifAvailable), .role = Role::parameter},
    {.name = "restartFileName", .storage = Storage::text, .offset = offsetof(ContinuationSettings, restartFileName), .role = Role::parameter},
}};
constexpr SettingsGroup ContinuationSettings_group{"ContinuationSettings", ContinuationSettings_rows, {}};

constexpr std::array<Row, 1> DenseOutputSettings_rows{{
    {.name = "atRequestedTimes", .storage = Storage::boolean, .offset = offsetof(DenseOutputSettings, atRequestedTimes), .role = Role::parameter},
}};
constexpr SettingsGroup DenseOutputSettings_group{"DenseOutputSettings", DenseOutputSettings_rows, {}};

constexpr std::array<Row, 1> EventsSettings_rows{{
    {.name = "ofItems", .storage = Storage::boolean, .offset = offsetof(EventsSettings, ofItems), .role = Role::parameter},
}};
constexpr SettingsGroup EventsSettings_group{"EventsSettings", EventsSettings_rows, {}};

constexpr std::array<Row, 4> InitialConditionsSettings_rows{{
    {.name = "checkConstraints", .storage = Storage::boolean, .offset = offsetof(InitialConditionsSettings, checkConstraints), .role = Role::parameter},
    {.name = "inconsistentIsError", .storage = Storage::boolean, .offset = offsetof(InitialConditionsSettings, inconsistentIsError), .role = Role::parameter},
    {.name = "positionTolerance", .storage = Storage::real, .offset = offsetof(InitialConditionsSettings, positionTolerance), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "velocityTolerance", .storage = Storage::real, .offset = offsetof(InitialConditionsSettings, velocityTolerance), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
}};
constexpr SettingsGroup InitialConditionsSettings_group{"InitialConditionsSettings", InitialConditionsSettings_rows, {}};

constexpr std::array<Row, 1> LinearSolverChoiceSettings_rows{{
    {.name = "automatic", .storage = Storage::boolean, .offset = offsetof(LinearSolverChoiceSettings, automatic), .role = Role::parameter},
}};
constexpr SettingsGroup LinearSolverChoiceSettings_group{"LinearSolverChoiceSettings", LinearSolverChoiceSettings_rows, {}};

constexpr std::array<Row, 4> LinearSolverSettings_rows{{
    {.name = "ignoreSingularJacobian", .storage = Storage::boolean, .offset = offsetof(LinearSolverSettings, ignoreSingularJacobian), .role = Role::parameter},
    {.name = "pivotThreshold", .storage = Storage::real, .offset = offsetof(LinearSolverSettings, pivotThreshold), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "reuseAnalyzedPattern", .storage = Storage::boolean, .offset = offsetof(LinearSolverSettings, reuseAnalyzedPattern), .role = Role::parameter},
    {.name = "showCausingItems", .storage = Storage::boolean, .offset = offsetof(LinearSolverSettings, showCausingItems), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 1> LinearSolverSettings_rules{{
    {.name = "reuseAnalyzedPattern", .no_effect = "a sparse matrix is always analyzed once for all factorizations with the same pattern"},
}};
constexpr SettingsGroup LinearSolverSettings_group{"LinearSolverSettings", LinearSolverSettings_rows, {}, LinearSolverSettings_rules};

constexpr std::array<Row, 8> ParallelSettings_rows{{
    {.name = "multithreadedLLimitJacobians", .storage = Storage::integer, .offset = offsetof(ParallelSettings, multithreadedLLimitJacobians), .role = Role::parameter, .check = Check::positive},
    {.name = "multithreadedLLimitLoads", .storage = Storage::integer, .offset = offsetof(ParallelSettings, multithreadedLLimitLoads), .role = Role::parameter, .check = Check::positive},
    {.name = "multithreadedLLimitMassMatrices", .storage = Storage::integer, .offset = offsetof(ParallelSettings, multithreadedLLimitMassMatrices), .role = Role::parameter, .check = Check::positive},
    {.name = "multithreadedLLimitResiduals", .storage = Storage::integer, .offset = offsetof(ParallelSettings, multithreadedLLimitResiduals), .role = Role::parameter, .check = Check::positive},
    {.name = "numberOfThreads", .storage = Storage::integer, .offset = offsetof(ParallelSettings, numberOfThreads), .role = Role::parameter, .check = Check::positive},
    {.name = "taskSplitMinItems", .storage = Storage::integer, .offset = offsetof(ParallelSettings, taskSplitMinItems), .role = Role::parameter, .check = Check::positive},
    {.name = "taskSplitTasksPerThread", .storage = Storage::integer, .offset = offsetof(ParallelSettings, taskSplitTasksPerThread), .role = Role::parameter, .check = Check::positive},
    {.name = "useLoadBalancing", .storage = Storage::boolean, .offset = offsetof(ParallelSettings, useLoadBalancing), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 7> ParallelSettings_rules{{
    {.name = "multithreadedLLimitJacobians", .no_effect = "how work is divided among threads follows from the size of the system alone, so that results do not depend on it"},
    {.name = "multithreadedLLimitLoads", .no_effect = "how work is divided among threads follows from the size of the system alone, so that results do not depend on it"},
    {.name = "multithreadedLLimitMassMatrices", .no_effect = "how work is divided among threads follows from the size of the system alone, so that results do not depend on it"},
    {.name = "multithreadedLLimitResiduals", .no_effect = "how work is divided among threads follows from the size of the system alone, so that results do not depend on it"},
    {.name = "taskSplitMinItems", .no_effect = "how work is divided among threads follows from the size of the system alone, so that results do not depend on it"},
    {.name = "taskSplitTasksPerThread", .no_effect = "how work is divided among threads follows from the size of the system alone, so that results do not depend on it"},
    {.name = "useLoadBalancing", .no_effect = "threads that are ready always take over work of others"},
}};
constexpr SettingsGroup ParallelSettings_group{"ParallelSettings", ParallelSettings_rows, {}, ParallelSettings_rules};

constexpr std::array<Row, 3> RedundantConstraintsSettings_rows{{
    {.name = "largestMisfit", .storage = Storage::real, .offset = offsetof(RedundantConstraintsSettings, largestMisfit), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "momentLength", .storage = Storage::real, .offset = offsetof(RedundantConstraintsSettings, momentLength), .role = Role::parameter, .check = Check::non_negative, .unit = "m"},
    {.name = "treat", .storage = Storage::boolean, .offset = offsetof(RedundantConstraintsSettings, treat), .role = Role::parameter},
}};
constexpr SettingsGroup RedundantConstraintsSettings_group{"RedundantConstraintsSettings", RedundantConstraintsSettings_rows, {}};

constexpr std::array<Row, 27> SolutionSettings_rows{{
    {.name = "appendToFile", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, appendToFile), .role = Role::parameter},
    {.name = "binarySolutionFile", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, binarySolutionFile), .role = Role::parameter},
    {.name = "coordinatesSolutionFileName", .storage = Storage::text, .offset = offsetof(SolutionSettings, coordinatesSolutionFileName), .role = Role::parameter},
    {.name = "exportAccelerations", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, exportAccelerations), .role = Role::parameter},
    {.name = "exportAlgebraicCoordinates", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, exportAlgebraicCoordinates), .role = Role::parameter},
    {.name = "exportDataCoordinates", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, exportDataCoordinates), .role = Role::parameter},
    {.name = "exportODE1Velocities", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, exportODE1Velocities), .role = Role::parameter},
    {.name = "exportVelocities", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, exportVelocities), .role = Role::parameter},
    {.name = "flushFilesDOF", .storage = Storage::integer, .offset = offsetof(SolutionSettings, flushFilesDOF), .role = Role::parameter, .check = Check::positive},
    {.name = "flushFilesImmediately", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, flushFilesImmediately), .role = Role::parameter},
    {.name = "outputPrecision", .storage = Storage::integer, .offset = offsetof(SolutionSettings, outputPrecision), .role = Role::parameter, .check = Check::non_negative},
    {.name = "recordImagesInterval", .storage = Storage::real, .offset = offsetof(SolutionSettings, recordImagesInterval), .role = Role::parameter, .unit = "s"},
    {.name = "restartFileName", .storage = Storage::text, .offset = offsetof(SolutionSettings, restartFileName), .role = Role::parameter},
    {.name = "restartWritePeriod", .storage = Storage::real, .offset = offsetof(SolutionSettings, restartWritePeriod), .role = Role::parameter, .check = Check::non_negative, .unit = "s"},
    {.name = "sensorsAppendToFile", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, sensorsAppendToFile), .role = Role::parameter},
    {.name = "sensorsStoreAndWriteFiles", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, sensorsStoreAndWriteFiles), .role = Role::parameter},
    {.name = "sensorsWriteFileFooter", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, sensorsWriteFileFooter), .role = Role::parameter},
    {.name = "sensorsWriteFileHeader", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, sensorsWriteFileHeader), .role = Role::parameter},
    {.name = "sensorsWritePeriod", .storage = Storage::real, .offset = offsetof(SolutionSettings, sensorsWritePeriod), .role = Role::parameter, .check = Check::non_negative, .unit = "s"},
    {.name = "solutionInformation", .storage = Storage::text, .offset = offsetof(SolutionSettings, solutionInformation), .role = Role::parameter},
    {.name = "solutionWritePeriod", .storage = Storage::real, .offset = offsetof(SolutionSettings, solutionWritePeriod), .role = Role::parameter, .check = Check::non_negative, .unit = "s"},
    {.name = "solverInformationFileName", .storage = Storage::text, .offset = offsetof(SolutionSettings, solverInformationFileName), .role = Role::parameter},
    {.name = "writeFileFooter", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, writeFileFooter), .role = Role::parameter},
    {.name = "writeFileHeader", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, writeFileHeader), .role = Role::parameter},
    {.name = "writeInitialValues", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, writeInitialValues), .role = Role::parameter},
    {.name = "writeRestartFile", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, writeRestartFile), .role = Role::parameter},
    {.name = "writeSolutionToFile", .storage = Storage::boolean, .offset = offsetof(SolutionSettings, writeSolutionToFile), .role = Role::parameter},
}};
constexpr std::array<std::string_view, 1> SolutionSettings_flags_of_restartWritePeriod{"writeRestartFile"};
constexpr std::array<SettingRule, 2> SolutionSettings_rules{{
    {.name = "outputPrecision", .lower = 1.0, .upper = 17.0, .words = "from 1 to 17"},
    {.name = "restartWritePeriod", .acts_with = SolutionSettings_flags_of_restartWritePeriod},
}};
constexpr SettingsGroup SolutionSettings_group{"SolutionSettings", SolutionSettings_rows, {}, SolutionSettings_rules};

constexpr std::array<Row, 7> StaticSolverArcLengthSettings_rows{{
    {.name = "active", .storage = Storage::boolean, .offset = offsetof(StaticSolverArcLengthSettings, active), .role = Role::parameter},
    {.name = "branchStep", .storage = Storage::real, .offset = offsetof(StaticSolverArcLengthSettings, branchStep), .role = Role::parameter, .unit = "various"},
    {.name = "desiredIterations", .storage = Storage::integer, .offset = offsetof(StaticSolverArcLengthSettings, desiredIterations), .role = Role::parameter, .check = Check::non_negative},
    {.name = "largestStep", .storage = Storage::real, .offset = offsetof(StaticSolverArcLengthSettings, largestStep), .role = Role::parameter, .check = Check::non_negative, .unit = "various"},
    {.name = "lowestLoadFactor", .storage = Storage::real, .offset = offsetof(StaticSolverArcLengthSettings, lowestLoadFactor), .role = Role::parameter, .unit = "1"},
    {.name = "maximumSteps", .storage = Storage::integer, .offset = offsetof(StaticSolverArcLengthSettings, maximumSteps), .role = Role::parameter, .check = Check::non_negative},
    {.name = "singularPoints", .storage = Storage::boolean, .offset = offsetof(StaticSolverArcLengthSettings, singularPoints), .role = Role::parameter},
}};
constexpr std::array<std::string_view, 1> StaticSolverArcLengthSettings_flags_of_branchStep{"active"};
constexpr std::array<std::string_view, 1> StaticSolverArcLengthSettings_flags_of_desiredIterations{"active"};
constexpr std::array<std::string_view, 1> StaticSolverArcLengthSettings_flags_of_largestStep{"active"};
constexpr std::array<std::string_view, 1> StaticSolverArcLengthSettings_flags_of_lowestLoadFactor{"active"};
constexpr std::array<std::string_view, 1> StaticSolverArcLengthSettings_flags_of_maximumSteps{"active"};
constexpr std::array<std::string_view, 1> StaticSolverArcLengthSettings_flags_of_singularPoints{"active"};
constexpr std::array<SettingRule, 6> StaticSolverArcLengthSettings_rules{{
    {.name = "branchStep", .acts_with = StaticSolverArcLengthSettings_flags_of_branchStep},
    {.name = "desiredIterations", .lower = 1.0, .words = "at least 1", .acts_with = StaticSolverArcLengthSettings_flags_of_desiredIterations},
    {.name = "largestStep", .acts_with = StaticSolverArcLengthSettings_flags_of_largestStep},
    {.name = "lowestLoadFactor", .upper = 0.0, .words = "at most 0", .acts_with = StaticSolverArcLengthSettings_flags_of_lowestLoadFactor},
    {.name = "maximumSteps", .lower = 1.0, .words = "at least 1", .acts_with = StaticSolverArcLengthSettings_flags_of_maximumSteps},
    {.name = "singularPoints", .acts_with = StaticSolverArcLengthSettings_flags_of_singularPoints},
}};
constexpr SettingsGroup StaticSolverArcLengthSettings_group{"StaticSolverArcLengthSettings", StaticSolverArcLengthSettings_rows, {}, StaticSolverArcLengthSettings_rules};

constexpr std::array<Row, 18> StaticSolverSettings_rows{{
    {.name = "adaptiveStep", .storage = Storage::boolean, .offset = offsetof(StaticSolverSettings, adaptiveStep), .role = Role::parameter},
    {.name = "adaptiveStepDecrease", .storage = Storage::real, .offset = offsetof(StaticSolverSettings, adaptiveStepDecrease), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "adaptiveStepIncrease", .storage = Storage::real, .offset = offsetof(StaticSolverSettings, adaptiveStepIncrease), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "adaptiveStepRecoveryIterations", .storage = Storage::integer, .offset = offsetof(StaticSolverSettings, adaptiveStepRecoveryIterations), .role = Role::parameter, .check = Check::non_negative},
    {.name = "adaptiveStepRecoverySteps", .storage = Storage::integer, .offset = offsetof(StaticSolverSettings, adaptiveStepRecoverySteps), .role = Role::parameter, .check = Check::non_negative},
    {.name = "computeLoadsJacobian", .storage = Storage::boolean, .offset = offsetof(StaticSolverSettings, computeLoadsJacobian), .role = Role::parameter},
    {.name = "constrainODE1coordinates", .storage = Storage::boolean, .offset = offsetof(StaticSolverSettings, constrainODE1coordinates), .role = Role::parameter},
    {.name = "loadStepDuration", .storage = Storage::real, .offset = offsetof(StaticSolverSettings, loadStepDuration), .role = Role::parameter, .check = Check::positive, .unit = "s"},
    {.name = "loadStepGeometric", .storage = Storage::boolean, .offset = offsetof(StaticSolverSettings, loadStepGeometric), .role = Role::parameter},
    {.name = "loadStepGeometricRange", .storage = Storage::real, .offset = offsetof(StaticSolverSettings, loadStepGeometricRange), .role = Role::parameter, .check = Check::positive, .unit = "1"},
    {.name = "loadStepStart", .storage = Storage::real, .offset = offsetof(StaticSolverSettings, loadStepStart), .role = Role::parameter, .check = Check::non_negative, .unit = "s"},
    {.name = "minimumStepSize", .storage = Storage::real, .offset = offsetof(StaticSolverSettings, minimumStepSize), .role = Role::parameter, .check = Check::positive, .unit = "s"},
    {.name = "numberOfLoadSteps", .storage = Storage::integer, .offset = offsetof(StaticSolverSettings, numberOfLoadSteps), .role = Role::parameter, .check = Check::positive},
    {.name = "stabilizerODE2term", .storage = Storage::real, .offset = offsetof(StaticSolverSettings, stabilizerODE2term), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "stepInformation", .storage = Storage::integer, .offset = offsetof(StaticSolverSettings, stepInformation), .role = Role::parameter, .check = Check::non_negative},
    {.name = "useLoadFactor", .storage = Storage::boolean, .offset = offsetof(StaticSolverSettings, useLoadFactor), .role = Role::parameter},
    {.name = "verboseMode", .storage = Storage::integer, .offset = offsetof(StaticSolverSettings, verboseMode), .role = Role::parameter, .check = Check::non_negative},
    {.name = "verboseModeFile", .storage = Storage::integer, .offset = offsetof(StaticSolverSettings, verboseModeFile), .role = Role::parameter, .check = Check::non_negative},
}};
constexpr std::array<std::string_view, 1> StaticSolverSettings_flags_of_adaptiveStepDecrease{"adaptiveStep"};
constexpr std::array<std::string_view, 1> StaticSolverSettings_flags_of_adaptiveStepIncrease{"adaptiveStep"};
constexpr std::array<std::string_view, 1> StaticSolverSettings_flags_of_adaptiveStepRecoveryIterations{"adaptiveStep"};
constexpr std::array<std::string_view, 1> StaticSolverSettings_flags_of_adaptiveStepRecoverySteps{"adaptiveStep"};
constexpr std::array<std::string_view, 1> StaticSolverSettings_flags_of_loadStepGeometricRange{"loadStepGeometric"};
constexpr std::array<SettingRule, 5> StaticSolverSettings_rules{{
    {.name = "adaptiveStepDecrease", .lower = 0.0, .upper = 1.0, .lower_open = true, .upper_open = true, .words = "greater than 0 and less than 1", .acts_with = StaticSolverSettings_flags_of_adaptiveStepDecrease},
    {.name = "adaptiveStepIncrease", .lower = 1.0, .words = "at least 1", .acts_with = StaticSolverSettings_flags_of_adaptiveStepIncrease},
    {.name = "adaptiveStepRecoveryIterations", .acts_with = StaticSolverSettings_flags_of_adaptiveStepRecoveryIterations},
    {.name = "adaptiveStepRecoverySteps", .acts_with = StaticSolverSettings_flags_of_adaptiveStepRecoverySteps},
    {.name = "loadStepGeometricRange", .lower = 1.0, .lower_open = true, .words = "greater than 1", .acts_with = StaticSolverSettings_flags_of_loadStepGeometricRange},
}};
constexpr std::array<SettingsChild, 3> StaticSolverSettings_children{{
    {"arcLength", &StaticSolverArcLengthSettings_group, offsetof(StaticSolverSettings, arcLength)},
    {"discontinuous", &DiscontinuousSettings_group, offsetof(StaticSolverSettings, discontinuous)},
    {"newton", &NewtonSettings_group, offsetof(StaticSolverSettings, newton)},
}};
constexpr SettingsGroup StaticSolverSettings_group{"StaticSolverSettings", StaticSolverSettings_rows, StaticSolverSettings_children, StaticSolverSettings_rules};

constexpr std::array<Row, 1> StepSizeControlSettings_rows{{
    {.name = "implicitSolvers", .storage = Storage::boolean, .offset = offsetof(StepSizeControlSettings, implicitSolvers), .role = Role::parameter},
}};
constexpr SettingsGroup StepSizeControlSettings_group{"StepSizeControlSettings", StepSizeControlSettings_rows, {}};

constexpr std::array<Row, 5> TimeIntegrationExplicitIntegrationSettings_rows{{
    {.name = "computeEndOfStepAccelerations", .storage = Storage::boolean, .offset = offsetof(TimeIntegrationExplicitIntegrationSettings, computeEndOfStepAccelerations), .role = Role::parameter},
    {.name = "computeMassMatrixInversePerBody", .storage = Storage::boolean, .offset = offsetof(TimeIntegrationExplicitIntegrationSettings, computeMassMatrixInversePerBody), .role = Role::parameter},
    {.name = "dynamicSolverType", .storage = Storage::enumeration, .offset = offsetof(TimeIntegrationExplicitIntegrationSettings, dynamicSolverType), .role = Role::parameter, .enumeration = 4},
    {.name = "eliminateConstraints", .storage = Storage::boolean, .offset = offsetof(TimeIntegrationExplicitIntegrationSettings, eliminateConstraints), .role = Role::parameter},
    {.name = "useLieGroupIntegration", .storage = Storage::boolean, .offset = offsetof(TimeIntegrationExplicitIntegrationSettings, useLieGroupIntegration), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 1> TimeIntegrationExplicitIntegrationSettings_rules{{
    {.name = "computeMassMatrixInversePerBody", .no_effect = "the mass matrix is always inverted in blocks that are not coupled, body by body where bodies share no nodes"},
}};
constexpr SettingsGroup TimeIntegrationExplicitIntegrationSettings_group{"TimeIntegrationExplicitIntegrationSettings", TimeIntegrationExplicitIntegrationSettings_rows, {}, TimeIntegrationExplicitIntegrationSettings_rules};

constexpr std::array<Row, 10> TimeIntegrationGeneralizedAlphaSettings_rows{{
    {.name = "computeInitialAccelerations", .storage = Storage::boolean, .offset = offsetof(TimeIntegrationGeneralizedAlphaSettings, computeInitialAccelerations), .role = Role::parameter},
    {.name = "lieGroupAddTangentOperator", .storage = Storage::boolean, .offset = offsetof(TimeIntegrationGeneralizedAlphaSettings, lieGroupAddTangentOperator), .role = Role::parameter},
    {.name = "lieGroupSimplifiedKinematicRelations", .storage = Storage::boolean, .offset = offsetof(TimeIntegrationGeneralizedAlphaSettings, lieGroupSimplifiedKinematicRelations), .role = Role::parameter},
    {.name = "newmarkBeta", .storage = Storage::real, .offset = offsetof(TimeIntegrationGeneralizedAlphaSettings, newmarkBeta), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "newmarkGamma", .storage = Storage::real, .offset = offsetof(TimeIntegrationGeneralizedAlphaSettings, newmarkGamma), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "resetAccelerations", .storage = Storage::boolean, .offset = offsetof(TimeIntegrationGeneralizedAlphaSettings, resetAccelerations), .role = Role::parameter},
    {.name = "spectralRadius", .storage = Storage::real, .offset = offsetof(TimeIntegrationGeneralizedAlphaSettings, spectralRadius), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "storeInitialAlgebraicCoordinates", .storage = Storage::boolean, .offset = offsetof(TimeIntegrationGeneralizedAlphaSettings, storeInitialAlgebraicCoordinates), .role = Role::parameter},
    {.name = "useIndex2Constraints", .storage = Storage::boolean, .offset = offsetof(TimeIntegrationGeneralizedAlphaSettings, useIndex2Constraints), .role = Role::parameter},
    {.name = "useNewmark", .storage = Storage::boolean, .offset = offsetof(TimeIntegrationGeneralizedAlphaSettings, useNewmark), .role = Role::parameter},
}};
constexpr std::array<std::string_view, 1> TimeIntegrationGeneralizedAlphaSettings_flags_of_lieGroupAddTangentOperator{"lieGroupSimplifiedKinematicRelations"};
constexpr std::array<std::string_view, 1> TimeIntegrationGeneralizedAlphaSettings_flags_of_newmarkBeta{"useNewmark"};
constexpr std::array<std::string_view, 1> TimeIntegrationGeneralizedAlphaSettings_flags_of_newmarkGamma{"useNewmark"};
constexpr std::array<SettingRule, 4> TimeIntegrationGeneralizedAlphaSettings_rules{{
    {.name = "lieGroupAddTangentOperator", .acts_with = TimeIntegrationGeneralizedAlphaSettings_flags_of_lieGroupAddTangentOperator},
    {.name = "newmarkBeta", .lower = 0.0, .upper = 1.0, .lower_open = true, .words = "greater than 0 and at most 1", .acts_with = TimeIntegrationGeneralizedAlphaSettings_flags_of_newmarkBeta},
    {.name = "newmarkGamma", .lower = 0.0, .upper = 1.5, .lower_open = true, .words = "greater than 0 and at most 1.5", .acts_with = TimeIntegrationGeneralizedAlphaSettings_flags_of_newmarkGamma},
    {.name = "spectralRadius", .lower = 0.0, .upper = 1.0, .words = "from 0 to 1"},
}};
constexpr SettingsGroup TimeIntegrationGeneralizedAlphaSettings_group{"TimeIntegrationGeneralizedAlphaSettings", TimeIntegrationGeneralizedAlphaSettings_rows, {}, TimeIntegrationGeneralizedAlphaSettings_rules};

constexpr std::array<Row, 24> TimeIntegrationSettings_rows{{
    {.name = "absoluteTolerance", .storage = Storage::real, .offset = offsetof(TimeIntegrationSettings, absoluteTolerance), .role = Role::parameter, .check = Check::non_negative, .unit = "various"},
    {.name = "adaptiveStep", .storage = Storage::boolean, .offset = offsetof(TimeIntegrationSettings, adaptiveStep), .role = Role::parameter},
    {.name = "adaptiveStepDecrease", .storage = Storage::real, .offset = offsetof(TimeIntegrationSettings, adaptiveStepDecrease), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "adaptiveStepIncrease", .storage = Storage::real, .offset = offsetof(TimeIntegrationSettings, adaptiveStepIncrease), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "adaptiveStepRecoveryIterations", .storage = Storage::integer, .offset = offsetof(TimeIntegrationSettings, adaptiveStepRecoveryIterations), .role = Role::parameter, .check = Check::non_negative},
    {.name = "adaptiveStepRecoverySteps", .storage = Storage::integer, .offset = offsetof(TimeIntegrationSettings, adaptiveStepRecoverySteps), .role = Role::parameter, .check = Check::non_negative},
    {.name = "automaticStepSize", .storage = Storage::boolean, .offset = offsetof(TimeIntegrationSettings, automaticStepSize), .role = Role::parameter},
    {.name = "computeLoadsJacobian", .storage = Storage::integer, .offset = offsetof(TimeIntegrationSettings, computeLoadsJacobian), .role = Role::parameter, .check = Check::non_negative},
    {.name = "endTime", .storage = Storage::real, .offset = offsetof(TimeIntegrationSettings, endTime), .role = Role::parameter, .check = Check::non_negative, .unit = "s"},
    {.name = "initialStepSize", .storage = Storage::real, .offset = offsetof(TimeIntegrationSettings, initialStepSize), .role = Role::parameter, .check = Check::non_negative, .unit = "s"},
    {.name = "minimumStepSize", .storage = Storage::real, .offset = offsetof(TimeIntegrationSettings, minimumStepSize), .role = Role::parameter, .check = Check::positive, .unit = "s"},
    {.name = "numberOfSteps", .storage = Storage::real, .offset = offsetof(TimeIntegrationSettings, numberOfSteps), .role = Role::parameter, .check = Check::positive, .unit = "1"},
    {.name = "realtimeFactor", .storage = Storage::real, .offset = offsetof(TimeIntegrationSettings, realtimeFactor), .role = Role::parameter, .check = Check::positive, .unit = "1"},
    {.name = "realtimeWaitMicroseconds", .storage = Storage::integer, .offset = offsetof(TimeIntegrationSettings, realtimeWaitMicroseconds), .role = Role::parameter, .check = Check::positive},
    {.name = "relativeTolerance", .storage = Storage::real, .offset = offsetof(TimeIntegrationSettings, relativeTolerance), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "reuseConstantMassMatrix", .storage = Storage::boolean, .offset = offsetof(TimeIntegrationSettings, reuseConstantMassMatrix), .role = Role::parameter},
    {.name = "simulateInRealtime", .storage = Storage::boolean, .offset = offsetof(TimeIntegrationSettings, simulateInRealtime), .role = Role::parameter},
    {.name = "startTime", .storage = Storage::real, .offset = offsetof(TimeIntegrationSettings, startTime), .role = Role::parameter, .check = Check::non_negative, .unit = "s"},
    {.name = "stepInformation", .storage = Storage::integer, .offset = offsetof(TimeIntegrationSettings, stepInformation), .role = Role::parameter, .check = Check::non_negative},
    {.name = "solverType", .storage = Storage::enumeration, .offset = offsetof(TimeIntegrationSettings, solverType), .role = Role::parameter, .enumeration = 4},
    {.name = "stepSizeMaxIncrease", .storage = Storage::real, .offset = offsetof(TimeIntegrationSettings, stepSizeMaxIncrease), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "stepSizeSafety", .storage = Storage::real, .offset = offsetof(TimeIntegrationSettings, stepSizeSafety), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "verboseMode", .storage = Storage::integer, .offset = offsetof(TimeIntegrationSettings, verboseMode), .role = Role::parameter, .check = Check::non_negative},
    {.name = "verboseModeFile", .storage = Storage::integer, .offset = offsetof(TimeIntegrationSettings, verboseModeFile), .role = Role::parameter, .check = Check::non_negative},
}};
constexpr std::array<std::string_view, 2> TimeIntegrationSettings_flags_of_adaptiveStepDecrease{"adaptiveStep", "automaticStepSize"};
constexpr std::array<std::string_view, 2> TimeIntegrationSettings_flags_of_adaptiveStepIncrease{"adaptiveStep", "automaticStepSize"};
constexpr std::array<std::string_view, 2> TimeIntegrationSettings_flags_of_adaptiveStepRecoveryIterations{"adaptiveStep", "automaticStepSize"};
constexpr std::array<std::string_view, 2> TimeIntegrationSettings_flags_of_adaptiveStepRecoverySteps{"adaptiveStep", "automaticStepSize"};
constexpr std::array<std::string_view, 1> TimeIntegrationSettings_flags_of_realtimeFactor{"simulateInRealtime"};
constexpr std::array<std::string_view, 1> TimeIntegrationSettings_flags_of_realtimeWaitMicroseconds{"simulateInRealtime"};
constexpr std::array<SettingRule, 12> TimeIntegrationSettings_rules{{
    {.name = "absoluteTolerance", .lower = 0.0, .lower_open = true, .words = "greater than 0"},
    {.name = "adaptiveStepDecrease", .lower = 0.0, .upper = 1.0, .lower_open = true, .upper_open = true, .words = "greater than 0 and less than 1", .acts_with = TimeIntegrationSettings_flags_of_adaptiveStepDecrease},
    {.name = "adaptiveStepIncrease", .lower = 1.0, .words = "at least 1", .acts_with = TimeIntegrationSettings_flags_of_adaptiveStepIncrease},
    {.name = "adaptiveStepRecoveryIterations", .acts_with = TimeIntegrationSettings_flags_of_adaptiveStepRecoveryIterations},
    {.name = "adaptiveStepRecoverySteps", .acts_with = TimeIntegrationSettings_flags_of_adaptiveStepRecoverySteps},
    {.name = "computeLoadsJacobian", .lower = 0.0, .upper = 2.0, .words = "from 0 to 2"},
    {.name = "numberOfSteps", .lower = 1.0, .upper = 1000000000000000.0, .words = "from 1 to 1e+15"},
    {.name = "realtimeFactor", .acts_with = TimeIntegrationSettings_flags_of_realtimeFactor},
    {.name = "realtimeWaitMicroseconds", .acts_with = TimeIntegrationSettings_flags_of_realtimeWaitMicroseconds},
    {.name = "relativeTolerance", .lower = 0.0, .upper = 1.0, .words = "from 0 to 1"},
    {.name = "stepSizeMaxIncrease", .lower = 1.0, .words = "at least 1"},
    {.name = "stepSizeSafety", .lower = 0.0, .upper = 1.0, .lower_open = true, .words = "greater than 0 and at most 1"},
}};
constexpr std::array<SettingsChild, 4> TimeIntegrationSettings_children{{
    {"discontinuous", &DiscontinuousSettings_group, offsetof(TimeIntegrationSettings, discontinuous)},
    {"explicitIntegration", &TimeIntegrationExplicitIntegrationSettings_group, offsetof(TimeIntegrationSettings, explicitIntegration)},
    {"generalizedAlpha", &TimeIntegrationGeneralizedAlphaSettings_group, offsetof(TimeIntegrationSettings, generalizedAlpha)},
    {"newton", &NewtonSettings_group, offsetof(TimeIntegrationSettings, newton)},
}};
constexpr SettingsGroup TimeIntegrationSettings_group{"TimeIntegrationSettings", TimeIntegrationSettings_rows, TimeIntegrationSettings_children, TimeIntegrationSettings_rules};

constexpr std::array<Row, 7> SimulationSettings_rows{{
    {.name = "cleanUpMemory", .storage = Storage::boolean, .offset = offsetof(SimulationSettings, cleanUpMemory), .role = Role::parameter},
    {.name = "displayComputationTime", .storage = Storage::boolean, .offset = offsetof(SimulationSettings, displayComputationTime), .role = Role::parameter},
    {.name = "displayGlobalTimers", .storage = Storage::boolean, .offset = offsetof(SimulationSettings, displayGlobalTimers), .role = Role::parameter},
    {.name = "displayStatistics", .storage = Storage::boolean, .offset = offsetof(SimulationSettings, displayStatistics), .role = Role::parameter},
    {.name = "linearSolverType", .storage = Storage::enumeration, .offset = offsetof(SimulationSettings, linearSolverType), .role = Role::parameter, .enumeration = 8},
    {.name = "outputPrecision", .storage = Storage::integer, .offset = offsetof(SimulationSettings, outputPrecision), .role = Role::parameter, .check = Check::non_negative},
    {.name = "pauseAfterEachStep", .storage = Storage::boolean, .offset = offsetof(SimulationSettings, pauseAfterEachStep), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 3> SimulationSettings_rules{{
    {.name = "displayGlobalTimers", .no_effect = "there are no global timers; displayComputationTime shows where time goes"},
    {.name = "outputPrecision", .lower = 1.0, .upper = 17.0, .words = "from 1 to 17"},
    {.name = "pauseAfterEachStep", .no_effect = "solvers wait where space is pressed on the page; a PostStep user function may wait"},
}};
constexpr std::array<SettingsChild, 12> SimulationSettings_children{{
    {"continuation", &ContinuationSettings_group, offsetof(SimulationSettings, continuation)},
    {"denseOutput", &DenseOutputSettings_group, offsetof(SimulationSettings, denseOutput)},
    {"events", &EventsSettings_group, offsetof(SimulationSettings, events)},
    {"initialConditions", &InitialConditionsSettings_group, offsetof(SimulationSettings, initialConditions)},
    {"linearSolverChoice", &LinearSolverChoiceSettings_group, offsetof(SimulationSettings, linearSolverChoice)},
    {"linearSolverSettings", &LinearSolverSettings_group, offsetof(SimulationSettings, linearSolverSettings)},
    {"parallel", &ParallelSettings_group, offsetof(SimulationSettings, parallel)},
    {"redundantConstraints", &RedundantConstraintsSettings_group, offsetof(SimulationSettings, redundantConstraints)},
    {"solutionSettings", &SolutionSettings_group, offsetof(SimulationSettings, solutionSettings)},
    {"staticSolver", &StaticSolverSettings_group, offsetof(SimulationSettings, staticSolver)},
    {"stepSizeControl", &StepSizeControlSettings_group, offsetof(SimulationSettings, stepSizeControl)},
    {"timeIntegration", &TimeIntegrationSettings_group, offsetof(SimulationSettings, timeIntegration)},
}};
constexpr SettingsGroup SimulationSettings_group{"SimulationSettings", SimulationSettings_rows, SimulationSettings_children, SimulationSettings_rules};

}  // namespace

const SettingsGroup& simulation_settings_group() { return SimulationSettings_group; }

}  // namespace dalembert
