"""Scenes of hands with joints, made from arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._columns import finite, listed, one_each
from ._views import Array


def scene_of_hand(
    scene: dict[str, Any],
    axes: int,
    jacobians: ArrayLike,
    stiffness: ArrayLike,
    joints: Sequence[str] | None,
    given: Mapping[str, Any],
    tendons: Sequence[Mapping[str, Any]] | None,
) -> dict[str, Any]:
    """The scene of contacts that joints move, see :meth:`grasp_lcp.Grasp.hand`. Contacts that no joint moves get no finger."""
    setup = scene["planar" if axes == 2 else "spatial"]
    contacts = setup.pop("contacts")
    moved = finite("jacobians", jacobians)
    if moved.ndim != 3 or moved.shape[:2] != (len(contacts), axes):
        raise ValueError(f"jacobians: shape {moved.shape} given, must be ({len(contacts)}, {axes}, joints)")
    count = moved.shape[2]
    springs, matrix = _springs(finite("stiffness", stiffness), count)
    names = [f"joint {j}" for j in range(count)] if joints is None else listed("joints", joints, "one name a joint")
    if len(names) != count:
        raise ValueError(f"joints: {len(names)} given, must be {count}, one a joint")
    rows: list[dict[str, Any]] = [{"name": name, "stiffness": spring} for name, spring in zip(names, springs, strict=True)]
    for field, value in given.items():
        if value is None:
            continue
        for row, one in zip(rows, one_each(field, value, count), strict=True):
            if one is not None and not isinstance(one, Mapping):
                number = float(finite(field, one))
                row[field] = {"saturates": number} if field == "limit" else number
            elif one is not None:
                row[field] = dict(one)
    finger: dict[str, Any] = {"joints": rows, "contacts": []}
    if matrix is not None:
        finger["stiffness_matrix"] = matrix.tolist()
    setup["contacts"] = []
    for contact, jacobian in zip(contacts, moved, strict=True):
        if jacobian.any():
            finger["contacts"].append({**contact, "moved_by": {"jacobian": jacobian.tolist()}})
        else:
            setup["contacts"].append(contact)
    if finger["contacts"]:
        setup["fingers"] = [finger]
        if tendons:
            setup["tendons"] = [dict(tendon) for tendon in tendons]
    return scene


def _springs(given: Array, count: int) -> tuple[list[float], Array | None]:
    """The stiffness of each joint, and None; for a matrix zeros, and the matrix."""
    if given.ndim < 2:
        try:
            return np.broadcast_to(given, (count,)).tolist(), None
        except ValueError:
            raise ValueError(f"stiffness: shape {given.shape} given, must be one number, ({count},) or ({count}, {count})") from None
    if given.shape != (count, count):
        raise ValueError(f"stiffness: shape {given.shape} given, must be one number, ({count},) or ({count}, {count})")
    return [0.0] * count, given
