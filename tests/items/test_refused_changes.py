"""An error of an assembled system names item and parameter; the system remains unchanged."""

from dalembert.testing.refused_changes import *  # noqa: F403
