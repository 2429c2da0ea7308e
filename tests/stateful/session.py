"""Operations of users on systems, in any order: rules, each of which makes its arguments from a number.

Every call is written to `Session.steps` before it is made, so that the steps to a crash are known.
"""

from __future__ import annotations

import copy
import pickle
import re
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from random import Random
from typing import Any

import numpy as np
from solutions import SOLVERS, some_settings, some_solver_call
from values import KINDS, arguments_of, item_of_dictionary, rows_of, some_argument, some_item, value_of
from watchers import ITEM_FUNCTIONS, POST_NEWTON_FUNCTIONS, STEP_FUNCTIONS, read, write

import dalembert as exu
from codegen.model import Parameter
from dalembert.testing.motions import Place
from dalembert.testing.repeated_solves import joins, solvable
from dalembert.testing.scenes import Scene
from dalembert.testing.variants import ALL_VARIANTS, Variant

VARIANTS = [variant for variant in ALL_VARIANTS if solvable(variant)]
VARIABLES = list(exu.OutputVariableType.__members__.values())
CONFIGURATIONS = list(exu.ConfigurationType.__members__.values())
CONTAINERS = (exu.MatrixContainer, exu.Vector2DList, exu.Vector3DList, exu.Vector6DList, exu.Matrix3DList, exu.Matrix6DList,
              exu.BeamSection, exu.BeamSectionGeometry)  # fmt: skip
SPECIAL = ("__getitem__", "__setitem__", "__len__", "__array__", "__copy__", "__setstate__", "__getstate__")
MOST_ITEMS = 60
LENGTH = 40  # rules of a session

# Refusals, with a text of ours; exceptions of user functions are passed on.
REFUSALS = (MemoryError, TypeError, ValueError, IndexError, AttributeError, NotImplementedError)
FROM_FUNCTIONS = (KeyError, ZeroDivisionError, RecursionError)
# Texts of pybind11, the standard library and Eigen, which do not help a user.
INTERNAL = (
    "vector::",
    "basic_string",
    "map::at",
    "bad_",
    "Unable to cast",
    "Eigen::",
    "unknown error",
    "optional",
    "std::",
)

# Beginnings of the texts of RuntimeErrors: who refuses in this state.
NAMED = (
    "mbs.",
    "solver.",
    "node ",
    "object ",
    "marker ",
    "load ",
    "sensor ",
    "SolveVariations",
    "the system",
    "nonlinear static",
    "implicit second order",
    "diagonally implicit",
    "explicit",
)


class Finding(AssertionError):
    """A forbidden result."""


def is_own(error: BaseException) -> bool:
    text = str(error)
    if isinstance(error, RuntimeError) and not isinstance(error, (NotImplementedError, RecursionError, ValueError)):
        return text.startswith(NAMED) and not any(word in text for word in INTERNAL)
    return isinstance(error, (*REFUSALS, *FROM_FUNCTIONS)) and bool(text) and not any(w in text for w in INTERNAL)


def snapshot(mbs: Any) -> list[Any]:
    """All that a refused call must leave as it was."""
    state: list[Any] = [model_of(mbs), mbs.systemIsConsistent]
    if mbs.systemIsConsistent:
        for configuration in (
            exu.ConfigurationType.Current,
            exu.ConfigurationType.Initial,
            exu.ConfigurationType.Reference,
        ):
            state += [x.tobytes() for x in mbs.systemData.GetSystemStateDict(configuration).values()]
    return state


def model_of(mbs: Any) -> str:
    """Items and functions; utilities keep solvers among the variables, which no copy has."""
    items = {key: value for key, value in mbs.GetDictionary().items() if not key.lower().endswith("variables")}
    return re.sub(r"<function .*? at 0x\w+>", "<function>", repr(items))


def state_of(mbs: Any) -> list[np.ndarray]:
    return list(mbs.systemData.GetSystemStateDict().values())


def fresh(mbs: Any) -> Any:
    """The same model, through a pickle, in the same state."""
    made = pickle.loads(pickle.dumps(mbs))
    made.Assemble()
    for configuration in (exu.ConfigurationType.Initial, exu.ConfigurationType.Current):
        made.systemData.SetSystemState(mbs.systemData.GetSystemState(configuration), configuration)
        made.systemData.SetODE2Coordinates_tt(mbs.systemData.GetODE2Coordinates_tt(configuration), configuration)
        made.systemData.SetODE1Coordinates_t(mbs.systemData.GetODE1Coordinates_t(configuration), configuration)
    return made


RULES: list[str] = []


def rule(function: Callable[..., None]) -> Callable[..., None]:
    RULES.append(function.__name__)
    return function


class Session:
    """A system in work, other ones, and references that are kept while it changes."""

    write_step: Callable[[str], None] = staticmethod(lambda step: None)  # called before each call

    def __init__(self) -> None:
        self.mbs = exu.SystemContainer().AddSystem()
        self.others: list[Any] = []
        self.kept: list[Any] = []
        self.solvers: list[Any] = []

    # ---- calls -------------------------------------------------------------------------------------------------------
    def call(self, text: str, function: Callable[..., Any], *arguments: Any, keeps: bool = True) -> tuple[Any, Any]:
        """Result and exception of a call. `keeps`: if it is refused, the system is as it was."""
        if text:
            type(self).write_step(f"{text}{', '.join(map(repr, arguments))})" if text.endswith("(") else text)
        before = snapshot(self.mbs) if keeps else None
        try:
            return function(*arguments), None
        except Exception as error:
            if not is_own(error):
                raise Finding(f"{text}: {type(error).__name__}: {error}") from error
            if keeps and snapshot(self.mbs) != before:
                raise Finding(f"{text} was refused and has changed the system: {error}") from error
            return None, error

    def call_method(self, name: str, *arguments: Any) -> tuple[Any, Any]:
        return self.call(f"mbs.{name}(", getattr(self.mbs, name), *arguments)

    def counts(self) -> dict[str, int]:
        data = self.mbs.systemData
        return {kind: getattr(data, f"NumberOf{kind.title()}s")() for kind in KINDS}

    def some_existing(self, random: Random) -> tuple[str, int] | None:
        counts = self.counts()
        kinds = [kind for kind in KINDS if counts[kind]]
        if not kinds:
            return None
        kind = random.choice(kinds)
        return kind, random.randrange(counts[kind])

    def rows_at(self, kind: str, number: int) -> list[Parameter]:
        """Parameters of an item of the system."""
        return rows_of(item_of_dictionary(kind, getattr(self.mbs, f"Get{kind.title()}")(number)))

    # ---- building ----------------------------------------------------------------------------------------------------
    def start(self, n: int, seed: int) -> None:
        self.build(VARIANTS[n], seed)

    @rule
    def add_model(self, n: int, seed: int) -> None:
        """Additional items."""
        if sum(self.counts().values()) < MOST_ITEMS:
            self.build(VARIANTS[n], seed)

    def build(self, variant: Variant, seed: int) -> None:
        scene = Scene(seed, Place(), variant.planar, joins(variant))
        scene.mbs = self.mbs
        self.call(f"# {variant.id}, seed {seed}", scene.build, variant, joins(variant), keeps=False)

    @rule
    def add_item(self, draw: int) -> None:
        random = Random(draw)
        if sum(self.counts().values()) >= MOST_ITEMS:
            return
        kind = random.choice(KINDS)
        item = some_item(random, kind)
        arguments = arguments_of(random, item, self.counts())
        text = f"mbs.Add{kind.title()}({item.name}({', '.join(f'{k}={v!r}' for k, v in arguments.items())}))"
        made, _ = self.call(text, lambda: getattr(self.mbs, f"Add{kind.title()}")(getattr(exu, item.name)(**arguments)))
        if made is not None:
            self.kept.append(made)

    @rule
    def set_parameter(self, draw: int) -> None:
        random = Random(draw)
        existing = self.some_existing(random)
        if existing is None:
            return
        kind, number = existing
        row = random.choice(self.rows_at(kind, number))
        value = value_of(random, row, self.counts(), 0.6)
        self.call_method(f"Set{kind.title()}Parameter", number, row.name, value)

    @rule
    def modify(self, draw: int) -> None:
        random = Random(draw)
        existing = self.some_existing(random)
        if existing is None:
            return
        kind, number = existing
        rows = self.rows_at(kind, number)
        chosen = {row.name: value_of(random, row, self.counts()) for row in random.sample(rows, min(2, len(rows)))}
        self.call_method(f"Modify{kind.title()}", number, chosen)

    @rule
    def delete(self, draw: int) -> None:
        random = Random(draw)
        existing = self.some_existing(random)
        if existing is None:
            return
        kind, number = existing
        options = (random.random() < 0.5, True) if kind in ("object", "load") else (True,)
        self.call_method(f"Delete{kind.title()}", number, *options)

    @rule
    def assemble(self, draw: int) -> None:
        """Items that are refused go, so that something is left to solve."""
        for _ in range(MOST_ITEMS if draw % 4 else 1):
            _, error = self.call("mbs.Assemble()", self.mbs.Assemble)
            words = str(error).split()
            if error is None or words[0] not in KINDS:
                return
            self.call_method(f"Delete{words[0].title()}", int(words[1].rstrip(",")))

    @rule
    def assemble_in_parts(self, draw: int) -> None:
        name = Random(draw).choice(
            [
                "AssembleCoordinates",
                "AssembleLTGLists",
                "AssembleInitializeSystemCoordinates",
                "AssembleSystemInitialize",
            ]
        )
        self.call(f"mbs.{name}()", getattr(self.mbs, name))

    @rule
    def set_functions(self, draw: int) -> None:
        random = Random(draw)
        for name in ("PreStep", "PostStep", "PostNewton"):
            function = random.choice(POST_NEWTON_FUNCTIONS if name == "PostNewton" else STEP_FUNCTIONS)
            function = function if random.random() < 0.5 else 0
            self.call_method(f"Set{name}UserFunction", function)

    @rule
    def set_item_function(self, draw: int) -> None:
        random = Random(draw)
        existing = self.some_existing(random)
        if existing is None:
            return
        kind, number = existing
        names = [row.name for row in self.rows_at(kind, number) if row.type.storage == "user_function"]
        if names:
            self.call_method(
                f"Set{kind.title()}Parameter", number, random.choice(names), random.choice((0, *ITEM_FUNCTIONS))
            )

    # ---- other systems -----------------------------------------------------------------------------------------------
    @rule
    def copy(self, draw: int) -> None:
        """Go on with the copy, or with the original; the other one is kept."""
        random = Random(draw)
        ways: dict[str, Callable[[], Any]] = {
            "copy.copy(mbs)": lambda: copy.copy(self.mbs),
            "copy.deepcopy(mbs)": lambda: copy.deepcopy(self.mbs),
            "pickle.loads(pickle.dumps(mbs))": lambda: pickle.loads(pickle.dumps(self.mbs)),
            "SetDictionary(mbs.GetDictionary())": self.through_dictionary,
        }
        text = random.choice(list(ways))
        made, _ = self.call(f"other = {text}", ways[text])
        if made is None:
            return
        if model_of(made) != model_of(self.mbs):
            raise Finding(f"{text} differs from the original")
        self.others = [made, *self.others[:2]]
        if random.random() < 0.5:
            type(self).write_step("mbs, other = other, mbs")
            self.mbs, self.others[0] = self.others[0], self.mbs

    def through_dictionary(self) -> Any:
        other = self.others[-1] if self.others else exu.SystemContainer().AddSystem()
        other.SetDictionary(self.mbs.GetDictionary())
        return other

    @rule
    def reset(self, draw: int) -> None:
        if draw % 4 == 0:
            self.call("mbs.Reset()", self.mbs.Reset)

    # ---- solving -----------------------------------------------------------------------------------------------------
    @rule
    def solve(self, draw: int) -> None:
        """The system behaves as a fresh copy of the model."""
        random = Random(draw)
        if not self.mbs.systemIsConsistent or self.mbs.systemData.SystemSize() == 0:
            return
        text, settings, solver = some_settings(random)
        name = f"mbs.Solve...({text}, {solver})"
        other, refusal = self.call("other = the same through a pickle", fresh, self.mbs)
        _, error = self.call(name, SOLVERS[solver], self.mbs, settings, keeps=False)
        if refusal is not None:
            if repr(error) != repr(refusal):
                raise Finding(f"{name}: {error!r}, and a fresh copy is refused by {refusal!r}") from refusal
            return
        _, error_of_other = self.call(
            f"{name} of the other", SOLVERS[solver], other, copy.deepcopy(settings), keeps=False
        )
        if repr(error) != repr(error_of_other):
            raise Finding(f"{name}: {error!r}, and of a fresh copy {error_of_other!r}")
        for mine, its in zip(state_of(self.mbs), state_of(other), strict=True):
            if not np.array_equal(mine, its, equal_nan=True):
                raise Finding(f"{name}: {mine}, and of a fresh copy {its}")
            if error is None and not np.isfinite(mine).all():
                raise Finding(f"{name}: success with {mine}")

    @rule
    def solve_side_by_side(self, draw: int) -> None:
        """Two copies on two threads, as one alone."""
        text, settings, solver = some_settings(Random(draw))
        if not self.mbs.systemIsConsistent or self.mbs.systemData.SystemSize() == 0 or draw % 2:
            return
        copies = [made for made, _ in (self.call("", fresh, self.mbs) for _ in range(3)) if made is not None]
        if not copies:
            return

        def solve(number: int) -> str:
            return repr(self.call("", SOLVERS[solver], copies[number], copy.deepcopy(settings), keeps=False)[1])

        type(self).write_step(f"mbs.Solve...({text}, {solver}) of two copies on two threads, and of one alone")
        with ThreadPoolExecutor(2) as pool:
            errors = [*pool.map(solve, range(2)), solve(2)]
        for other in copies[:2]:
            for mine, its in zip(state_of(copies[2]), state_of(other), strict=True):
                if not np.array_equal(mine, its, equal_nan=True) or len(set(errors)) > 1:
                    raise Finding(f"{solver} side by side: {mine}, {its}, {errors}")

    @rule
    def use_while_solving(self, draw: int) -> None:
        """Another thread reads and changes the system in use: refused or right."""
        if not self.mbs.systemIsConsistent or self.mbs.systemData.SystemSize() == 0:
            return
        random = Random(draw)
        text, settings, solver = some_settings(random)
        settings.timeIntegration.numberOfSteps = 200
        choices: list[Callable[[], Any]] = [
            self.mbs.Assemble,
            self.mbs.Reset,
            lambda: self.mbs.DeleteObject(0),
            lambda: self.mbs.AddNode(exu.NodePoint()),
            lambda: SOLVERS[solver](self.mbs, settings),
            lambda: self.mbs.systemData.GetODE2Coordinates(exu.ConfigurationType.Visualization),
            lambda: self.mbs.systemData.SetODE2Coordinates(self.mbs.systemData.GetODE2Coordinates()),
            lambda: read(self.mbs),
            lambda: write(self.mbs),
            lambda: repr(self.mbs.GetDictionary()),
            lambda: copy.copy(self.mbs),
        ]
        chosen = random.choices(choices, k=4)
        type(self).write_step(
            f"mbs.Solve...({text}, {solver}), and from another thread {[choices.index(c) for c in chosen]}"
        )
        with ThreadPoolExecutor(1) as pool:
            solution = pool.submit(SOLVERS[solver], self.mbs, settings)
            for function in chosen:
                self.call("", function, keeps=False)
            self.call("", solution.result, keeps=False)

    @rule
    def solver_part(self, draw: int) -> None:
        random = Random(draw)
        text, function = some_solver_call(random, self.solvers, self.mbs)
        self.call(text, function, keeps=False)

    @rule
    def solve_variations(self, draw: int) -> None:
        random = Random(draw)
        text, settings, solver = some_settings(random)
        if solver not in exu.DynamicSolverType.__members__.values():
            solver = "static"
        existing = self.some_existing(random)
        if existing is None or not self.mbs.systemIsConsistent:
            return
        kind, number = existing
        entry = getattr(self.mbs, f"Get{kind.title()}")(number)
        reals = [key for key, value in entry.items() if isinstance(value, float)] or ["none"]
        key = random.choice(reals)
        value = entry.get(key, 0.0)
        values = [[value, 1.5 * value], [value] * 9, [value, -1.0], [float("nan")], []][random.randrange(5)]
        index = getattr(exu, f"{kind.title()}Index")(number)
        self.call(
            f"mbs.SolveVariations({{({index!r}, {key!r}): {values}}}, {text}, {solver})",
            lambda: self.mbs.SolveVariations(
                {(index, key): values}, settings, solver, storeHistories=draw % 2 == 0, storeCoordinates=True,
                numberOfThreads=1 + draw % 3,
            ),
        )  # fmt: skip

    # ---- reading and kept references ---------------------------------------------------------------------------------
    @rule
    def read_outputs(self, draw: int) -> None:
        random = Random(draw)
        existing = self.some_existing(random)
        if existing is None:
            return
        kind, number = existing
        variable, configuration = random.choice(VARIABLES), random.choice(CONFIGURATIONS)
        reading = {
            "node": ("GetNodeOutput", (variable, configuration)),
            "object": random.choice(
                (
                    ("GetObjectOutput", (variable, configuration)),
                    ("GetObjectOutputBody", (variable, [random.choice((0.0, 0.7, -9.0)), 0.0, 0.1], configuration)),
                    ("GetObjectOutputSuperElement", (variable, random.choice((0, 3, 4, -1)), configuration)),
                )
            ),
            "marker": ("GetMarkerOutput", (variable, configuration)),
            "load": ("GetLoadValues", ()),
            "sensor": random.choice((("GetSensorValues", (configuration,)), ("GetSensorStoredData", ()))),
        }
        method, rest = reading[kind]
        values, _ = self.call_method(method, number, *rest)
        if isinstance(values, np.ndarray):
            self.kept.append(values)

    @rule
    def read_all(self, draw: int) -> None:
        choices: list[tuple[str, Callable[[], Any]]] = [
            ("read(mbs)", lambda: read(self.mbs) if self.mbs.systemIsConsistent else None),
            ("mbs._repr_html_()", self.mbs._repr_html_),
            ("mbs.ComputeLinearizedSystem()", self.mbs.ComputeLinearizedSystem),
            ("mbs.ComputeODE2Eigenvalues()", self.mbs.ComputeODE2Eigenvalues),
            ("mbs.ComputeSystemDegreeOfFreedom()", self.mbs.ComputeSystemDegreeOfFreedom),
        ]
        text, function = Random(draw).choice(choices)
        self.call(text, function, keeps=False)  # these assemble

    @rule
    def system_data(self, draw: int) -> None:
        """Also through an old systemData, and into views that are kept."""
        random = Random(draw)
        data = random.choice([self.mbs.systemData, *(x for x in self.kept if isinstance(x, type(self.mbs.systemData)))])
        configuration = random.choice(CONFIGURATIONS)
        vector = random.choice(["ODE2Coordinates", "ODE2Coordinates_t", "ODE2Coordinates_tt", "ODE1Coordinates",
                                "AECoordinates", "DataCoordinates"])  # fmt: skip
        values, _ = self.call(f"data.Get{vector}({configuration}, copy={draw % 2 == 0})",
                              lambda: getattr(data, f"Get{vector}")(configuration, copy=draw % 2 == 0))  # fmt: skip
        if values is not None:
            if random.random() < 0.5:
                self.kept.append(values)
            if random.random() < 0.3:
                values = random.choice([values[1:], np.append(values, 1.0), values + float("nan"), "words", None])
            self.call(f"data.Set{vector}(", getattr(data, f"Set{vector}"), values, configuration)
        if random.random() < 0.3:
            self.kept.append(data)
        method = random.choice(["GetObjectLTGODE2", "GetNodeLTGData", "GetObjectLTGAE", "GetNodeLTGODE1"])
        self.call(f"data.{method}(", getattr(data, method), random.choice((0, 1, 5, -1, 2**40, exu.NodeIndex(0))))

    @rule
    def containers(self, draw: int) -> None:
        """Matrices, lists and sections, with arguments of all kinds."""
        random = Random(draw)
        made = [thing for thing in self.kept if isinstance(thing, CONTAINERS)]
        thing = random.choice(made) if made and draw % 3 else random.choice(CONTAINERS)()
        name = random.choice([name for name in dir(thing) if name[0].isupper() or name in SPECIAL])
        arguments = [some_argument(random) for _ in range(random.randrange(4))]
        self.call(f"{type(thing).__name__}.{name}(", getattr(thing, name), *arguments)
        self.call("repr", lambda: repr(thing), keeps=False)
        self.kept.append(thing)

    @rule
    def use_kept(self, draw: int) -> None:
        if not self.kept:
            return
        random = Random(draw)
        thing = self.kept.pop(random.randrange(len(self.kept)))
        type(self).write_step(f"use {type(thing).__name__}")
        if isinstance(thing, np.ndarray):
            if thing.flags.writeable and thing.size:
                thing[...] = np.nan_to_num(thing) + 0.0
            thing.sum()
        elif hasattr(thing, "__index__"):
            kind = type(thing).__name__.removesuffix("Index")
            self.call(f"mbs.Get{kind}({thing!r})", getattr(self.mbs, f"Get{kind}"), thing)
        self.kept = self.kept[-8:]


# ---- sessions ------------------------------------------------------------------------------------------------------------
Steps = list[tuple[str, dict[str, int]]]


def some_steps(random: Random) -> Steps:
    def draws(name: str) -> dict[str, int]:
        if name in ("start", "add_model"):
            return {"n": random.randrange(len(VARIANTS)), "seed": random.randrange(10)}
        return {"draw": random.randrange(2**32)}

    return [(name, draws(name)) for name in ["start", *(random.choice(RULES) for _ in range(LENGTH))]]


def run(steps: Steps) -> None:
    session = Session()
    for name, draws in steps:
        getattr(session, name)(**draws)
        repr(session.mbs)
