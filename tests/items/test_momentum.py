"""Forces between two bodies conserve linear and angular momentum."""

from dalembert.testing.momentum import *  # noqa: F403
