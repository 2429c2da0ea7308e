"""The tests that every item has, for the items of bar_element: `dalembert items check`."""

from dalembert.testing import *
