"""Items of bar_element."""

from bar_element._items import *
