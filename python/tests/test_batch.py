"""Batches: the bits of single calls, numpy's broadcasting, bad rows in their place, any number of threads."""

import os
import subprocess
import sys

import numpy as np
import pytest
from grasps import jar

import grasp_lcp
from grasp_lcp import ContactState, Grasp, OnsetStatus, SolveStatus, onsets, solve_batch

SPRINGS = {"series_stiffness": [900.0, 600.0], "friction": 0.6, "command": [0.006, 0, 0]}


def jars(rows: int, contacts: int = 3, seed: int = 1) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    made = [jar(rng, contacts) for _ in range(rows)]
    return np.array([points for points, _ in made]), np.array([normals for _, normals in made])


@pytest.mark.parametrize("contacts", [1, 2, 3, 4, 5, 6])
def test_rows_are_single_onsets(contacts: int) -> None:
    points, normals = jars(50, contacts)
    down = [0, 0, -1.0]
    found = onsets(points, normals, down, complete=True, **SPRINGS)
    for row in range(50):
        one = Grasp.spatial(points[row], normals[row], **SPRINGS).onset(down)
        if one.outcome == "at":
            assert found.status[row] == OnsetStatus.LEAVES
            assert found.factor[row] == pytest.approx(one.factor, rel=1e-10)
            assert np.flatnonzero(found.leaving[row]).tolist() == [leaving.contact for leaving in one.leaving]
        else:
            names = {"never": "NEVER", "already_sliding": "ALREADY_SLIDING", "no_base": "NO_BASE", "gives_way": "GIVES_WAY"}
            assert found.status[row] == OnsetStatus[names[one.outcome]]


def test_equilibria_have_the_bits_of_single_calls() -> None:
    points, normals = jars(40)
    load = [1.0, 0.5, -6.0]
    found = solve_batch(points, normals, load, **SPRINGS)
    for row in range(40):
        one = Grasp.spatial(points[row], normals[row], **SPRINGS).solve(load)
        assert (one.outcome == "equilibrium") == found.answered[row]
        if one.equilibrium is None:
            assert np.isnan(found.forces[row]).all() and (found.states[row] == ContactState.UNKNOWN).all()
            continue
        for name in ("twist", "forces", "forces_world", "slips", "gaps", "margins"):
            assert (getattr(one.equilibrium, name) == getattr(found, name)[row]).all()
        states = tuple(ContactState(code).name.lower() for code in found.states[row])
        assert states == one.equilibrium.states


def test_broadcasting_is_that_of_numpy() -> None:
    points, normals = jars(6)
    pulls = np.random.default_rng(2).normal(size=(5, 3))
    table = onsets(points[:, None], normals[:, None], pulls, **SPRINGS)
    assert table.factor.shape == (6, 5) and table.leaving.shape == (6, 5, 3)
    for k in range(5):
        column = onsets(points, normals, pulls[k], **SPRINGS)
        assert (column.status == table.status[:, k]).all()
        assert np.array_equal(column.factor, table.factor[:, k], equal_nan=True)
    # One load for each grasp, and loads along an axis before that of the grasps.
    own = onsets(points[:5], normals[:5], pulls, **SPRINGS)
    assert np.array_equal(own.factor, np.diagonal(table.factor[:5]), equal_nan=True)
    turned = onsets(points, normals, pulls[:, None], **SPRINGS)
    assert np.array_equal(turned.factor, table.factor.T, equal_nan=True)
    # Friction along one more axis; a single grasp has a shape of nothing.
    frictions = onsets(points, normals, pulls[0], **(SPRINGS | {"friction": np.full((4, 1, 1), 0.6)}))
    assert frictions.factor.shape == (4, 6) and np.array_equal(frictions.factor[3], table.factor[:, 0], equal_nan=True)
    assert onsets(points[0], normals[0], pulls[0], **SPRINGS).factor == table.factor[0, 0]
    solved = solve_batch(points[:, None], normals[:, None], pulls, **SPRINGS)
    assert solved.forces.shape == (6, 5, 3, 3) and solved.twist.shape == (6, 5, 6)
    assert onsets(np.zeros((0, 3, 3)), normals[0], pulls[0], **SPRINGS).factor.shape == (0,)


def test_bad_rows_are_told_and_stop_nothing() -> None:
    points, normals = jars(8)
    friction = np.full((8, 3), 0.6)
    good = onsets(points, normals, [0, 0, -1.0], **(SPRINGS | {"friction": friction}))
    friction[1, 2], friction[2, 0] = np.nan, -0.1
    points[3, 1, 2], points[4, 0, 0], normals[5, 1] = np.nan, np.inf, 0.0
    given = SPRINGS | {"friction": friction}
    found = onsets(points, normals, [0, 0, -1.0], **given)
    nan, bad = OnsetStatus.NOT_A_NUMBER, OnsetStatus.MALFORMED
    assert found.status[1:6].tolist() == [nan, bad, nan, bad, bad]
    for row in (0, 6, 7):
        assert np.array_equal(found.factor[row], good.factor[row], equal_nan=True) and found.status[row] == good.status[row]
    assert not found.answered[1:6].any() and np.isnan(found.factor[1:6]).all() and not found.leaving[1:6].any()
    solved = solve_batch(points, normals, [0, 0, -1.0], **given)
    expected = [SolveStatus.NOT_A_NUMBER, SolveStatus.MALFORMED]
    assert solved.status[1:6].tolist() == [expected[0], expected[1], expected[0], expected[1], expected[1]]
    pulls = np.array([[0, 0, -1.0], [0, np.nan, 0], [1.0, 0, 0]])
    table = onsets(points[:, None], normals[:, None], pulls, **(given | {"friction": friction[:, None]}))
    assert (table.status[[0, 6, 7], 1] == nan).all() and table.factor[0, 0] == found.factor[0]
    nothing = np.zeros((2, 0, 3))
    assert (onsets(nothing, nothing, [0, 0, -1.0], **SPRINGS).status == bad).all()
    masked = np.ma.masked_array(points, mask=np.zeros_like(points, dtype=bool))
    masked[0, 0, 0] = np.ma.masked
    assert onsets(masked, normals, [0, 0, -1.0], **given).status[0] == nan


def test_single_precision_is_widened() -> None:
    points, normals = (array.astype(np.float32) for array in jars(20))
    narrow = onsets(points, normals, np.array([0, 0, -1], dtype=np.int32), **SPRINGS)
    wide = onsets(points.astype(float), normals.astype(float), [0, 0, -1.0], **SPRINGS)
    assert np.array_equal(narrow.factor, wide.factor, equal_nan=True)


def test_unequal_tangents_go_to_the_whole_method() -> None:
    points, normals = jars(10)
    given = SPRINGS | {"series_stiffness": [900.0, 600.0, 300.0]}
    found = onsets(points, normals, [0, 0, -1.0], **given)
    for row in range(10):
        one = Grasp.spatial(points[row], normals[row], **given).onset([0, 0, -1.0])
        if one.outcome == "at":
            assert found.factor[row] == one.factor


def test_the_same_bits_for_any_number_of_threads() -> None:
    # More rows than a thread takes at once.
    program = """
import hashlib, sys
import numpy as np
sys.path.insert(0, {here!r})
from test_batch import SPRINGS, jars
from grasp_lcp import onsets, solve_batch
points, normals = jars(100)
points, normals = np.tile(points, (50, 1, 1)), np.tile(normals, (50, 1, 1)) + np.linspace(0, 1e-3, 5000)[:, None, None]
found = onsets(points, normals, [0.1, 0, -1.0], **SPRINGS)
solved = solve_batch(points[:500], normals[:500], [0.1, 0, -1.0], **SPRINGS)
parts = (found.factor, found.status, found.leaving, solved.forces, solved.twist)
print(hashlib.sha256(b"".join(part.tobytes() for part in parts)).hexdigest())
"""
    run = [sys.executable, "-c", program.format(here=os.path.dirname(__file__))]
    prints = {
        subprocess.run(run, env=os.environ | {"RAYON_NUM_THREADS": threads}, capture_output=True, check=True).stdout
        for threads in ("1", "2", "5")
    }
    assert len(prints) == 1 and len(prints.pop()) == 65


def test_the_interpreter_runs_on_meanwhile() -> None:
    import threading
    import time

    points, normals = jars(100)
    points, normals = np.tile(points, (400, 1, 1)), np.tile(normals, (400, 1, 1))
    done, ticks = threading.Event(), 0

    def work() -> None:
        solve_batch(points, normals, [0, 0, -1.0], **SPRINGS)
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not done.is_set():
        ticks += 1
        time.sleep(1e-4)
    thread.join()
    print(f"{ticks} ticks of the interpreter during the batch")
    assert ticks > 5


def test_results_read_well() -> None:
    points, normals = jars(3)
    found = onsets(points, normals, [0, 0, -1.0], **SPRINGS)
    assert repr(found).startswith("<Onsets (3,): ") and sum(found.count().values()) == 3
    assert "equilibrium" in repr(solve_batch(points, normals, [0, 0, 0.0], **SPRINGS))
    assert grasp_lcp.OnsetStatus.LEAVES == 0
