"""Measured pushes of a block on three points, in MuJoCo and by the exact limit: error against run time.

    pip install mujoco matplotlib
    python python/examples/mujoco_pushes.py [EVERY]     # prints a table of every EVERYth push, 8 unless said otherwise

A triangular block of 1.518 kg slides on three points of known place (Zhou, Paolini, Bagnell and Mason, ICRA 2016; the file is described in
``tests/support/src/measured_pushes.rs``). Friction of a surface is the median of what its pushes tell. In MuJoCo a push is put on and held for half a
second, and a bisection finds the least one that moves the block by half a millimetre. Its friction creeps: below the limit the block moves, too, and
the less the larger ``impratio``. Inertia delays it: only pushes beyond the limit, by a part that falls with the square of the time, move it so far.
"""

from __future__ import annotations

import csv
import sys
import time
from pathlib import Path

import mujoco  # type: ignore[import-untyped]
import numpy as np
from numpy.typing import NDArray

from grasp_lcp import Grasp

Array = NDArray[np.float64]

DATA = Path(__file__).resolve().parents[2] / "tests" / "support" / "data" / "cmu_three_point_pushes.csv"
# Supports from the right-angled corner, mm; the centre of mass is at (50, 50).
LAYOUTS = {
    "3pts1": [(30, 30), (190 / 3, 130 / 3), (130 / 3, 190 / 3)],
    "3pts2": [(10, 10), (10, 130), (130, 10)],
    "3pts3": [(30, 30), (90, 30), (30, 90)],
    "3pts4": [(10, 10), (90, 30), (10, 130)],
}
MASS, GRAVITY = 1.518, 9.8
# Of a support's round foot, m: small beside the block, so that it touches where it is said to.
FOOT = 0.002
# Seconds in which a push is held, how far the block has moved when it is said to slide (m), and how often the range of pushes is halved: to 0.4 %.
WATCH, MOVED, HALVINGS = 0.5, 5e-4, 8
# Parts of what was predicted that pushes are looked for between.
RANGE = (0.3, 1.3)
# Steps (s) and `impratio` that are compared.
SETTINGS = ((0.002, 1.0), (0.002, 10.0), (0.002, 100.0), (0.0005, 100.0))


def supports(layout: str) -> Array:
    """Where the supports are, m from the centre of mass, shape (3, 2)."""
    return (np.array(LAYOUTS[layout]) - 50.0) * 1e-3


def block(layout: str) -> Grasp:
    """The block with a coefficient of one: the load at which it slides is in proportion to friction."""
    points = np.column_stack([supports(layout), np.zeros(3)])
    return Grasp.spatial(points, [[0, 0, 1]] * 3, series_stiffness=1e6, friction=1.0)


def limit(grasp: Grasp, push: Array) -> float:
    """The part of a measured push at which the block slides, with a coefficient of one."""
    verdict = grasp.hold([push[0], push[1], 0, 0, 0, push[2]], base=[0, 0, -MASS * GRAVITY])
    if verdict.lost is None:
        raise ValueError(str(verdict))
    return verdict.lost


def scene(layout: str, friction: float, step: float, impratio: float) -> mujoco.MjModel:
    """The block on the floor; its centre of mass is at the height of the floor, where the pushes act."""
    feet = "".join(f'<geom type="sphere" size="{FOOT}" pos="{x} {y} {FOOT}" mass="0"/>' for x, y in supports(layout))
    return mujoco.MjModel.from_xml_string(f"""
    <mujoco>
      <option timestep="{step}" cone="elliptic" impratio="{impratio}" gravity="0 0 -{GRAVITY}" tolerance="1e-10"/>
      <default><geom condim="3" friction="{friction}"/></default>
      <worldbody>
        <geom type="plane" size="1 1 0.1"/>
        <body name="block"><freejoint/><inertial pos="0 0 0" mass="{MASS}" diaginertia="0.003 0.003 0.006"/>{feet}</body>
      </worldbody>
    </mujoco>""")


def moves(model: mujoco.MjModel, rest: mujoco.MjData, push: Array, watch: float) -> bool:
    """Whether the block moves under a push that is put on and held for a time, s."""
    data = mujoco.MjData(model)
    data.qpos[:], data.qvel[:] = rest.qpos, rest.qvel
    data.xfrc_applied[model.body("block").id] = [push[0], push[1], 0, 0, 0, push[2]]
    mujoco.mj_step(model, data, round(watch / model.opt.timestep))
    turned = 2.0 * np.arcsin(min(1.0, abs(data.qpos[6])))
    return bool(np.hypot(*(data.qpos[:2] - rest.qpos[:2])) + 0.05 * turned > MOVED)


def slides_at(model: mujoco.MjModel, push: Array, predicted: float, watch: float = WATCH, halvings: int = HALVINGS) -> float:
    """The part of a push at which the block begins to move, by halving."""
    rest = mujoco.MjData(model)
    mujoco.mj_step(model, rest, round(0.2 / model.opt.timestep))
    low, high = (part * predicted for part in RANGE)
    for _ in range(halvings):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if moves(model, rest, middle * push, watch) else (middle, high)
    return 0.5 * (low + high)


def main(every: int) -> None:
    """Prints the table."""
    with DATA.open() as file:
        rows = [row for row in csv.DictReader(file)]
    pushes = [np.array([float(row[name]) for name in ("fx_N", "fy_N", "mz_Nm")]) for row in rows]
    blocks = {layout: block(layout) for layout in LAYOUTS}
    began = time.perf_counter()
    limits = [limit(blocks[row["support"]], push) for row, push in zip(rows, pushes, strict=True)]
    exact_time = (time.perf_counter() - began) / len(rows)
    surfaces = sorted({row["surface"] for row in rows})
    friction = {
        name: float(np.median([1 / each for row, each in zip(rows, limits, strict=True) if row["surface"] == name])) for name in surfaces
    }
    chosen = range(0, len(rows), every)
    exact = np.array([friction[rows[k]["surface"]] * limits[k] for k in chosen])
    print(
        f"{len(chosen)} of {len(rows)} pushes, friction of the surface from all: what is predicted over what was measured, off by, in the median\n"
    )
    print(f"{'':<34}{'from measured':>16}{'from exact':>14}{'a push':>12}")
    print(f"{'exact limit':<34}{100 * np.median(abs(exact - 1)):>14.1f} %{'':>14}{1e3 * exact_time:>9.2f} ms")
    for step, impratio in SETTINGS:
        began = time.perf_counter()
        models = {(surface, layout): scene(layout, friction[surface], step, impratio) for surface in surfaces for layout in LAYOUTS}
        found = np.array(
            [slides_at(models[rows[k]["surface"], rows[k]["support"]], pushes[k], part) for k, part in zip(chosen, exact, strict=True)]
        )
        took = (time.perf_counter() - began) / len(chosen)
        off, beside = (100 * float(np.median(abs(found / scale - 1))) for scale in (1.0, exact))
        name = f"MuJoCo, impratio {impratio:g}, {1e3 * step:g} ms"
        print(f"{name:<34}{off:>14.1f} %{beside:>12.2f} %{1e3 * took:>9.0f} ms")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 8)
