"""Derivatives of the factor with respect to all data, in closed form from one adjoint solve; see ``screening/gradient.rs``.

At the factor the margin m of the contact that stops sticking vanishes, so that ``dτ = -dm / m'``. All derivatives follow from the forces F and the
motion (u, ω) at the onset, and from the forces P and the motion (v, ω̄) with ∂m/∂F of that contact as the only command. They are written in array
operations of the data and the factor, so that they can be differentiated in turn.
"""

from __future__ import annotations

from typing import Any

from .forces import Body, Commands
from .onset import Scenes
from .sites import Row, Vector, cross, dot, kept, moment, sum_of_sizes, turned, world


def slopes(scenes: Scenes, factor: Row, contact: Any, refined: int) -> list[Any]:
    """Derivatives with respect to points, unit normals, friction, stiffness, commands along the coordinate axes and base load.

    They are zero in scenes where no contact leaves, and NaN by points, normals and loads where a motion of the object is free.
    """
    sites, xp = scenes.sites, scenes.xp
    axes, body = sites.axes, Body(sites)
    leaves = contact >= 0
    reached = xp.where(leaves, factor, 0.0)
    load = tuple(b + reached * d for b, d in zip(scenes.base, scenes.direction, strict=True))
    commands = Commands(sites.pressed, sites.sheared)
    normal, tangential, moved, _ = body.let_go(commands, body.carried(load), refined)
    here = [number == contact for number in sites.number]
    mu = sites.chosen(here, sites.friction)
    alpha, beta = abs(mu), xp.where(mu > 0, 1.0, 0.0)
    friction = [sites.chosen(here, [t[k] for t in tangential]) for k in range(len(tangential[0]))]
    stretch = body.displacements(moved)
    # Sizes of the terms whose sum is a contact force.
    terms = [
        k_n * (abs(a) + sum_of_sizes(u)) + k_t * (sum_of_sizes(s) + sum_of_sizes(u))
        for (k_n, k_t), a, s, u in zip(sites.springs, sites.pressed, sites.sheared, stretch, strict=True)
    ]
    slides = sites.length(friction)
    apart = slides > sites.tolerances.negligible * sites.chosen(here, terms)
    sliding = [xp.where(apart, -beta * t / xp.where(apart, slides, 1.0), 0.0) for t in friction]
    alpha, sliding = kept(xp, (alpha, sliding))
    probe = Commands(
        [xp.where(at, alpha, 0.0) for at in here], [tuple(xp.where(at, t, 0.0) for t in sliding) for at in here]
    )  # fmt: skip
    nothing = tuple(xp.zeros_like(each) for each in moved)
    answered, aside, virtual, _ = body.let_go(probe, nothing, refined)
    # The rate of the margin is the virtual work of the load's direction on the motion (v, ω̄).
    scale = sites.over(1.0, dot(virtual, body.carried(scenes.direction)))
    virtual = kept(xp, [scale * each for each in virtual])
    answered, aside = kept(xp, ([scale * p for p in answered], [tuple(scale * t for t in each) for each in aside]))
    turn, virtual_turn = moved[axes:], virtual[axes:]
    points, normals, springs, by_friction, by_command = [], [], [], [], []
    displaced = zip(stretch, body.displacements(virtual), strict=True)
    for i, (u, v) in enumerate(displaced):
        n, (k_n, k_t) = sites.normal[i], sites.springs[i]
        force, reply, u, v = kept(xp, (world(n, normal[i], tangential[i]), world(n, answered[i], aside[i]), u, v))
        points.append(tuple(a + b for a, b in zip(turned(virtual_turn, force), turned(turn, reply), strict=True)))
        tilt = _tilt(n, [a + b for a, b in zip(moment(v, force), moment(u, reply), strict=True)])
        # Commands along the coordinate axes are constant while the normal tilts.
        command = scenes.command[i]
        along, pressed = dot(command, n), dot(reply, n)
        normals.append(tuple(t - (r * along - a * pressed) for t, r, a in zip(tilt, reply, command, strict=True)))
        across_both = dot(tangential[i], aside[i])
        springs.append((sites.over(normal[i] * answered[i], k_n * k_n), sites.over(across_both, k_t * k_t)))
        by_friction.append(xp.where(here[i], scale * beta * normal[i], 0.0))
        by_command.append(reply)
    at_origin = [v - t for v, t in zip(virtual[:axes], turned(virtual_turn, body.centre), strict=True)]
    is_free = body.factors.free > 0

    def shown(rows: list[Any], free: bool) -> list[Any]:
        found: list[Any] = kept(xp, [xp.where(leaves, xp.where(is_free, float("nan"), row) if free else row, 0.0) for row in rows])
        return found

    def vectors(rows: list[Vector], free: bool) -> Any:
        size = len(rows[0])
        flat = shown([x for row in rows for x in row], free)
        each = [xp.stack(flat[i : i + size], axis=-1) for i in range(0, len(flat), size)]
        return xp.moveaxis(each[0], 0, -2) if sites.stacked else xp.stack(each, axis=-2)

    rows = shown(by_friction, False)
    return [
        vectors(points, True),
        vectors(normals, True),
        xp.moveaxis(rows[0], 0, -1) if sites.stacked else xp.stack(rows, axis=-1),
        vectors(springs, False),
        vectors(by_command, False),
        xp.stack(shown([-x for x in (*at_origin, *virtual_turn)], True), axis=-1),
    ]


def _tilt(normal: Vector, moments: list[Row]) -> Vector:
    """The derivative with respect to a normal, from that with respect to a rotation of its contact frame."""
    if len(normal) == 2:
        return (-moments[0] * normal[1], moments[0] * normal[0])
    return cross(moments, normal)
