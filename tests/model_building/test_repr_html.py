"""Notebooks show a system as a table of its items."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import dalembert as exu


def test_items_by_kind_and_type() -> None:
    mbs = exu.SystemContainer().AddSystem()
    for i in range(6):
        mbs.AddNode(exu.NodePoint(name=f"<point {i}>"))
    mbs.AddNode(exu.NodePointGround(name="rest"))
    mbs.AddObject(exu.ObjectMassPoint(name="ball", nodeNumber=0, physicsMass=1))
    page = ElementTree.fromstring(mbs._repr_html_())  # well formed: names are escaped
    assert re.match("MainSystem: 7 nodes, 1 object, 0 markers.*not assembled", page.findtext("p"))
    assert [[cell.text for cell in row] for row in page.iter("tr")] == [
        ["kind", "type", "number", "names"],
        ["node", "Point", "6", "<point 0>, <point 1>, <point 2>, <point 3>, ..."],
        ["node", "PointGround", "1", "rest"],
        ["object", "MassPoint", "1", "ball"],
    ]


def test_an_empty_system_has_no_table() -> None:
    page = ElementTree.fromstring(exu.SystemContainer().AddSystem()._repr_html_())
    assert page.find("table") is None and page.findtext("p").startswith("MainSystem: 0 nodes")
