"""Measured signals in CSV and MAT files as tables of Create functions, by the names of columns and variables."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.io

import dalembert as db
from dalembert.create._signals import table_of

TIME, FORCE = np.array([0.0, 0.1, 0.3, 0.4]), np.array([0.0, 50.0, 50.0, 0.0])  # s, N: an impulse of 15 Ns
TABLE = np.column_stack([TIME, FORCE])
CONTENT = {
    "time": TIME[:, None],
    "force": FORCE[:, None],
    "row": FORCE[None, :],
    "short": FORCE[:2],
    "pulse": TABLE,
    "log": {"t": TIME, "drive": {"force": FORCE}},
    "count": np.arange(4, dtype=np.int16),
    "label": "measured",
    "phasor": FORCE * 1j,
}


def write_v73(path: Path, content: dict[str, Any]) -> None:
    """Write a file as MATLAB does with -v7.3: HDF5 after a header of 512 bytes, matrices transposed."""
    h5py = pytest.importorskip("h5py")

    def fill(group: Any, values: dict[str, Any]) -> None:
        for name, value in values.items():
            if isinstance(value, dict):
                fill(group.create_group(name), value)
            elif isinstance(value, str):
                stored = group.create_dataset(name, data=np.array([[ord(each)] for each in value], dtype=np.uint16))
                stored.attrs["MATLAB_class"] = np.bytes_("char")
            else:
                stored = group.create_dataset(name, data=np.atleast_2d(value).T)
                stored.attrs["MATLAB_class"] = np.bytes_("int16" if value.dtype == np.int16 else "double")

    with h5py.File(path, "w", userblock_size=512) as file:
        fill(file, content)
        file.create_group("#refs#")
    with open(path, "r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64, HDF5 schema 1.00 .".ljust(124) + b"\x00\x02IM")


def mat_file(path: Path, version: str, content: dict[str, Any]) -> Path:
    if version == "7.3":
        write_v73(path, content)
    else:
        scipy.io.savemat(path, content, do_compression=version == "7")
    return path


@pytest.fixture(params=["5", "7", "7.3"])
def measured(request: Any, tmp_path: Path) -> Path:
    return mat_file(tmp_path / "measured.mat", request.param, CONTENT)


@pytest.mark.parametrize(
    "names", [("time", "force"), ("time", "row"), ("pulse",), ("log.t", "log.drive.force"), ("time", "log.drive.force")]
)
def test_variables_of_mat_files(measured: Path, names: tuple[str, ...]) -> None:
    assert np.array_equal(table_of("CreateForceFromTable", "table", (measured, *names)), TABLE)
    assert np.array_equal(table_of("CreateForceFromTable", "table", (os.fspath(measured), *names)), TABLE)


@pytest.mark.parametrize("version", ["5", "7.3"])
def test_the_only_variable_needs_no_name(tmp_path: Path, version: str) -> None:
    file = mat_file(tmp_path / "MEASURED.MAT", version, {"pulse": TABLE})
    assert np.array_equal(table_of("CreateForceFromTable", "table", file), TABLE)
    whole = mat_file(tmp_path / "counts.mat", version, {"t": np.arange(3, dtype=np.int16), "x": np.ones(3)})
    assert np.array_equal(table_of("CreateForceFromTable", "table", (whole, "t", "x")), [[0, 1], [1, 1], [2, 1]])


def test_an_impulse_of_a_mat_file(measured: Path) -> None:
    """The momentum is the integral of the force, exactly, because its corners are ends of steps."""
    model = db.Model()
    ball = model.create_sphere("ball", radius=0.1, mass=5)
    model.create_force_from_table(body_number=ball, table=(measured, "time", "force"), direction="y")
    model.solve(0.5, 1e-3, method="trapezoidal_index2")
    assert np.allclose(ball.velocity, [0, 3, 0], rtol=0, atol=1e-9)


@pytest.mark.parametrize(
    ("names", "text"),
    [
        ((), "has the variables .*pulse.*; choose by name, such as .'measured.mat', '\\w*'. for a matrix"),
        (("time", "forces"), "measured.mat has no variable 'forces'. Did you mean 'force'"),
        (("time", "log.drive.forc"), "'log.drive' of .*measured.mat has no variable 'forc'. Did you mean 'force'"),
        (("time", "force.x"), "'force' of .*measured.mat has no variable 'x'"),
        (("log",), "'log' of .*measured.mat is a structure with log.(t, log.drive|drive, log.t)"),
        (("time", "label"), "'label' of .*measured.mat is no array of real numbers"),
        (("time", "phasor"), "'phasor' of .*measured.mat is no array of real numbers"),
        (("time", "short"), "expected two vectors of one length in .*, received the shapes "),
        (("time", "pulse"), "expected two vectors of one length in .*, received the shapes "),
        (("force",), "a table with two columns"),
        (("force", "time"), "a table with increasing times"),
        (("time", "force", "row"), r"expected \(file, 'time', 'force'\) or \(file, 'matrix'\)"),
        (("time", 1), r"expected \(file, 'time', 'force'\) or \(file, 'matrix'\)"),
    ],
)
def test_wrong_variables_are_refused(measured: Path, names: tuple[Any, ...], text: str) -> None:
    place = re.escape("MainSystem.CreateForceFromTable(...): argument 'table'")
    with pytest.raises(ValueError, match=f"{place}.*{text}"):
        table_of("CreateForceFromTable", "table", (measured, *names))


def test_files_that_cannot_be_read_are_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="a file that can be read, received '.*none.mat: No such file"):
        table_of("CreateForceFromTable", "table", (tmp_path / "none.mat", "a", "b"))
    damaged = tmp_path / "damaged.mat"
    damaged.write_text("time, force\n0, 1\n1, 2\n")
    with pytest.raises(ValueError, match="damaged.mat is no MAT file that can be read"):
        table_of("CreateForceFromTable", "table", (damaged, "a", "b"))
    cut = mat_file(tmp_path / "cut.mat", "7.3", CONTENT)
    cut.write_bytes(cut.read_bytes()[:900])
    with pytest.raises(ValueError, match=r"a file that can be read, received '.*cut.mat: "):
        table_of("CreateForceFromTable", "table", (cut, "time", "force"))


def test_a_missing_package_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = mat_file(tmp_path / "new.mat", "7.3", CONTENT)
    monkeypatch.setitem(__import__("sys").modules, "h5py", None)
    with pytest.raises(ImportError, match="version 7.3, for which the package h5py is needed.*dalembert\\[hdf5\\]"):
        table_of("CreateForceFromTable", "table", (file, "time", "force"))


# ---- columns of CSV files


@pytest.mark.parametrize("header", ["t,F [N],x", 't; "F [N]"; x', "t\tF [N]\tx"])
def test_columns_of_csv_files(tmp_path: Path, header: str) -> None:
    file = tmp_path / "measured.csv"
    rows = "\n".join(f"{t};{force};{9}" for t, force in TABLE)
    file.write_text(f"Logger 7\n# of Monday\n{header}\n{rows}\n")
    assert np.array_equal(table_of("CreateMotor", "speed", (file, "t", "F [N]")), TABLE)
    for names, text in (
        (("t", "F"), r"names of two columns of .*measured.csv \(t, F \[N\], x\)"),
        (("t",), "names of two columns of"),
    ):
        with pytest.raises(ValueError, match=f"argument 'speed': expected {text}"):
            table_of("CreateMotor", "speed", (file, *names))
    file.write_text("t,F\n0,1,2\n1,2,3\n")
    with pytest.raises(ValueError, match="expected 2 columns as in the header of .*, received 3"):
        table_of("CreateMotor", "speed", (file, "t", "F"))
