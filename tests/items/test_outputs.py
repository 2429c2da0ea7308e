"""Every output variable of every item: there in all configurations, of the size that its spec states."""

from dalembert.testing.outputs import *  # noqa: F403
