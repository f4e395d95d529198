"""At which load does a grasp in MuJoCo slide? Its contacts are asked here, and its object is watched as it creeps.

    pip install mujoco matplotlib
    python python/examples/mujoco_creep.py          # prints a table, writes output/mujoco_creep.svg

A jar hangs between three round fingertips that position actuators press on it. In MuJoCo friction is a damper: below the friction limit
a contact slips with a speed in proportion to the force that it carries, so that an object that is held sinks for ever. Users ask about
it in https://github.com/google-deepmind/mujoco/issues/3328. The motion in the simulator does not say whether the grasp holds, or how far
the load is from its limit. The contacts of the simulator do: they are read once, and grasp-lcp finds the load at which Coulomb's
friction gives way. Below it the jar rests, and the springs of the fingers say where.

MuJoCo's option ``impratio`` divides the creep on the elliptic cone. With a large one a bisection finds the load at which MuJoCo's own
friction gives way. Beyond it the jar does not drop freely there: slip drives the fingertips outwards, and they press more.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import mujoco  # type: ignore[import-untyped]
from matplotlib.figure import Figure

from grasp_lcp import Grasp, Solution
from grasp_lcp.mujoco import touching

# Friction cones and values of `impratio` that are compared; the last is the sharpest.
SETTINGS = (("pyramidal", 1.0), ("elliptic", 1.0), ("elliptic", 10.0), ("elliptic", 1000.0))
FRACTIONS = (0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 0.99, 1.01, 1.05, 1.2)
PICTURE = Path(__file__).resolve().parents[2] / "output" / "mujoco_creep.svg"

# Seconds in which the fingers close on the jar without its weight, in which a load grows, in which it rests, and of the watch at most.
# The load grows slowly beside oscillations on the fingers' springs, of 50 ms; a sudden one would make the fingers carry twice as much.
CLOSE, GROW, REST, WATCH = 1.0, 0.2, 0.1, 0.3
# The watch ends after so much slip, m. A jar 80 mm high that is pulled hard would otherwise leave its fingers.
SLIPPED = 0.005
# Solver tolerance: with MuJoCo's own, 1e-8, slip near the limit of a stiff friction is noise of the solver.
TOLERANCE = 1e-12
# How far each finger is told to go beyond touching, m. Times kp, less what the contact gives, it is the squeeze.
TRAVEL = 0.004

SCENE = """
<mujoco>
  <option timestep="0.001" tolerance="{tolerance}" cone="{cone}" impratio="{impratio}"/>
  <default><geom condim="3" friction="0.5"/></default>
  <worldbody>
    <replicate count="3" euler="0 0 120">
      <body name="finger" gravcomp="1">
        <joint name="press" type="slide" axis="-1 0 0"/>
        <joint name="across" type="slide" axis="0 1 0" stiffness="2000" damping="20"/>
        <joint name="along" type="slide" axis="0 0 1" stiffness="2000" damping="20"/>
        <geom type="sphere" size="0.01" pos="0.04 0 0" mass="0.05"/>
      </body>
    </replicate>
    <body name="object"><freejoint/><geom type="cylinder" size="0.03 0.04" mass="0.2"/></body>
  </worldbody>
  <actuator><position name="press" joint="press" kp="2000" kv="20"/></actuator>
</mujoco>"""


@dataclass(frozen=True)
class Drift:
    """What the simulator does under a load: the object slips down the fingertips (mm/s), which have sunk with it on their springs (mm)."""

    slip: float
    sink: float


def scene(cone: str = "elliptic", impratio: float = 1.0) -> mujoco.MjModel:
    """A jar between three fingers; MuJoCo numbers the copies of a finger, its joints and its actuator from 0."""
    return mujoco.MjModel.from_xml_string(SCENE.format(cone=cone, impratio=impratio, tolerance=TOLERANCE))


def pull(model: mujoco.MjModel, data: mujoco.MjData, load: float) -> None:
    """Load the object with a force downwards at its centre of mass, N, of which its weight is a part."""
    body = model.body("object").id
    data.xfrc_applied[body, 2] = -model.body_mass[body] * model.opt.gravity[2] - load


def squeezed(model: mujoco.MjModel) -> mujoco.MjData:
    """The object in the closed fingers with its weight held up, because ``pressed_with`` speaks of the squeeze alone."""
    data = mujoco.MjData(model)
    data.ctrl[:] = TRAVEL
    pull(model, data, 0.0)
    mujoco.mj_step(model, data, round(CLOSE / model.opt.timestep))
    return data


def loaded(model: mujoco.MjModel, load: float) -> mujoco.MjData:
    """The squeezed object some time after a load has grown on it, N."""
    data, steps = squeezed(model), round(GROW / model.opt.timestep)
    for step in range(1, steps + 1):
        pull(model, data, load * step / steps)
        mujoco.mj_step(model, data)
    mujoco.mj_step(model, data, round(REST / model.opt.timestep))
    return data


def heights(model: mujoco.MjModel, data: mujoco.MjData) -> tuple[float, float]:
    """Of the object, and of the fingers in the mean, m."""
    fingers = [body for body in range(model.nbody) if model.body(body).name.startswith("finger")]
    return float(data.body("object").xipos[2]), float(data.xpos[fingers, 2].mean())


def drift(model: mujoco.MjModel, load: float) -> Drift:
    """Watch the object under a load, N."""
    data = loaded(model, load)
    begun, slip = data.time, 0.0
    first, tips = heights(model, data)
    while data.time - begun < WATCH and slip < SLIPPED:
        mujoco.mj_step(model, data)
        height, now = heights(model, data)
        slip = (first - tips) - (height - now)
    if len(touching(model, data, "object")) < len(model.actuator_gainprm):
        raise ValueError(f"load is {load} N, must leave the object between its fingers while it is watched")
    return Drift(1e3 * slip / (data.time - begun), -1e3 * now)


def gives_way(model: mujoco.MjModel, low: float, high: float) -> float:
    """By bisection between two loads, the load at which slip is twice as fast as creep under the lower one foretells, N."""
    slope = drift(model, low).slip / low
    while high - low > 1e-5 * high:
        middle = (low + high) / 2
        low, high = (low, middle) if drift(model, middle).slip > 2 * slope * middle else (middle, high)
    return (low + high) / 2


def said(answer: Solution) -> str:
    """The answer of grasp-lcp in a table's words."""
    state = answer.equilibrium
    if state is None:
        return answer.outcome.replace("_", " ")
    return f"rests, {-1e3 * state.twist[2]:.3f} mm lower" + (", slides there" if "sliding" in state.states else "")


def draw(path: Path, onset: float, loads: Sequence[float], columns: Sequence[tuple[str, Sequence[Drift]]]) -> None:
    """Slip against load for each setting, and the onset."""
    figure = Figure(figsize=(7.2, 4.4), layout="constrained")
    axes = figure.subplots()
    for (label, found), marker in zip(columns, "sovD", strict=False):
        axes.semilogy(loads, [each.slip for each in found], marker=marker, markersize=4, label=label)
    axes.axvline(onset, color="black", linestyle="--")
    axes.text(onset, 0.03, f"grasp-lcp: slides at {onset:.3f} N ", ha="right", transform=axes.get_xaxis_transform())
    axes.set(xlabel="load, N", ylabel="slip in the simulator, mm/s", title="A jar that holds, and creeps in the simulator")
    axes.legend(loc=(0.02, 0.18), fontsize=8, title="MuJoCo, by cone and impratio", title_fontsize=8)
    axes.grid(alpha=0.3)
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path)


def main(picture: Path = PICTURE, fractions: Sequence[float] = FRACTIONS) -> None:
    """Read the contacts, ask for the onset, and print and draw what the simulator does under loads around it."""
    models = [(f"{cone} {impratio:g}", scene(cone, impratio)) for cone, impratio in SETTINGS]
    model = models[-1][1]
    data = squeezed(model)
    grasp, held = Grasp.from_mujoco(model, data, "object"), touching(model, data, "object")
    answer = grasp.onset([0, 0, -1])
    print(answer)
    onset = answer.factor
    if onset is None:
        raise ValueError(f"scene: {answer.outcome} is the answer without a load, must be a grasp that holds its object")
    by_hand = sum(touch.friction * touch.press for touch in held)
    print(f"by hand, μ times the sum of normal forces: {by_hand:.12g} N, off by {abs(onset / by_hand - 1):.1e}\n")

    loads = [fraction * onset for fraction in fractions]
    columns = [(label, [drift(setting, load) for load in loads]) for label, setting in models]
    print("slip in MuJoCo, mm/s, by cone and impratio; how far its fingertips sank, mm; what grasp-lcp says")
    print("load, N  of onset" + "".join(f"{label:>15}" for label, _ in columns) + "     tips  grasp-lcp")
    for row, (load, fraction) in enumerate(zip(loads, fractions, strict=True)):
        slips = "".join(f"{found[row].slip:15.5f}" for _, found in columns)
        print(f"{load:7.3f}  {fraction:8.2f}{slips}{columns[-1][1][row].sink:9.3f}  {said(grasp.solve([0, 0, -load]))}")

    own = gives_way(model, 0.5 * onset, 1.2 * onset)
    print(f"\nMuJoCo's own friction gives way at {own:.4f} N, impratio {SETTINGS[-1][1]:g}, {100 * (own / onset - 1):+.3f} % off the onset")
    draw(picture, onset, loads, columns)
    print(f"drawn: {picture}")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else PICTURE)
