"""The whole program: a quick pass for all scenes, and a thorough pass for those that the quick one does not decide."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from .first_exit import FirstExit
from .onset import Scenes
from .slopes import slopes

Again = Callable[[list[Any]], list[Any]]
"""Type of the function that computes thorough answers from the data of some scenes."""
Among = Callable[[Any, list[Any], list[Any], Again], list[Any]]
"""Type of the function that replaces quick answers of undecided scenes by thorough ones, computed from their data."""

UNROLLED = 8
"""The largest number of contacts for which each contact has arrays of its own on an accelerator."""


class Kind(NamedTuple):
    """The properties of a batch for which a program is compiled."""

    hold: tuple[str, ...]
    """One word for each contact, as in :func:`grasp_lcp.onsets`."""
    loaded: bool
    """Whether there is a base load."""
    stacked: bool
    """Whether contacts are the first axis of common arrays; otherwise each contact has arrays of its own."""


def onsets(xp: Any, epsilon: float, kind: Kind, data: list[Any], among: Among) -> FirstExit:
    """The onsets of all scenes; ``data`` as :class:`.onset.Scenes` takes them."""

    def of(data: Sequence[Any], stacked: bool) -> Scenes:
        return Scenes(xp, epsilon, data, kind.hold, loaded=kind.loaded, stacked=stacked)

    count, axes = data[0].shape[-2:]
    if (axes, count) == (3, 2):
        # Two contacts in space leave a motion free. Only refined forces show reliably whether the load does work on it.
        return of(data, kind.stacked).thoroughly()
    # The closed forms for two and three contacts need separate arrays for each contact. Undecided scenes then keep the order of the crate's sums.
    stacked = kind.stacked and (axes, count) not in ((2, 2), (3, 3))

    def again(data: list[Any]) -> list[Any]:
        return list(of(data, stacked).thoroughly())

    found, is_open = of(data, stacked).quickly()
    return found if is_open is None else FirstExit(*among(is_open, list(found), data, again))


def gradients(xp: Any, epsilon: float, kind: Kind, data: list[Any], found: FirstExit) -> list[Any]:
    """Derivatives with respect to each array of ``data``, zero in scenes without a finite factor.

    One refinement makes them as accurate as the factor unless stiffnesses differ by more than a million within a grasp.
    """
    # Data of scenes without a factor may be NaN, which would enter second derivatives; they are replaced by ones.
    leaves = found.contact >= 0
    data = [xp.where(leaves.reshape(*leaves.shape, *(1,) * (each.ndim - leaves.ndim)), each, 1.0) for each in data]
    scenes = Scenes(xp, epsilon, data, kind.hold, loaded=kind.loaded, stacked=kind.stacked)
    by = slopes(scenes, found.factor, found.contact, 1)
    by.append(xp.where(leaves, found.factor, 0.0)[..., None] * by[-1])
    return by


def among_rows(is_open: Any, found: list[Any], data: list[Any], again: Again) -> list[Any]:
    """Answers only undecided scenes. Their number depends on the data, which numpy and PyTorch allow."""
    if bool(is_open.any()):
        for whole, part in zip(found, again([each[is_open] for each in data]), strict=True):
            whole[is_open] = part.to(whole.dtype) if hasattr(part, "to") else part
    return found
