"""Draws grasps into axes of matplotlib, which the caller provides."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from .equilibrium import Equilibrium

# Colours of contacts by their state, as in pictures of the crate.
COLOURS = {"sticking": "#0072b2", "sliding": "#d55e00", "frictionless": "#009e73", "separated": "#999999"}


def draw_into(ax: Any, places: tuple[Sequence[Any], Sequence[Any]], setup: Mapping[str, Any], state: Equilibrium | None) -> None:
    """Lines of the object, points of contacts, and forces on the object."""
    points, edges = np.array(places[0]), places[1]
    axes = points.shape[1]
    outlines = [setup.get("outline", ()), *(body.get("outline", ()) for body in setup.get("bodies", ()))]
    lines = [np.array([*corners, corners[0]]) for corners in outlines if len(corners) > 1] + [np.array(edge) for edge in edges]
    for line in lines:
        ax.plot(*line.T, color="#777777", linewidth=0.8)
    colours = [COLOURS["separated"]] * len(points) if state is None else [COLOURS[contact.state] for contact in state.contacts]
    ax.scatter(*points.T, color=colours, s=12)
    everything = np.vstack([points, *lines])
    if state is not None:
        # One resultant for all points of a pad, at their mean weighted by the sizes of their forces.
        numbers = np.array([contact.contact for contact in state.contacts])
        of_pads = [numbers == number for number in np.unique(numbers)]
        weights = np.linalg.norm(state.forces_world, axis=1) + 1e-300
        at = np.array([np.average(points[of_pad], axis=0, weights=weights[of_pad]) for of_pad in of_pads])
        forces = np.array([state.forces_world[of_pad].sum(axis=0) for of_pad in of_pads])
        size, most = np.ptp(everything, axis=0).max(), np.linalg.norm(forces, axis=1).max()
        arrows = forces * (size / (3 * most) if most > 0 else 0.0)
        inks = [colours[int(np.argmax(of_pad))] for of_pad in of_pads]
        in_plane = {"angles": "xy", "scale_units": "xy", "scale": 1} if axes == 2 else {}
        ax.quiver(*at.T, *arrows.T, color=inks, **in_plane)
        everything = np.vstack([everything, at + arrows])
    if axes == 2:
        ax.set_aspect("equal")
        ax.update_datalim(everything)
        ax.autoscale_view()
    else:
        ax.set_box_aspect(np.maximum(np.ptp(everything, axis=0), 1e-9 + 0.05 * np.ptp(everything)))
    for name, axis in zip("xyz", (ax.xaxis, ax.yaxis, getattr(ax, "zaxis", None)), strict=True):
        if axis is not None:
            axis.set_label_text(f"{name} (m)")
