"""The forces of contacts that all stick, by the displacement method.

First the commands stretch the springs while the object is fixed. Then the object moves by ``q = T⁻¹ w``, with w the unbalanced wrench and
``T = Σ G K Gᵀ`` the stiffness of the object about the centroid of its contacts. A motion that stretches no spring has a pivot that is a rounding
error; its component stays zero.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce
from typing import Any

from .factors import AlongTheLine, Factors
from .sites import Each, Row, Sites, Vector, across, dot, kept, moment, sum_of, sum_of_sizes, turned, world


@dataclass(frozen=True)
class Forces:
    """The forces of all contacts, or their rates per unit of the factor."""

    normal: Each
    tangential: list[Vector]
    rounding: Each
    """A bound on the rounding error of each force."""
    unbalanced: Row
    """The part of the load that the forces leave unbalanced."""
    free: Any
    """The scenes in which the load does work on a motion that no contact resists."""

    def plus(self, others: Forces, rounding: float) -> Forces:
        """The sum of both, with the rounding errors of ``others`` multiplied by ``rounding``."""
        return Forces(
            [a + b for a, b in zip(self.normal, others.normal, strict=True)],
            [tuple(x + y for x, y in zip(a, b, strict=True)) for a, b in zip(self.tangential, others.tangential, strict=True)],
            [a + rounding * b for a, b in zip(self.rounding, others.rounding, strict=True)],
            self.unbalanced + others.unbalanced,
            self.free | others.free,
        )


@dataclass(frozen=True)
class Commands:
    """Commanded displacements along the normals and perpendicular to them."""

    pressed: Each
    sheared: list[Vector]


class Body:
    """The object on the springs of its contacts, its stiffness factorised as ``L D Lᵀ``."""

    def __init__(self, sites: Sites) -> None:
        axes = range(sites.axes)
        self.sites = sites
        self.centre = tuple(sites.total([p[k] * (1.0 / sites.count) for p in sites.point]) for k in axes)
        self.arm = [tuple(p[k] - self.centre[k] for k in axes) for p in sites.point]
        self.reach = reduce(sites.larger, [sites.most([abs(arm[k]) for arm in self.arm]) for k in axes])
        # Two contacts in space resist no rotation about the line between them.
        line = AlongTheLine(sites, sites.point) if (sites.axes, sites.count) == (3, 2) else None
        self.factors = Factors(sites, kept(sites.xp, self._stiffness()), line)
        self.factors.inverse, self.factors.below = kept(sites.xp, (self.factors.inverse, self.factors.below))

    def _stiffness(self) -> list[list[Row]]:
        """The entries of T on and below the diagonal. With one tangential stiffness a contact, ``K = k_t I + (k_n - k_t) n nᵀ``."""
        sites, axes, rows = self.sites, self.sites.axes, range(self.sites.coordinates)
        lines = [(*n, *moment(arm, n)) for n, arm in zip(sites.normal, self.arm, strict=True)]
        more = [k_n - k_t for k_n, k_t in sites.springs]
        shear = [k_t for _, k_t in sites.springs]
        pulled = [tuple(k * a for a in arm) for k, arm in zip(shear, self.arm, strict=True)]
        back = [tuple(-p for p in each) for each in pulled]
        square = [dot(p, arm) for p, arm in zip(pulled, self.arm, strict=True)]
        terms = {(r, c): [[m * line[r] * line[c] for m, line in zip(more, lines, strict=True)]] for r in rows for c in range(r + 1)}
        for k in range(axes):
            terms[k, k].append(shear)
        if axes == 2:
            terms[2, 0].append([p[1] for p in back])
            terms[2, 1].append([p[0] for p in pulled])
            terms[2, 2].append(square)
        for k in range(3 if axes == 3 else 0):
            after, last = (k + 1) % 3, (k + 2) % 3
            terms[3 + k, after].append([p[last] for p in back])
            terms[3 + k, last].append([p[after] for p in pulled])
            terms[3 + k, 3 + k].append(square)
            for other in range(k + 1):
                terms[3 + k, 3 + other].append([p[k] * arm[other] for p, arm in zip(back, self.arm, strict=True)])
        return [[sites.total(*terms[r, c]) for c in range(r + 1)] for r in rows]

    def carried(self, load: Vector) -> Vector:
        """The load with its moment about the centroid of the contacts instead of the origin."""
        axes = self.sites.axes
        about = moment(self.centre, load[:axes])
        return (*load[:axes], *(m - a for m, a in zip(load[axes:], about, strict=True)))

    def displacements(self, q: list[Row]) -> list[Vector]:
        """The displacements of the contacts by a motion of the object."""
        axes = self.sites.axes
        return [tuple(x + t for x, t in zip(q[:axes], turned(q[axes:], arm), strict=True)) for arm in self.arm]

    def unbalanced(self, normal: Each, tangential: list[Vector], load: Vector) -> tuple[list[Row], Row]:
        """The residual of balance of forces and moments, and its size relative to them."""
        sites, axes = self.sites, self.sites.axes
        forces = [world(*each) for each in zip(sites.normal, normal, tangential, strict=True)]
        moments = [moment(arm, force) for arm, force in zip(self.arm, forces, strict=True)]
        left = [sites.total([force[k] for force in forces], start=load[k]) for k in range(axes)]
        left += [sites.total([m[k] for m in moments], start=load[axes + k]) for k in range(len(moments[0]))]
        size = sites.total(*([abs(force[k]) for force in forces] for k in range(axes)), start=sum_of_sizes(load[:axes]))
        turning = sum_of([self.reach * size, *map(abs, load[axes:])])
        worst = reduce(sites.larger, [abs(x) for x in left[:axes]]) / (size + sites.tolerances.tiny)
        worst = worst + reduce(sites.larger, [abs(x) for x in left[axes:]]) / (turning + sites.tolerances.tiny)
        return left, worst + 0.0 * left[0]

    def let_go(self, commands: Commands | None, load: Vector, refined: int) -> tuple[Each, list[Vector], list[Row], Row]:
        """Normal and tangential forces at the equilibrium, the motion of the object, and the unbalanced part of the load.

        If stiffnesses differ by many orders of magnitude, T loses the contribution of soft contacts to rounding. Iterative refinement restores it:
        the residual of balance is solved for again, at most ``refined`` times.
        """
        sites = self.sites
        zero = sites.xp.zeros_like(sites.springs[0][0])
        if commands is None:
            normal, tangential, left = [], [], list(load)
        else:
            normal = [k_n * a for (k_n, _), a in zip(sites.springs, commands.pressed, strict=True)]
            tangential = [tuple(k_t * x for x in s) for (_, k_t), s in zip(sites.springs, commands.sheared, strict=True)]
            left, _ = self.unbalanced(normal, tangential, load)
        moved: list[Row] = []
        for time in range(refined + 1):
            q = kept(sites.xp, self.factors.solve(left))
            moved = [a + b for a, b in zip(moved, q, strict=True)] if moved else q
            stretch = self.displacements(q)
            less_n = [k_n * dot(n, u) for (k_n, _), n, u in zip(sites.springs, sites.normal, stretch, strict=True)]
            less_t = [
                tuple(k_t * x for x in across(n, u)) for (_, k_t), n, u in zip(sites.springs, sites.normal, stretch, strict=True)
            ]  # fmt: skip
            if not normal:
                normal, tangential = [zero - x for x in less_n], [tuple(zero - x for x in t) for t in less_t]
            else:
                normal = [a - b for a, b in zip(normal, less_n, strict=True)]
                tangential = [tuple(x - y for x, y in zip(a, b, strict=True)) for a, b in zip(tangential, less_t, strict=True)]
            normal, tangential = kept(sites.xp, (normal, tangential))
            left, part = self.unbalanced(normal, tangential, load)
            if time < refined:
                improvable = part > sites.tolerances.improvable
                left = [sites.xp.where(improvable, each, 0.0) for each in left]
        return normal, tangential, moved, part

    def sticking(self, commands: Commands | None, load: Vector, refined: int) -> Forces:
        """The forces of commands without a load, or of a load (about the origin) without commands."""
        if commands is None:
            load = self.carried(load)
        normal, tangential, moved, part = self.let_go(commands, load, refined)
        free = (part > self.sites.tolerances.free_motion) & (self.factors.free > 0)
        return Forces(normal, tangential, self._rounding(commands, load, moved, normal, tangential), part, free)

    def _rounding(self, commands: Commands | None, load: Vector, moved: list[Row], normal: Each, tangential: list[Vector]) -> Each:
        """Bounds of rounding errors: a fraction of each force plus a fraction of the force that the total displacement would give its spring.

        The second force is limited by the sum of all forces, since displacements that should cancel leave forces only between several contacts.
        """
        sites, axes = self.sites, self.sites.axes
        span = sum_of_sizes(moved[:axes]) + self.reach * sum_of_sizes(moved[axes:])
        stretched, sizes = [], []
        for i, (k_n, k_t) in enumerate(sites.springs):
            force = sites.larger(k_n, k_t) * span
            if commands is not None:
                force = sum_of([force, k_n * abs(commands.pressed[i]), *(k_t * abs(s) for s in commands.sheared[i])])
            stretched.append(force)
            sizes.append(sum_of_sizes((normal[i], *tangential[i])))
        largest = sites.total(sizes, start=sum_of_sizes(load[:axes])) + sites.second(stretched)
        part = sites.tolerances.slack if commands is None else sites.tolerances.on_the_edge
        return [part * (size + sites.smaller(largest, force)) for size, force in zip(sizes, stretched, strict=True)]
