"""Meshes of shells; planned."""

from __future__ import annotations

from typing import Any, NoReturn

from dalembert._planned import refuse

__all__ = ["ShellMesh"]


class ShellMesh:
    """Quadrilateral mesh of thin plate elements; planned."""

    def __init__(self, *args: Any, **kwargs: Any) -> NoReturn:
        refuse("shells.ShellMesh")
