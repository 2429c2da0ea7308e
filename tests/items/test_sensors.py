"""Values of sensors agree with outputs of their items, at any time and in stored data; two successive runs store the
same data as two new systems."""

from dalembert.testing.sensors import *  # noqa: F403
