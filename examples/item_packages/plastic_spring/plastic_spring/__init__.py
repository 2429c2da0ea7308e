"""Items of plastic_spring."""

from plastic_spring._items import *
