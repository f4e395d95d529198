"""The whole program: a quick pass for all scenes, and a thorough one for those that it leaves open."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from .first_exit import FirstExit
from .onset import Scenes
from .slopes import slopes

Again = Callable[[list[Any]], list[Any]]
"""A thorough answer for the scenes with these data."""
Among = Callable[[Any, list[Any], list[Any], Again], list[Any]]
"""Puts thorough answers in the place of quick ones in the scenes that are open, from their data."""

UNROLLED = 8
"""The largest number of contacts that have an array each on an accelerator."""


class Kind(NamedTuple):
    """What a program is compiled for."""

    hold: tuple[str, ...]
    """A word a contact."""
    loaded: bool
    """Whether there is a base load."""
    stacked: bool
    """Whether contacts are the first axis of arrays in place of an array each."""


def onsets(xp: Any, epsilon: float, kind: Kind, data: list[Any], among: Among) -> FirstExit:
    """The onsets of all scenes; ``data`` as :class:`.onset.Scenes` takes them."""

    def of(data: Sequence[Any], stacked: bool) -> Scenes:
        return Scenes(xp, epsilon, data, kind.hold, loaded=kind.loaded, stacked=stacked)

    def again(data: list[Any]) -> list[Any]:
        return list(of(data, kind.stacked).thoroughly())

    count, axes = data[0].shape[-2:]
    if (axes, count) == (3, 2):
        # Two contacts in space leave a motion free, which only refined forces tell from a load that works on it.
        return of(data, kind.stacked).thoroughly()
    # The closed forms for two and three contacts have an array for each of them.
    closed = (axes, count) in ((2, 2), (3, 3))
    found, is_open = of(data, kind.stacked and not closed).quickly()
    return found if is_open is None else FirstExit(*among(is_open, list(found), data, again))


def gradients(xp: Any, epsilon: float, kind: Kind, data: list[Any], found: FirstExit) -> list[Any]:
    """Derivatives by each array of ``data``, zero in scenes without a finite factor.

    One refinement makes them as accurate as the factor unless stiffnesses differ by more than a million within a grasp.
    """
    # Elsewhere data may be NaN, which would reach second derivatives.
    leaves = found.contact >= 0
    data = [xp.where(leaves.reshape(*leaves.shape, *(1,) * (each.ndim - leaves.ndim)), each, 1.0) for each in data]
    scenes = Scenes(xp, epsilon, data, kind.hold, loaded=kind.loaded, stacked=kind.stacked)
    by = slopes(scenes, found.factor, found.contact, 1)
    by.append(xp.where(leaves, found.factor, 0.0)[..., None] * by[-1])
    return by


def among_rows(is_open: Any, found: list[Any], data: list[Any], again: Again) -> list[Any]:
    """Answers the open scenes alone, where the number of rows may depend on the data: in numpy and in PyTorch."""
    if bool(is_open.any()):
        for whole, part in zip(found, again([each[is_open] for each in data]), strict=True):
            whole[is_open] = part.to(whole.dtype) if hasattr(part, "to") else part
    return found
