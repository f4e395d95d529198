"""Batches spread over a cluster's engine: the bits of one process, no row lost or doubled, bad rows answered by their status."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from grasp_lcp import Grasp, OnsetStatus, VerdictStatus

EXAMPLES = Path(__file__).parents[1] / "examples"
sys.path.insert(0, str(EXAMPLES))

import many_grasps  # noqa: E402

ROWS = 20_000
# 20 bad rows of three kinds in turn: 7 points that are NaN, 7 negative frictions and 6 normals of zeros.
BAD = {"NOT_A_NUMBER": 7, "MALFORMED": 13}


def check_printed(printed: str) -> None:
    """The counts that the examples print."""
    print(printed)
    assert f"{ROWS} answers: 0 lost, 0 doubled, 0 invented, 0 different in any bit" in printed
    words = [line.split() for line in printed.splitlines() if line.startswith("  ")]
    statuses = {name: int(count) for name, count in words}
    assert BAD.items() <= statuses.items()
    assert sum(statuses.values()) == ROWS and statuses["LEAVES"] > 0.9 * ROWS and statuses["NOT_STICKING"] > 0


def test_answers_are_those_of_single_grasps() -> None:
    rows = 600
    grasps = many_grasps.at_random(rows)
    answers = grasps.answered()
    assert OnsetStatus(answers["status"][500]) == OnsetStatus.NOT_A_NUMBER
    asked, leave = range(0, rows, 7), 0
    for row in asked:
        onset = Grasp.spatial(
            grasps.points[row], grasps.normals[row], friction=grasps.friction[row], pressed_with=grasps.squeeze[row],
            body_stiffness=[5e4, 3e4], finger_stiffness=[2e3, 1.5e3],
        ).onset(many_grasps.DOWN)  # fmt: skip
        assert (onset.outcome == "at") == (answers["status"][row] == OnsetStatus.LEAVES)
        if onset.outcome == "at":
            assert answers["factor"][row] == pytest.approx(onset.factor, rel=1e-10)
            assert answers["leaving"][row] == sum(1 << leaving.contact for leaving in onset.leaving)
            leave += 1
        verdict = Grasp.spatial(
            grasps.points[row], grasps.normals[row], friction=grasps.friction[row], pressed_with=grasps.squeeze[row],
            body_stiffness=[5e4, 3e4], finger_stiffness=[2e3, 1.5e3],
        ).hold([0, 0, -0.5])  # fmt: skip
        assert VerdictStatus(answers["verdict"][row]).name.lower() == verdict.outcome
    print(f"{leave} of {len(asked)} leave")
    assert leave > 50


def test_a_comparison_finds_what_is_amiss() -> None:
    answers = many_grasps.at_random(1000).answered()
    assert many_grasps.compared(answers[::-1], answers).same
    broken = np.concatenate([answers[3:], answers[10:12]])
    broken["id"][5] = 1000
    first, second = np.flatnonzero(broken["status"] == OnsetStatus.LEAVES)[20:22]
    broken["factor"][first] = np.nextafter(broken["factor"][first], np.inf)
    broken["leaving"][second] ^= 1
    found = many_grasps.compared(broken, answers)
    assert (found.lost, found.doubled, found.invented, found.different) == (4, 2, 1, 2) and not found.same


def test_lists_of_arrow_are_seen_and_not_copied() -> None:
    pytest.importorskip("pyspark", reason="pyspark is not installed")
    import spark_onsets

    table = spark_onsets.table_of(many_grasps.at_random(100))
    batch = table.to_batches()[0].slice(10, 50)
    seen = spark_onsets.grasps_of(batch)
    for name in ("points", "normals"):
        values = batch.column(name).values.buffers()[1]
        assert getattr(seen, name).shape == (50, 3, 3)
        assert getattr(seen, name).ctypes.data == values.address + 10 * 9 * 8
    assert seen.friction.ctypes.data == batch.column("friction").buffers()[1].address + 10 * 8


def test_lists_of_other_lengths_are_told_row_by_row() -> None:
    pytest.importorskip("pyspark", reason="pyspark is not installed")
    import pyarrow as pa
    import spark_onsets

    table = spark_onsets.table_of(many_grasps.at_random(8))
    columns = table.to_pydict()
    columns["points"][1] = None
    columns["points"][2] = columns["points"][2][:6]
    columns["normals"][3] = columns["normals"][3] * 2
    columns["normals"][4][4] = None
    columns["friction"][5], columns["squeeze"][6] = None, None
    (batch,) = pa.table(columns, schema=table.schema).to_batches()
    (answers,) = spark_onsets.answer([batch])
    good = many_grasps.at_random(8).answered()
    nan = OnsetStatus.NOT_A_NUMBER
    assert answers["status"].to_pylist() == [good["status"][0], nan, nan, nan, nan, nan, nan, good["status"][7]]
    assert answers["factor"][0].as_py() == good["factor"][0] and answers["id"].to_pylist() == good["id"].tolist()
    none = spark_onsets.grasps_of(batch.slice(0, 0))
    assert len(none.answered()) == 0


def needs_spark() -> None:
    """Skips where Spark cannot run."""
    pytest.importorskip("pyspark", reason="pyspark is not installed: pip install 'grasp-lcp[cluster]'")
    if shutil.which("java") is None and "JAVA_HOME" not in os.environ:
        pytest.skip("Spark needs Java, and there is no java on the path")


def test_spark_gives_the_bits_of_one_process(capfd: pytest.CaptureFixture[str]) -> None:
    needs_spark()
    import spark_onsets

    assert spark_onsets.main([str(ROWS)]) == 0
    check_printed(capfd.readouterr().out)


def test_workers_of_spark_have_a_core_each() -> None:
    needs_spark()
    import pyarrow as pa
    import spark_onsets

    def told(batches: object) -> object:
        import os
        import sys

        for batch in batches:  # type: ignore[attr-defined]
            row = [f"{sys.executable} {os.environ.get('RAYON_NUM_THREADS')}"] * len(batch)
            yield pa.RecordBatch.from_pydict({"told": row})

    before = os.environ.get("RAYON_NUM_THREADS")
    spark = spark_onsets.session()
    try:
        rows = spark.range(4).mapInArrow(told, "told string").collect()
    finally:
        spark.stop()
    assert {row.told for row in rows} == {f"{sys.executable} 1"} and len(rows) == 4
    # This process keeps all of its cores.
    assert os.environ.get("RAYON_NUM_THREADS") == before


@pytest.mark.parametrize("scheduler", ["threads", "processes"])
def test_dask_gives_the_bits_of_one_process(scheduler: str) -> None:
    pytest.importorskip("dask.array", reason="dask is not installed: pip install 'dask[array]'")
    run = [sys.executable, str(EXAMPLES / "dask_onsets.py"), str(ROWS), "--scheduler", scheduler, "--block", "1500"]
    done = subprocess.run(run, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    check_printed(done.stdout)
