"""mbs.AddNode and the like are made in a quick way: they behave as Python methods, and errors explain missing names."""

from __future__ import annotations

import copy
import gc
import inspect
import pydoc
import weakref
from typing import Any

import pytest

import dalembert as exu

NAMES = ["AddNode", "AddObject", "AddMarker", "AddLoad", "AddSensor"]


def system() -> Any:
    return exu.SystemContainer().AddSystem()


@pytest.mark.parametrize("name", NAMES)
def test_they_are_like_methods(name: str) -> None:
    mbs, other = system(), system()
    method, of_class = getattr(mbs, name), getattr(exu.MainSystem, name)
    assert method.__name__ == name and method.__doc__ == of_class.__doc__ and method.__self__ is mbs
    assert str(inspect.signature(method)) == "(pyObject, /)" and inspect.isroutine(method) and callable(method)
    assert method == getattr(mbs, name) and hash(method) == hash(getattr(mbs, name))
    assert method != getattr(other, name) and method != getattr(mbs, NAMES[NAMES.index(name) - 1])
    assert f"built-in method {name} of dalembert._core.MainSystem object" in repr(method)
    assert method.__doc__ in pydoc.render_doc(method)
    assert name in dir(mbs) and isinstance(of_class, type(str.join))


def test_they_add_in_all_ways() -> None:
    mbs = system()
    add = mbs.AddNode
    assert [add(exu.NodePoint()), exu.MainSystem.AddNode(mbs, exu.NodePoint()), copy.copy(add)(exu.NodePoint())] == [
        0,
        1,
        2,
    ]
    assert list(map(add, [exu.NodePoint(), {"nodeType": "Point"}])) == [3, 4] and add(*[exu.NodePoint()]) == 5
    assert (
        mbs.AddObject(exu.ObjectMassPoint(physicsMass=1, nodeNumber=mbs.AddNode(exu.NodePoint()))) == 0
    )  # two at once
    for call in (lambda: mbs.AddNode(), lambda: mbs.AddNode(exu.NodePoint(), 1), lambda: mbs.AddNode(pyObject=1)):
        with pytest.raises(TypeError, match=r"AddNode\(\) takes"):
            call()
    with pytest.raises(TypeError, match=r"mbs\.AddNode\(\.\.\.\): received 3"):
        mbs.AddNode(3)
    assert mbs.systemData.NumberOfNodes() == 7


def test_classes_and_models_may_replace_them(monkeypatch: pytest.MonkeyPatch) -> None:
    class Counting(exu.MainSystem):
        count = 0

        def AddNode(self, node: Any) -> Any:
            self.count += 1
            return super().AddNode(node)

    mbs = Counting()
    assert (mbs.AddNode(exu.NodePoint()), mbs.AddNode(exu.NodePoint()), mbs.count) == (0, 1, 2)
    with pytest.raises(AttributeError, match="Did you mean 'AddMarker'"):
        mbs.AddMarkr  # noqa: B018
    monkeypatch.setattr(exu.MainSystem, "AddObject", lambda mbs, item: "replaced")
    assert system().AddObject(exu.ObjectGround()) == "replaced"


def test_they_keep_their_system_no_longer_than_they_are_used() -> None:
    mbs = system()
    gone = weakref.ref(mbs)
    add = mbs.AddNode
    del mbs
    add(exu.NodePoint())
    assert gone() is not None
    del add
    assert gone() is None
    mbs = exu.MainSystem()
    mbs.variables["add"] = mbs.AddNode  # in a circle
    gone = weakref.ref(mbs)
    del mbs
    gc.collect()
    assert gone() is None


def test_missing_names_are_explained() -> None:
    mbs = system()
    with pytest.raises(
        AttributeError, match="'MainSystem' object has no attribute 'AddNodes'. Did you mean 'AddNode'"
    ) as told:
        mbs.AddNodes  # noqa: B018
    assert told.value.name == "AddNodes"
    with pytest.raises(AttributeError, match="it belongs to a system container: SC.AddSystem"):
        mbs.AddSystem  # noqa: B018
    assert not hasattr(mbs, "no_such_name") and getattr(mbs, "no_such_name", 3) == 3
