"""Grasps in the axes of matplotlib."""

from __future__ import annotations

import numpy as np
import pytest
from test_mesh import gripped

from grasp_lcp import Grasp

figure = pytest.importorskip("matplotlib.figure")


def test_a_plane_grasp_has_its_contacts_and_forces() -> None:
    jaws = Grasp.planar(
        [[-0.04, 0], [0.04, 0]],
        [[1, 0], [-1, 0]],
        series_stiffness=1e3,
        friction=0.5,
        pressed_with=8.0,
        outline=[[-0.04, -0.02], [0.04, -0.02], [0.04, 0.02], [-0.04, 0.02]],
    )
    ax = figure.Figure().subplots()
    state = jaws.solve([0, -4]).equilibrium
    jaws.draw(ax, state)
    dots, arrows = ax.collections
    np.testing.assert_array_equal(dots.get_offsets(), [[-0.04, 0], [0.04, 0]])
    # Each presses with 8 N and carries 2 N; the longest arrow has a third of 80 mm.
    scale = 0.08 / 3 / np.hypot(8, 2)
    np.testing.assert_allclose(arrows.U, scale * np.array([8, -8]), rtol=1e-9)
    np.testing.assert_allclose(arrows.V, scale * np.array([2, 2]), rtol=1e-9)
    assert len(ax.lines) == 1 and ax.get_xlabel() == "x (m)"


def test_pads_on_a_mesh_are_drawn_on_the_part() -> None:
    ax = figure.Figure().add_subplot(projection="3d")
    grasp = gripped()
    grasp.draw(ax, grasp.solve([0, 0, -5]).equilibrium)
    # The bracket has 18 edges that one sees; its pads lie on the faces of the leg, not where they began.
    assert len(ax.lines) == 18
    x = np.asarray(ax.collections[0]._offsets3d[0])
    assert set(np.round(x, 9)) == {0.0, 0.006}
    # Of each pad one arrow: its shaft and the two lines of its head.
    assert len(ax.collections[1]._segments3d) == 2 * 3


def test_a_grasp_without_a_state_has_its_contacts_alone() -> None:
    ax = figure.Figure().add_subplot(projection="3d")
    gripped().draw(ax)
    assert len(ax.collections) == 1
