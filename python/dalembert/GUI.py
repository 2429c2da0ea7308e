"""Dialogs that show and change settings and dictionaries as a tree, with tkinter.

What is typed is checked by the settings themselves: a value that they refuse stays as it was, and the reason is shown.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from enum import Enum
from typing import Any

import numpy as np

__all__ = ["Edit", "EditDictionary", "EditDictionaryWithTypeInfo", "IsArrayInt", "IsFloat", "IsVector"]


def IsFloat(v: Any) -> bool:
    """Whether the text is a number."""
    try:
        float(v)
    except (TypeError, ValueError):
        return False
    return True


def _list(v: Any) -> list[Any] | None:
    try:
        value = ast.literal_eval(v) if isinstance(v, str) else v
    except (SyntaxError, ValueError):
        return None
    return list(value) if isinstance(value, (list, tuple, np.ndarray)) else None


def IsArrayInt(v: Any) -> bool:
    """Whether the text is a list of integers."""
    value = _list(v)
    return value is not None and all(isinstance(x, int) and not isinstance(x, bool) for x in value)


def IsVector(v: Any) -> bool:
    """Whether the text is a list of numbers."""
    value = _list(v)
    return value is not None and all(isinstance(x, (int, float)) and not isinstance(x, bool) for x in value)


class Edit:
    """Nested values behind a dialog: rows with a path, a text and help; a text that is set becomes a value."""

    def __init__(self, thing: Any) -> None:
        """Thing: settings, or a dictionary, which is changed in place."""
        self.thing = thing
        self._is_settings = hasattr(thing, "GetDictionaryWithTypeInfo")

    def rows(self) -> Iterator[tuple[tuple[str, ...], str, str]]:
        """Give path, value as text and help of every value; branches come with the text ''."""
        info = self.thing.GetDictionaryWithTypeInfo() if self._is_settings else self.thing
        yield from self._rows(info, ())

    def _rows(self, members: Mapping[str, Any], path: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], str, str]]:
        for key, value in members.items():
            below = (*path, str(key))
            leaf = isinstance(value, Mapping) and "value" in value and "type" in value if self._is_settings else False
            if leaf:
                yield below, _text(value["value"]), str(value.get("description", ""))
            elif isinstance(value, Mapping):
                yield below, "", ""
                yield from self._rows(value, below)
            else:
                yield below, _text(value), type(value).__name__

    def value(self, path: tuple[str, ...]) -> Any:
        """Return the value at a path."""
        found = self.thing
        for key in path:
            found = getattr(found, key) if self._is_settings else found[key]
        return found

    def choices(self, path: tuple[str, ...]) -> list[str]:
        """Return the texts that a value can have; [] if they cannot be listed."""
        value = self.value(path)
        if isinstance(value, Enum):
            return list(type(value).__members__)
        return ["True", "False"] if isinstance(value, bool) else []

    def set(self, path: tuple[str, ...], text: str) -> None:
        """Set a value from a text; ValueError or TypeError, of the settings or of the type, if it does not fit."""
        old = self.value(path)
        if isinstance(old, Enum):
            if text not in type(old).__members__:
                raise ValueError(f"{'.'.join(path)}: received '{text}'; known are {', '.join(type(old).__members__)}")
            value: Any = type(old)[text]
        elif isinstance(old, str):
            value = text
        else:
            try:
                value = ast.literal_eval(text)
            except (SyntaxError, ValueError):
                raise ValueError(f"{'.'.join(path)}: '{text}' is no {type(old).__name__}") from None
            if not self._is_settings and old is not None:
                value = _like(old, value, ".".join(path))
        owner = self.thing
        for key in path[:-1]:
            owner = getattr(owner, key) if self._is_settings else owner[key]
        if self._is_settings:
            setattr(owner, path[-1], value)
        else:
            owner[path[-1]] = value


def _text(value: Any) -> str:
    if isinstance(value, Enum):
        return value.name
    return str(value.tolist() if isinstance(value, np.ndarray) else value)


def _like(old: Any, value: Any, place: str) -> Any:
    """Return a value of the type that the old one has."""
    if isinstance(old, np.ndarray):
        return np.array(value, dtype=old.dtype)
    if isinstance(old, bool) != isinstance(value, bool) or not isinstance(value, (type(old), int)):
        raise TypeError(f"{place}: received {value!r}, but expected a {type(old).__name__}")
    return type(old)(value)


def _tkinter() -> Any:
    try:
        import tkinter
        import tkinter.ttk

        return tkinter, tkinter.Tk()
    except ImportError:
        raise ImportError("dialogs need tkinter, which this Python has not; set the attributes instead") from None
    except Exception as error:  # tkinter.TclError, whose name is not known without tkinter
        raise RuntimeError(f"there is no display for dialogs ({error}); set the attributes instead") from None


def _show(edit: Edit, title: str, editable: bool) -> None:
    """Open the dialog, and return when it is closed."""
    tk, root = _tkinter()
    root.title(title)
    tree = tk.ttk.Treeview(root, columns=("value", "help"), height=30)
    for column, width, text in (("#0", 300, "name"), ("value", 200, "value"), ("help", 500, "meaning")):
        tree.column(column, width=width)
        tree.heading(column, text=text, anchor="w")
    for path, text, words in edit.rows():
        tree.insert("/".join(path[:-1]), "end", "/".join(path), text=path[-1], values=(text, words))
    message = tk.StringVar(root)
    tree.pack(fill="both", expand=True)
    tk.Label(root, textvariable=message, anchor="w").pack(fill="x")

    def begin(event: Any) -> None:
        name = tree.focus()
        if not editable or not name or tree.get_children(name):
            return
        path, box = tuple(name.split("/")), tree.bbox(name, "value")
        choices = edit.choices(path)
        field = tk.ttk.Combobox(root, values=choices) if choices else tk.Entry(root)
        field.insert(0, tree.set(name, "value"))
        field.place(x=box[0], y=box[1], width=max(box[2], 200), height=box[3])
        field.focus_set()

        def finish(_: Any) -> None:
            try:
                edit.set(path, field.get())
                tree.set(name, "value", _text(edit.value(path)))
                message.set("")
            except (TypeError, ValueError) as error:
                message.set(str(error))
            field.destroy()

        field.bind("<Return>", finish)
        field.bind("<<ComboboxSelected>>", finish)
        field.bind("<Escape>", lambda _: field.destroy())

    tree.bind("<Double-1>", begin)
    tree.bind("<Return>", begin)
    root.bind("<Control-q>", lambda _: root.destroy())
    root.mainloop()


def EditDictionaryWithTypeInfo(settingsStructure: Any, exu: Any = None, dictionaryName: str = "edit") -> None:
    """Show settings, such as SimulationSettings() or SC.visualizationSettings, in a dialog, and change them there."""
    _show(Edit(settingsStructure), dictionaryName, True)


def EditDictionary(dictionaryData: dict[str, Any], dictionaryIsEditable: bool = True, dialogName: str = "") -> Any:
    """Show a dictionary, such as mbs.GetObject(0), in a dialog; return it, with what was changed there."""
    _show(Edit(dictionaryData), dialogName or "dictionary", dictionaryIsEditable)
    return dictionaryData
