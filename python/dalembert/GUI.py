"""Dialogs that show and change settings and dictionaries as a tree, with tkinter.

The settings check the input: a rejected value does not change, and the reason is shown.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Mapping
from enum import Enum
from typing import Any

import numpy as np

__all__ = ["Edit", "EditDictionary", "EditDictionaryWithTypeInfo", "IsArrayInt", "IsFloat", "IsVector"]

# Scripts change these before a dialog is opened.
treeEditDefaultWidth, treeEditDefaultHeight = 1024, 800  # pixels of dialogs of settings
treeEditMaxInitialHeight = 1440  # on larger screens
treeEditOpenItems = ["bodies", "connectors", "nodes", "general"]  # initially open groups
dialogDefaultWidth, dialogDefaultHeight = 800, 600  # pixels of dialogs of dictionaries
treeviewDefaultFontSize = 9  # points
textHeightFactor = 1.45  # distance of lines by size of the font
useRenderWindowDisplayScaling = True  # no effect: dialogs are scaled as the screen is that they open on

_FREE_SHARE = 1.2  # height of a screen by that of the tallest dialog


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
                yield below, _text(value["value"]), str(value.get("description", "")).replace("``", "")
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


def _tree_height(screen: int) -> int:
    """Return the height of a dialog of settings on a screen of so many pixels."""
    return max(treeEditDefaultHeight, min(treeEditMaxInitialHeight, int(screen / _FREE_SHARE)))


def _show(edit: Edit, title: str, editable: bool, size: Callable[[int], tuple[int, int]]) -> None:
    """Open the dialog, with width and height for the height of the screen, and return when it is closed."""
    tk, root = _tkinter()
    root.title(title)
    width, height = size(root.winfo_screenheight())
    root.geometry(f"{width}x{height}")
    font, style = (None, treeviewDefaultFontSize), tk.ttk.Style(root)
    row = round(treeviewDefaultFontSize * textHeightFactor * root.winfo_fpixels("1p"))
    style.configure("Treeview", font=font, rowheight=row)
    style.configure("Treeview.Heading", font=font)
    tree = tk.ttk.Treeview(root, columns=("value", "help"), height=30)
    for column, width, text in (("#0", 300, "name"), ("value", 200, "value"), ("help", 500, "meaning")):
        tree.column(column, width=width)
        tree.heading(column, text=text, anchor="w")
    for path, text, words in edit.rows():
        is_open = path[-1] in treeEditOpenItems
        tree.insert("/".join(path[:-1]), "end", "/".join(path), text=path[-1], values=(text, words), open=is_open)
    message = tk.StringVar(root)
    tk.Label(root, textvariable=message, anchor="w").pack(side="bottom", fill="x")  # it keeps its room in small windows
    bar = tk.ttk.Scrollbar(root, command=tree.yview)
    bar.pack(side="right", fill="y")
    tree.configure(yscrollcommand=bar.set)
    tree.pack(fill="both", expand=True)

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
    _show(Edit(settingsStructure), dictionaryName, True, lambda screen: (treeEditDefaultWidth, _tree_height(screen)))


def EditDictionary(dictionaryData: dict[str, Any], dictionaryIsEditable: bool = True, dialogName: str = "") -> Any:
    """Show a dictionary, such as mbs.GetObject(0), in a dialog; return it, with what was changed there."""
    size = (dialogDefaultWidth, dialogDefaultHeight)
    _show(Edit(dictionaryData), dialogName or "dictionary", dictionaryIsEditable, lambda _: size)
    return dictionaryData
