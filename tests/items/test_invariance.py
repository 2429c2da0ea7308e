"""A rotated and shifted model has rotated and shifted motions and outputs."""

from dalembert.testing.invariance import *  # noqa: F403
