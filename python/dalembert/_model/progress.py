"""A progress bar in terminals and notebooks while a solver runs; tqdm draws it."""

from __future__ import annotations

import sys
import threading
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

_PERIOD, _DELAY = 0.1, 1.0  # s: between updates, and before the bar appears
_FORMAT = "{l_bar}{bar}| {n:.3g}/{total:.3g} s [{elapsed}<{remaining}]"


def _in_notebook() -> bool:
    shell = sys.modules.get("IPython")
    return shell is not None and type(shell.get_ipython()).__name__ == "ZMQInteractiveShell"


def is_shown(wanted: bool | None) -> bool:
    """Return whether to show a bar; None: where there is someone to see it."""
    if wanted is not None:
        return wanted
    return _in_notebook() or bool(getattr(sys.stderr, "isatty", lambda: False)())


@contextmanager
def progress(system: Any, slot: str, start: float, end: float, wanted: bool | None) -> Iterator[None]:
    """Show the time (s) of the solver system.sys[slot], which a thread reads while the solver runs."""
    if not is_shown(wanted):
        yield
        return
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of notebooks without widgets, where a bar of text is shown
        from tqdm.auto import tqdm

    ended = threading.Event()
    earlier = system.sys.get(slot)

    def follow() -> None:
        with tqdm(total=end - start, delay=_DELAY, leave=False, bar_format=_FORMAT, unit="s") as bar:
            while not ended.wait(_PERIOD):
                solver = system.sys.get(slot)
                if solver is not None and solver is not earlier:
                    bar.update(max(0.0, min(solver.it.currentTime, end) - start - bar.n))

    thread = threading.Thread(target=follow, daemon=True)
    thread.start()
    try:
        yield
    finally:
        ended.set()
        thread.join()
