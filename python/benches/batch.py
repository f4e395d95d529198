"""A million planar pairs and a million spatial triples from numpy arrays.

    cargo run --release --package grasp-lcp-python --example rust_batch
    python python/benches/batch.py

prints the same two lines: the same factors to the last bit, and how long each takes. Verdicts, pads and amounts follow;
`cargo run --release -p reports --bin verdict_batch` compares them with single grasps.
"""

import time
from collections.abc import Callable

import numpy as np

from grasp_lcp import Onsets, OnsetStatus, hold_batch, need_batch, onsets

GRASPS = 1_000_000
REPEATS = 5
SPREAD = 0.6180339887498949


def number(datum: int) -> np.ndarray:
    """A number between 0 and 1 for each grasp, the same in `rust_batch.rs`."""
    return np.modf((np.arange(GRASPS) + 1.0) * SPREAD + datum * 0.137)[0]


def report(name: str, run: Callable[[], Onsets]) -> None:
    """The best time, and a sum of the factors' bits."""
    best = float("inf")
    for _ in range(REPEATS):
        start = time.perf_counter()
        found = run()
        best = min(best, time.perf_counter() - start)
    factors = found.factor[found.status == OnsetStatus.LEAVES]
    bits = int(factors.view(np.uint64).sum(dtype=np.uint64))
    pace = GRASPS / best * 1e-6
    print(f"{name:16} {best:8.3f} s  {pace:6.2f} million a second  {len(factors)} factors, sum of bits {bits:016x}")


friction = (0.3 + 0.4 * number(0))[:, None]

pairs = np.zeros((GRASPS, 2, 2))
pairs[:, :, 0] = [-0.04, 0.04]
for contact in range(2):
    pairs[:, contact, 1] = 0.02 * (number(contact + 1) - 0.5)
inward = np.array([[1.0, 0.0], [-1.0, 0.0]])
report(
    "planar pairs",
    lambda: onsets(pairs, inward, [0.1, -1.0], friction=friction, series_stiffness=[1e3, 8e2], command=[0.01, 0.0]),
)

triples = np.zeros((GRASPS, 3, 3))
triples[:, :, 0] = [-0.04, 0.02, 0.02]
triples[:, 1, 1], triples[:, 2, 1] = 0.03 + 0.01 * number(2), -(0.03 + 0.01 * number(4))
for contact, datum in enumerate((1, 3, 5)):
    triples[:, contact, 2] = 0.02 * (number(datum) - 0.5)
towards = triples * [-1.0, -1.0, 0.0]
report(
    "spatial triples",
    lambda: onsets(triples, towards, [0.1, 0.2, -1.0], friction=friction, series_stiffness=[9e2, 6e2], command=[0.006, 0.0, 0.0]),
)


def paced(name: str, rows: int, run: Callable[[], object]) -> None:
    """The best pace, and the answer in a line."""
    best, found = float("inf"), None
    for _ in range(REPEATS):
        start = time.perf_counter()
        found = run()
        best = min(best, time.perf_counter() - start)
    print(f"{name:24} {rows / best:10.0f} a second  {found}")


springs = {"friction": friction, "series_stiffness": [9e2, 6e2], "command": [0.006, 0.0, 0.0]}
paced("verdicts, triples", GRASPS, lambda: hold_batch(triples, towards, [0.1, 0.2, -1.0], **springs))
paced("squeezes that stick", GRASPS, lambda: need_batch(triples, towards, [0.1, 0.2, -1.0], sticks=True, **springs))
few = GRASPS // 500
held = springs | {"friction": friction[:few]}
paced("squeezes that hold", few, lambda: need_batch(triples[:few], towards[:few], [0.1, 0.2, -1.0], **held))

some = GRASPS // 20
jaws = np.broadcast_to([[-0.03, 0.0, 0.0], [0.03, 0.0, 0.0]], (some, 2, 3))
padded = {
    "friction": friction[:some], "series_stiffness": [2e4, 1e4], "pressed_with": 10.0,
    "soft": {"disc": {"radius": 0.006, "annuli": 1, "points": 8}},
}  # fmt: skip
paced("onsets, pads of 16", some, lambda: onsets(jaws, -jaws, [0.0, 0.0, -4.0], **padded))
paced("verdicts, pads of 16", some, lambda: hold_batch(jaws, -jaws, [0.0, 0.0, -4.0], **padded))
