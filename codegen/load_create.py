"""Read the signatures of the Create functions, for the stub of Model: they are Python, so their source is parsed."""

from __future__ import annotations

import ast
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class CreateArgument:
    name: str
    annotation: str
    required: bool


@dataclass(frozen=True)
class CreateFunction:
    """A Create function without its first argument, the system."""

    name: str
    arguments: tuple[CreateArgument, ...]
    returns: str
    summary: str


def load_create_functions(folder: Path) -> tuple[CreateFunction, ...]:
    """Return the Create functions of the modules in a folder, in the order of their names."""
    files = sorted(folder.glob("[a-z]*.py"))
    return tuple(
        sorted(
            (
                _function(node)
                for file in files
                for node in ast.parse(file.read_text("utf-8")).body
                if isinstance(node, ast.FunctionDef) and node.name.startswith("Create")
            ),
            key=lambda each: each.name,
        )
    )


def _function(node: ast.FunctionDef) -> CreateFunction:
    arguments = node.args.args
    first_optional = len(arguments) - len(node.args.defaults)
    read = [
        CreateArgument(each.arg, ast.unparse(each.annotation) if each.annotation else "Any", i < first_optional)
        for i, each in enumerate(arguments)
    ]
    returns = ast.unparse(node.returns) if node.returns else "Any"
    return CreateFunction(node.name, tuple(read[1:]), returns, (ast.get_docstring(node) or "").partition("\n")[0])
