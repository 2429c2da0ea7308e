"""The tangent is the derivative of the residual, along all weights, at random states of models around every item."""

from dalembert.testing.tangent import *  # noqa: F403
