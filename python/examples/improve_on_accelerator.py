"""A million grasps of a mesh climb to better ones where the arrays are, and the crate certifies a hundred of the best.

    python improve_on_accelerator.py            # a million grasps
    python improve_on_accelerator.py --quick    # two thousand, for a processor

The pear, its three fingers and the climb are those of `improve_grasps.py`: along the derivative of the factor by where the fingers are and how the
surface tilts there, in steps that become shorter, over edges from triangle to triangle. Each step is one program of JAX. On an accelerator factors
and slopes are array operations of it; on a processor the crate computes them. `hold` then asks about the best as single grasps,
under the weight and under all but a thousandth of the load at which the climb says that its first finger slides, until a hundred are certified.
Those that turn too far on the way there are not.
"""

from __future__ import annotations

import argparse
import time
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from improve_grasps import FINGERS, FIRST, LAST, STEPS, WEIGHT, Mesh, pear, random_grasps

from grasp_lcp import Grasp
from grasp_lcp.jax import onset_factor

GRASPS, QUICK = 1_000_000, 2_000
BEST = 100
HOPS = 100  # over edges in one step, at most


class Surface:
    """The mesh on the device, and the steps of grasps along it."""

    def __init__(self, mesh: Mesh, native: bool | None) -> None:
        self.native = native
        self.normals, self.turns, self.weights = (jnp.asarray(each) for each in (mesh.normals, mesh.turns, mesh.weights))
        self.beyond = jnp.asarray(mesh.beyond)

    def put(self, points: Any, faces: Any) -> tuple[Any, Any]:
        """Points moved towards the origin, or away from it, to the surface, and their triangles: found from those given, from edge to edge."""

        def parts(faces: Any) -> Any:
            return jnp.einsum("...ij,...j->...i", self.weights[faces], points)

        def hop(state: Any) -> Any:
            hops, faces, here, _ = state
            astray = here.min(axis=-1) < -1e-12
            faces = jnp.where(astray, self.beyond[faces, here.argmin(axis=-1)], faces)
            return hops + 1, faces, parts(faces), astray.any()

        _, faces, here, _ = jax.lax.while_loop(lambda state: state[3] & (state[0] < HOPS), hop, (0, faces, parts(faces), True))
        return points / here.sum(axis=-1, keepdims=True), faces

    def uphill(self, points: Any, faces: Any) -> tuple[Any, Any]:
        """Factors, and their derivatives along the surface: normals turn with the points."""

        def total(points: Any, normals: Any) -> tuple[Any, Any]:
            factor = onset_factor(points, normals, WEIGHT, native=self.native, **FINGERS)
            factor = jnp.where(jnp.isfinite(factor), factor, 0.0)
            return factor.sum(), factor

        normals = self.normals[faces]
        (by_points, by_normals), factor = jax.grad(total, argnums=(0, 1), has_aux=True)(points, normals)
        along = by_points + jnp.einsum("...jk,...j->...k", self.turns[faces], by_normals)
        return factor, along - (along * normals).sum(axis=-1, keepdims=True) * normals

    def step(self, size: Any, points: Any, faces: Any, best: Any, at: Any, highest: Any) -> tuple[Any, ...]:
        """One step of each grasp. It remembers the best points it has seen; one that has lost its hold begins again from them."""
        factor, along = self.uphill(points, faces)
        better = factor > highest
        best, at = jnp.where(better[:, None, None], points, best), jnp.where(better[:, None], faces, at)
        lost = factor <= 0.0
        points, faces = jnp.where(lost[:, None, None], best, points), jnp.where(lost[:, None], at, faces)
        length = jnp.sqrt((along * along).sum(axis=(1, 2), keepdims=True))
        moved = points + size * along / jnp.maximum(length, 1e-30)
        return (*self.put(moved, faces), best, at, jnp.maximum(factor, highest))


def refusal(mesh: Mesh, points: np.ndarray, faces: np.ndarray, factor: float) -> str | None:
    """What the method of single grasps says if not everything sticks under the weight and up to all but a thousandth of the factor."""
    grasp = Grasp.spatial(points, mesh.normals[faces], **FINGERS)
    for multiple in (1.0, 0.999 * factor):
        verdict = grasp.hold(multiple * WEIGHT)
        if verdict.outcome != "sticks":
            return f"{multiple:.2f} times the weight: {str(verdict).splitlines()[0]}"
    return None


def main() -> None:
    """Prints what the climb brought and how many of the best are certified."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--quick", action="store_true", help="two thousand grasps")
    parser.add_argument("--native", action="store_true", help="array operations on a processor, too")
    given = parser.parse_args()
    grasps = QUICK if given.quick else GRASPS
    jax.config.update("jax_enable_x64", True)
    mesh = pear()
    surface = Surface(mesh, given.native or None)
    points, faces = (jnp.asarray(each) for each in random_grasps(mesh, np.random.default_rng(1), grasps))
    first, _ = jax.jit(surface.uphill)(points, faces)
    state: tuple[Any, ...] = (points, faces, points, faces, jnp.zeros(grasps))
    step = jax.jit(surface.step)
    start = time.perf_counter()
    for size in np.geomspace(FIRST, LAST, STEPS):
        state = step(size, *state)
    *_, best, at, highest = (np.asarray(each) for each in jax.block_until_ready(state))
    seconds = time.perf_counter() - start
    device = jax.devices()[0]
    print(f"{grasps} grasps, {STEPS} steps on {device.device_kind} ({device.platform}): {seconds:.2f} s with the compilation")
    for name, factors in (("before", np.asarray(first)), ("after", highest)):
        low, middle, high = np.percentile(factors, [10, 50, 90])
        print(f"  {name:6} they hold {low:.3f}, {middle:.3f}, {high:.3f} times the weight (a tenth, half, nine tenths of them)")
    start = time.perf_counter()
    certified, refusals = [], []
    for k in np.argsort(-highest):
        refused = refusal(mesh, best[k], at[k], float(highest[k]))
        if refused is None:
            certified.append(highest[k])
        else:
            refusals.append(refused)
        if len(certified) == BEST:
            break
    milliseconds = 1e3 * (time.perf_counter() - start) / (len(certified) + len(refusals))
    print(
        f"the best {len(certified)} that are certified hold {certified[-1]:.4f} to {certified[0]:.4f} times the weight, {milliseconds:.1f} ms each"
    )
    if refusals:
        print(f"  {len(refusals)} were refused, the first of them under {refusals[0]}")


if __name__ == "__main__":
    main()
