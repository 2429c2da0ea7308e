"""The version of the package, and that of the interface which its models rely on."""

from __future__ import annotations

import re

__version__ = "0.1.0"
interface_version = "1.11.0"


def _numbers(version: str) -> tuple[int, ...]:
    """Return the leading numbers of a version: '1.6.31.dev1' -> (1, 6, 31); ValueError if there are none."""
    if not isinstance(version, str) or not (match := re.match(r"\d+(\.\d+)*", version)):
        raise ValueError(f"RequireVersion: expected a version such as '1.11.0', received {version!r}")
    return tuple(int(number) for number in match.group().split("."))


def RequireVersion(requiredVersionString: str) -> None:
    """Raise a RuntimeError if a model needs a newer interface than interface_version."""
    if _numbers(requiredVersionString) > _numbers(interface_version):
        raise RuntimeError(
            f"the model requires interface version {requiredVersionString}, but dalembert {__version__} "
            f"provides {interface_version}"
        )
