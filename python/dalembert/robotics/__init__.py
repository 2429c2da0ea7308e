"""Robots, mobile robots, trajectories and inverse kinematics; includes the names of roboticsCore."""

from __future__ import annotations

from dalembert.robotics.roboticsCore import *
