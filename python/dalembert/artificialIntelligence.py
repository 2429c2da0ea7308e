"""Environments for reinforcement learning: one system, or a thousand systems that step together.

gymnasium is an extra: pip install 'dalembert[learning]'.
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from typing import Any

import numpy as np

import dalembert as exu
from dalembert._solving.integrators import kind_of

try:
    from gymnasium import Env, logger, spaces
    from gymnasium.vector import AutoresetMode, VectorEnv
    from gymnasium.vector.utils import batch_space
except ImportError as _error:
    raise ImportError(
        f"dalembert.artificialIntelligence needs the package gymnasium ({_error}); "
        "install it with 'pip install gymnasium'"
    ) from None

__all__ = ["Env", "OpenAIGymInterfaceEnv", "VariationsVectorEnv", "exu", "logger", "np", "spaces"]


def _missing(environment: Any, method: str, what: str) -> NotImplementedError:
    return NotImplementedError(f"{type(environment).__name__}: write the method {method}, which {what}")


class OpenAIGymInterfaceEnv(Env):  # type: ignore[misc,unused-ignore]  # gymnasium is not always there
    """An environment around one MainSystem, for derived classes.

    They write CreateMBS, SetupSpaces, MapAction2MBS, Output2StateAndDone and State2InitialValues, and set
    stepUpdateTime, the time of one step in s. self.mbs, self.SC and self.simulationSettings are there when CreateMBS is
    called; self.state is the state that is observed. randomInitializationValue is the half width of random initial
    states, one number or a list.
    """

    metadata = {"render_modes": ["human"], "render_fps": 50}
    stepUpdateTime = 0.02

    def __init__(self, **kwargs: Any) -> None:
        self.state: Any = None
        self.rendererRunning: Any = None
        self.useRenderer = False
        self.flagNan = False
        self.randomInitializationValue: Any = 0.05
        self.steps_beyond_done: int | None = None
        self.SC = exu.SystemContainer()
        self.mbs: Any = self.SC.AddSystem()
        self.simulationSettings = exu.SimulationSettings()
        self.simulationSettings.solutionSettings.solutionInformation = type(self).__name__
        self.simulationSettings.solutionSettings.writeSolutionToFile = False
        self.simulationSettings.timeIntegration.verboseMode = 0
        self.stateSize = self.CreateMBS(self.SC, self.mbs, self.simulationSettings, **kwargs)
        self.SetupSpaces()
        self.PreInitializeSolver()

    # ---- implemented by derived classes ------------------------------------------------------------------------------

    def CreateMBS(self, SC: Any, mbs: Any, simulationSettings: Any, **kwargs: Any) -> int:
        """Build and assemble the system, adjust the settings, and return the number of states."""
        raise _missing(self, "CreateMBS", "builds the system and returns the number of states")

    def SetupSpaces(self) -> None:
        """Set self.action_space and self.observation_space."""
        raise _missing(self, "SetupSpaces", "sets self.action_space and self.observation_space")

    def MapAction2MBS(self, action: Any) -> None:
        """Hand an action to the system, for instance as parameter of a load."""
        raise _missing(self, "MapAction2MBS", "hands an action to self.mbs")

    def Output2StateAndDone(self) -> bool:
        """Set self.state from the system, and return whether the episode is over."""
        raise _missing(self, "Output2StateAndDone", "sets self.state and returns whether the episode is over")

    def State2InitialValues(self) -> Any:
        """Return ODE2 coordinates and their velocities that belong to self.state."""
        raise _missing(self, "State2InitialValues", "returns coordinates and velocities of self.state")

    # ---- solver ------------------------------------------------------------------------------------------------------

    def PreInitializeSolver(self) -> None:
        """Make the solver; write another one, with SetSolver(...), for another method than generalized alpha."""
        self.SetSolver(exu.DynamicSolverType.GeneralizedAlpha)

    def SetSolver(self, solverType: Any) -> None:
        """Make the solver of a type that integrates all steps."""
        integration = self.simulationSettings.timeIntegration
        trapezoidal = solverType == exu.DynamicSolverType.TrapezoidalIndex2
        integration.generalizedAlpha.useNewmark = trapezoidal
        integration.generalizedAlpha.useIndex2Constraints = trapezoidal
        kind = kind_of("SetSolver", solverType)
        if kind == "explicit":
            integration.solverType = integration.explicitIntegration.dynamicSolverType = solverType
        classes = {
            "implicit": exu.MainSolverImplicitSecondOrder,
            "diagonally implicit": exu.MainSolverDiagonallyImplicit,
            "explicit": exu.MainSolverExplicit,
        }
        self.dynamicSolver: Any = classes[kind]()
        self.dynamicSolver.InitializeSolver(self.mbs, self.simulationSettings)
        self.dynamicSolver.SolveSteps(self.mbs, self.simulationSettings)

    def IntegrateStep(self) -> None:
        """Integrate over stepUpdateTime; the result is the initial state of the next step."""
        integration = self.simulationSettings.timeIntegration
        begin = integration.endTime
        integration.endTime = begin + self.stepUpdateTime
        integration.startTime = begin
        self.dynamicSolver.InitializeSolverInitialConditions(self.mbs, self.simulationSettings)
        self.dynamicSolver.SolveSteps(self.mbs, self.simulationSettings)
        data, initial = self.mbs.systemData, exu.ConfigurationType.Initial
        data.SetSystemState(data.GetSystemState(), configuration=initial)
        data.SetODE2Coordinates_tt(data.GetODE2Coordinates_tt(), configuration=initial)

    # ---- interface of gymnasium --------------------------------------------------------------------------------------

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Take one step with an action; return observation, reward (1 until the end), terminated, truncated, info."""
        if self.state is None:
            raise RuntimeError(f"{type(self).__name__}.step(...): call reset() first")
        if not self.action_space.contains(action):
            raise ValueError(f"{type(self).__name__}.step(...): action {action!r} is not in {self.action_space}")
        coordinates, velocities = self.State2InitialValues()
        self.mbs.systemData.SetODE2Coordinates(coordinates, exu.ConfigurationType.Initial)
        self.mbs.systemData.SetODE2Coordinates_t(velocities, exu.ConfigurationType.Initial)
        self.MapAction2MBS(action)
        self.IntegrateStep()
        done = bool(self.Output2StateAndDone())
        reward = 0.0 if done and self.steps_beyond_done is not None else 1.0
        if done:
            if self.steps_beyond_done is not None:
                logger.warn(f"{type(self).__name__}.step(...): the episode is over; call reset()")
            self.steps_beyond_done = (self.steps_beyond_done or 0) + (self.steps_beyond_done is not None)
        return np.array(self.state, dtype=np.float32), reward, done, False, {}

    def reset(
        self, *, seed: int | None = None, return_info: bool = False, options: Mapping[str, Any] | None = None
    ) -> tuple[Any, dict[str, Any]]:
        """Begin an episode in a random state; return observation and info. A seed makes it the same again."""
        super().reset(seed=seed)
        half_width = np.asarray(self.randomInitializationValue, dtype=float)
        size = self.stateSize if half_width.ndim == 0 else None
        self.state = self.np_random.uniform(-half_width, half_width, size)
        self.steps_beyond_done = None
        self.State2InitialValues()
        self.simulationSettings.timeIntegration.startTime = 0
        self.simulationSettings.timeIntegration.endTime = self.stepUpdateTime
        self.dynamicSolver.InitializeSolver(self.mbs, self.simulationSettings)
        self.simulationSettings.timeIntegration.endTime = 0
        return np.array(self.state, dtype=np.float32), {}

    def render(self, mode: str = "human") -> None:
        """Show the current state, if useRenderer is set."""
        if not self.useRenderer:
            return
        if not self.rendererRunning:
            self.rendererRunning = True
            self.SC.renderer.Start()
        self.mbs.SendRedrawSignal()

    def close(self) -> None:
        """Close the window, if there is one."""
        if self.rendererRunning:
            self.rendererRunning = None
            self.SC.renderer.Stop()

    def TestModel(
        self,
        numberOfSteps: int = 500,
        seed: int = 0,
        model: Any = None,
        solutionFileName: str | None = None,
        useRenderer: bool = True,
        sleepTime: float = 0.01,
        stopIfDone: bool = False,
        showTimeSpent: bool = True,
        **kwargs: Any,
    ) -> None:
        """Run steps with random actions, or with those of a learned model that has predict(observation).

        solutionFileName: writes the solution; useRenderer, sleepTime: show it, slowly enough to see; stopIfDone: reset
        when an episode is over.
        """
        settings = self.simulationSettings.solutionSettings
        settings.writeSolutionToFile = solutionFileName is not None
        if solutionFileName is not None:
            settings.coordinatesSolutionFileName = solutionFileName
        before, self.useRenderer, self.flagNan = self.useRenderer, useRenderer, False
        observation, _ = self.reset(seed=seed)
        begin = time.perf_counter()
        for _ in range(numberOfSteps):
            action = self.action_space.sample() if model is None else model.predict(observation, deterministic=True)[0]
            if np.isnan(self.state).any():
                self.flagNan = True
                break
            observation, _, done, *_ = self.step(action)
            self.render()
            if self.mbs.GetRenderEngineStopFlag():
                break
            if stopIfDone and done:
                observation, _ = self.reset()
            if useRenderer and sleepTime:
                time.sleep(sleepTime)
        if showTimeSpent:
            exu.Print(f"{numberOfSteps} steps in {time.perf_counter() - begin:.3g} s")
        self.close()
        self.useRenderer = before


class VariationsVectorEnv(VectorEnv):  # type: ignore[misc,unused-ignore]
    """Environments that step together, all by one mbs.SolveVariations: thousands of steps of small systems per call.

    Derived classes write CreateMBS, SetupSpaces, MapActions, InitialStates and Outputs for arrays with a row per
    environment. Models have no Python functions in them: actions are parameters. An environment that has ended begins
    anew in the next step, whose action does not count for it.
    """

    metadata = {"render_modes": [], "autoreset_mode": AutoresetMode.NEXT_STEP}
    stepUpdateTime = 0.02
    solverType: Any = exu.DynamicSolverType.GeneralizedAlpha

    def __init__(self, num_envs: int, numberOfThreads: int | None = None, **kwargs: Any) -> None:
        self.num_envs = int(num_envs)
        self.numberOfThreads = numberOfThreads
        self.SC = exu.SystemContainer()
        self.mbs: Any = self.SC.AddSystem()
        self.simulationSettings = exu.SimulationSettings()
        self.CreateMBS(self.SC, self.mbs, self.simulationSettings, **kwargs)
        self.simulationSettings.timeIntegration.endTime = self.stepUpdateTime
        self.SetupSpaces()
        self.action_space = batch_space(self.single_action_space, self.num_envs)
        self.observation_space = batch_space(self.single_observation_space, self.num_envs)
        self._q = self._v = np.zeros((0, 0))
        self._others: dict[str, Any] = {}  # coordinates of first order, and the history of friction and contact
        self._ended = np.zeros(self.num_envs, dtype=bool)

    # ---- implemented by derived classes ------------------------------------------------------------------------------

    def CreateMBS(self, SC: Any, mbs: Any, simulationSettings: Any, **kwargs: Any) -> None:
        """Build and assemble the system, and set steps of the solver (numberOfSteps is that of one step here)."""
        raise _missing(self, "CreateMBS", "builds and assembles the system")

    def SetupSpaces(self) -> None:
        """Set self.single_action_space and self.single_observation_space."""
        raise _missing(self, "SetupSpaces", "sets self.single_action_space and self.single_observation_space")

    def MapActions(self, actions: Any) -> Mapping[tuple[Any, str], Any]:
        """Return parameters for SolveVariations: (item, parameter) and an array with a row per environment."""
        raise _missing(self, "MapActions", "returns arrays of parameters, by (item, parameter)")

    def InitialStates(self, number: int) -> tuple[Any, Any]:
        """Return random ODE2 coordinates and velocities, number x size each, from self.np_random."""
        raise _missing(self, "InitialStates", "returns random coordinates and velocities")

    def Outputs(self, coordinates: Any, velocities: Any) -> tuple[Any, Any, Any]:
        """Return observations, rewards and whether episodes are over, a row per environment."""
        raise _missing(self, "Outputs", "returns observations, rewards and ends of episodes")

    def _other_starts(self) -> dict[str, Any]:
        """Return coordinates that belong to an episode besides ODE2, as they are at its beginning."""
        data, initial = self.mbs.systemData, exu.ConfigurationType.Initial
        starts = {"ODE1": data.GetODE1Coordinates(initial), "Data": data.GetDataCoordinates(initial)}
        return {name: start for name, start in starts.items() if len(start)}

    # ---- interface of gymnasium --------------------------------------------------------------------------------------

    def reset(self, *, seed: Any = None, options: Mapping[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Begin all episodes; return observations and info."""
        super().reset(seed=seed)
        self._q, self._v = (np.array(part, dtype=float) for part in self.InitialStates(self.num_envs))
        self._others = {name: np.tile(start, (self.num_envs, 1)) for name, start in self._other_starts().items()}
        self._ended[:] = False
        return self._observed()[0], {}

    def step(self, actions: Any) -> tuple[Any, Any, Any, Any, dict[str, Any]]:
        """Step all environments; an environment that cannot be solved is truncated, its message is in
        info['messages']."""
        if not self._q.size:
            raise RuntimeError(f"{type(self).__name__}.step(...): call reset() first")
        found = self.mbs.SolveVariations(
            self.MapActions(np.asarray(actions)),
            self.simulationSettings,
            solverType=self.solverType,
            sensors=[],
            initialCoordinates={"ODE2": self._q, "ODE2_t": self._v, **self._others},
            storeCoordinates=True,
            numberOfThreads=self.numberOfThreads,
        )
        solved = found.success[:, None]
        self._q = np.where(solved, found.coordinates["ODE2"], self._q)
        self._v = np.where(solved, found.coordinates["ODE2_t"], self._v)
        for name, values in self._others.items():
            self._others[name] = np.where(solved, found.coordinates[name], values)
        begun = self._ended.copy()
        if begun.any():
            self._q[begun], self._v[begun] = self.InitialStates(int(begun.sum()))
            for name, start in self._other_starts().items():
                self._others[name][begun] = start
        observations, rewards, terminated = self._observed()
        rewards, terminated = np.where(begun, 0.0, rewards), terminated & ~begun
        truncated = ~found.success & ~begun
        self._ended = terminated | truncated
        info = {"messages": found.messages} if truncated.any() else {}
        return observations, rewards, terminated, truncated, info

    def _observed(self) -> tuple[Any, Any, Any]:
        observations, rewards, terminated = self.Outputs(self._q, self._v)
        dtype = self.single_observation_space.dtype
        return np.asarray(observations, dtype), np.asarray(rewards, float), np.asarray(terminated, bool)
