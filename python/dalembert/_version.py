"""The version of the package, and that of the interface which its models rely on."""

from __future__ import annotations

import re

__version__ = "0.1.0"
interface_version = "1.13.6"  # the newest release whose models run
_FOLDER = (1, 12)  # since then, files of solvers are in a folder by default


def _numbers(version: str) -> tuple[int, ...]:
    """Return the leading numbers of a version: '1.6.31.dev1' -> (1, 6, 31); ValueError if there are none."""
    if not isinstance(version, str) or not (match := re.match(r"\d+(\.\d+)*", version)):
        raise ValueError(f"RequireVersion: expected a version such as '1.11.0', received {version!r}")
    return tuple(int(number) for number in match.group().split("."))


def use_interface(version: str) -> None:
    """Use the defaults of a release of Exudyn for settings that are made from now on.

    From 1.12 on, the default names of solution, restart and solver information file are in the folder solution/.
    """
    from dalembert import _core

    _core._set_default_folder("solution/" if _numbers(version) >= _FOLDER else "")


def RequireVersion(requiredVersionString: str) -> None:
    """Use the defaults of the release that a model needs; RuntimeError if it is newer than interface_version.

    If the release is 1.12 or newer, the default names of solution, restart and solver information file are in the
    folder solution/; releases before that have no influence.
    """
    needed = _numbers(requiredVersionString)
    if needed > _numbers(interface_version):
        raise RuntimeError(
            f"the model requires interface version {requiredVersionString}, but dalembert {__version__} "
            f"provides {interface_version}"
        )
    if needed >= _FOLDER:
        use_interface(requiredVersionString)
