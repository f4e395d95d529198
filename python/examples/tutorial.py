# %% [markdown]
# # From a mesh's points to a map of onsets
#
# Which of some thousand ways to hold a bottle holds it best? The cells below make a mesh, pick triples of fingers on it, ask one of them
# every question, then all of them the one that matters: at which load does the first finger slide? They end with what an error costs.
#
# Run it as it is, `python python/examples/tutorial.py [FOLDER]`, or cell by cell in an editor that knows `# %%`. Pictures are written to
# `output/`, or to the folder given, or to the one that the environment's GRASP_LCP_OUTPUT names.

# %%
"""From a mesh's points to a map of onsets, a picture, and a table of error against run time."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable
from decimal import Decimal, localcontext
from functools import partial
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm
from numpy.typing import NDArray
from scipy.optimize import bisect  # type: ignore[import-untyped]
from scipy.stats import spearmanr  # type: ignore[import-untyped]

from grasp_lcp import Grasp, Onsets, onsets, wrench

Array = NDArray[np.float64]
# A notebook's kernel has arguments of its own.
given = sys.argv[1] if len(sys.argv) == 2 and "ipykernel" not in sys.modules else None
output = Path(given or os.environ.get("GRASP_LCP_OUTPUT", "output"))
output.mkdir(parents=True, exist_ok=True)
rng = np.random.default_rng(5)

# %% [markdown]
# ## 1. A mesh
#
# A bottle of 16 cm as a surface of revolution about z: rings of vertices, two triangles for each cell. Any mesh will do that comes as
# vertices and triangles. The origin is the middle of the bottle, where its weight acts.

# %%
SEGMENTS = 48
heights = np.linspace(-0.08, 0.08, 33)
radii = 0.014 + 0.020 / (1 + np.exp((heights - 0.035) / 0.008))
angles = 2 * np.pi * np.arange(SEGMENTS) / SEGMENTS
vertices = np.stack(
    [np.outer(radii, np.cos(angles)), np.outer(radii, np.sin(angles)), np.repeat(heights[:, None], SEGMENTS, axis=1)], axis=2
).reshape(-1, 3)

ring, segment = np.meshgrid(np.arange(len(heights) - 1), np.arange(SEGMENTS), indexing="ij")
a, b = ring * SEGMENTS + segment, ring * SEGMENTS + (segment + 1) % SEGMENTS
triangles = np.concatenate([np.stack([a, b, b + SEGMENTS], -1), np.stack([a, b + SEGMENTS, a + SEGMENTS], -1)]).reshape(-1, 3)

corners = vertices[triangles]
outward = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
areas = np.linalg.norm(outward, axis=1) / 2
# Normals of contacts point into the object, the way a finger pushes.
inward = -outward / (2 * areas[:, None])
print(f"A bottle of {len(vertices)} vertices and {len(triangles)} triangles, {areas.sum() * 1e4:.0f} cm²\n")

# %% [markdown]
# ## 2. Candidates
#
# Points spread over the surface, then triples: a thumb and two fingers opposite. Two points are *antipodal* if the line between them lies
# in both friction cones. The thumb must be antipodal to both fingers, and the fingers 15 to 50 mm apart.

# %%
FRICTION = 0.5
SQUEEZE = 10.0  # N, the thumb; the fingers half of it each
WEIGHT = 4.905  # N, half a kilogram
SPRINGS: dict[str, Any] = {"body_stiffness": [5e4, 3e4], "finger_stiffness": [2e3, 1.5e3]}  # N/m, normal and tangential

on = rng.choice(len(triangles), size=700, p=areas / areas.sum())
shares = rng.dirichlet([1.0, 1.0, 1.0], size=len(on))
surface, pushing = np.einsum("pk,pkc->pc", shares, corners[on]), inward[on]

between = surface[None, :] - surface[:, None]
lengths = np.linalg.norm(between, axis=2) + np.eye(len(surface))
steepest = 1 / np.hypot(1, FRICTION)
leaves_in_cone = np.einsum("pqc,pc->pq", between, pushing) > steepest * lengths
antipodal = leaves_in_cone & leaves_in_cone.T

# Pairs come sorted by their thumb, so that a second finger of a thumb is another row of its stretch.
thumb, finger = np.nonzero(antipodal)
of_thumb = np.bincount(thumb, minlength=len(surface))
stretch = np.cumsum(of_thumb) - of_thumb
drawn = rng.integers(len(thumb), size=20_000)
other = finger[stretch[thumb[drawn]] + rng.integers(of_thumb[thumb[drawn]])]
apart = np.linalg.norm(surface[finger[drawn]] - surface[other], axis=1)
triples = np.stack([thumb[drawn], finger[drawn], other], axis=1)[(apart > 0.015) & (apart < 0.05)]
points, normals = surface[triples], pushing[triples]
pressed = np.array([SQUEEZE, SQUEEZE / 2, SQUEEZE / 2])
print(f"{len(thumb)} antipodal pairs of {len(surface)} points, {len(points)} candidates of three fingers\n")

# %% [markdown]
# ## 3. One grasp
#
# A planner asks what contacts *could* hold. The measure ε of Ferrari and Canny is the size of the loads that normal forces of 20 N in all
# could balance in every direction, moments about the middle of the contacts included. So every force of this size through that middle could
# be balanced. The onset asks what *these* fingers do, springs that are pressed with 10, 5 and 5 N. Of the first 200 candidates that hold at
# least a tenth of a newton, here is the one that ε flatters most.


# %%
def grasp_of(candidate: int, **more: Any) -> Grasp:
    """A candidate as a grasp."""
    return Grasp.spatial(
        points[candidate],
        normals[candidate],
        friction=FRICTION,
        pressed_with=pressed,
        names=["thumb", "index", "middle"],
        **SPRINGS,
        **more,
    )


budget = float(pressed.sum())
middles = points.mean(axis=1)
epsilons = np.array([grasp_of(k).quality(budget).epsilon for k in range(200)])
# A grasp that slides while it is squeezed has no size.
least_forces = np.array([grasp_of(k).weakest_direction(at=middles[k]).size or 0.0 for k in range(200)])
flattered = int(np.argmax(np.where(least_forces > 0.1, epsilons / np.maximum(least_forces, 0.1), 0.0)))
grasp, middle = grasp_of(flattered), middles[flattered]
print(repr(grasp))

quality = grasp.quality(budget)
least = grasp.weakest_direction(at=middle)
assert least.size is not None and least.direction is not None
along = wrench(least.direction, at=middle)
print(f"force closure: {quality.force_closure}, ε: {quality.epsilon:.4f} N")
print(f"weakest direction: {least}")
print(f"along it could hold: {grasp.load_limit(along, budget=budget, each=False)}")
print(f"along it does hold: {grasp.onset(along).factor:.12g} N")
print(f"under half of that: {grasp.solve(0.5 * least.size * along).equilibrium}")
print(f"under ε along it: {grasp.solve(quality.epsilon * along).equilibrium}\n")

# %% [markdown]
# Forces that balance ε exist, but these fingers do not press with them: springs know nothing of plans, and one finger slides long before.
# The reverse happens, too: ε counts moments, and a grasp that is weak against a moment may hold a weight well.
#
# ## 4. All of them, in all directions
#
# Points of shape (B, 1, 3, 3) and directions of shape (S, 3) are B S questions. The least factor over the directions is the load that a grasp
# holds however the bottle is turned.


# %%
def sphere(count: int) -> Array:
    """Directions spread evenly over the sphere, in a spiral."""
    height = 1 - (2 * np.arange(count) + 1) / count
    turn = np.pi * (1 + np.sqrt(5)) * np.arange(count)
    return np.stack([np.sqrt(1 - height**2) * np.cos(turn), np.sqrt(1 - height**2) * np.sin(turn), height], axis=1)


def asked(chosen: Any, directions: Array, **more: Any) -> Onsets:
    """Onsets of candidates, all directions for each."""
    return onsets(points[chosen, None], normals[chosen, None], directions, friction=FRICTION, pressed_with=pressed, **SPRINGS, **more)


directions = sphere(200)
start = time.perf_counter()
table = asked(slice(None), directions)
seconds = time.perf_counter() - start
print(f"{table} in {seconds:.2f} s, {table.factor.size / seconds * 1e-6:.0f} million a second")

# Screening leaves open what does not stick when it is squeezed, and what single passes cannot tell; the whole method says more.
left_open = np.flatnonzero(~table.answered.all(axis=1))
told = asked(left_open, directions, complete=True)
print(f"the {len(left_open)} candidates left open: {told}")
worst = table.factor.min(axis=1)
# A grasp that slides while it is squeezed holds nothing for sure.
worst[left_open] = np.where(told.answered.all(axis=1), told.factor.min(axis=1), 0.0)
ranked = np.argsort(-worst)
best = int(ranked[0])
print(f"{np.count_nonzero(worst > WEIGHT)} of {len(worst)} candidates hold {WEIGHT} N however they are turned")
correlation = spearmanr(epsilons, worst[:200]).statistic
print(f"rank correlation of ε and the worst onset, first 200 candidates: {correlation:.2f}\n")

print("candidate   worst of 200 directions (N)   weakest direction (N)       ε (N)")
for k in ranked[:5]:
    print(f"{k:9}{worst[k]:30.3f}{grasp_of(k).weakest_direction().size:24.3f}{grasp_of(k).quality(budget).epsilon:12.3f}")
print()

# %% [markdown]
# ## 5. Pictures
#
# The best grasp's onsets over all directions, and what ε would have said of the first 200. The crate draws the grasp itself: in a notebook an answer
# shows itself, in a script `_repr_svg_` has the text. It is drawn at its onset in the weakest direction.

# %%
azimuths, elevations = np.linspace(-180, 180, 145), np.linspace(-90, 90, 73)
east, north = np.meshgrid(np.radians(azimuths), np.radians(elevations))
everywhere = np.stack([np.cos(north) * np.cos(east), np.cos(north) * np.sin(east), np.sin(north)], axis=2)
held = asked([best], everywhere.reshape(-1, 3)).factor.reshape(east.shape)

figure = plt.figure(figsize=(15, 4.5), layout="constrained")
columns = figure.add_gridspec(1, 3, width_ratios=[0.9, 2, 1])
scene: Any = figure.add_subplot(columns[0], projection="3d")
left, right = (figure.add_subplot(column) for column in (columns[1], columns[2]))
scene.plot_trisurf(*vertices.T, triangles=triangles, color="lightgrey", alpha=0.4, linewidth=0)
scene.quiver(*points[best].T, *normals[best].T, length=0.03, pivot="tip", color="tab:red")
scene.set(title="The best grasp", box_aspect=(0.5, 0.5, 1), xlim=(-0.04, 0.04), ylim=(-0.04, 0.04))
scene.set_axis_off()
shades = left.pcolormesh(azimuths, elevations, held, norm=LogNorm(), cmap="viridis", shading="gouraud", rasterized=True)
levels = [7.5, 8, 9, 10, 12, 15, 20]
figure.colorbar(shades, ax=left, label="onset of sliding, N", ticks=levels, format="%g")
left.clabel(left.contour(azimuths, elevations, held, levels=levels, colors="white", linewidths=0.6), fmt="%g N")
towards = grasp_of(best).weakest_direction().direction
assert towards is not None
left.plot(np.degrees(np.arctan2(towards[1], towards[0])), np.degrees(np.arcsin(towards[2])), "r*", markersize=12)
left.set(
    title="What it holds in every direction; the weakest is the star", xlabel="azimuth of the load, degrees", ylabel="elevation, degrees"
)
right.scatter(epsilons, worst[:200], s=8)
right.set(title="200 candidates", xlabel="ε, N", ylabel="onset of a weight, worst direction, N")
figure.savefig(output / "tutorial_onsets.png", dpi=110)

drawn_at = grasp_of(best).onset(towards)
picture = drawn_at._repr_svg_()
assert picture is not None
(output / "tutorial_grasp.svg").write_text(picture, encoding="utf-8")
drawn_at

# %% [markdown]
# ## 6. What an error costs
#
# The same onset by other means, and a reference that shares nothing with the crate: elastic forces from their definition and the root of
# a quadratic equation, in fifty digits. A finger at p moves by v + ω × p with the object and pushes with f = F n - K (v + ω × p), where K is
# k_n along n and k_t across; the forces balance the load; the finger slides where f leaves the cone, (1 + μ²) (n·f)² = f·f.


# %%
def elastic_forces(candidate: int, direction: Array, number: Callable[[Any], Any]) -> tuple[Any, Any, Any]:
    """Unit normals, forces without a load, and forces that one newton adds, each of shape (3, 3), in the arithmetic of `number`."""
    given = (points[candidate], normals[candidate], direction, pressed, SPRINGS["body_stiffness"], SPRINGS["finger_stiffness"])
    place, normal, along, press, body, finger = (number(np.array(each)) for each in given)
    normal = normal / np.sqrt((normal * normal).sum(axis=1))[:, None]
    k_n, k_t = 1 / (1 / body + 1 / finger)
    unit = np.eye(3, dtype=place.dtype)
    moves = np.concatenate([np.broadcast_to(unit, (3, 3, 3)), np.cross(unit, place[:, None]).transpose(0, 2, 1)], axis=2)
    springs = k_t * unit + (k_n - k_t) * normal[:, :, None] * normal[:, None, :]
    squeeze = press[:, None] * normal
    whole = (moves.transpose(0, 2, 1) @ springs @ moves).sum(axis=0)
    pushed = (moves.transpose(0, 2, 1) @ squeeze[:, :, None]).sum(axis=0)
    loads = np.concatenate([pushed, np.concatenate([along, 0 * along])[:, None]], axis=1)
    # The matrix is positive definite: elimination needs no pivoting.
    for k in range(6):
        shares = whole[k + 1 :, k, None] / whole[k, k]
        whole[k + 1 :], loads[k + 1 :] = whole[k + 1 :] - shares * whole[k], loads[k + 1 :] - shares * loads[k]
    for k in reversed(range(6)):
        loads[k] = (loads[k] - whole[k, k + 1 :] @ loads[k + 1 :]) / whole[k, k]
    answers = springs @ moves @ loads
    return normal, squeeze - answers[:, :, 0], -answers[:, :, 1]


def in_fifty_digits(candidate: int, direction: Array) -> float:
    """The onset from the quadratic equation, rounded at its end; infinite where no finger ever slides."""
    with localcontext(prec=50):
        normal, resting, added = elastic_forces(candidate, direction, np.frompyfunc(lambda x: Decimal(float(x)), 1, 1))

        def cone(f: Any, g: Any) -> Any:
            return (1 + Decimal(FRICTION) ** 2) * (normal * f).sum(axis=1) * (normal * g).sum(axis=1) - (f * g).sum(axis=1)

        # c + 2 b τ + a τ² = 0 with c > 0 at rest: the first positive root is c / (-b + √(b² - a c)).
        factors = []
        for c, b, a in zip(cone(resting, resting), cone(resting, added), cone(added, added), strict=True):
            below = (b * b - a * c).sqrt() - b if b * b > a * c else Decimal(0)
            factors += [c / below] if below > 0 else []
        return float(min(factors, default=Decimal("inf")))


def by_bisection(candidate: int, direction: Array) -> float:
    """The onset by bisection of the least margin of friction, to 1e-12 N."""
    normal, resting, added = elastic_forces(candidate, direction, np.asarray)

    def margin(factor: float) -> float:
        force = resting + factor * added
        pushes = (normal * force).sum(axis=1)
        return float(np.min(FRICTION * pushes - np.linalg.norm(force - pushes[:, None] * normal, axis=1)))

    return float(bisect(margin, 0.0, 1e3, xtol=1e-12))


def timed(ask: Callable[[], Any], questions: int) -> tuple[Any, float]:
    """An answer, and the best time of three, in µs for each question."""
    best_time = float("inf")
    for _ in range(3):
        start = time.perf_counter()
        answer = ask()
        best_time = min(best_time, time.perf_counter() - start)
    return answer, best_time / questions * 1e6


# %% [markdown]
# One direction for all candidates; single calls and the reference for 100 of them that stick when they are squeezed. The polygon in place of
# the round cone is what linear programs and LCPs of friction usually take. Some grasps that stick are outside its cone before any load:
# their onset is 0 then, an error of 1.

# %%
tilted = np.array([0.3, 0.2, -0.9])
sample = np.flatnonzero(worst > 0.1)[:100]
reference = np.array([in_fifty_digits(k, tilted) for k in sample])
rows: list[tuple[str, float, Array]] = []


def one_by_one(made: list[Grasp]) -> Array:
    """Onsets by single calls; 0 where a finger slides already."""
    found = [grasp.onset(tilted) for grasp in made]
    return np.array([0.0 if onset.outcome == "already_sliding" else onset.factor for onset in found], dtype=np.float64)


for name, complete in (("onsets, all candidates", False), ("onsets, complete=True", True)):
    found, cost = timed(partial(asked, slice(None), tilted[None], complete=complete), len(points))
    rows.append((name, cost, found.factor[sample, 0]))

made = [grasp_of(k) for k in sample]
found, cost = timed(partial(one_by_one, made), len(sample))
rows.append(("Grasp.onset, one by one", cost, found))
found, cost = timed(lambda: [by_bisection(k, tilted) for k in sample], len(sample))
rows.append(("numpy and scipy's bisection", cost, np.array(found)))
for facets in (4, 8, 16, 32):
    made = [grasp_of(k, settings={"cone": "polygon", "polygon": {"facets": facets}}) for k in sample]
    found, cost = timed(partial(one_by_one, made), len(sample))
    rows.append((f"polygon of {facets} facets", cost, found))

print("onset of sliding by                  µs a grasp    median error     worst error")
for name, cost, factors in rows:
    errors = np.abs(factors / reference - 1)
    print(f"{name:<32}{cost:>15.2f}{np.median(errors):>16.1e}{errors.max():>16.1e}")

# %%
figure, axes = plt.subplots(figsize=(8, 4), layout="constrained")
for marker, (name, cost, factors) in zip("osD^vPX*", rows, strict=True):
    axes.loglog(cost, np.median(np.abs(factors / reference - 1)), marker, markersize=9, label=name, linestyle="none")
axes.set(title="Onset of sliding of three fingers", xlabel="run time, µs a grasp", ylabel="median relative error")
axes.grid(alpha=0.3)
figure.legend(loc="outside right center", frameon=False)
figure.savefig(output / "tutorial_error.png", dpi=110)
print(f"\npictures: {', '.join(sorted(str(path) for path in output.glob('tutorial_*')))}")
