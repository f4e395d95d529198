"""The onsets of a million grasps in Dask: each block of the arrays is one call of `grasp_lcp.onsets`.

    pip install grasp-lcp 'dask[array]'
    python python/examples/dask_onsets.py [GRASPS] [--scheduler processes]

compares with one process to the last bit, row by row, and prints how long both take.

Dask's threads share the threads of one process: the call lets go of the interpreter's lock, and nothing needs to be set. Dask's processes have a
core each, so that each is told RAYON_NUM_THREADS=1; of `dask.distributed` that is `LocalCluster(threads_per_worker=1)` or the environment of
`dask worker --nthreads 1`. Ray is told by `@ray.remote(runtime_env={"env_vars": {"RAYON_NUM_THREADS": "1"}})` before a function that calls
`answered` for a part of the arrays.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from typing import Any

import dask
import dask.array
import numpy as np
from many_grasps import ANSWER, ManyGrasps, answered, at_random, compared, paced

da: Any = dask.array

BLOCK = 50_000
"""Grasps of a block: some 10 MB, and a few milliseconds of work."""


def onsets_in_dask(grasps: ManyGrasps, block: int) -> Any:
    """Answers of a table of grasps as an array of Dask, not computed yet. Blocks are told by axes: b grasps, n fingers, c coordinates."""
    columns = [
        ("b", grasps.id), ("bnc", grasps.points), ("bnc", grasps.normals), ("b", grasps.friction), ("b", grasps.squeeze),
    ]  # fmt: skip
    pairs: list[Any] = []
    for axes, column in columns:
        pairs += [da.from_array(column, chunks=(block, *column.shape[1:])), axes]
    return da.blockwise(answered, "b", *pairs, dtype=ANSWER, concatenate=True, meta=np.empty(0, dtype=ANSWER))


def main(arguments: list[str] | None = None) -> int:
    """Asks in Dask and in one process, compares and prints; 1 if anything differs."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("grasps", type=int, nargs="?", default=1_000_000)
    parser.add_argument("--scheduler", choices=["threads", "processes"], default="threads")
    parser.add_argument("--block", type=int, default=BLOCK, help="grasps of a block")
    given = parser.parse_args(arguments)
    clock = time.perf_counter
    grasps = at_random(given.grasps)
    times = [clock()]
    expected = grasps.answered()
    times.append(clock())
    if given.scheduler == "processes":
        # Processes that start from here on have a core each.
        os.environ["RAYON_NUM_THREADS"] = "1"
    with dask.config.set(scheduler=given.scheduler):
        found = onsets_in_dask(grasps, given.block).compute()
    times.append(clock())
    comparison = compared(found, expected)
    print(paced("one process, one call", given.grasps, times[1] - times[0]))
    print(paced(f"Dask, {given.scheduler}", given.grasps, times[2] - times[1]))
    print(comparison)
    return 0 if comparison.same else 1


if __name__ == "__main__":
    sys.exit(main())
