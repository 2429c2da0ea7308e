"""Dialogs, as far as they need no display."""

from __future__ import annotations

from unittest import mock

import numpy as np
import pytest

import dalembert as exu
from dalembert import GUI


def test_settings_are_edited_as_texts() -> None:
    settings = exu.SimulationSettings()
    edit = GUI.Edit(settings)
    rows = {path: (text, words) for path, text, words in edit.rows()}
    assert rows[("timeIntegration",)][0] == "" and rows[("timeIntegration", "endTime")][0] == "1.0"
    assert "in s" in rows[("timeIntegration", "endTime")][1] and not any("``" in words for _, words in rows.values())
    edit.set(("timeIntegration", "endTime"), "2.5")
    edit.set(("linearSolverType",), "EigenSparse")
    edit.set(("timeIntegration", "newton", "useModifiedNewton"), "True")
    assert settings.timeIntegration.endTime == 2.5 and settings.timeIntegration.newton.useModifiedNewton
    assert settings.linearSolverType == exu.LinearSolverType.EigenSparse
    assert "EigenSparse" in edit.choices(("linearSolverType",))
    for path, text in (
        (("timeIntegration", "endTime"), "soon"),
        (("timeIntegration", "numberOfSteps"), "-1"),
        (("linearSolverType",), "fast"),
    ):
        with pytest.raises(ValueError, match=path[-1]):
            edit.set(path, text)
    assert settings.timeIntegration.endTime == 2.5


def test_dictionaries_keep_their_types() -> None:
    data = {"mass": 1.0, "color": [1, 0], "place": np.zeros(2), "inner": {"show": True}}
    edit = GUI.Edit(data)
    for path, text in ((("mass",), "3"), (("place",), "[1, 2]"), (("inner", "show"), "False"), (("color",), "[0, 1]")):
        edit.set(path, text)
    assert data["mass"] == 3.0 and isinstance(data["mass"], float) and data["inner"] == {"show": False}
    assert data["place"].tolist() == [1.0, 2.0] and data["color"] == [0, 1]
    with pytest.raises(TypeError, match="inner.show: received 3, but expected a bool"):
        edit.set(("inner", "show"), "3")
    assert (
        GUI.IsVector("[1, 2.5]")
        and GUI.IsArrayInt("[1, 2]")
        and not GUI.IsArrayInt("[1, 2.5]")
        and not GUI.IsFloat("x")
    )


def test_scripts_select_size_and_state_of_dialogs(monkeypatch: pytest.MonkeyPatch) -> None:
    root, tk = mock.MagicMock(), mock.MagicMock()
    root.winfo_screenheight.return_value, root.winfo_fpixels.return_value = 1200, 1.5
    monkeypatch.setattr(GUI, "_tkinter", lambda: (tk, root))
    monkeypatch.setattr(GUI, "treeEditOpenItems", ["timeIntegration"])
    GUI.EditDictionaryWithTypeInfo(exu.SimulationSettings())
    root.geometry.assert_called_with("1024x1000")
    lines = {call.args[2]: call.kwargs["open"] for call in tk.ttk.Treeview.return_value.insert.call_args_list}
    assert [name for name, is_open in lines.items() if is_open] == ["timeIntegration"]
    monkeypatch.setattr(GUI, "treeEditDefaultWidth", 700)
    monkeypatch.setattr(GUI, "treeEditMaxInitialHeight", 600)
    monkeypatch.setattr(GUI, "treeviewDefaultFontSize", 20)
    GUI.EditDictionaryWithTypeInfo(exu.SimulationSettings())
    root.geometry.assert_called_with("700x800")
    tk.ttk.Style.return_value.configure.assert_any_call("Treeview", font=(None, 20), rowheight=44)
    monkeypatch.setattr(GUI, "dialogDefaultHeight", 300)
    GUI.EditDictionary({"mass": 1.0})
    root.geometry.assert_called_with("800x300")


def test_without_a_display_dialogs_say_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DISPLAY", raising=False)
    with pytest.raises((RuntimeError, ImportError), match="set the attributes instead"):
        GUI.EditDictionaryWithTypeInfo(exu.SimulationSettings())
