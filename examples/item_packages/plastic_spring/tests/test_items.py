"""The tests that every item has, for the items of plastic_spring: `dalembert items check`."""

from dalembert.testing import *
