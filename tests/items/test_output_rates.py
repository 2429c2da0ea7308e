"""Each output is compared with a second formula: rates with differences along the motion, local vectors with global
ones,
forces and torques with the power that they bring into the system."""

from dalembert.testing.output_rates import *  # noqa: F403
