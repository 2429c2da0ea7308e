"""Denavit-Hartenberg parameters of joints, standard and modified. Lengths in m, angles in rad."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import as_array, as_vector
from dalembert._geometry.rigid_transformation import HT, sharing
from dalembert._geometry.transformations import HTrotateX, HTrotateZ, HTtranslate


def StdDH2HT(DHparameters: npt.ArrayLike) -> HT:
    """Return the transformation Rz(theta) Tz(d) Tx(a) Rx(alpha) of standard parameters [theta, d, a, alpha].

    J. Denavit, R. S. Hartenberg, A kinematic notation for lower-pair mechanisms, J. Applied Mechanics 22, 1955.
    """
    theta, d, a, alpha = as_vector("StdDH2HT: DHparameters", DHparameters, 4)
    return sharing(HTrotateZ(theta) @ HTtranslate([a, 0.0, d]) @ HTrotateX(alpha))


def ModDHKK2HT(DHparameters: npt.ArrayLike) -> list[HT]:
    """Return [Rx(alpha) Tx(d), Rz(theta) Tz(r)], before and with the motion of the joint, of [alpha, d, theta, r].

    W. Khalil, J.-F. Kleinfinger, A new geometric notation for open and closed-loop robots, IEEE ICRA, 1986.
    """
    alpha, d, theta, r = as_vector("ModDHKK2HT: DHparameters", DHparameters, 4)
    before, after = HTrotateX(alpha) @ HTtranslate([d, 0.0, 0.0]), HTrotateZ(theta) @ HTtranslate([0.0, 0.0, r])
    return [sharing(before), sharing(after)]


def projectAngleToPMPi(q0: npt.ArrayLike) -> Any:
    """Return angles, a number or a list of them, turned by full turns into the range above -pi and up to pi."""
    q = as_array("projectAngleToPMPi: q0", q0)
    return q - 2 * np.pi * np.ceil((q - np.pi) / (2 * np.pi))
