"""What the tests of items share."""

from __future__ import annotations

import pytest

import dalembert as exu


@pytest.fixture
def mbs() -> exu.MainSystem:
    return exu.SystemContainer().AddSystem()
