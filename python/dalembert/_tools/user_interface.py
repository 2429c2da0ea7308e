"""exu.special.userInterface: switches that keep windows from opening, and variables of the environment."""

from __future__ import annotations

import os
import sys

from dalembert import _core
from dalembert._checks import shape_error

WINDOWS = ("Renderer", "SolutionViewer", "Plots", "Dialogs")
_told: set[str] = set()


class UserInterface:
    """Switches of windows; True: functions that would open one continue without it."""

    __slots__ = ("suppressDialogs", "suppressPlots", "suppressRenderer", "suppressSolutionViewer")
    suppressDialogs: bool
    suppressPlots: bool
    suppressRenderer: bool
    suppressSolutionViewer: bool

    def __init__(self) -> None:
        self.SuppressAll(False)

    def SuppressAll(self, flag: bool = True) -> None:
        """Set all switches."""
        for window in WINDOWS:
            setattr(self, f"suppress{window}", bool(flag))

    def __repr__(self) -> str:
        return "UserInterface(" + ", ".join(f"{name}={getattr(self, name)}" for name in self.__slots__) + ")"


user_interface = UserInterface()


def UIWindowSuppressed(kind: str, callerInfo: str = "") -> bool:
    """Return whether exu.special.userInterface suppresses a kind of window; the first time, a line is printed.

    kind: 'Renderer', 'SolutionViewer', 'Plots' or 'Dialogs'; callerInfo: the function that is named in this line.
    """
    if kind not in WINDOWS:
        raise shape_error("UIWindowSuppressed: kind", ", ".join(WINDOWS[:-1]) + f" or {WINDOWS[-1]}", kind)
    suppressed = bool(getattr(user_interface, f"suppress{kind}"))
    if suppressed and kind not in _told:
        _told.add(kind)
        _core.Print(f"{callerInfo or kind}: no window, as exu.special.userInterface.suppress{kind} is set")
    return suppressed


def follow_environment() -> None:
    """Take over EXUDYN_OUTPUTDIRECTORY and EXUDYN_SUPPRESS_UI_WINDOW_OPEN, if they are set."""
    directory = os.environ.get("EXUDYN_OUTPUTDIRECTORY")
    if directory:
        _core.config.outputDirectory = directory
    if os.environ.get("EXUDYN_SUPPRESS_UI_WINDOW_OPEN") == "1":
        user_interface.SuppressAll()
        if "matplotlib" not in sys.modules:
            os.environ.setdefault("MPLBACKEND", "Agg")


setattr(_core.Special, "userInterface", property(lambda special: user_interface))  # noqa: B010  a stub declares it
follow_environment()
