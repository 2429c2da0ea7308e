"""Internals of websockets, beyond their public interface, on which the connection of pages depends."""

from __future__ import annotations

import inspect
import re
from importlib.metadata import version
from pathlib import Path

import pytest
from websockets.asyncio import connection, server
from websockets.asyncio.server import ServerConnection

from dalembert._live.connection import PageConnection

ROOT = Path(__file__).resolve().parents[2]
ADVICE = (
    f"websockets {version('websockets')} is not what dalembert/_live/connection.py was made for: {{}}. "
    "Adapt that file, or lower the ceiling in pyproject.toml."
)
REPLACED = ("connection_made", "connection_lost", "send_data", "process_event")


@pytest.mark.parametrize("name", REPLACED)
def test_methods_that_are_replaced_are_there(name: str) -> None:
    original = getattr(ServerConnection, name, None)
    assert original is not None, ADVICE.format(f"its connections have no method {name}")
    taken, ours = (list(inspect.signature(f).parameters) for f in (original, getattr(PageConnection, name)))
    assert taken == ours, ADVICE.format(f"{name} takes {taken}")


def test_names_are_its_own() -> None:
    own = {name for name in vars(PageConnection) if name in dir(ServerConnection) and not name.startswith("__")}
    own |= set(re.findall(r"self\.(_\w+|on_shown|end_pictures|send_picture)", inspect.getsource(PageConnection)))
    theirs = set(re.findall(r"self\.(\w+)", inspect.getsource(connection) + inspect.getsource(server)))
    assert own & theirs <= set(REPLACED), ADVICE.format(f"it uses the names {sorted(own & theirs - set(REPLACED))} too")


def test_all_is_written_by_one_method() -> None:
    """Pictures are written between two calls of it, so that messages stay whole."""
    pattern = r"transport\.(?:write|writelines|sendto)\("
    writes = _calls(pattern, inspect.getsource(connection)) + _calls(pattern, inspect.getsource(server))
    within = _calls(pattern, inspect.getsource(connection.Connection.send_data))
    assert writes == within == 1, ADVICE.format(f"it writes in {writes} places, {within} of them in send_data")


def test_received_messages_pass_one_method() -> None:
    source = inspect.getsource(connection.Connection.data_received)
    assert _calls(r"self\.process_event\(", source) == 1, ADVICE.format("data_received does not call process_event")


def test_versions_are_those_that_were_tried() -> None:
    """docs/developer/dependencies.rst lists them."""
    floor, ceiling = re.findall(r'"websockets>=(\d+)\.0,<(\d+)"', (ROOT / "pyproject.toml").read_text("utf-8"))[0]
    assert int(floor) <= int(version("websockets").split(".")[0]) < int(ceiling)


def _calls(pattern: str, source: str) -> int:
    return len(re.findall(pattern, source))
