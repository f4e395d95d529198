"""The onset of sliding as a layer of PyTorch: exact factors and exact gradients of whole batches, on the processor.

    >>> from grasp_lcp.torch import onset_factor
    >>> factor = onset_factor(points, normals, direction, friction=0.5, series_stiffness=[2e3, 1.5e3], pressed_with=8.0)
    >>> factor.sum().backward()

No other module of the package imports PyTorch.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import torch
from torch import Tensor
from torch.autograd import Function

from ._learning import SECOND, factors, factors_and_gradients

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
) -> Tensor:
    """The factor of a direction at which the first contact of each grasp stops sticking, as a differentiable function of all tensors.

    Shapes are those of :func:`grasp_lcp.onsets`; grasps have two to five contacts. The factor is computed in double precision and returned in
    the type of ``points``. In rows without a factor the result is ``inf`` or NaN and all its derivatives are zero; ``torch.where`` leaves such
    rows out of a sum. At a kink, where several contacts leave together, the derivatives are those of the first of them. There are no second
    derivatives.

    :param points: contact points, m, shape (..., n, 2) or (..., n, 3).
    :param normals: directions into the object, of any length, of the shape of ``points``.
    :param direction: load per unit of the factor, N and N m, shape (..., c) for a force or (..., d) for a force and a moment.
    :param base: load at factor 0, shape (..., c) or (..., d); zero unless given.
    :param series_stiffness: N/m: one number, or (..., 2) normal and tangential.
    :param pressed_with: squeeze forces along the normals, N. Commands change with normals and stiffness so that these forces stay.
    :param command_world: further commands along the coordinate axes, m. They stay when normals change, and add to those of ``pressed_with``.
    """
    kind, place = points.dtype, points.device

    def double(given: Any) -> Tensor:
        return torch.as_tensor(given, dtype=torch.float64, device="cpu") if not isinstance(given, Tensor) else given.cpu().double()

    at, axes = double(points), points.shape[-1]
    inward = double(normals)
    inward = inward / inward.norm(dim=-1, keepdim=True)
    stiffness = double(series_stiffness)
    if stiffness.ndim == 0 or stiffness.shape[-1] != 2:
        stiffness = stiffness.unsqueeze(-1).expand(*stiffness.shape, 2)
    told = torch.zeros(axes, dtype=torch.float64) if command_world is None else double(command_world)
    if pressed_with is not None:
        told = told + inward * (double(pressed_with) / stiffness[..., 0]).unsqueeze(-1)
    mu = double(friction)
    contacts = torch.broadcast_shapes(at.shape[:-1], inward.shape[:-1], stiffness.shape[:-1], told.shape[:-1], mu.shape)
    along = _load(double(direction), axes)
    start = torch.zeros_like(along) if base is None else _load(double(base), axes)
    start, along = torch.broadcast_tensors(start, along)
    found = _OnsetFactor.apply(
        hold,
        at.expand(*contacts, axes),
        inward.expand(*contacts, axes),
        mu.expand(contacts),
        stiffness.expand(*contacts, 2),
        told.expand(*contacts, axes),
        start,
        along,
    )
    return found.to(dtype=kind, device=place)


def _load(given: Tensor, axes: int) -> Tensor:
    coordinates = 3 * (axes - 1)
    if given.shape[-1] == axes:
        return torch.cat([given, given.new_zeros(*given.shape[:-1], coordinates - axes)], dim=-1)
    if given.shape[-1] == coordinates:
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
    """The product of slope and incoming gradient. It takes the data as inputs, so that a second backward pass reaches it and is refused."""

    @staticmethod
    def forward(ctx: Any, given: Tensor, slope: Tensor, shape: torch.Size, *data: Tensor) -> Tensor:
        weight = given.reshape(*given.shape, *(1,) * (slope.ndim - given.ndim))
        return (weight * slope).sum_to_size(shape)

    @staticmethod
    def backward(ctx: Any, *given: Tensor) -> Any:
        raise RuntimeError(f"grasp_lcp.torch.{SECOND}")
