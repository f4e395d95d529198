"""The grasp of a body in MuJoCo: its contacts, and the joints and actuators that move them."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._touching import Touching, drive, hand_of, pressing
from ._views import Array

# Equality constraints become rods; this is their stiffness relative to the stiffest joint.
ROD = 1e6


def touching(model: Any, data: Any, body: int | str) -> list[Touching]:
    """The contacts that press on a body and on all that is welded to it, in MuJoCo's order.

    The first row of a MuJoCo frame is the normal, which points from geom 1 to geom 2, and its force acts on geom 2. If geom 1 belongs to the body,
    both change their sign.
    """
    import mujoco  # type: ignore[import-not-found,import-untyped,unused-ignore]

    body, found = int(model.body(body).id), []
    for index, contact in enumerate(data.contact):
        bodies = [int(model.geom_bodyid[geom]) for geom in contact.geom]
        is_of_body = [model.body_weldid[each] == model.body_weldid[body] for each in bodies]
        if is_of_body[0] == is_of_body[1] or contact.efc_address < 0:
            continue
        sign, side = (1.0, 0) if is_of_body[1] else (-1.0, 1)
        name = model.geom(contact.geom[side]).name or model.body(bodies[side]).name or f"geom {contact.geom[side]}"
        if contact.dim > 1 and contact.friction[0] != contact.friction[1]:
            raise ValueError(f"{name}: friction along the tangents is {contact.friction[:2]}, must be one coefficient")
        force = np.zeros(6)
        mujoco.mj_contactForce(model, data, index, force)
        frame = np.array(contact.frame).reshape(3, 3)
        found.append(
            Touching(
                other=bodies[side],
                name=name,
                point=contact.pos - data.xipos[body],
                normal=sign * frame[0],
                friction=float(contact.friction[0]) if contact.dim > 1 else 0.0,
                force=sign * force[:3] @ frame,
                depth=-float(contact.dist),
            )
        )
    return pressing(found)


def _dense(model: Any, rows: int, values: Any, count: Any, first: Any, columns: Any) -> Array:
    """A sparse matrix of MuJoCo as a dense one, with one column for each degree of freedom."""
    dense = np.zeros((rows, model.nv))
    for row in range(rows):
        place = slice(first[row], first[row] + count[row])
        dense[row, columns[place]] = values[place]
    return dense


def _moments(model: Any, data: Any) -> Array:
    """Lever arms of the actuators over all degrees of freedom."""
    if data.actuator_moment.ndim == 2:
        return np.array(data.actuator_moment)
    return _dense(model, model.nu, data.actuator_moment, data.moment_rownnz, data.moment_rowadr, data.moment_colind)


def _equalities(model: Any, data: Any) -> Array:
    """Jacobian rows of the active equality constraints."""
    import mujoco

    if mujoco.mj_isSparse(model):
        rows = _dense(model, data.nefc, data.efc_J.ravel(), data.efc_J_rownnz, data.efc_J_rowadr, data.efc_J_colind.ravel())
    else:
        rows = np.array(data.efc_J).reshape(data.nefc, model.nv)
    equality: Array = rows[np.array(data.efc_type)[: data.nefc] == int(mujoco.mjtConstraint.mjCNSTR_EQUALITY)]
    return equality


def _actuator(model: Any, data: Any, index: int) -> tuple[float, float | None]:
    """Stiffness of an actuator, force over length, and its largest force in the direction in which it acts; None without a limit."""
    import mujoco

    slope = 0.0
    if model.actuator_biastype[index] == int(mujoco.mjtBias.mjBIAS_AFFINE):
        slope += float(model.actuator_biasprm[index][1])
    if model.actuator_gaintype[index] == int(mujoco.mjtGain.mjGAIN_AFFINE):
        slope += float(model.actuator_gainprm[index][1] * data.ctrl[index])
    limit = None
    if model.actuator_forcelimited[index]:
        low, high = (float(x) for x in model.actuator_forcerange[index])
        limit = -low if data.actuator_force[index] < 0 else high
    return max(-slope, 0.0), limit


def hand_of_body(model: Any, data: Any, body: int | str) -> dict[str, Any]:
    """Arguments of :meth:`grasp_lcp.Grasp.hand` for the contacts of a body, see :meth:`grasp_lcp.Grasp.from_mujoco`."""
    import mujoco

    index = int(model.body(body).id)
    held = touching(model, data, index)
    whole = np.zeros((len(held), 3, model.nv))
    for jacobian, touch in zip(whole, held, strict=True):
        mujoco.mj_jac(model, data, jacobian, None, touch.point + data.xipos[index], touch.other)
    moments, equalities = _moments(model, data), _equalities(model, data)
    # Degrees of freedom that move a contact, and all others that actuators and constraints couple with them.
    kept = np.abs(whole).max(axis=(0, 1), initial=0.0) > 0
    coupled = np.vstack([moments, equalities]) != 0
    while (more := kept | coupled[coupled[:, kept].any(axis=1)].any(axis=0)).sum() > kept.sum():
        kept = more
    dofs = np.flatnonzero(kept)
    joints = [model.joint(int(model.dof_jntid[dof])) for dof in dofs]
    for joint in joints:
        if int(joint.type[0]) not in (int(mujoco.mjtJoint.mjJNT_HINGE), int(mujoco.mjtJoint.mjJNT_SLIDE)):
            raise ValueError(f"joint {joint.name!r}: a free or a ball joint is behind a contact, must be hinges and slides")
    springs = np.array([float(np.ravel(joint.stiffness)[0]) for joint in joints])
    drives = []
    for actuator, arms in enumerate(moments[:, dofs]):
        stiffness, limit = _actuator(model, data, actuator)
        if stiffness != 0.0 and arms.any():
            name = model.actuator(actuator).name or f"actuator {actuator}"
            drives.append(drive(name, arms, stiffness, float(data.actuator_force[actuator]), limit))
    stiffest = max([*springs, *(each["stiffness"] * float(np.square(each["arms"]).max()) for each in drives)], default=0.0)
    for number, row in enumerate(equalities[:, dofs]):
        if row.any():
            drives.append(drive(f"constraint {number}", row / np.linalg.norm(row), ROD * (stiffest or 1.0), 0.0, None))
    return hand_of(body, held, whole[:, :, dofs], [joint.name or f"joint {joint.id}" for joint in joints], springs, drives)
