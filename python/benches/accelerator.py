"""Onsets and gradients as array programs: millions a second on the device at hand, and differences to the crate.

    python python/benches/accelerator.py            # a million scenes a line
    python python/benches/accelerator.py --quick    # small, for a processor in CI
    python python/benches/accelerator.py --compare jax torch    # compares a million grasps with the crate in these, too

Statuses and factors of random and degenerate grasps are compared with those of the crate. The program makes the same operations in the same order,
and each result is rounded, so that statuses agree also where rounding decides, and factors to the last bit.
"""

from __future__ import annotations

import argparse
import importlib.util
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from grasp_lcp import OnsetStatus, onset_gradients, onsets
from grasp_lcp._arrays.program import Kind, among_rows
from grasp_lcp._arrays.program import onsets as array_program

Data = dict[str, np.ndarray]
Answers = Callable[[Data], tuple[np.ndarray, ...]]
"""Type of a function from data to factors and statuses."""

SIZES = [(2, 2), (2, 3), (2, 5), (3, 2), (3, 3), (3, 4), (3, 5)]
"""Numbers of axes and of contacts."""
KINDS = (
    "anywhere", "jar", "loaded", "sheared", "infinite or no friction", "stiff and soft", "slim", "far off", "even", "on the edge",
    "in a row", "coincident", "on a grid", "opposed", "malformed",
)  # fmt: skip


def unit(v: np.ndarray) -> np.ndarray:
    """Unit vectors, as the crate computes them; zeros stay zeros."""
    largest = np.abs(v).max(axis=-1, keepdims=True)
    scaled = v / np.where(largest > 0, largest, 1)
    return scaled / np.where(largest == 0, 1, np.linalg.norm(scaled, axis=-1, keepdims=True))


def grasps(kind: str, axes: int, contacts: int, rows: int, rng: np.random.Generator) -> Data:
    """Grasps of one kind: most stick at rest, and degenerate ones are exactly so."""
    size, shape = 3 * (axes - 1), (rows, contacts)
    outward = unit(rng.normal(size=(*shape, axes)))
    points, normals = 0.05 * outward, unit(-outward + 0.05 * rng.normal(size=outward.shape))
    friction, stiffness = rng.uniform(0.3, 0.9, shape), rng.uniform(500, 3000, (*shape, 2))
    press = rng.uniform(1, 9, shape)
    shear, base = np.zeros_like(points), np.zeros((rows, size))
    arms = np.array([1.0] * axes + [0.02] * (size - axes))
    direction = rng.normal(size=(rows, size)) * arms
    if kind not in ("anywhere", "coincident", "malformed"):
        angles = 2 * np.pi * np.arange(contacts) / contacts + (0 if kind == "even" else rng.uniform(-0.3, 0.3, shape))
        height = [rng.uniform(-0.01, 0.01, shape)] * (axes - 2)
        around = np.broadcast_arrays(0.04 * np.cos(angles), 0.04 * np.sin(angles), np.zeros(shape))[:2]
        points = np.stack([*around, *height], axis=-1)
        tilt = 0 if kind == "even" else rng.normal(0, 0.002, points.shape)
        normals = unit(-points * np.array([1, 1, 0][:axes]) + tilt)
    if kind == "loaded":
        base = 0.3 * rng.normal(size=(rows, size)) * arms
    elif kind == "sheared":
        shear = rng.normal(0, 2e-4, points.shape)
    elif kind == "infinite or no friction":
        friction, base = rng.choice([0, np.inf, 0.5, 0.8], size=shape), 0.1 * direction
    elif kind == "stiff and soft":
        stiffness = 10 ** rng.uniform(0, 9, (*shape, 2))
    elif kind == "slim":
        points[..., 0] *= 10 ** rng.uniform(-9, 0, (rows, 1))
    elif kind == "far off":
        away, strong = 10 ** rng.uniform(-12, 12, (rows, 1)), 10 ** rng.uniform(-12, 12, (rows, 1))
        points, press = points * away[..., None], press * strong
        direction = direction * strong * np.concatenate([np.ones((rows, axes)), np.repeat(away, size - axes, axis=1)], axis=1)
    elif kind == "even":
        friction[:], stiffness[:], press[:], direction[:] = 0.5, [1e3, 8e2], 5.0, 0.0
        direction[:, axes - 1] = -rng.uniform(0.5, 2, rows)
    elif kind in ("on the edge", "on a grid"):
        points = rng.integers(-2, 3, points.shape) / 64
        normals = unit(rng.integers(-1, 2, points.shape).astype(float))
        stiffness[:], press = 1024.0, rng.integers(0, 3, shape).astype(float)
        friction = rng.choice([0, 0.5, 1, np.inf] if kind == "on a grid" else [0.25, 0.5, 1], size=shape)
        direction = np.round(2 * direction)
        if kind == "on the edge":
            aside = np.stack([-normals[..., 1], normals[..., 0], *[0 * friction] * (axes - 2)], axis=-1)
            shear = aside * (press * friction / 1024)[..., None] * rng.choice([0, 0.5, 1], size=(*shape, 1))
    elif kind == "in a row":
        points = np.zeros_like(points)
        points[..., 0], normals = np.linspace(-0.04, 0.04, contacts), np.zeros_like(normals)
        normals[..., 1] = np.where(np.arange(contacts) % 2 == 0, 1, -1)
    elif kind == "coincident":
        points[:, 1] = points[:, 0]
    elif kind == "opposed":
        # The load acts on the line between two contacts, or turns the object about it by a little.
        points[:, :2], normals[:, :2] = 0, 0
        points[:, 0, 0], points[:, 1, 0], normals[:, 0, 0], normals[:, 1, 0] = -0.04, 0.04, 1, -1
        turn = np.linalg.qr(rng.normal(size=(rows, axes, axes)))[0]
        away = 0.1 * rng.normal(size=(rows, 1, axes))
        points, normals = np.einsum("bij,bnj->bni", turn, points) + away, np.einsum("bij,bnj->bni", turn, normals)
        force = rng.normal(size=(rows, axes))
        moment = np.cross(away[:, 0], force) if axes == 3 else (away[:, 0, :1] * force[:, 1:] - away[:, 0, 1:] * force[:, :1])
        direction = np.concatenate([force, moment], axis=1)
        if axes == 3:
            twist = 10 ** rng.uniform(-16, -4, (rows, 1)) * rng.choice([0, 1], size=(rows, 1))
            direction[:, 3:] += twist * unit(points[:, 1] - points[:, 0])
    elif kind == "malformed":
        which, contact = rng.integers(0, 12, rows), rng.integers(0, contacts, rows)
        wrong: list[tuple[np.ndarray, float]] = [(points, np.nan), (points, 1e60), (normals, np.nan), (friction, -1), (friction, np.nan)]
        wrong += [(stiffness, 0), (stiffness, -1), (stiffness, np.nan), (direction, np.nan)]
        for number, (array, value) in enumerate(wrong):
            at = np.flatnonzero(which == number)
            array[(at, contact[at], *[1] * (array.ndim - 2)) if array is not direction else (at, 1)] = value
        normals[np.flatnonzero(which == 9), 0], direction[which == 10] = 0, 0
        friction[rng.random(rows) < 0.1, 0] = -1
    safe = np.where(stiffness[..., 0] > 0, stiffness[..., 0], 1)
    command = normals * (press / safe)[..., None] + shear
    return {
        "points": points, "normals": normals, "friction": friction, "series_stiffness": stiffness,
        "command_world": command, "base": base, "direction": direction,
    }  # fmt: skip


def in_numpy(data: Data) -> tuple[np.ndarray, np.ndarray]:
    """Factors and statuses by the array program, in numpy."""
    kind = Kind(("unilateral",) * data["points"].shape[1], bool(data["base"].any()), False)
    with np.errstate(all="ignore"):
        given = data | {"normals": unit(data["normals"])}
        found = array_program(np, float(np.finfo(np.float64).eps), kind, [each.copy() for each in given.values()], among_rows)
    return found.factor, found.status


def precision_of(jax: Any) -> Any:
    """The context of a precision, which older versions of JAX keep elsewhere."""
    return jax.enable_x64 if hasattr(jax, "enable_x64") else jax.experimental.enable_x64


def in_jax(axes: int, contacts: int) -> Answers:
    """The array program in JAX, compiled as a whole."""
    import jax

    from grasp_lcp.jax import onset_factor

    asked = jax.jit(lambda given: onset_factor(**given, native=True, with_status=True))

    def in_double(data: Data) -> Any:
        with precision_of(jax)(True):
            return tuple(np.asarray(each) for each in asked(data))

    return in_double


def in_torch(axes: int, contacts: int) -> Answers:
    """The array program in PyTorch."""
    import torch

    from grasp_lcp.torch import onset_factor

    place = "cuda" if torch.cuda.is_available() else "cpu"

    def asked(data: Data) -> Any:
        with torch.no_grad():
            found = onset_factor(
                **{name: torch.as_tensor(each, device=place) for name, each in data.items()}, native=True, with_status=True
            )
        return tuple(each.cpu().numpy() for each in found)

    return asked


ANSWERS_IN: dict[str, Callable[[int, int], Answers]] = {"numpy": lambda axes, contacts: in_numpy, "jax": in_jax, "torch": in_torch}
"""The program that answers grasps of one number of axes and contacts."""


@dataclass
class Differences:
    """How answers of the array program differ from those of the crate."""

    rows: int = 0
    statuses: int = 0
    """Rows with another status."""
    factors: int = 0
    """Rows with a finite factor from both."""
    bits: int = 0
    """Factors that differ in some bit."""
    far: int = 0
    """Factors that differ by more than 1e-12 of their size."""

    def add(self, others: Differences) -> None:
        """Counts them, too."""
        for name in ("rows", "statuses", "factors", "bits", "far"):
            setattr(self, name, getattr(self, name) + getattr(others, name))


def compared(data: Data, answers: Answers | None = None) -> Differences:
    """The differences for grasps with these data, in numpy unless other answers are given."""
    factor, status = (answers or in_numpy)(data)
    asked = onsets(**data)
    both = (status == OnsetStatus.LEAVES) & (asked.status == OnsetStatus.LEAVES)
    bits = both & (factor != asked.factor)
    far = np.abs(factor[both] - asked.factor[both]) > 1e-12 * asked.factor[both]
    return Differences(len(factor), int((status != asked.status).sum()), int(both.sum()), int(bits.sum()), int(far.sum()))


def print_differences(rows: int, name: str = "numpy") -> Differences:
    """A line for each number of contacts, with ``rows`` grasps of each kind."""
    total = Differences()
    print(f"differences of the array program, in {name}, to the crate")
    for axes, contacts in SIZES:
        here, answers = Differences(), ANSWERS_IN[name](axes, contacts)
        for number, kind in enumerate(KINDS):
            rng = np.random.default_rng([axes, contacts, number])
            here.add(compared(grasps(kind, axes, contacts, rows, rng), answers))
        total.add(here)
        print(f"  {contacts} contacts in {'plane' if axes == 2 else 'space'}: {_shown(here)}", flush=True)
    print(f"  all: {_shown(total)}", flush=True)
    return total


def _shown(d: Differences) -> str:
    return f"{d.rows} grasps, {d.statuses} statuses differ; {d.factors} factors, {d.far} differ by more than 1e-12, {d.bits} differ in some bit"


def best_of(run: Callable[[], Any], times: int) -> float:
    """The best time, s, after a first run."""
    run()
    taken = []
    for _ in range(times):
        start = time.perf_counter()
        run()
        taken.append(time.perf_counter() - start)
    return min(taken)


def paced_by_jax(rows: int, sizes: list[int], times: int) -> None:
    """Millions a second with scenes along the last axis of the arrays, and the largest difference of a factor to the crate."""
    import jax
    import jax.numpy as jnp

    from grasp_lcp.jax import onset_factor

    in_precision = precision_of(jax)
    jax.config.update("jax_enable_x64", True)
    device = jax.devices()[0]
    print(f"JAX {jax.__version__} on {device.device_kind} ({device.platform}), {rows} grasps in space")
    for contacts in sizes:
        data = grasps("jar", 3, contacts, rows, np.random.default_rng(1))
        expected = onsets(**data)
        for dtype in (np.float64, np.float32):
            with in_precision(dtype == np.float64):
                given = [jnp.asarray(np.moveaxis(each, 0, -1), dtype) for each in data.values()]

                def asked(*given: Any) -> Any:
                    points, normals, friction, stiffness, command, _, direction = (jnp.moveaxis(each, -1, 0) for each in given)
                    return onset_factor(
                        points, normals, direction, friction=friction, series_stiffness=stiffness, command_world=command, native=True
                    )  # fmt: skip

                def total(*given: Any) -> Any:
                    factor = asked(*given)
                    return jnp.where(jnp.isfinite(factor), factor, 0).sum()

                onset, gradient = jax.jit(asked), jax.jit(jax.grad(total, argnums=(0, 1)))
                start = time.perf_counter()
                factor = np.asarray(jax.block_until_ready(onset(*given)))
                first = time.perf_counter() - start
                paces = [best_of(lambda f=f, given=given: jax.block_until_ready(f(*given)), times) for f in (onset, gradient)]
            print(_pace(contacts, dtype, rows, paces, factor, expected.factor) + f", compiled in {first:.1f} s", flush=True)


def paced_by_torch(rows: int, sizes: list[int], times: int) -> None:
    """The same in PyTorch, operation by operation."""
    import torch

    from grasp_lcp.torch import onset_factor

    place = "cuda" if torch.cuda.is_available() else "cpu"
    name = torch.cuda.get_device_name() if place == "cuda" else place
    print(f"PyTorch {torch.__version__} on {name}, {rows} grasps in space")
    for contacts in sizes:
        data = grasps("jar", 3, contacts, rows, np.random.default_rng(1))
        expected = onsets(**data)
        for dtype in (torch.float64, torch.float32):
            given = {each: torch.as_tensor(value, dtype=dtype, device=place) for each, value in data.items() if each != "base"}
            leaves = [given["points"].requires_grad_(), given["normals"].requires_grad_()]

            def onset(given: Any = given) -> Any:
                with torch.no_grad():
                    found = onset_factor(**given, native=True)
                return found.cpu()

            def gradient(given: Any = given, leaves: Any = leaves) -> Any:
                factor = onset_factor(**given, native=True)
                slopes = torch.autograd.grad(torch.where(factor.isfinite(), factor, torch.zeros_like(factor)).sum(), leaves)
                return [each.flatten()[0].item() for each in slopes]

            paces = [best_of(run, times) for run in (onset, gradient)]
            print(_pace(contacts, np.dtype(str(dtype)[6:]), rows, paces, onset().numpy(), expected.factor), flush=True)


def _pace(contacts: int, dtype: Any, rows: int, seconds: list[float], factor: np.ndarray, expected: np.ndarray) -> str:
    both = np.isfinite(factor) & np.isfinite(expected)
    off = np.abs(factor[both] / expected[both] - 1)
    onset, gradient = (rows / each * 1e-6 for each in seconds)
    return (
        f"  {contacts} contacts, {np.dtype(dtype).name}: {onset:.3g} million onsets a second, {gradient:.3g} million gradients; factors off by "
        f"{np.median(off):.0e} in the median, {off.max(initial=0):.0e} at most"
    )


def main() -> None:
    """Prints the report."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--quick", action="store_true", help="few grasps of three contacts")
    parser.add_argument("--rows", type=int, help="grasps of each line of throughput")
    parser.add_argument("--compare", nargs="+", choices=ANSWERS_IN, help="only print differences to the crate, in these")
    given = parser.parse_args()
    if given.compare:
        for name in given.compare:
            print_differences(-(-(given.rows or 1_000_000) // (len(SIZES) * len(KINDS))), name)
        return
    sizes, rows = ([3], 20_000) if given.quick else ([3, 5], 1_000_000)
    rows = given.rows or rows
    print_differences(500 if given.quick else 10_000)
    data = grasps("jar", 3, 3, rows, np.random.default_rng(1))
    crate = [rows / best_of(lambda of=of: of(**data), 3) * 1e-6 for of in (onsets, onset_gradients)]
    print(f"the crate on the processor, 3 contacts, a load each: {crate[0]:.3g} million onsets a second, {crate[1]:.3g} million gradients")
    for name, paced in (("jax", paced_by_jax), ("torch", paced_by_torch)):
        if importlib.util.find_spec(name) is None:
            print(f"{name} is not installed: not measured")
        else:
            paced(rows, sizes, 2 if given.quick else 7)


if __name__ == "__main__":
    main()
