"""Requests of viewers for the solver's thread: user functions, which may change the system."""

from __future__ import annotations

from typing import Any


def run(mbs: Any) -> None:
    """Run the requests of the viewer of a system; called by its solver between two steps."""
    from dalembert._live.viewer import viewer_of

    viewer = viewer_of(mbs.GetSystemContainer())
    if viewer is not None:
        viewer.run_calls()
