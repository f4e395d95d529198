"""The grasp of a body in Drake: its contacts, and the joints and actuators that move them."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._touching import Touching, drive, hand_of, pressing


def touching(plant: Any, context: Any, body: str) -> list[Touching]:
    """The point contacts that press on a body, in Drake's order.

    A contact of Drake has its force on body B and its normal from B to A. The normal changes its sign if the held body is B, the force if the held
    body is A.
    """
    held, found = plant.GetBodyByName(body), []
    centre = held.EvalPoseInWorld(context).multiply(held.CalcCenterOfMassInBodyFrame(context))
    results = plant.get_contact_results_output_port().Eval(context)
    query = plant.get_geometry_query_input_port().Eval(context)
    for index in range(results.num_point_pair_contacts()):
        contact = results.point_pair_contact_info(index)
        bodies, pair = (contact.bodyA_index(), contact.bodyB_index()), contact.point_pair()
        if held.index() not in bodies:
            continue
        on_b = bodies[1] == held.index()
        other = plant.get_body(bodies[0] if on_b else bodies[1])
        rubs = [query.inspector().GetProximityProperties(key).GetProperty("material", "coulomb_friction") for key in (pair.id_A, pair.id_B)]
        one, two = (each.static_friction() for each in rubs)
        sign = 1.0 if on_b else -1.0
        found.append(
            Touching(
                other=int(other.index()),
                name=other.name(),
                point=contact.contact_point() - centre,
                normal=-sign * pair.nhat_BA_W,
                # Drake combines the coefficients of two surfaces by their harmonic mean.
                friction=2 * one * two / (one + two) if one + two > 0 else 0.0,
                force=sign * contact.contact_force(),
                depth=float(pair.depth),
            )
        )
    return pressing(found)


def hand_of_body(plant: Any, context: Any, body: str) -> dict[str, Any]:
    """Arguments of :meth:`grasp_lcp.Grasp.hand` for the contacts of a body, see :meth:`grasp_lcp.Grasp.from_drake`."""
    from pydrake.multibody.tree import (  # type: ignore[import-not-found,import-untyped,unused-ignore]
        BodyIndex,
        ForceElementIndex,
        JacobianWrtVariable,
        PrismaticSpring,
        RevoluteSpring,
    )

    held, world = touching(plant, context, body), plant.world_frame()
    pose = plant.GetBodyByName(body).EvalPoseInWorld(context)
    centre = pose.multiply(plant.GetBodyByName(body).CalcCenterOfMassInBodyFrame(context))
    whole = np.zeros((len(held), 3, plant.num_velocities()))
    for jacobian, touch in zip(whole, held, strict=True):
        other = plant.get_body(BodyIndex(touch.other))
        there = other.EvalPoseInWorld(context).inverse().multiply(touch.point + centre)
        jacobian[:] = plant.CalcJacobianTranslationalVelocity(context, JacobianWrtVariable.kV, other.body_frame(), there, world, world)
    dofs = np.flatnonzero(np.abs(whole).max(axis=(0, 1), initial=0.0) > 0)
    moving = {plant.get_joint(index).velocity_start(): plant.get_joint(index) for index in plant.GetJointIndices()}
    for dof in dofs:
        if dof not in moving or moving[dof].num_velocities() != 1:
            raise ValueError(f"velocity {dof}: a joint of several axes is behind a contact, must be hinges and slides")
    springs, drives = np.zeros(plant.num_velocities()), []
    for number in range(plant.num_force_elements()):
        element = plant.get_force_element(ForceElementIndex(number))
        if type(element) in (PrismaticSpring, RevoluteSpring):
            # In newer versions of Drake the stiffness of a hinge's spring is a parameter of the context.
            stiffness = element.GetStiffness(context) if hasattr(element, "GetStiffness") else element.stiffness()
            springs[element.joint().velocity_start()] += stiffness
    acts = plant.get_net_actuation_output_port().Eval(context)
    for index in plant.GetJointActuatorIndices():
        motor = plant.get_joint_actuator(index)
        arms = (dofs == motor.joint().velocity_start()).astype(float)
        stiffness = float(motor.get_controller_gains().p) if motor.has_controller() else 0.0
        if stiffness > 0 and arms.any():
            limit = float(motor.effort_limit())
            drives.append(drive(motor.name(), arms, stiffness, float(acts[motor.input_start()]), limit if np.isfinite(limit) else None))
    return hand_of(body, held, whole[:, :, dofs], [moving[dof].name() for dof in dofs], springs[dofs], drives)
