"""The onset of sliding as a function of JAX: exact factors and gradients of whole batches, on the device of the arrays.

    >>> from grasp_lcp.jax import onset_factor
    >>> jax.grad(lambda points: onset_factor(points, normals, down, friction=0.5, series_stiffness=2e3, pressed_with=8.0).sum())(points)

On a CPU callbacks ask the crate. On an accelerator, and for pads, one program of array operations computes the answer. No other module of the package
imports JAX.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from functools import partial, reduce
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax.custom_derivatives import SymbolicZero

from ._arrays.first_exit import FirstExit
from ._arrays.pads import spread, takes_array_program
from ._arrays.program import UNROLLED, Again, Kind, gradients, onsets
from ._arrays.sites import sum_of
from ._columns import words_of_holds
from ._learning import SECOND, factors, factors_and_gradients, statuses
from .batch import Soft

__all__ = ["onset_factor"]


def onset_factor(
    points: Any,
    normals: Any,
    direction: Any,
    base: Any = None,
    *,
    friction: Any,
    series_stiffness: Any,
    pressed_with: Any = None,
    command_world: Any = None,
    hold: str | Sequence[str] = "unilateral",
    soft: Soft = None,
    native: bool | None = None,
    with_status: bool = False,
) -> Any:
    """The factor of a direction at which the first contact of each grasp stops sticking, as a differentiable function of all arrays.

    It works under ``jax.jit``, ``jax.grad``, ``jax.jvp``, ``jax.jacfwd``, ``jax.vmap`` and ``jax.shard_map``. The parameters are as in
    :func:`grasp_lcp.torch.onset_factor`. The crate computes in double precision, the array program in that of JAX: double with
    ``jax_enable_x64``. In rows without a factor the result is ``inf`` or NaN and all its derivatives are zero. At a kink, where several contacts
    stop sticking together, the derivatives are those of the first of these contacts. Only the array program has second derivatives.

    :param native: ``True`` for the array program, ``False`` for the crate; unless given, the array program on an accelerator.
    :param with_status: return a pair, factors and the :class:`grasp_lcp.OnsetStatus` of each row.
    """
    at = jnp.asarray(points, dtype=float)
    axes, zero = at.shape[-1], _one(at) - 1.0
    inward = _unit(jnp.asarray(normals, dtype=float), zero)
    stiffness = jnp.asarray(series_stiffness, dtype=float)
    if stiffness.ndim == 0 or stiffness.shape[-1] != 2:
        stiffness = jnp.stack([stiffness, stiffness], axis=-1)
    told = jnp.zeros(axes) if command_world is None else jnp.asarray(command_world, dtype=float)
    if pressed_with is not None:
        told = told + (inward * (jnp.asarray(pressed_with, dtype=float) / stiffness[..., 0] + zero)[..., None] + zero)
    mu = jnp.asarray(friction, dtype=float)
    along = _load(jnp.asarray(direction, dtype=float), axes)
    start = jnp.zeros_like(along) if base is None else _load(jnp.asarray(base, dtype=float), axes)
    contacts = jnp.broadcast_shapes(at.shape[:-1], inward.shape[:-1], stiffness.shape[:-1], told.shape[:-1], mu.shape)
    leading = jnp.broadcast_shapes(contacts[:-1], along.shape[:-1], start.shape[:-1])
    each, coordinates = (*leading, contacts[-1]), 3 * (axes - 1)
    data = [
        jnp.broadcast_to(given, shape)
        for given, shape in zip(
            (at, inward, mu, stiffness, told, start, along),
            ((*each, axes), (*each, axes), each, (*each, 2), (*each, axes), (*leading, coordinates), (*leading, coordinates)),
            strict=True,
        )
    ]
    if takes_array_program(native, soft, lambda: _on_an_accelerator(points)):
        data, words = spread(jnp, soft, data, words_of_holds(hold, contacts[-1]))
        kind = Kind(words, base is not None, len(words) > UNROLLED)
        rows = [given.reshape(-1, *given.shape[len(leading) :]) for given in data]
        factor, status, _ = _array_program(kind, *rows)
        factor, status = factor.reshape(leading), status.reshape(leading)
        return (factor, status.astype(jnp.uint8)) if with_status else factor
    held = hold if isinstance(hold, str) else tuple(hold)
    factor = _onset_factor(held, *data)
    return (factor, _status(held, *map(jax.lax.stop_gradient, data))) if with_status else factor


def _on_an_accelerator(points: Any) -> bool:
    if isinstance(points, jax.Array) and not isinstance(points, jax.core.Tracer):
        return any(device.platform != "cpu" for device in points.devices())
    return jax.default_backend() != "cpu"


def _unit(given: Any, zero: Any) -> Any:
    """Unit vectors with finite derivatives. Vectors of zeros and of NaN are returned unchanged. For ``zero`` see :class:`_Rounded`.

    Components have arrays of their own: a compiler may replace the quotient by numbers that are broadcast by a product with their reciprocal.
    """
    known = jnp.isfinite(given).all(axis=-1)
    of = [jnp.where(known, given[..., k], 1.0) for k in range(given.shape[-1])]
    largest = jax.lax.stop_gradient(reduce(jnp.maximum, map(abs, of)))
    scaled = [each / jnp.where(largest > 0, largest, 1.0) + zero for each in of]
    square = sum_of(each * each + zero for each in scaled)
    length = jnp.sqrt(jnp.where(square == 0, 1.0, square)) + zero
    return jnp.stack([jnp.where(known, each / length, jnp.nan) for each in scaled], axis=-1)


def _load(given: Any, axes: int) -> Any:
    coordinates = 3 * (axes - 1)
    if given.ndim and given.shape[-1] == axes:
        return jnp.concatenate([given, jnp.zeros((*given.shape[:-1], coordinates - axes), given.dtype)], axis=-1)
    if given.ndim and given.shape[-1] == coordinates:
        return given
    raise ValueError(f"direction or base: shape {given.shape} given, must end in {axes} of a force or {coordinates} with a moment")


def _call(answer: Any, shapes: Any, data: Any) -> Any:
    """Calls ``answer`` on the CPU, in double precision."""

    def there(*given: Any) -> Any:
        found = answer([np.asarray(each, dtype=np.float64) for each in given])
        return jax.tree.map(lambda each, shape: np.asarray(each, dtype=shape.dtype), found, shapes)

    return jax.pure_callback(there, shapes, *data, vmap_method="broadcast_all")


def _shaped(like: Any, shape: tuple[int, ...]) -> Any:
    return jax.ShapeDtypeStruct(shape, like.dtype)


@partial(jax.custom_jvp, nondiff_argnums=(0,))
def _onset_factor(hold: Any, *data: Any) -> Any:
    return _call(lambda given: factors(given, hold), _shaped(data[0], data[0].shape[:-2]), data)


@partial(jax.custom_jvp, nondiff_argnums=(0,))
def _with_slopes(hold: Any, *data: Any) -> Any:
    shapes = [_shaped(data[0], data[0].shape[:-2]), *(_shaped(each, each.shape) for each in data)]
    return _call(lambda given: factors_and_gradients(given, hold), shapes, data)


@_with_slopes.defjvp
def _refuse(hold: Any, primals: Any, tangents: Any) -> Any:
    raise NotImplementedError(f"grasp_lcp.jax.{SECOND}")


@_onset_factor.defjvp
def _along(hold: Any, primals: Any, tangents: Any) -> Any:
    """The factor and its change along the tangents. The change is linear in the tangents, so that reverse mode can transpose it."""
    found, *slopes = _with_slopes(hold, *primals)
    parts = [(slope * tangent).sum(axis=tuple(range(found.ndim, slope.ndim))) for slope, tangent in zip(slopes, tangents, strict=True)]
    return found, sum(parts)


def _status(hold: Any, *data: Any) -> Any:
    """The status of each row, from the crate."""
    return _call(lambda given: statuses(given, hold), jax.ShapeDtypeStruct(data[0].shape[:-2], jnp.uint8), data)


def _one(points: Any) -> Any:
    """A one whose value the compiler cannot know."""
    size = jnp.max(jnp.abs(jax.lax.stop_gradient(points)), initial=0.0)
    return jnp.maximum(jnp.minimum(jnp.where(size < jnp.inf, size, 0.0), 1.0), 1.0)


class _Rounded:
    """An array whose products, quotients and roots are rounded to floating-point numbers, as the crate rounds them.

    A compiler contracts a product and a sum, and divides once by a product of two denominators. The sum with a zero whose value it cannot know keeps
    them apart. Where it contracts, this costs no operation more: ``a * b + zero`` is contracted instead of the sum of ``a * b`` and the next term.
    """

    def __init__(self, array: Any, zero: Any) -> None:
        self.array, self.zero = array, zero

    def __getattr__(self, name: str) -> Any:
        found = getattr(self.array, name)
        return _of_rows(lambda _, *given, **others: found(*given, **others), self) if callable(found) else found


def _of_rows(function: Callable[..., Any], *first: Any, rounded: bool = False) -> Callable[..., Any]:
    """A function of bare arrays as one of bare or rounded arrays, with its first arguments. Its results are rounded if an argument is."""

    def asked(*given: Any, **others: Any) -> Any:
        given = (*first, *given)
        zero = next((each.zero for each in jax.tree.leaves(given) if isinstance(each, _Rounded)), None)
        found = function(*_bare(given), **others)
        if zero is None:
            return found
        if rounded and jnp.issubdtype(found.dtype, jnp.floating):
            found = found + zero
        return jax.tree.map(lambda each: _Rounded(each, zero), found)

    return asked


def _bare(rows: Any) -> Any:
    """The bare arrays of a tree of bare and rounded ones."""
    return jax.tree.map(lambda each: each.array if isinstance(each, _Rounded) else each, rows)


def _method(function: Callable[..., Any], rounded: bool = False, swapped: bool = False) -> Any:
    asked = _of_rows(function, rounded=rounded)
    return lambda one, *other: asked(*other, one) if swapped else asked(one, *other)


for _name in ("mul", "truediv", "add", "sub", "and_", "or_"):
    _word, _function, _is_rounded = _name.rstrip("_"), getattr(operator, _name), _name in ("mul", "truediv")
    setattr(_Rounded, f"__{_word}__", _method(_function, _is_rounded))
    setattr(_Rounded, f"__r{_word}__", _method(_function, _is_rounded, swapped=True))
for _name in ("lt", "le", "gt", "ge", "eq", "ne", "neg", "abs", "invert", "getitem"):
    setattr(_Rounded, f"__{_name}__", _method(getattr(operator, _name)))


class _Namespace:
    """``jax.numpy`` for bare and rounded arrays, with a function ``kept``, which makes the compiler compute rows only once."""

    def __init__(self, one: Any) -> None:
        self.kept = _of_rows(partial(_kept, one))

    def __getattr__(self, name: str) -> Any:
        return _of_rows(getattr(jnp, name), rounded=name == "sqrt")


def _kept(one: Any, rows: Any) -> Any:
    if jax.default_backend() != "cpu":
        return jax.lax.optimization_barrier(rows)
    # On a CPU the compiler ignores barriers, but never repeats a division.
    return jax.tree.map(lambda row: row / one, rows)


def _rounded(one: Any, data: Sequence[Any]) -> list[Any]:
    """Rounded arrays where operations are compiled together. One by one they are rounded anyway."""
    return [_Rounded(each, one - 1.0) if isinstance(each, jax.core.Tracer) else each for each in data]


@partial(jax.custom_jvp, nondiff_argnums=(0,))
def _array_program(kind: Kind, *data: Any) -> Any:
    """Factors, statuses and contacts that stop sticking, all of one floating-point type: JAX cannot shard derivatives of integers over devices."""
    one = _one(data[0])
    found = _bare(onsets(_Namespace(one), float(jnp.finfo(one.dtype).eps), kind, _rounded(one, data), partial(_among, one)))
    return tuple(each.astype(data[0].dtype) for each in found)


def _change(kind: Kind, primals: Any, tangents: Any) -> Any:
    """The factor and its change along the tangents. Slopes are array operations on the data and the factor, so that they have derivatives."""
    found = FirstExit(*_array_program(kind, *primals))
    slopes = gradients(_Namespace(_one(primals[0])), float(jnp.finfo(primals[0].dtype).eps), kind, list(primals), found)
    change = jnp.zeros_like(found.factor)
    for slope, tangent in zip(slopes, tangents, strict=True):
        if not isinstance(tangent, SymbolicZero):
            change = change + (slope * tangent).sum(axis=tuple(range(1, slope.ndim)))
    nothing = jnp.zeros_like(found.factor)
    return tuple(found), (change, nothing, nothing)


_array_program.defjvp(_change, symbolic_zeros=True)

LOOPS = 16
"""Largest number of rounds in which the thorough pass answers undecided rows; all rounds have the same number of rows."""


def _among(one: Any, is_open: Any, found: list[Any], data: list[Any], again: Again) -> list[Any]:
    is_open, found, data = _bare((is_open, found, data))
    rows = is_open.shape[0]
    each = min(rows, max(64, -(-rows // LOOPS)))

    def round_of(state: Any) -> Any:
        is_open, found = state
        (at,) = jnp.nonzero(is_open, size=each, fill_value=rows)
        answers = _bare(again(_rounded(one, [given.at[at].get(mode="clip") for given in data])))
        found = [whole.at[at].set(part.astype(whole.dtype), mode="drop") for whole, part in zip(found, answers, strict=True)]
        return is_open.at[at].set(False, mode="drop"), found

    return jax.lax.while_loop(lambda state: state[0].any(), round_of, (is_open, found))[1]
