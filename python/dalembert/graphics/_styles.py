"""Colours and materials. Colours are lists [red, green, blue, alpha] in 0..1; -1 stands for 'default'."""

from __future__ import annotations

from typing import NoReturn

from dalembert._tools.missing_names import missing, nearest


class _Named(type):
    """Type of classes whose attributes are the available choices."""

    def __getattr__(cls, name: str) -> NoReturn:
        known = [each for each in vars(cls) if not each.startswith("_")]
        hint = "" if name.startswith("_") else nearest(name, known) or f"; known are: {', '.join(known)}"
        raise missing(f"graphics.{cls.__name__} has no attribute '{name}'", hint, name, cls)


class color(metaclass=_Named):
    """Named RGBA colours."""

    red = [1.0, 0.0, 0.0, 1.0]
    green = [0.0, 1.0, 0.0, 1.0]
    blue = [0.0, 0.0, 1.0, 1.0]
    cyan = [0.0, 1.0, 1.0, 1.0]
    magenta = [1.0, 0.0, 1.0, 1.0]
    yellow = [1.0, 1.0, 0.0, 1.0]
    orange = [1.0, 0.5, 0.0, 1.0]
    pink = [1.0, 0.0, 0.5, 1.0]
    lawngreen = [0.5, 1.0, 0.0, 1.0]
    springgreen = [0.0, 1.0, 0.5, 1.0]
    violet = [0.5, 0.0, 1.0, 1.0]
    dodgerblue = [0.0, 0.5, 1.0, 1.0]
    lightred = [0.9, 0.4, 0.4, 1.0]
    lightgreen = [0.4, 0.9, 0.4, 1.0]
    steelblue = [0.4, 0.4, 0.9, 1.0]
    brown = [0.65, 0.2, 0.2, 1.0]
    black = [0.0, 0.0, 0.0, 1.0]
    darkgrey = [0.2, 0.2, 0.2, 1.0]
    darkgrey2 = [0.35, 0.35, 0.35, 1.0]
    grey = [0.5, 0.5, 0.5, 1.0]
    lightgrey = [0.7, 0.7, 0.7, 1.0]
    lightgrey2 = [0.85, 0.85, 0.85, 1.0]
    white = [1.0, 1.0, 1.0, 1.0]
    default = [-1.0, -1.0, -1.0, -1.0]
    defaultBody = [0.4, 0.4, 0.9, 1]
    defaultJoint = [0.6, 0.6, 0.8, 1]
    defaultFFRF = green


class material(metaclass=_Named):
    """Indices of the standard materials, and colours that use the material's own RGB values.

    A material is chosen with an index in the place of alpha, e.g. [1, 0, 0, material.indexChrome].
    """

    indexBase = 1000
    indexDefault = indexBase
    indexMatt = indexBase + 1
    indexSteel = indexBase + 2
    indexPlastic = indexBase + 3
    indexChrome = indexBase + 4
    indexShiny = indexBase + 5
    indexTransparent = indexBase + 6
    indexGlass = indexBase + 7
    indexMirror = indexBase + 8
    indexEmission = indexBase + 9
    default = [-1, -1, -1, indexDefault]
    matt = [-1, -1, -1, indexMatt]
    steel = [-1, -1, -1, indexSteel]
    plastic = [-1, -1, -1, indexPlastic]
    chrome = [-1, -1, -1, indexChrome]
    shiny = [-1, -1, -1, indexShiny]
    transparent = [-1, -1, -1, indexTransparent]
    glass = [-1, -1, -1, indexGlass]
    mirror = [-1, -1, -1, indexMirror]
    emission = [-1, -1, -1, indexEmission]


colorList = [
    color.red,
    color.green,
    color.blue,
    color.cyan,
    color.magenta,
    color.yellow,
    color.orange,
    color.pink,
    color.lawngreen,
    color.violet,
    color.springgreen,
    color.dodgerblue,
    color.grey,
    color.darkgrey,
    color.lightgrey,
    color.brown,
]
