"""A contact of a simulator, as grasp-lcp counts it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Touch:
    """A contact of the simulator as grasp-lcp counts it, SI units: point relative to the object's centre of mass, normal and force into it."""

    finger: str
    point: Array
    normal: Array
    friction: float
    force: Array
    depth: float

    @property
    def press(self) -> float:
        """The normal force, N."""
        return float(self.normal @ self.force)
