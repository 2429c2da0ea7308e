"""Completion by the tab key in IPython and Jupyter.

Attributes of settings, and parts of systems, are found by code of the class, which IPython does not run while it
completes unless the class is known to do nothing else. Reading them has no other effect.
"""

from __future__ import annotations

import sys

from dalembert import _core


def tell_ipython() -> None:
    """Name the classes of settings, and of systems and their parts, to IPython, if it is there."""
    if "IPython" not in sys.modules:
        return
    try:
        from IPython.core.guarded_eval import EVALUATION_POLICIES
    except ImportError:  # an IPython that completes otherwise
        return
    allowed = getattr(EVALUATION_POLICIES.get("limited"), "allowed_getattr", None)
    if isinstance(allowed, set):
        allowed.update(cls for cls in vars(_core).values() if hasattr(cls, "GetDictionaryWithTypeInfo"))
        allowed.update((_core.SystemContainer, _core.MainSystem, _core.SystemData, _core.Renderer))
