"""What a single call from Python costs over the call in Rust: the onset of a planar pair.

    cargo run --release --package grasp-lcp-python --example rust_single
    python python/benches/single.py

prints the best of several repeats; the difference is what Python adds.
"""

import timeit

import numpy as np

from grasp_lcp import Grasp

# The grasp of `rust_single.rs`.
grasp = Grasp.planar(
    [[-0.04, 0.0], [0.04, 0.0]], [[1.0, 0.0], [-1.0, 0.0]], names=["left", "right"],
    body_stiffness=[5e4, 3e4], finger_stiffness=[2e3, 1.5e3], friction=0.5, pressed_with=8.0,
)  # fmt: skip
CALLS = 20_000


def best(call: object, repeats: int = 15) -> float:
    """The least time of a call, in microseconds."""
    return min(timeit.repeat(call, number=CALLS, repeat=repeats)) / CALLS * 1e6  # type: ignore[arg-type]


along = np.array([0.0, -4.905])
assert grasp.onset(along).factor is not None
print(f"onset(array)          {best(lambda: grasp.onset(along)):6.2f} µs")
print(f"onset(array).factor   {best(lambda: grasp.onset(along).factor):6.2f} µs")
print(f"onset(list).factor    {best(lambda: grasp.onset([0.0, -4.905]).factor):6.2f} µs")
print(f"solve(array).outcome  {best(lambda: grasp.solve(along).outcome):6.2f} µs")
print(f"an empty function     {best(lambda: None):6.2f} µs")
