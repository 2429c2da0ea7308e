"""Modules by the names that models have for them after `from dalembert.utilities import *`."""

import copy
import math

import numpy as np

import dalembert as exu
import dalembert as exudyn
from dalembert import itemInterface as eii

__all__ = ["copy", "eii", "exu", "exudyn", "math", "np"]
