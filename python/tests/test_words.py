"""What is printed is words: a motion, a soft fingertip as one contact, names without control characters."""

from __future__ import annotations

import json

from grasp_lcp import Grasp

WICKED = "tip\x1b[2J\n"


def pinch() -> Grasp:
    """Two pads that press with 10 N each; half of a load along y goes to each of them."""
    jaw = {"series_stiffness": [2000, 1000], "friction": 0.5, "pressed_with": 10, "soft": {"pad": {"width": 0.02, "strips": 1}}}
    contacts = [{"name": WICKED, "point": [-0.03, 0], "normal": [1, 0], **jaw}, {"point": [0.03, 0], "normal": [-1, 0], **jaw}]
    return Grasp.from_json(json.dumps({"format": "grasp-lcp/1", "planar": {"contacts": contacts}}))


def test_pads_and_motions() -> None:
    state = pinch().solve([0, -4]).equilibrium
    assert state is not None
    # Tangents point down on the left and up on the right; 2 N on 1000 N/m; 0.5 · 10 - 2 N are left.
    lines = repr(state).splitlines()
    assert lines[0].startswith("<Equilibrium: the object moves 2 mm along −y, residual ")
    assert lines[1] == "  tip\\u{1b}[2J\\n: sticks, force (10, -2) N, moment 0 N m, margin 3 N"
    assert lines[2] == "  contact 1: sticks, force (10, 2) N, moment 0 N m, margin 3 N>"
    assert [len(pad.points) for pad in state.pads] == [4, 4] and len(state.contacts) == 8


def test_names() -> None:
    grasp = pinch()
    for told in (grasp.solve([0, -4]), grasp.onset([0, -1]), grasp.follow([[0, -9]]), grasp.hold([0, -4])):
        assert "\x1b" not in repr(told)
    assert "tip\\u{1b}[2J\\n and contact 1 slide" in repr(grasp.onset([0, -1]))
