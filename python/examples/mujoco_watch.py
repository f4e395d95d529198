"""A gripper in MuJoCo feels its contact forces a thousand times a second and presses harder before the jar slips.

    pip install mujoco matplotlib
    python python/examples/mujoco_watch.py

The jar of ``mujoco_creep.py`` is filled while three fingers hold it. In each tick the contact forces of the simulation go to the watch of the
grasp, with the load that is to come: it says how much more squeeze that needs, and the fingers are told to press so much more. The same
run with the first squeeze stands beside it.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass

import mujoco  # type: ignore[import-untyped]
import numpy as np
from mujoco_creep import TRAVEL, heights, pull, scene, squeezed
from numpy.typing import NDArray

from grasp_lcp import Grasp
from grasp_lcp.mujoco import Touching, touching

Array = NDArray[np.float64]

# The jar weighs so much before and after it is filled, N, which takes so long, s; then it is watched a while.
EMPTY, FULL, FILLED, AFTER = 3.0, 20.0, 0.8, 0.4
# The watch looks so far ahead, s: the fingers take some milliseconds to press harder. So much of the load, and N, are kept in reserve.
AHEAD, RESERVE = 0.03, 0.1
# So much the squeeze may grow in a tick, in parts of the first one.
FASTEST = 0.01
# What slips so far down its fingers, m, has slipped.
SLIPPED = 1e-3


@dataclass(frozen=True)
class Run:
    """What became of the jar."""

    holds: float
    """What the first squeeze holds until something slides, by the grasp that is read from the simulation, N."""
    slipped: float | None
    """When it had slipped a millimetre, s; None if it never did."""
    load: float
    """The load then, or at the end, N."""
    down: float
    """How far it had slipped in the end, or when a finger lost it, m."""
    lost: bool
    """Whether a finger lost it."""
    press: float
    """What a finger pressed with at the end in the mean, N."""
    margin: float
    """The least margin that was seen, N."""
    ticks: Array
    """How long each look took, s."""


def grasp_of(model: mujoco.MjModel, held: Sequence[Touching]) -> Grasp:
    """The grasp of contacts that were read without a load, with the fingers as springs: a watch knows no joints.

    Along the normal the actuator is in series with the contact, which gives by its depth under its force. Along the tangents MuJoCo's contact is
    no spring but the damper that creeps: here it is rigid, and the finger's joints give alone.
    """
    springs = [float(model.actuator("press0").gainprm[0]), *(float(model.joint(joint).stiffness[0]) for joint in ("across0", "along0"))]
    return Grasp.spatial(
        [touch.point for touch in held],
        [touch.normal for touch in held],
        # The first tangent is level, as the joint `across` is; the second is vertical, as `along` is.
        tangents=[np.cross([0, 0, 1], touch.normal) for touch in held],
        finger_stiffness=springs,
        body_stiffness=[[touch.press / touch.depth, np.inf, np.inf] for touch in held],
        friction=[touch.friction for touch in held],
        pressed_with=[touch.press for touch in held],
    )


def load(when: float) -> float:
    """What the jar weighs at a time, N."""
    part = min(max(when / FILLED, 0.0), 1.0)
    return EMPTY + (FULL - EMPTY) * part * part * (3 - 2 * part)


def run(watched: bool) -> Run:
    """Fills the jar, and presses harder if it is watched."""
    model = scene("elliptic", 1000.0)
    data = squeezed(model)
    grasp = grasp_of(model, touching(model, data, "object"))
    watch, holds = grasp.watch(), grasp.onset([0, 0, -1]).factor or 0.0
    # The empty jar is put down on the fingers first.
    for step in range(1, 301):
        pull(model, data, EMPTY * step / 300)
        mujoco.mj_step(model, data)
    height, tips = heights(model, data)
    begun, squeeze, slipped, down, lost = data.time, 1.0, None, 0.0, False
    margin, press, weight, ticks = np.inf, 0.0, EMPTY, []
    while not lost and data.time - begun < FILLED + AFTER:
        now = data.time - begun
        weight = load(now)
        pull(model, data, weight)
        data.ctrl[:] = TRAVEL * squeeze
        mujoco.mj_step(model, data)
        # The sensors.
        held = touching(model, data, "object")
        lost = len(held) < 3
        if lost:
            break
        forces = np.array([touch.force for touch in held])
        press = float(np.mean([touch.press for touch in held]))
        # The watch: what is planned, and a tenth of the load in reserve.
        to_come = load(now + AHEAD) - weight + RESERVE * weight
        clock = time.perf_counter()
        seen = watch(forces, [0, 0, -to_come])
        ticks.append(time.perf_counter() - clock)
        margin = min(margin, seen.margin)
        if watched:
            squeeze += FASTEST if seen.extra_squeeze is None else min(seen.extra_squeeze, FASTEST)
        now_height, now_tips = heights(model, data)
        down = (height - tips) - (now_height - now_tips)
        if slipped is None and down > SLIPPED:
            slipped = now
    at = weight if slipped is None else load(slipped)
    return Run(holds, slipped, at, down, lost, press, margin, np.array(ticks))


def main() -> None:
    """Prints what becomes of the jar, without a watch and with it."""
    alone, watched = run(False), run(True)
    fate = "is lost" if alone.lost else "slips"
    kept = "nothing slips" if watched.slipped is None else "it slips, too"
    print(f"A jar that is filled to {FULL:g} N {fate} without a watch; with it {kept}.")
    print(f"  what the springs of the fingers say: the first squeeze holds {alone.holds:.3f} N")
    for name, each in (("first squeeze", alone), ("with the watch", watched)):
        when = f"down by 1 mm at {each.slipped:.3f} s under {each.load:.2f} N" if each.slipped is not None else f"holds {each.load:.2f} N"
        end = "lost" if each.lost else f"{each.press:.2f} N a finger in the end"
        print(f"  {name:15} {when}; {1e3 * each.down:.3f} mm down in all, {end}; least margin {each.margin:.3f} N")
    ticks = 1e6 * watched.ticks
    print(f"A look took {np.median(ticks):.1f} µs as a rule and {ticks.max():.1f} µs at most, of {len(ticks)} at 1 kHz.")


if __name__ == "__main__":
    main()
