"""Contact forces by the force method, in compliances: of a pair in the plane, and of three contacts in space.

Forces along the edges between contacts are all that balance leaves unknown. They follow from the condition that the object is rigid: distances of
its contact points are constant. The equations are those of ``screening/pair.rs`` and ``screening/triangle.rs``.
"""

from __future__ import annotations

from .factors import Factors
from .forces import Forces
from .sites import Row, Sites, Vector, across, cross, dot, moment, sum_of, sum_of_sizes


class Pair:
    """Two contacts in the plane and the line through them. Lists have one entry for each contact."""

    def __init__(self, sites: Sites) -> None:
        xp, over = sites.xp, sites.over
        self.sites = sites
        (a, b), (m, n) = sites.point, sites.normal
        p = (b[0] - a[0], b[1] - a[1])
        square = dot(p, p)
        lines = [p, (-p[0], -p[1])]
        self.n = [dot(normal, line) for normal, line in zip((m, n), lines, strict=True)]
        self.t = [across(normal, line)[0] for normal, line in zip((m, n), lines, strict=True)]
        self.midpoint = (0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]))
        # A contact without friction has an infinite tangential compliance. The equations are divided by it, which leaves one for this compliance
        # and zero for all others. The pair holds nothing if both contacts are frictionless, or if one is and its normal points along the line.
        slippery = [k_t == 0 for _, k_t in sites.springs]
        some = slippery[0] | slippery[1]
        along = [t * t <= sites.tolerances.dependent * square for t in self.t]
        gives = []
        for slips, (k_n, k_t) in zip(slippery, sites.springs, strict=True):
            gives.append((xp.where(some, 0.0, 1.0 / k_n), xp.where(some, xp.where(slips, 1.0, 0.0), 1.0 / xp.where(slips, 1.0, k_t))))
        u = [c_n * n for (c_n, _), n in zip(gives, self.n, strict=True)]
        v = [c_t * t for (_, c_t), t in zip(gives, self.t, strict=True)]
        give = u[0] * self.n[0] + v[0] * self.t[0] + (u[1] * self.n[1] + v[1] * self.t[1])
        self.is_held = ~((slippery[0] & slippery[1]) | (slippery[0] & along[0]) | (slippery[1] & along[1])) & (square > 0) & (give > 0)
        self.one_over_give, self.one_over_square = over(1.0, give), over(1.0, square)
        self.u, self.v = u, v
        self.sheared = (u[0] * self.t[0] - v[0] * self.n[0]) + (u[1] * self.t[1] - v[1] * self.n[1])
        presses = [xp.where(some, 0.0, pressed) for pressed in sites.pressed]
        shears = [xp.where(some, 0.0, sheared[0]) for sheared in sites.sheared]
        taken = [a * n + s * t for a, s, n, t in zip(presses, shears, self.n, self.t, strict=True)]
        self.commanded = taken[0] + taken[1]
        length = sum_of_sizes(p)
        self.size_of_commands = length * (length * self.one_over_give) * sum_of_sizes((presses[0], shears[0], presses[1], shears[1]))
        scale = 1.0 + length * self.one_over_give * (sum_of_sizes((u[0], v[0])) + sum_of_sizes((u[1], v[1])))
        self.size_of_moment = length * self.one_over_square * scale
        self.size_of_force = self.size_of_moment * sum_of_sizes(self.midpoint) + scale

    def squeezed(self) -> Forces:
        """Forces of the commands without a load. They act along the line through both contacts."""
        force = self.commanded * self.one_over_give
        return self._forces(
            [force * n for n in self.n], [force * t for t in self.t], self.sites.tolerances.on_the_edge * self.size_of_commands
        )  # fmt: skip

    def loaded(self, load: Vector) -> Forces:
        """Forces of a load without commands."""
        s = (load[2] - moment(self.midpoint, load[:2])[0]) * self.one_over_square
        half = (-0.5 * load[0], -0.5 * load[1])
        along = [dot(normal, half) for normal in self.sites.normal]
        aside = [across(normal, half)[0] for normal in self.sites.normal]
        given = [u * a + v * b for u, v, a, b in zip(self.u, self.v, along, aside, strict=True)]
        force = -((s * self.sheared + (given[0] + given[1])) * self.one_over_give)
        size = self.size_of_moment * abs(load[2]) + self.size_of_force * sum_of_sizes(load[:2])
        normal = [force * n + (s * t + a) for n, t, a in zip(self.n, self.t, along, strict=True)]
        tangential = [force * t + (b - s * n) for n, t, b in zip(self.n, self.t, aside, strict=True)]
        return self._forces(normal, tangential, self.sites.tolerances.slack * size)

    def _forces(self, normal: list[Row], tangential: list[Row], rounding: Row) -> Forces:
        nothing = self.sites.xp.zeros_like(normal[0])
        return Forces(normal, [(t,) for t in tangential], [rounding, rounding], nothing, nothing > 0)


class Triangle:
    """Three contacts in space and the edges between them; edge i lies opposite to contact i."""

    def __init__(self, sites: Sites) -> None:
        xp = sites.xp
        self.sites = sites
        points, normals = sites.point, sites.normal
        self.edge = [tuple(b - a for a, b in zip(points[(i + 1) % 3], points[(i + 2) % 3], strict=True)) for i in range(3)]
        self.centre = tuple(sum_of(p) * (1.0 / 3.0) for p in zip(*points, strict=True))
        self.across = cross(self.edge[1], self.edge[2])
        stiff = [(xp.where(k_n > 0, k_n, 1.0), xp.where(k_t > 0, k_t, 1.0)) for k_n, k_t in sites.springs]
        self.gives = [(1.0 / k_n, 1.0 / k_t) for k_n, k_t in stiff]
        self.ends = [dot(normals[i], self.edge[(i + 1) % 3]) for i in range(3)]
        self.begins = [dot(normals[i], self.edge[(i + 2) % 3]) for i in range(3)]
        corner = [dot(self.edge[(i + 1) % 3], self.edge[(i + 2) % 3]) for i in range(3)]
        t: list[list[Row]] = [[None] * 3 for _ in range(3)]
        self.pushed, self.turned = [], []
        for k in range(3):
            tail, head = (k + 1) % 3, (k + 2) % 3
            (n_tail, t_tail), (n_head, t_head), (n_k, t_k) = self.gives[tail], self.gives[head], self.gives[k]
            square = -(corner[tail] + corner[head])
            end, begin = (n_head - t_head) * self.ends[head], (n_tail - t_tail) * self.begins[tail]
            t[k][k] = (t_head + t_tail) * square + (end * self.ends[head] + begin * self.begins[tail])
            t[max(tail, head)][min(tail, head)] = -(t_k * corner[k] + (n_k - t_k) * self.ends[k] * self.begins[k])
            self.pushed.append(t_head - t_tail)
            self.turned.append(t_head * corner[tail] - t_tail * corner[head])
        self.factors = Factors(sites, t)
        square = dot(self.across, self.across)
        self.one_over_square = sites.over(1.0, square)
        self._measure(square)

    def _measure(self, square: Row) -> None:
        """Bounds of rounding errors of forces, and the scenes in which they are small enough for this method; see ``screening/method.rs``."""
        sites, xp = self.sites, self.sites.xp
        length = [sites.length(edge) for edge in self.edge]
        scale: Row = 1.0
        for k in range(3):
            zero = xp.zeros_like(length[0])
            unit = [zero + 1.0 if i == k else zero for i in range(3)]
            along = self.factors.solve(unit)
            given = [sites.larger(c_t, c_n) for c_n, c_t in (self.gives[(k + 1) % 3], self.gives[(k + 2) % 3])]
            given_by = (given[0] + given[1]) * length[k]
            for i in range(3):
                scale = scale + length[i] * abs(along[i]) * given_by
        longest = sites.larger(sites.larger(length[0], length[1]), length[2])
        self.size_of_moment = longest * xp.where(square > 0, xp.sqrt(xp.where(square > 0, self.one_over_square, 1.0)), 0.0) * scale
        self.size_of_force = scale + self.size_of_moment * sum_of_sizes(self.centre)
        stiffness = sum_of([dot(edge, edge) * inverse for edge, inverse in zip(self.edge, self.factors.inverse, strict=True)])
        commands = sum_of_sizes([x for p, s in zip(sites.pressed, sites.sheared, strict=True) for x in (p, *s)])
        self.size_of_commands = stiffness * commands
        every = [c for gives in self.gives for c in gives]
        least, most = every[0], every[0]
        for each in every[1:]:
            least, most = sites.smaller(least, each), sites.larger(most, each)
        has_friction = (sites.springs[0][1] > 0) & (sites.springs[1][1] > 0) & (sites.springs[2][1] > 0)
        is_tame = (self.factors.free == 0) & (self.size_of_moment * longest <= 1e3) & (square > 0)
        self.is_fit = is_tame & has_friction & (most <= 1e3 * least)
        """The scenes whose forces this method finds; in all others the motion of the object is solved for."""

    def squeezed(self) -> Forces:
        """Forces of the commands without a load."""
        sites = self.sites
        taken = self._along_normals(sites.pressed)
        for k in range(3):
            tail, head = sites.sheared[(k + 1) % 3], sites.sheared[(k + 2) % 3]
            taken[k] = sum_of([taken[k], *(e * (b - a) for e, a, b in zip(self.edge[k], tail, head, strict=True))])
        return self._forces(self.factors.solve(taken), None, sites.tolerances.on_the_edge * self.size_of_commands)

    def loaded(self, load: Vector) -> Forces:
        """Forces of a load without commands."""
        share = tuple(x * (-1.0 / 3.0) for x in load[:3])
        turning = tuple(self.one_over_square * (m - a) for m, a in zip(load[3:], cross(self.centre, load[:3]), strict=True))
        twist = 0.5 * dot(self.across, turning)
        borne, pressed, shrunk = [], [], []
        for i in range(3):
            lift = dot(self.edge[i], turning)
            borne.append(tuple(s + (twist * e - lift * m) for s, e, m in zip(share, self.edge[i], self.across, strict=True)))
            pressed.append(dot(self.sites.normal[i], borne[i]))
            shrunk.append((self.gives[i][0] - self.gives[i][1]) * pressed[i])
        taken = self._along_normals(shrunk)
        taken = [-(t + (p * dot(e, share) + r * twist)) for t, p, r, e in zip(taken, self.pushed, self.turned, self.edge, strict=True)]
        size = self.size_of_moment * sum_of_sizes(load[3:]) + self.size_of_force * sum_of_sizes(load[:3])
        return self._forces(self.factors.solve(taken), (borne, pressed), self.sites.tolerances.slack * size)

    def _along_normals(self, way: list[Row]) -> list[Row]:
        """The change of each edge length, times the length, if contact i moves by ``way[i]`` along its normal."""
        return [way[(k + 2) % 3] * self.ends[(k + 2) % 3] - way[(k + 1) % 3] * self.begins[(k + 1) % 3] for k in range(3)]

    def _forces(self, along: list[Row], borne: tuple[list[Vector], list[Row]] | None, rounding: Row) -> Forces:
        """Contact forces: those along the edges plus ``borne``, forces that balance the load with their normal components."""
        normal, tangential = [], []
        unbalanced = self.sites.xp.zeros_like(along[0])
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            pressed = along[j] * self.ends[i] - along[k] * self.begins[i]
            force = [along[j] * a - along[k] * b for a, b in zip(self.edge[j], self.edge[k], strict=True)]
            if borne is not None:
                pressed = pressed + borne[1][i]
                force = [a + b for a, b in zip(force, borne[0][i], strict=True)]
            normal.append(pressed)
            tangential.append(tuple(f - n * pressed for f, n in zip(force, self.sites.normal[i], strict=True)))
            unbalanced = unbalanced + 0.0 * pressed
        return Forces(normal, tangential, [rounding] * 3, unbalanced, unbalanced > 0)
