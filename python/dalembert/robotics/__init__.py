"""Robots, mobile robots, trajectories and inverse kinematics; what roboticsCore has is here as well."""

from __future__ import annotations

from dalembert.robotics.roboticsCore import *
