"""Reactions agree with the virtual work of the constraint equations, and do no work on admissible motions."""

from dalembert.testing.virtual_work import *  # noqa: F403
