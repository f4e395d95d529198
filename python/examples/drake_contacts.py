"""At which load does a grasp in Drake slide? The jar of `mujoco_creep.py`, its contacts asked in the same way.

    pip install drake
    python python/examples/drake_contacts.py        # prints a table

Drake's solvers soften friction, too, and by less: below the limit its jar slips as well, but slowly.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlant, MultibodyPlantConfig
from pydrake.multibody.tree import PrismaticSpring
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

from grasp_lcp import Grasp
from grasp_lcp.drake import touching

# Drake's approximations of contact that are compared. Its fourth, "tamsi", knows no actuators with gains.
SOLVERS = ("sap", "similar", "lagged")
FRACTIONS = (0.3, 0.6, 0.9, 0.99, 1.01, 1.05)
# Gain of the actuators that press, and springs of the fingers across and along themselves, N/m.
GAIN, SPRING = 2000.0, 2000.0
# How far each finger is told to go beyond touching, m.
TRAVEL = 0.004
# Seconds in which the fingers close on the weightless jar, in which a load grows, in which it rests, and of the watch.
# Contacts of "sap" relax in about 0.2 s; what is read sooner is not yet what the actuators push with.
CLOSE, GROW, REST, WATCH = 3.0, 0.2, 0.1, 0.05
STEP = 1e-3

# Axes along the coordinate axes of the world: of a body with several joints Drake's reader does not turn them with the body.
FINGER = """
    <body name="finger{k}">
      <joint name="press{k}" type="slide" axis="{inward[0]} {inward[1]} 0" damping="20"/>
      <joint name="across{k}" type="slide" axis="{inward[1]} {minus} 0" damping="20"/>
      <joint name="along{k}" type="slide" axis="0 0 1" damping="20"/>
      <geom type="sphere" size="0.01" pos="{centre[0]} {centre[1]} 0" mass="0.05"/>
    </body>"""
SCENE = """
<mujoco model="scene">
  <default><geom condim="3" friction="0.5"/></default>
  <worldbody>{fingers}
    <body name="object"><freejoint/><geom type="cylinder" size="0.03 0.04" mass="0.2"/></body>
  </worldbody>
  <actuator>{actuators}</actuator>
</mujoco>"""
ACTUATOR = '<position name="press{k}" joint="press{k}" kp="{gain}"/>'


class Scene:
    """A jar between three fingers in Drake, without gravity: its weight is a part of the load that is told."""

    def __init__(self, solver: str) -> None:
        builder = DiagramBuilder()
        config = MultibodyPlantConfig(time_step=STEP, discrete_contact_approximation=solver, contact_model="point")
        self.plant, self.graph = AddMultibodyPlant(config, builder)
        inward = [-np.array([np.cos(angle), np.sin(angle)]) for angle in 2 * np.pi * np.arange(3) / 3]
        fingers = "".join(FINGER.format(k=k, inward=n, minus=-n[0], centre=-0.04 * n) for k, n in enumerate(inward))
        actuators = "".join(ACTUATOR.format(k=k, gain=GAIN) for k in range(3))
        (self.model,) = Parser(self.plant).AddModelsFromString(SCENE.format(fingers=fingers, actuators=actuators), "xml")
        # Drake's reader of these files knows no springs of joints.
        for name in (f"{joint}{k}" for joint in ("across", "along") for k in range(3)):
            self.plant.AddForceElement(PrismaticSpring(self.plant.GetJointByName(name), 0.0, SPRING))
        self.plant.mutable_gravity_field().set_gravity_vector([0, 0, 0])
        self.plant.Finalize()
        self.object = self.plant.GetBodyByName("object")
        self.simulator = Simulator(builder.Build())
        self.context = self.plant.GetMyMutableContextFromRoot(self.simulator.get_mutable_context())
        told = np.concatenate([np.full(3, TRAVEL), np.zeros(3)])
        self.plant.get_desired_state_input_port(self.model).FixValue(self.context, told)
        self.pull(0.0)
        self.run(CLOSE)

    def run(self, seconds: float) -> None:
        """So many seconds of the simulator."""
        self.simulator.AdvanceTo(self.context.get_time() + seconds)

    def pull(self, load: float) -> None:
        """Load the object with a force downwards at its centre of mass, N."""
        forces = np.zeros(self.plant.num_velocities())
        # Velocities of a free body are its rotation and then its translation.
        forces[self.object.floating_velocities_start_in_v() + 5] = -load
        self.plant.get_applied_generalized_force_input_port().FixValue(self.context, forces)

    def load(self, load: float) -> None:
        """Let a load grow, and wait until the fingers stand still."""
        steps = round(GROW / STEP)
        for step in range(1, steps + 1):
            self.pull(load * step / steps)
            self.run(STEP)
        self.run(REST)

    def heights(self) -> tuple[float, float]:
        """Of the object, and of the fingers in the mean, m."""
        tips = [self.plant.GetJointByName(f"along{k}").get_translation(self.context) for k in range(3)]
        return float(self.object.EvalPoseInWorld(self.context).translation()[2]), float(np.mean(tips))

    def slip(self) -> float:
        """How fast the object slips down the fingertips, mm/s."""
        (object_was, tips_were), begun = self.heights(), self.context.get_time()
        self.run(WATCH)
        object_is, tips_are = self.heights()
        return 1e3 * ((object_was - tips_were) - (object_is - tips_are)) / float(self.context.get_time() - begun)


def main(solvers: Sequence[str] = SOLVERS, fractions: Sequence[float] = FRACTIONS) -> None:
    """For each solver the onset of its contacts, and slip under loads around it."""
    print("solver    onset, N  by hand, N" + "".join(f"{fraction:>12.2f}" for fraction in fractions) + "  of onset: slip in Drake, mm/s")
    for solver in solvers:
        squeezed = Scene(solver)
        held = touching(squeezed.plant, squeezed.context, "object")
        grasp = Grasp.from_drake(squeezed.plant, squeezed.context, "object")
        onset, by_hand = grasp.onset([0, 0, -1]).factor, sum(touch.friction * touch.press for touch in held)
        if onset is None:
            raise ValueError(f"{solver}: its contacts hold nothing without a load, must be a grasp")
        slips = []
        for fraction in fractions:
            scene = Scene(solver)
            scene.load(fraction * onset)
            slips.append(scene.slip())
        print(f"{solver:8}{onset:10.6f}{by_hand:12.6f}" + "".join(f"{slip:12.4f}" for slip in slips))


if __name__ == "__main__":
    main()
