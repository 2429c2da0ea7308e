"""A solver leaves nothing behind: two runs in a row from the same start are bit for bit two fresh runs."""

from dalembert.testing.repeated_solves import *  # noqa: F403
