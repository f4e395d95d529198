"""The onset of sliding as a layer of PyTorch: exact factors and gradients of whole batches, on the device of the tensors.

    >>> from grasp_lcp.torch import onset_factor
    >>> factor = onset_factor(points, normals, direction, friction=0.5, series_stiffness=[2e3, 1.5e3], pressed_with=8.0)
    >>> factor.sum().backward()

On a CPU the crate computes the answer, on an accelerator one program of array operations. No other module of the package imports PyTorch.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import torch
from torch import Tensor
from torch.autograd import Function

from ._arrays.first_exit import FirstExit
from ._arrays.pads import spread, takes_array_program
from ._arrays.program import Kind, among_rows, gradients, onsets
from ._columns import words_of_holds
from ._learning import SECOND, factors, factors_and_gradients, statuses
from .batch import Soft

__all__ = ["onset_factor"]


def onset_factor(
    points: Tensor,
    normals: Tensor,
    direction: Tensor | Sequence[float],
    base: Tensor | Sequence[float] | None = None,
    *,
    friction: Tensor | Sequence[float] | float,
    series_stiffness: Tensor | Sequence[float] | float,
    pressed_with: Tensor | Sequence[float] | float | None = None,
    command_world: Tensor | Sequence[float] | None = None,
    hold: str | Sequence[str] = "unilateral",
    soft: Soft = None,
    native: bool | None = None,
    with_status: bool = False,
) -> Any:
    """The factor of a direction at which the first contact of each grasp stops sticking, as a differentiable function of all tensors.

    Shapes are as in :func:`grasp_lcp.onsets`. The crate takes grasps of two to five contacts and computes in double precision. The array program
    takes two or more, computes in the precision of ``points``, single at least, and has forward and second derivatives, too. In rows
    without a factor the result is ``inf`` or NaN and all its derivatives are zero; ``torch.where`` removes such rows from a sum. If a motion of
    the object is free, as for two hard fingers in space, the derivatives with respect to points, normals and loads are NaN. At a kink,
    where several contacts stop sticking together, the derivatives are those of the first of these contacts.

    :param points: contact points, m, shape (..., n, 2) or (..., n, 3).
    :param normals: directions into the object, of any length, of the shape of ``points``.
    :param direction: load per unit of the factor, N and N m, shape (..., c) for a force or (..., d) for a force and a moment.
    :param base: load at factor 0, shape (..., c) or (..., d); zero unless given.
    :param series_stiffness: N/m: one number, or (..., 2) normal and tangential.
    :param pressed_with: squeeze forces along the normals, N. Commands change with normals and stiffness so that these forces are constant.
    :param command_world: commands along the coordinate axes, m, in addition to those of ``pressed_with``. They are constant when normals change.
    :param soft: pads in place of the points, as in :func:`grasp_lcp.onsets`, by the array program. Derivatives are with respect to the data of
        whole contacts; a pad turns with the tangents that follow from its normal.
    :param native: ``True`` for the array program, ``False`` for the crate; unless given, the array program for tensors on an accelerator.
    :param with_status: return a pair, factors and the :class:`grasp_lcp.OnsetStatus` of each row.
    """
    if not isinstance(points, Tensor):
        raise TypeError(f"points: {type(points).__name__} given, must be a tensor")
    kind, place = points.dtype if points.is_floating_point() else torch.get_default_dtype(), points.device
    is_native = takes_array_program(native, soft, lambda: place.type != "cpu")
    # The array program has tolerances for single and for double precision.
    of = torch.float32 if is_native and kind != torch.float64 else torch.float64
    there = place if is_native else torch.device("cpu")

    def of_its_kind(given: Any) -> Tensor:
        return given.to(dtype=of, device=there) if isinstance(given, Tensor) else torch.as_tensor(given, dtype=of, device=there)

    at, axes = of_its_kind(points), points.shape[-1]
    inward = _unit(of_its_kind(normals))
    stiffness = of_its_kind(series_stiffness)
    if stiffness.ndim == 0 or stiffness.shape[-1] != 2:
        stiffness = stiffness.unsqueeze(-1).expand(*stiffness.shape, 2)
    told = at.new_zeros(axes) if command_world is None else of_its_kind(command_world)
    if pressed_with is not None:
        told = told + inward * (of_its_kind(pressed_with) / stiffness[..., 0]).unsqueeze(-1)
    mu = of_its_kind(friction)
    contacts = torch.broadcast_shapes(at.shape[:-1], inward.shape[:-1], stiffness.shape[:-1], told.shape[:-1], mu.shape)
    along = _load(of_its_kind(direction), axes)
    start = torch.zeros_like(along) if base is None else _load(of_its_kind(base), axes)
    start, along = torch.broadcast_tensors(start, along)
    data = [
        at.expand(*contacts, axes),
        inward.expand(*contacts, axes),
        mu.expand(contacts),
        stiffness.expand(*contacts, 2),
        told.expand(*contacts, axes),
        start,
        along,
    ]
    if is_native:
        leading, coordinates = torch.broadcast_shapes(contacts[:-1], along.shape[:-1]), along.shape[-1]
        data = [each.expand(*leading, *each.shape[len(contacts) - 1 :]) for each in data[:5]]
        data += [each.expand(*leading, coordinates) for each in (start, along)]
        data, words = spread(torch, soft, data, words_of_holds(hold, contacts[-1]))
        factor, status, _ = _ArrayProgram.apply(Kind(words, base is not None, True), *data)
        factor = factor.to(kind)
        return (factor, status.to(torch.uint8)) if with_status else factor
    factor = _OnsetFactor.apply(hold, *data).to(dtype=kind, device=place)
    if not with_status:
        return factor
    return factor, torch.from_numpy(statuses([each.detach().numpy() for each in data], hold).copy()).to(place)


def _unit(given: Tensor) -> Tensor:
    """Unit vectors with finite derivatives. Vectors of zeros and of NaN are returned unchanged."""
    known = given.isfinite().all(dim=-1, keepdim=True)
    given = torch.where(known, given, torch.ones_like(given))
    largest = given.detach().abs().amax(dim=-1, keepdim=True)
    scaled = given / torch.where(largest > 0, largest, torch.ones_like(largest))
    square = (scaled * scaled).sum(dim=-1, keepdim=True)
    return torch.where(known, scaled / _root(torch.where(square == 0, torch.ones_like(square), square)), torch.full_like(given, torch.nan))


def _root(of: Tensor) -> Tensor:
    """The square root, rounded correctly. On a CPU PyTorch may return a neighbour of the nearest number."""
    root = of.sqrt()
    if of.dtype != torch.float64 or of.device.type != "cpu":
        return root
    near = root.detach()
    # The square in two parts, after Veltkamp and Dekker.
    split = near * (2.0**27 + 1.0)
    high = split - (split - near)
    low = near - high
    square = near * near
    error = ((high * high - square) + 2.0 * high * low) + low * low
    change = ((of.detach() - square) - error) / (2.0 * near)
    return root + torch.where(change.isfinite(), change, 0.0)


class _Namespace:
    """PyTorch with square roots that are rounded correctly."""

    sqrt = staticmethod(_root)

    def __getattr__(self, name: str) -> Any:
        return getattr(torch, name)


def _load(given: Tensor, axes: int) -> Tensor:
    coordinates = 3 * (axes - 1)
    if given.ndim and given.shape[-1] == axes:
        return torch.cat([given, given.new_zeros(*given.shape[:-1], coordinates - axes)], dim=-1)
    if given.ndim and given.shape[-1] == coordinates:
        return given
    raise ValueError(f"direction or base: shape {tuple(given.shape)} given, must end in {axes} of a force or {coordinates} with a moment")


class _OnsetFactor(Function):
    @staticmethod
    def forward(ctx: Any, hold: Any, *data: Tensor) -> Tensor:
        arrays = [each.detach().numpy() for each in data]
        if not any(ctx.needs_input_grad):
            return torch.from_numpy(factors(arrays, hold).copy())
        found, *slopes = [torch.from_numpy(each.copy()) for each in factors_and_gradients(arrays, hold)]
        ctx.save_for_backward(*data, *slopes)
        return found

    @staticmethod
    def backward(ctx: Any, *given: Tensor) -> Any:
        (given_one,) = given
        count = len(ctx.saved_tensors) // 2
        data, slopes = ctx.saved_tensors[:count], ctx.saved_tensors[count:]
        return (None, *(_Slope.apply(given_one, slope, each.shape, *data) for slope, each in zip(slopes, data, strict=True)))


class _Slope(Function):
    """The product of slope and incoming gradient. The data are inputs, so that a second backward pass calls :meth:`backward`, which refuses it."""

    @staticmethod
    def forward(ctx: Any, given: Tensor, slope: Tensor, shape: torch.Size, *data: Tensor) -> Tensor:
        weight = given.reshape(*given.shape, *(1,) * (slope.ndim - given.ndim))
        return (weight * slope).sum_to_size(shape)

    @staticmethod
    def backward(ctx: Any, *given: Tensor) -> Any:
        raise RuntimeError(f"grasp_lcp.torch.{SECOND}")


def _rows(data: Sequence[Tensor]) -> list[Tensor]:
    """The data with all axes of the batch joined to one, one row for each grasp."""
    axes = len(data[0].shape) - 2
    return [each.reshape(-1, *each.shape[axes:]) for each in data]


class _ArrayProgram(Function):
    """Factors, statuses and contacts that stop sticking. Slopes are tensor operations on the data and the factor, so that they have derivatives."""

    @staticmethod
    def forward(kind: Any, *data: Tensor) -> Any:
        found = onsets(_Namespace(), torch.finfo(data[0].dtype).eps, kind, _rows(data), among_rows)
        return tuple(each.reshape(data[0].shape[:-2]) for each in found)

    @staticmethod
    def setup_context(ctx: Any, inputs: Any, output: Any) -> None:
        ctx.kind, *data = inputs
        factor, status, contact = output
        ctx.mark_non_differentiable(status, contact)
        ctx.save_for_backward(*data, factor, contact)
        ctx.save_for_forward(*data, factor, contact)

    @staticmethod
    def backward(ctx: Any, given: Tensor, *_: Any) -> Any:
        slopes = _slopes(ctx.kind, *ctx.saved_tensors)
        weighted = (given.reshape(*given.shape, *(1,) * (each.ndim - given.ndim)) * each for each in slopes)
        return (None, *(each if wanted else None for each, wanted in zip(weighted, ctx.needs_input_grad[1:], strict=True)))

    @staticmethod
    def jvp(ctx: Any, _: Any, *tangents: Tensor | None) -> Any:
        slopes = _slopes(ctx.kind, *ctx.saved_tensors)
        changes = [
            (slope * tangent).flatten(slopes[-1].ndim - 1).sum(dim=-1)
            for slope, tangent in zip(slopes, tangents, strict=True)
            if tangent is not None
        ]
        return sum(changes), None, None

    @staticmethod
    def vmap(info: Any, axes: Any, kind: Any, *data: Tensor) -> Any:
        moved = [
            each.expand(info.batch_size, *each.shape) if axis is None else each.movedim(axis, 0)
            for each, axis in zip(data, axes[1:], strict=True)
        ]
        return _ArrayProgram.apply(kind, *moved), (0, 0, 0)


def _slopes(kind: Any, *saved: Tensor) -> list[Tensor]:
    """The derivatives of the factor with respect to each tensor."""
    *data, factor, contact = saved
    found = FirstExit(factor.reshape(-1), None, contact.reshape(-1))
    slopes = gradients(torch, torch.finfo(factor.dtype).eps, kind, _rows(data), found)
    return [each.reshape(*factor.shape, *each.shape[1:]) for each in slopes]
