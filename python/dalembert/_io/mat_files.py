"""Variables of MAT files of MATLAB, versions 5 to 7.2 by scipy and 7.3 by h5py, which are HDF5 files."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._tools.missing_names import nearest


def read_mat(where: str, path: Path, names: tuple[str, ...]) -> list[FloatArray]:
    """Return arrays of numbers by name, or the only variable without names; 'run.force' is a field of a structure."""
    import scipy.io

    with open(path, "rb") as file:
        beginning = file.read(128)
    if b"\x89HDF" in beginning or beginning.startswith(b"MATLAB 7.3"):
        try:
            import h5py
        except ImportError:
            text = f"{where}: {path} is a MAT file of version 7.3, for which the package h5py is needed"
            raise ImportError(f"{text}; install it with \"pip install 'dalembert[hdf5]'\"") from None
        with h5py.File(path, "r") as file:
            return _arrays(where, path, file, names)
    try:
        content = scipy.io.loadmat(path, simplify_cells=True)
    except Exception as error:  # of many kinds for damaged files
        raise ValueError(f"{where}: {path} is no MAT file that can be read: {error}") from error
    return _arrays(where, path, content, names)


def _arrays(where: str, path: Path, content: Mapping[str, Any], names: tuple[str, ...]) -> list[FloatArray]:
    known = _names(content)
    if not names and len(known) != 1:
        raise ValueError(
            f"{where}: {path} has the variables {', '.join(known) or '(none)'}; choose by name, such as "
            f"('{path.name}', '{known[0] if known else 'x'}') for a matrix [t, value], or ('{path.name}', 't', 'value')"
        )
    return [_array(where, path, content, name) for name in names or tuple(known)]


def _array(where: str, path: Path, content: Mapping[str, Any], name: str) -> FloatArray:
    value: Any = content
    for k, part in enumerate(parts := name.split(".")):
        known = _names(value) if isinstance(value, Mapping) else []
        if part not in known:
            owner = f"'{'.'.join(parts[:k])}' of {path}" if k else str(path)
            hint = nearest(part, known) or (f"; it has {', '.join(known)}" if known else "")
            raise ValueError(f"{where}: {owner} has no variable '{part}'{hint}")
        value = value[part]
    if isinstance(value, Mapping):
        raise ValueError(f"{where}: '{name}' of {path} is a structure with {', '.join(f'{name}.{x}' for x in value)}")
    transposed = hasattr(value, "attrs")  # HDF5: MATLAB stores columns one after the other
    kind = value.attrs.get("MATLAB_class", b"double") if transposed else b"double"
    array = np.asarray(value)
    if array.dtype.kind not in "fiub" or kind in (b"char", b"cell"):
        raise ValueError(f"{where}: '{name}' of {path} is no array of real numbers")
    return np.asarray(array.T if transposed else array, dtype=float)


def _names(content: Mapping[str, Any]) -> list[str]:
    return [each for each in content if not each.startswith(("__", "#"))]
