"""The tangent is the derivative of the residual, along all weights, at random states of models around every item."""

from dalembert.testing.tangents import *  # noqa: F403
