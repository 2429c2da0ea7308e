"""The error of sensitivities that cannot be computed."""

from __future__ import annotations

INSTEAD = "use processing.ComputeSensitivities, which takes differences of whole solutions"  # advice


class NotDifferentiable(ValueError):
    """A derivative that does not exist, or that is not available; item, parameter, time, reason and advice say why.

    item: the item or the setting that prevents it, '' if it is none; parameter: name of the parameter, '' if it is
    none; time: in s, or
    None.
    """

    __module__ = "dalembert"

    def __init__(
        self, reason: str, *, item: str = "", parameter: str = "", time: float | None = None, advice: str = ""
    ) -> None:
        self.item, self.parameter, self.time, self.reason, self.advice = item, parameter, time, reason, advice
        where = [item, f"parameter '{parameter}'" if parameter else "", "" if time is None else f"time {time:.6g} s"]
        text = ", ".join(part for part in where if part)
        super().__init__(f"{text}: {reason}" * bool(text) + reason * (not text) + (f"; {advice}" if advice else ""))
