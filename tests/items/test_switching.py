"""Items switched on and off while a solver runs, for every connector, contact, constraint and joint."""

from dalembert.testing.switching import *  # noqa: F403
