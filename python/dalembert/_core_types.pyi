# Types that the stubs of the compiled module share. There is no such module at run time.

from collections.abc import Sequence
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dalembert._core import MatrixContainer

class SparseMatrix(Protocol):
    """A sparse matrix of scipy."""

    def tocoo(self) -> Any: ...

Array = NDArray[np.float64]
Indices = NDArray[np.int32]
Vector = Sequence[float] | NDArray[Any]
Matrix = Sequence[Vector] | NDArray[Any]

# A matrix given densely, as triplets in a container, or as a sparse matrix.
MatrixLike = ArrayLike | MatrixContainer | SparseMatrix
