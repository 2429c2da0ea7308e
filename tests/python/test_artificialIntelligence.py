"""Environments for reinforcement learning, on a cart with a pole: they follow gymnasium's rules, and agree with each
other."""

from __future__ import annotations

import subprocess
import sys
from typing import Any

import numpy as np
import pytest

pytest.importorskip("gymnasium")

from gymnasium.utils.env_checker import check_env

import dalembert as exu
from dalembert.artificialIntelligence import OpenAIGymInterfaceEnv, VariationsVectorEnv, spaces
from dalembert.rigidBodyUtilities import InertiaCuboid

FORCE, LENGTH, STEP = 10.0, 1.0, 0.02


def cart_pole(mbs: Any, settings: Any) -> Any:
    """A cart of 1 kg, and a pole that stands on it; both planar. Returns the load on the cart."""
    cart = mbs.CreateMassPoint("cart", physicsMass=1, create2D=True)
    pole = InertiaCuboid(1000, [0.01, LENGTH, 0.01])
    mbs.CreateRigidBody("pole", [0, LENGTH / 2, 0], inertia=pole, gravity=[0, -9.81, 0], create2D=True)
    mbs.CreateCoordinateConstraint(bodyNumbers=[None, cart], coordinates=[None, 1])
    ends = [
        mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=b, localPosition=p))
        for b, p in (("cart", [0, 0, 0]), ("pole", [0, -LENGTH / 2, 0]))
    ]
    mbs.AddObject(exu.ObjectJointRevolute2D(markerNumbers=ends))
    load = mbs.AddLoad(
        exu.LoadCoordinate(markerNumber=mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber="Node:cart", coordinate=0)))
    )
    mbs.Assemble()
    settings.timeIntegration.numberOfSteps = 2
    return load


def coordinates_of(state: Any) -> tuple[Any, Any]:
    """Coordinates and velocities from [x, phi, x_t, phi_t], a row per state."""
    x, phi, x_t, phi_t = np.moveaxis(np.atleast_2d(state), -1, 0)
    zero, half = np.zeros_like(x), LENGTH / 2
    q = [x, zero, x - half * np.sin(phi), half * (np.cos(phi) - 1), phi]
    v = [x_t, zero, x_t - half * np.cos(phi) * phi_t, -half * np.sin(phi) * phi_t, phi_t]
    return np.stack(q, -1), np.stack(v, -1)


def state_of(q: Any, v: Any) -> Any:
    return np.stack([q[..., 0], q[..., 4], v[..., 0], v[..., 4]], -1)


def over(state: Any) -> Any:
    return (np.abs(state[..., 0]) > 2.4) | (np.abs(state[..., 1]) > 0.2)


class CartPole(OpenAIGymInterfaceEnv):
    stepUpdateTime = STEP

    def CreateMBS(self, SC: Any, mbs: Any, simulationSettings: Any, **kwargs: Any) -> int:
        self.load = cart_pole(mbs, simulationSettings)
        return 4

    def SetupSpaces(self) -> None:
        self.action_space = spaces.Discrete(2)
        self.observation_space = spaces.Box(-np.inf, np.inf, (4,), np.float32)

    def MapAction2MBS(self, action: Any) -> None:
        self.mbs.SetLoadParameter(self.load, "load", FORCE if action == 1 else -FORCE)

    def Output2StateAndDone(self) -> bool:
        data = self.mbs.systemData
        self.state = state_of(data.GetODE2Coordinates(), data.GetODE2Coordinates_t())
        return bool(over(self.state))

    def State2InitialValues(self) -> Any:
        q, v = coordinates_of(self.state)
        return q[0], v[0]


class CartPoles(VariationsVectorEnv):
    stepUpdateTime = STEP

    def CreateMBS(self, SC: Any, mbs: Any, simulationSettings: Any, **kwargs: Any) -> None:
        self.load = cart_pole(mbs, simulationSettings)

    def SetupSpaces(self) -> None:
        self.single_action_space = spaces.Discrete(2)
        self.single_observation_space = spaces.Box(-np.inf, np.inf, (4,), np.float32)

    def MapActions(self, actions: Any) -> Any:
        return {(self.load, "load"): np.where(actions == 1, FORCE, -FORCE)}

    def InitialStates(self, number: int) -> Any:
        return coordinates_of(self.np_random.uniform(-0.05, 0.05, (number, 4)))

    def Outputs(self, coordinates: Any, velocities: Any) -> Any:
        state = state_of(coordinates, velocities)
        return state, np.ones(len(state)), over(state)


@pytest.mark.filterwarnings("ignore")
def test_the_rules_of_gymnasium() -> None:
    check_env(CartPole(), skip_render_check=True)


def test_a_pole_falls_the_other_way() -> None:
    """Pushed to the right, a pole on a light cart turns to the left, by F / (m_cart (4/3 - m_pole/M) l/2), mass about 1.1 kg."""
    env = CartPole()
    env.reset(seed=3)
    env.state = np.zeros(4)
    state, reward, terminated, truncated, _ = env.step(1)
    total, pole, half = 1.1, 0.1, LENGTH / 2
    alpha = FORCE / total / (half * (4 / 3 - pole / total))
    assert state[3] == pytest.approx(alpha * STEP, rel=2e-2) and state[2] > 0
    assert (reward, terminated, truncated) == (1.0, False, False)
    with pytest.raises(ValueError, match="action 7 is not in"):
        env.step(7)
    while not env.step(1)[2]:
        pass
    with pytest.warns(UserWarning, match="the episode is over"):
        assert env.step(1)[1] == 0.0


def test_episodes_are_repeatable() -> None:
    def run() -> Any:
        env = CartPole()
        env.reset(seed=11)
        return np.array([env.step(i % 2)[0] for i in range(20)])

    assert np.array_equal(run(), run())
    CartPole().TestModel(numberOfSteps=5, useRenderer=False, showTimeSpent=False)


def test_many_environments_step_like_one() -> None:
    many, one = CartPoles(5), CartPole()
    observed, _ = many.reset(seed=5)
    assert observed.shape == (5, 4) and many.observation_space.contains(observed)
    one.reset(seed=0)
    one.state = state_of(*coordinates_of(observed[2].astype(float)))[0]
    one.state = state_of(many._q[2], many._v[2])
    for action in (1, 0, 0, 1, 1):
        observed, rewards, terminated, truncated, _ = many.step(np.full(5, action))
        single = one.step(action)[0]
    assert np.allclose(observed[2], single, atol=2e-5)
    assert rewards.tolist() == [1.0] * 5 and not terminated.any() and not truncated.any()


def test_ended_environments_begin_anew() -> None:
    many = CartPoles(100)
    many.reset(seed=1)
    ended = np.zeros(100, dtype=bool)
    for _ in range(60):
        observed, rewards, terminated, _, _ = many.step(many.action_space.sample())
        assert np.abs(observed[ended, 1]).max(initial=0) <= 0.05 and (rewards[ended] == 0).all()
        ended = terminated
    with pytest.raises(RuntimeError, match="call reset"):
        CartPoles(2).step(np.zeros(2))


class Pushers(VariationsVectorEnv):
    """A mass that is pushed against dry friction, whose history is in data coordinates."""

    stepUpdateTime = STEP

    def CreateMBS(self, SC: Any, mbs: Any, simulationSettings: Any, **kwargs: Any) -> None:
        node = mbs.AddNode(exu.Node1D())
        mbs.AddObject(exu.Mass1D(nodeNumber=node, physicsMass=1))
        places = [mbs.AddNode(exu.NodePointGround()), node]
        markers = [mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=n, coordinate=0)) for n in places]
        history = mbs.AddNode(exu.NodeGenericData(initialCoordinates=[1, 0, 0], numberOfDataCoordinates=3))
        mbs.AddObject(
            exu.ObjectConnectorCoordinateSpringDamperExt(
                markerNumbers=markers, nodeNumber=history, fDynamicFriction=2, stickingStiffness=1e4
            )
        )
        self.load = mbs.AddLoad(exu.LoadCoordinate(markerNumber=markers[1]))
        mbs.Assemble()
        simulationSettings.timeIntegration.numberOfSteps = 4

    def SetupSpaces(self) -> None:
        self.single_action_space = spaces.Box(-5, 5, (), np.float32)
        self.single_observation_space = spaces.Box(-np.inf, np.inf, (2,), np.float32)

    def MapActions(self, actions: Any) -> Any:
        return {(self.load, "load"): actions}

    def InitialStates(self, number: int) -> Any:
        return np.zeros((number, 1)), np.zeros((number, 1))

    def Outputs(self, coordinates: Any, velocities: Any) -> Any:
        return np.hstack((coordinates, velocities)), np.ones(len(coordinates)), np.abs(coordinates[:, 0]) > 0.05


def test_history_goes_on_and_begins_anew() -> None:
    """The state of friction is that of one long simulation with the same steps, and is reset in a new episode."""
    many = Pushers(2)
    many.reset(seed=1)
    for _ in range(3):
        observed, *_ = many.step(np.array([1.0, 5.0]))
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 3 * STEP, 12
    many.mbs.SetLoadParameter(many.load, "load", 5.0)
    many.mbs.SolveDynamic(settings)
    data = many.mbs.systemData
    assert many._others["Data"][1] == pytest.approx(data.GetDataCoordinates(), abs=1e-6)
    assert observed[1, 0] == pytest.approx(data.GetODE2Coordinates()[0], rel=1e-3)
    assert abs(observed[0, 0]) < 1e-3  # it sticks
    while not many.step(np.array([1.0, 5.0]))[2][1]:
        pass
    many.step(np.array([1.0, 5.0]))
    assert many._others["Data"][1].tolist() == [1, 0, 0] and many._others["Data"][0].tolist() != [1, 0, 0]


def test_missing_parts_are_reported() -> None:
    with pytest.raises(NotImplementedError, match="OpenAIGymInterfaceEnv: write the method CreateMBS"):
        OpenAIGymInterfaceEnv()
    code = "import sys; sys.modules['gymnasium'] = None; import dalembert.artificialIntelligence"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert "needs the package gymnasium" in done.stderr and "pip install gymnasium" in done.stderr
