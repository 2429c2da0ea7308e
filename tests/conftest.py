"""What holds for all tests: none of them judges by the time it takes, none opens a window."""

import os

from hypothesis import settings

os.environ.setdefault("MPLBACKEND", "Agg")
settings.register_profile("untimed", deadline=None)
settings.load_profile("untimed")
