"""Scenes of pads that close on a mesh."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._columns import finite, listed

# Fields that describe the shape and the motion of a pad; all other fields belong to its contact.
TOUCHES = ("rectangle", "disc", "round", "v_deg", "strips", "from", "closing", "layer")


def scene_of_mesh(
    mesh: Any, pads: Sequence[Mapping[str, Any]], unit: str, mass: float | None, density: float | None, settings: Mapping[str, Any] | None
) -> dict[str, Any]:
    """The scene of a part and its pads, see :meth:`grasp_lcp.Grasp.from_mesh`."""
    part: dict[str, Any] = {"unit": unit}
    if isinstance(mesh, (str, os.PathLike)):
        part["mesh"] = os.path.abspath(mesh)
    else:
        part["vertices"], part["faces"] = _arrays(mesh)
    part.update({name: value for name, value in (("mass", mass), ("density", density)) if value is not None})
    contacts = []
    for index, pad in enumerate(listed("pads", pads, "a list of pads")):
        if not isinstance(pad, Mapping):
            raise TypeError(
                f"pads[{index}]: {pad!r} given, must be a mapping, such as {{'rectangle': [0.02, 0.03], 'from': …, 'closing': …}}"
            )
        contact = {name: value for name, value in pad.items() if name not in TOUCHES}
        contacts.append({**contact, "touches": {name: value for name, value in pad.items() if name in TOUCHES}})
    setup: dict[str, Any] = {"part": part, "contacts": contacts}
    if settings is not None:
        setup["settings"] = settings
    return {"format": "grasp-lcp/1", "spatial": setup}


def _arrays(mesh: Any) -> tuple[list[list[float]], list[list[int]]]:
    """Vertices and faces of a mesh object, such as one of trimesh, or of a pair of arrays."""
    try:
        vertices, faces = (mesh.vertices, mesh.faces) if hasattr(mesh, "vertices") else mesh
    except (TypeError, ValueError):
        raise TypeError(f"mesh: {type(mesh).__name__} given, must be a path, a mesh with vertices and faces, or a pair of them") from None
    return _rows("vertices", finite("vertices", vertices)), _rows("faces", _whole("faces", faces))


def _whole(name: str, given: ArrayLike) -> np.ndarray[Any, Any]:
    found = np.asarray(given)
    if found.dtype.kind not in "iu" or (found.size and found.min() < 0):
        raise TypeError(f"{name}: must be whole numbers from 0, the corners of each face")
    return found


def _rows(name: str, found: np.ndarray[Any, Any]) -> Any:
    if found.ndim != 2 or found.shape[1] != 3 or not len(found):
        raise ValueError(f"{name}: shape {found.shape} given, must be (n, 3) with at least one row")
    return found.tolist()
