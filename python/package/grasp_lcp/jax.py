"""The onset of sliding as a function of JAX: exact factors and exact gradients of whole batches, by callbacks to the processor.

    >>> from grasp_lcp.jax import onset_factor
    >>> jax.grad(lambda points: onset_factor(points, normals, down, friction=0.5, series_stiffness=2e3, pressed_with=8.0).sum())(points)

No other module of the package imports JAX.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from ._learning import SECOND, factors, factors_and_gradients

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
) -> Any:
    """The factor of a direction at which the first contact of each grasp stops sticking, as a differentiable function of all arrays.

    It works under ``jax.jit``, ``jax.grad``, ``jax.jvp``, ``jax.jacfwd`` and ``jax.vmap``. The parameters are as in
    :func:`grasp_lcp.torch.onset_factor`. The factor is computed in double precision and returned in the precision of JAX: double with
    ``jax_enable_x64``. In rows without a factor the result is ``inf`` or NaN and all its derivatives are zero. At a kink, where several
    contacts leave together, the derivatives belong to the first of these contacts. There are no second derivatives.
    """
    at = jnp.asarray(points, dtype=float)
    axes = at.shape[-1]
    inward = jnp.asarray(normals, dtype=float)
    inward = inward / jnp.linalg.norm(inward, axis=-1, keepdims=True)
    stiffness = jnp.asarray(series_stiffness, dtype=float)
    if stiffness.ndim == 0 or stiffness.shape[-1] != 2:
        stiffness = jnp.stack([stiffness, stiffness], axis=-1)
    told = jnp.zeros(axes) if command_world is None else jnp.asarray(command_world, dtype=float)
    if pressed_with is not None:
        told = told + inward * (jnp.asarray(pressed_with, dtype=float) / stiffness[..., 0])[..., None]
    mu = jnp.asarray(friction, dtype=float)
    along = _load(jnp.asarray(direction, dtype=float), axes)
    start = jnp.zeros_like(along) if base is None else _load(jnp.asarray(base, dtype=float), axes)
    contacts = jnp.broadcast_shapes(at.shape[:-1], inward.shape[:-1], stiffness.shape[:-1], told.shape[:-1], mu.shape)
    leading = jnp.broadcast_shapes(contacts[:-1], along.shape[:-1], start.shape[:-1])
    each, coordinates = (*leading, contacts[-1]), 3 * (axes - 1)
    held = hold if isinstance(hold, str) else tuple(hold)
    return _onset_factor(
        held,
        jnp.broadcast_to(at, (*each, axes)),
        jnp.broadcast_to(inward, (*each, axes)),
        jnp.broadcast_to(mu, each),
        jnp.broadcast_to(stiffness, (*each, 2)),
        jnp.broadcast_to(told, (*each, axes)),
        jnp.broadcast_to(start, (*leading, coordinates)),
        jnp.broadcast_to(along, (*leading, coordinates)),
    )


def _load(given: Any, axes: int) -> Any:
    coordinates = 3 * (axes - 1)
    if given.shape[-1] == axes:
        return jnp.concatenate([given, jnp.zeros((*given.shape[:-1], coordinates - axes), given.dtype)], axis=-1)
    if given.shape[-1] == coordinates:
        return given
    raise ValueError(f"direction or base: shape {given.shape} given, must end in {axes} of a force or {coordinates} with a moment")


def _call(answer: Any, shapes: Any, data: Any) -> Any:
    """Asks on the processor, in double precision."""

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
    """The factor and its change along the tangents, which is linear in them: reverse mode transposes it."""
    found, *slopes = _with_slopes(hold, *primals)
    parts = [(slope * tangent).sum(axis=tuple(range(found.ndim, slope.ndim))) for slope, tangent in zip(slopes, tangents, strict=True)]
    return found, sum(parts)
