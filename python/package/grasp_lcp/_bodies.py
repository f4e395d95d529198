"""Converts arrays of several bodies to the format of scenes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._columns import as_written, finite, listed, wrench_json


def bodies_in_scene(
    scene: dict[str, Any],
    axes: int,
    names: Sequence[str],
    sides: Mapping[str, Any],
    given: Mapping[str, Any],
    beside: Mapping[str, Any],
) -> None:
    """Writes the bodies into ``scene``, a dictionary.

    :param sides: ``on`` and ``against``: the body on each side of every contact, by name or number.
    :param given: data of the bodies, one value or row a body: mass, centre of mass, load.
    :param beside: data of the scene that belong to all bodies: gravity, the loaded body, links.
    """
    told = listed("names", [names] if isinstance(names, str) else names, "the names of the bodies")
    for index, name in enumerate(told):
        if not isinstance(name, str):
            raise TypeError(f"names[{index}]: {name!r} given, must be text")
    contacts = scene["contacts"]
    for field, side in sides.items():
        if side is not None:
            for contact, body in zip(contacts, _called(field, side, told, len(contacts)), strict=True):
                if body is not None:
                    contact[field] = body
    scene["bodies"] = [{"name": name} for name in told]
    for field, each in given.items():
        if each is not None:
            for body, value in zip(scene["bodies"], _of_each(field, each, len(told), axes), strict=True):
                body[field] = value
    scene.update({name: as_written(name, value) for name, value in beside.items() if value is not None and value is not False})


def _called(field: str, given: Any, names: Sequence[str], contacts: int) -> list[str | None]:
    """The name of the body of each contact, from names or numbers from 0. None and -1 mean the ground and become None."""
    each = listed(field, given.tolist() if isinstance(given, np.ndarray) else given, "a body for each contact")
    if isinstance(given, str) or len(each) != contacts:
        raise ValueError(f"{field}: {1 if isinstance(given, str) else len(each)} given, must be {contacts}, one a contact")
    found: list[str | None] = []
    for index, body in enumerate(each):
        if isinstance(body, (int, np.integer)) and not isinstance(body, bool):
            if not -1 <= body < len(names):
                raise ValueError(f"{field}[{index}] is {body}, must be from 0 to {len(names) - 1}, or -1 for the ground")
            found.append(None if body < 0 else names[int(body)])
        elif body is None or isinstance(body, str):
            found.append(body)
        else:
            raise TypeError(f"{field}[{index}]: {body!r} given, must be the name or the number of a body, or None")
    return found


def _of_each(field: str, given: ArrayLike, bodies: int, axes: int) -> list[Any]:
    """Broadcasts ``given`` to one number or one row a body; loads become mappings of force and moment."""
    if field == "load":
        each = listed(field, given, "a load for each body")
        if len(each) != bodies:
            raise ValueError(f"{field}: {len(each)} given, must be {bodies}, one a body")
        return [wrench_json(f"{field}[{index}]", load, axes) for index, load in enumerate(each)]
    shape = (bodies,) if field == "mass" else (bodies, axes)
    found = finite(field, given)
    try:
        return list(np.broadcast_to(found, shape).tolist())
    except ValueError:
        raise ValueError(f"{field}: shape {found.shape} given, must be {shape}") from None
