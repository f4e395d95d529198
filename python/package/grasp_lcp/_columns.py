"""Broadcasts arrays of contact data to the shape that the native module reads, and checks them. Errors name the argument."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._views import Array

STIFFNESSES = ("series_stiffness", "body_stiffness", "finger_stiffness")

HOLDS = {"unilateral": 0, "kept_closed": 1, "bonded": 2}


def floats(name: str, given: ArrayLike) -> Array:
    """Converts integers and floating-point numbers to double precision; masked entries become NaN."""
    try:
        found = np.asarray(given)
    except ValueError:
        raise ValueError(f"{name}: rows of different lengths given, must be an array") from None
    if found.dtype.kind not in "fiu":
        hint = f": {name}.astype(float) makes them" if found.dtype.kind == "O" and isinstance(given, np.ndarray) else ""
        raise TypeError(f"{name}: {_kind(found)} given, must be numbers{hint}")
    if isinstance(given, np.ma.MaskedArray):
        found = np.ma.filled(given.astype(np.float64), np.nan)
    return np.require(found, dtype=np.float64, requirements=["A"])


def _kind(found: np.ndarray[Any, Any]) -> str:
    """What an array contains in place of numbers, in words, for an error message."""
    if found.dtype.kind == "O":
        others = [item for item in found.flat if not isinstance(item, (int, float))]
        return repr(others[0]) if others else "an array of objects"
    return {"U": "text", "S": "bytes", "c": "complex numbers", "b": "booleans"}.get(found.dtype.kind, str(found.dtype))


def finite(name: str, given: ArrayLike) -> Array:
    """Converts numbers to double precision and refuses values that are not finite, because JSON cannot express them."""
    found = floats(name, given)
    bad = np.argwhere(~np.isfinite(found))
    if len(bad):
        place = ", ".join(str(index) for index in bad[0])
        where = f"[{place}]" if place else ""
        raise ValueError(f"{name}{where} is {found[tuple(bad[0])]}, must be finite")
    return found


def one_of(name: str, given: Any, allowed: Sequence[str]) -> Any:
    """The given word, if it is one of the allowed ones; else an error that names them, and the nearest."""
    if given in allowed:
        return given
    near = get_close_matches(given, allowed, 1) if isinstance(given, str) else []
    meant = f" ({near[0]}?)" if near else ""
    raise ValueError(f"{name}: {given!r}{meant}, must be one of {', '.join(allowed)}")


def listed(name: str, given: Any, what: str) -> list[Any]:
    """Converts an iterable to a list; the ``TypeError`` says that the argument must be ``what``."""
    try:
        return list(given)
    except TypeError:
        raise TypeError(f"{name}: {given!r} given, must be {what}") from None


def _stiffness(name: str, given: ArrayLike, axes: int) -> Array:
    found = floats(name, given)
    if found.ndim == 0:
        return np.broadcast_to(found, (axes,))
    if found.shape[-1] == axes:
        return found
    if found.shape[-1] == 2:
        # Normal and tangential stiffness; both tangents share the second.
        return found[..., [0, 1, 1]]
    sizes = "2" if axes == 2 else "2 or 3"
    raise ValueError(f"{name}: shape {found.shape} given, must be one number or end in {sizes}, normal first")


def _vectors(name: str, given: ArrayLike, axes: int) -> Array:
    found = floats(name, given)
    if found.ndim == 0 or found.shape[-1] != axes:
        raise ValueError(f"{name}: shape {found.shape} given, must end in {axes}")
    return found


def words_of_holds(given: str | Sequence[str], contacts: int) -> tuple[str, ...]:
    """The argument ``hold`` as one word for each contact."""
    if isinstance(given, str):
        given = [given] * contacts
    words = listed("hold", given, "a word, or one for each contact")
    if len(words) != contacts:
        raise ValueError(f"hold: {len(words)} given, must be one word, or {contacts}, one a contact")
    for index, word in enumerate(words):
        if not isinstance(word, str) or word not in HOLDS:
            raise ValueError(f"hold[{index}] is {word!r}, must be one of {', '.join(HOLDS)}")
    return tuple(words)


def columns(
    axes: int,
    points: ArrayLike,
    normals: ArrayLike,
    friction: ArrayLike,
    hold: str | Sequence[str],
    soft: Any = None,
    **others: ArrayLike | None,
) -> tuple[tuple[int, ...], dict[str, Any]]:
    """The batch shape of the grasps, and all contact data broadcast to it.

    Data have shape (grasps, contacts) for scalars and (grasps, contacts, axes) for vectors; ``hold`` has one code for each contact.
    """
    given: dict[str, Array | None] = {"points": _vectors("points", points, axes)}
    if given["points"] is None or given["points"].ndim < 2:
        raise ValueError(f"points: shape {np.shape(points)} given, must be (..., n, {axes})")
    contacts = given["points"].shape[-2]
    given["normals"] = _vectors("normals", normals, axes)
    for name in STIFFNESSES:
        value = others.get(name)
        given[name] = None if value is None else _stiffness(name, value, axes)
    for name in ("tangents", "command", "command_world"):
        value = others.get(name)
        given[name] = None if value is None else _vectors(name, value, axes)
    if all(given[name] is None for name in STIFFNESSES):
        raise ValueError("series_stiffness: nothing given, must be given, or body_stiffness or finger_stiffness")
    if given["series_stiffness"] is not None and (given["body_stiffness"] is not None or given["finger_stiffness"] is not None):
        raise ValueError("series_stiffness: given beside body_stiffness or finger_stiffness, must be alone")
    commands = given["command"]
    if commands is not None and others.get("pressed_with") is not None and np.any(commands[..., 0] != 0):
        raise ValueError("pressed_with: given beside a command with a normal part, must be alone")
    if given["command"] is not None and given["command_world"] is not None:
        raise ValueError("command_world: given beside command, must be alone")
    scalars = {"friction": floats("friction", friction)}
    for name in ("pressed_with", "clearance", "kinetic_friction"):
        value = others.get(name)
        if value is not None:
            scalars[name] = floats(name, value)

    shape: tuple[int, ...] = ()
    shapes = [(name, found.shape[:-1]) for name, found in given.items() if found is not None]
    for name, own in [*shapes, *((name, found.shape) for name, found in scalars.items())]:
        try:
            shape = np.broadcast_shapes(shape, own)
        except ValueError:
            raise ValueError(f"{name}: shape {own} given for contacts of shape {shape}, must broadcast to it") from None
        if shape[-1] != contacts:
            raise ValueError(f"{name}: {shape[-1]} contacts given, points have {contacts}")
    leading = shape[:-1]
    rows = int(np.prod(leading, dtype=np.int64))

    made: dict[str, Any] = {
        name: None if found is None else np.broadcast_to(found, (*shape, axes)).reshape(rows, contacts, axes)
        for name, found in given.items()
    }
    for name in ("friction", "pressed_with", "clearance", "kinetic_friction"):
        made[name] = np.broadcast_to(scalars[name], shape).reshape(rows, contacts) if name in scalars else None
    made["hold"] = None if hold == "unilateral" else np.array([HOLDS[word] for word in words_of_holds(hold, contacts)], dtype=np.uint8)
    made["soft"] = text_of_pads(soft, contacts)
    return leading, made


def text_of_pads(soft: Any, contacts: int) -> str | None:
    """The argument ``soft`` as JSON text: a list with a pad or null for each contact."""
    if soft is None:
        return None
    pads = one_each("soft", soft, contacts)
    return dumped([None if pad is None else as_written(f"soft[{index}]", pad) for index, pad in enumerate(pads)])


def plain(name: str, given: Any) -> Any:
    """Converts a load or a turn to data for JSON: mappings entry by entry, arrays to lists of finite numbers."""
    if isinstance(given, Mapping):
        return {key: plain(f"{name}[{key!r}]", value) for key, value in given.items()}
    if isinstance(given, (str, bool)):
        return given
    return finite(name, given).tolist()


def as_written(name: str, given: Any) -> Any:
    """Converts a part of a contact to the format of scenes; integers stay integers."""
    if isinstance(given, Mapping):
        return {key: as_written(f"{name}[{key!r}]", value) for key, value in given.items()}
    if isinstance(given, (list, tuple)):
        return [as_written(f"{name}[{index}]", value) for index, value in enumerate(given)]
    if isinstance(given, (str, bool, int)):
        return given
    return int(given) if isinstance(given, np.integer) else finite(name, given).tolist()


def one_each(name: str, given: Any, contacts: int) -> list[Any]:
    """A list with one entry for each contact. A single value is repeated; a list must have one value or None for each contact."""
    if isinstance(given, (Mapping, str)) or np.ndim(given) == 0:
        return [given] * contacts
    each = listed(name, given, "one for all contacts, or a list of one each")
    if len(each) != contacts:
        raise ValueError(f"{name}: {len(each)} given, must be one for all or {contacts}, one a contact")
    return each


def wrench_json(name: str, given: Any, axes: int) -> Any:
    """Converts a load to the format of scenes, from a mapping or from an array of a force, or of a force and a moment."""
    if isinstance(given, Mapping):
        return plain(name, given)
    numbers = finite(name, given)
    coordinates = 3 * (axes - 1)
    if numbers.shape not in ((axes,), (coordinates,)):
        raise ValueError(f"{name}: shape {numbers.shape} given, must be ({axes},) of a force or ({coordinates},) of a force and a moment")
    force, moment = numbers[:axes].tolist(), numbers[axes:].tolist()
    if not moment:
        # With a moment the force acts through the origin, also where forces of several bodies act at their centre of mass.
        moment = [0.0] * (coordinates - axes)
    return {"force": force, "moment": moment if axes == 3 else moment[0]}


def load_text(name: str, given: Mapping[str, Any]) -> str:
    """A load given as a mapping, as JSON text."""
    return dumped(plain(name, given))


def scene_text(scene: Any) -> str:
    """A scene as JSON text. Refuses NaN and infinities by the name of their field."""
    try:
        return dumped(scene)
    except ValueError:
        _refuse_not_finite("", scene)
        raise


def _refuse_not_finite(where: str, value: Any) -> None:
    """Raises the error for the first number that is not finite."""
    if isinstance(value, (np.ndarray, np.generic)):
        value = value.tolist()
    if isinstance(value, Mapping):
        for key, each in value.items():
            _refuse_not_finite(f"{where}.{key}" if where else str(key), each)
    elif isinstance(value, (list, tuple)):
        for index, each in enumerate(value):
            _refuse_not_finite(f"{where}[{index}]", each)
    elif isinstance(value, float) and not np.isfinite(value):
        words = ' or a word: "infinite" friction, "rigid" stiffness' if value > 0 else ""
        raise ValueError(f"{where}: {value} given, must be a finite number{words}")


def _with_arrays(value: Any) -> Any:
    """Converts arrays, numbers of numpy and mappings to types that ``json.dumps`` accepts."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if isinstance(value, Mapping):
        return dict(value)
    raise TypeError(f"{type(value).__name__} given, must be numbers, texts, lists, mappings and arrays")


def dumped(value: Any) -> str:
    """JSON text; refuses NaN and infinities, which Python would write as words that JSON does not have."""
    return json.dumps(value, default=_with_arrays, allow_nan=False)
