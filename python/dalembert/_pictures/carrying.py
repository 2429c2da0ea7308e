"""Attachment of parts that move rigidly with another part: a file stores their constant relative pose, and no numbers
per frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dalembert._checks import FloatArray

NEAREST = 32  # number of nearby parts that are tested as carriers
EQUAL = 1e-6  # relative tolerance of lengths for rigid motion


@dataclass(frozen=True)
class Carried:
    """A part relative to its carrier; `form` is the type of its numbers.

    "rows": the part rotates with the carrier. "place": its matrix is constant, its position is carried. "points":
    points.
    """

    by: int  # number of the array of the other motion
    form: str
    numbers: FloatArray


class Carriers:
    """Motions that are kept (frames x rows of matrix and place), for those that come after them."""

    def __init__(self) -> None:
        self._arrays: list[int] = []
        self._rows: list[FloatArray] = []  # frames x 3 x 4
        self._starts = np.empty((64, 3))  # start positions
        self._reach = 0.0  # how far from the origin they come

    def add(self, rows: FloatArray, array: int) -> None:
        """Register this motion as a carrier, if it determines the positions of points."""
        rows = rows.reshape(-1, 3, 4)
        lengths = np.linalg.norm(rows[0, :, :3], axis=0)
        if not lengths.all() or abs(np.linalg.det(rows[0, :, :3] / lengths)) < 0.1:
            return
        if len(self._rows) == len(self._starts):
            self._starts = np.concatenate([self._starts, np.empty_like(self._starts)])
        self._starts[len(self._rows)] = rows[0, :, 3]
        self._reach = max(self._reach, float(np.linalg.norm(rows[:, :, 3], axis=1).max()))
        self._rows.append(rows)
        self._arrays.append(array)

    def part(self, rows: FloatArray, is_round: bool = False) -> Carried | None:
        """Return the attachment of a rigid part (frames x rows of matrix and position); None if it has no carrier.

        The rotation of a round part about its z axis is ignored.
        """
        rows = rows.reshape(-1, 3, 4)
        widths = np.linalg.norm(rows[:, :, :2], axis=1)
        seen = slice(2 if is_round and np.ptp(widths) <= EQUAL * widths.max() else 0, None)
        if (found := self._found(rows, np.array([0, 0, 0, 1.0]), seen)) is not None:
            return Carried(found[0], "rows", found[1].ravel())
        if np.ptp(rows[:, :, :3], axis=0).max() > EQUAL * np.abs(rows[0, :, :3]).max():
            return None
        if (found := self._found(rows[:, :, 3:], np.array([1.0]))) is None:
            return None
        return Carried(found[0], "place", np.column_stack([rows[0, :, :3], found[1]]).ravel())

    def points(self, points: FloatArray) -> Carried | None:
        """Return how points (frames x numbers) are carried; None: they do not keep their places in anything."""
        columns = points.reshape(len(points), -1, 3).transpose(0, 2, 1)
        found = self._found(columns, np.ones(columns.shape[2]))
        return None if found is None else Carried(found[0], "points", found[1].T.ravel())

    def ball(self, frames: FloatArray) -> Carried | None:
        """Return how the center of a ball is carried, of which there are center and radius; the radius is kept."""
        if np.ptp(frames[:, 3]) > 0 or (found := self.points(frames[:, :3])) is None:
            return None
        return Carried(found.by, "ball", np.append(found.numbers, frames[0, 3]))

    def _found(
        self, columns: FloatArray, weights: FloatArray, seen: slice = slice(None)
    ) -> tuple[int, FloatArray] | None:
        """Return the carrier of the visible columns (frames x 3 x n), and their values in its frame.

        Weights: 1 for points, 0 for vectors.
        """
        distances = np.linalg.norm(self._starts[: len(self._rows)] - columns[0, :, -1], axis=1)
        lengths = np.linalg.norm(columns, axis=1).max(axis=0)
        size = max(float((lengths * weights).max()), self._reach)
        limit = EQUAL * np.where(weights > 0, size, lengths)
        some = np.linspace(0, len(columns) - 1, 5).astype(int)
        for base in np.argsort(distances)[:NEAREST]:
            rows = self._rows[base]
            if len(rows) != len(columns):
                continue
            from_there = columns[0] - weights * rows[0, :, 3:]
            if np.linalg.norm(from_there * weights, axis=0).max() > size:
                continue  # a long lever: the bits that the motion lacks would be seen
            local = np.linalg.solve(rows[0, :, :3], from_there)
            if all(
                (np.abs(rows[at, :, :3] @ local + weights * rows[at, :, 3:] - columns[at]) <= limit)[:, :, seen].all()
                for at in (some, slice(None))
            ):
                return self._arrays[base], local
        return None
