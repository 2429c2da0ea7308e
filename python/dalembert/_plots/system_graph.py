"""The items of a system and their connections as a graph (networkx), drawn by matplotlib."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from dalembert._calls import check_given
from dalembert._checks import as_positive, check_integer, check_system, shape_error

_COLORS = {
    "Node": "red",
    "Object": "skyblue",
    "Connector": "dodgerblue",
    "Marker": "orange",
    "Load": "mediumorchid",
    "Sensor": "forestgreen",
}
_OBJECT_NODE_COLOR = "navy"
LARGEST = 100.0  # factor of the size of letters
# Prefixes of labels, which distinguish connectors from bodies.
_OBJECT_PREFIXES = {"Connector": "Oconnector", "Contact": "Ocontact", "Joint": "Ojoint"}
# Parts of the type name after which a label is broken into two lines.
_BREAKS = {
    "Node": ("Ground", "Rigid", "Generic"),
    "Marker": ("Body", "Object", "Node", "SuperElement", "Kinematic"),
    "Object": ("Joint", "Mass", "Beam", "ANCF", "Contact", "Connector", "Rigid", "FFRF"),
    "Load": ("Mass",),
    "Sensor": (),
}
# The style of a label: box and font size.
_STYLES = {"Object": ("round,pad=0.2", 12), "Node": ("square,pad=0.1", 10), "Marker": ("square,pad=0.1", 8)}
_NO_ANNOTATION = (
    "V",
    "name",
    *(f"{kind}{end}" for kind in ("node", "object", "marker", "load", "sensor") for end in ("Number", "Type")),
    "bodyNumber",
)


class _Item(NamedTuple):
    kind: str  # 'Node', 'Object', ...
    number: int
    data: dict[str, Any]

    @property
    def type_name(self) -> str:
        return str(self.data[f"{self.kind.lower()}Type"])

    @property
    def color(self) -> str:
        is_connector = self.kind == "Object" and any(part in self.type_name for part in _OBJECT_PREFIXES)
        return _COLORS["Connector" if is_connector else self.kind]

    def numbers(self, *parameters: str) -> list[int]:
        """Return the valid item numbers in the parameters, which hold one number or a list of them."""
        values = [self.data[p] for p in parameters if p in self.data]
        flat = [n for value in values for n in (value if isinstance(value, (list, np.ndarray)) else [value])]
        return [int(n) for n in flat if int(n) >= 0]


def _items(mbs: Any, showLoads: bool, showSensors: bool) -> dict[str, list[_Item]]:
    kinds = ["Node", "Marker", "Object"] + ["Load"] * bool(showLoads) + ["Sensor"] * bool(showSensors)
    data = mbs.systemData
    return {
        kind: [_Item(kind, i, getattr(mbs, f"Get{kind}")(i)) for i in range(getattr(data, f"NumberOf{kind}s")())]
        for kind in kinds
    }


def _label(item: _Item, useItemNames: bool, useItemTypes: bool, addItemTypeNames: bool, line_break: str) -> str:
    if useItemNames:
        return str(item.data["name"])
    kind = item.kind
    if not useItemTypes:
        prefixes = (new for part, new in _OBJECT_PREFIXES.items() if kind == "Object" and part in item.type_name)
        return f"{next(prefixes, kind)}{item.number}"
    name = f"{item.type_name}{item.number}"
    if not addItemTypeNames:
        return name
    if line_break:
        for part in _BREAKS[kind]:
            if name.startswith(part):
                return f"{kind}{part}{line_break}{name.removeprefix(part)}"
    return f"{kind}{line_break}{name}"


def _edges(items: dict[str, list[_Item]]) -> list[tuple[_Item, _Item, str]]:
    """Return which item refers to which, and the colour of the line between them."""
    rows = (
        ("Object", "Node", ("nodeNumber", "nodeNumbers"), _OBJECT_NODE_COLOR),
        ("Object", "Marker", ("markerNumbers",), _COLORS["Connector"]),
        ("Marker", "Node", ("nodeNumber",), _COLORS["Marker"]),
        ("Marker", "Object", ("objectNumber", "bodyNumber"), _COLORS["Marker"]),
        ("Load", "Marker", ("markerNumber",), _COLORS["Load"]),
        ("Sensor", "Object", ("objectNumber", "bodyNumber"), _COLORS["Sensor"]),
        ("Sensor", "Node", ("nodeNumber",), _COLORS["Sensor"]),
    )
    return [
        (item, items[target][number], color)
        for kind, target, parameters, color in rows
        for item in items.get(kind, [])
        for number in item.numbers(*parameters)
        if number < len(items[target])
    ]


def _draw(graph: Any, labelled: dict[str, _Item], options: dict[str, Any]) -> Any:
    """Draw the graph into the current figure and return the texts of the labels."""
    import matplotlib.pyplot as plt
    import networkx as nx

    scale = options["fontSizeFactor"]
    plt.clf()
    if options["showLegend"]:
        names = {"Connector": "Object(Connector)"}
        for kind, color in _COLORS.items():
            plt.plot([0], [0], linewidth=8, color=color, label=names.get(kind, kind))
        plt.legend(fontsize=10 * max(scale, 1))

    colors = [data["color"] for _, _, data in graph.edges(data=True)]
    positions = nx.spring_layout(
        graph,
        scale=0.5,
        k=options["layoutDistanceFactor"] / np.sqrt(max(graph.size(), 1)),
        threshold=1e-5,
        iterations=options["layoutIterations"],
    )
    nx.draw_networkx_nodes(graph, positions, node_size=1)
    widths = [4 if color == _OBJECT_NODE_COLOR else 2 for color in colors]
    nx.draw_networkx_edges(graph, positions, edge_color=colors, width=widths)
    texts = nx.draw_networkx_labels(graph, positions, font_size=10 * scale, clip_on=False)
    for label, item in labelled.items():
        box, size = _STYLES.get(item.kind, ("round,pad=0.2", 10))
        texts[label].set_bbox({"facecolor": item.color, "edgecolor": item.color, "boxstyle": box})
        texts[label].set_fontsize(size * scale)
    plt.axis("off")
    if options["tightLayout"]:
        plt.tight_layout()
    plt.margins(x=0.1 * scale, y=0.1 * scale)
    plt.draw()
    return texts


def DrawSystemGraph(
    mbs: Any,
    showLoads: bool = True,
    showSensors: bool = True,
    useItemNames: bool = False,
    useItemTypes: bool = False,
    addItemTypeNames: bool = True,
    multiLine: bool = True,
    fontSizeFactor: float = 1.0,
    layoutDistanceFactor: float = 3.0,
    layoutIterations: int = 100,
    showLegend: bool = True,
    tightLayout: bool = True,
    showGraph: bool = True,
    addItemData: bool = False,
    addAnnotations: bool = False,
) -> list[Any]:
    """Draw the references between items and return [networkx, graph, texts]; texts is None if showGraph is False.

    Labels are kind and number, type names (useItemTypes) or item names (useItemNames: they must differ). addItemData
    stores type, basicType, ID and name, addAnnotations the parameters in the nodes of the graph. ImportError if
    networkx or matplotlib are missing.
    """
    check_given(DrawSystemGraph, locals().items())
    try:
        import networkx as nx
    except ImportError as error:
        raise ImportError("DrawSystemGraph needs networkx: pip install networkx") from error

    line_break = "-\n" if multiLine and showGraph else ""
    check_system("DrawSystemGraph: mbs", mbs)
    where = "DrawSystemGraph: "
    layoutDistanceFactor = as_positive(f"{where}layoutDistanceFactor", layoutDistanceFactor)
    check_integer(f"{where}layoutIterations", layoutIterations, 1)
    if not 0 < fontSizeFactor <= LARGEST:
        raise shape_error(f"{where}fontSizeFactor", f"a positive number up to {LARGEST:g}", fontSizeFactor)
    items = _items(mbs, showLoads, showSensors)
    graph = nx.Graph()
    labels: dict[tuple[str, int], str] = {}
    labelled: dict[str, _Item] = {}
    for item in (item for group in items.values() for item in group):
        label = _label(item, useItemNames, useItemTypes, addItemTypeNames, line_break)
        labels[item.kind, item.number] = label
        labelled[label] = item
        graph.add_node(label)
        if addItemData:
            graph.nodes[label].update(
                type=item.kind + item.type_name, basicType=item.kind, ID=item.number, name=item.data["name"]
            )
        if addAnnotations:
            kept = {key: value for key, value in item.data.items() if not key.startswith(_NO_ANNOTATION)}
            graph.nodes[label]["annotations"] = kept
    for start, end, color in _edges(items):
        graph.add_edge(labels[start.kind, start.number], labels[end.kind, end.number], color=color)

    options = {
        "fontSizeFactor": fontSizeFactor,
        "layoutDistanceFactor": layoutDistanceFactor,
        "layoutIterations": layoutIterations,
        "showLegend": showLegend,
        "tightLayout": tightLayout,
    }
    return [nx, graph, _draw(graph, labelled, options) if showGraph else None]
