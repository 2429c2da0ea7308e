"""Mass matrices: it is symmetric, positive, the derivative of the residual, and agrees with the equations of Newton and
Euler."""

from dalembert.testing.mass import *  # noqa: F403
