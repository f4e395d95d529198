"""The factor at which forces that change in proportion to the load leave their friction cones, and the status of each scene.

The equations, and the bounds beyond which rounding errors make an answer unclear, are those of ``screening/cone.rs`` and ``screening/first_exit.rs``.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from .forces import Forces
from .sites import Row, Sites, cross, dot, sum_of

LEAVES, NEVER, NOT_STICKING, GIVES_WAY, UNCLEAR, NOT_A_NUMBER, MALFORMED = 0, 1, 2, 3, 4, 7, 8
"""Numbers of :class:`grasp_lcp.OnsetStatus`."""


class FirstExit(NamedTuple):
    """The first contact of each scene to stop sticking."""

    factor: Row
    """The factor at first slip: infinite if no contact ever stops sticking, NaN if unknown."""
    status: Any
    contact: Any
    """The index of the first contact that stops sticking, -1 if there is none."""


def first_exit(sites: Sites, base: Forces, rates: Forces) -> FirstExit:
    """The first exit, from the forces at factor zero and their rates per unit of the factor."""
    xp, tolerances = sites.xp, sites.tolerances
    factors, margins, sures, all_lost = [], [], [], []
    for i, mu in enumerate(sites.friction):
        exit = _exit_in_plane if sites.axes == 2 else _exit_in_space
        alpha, beta = abs(mu), xp.where(mu > 0, 1.0, 0.0)
        weight = alpha + beta
        noise = weight * rates.rounding[i]
        force = (alpha * base.normal[i], tuple(beta * t for t in base.tangential[i]))
        rate = (alpha * rates.normal[i], tuple(beta * t for t in rates.tangential[i]))
        factor, margin, lost = exit(sites, force, rate, noise)
        factors.append(factor)
        # A contact whose squares overflow or underflow decides nothing. Another contact may still clearly not stick.
        margins.append(xp.where(lost, float("inf"), margin))
        sures.append(xp.where(lost, float("inf"), margin - weight * base.rounding[i]))
        all_lost.append(xp.where(lost, 1.0, 0.0))
    first, margin, sure = sites.least(factors), sites.least(margins), sites.least(sures)
    status = xp.where(first < float("inf"), LEAVES, NEVER)
    is_sure = (first > 0) & (sure >= 0) & (sites.most(all_lost) == 0) & (base.unbalanced + rates.unbalanced < tolerances.solved)
    status = xp.where(is_sure, status, UNCLEAR)
    status = xp.where(rates.free, GIVES_WAY, status)
    # The rounding error of the least margin is at most `margin - sure`.
    status = xp.where(sure - margin > margin, NOT_STICKING, status)
    status = xp.where(base.free, GIVES_WAY, status)
    until = (1.0 + tolerances.solved) * first
    leaving = sites.least([xp.where(factor > until, sites.count, number) for factor, number in zip(factors, sites.number, strict=True)])
    leaves = status == LEAVES
    factor = xp.where(leaves, first, xp.where(status == NEVER, float("inf"), float("nan")))
    return FirstExit(factor, status, xp.where(leaves, leaving, -1))


def _known(sites: Sites, factor: Row, closing: Row, noise: Row) -> Row:
    """The factor; infinite if the margin closes no faster than its rounding error, and negative, that is unclear, unless it closes much faster."""
    factor = sites.xp.where(closing > sites.tolerances.sharp * noise, factor, -3.0)
    return sites.xp.where(closing > noise, factor, float("inf"))


def _ratio(sites: Sites, a: Row, b: Row) -> Row:
    is_zero = b == 0
    return sites.xp.where(is_zero, float("inf"), a / sites.xp.where(is_zero, 1.0, b))


def _exit_in_plane(sites: Sites, force: Any, rate: Any, noise: Row) -> tuple[Row, Row, Any]:
    """The exit in the plane, where the margin is the smaller of two linear functions of the factor."""
    (n, (t,)), (dn, (dt,)) = force, rate
    one, two = n - t, n + t
    closing_one, closing_two = dt - dn, -(dt + dn)
    factor = sites.smaller(
        _known(sites, _ratio(sites, one, closing_one), closing_one, noise),
        _known(sites, _ratio(sites, two, closing_two), closing_two, noise),
    )
    return factor, sites.smaller(one, two), n != n


def _exit_in_space(sites: Sites, force: Any, rate: Any, noise: Row) -> tuple[Row, Row, Any]:
    """The root of ``c + 2 b τ - a τ² = 0`` at which the force, linear in τ, leaves the cone; see ``screening/cone.rs``."""
    xp, tolerances = sites.xp, sites.tolerances
    (n, t), (dn, dt) = force, rate
    friction, friction_rate = sites.length(t), sites.length(dt)
    margin, closing = n - friction, friction_rate - dn
    a, b, c = closing * (friction_rate + dn), n * dn - dot(t, dt), margin * (n + friction)
    turn = [n * y - dn * x for x, y in zip(t, dt, strict=True)]
    twist = cross(t, dt)
    gap = sum_of(x * x - y * y for x, y in zip(turn, twist, strict=True))
    root = xp.where(gap > 0, xp.sqrt(xp.where(gap > 0, gap, 1.0)), 0.0)
    # Of the two equivalent forms of the root, the one without cancellation.
    last = _ratio(sites, xp.where(b > 0, root + b, c), xp.where(b > 0, a, root - b))
    product = (abs(n) + friction) * (abs(dn) + friction_rate)
    in_range = (product > tolerances.least_product) & ~(product > tolerances.most_product)
    return _known(sites, last, closing, noise), margin, (closing > noise) & ~in_range
