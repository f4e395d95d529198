"""Does the grasp hold? Contact forces, object motion, and the exact load at which a grasp starts to slide.

    >>> from grasp_lcp import Grasp
    >>> grasp = Grasp.planar(
    ...     [[-0.04, 0], [0.04, 0]], [[1, 0], [-1, 0]],      # points, m; normals into the object
    ...     body_stiffness=[5e4, 3e4], finger_stiffness=[2e3, 1.5e3], friction=0.5, pressed_with=8.0)
    >>> grasp.onset([0, -4.905])
    <Onset: FIRST SLIP at factor 1.63099: contact 0 and contact 1 slide; beyond: no equilibrium; it is the limit load>

One grasp: :class:`Grasp`. Batches of grasps: :func:`onsets`, :func:`onset_gradients`, :func:`hold_batch`,
:func:`need_batch`, :func:`solve_batch`. Differentiable layers:
:mod:`grasp_lcp.torch` and :mod:`grasp_lcp.jax`, which the package imports only on request. Linear complementarity
and frictional contact problems that belong to no grasp: :mod:`grasp_lcp.lcp`, :mod:`grasp_lcp.friction`. "No equilibrium exists" is an
answer, never an exception; malformed input is a ``ValueError`` or a ``TypeError`` that names the argument.
"""

from typing import TYPE_CHECKING, Any

from . import friction, lcp
from ._grasp_lcp import VERSION as __version__
from .answers import (
    Answer,
    Beyond,
    Comparison,
    Event,
    Identified,
    Improved,
    Leaving,
    Needed,
    Onset,
    Path,
    Proof,
    Shakedown,
    Shaken,
    Solution,
    TurnOnset,
    Verdict,
)
from .batch import ContactState, Equilibria, Onsets, OnsetStatus, SolveStatus, onsets, solve_batch
from .equilibrium import Contact, Drive, Equilibrium, Pad
from .gradients import OnsetGradients, onset_gradients
from .grasp import Grasp, Leg, Settings, answers, warnings, wrench
from .quality import Closure, LeastSqueeze, LoadLimit, Quality, WeakestDirection, WrenchBall
from .watch import Watch, Watched

if TYPE_CHECKING:
    from .verdicts import Amounts, AmountStatus, Doubt, LossMotion, Verdicts, VerdictStatus, hold_batch, need_batch

__all__ = [
    "AmountStatus",
    "Amounts",
    "Answer",
    "Beyond",
    "Closure",
    "Comparison",
    "Contact",
    "ContactState",
    "Doubt",
    "Drive",
    "Equilibria",
    "Equilibrium",
    "Event",
    "Grasp",
    "Identified",
    "Improved",
    "LeastSqueeze",
    "Leaving",
    "Leg",
    "LoadLimit",
    "LossMotion",
    "Needed",
    "Onset",
    "OnsetGradients",
    "OnsetStatus",
    "Onsets",
    "Pad",
    "Path",
    "Proof",
    "Quality",
    "Settings",
    "Shakedown",
    "Shaken",
    "Solution",
    "SolveStatus",
    "TurnOnset",
    "Verdict",
    "VerdictStatus",
    "Verdicts",
    "Watch",
    "Watched",
    "WeakestDirection",
    "WrenchBall",
    "__version__",
    "answers",
    "friction",
    "hold_batch",
    "lcp",
    "need_batch",
    "onset_gradients",
    "onsets",
    "solve_batch",
    "warnings",
    "wrench",
]  # fmt: skip


def __getattr__(name: str) -> Any:
    """Imports the names of module ``verdicts`` when they are first used."""
    if name in __all__:
        from . import verdicts

        return getattr(verdicts, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """All names, those too that are imported when they are first used."""
    return sorted({*globals(), *__all__})
