"""A table of grasps in Spark: each Arrow batch is one call of `grasp_lcp.onsets`, and the answers are a table again.

    pip install 'grasp-lcp[cluster]'       # and Java 17
    python python/examples/spark_onsets.py [GRASPS]

asks a million grasps from a Parquet file on two cores, compares with one process to the last bit, row by row, and prints how long both take.

On a cluster: `spark-submit --py-files many_grasps.py spark_onsets.py` with `session` as it is but for its master, where `grasp_lcp` is
installed on all machines. Each worker is told RAYON_NUM_THREADS=1. Spark runs one Python worker for each core already; if each of them asked
for all cores again, c cores would carry c² threads that get in each other's way.

The calls are short beside carrying the table through Spark, as the printed times show. Spark pays where the table lives in it already.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import many_grasps
import numpy as np
import pyarrow as pa  # type: ignore[import-untyped]
import pyarrow.compute as pc  # type: ignore[import-untyped]
import pyarrow.parquet as pq  # type: ignore[import-untyped]
from many_grasps import ANSWER, FINGERS, Answers, Array, ManyGrasps, at_random, compared, paced
from pyspark.sql import DataFrame, SparkSession

SCHEMA = "id long, factor double, status tinyint, leaving tinyint, verdict tinyint"

SPLIT = 16 << 20
"""Bytes of the table that one task reads: small enough that no core waits long for the last task."""


def vectors(column: Any) -> Array:
    """A column of lists of nine numbers as an array of shape (B, 3, 3): a view where every list has nine.

    A list of another length, a null in its place or a null inside it is NaN, so that its row is answered by its status.
    """
    size = 3 * FINGERS
    fits = pc.fill_null(pc.equal(pc.list_value_length(column), size), False)
    if pc.all(fits).as_py() is not False:
        rows = column.flatten().to_numpy(zero_copy_only=False)
    else:
        rows = np.full((len(column), size), np.nan)
        rows[fits.to_numpy(zero_copy_only=False)] = column.filter(fits).flatten().to_numpy(zero_copy_only=False).reshape(-1, size)
    return np.reshape(rows, (-1, FINGERS, 3))


def numbers(column: Any) -> Array:
    """A column of numbers, a view where none is null; a null is NaN."""
    return np.asarray(column.to_numpy(zero_copy_only=False), dtype=np.float64)


def grasps_of(batch: Any) -> ManyGrasps:
    """The grasps of an Arrow batch."""
    named = {name: batch.column(index) for index, name in enumerate(batch.schema.names)}
    return ManyGrasps(
        id=named["id"].to_numpy(),
        points=vectors(named["points"]),
        normals=vectors(named["normals"]),
        friction=numbers(named["friction"]),
        squeeze=numbers(named["squeeze"]),
    )


def batch_of(answers: Answers) -> Any:
    """Answers as an Arrow batch of SCHEMA. Spark has no unsigned numbers, and codes and three bits need none."""
    columns = {name: np.ascontiguousarray(answers[name]) for name in ("id", "factor")}
    columns |= {name: answers[name].astype(np.int8) for name in ("status", "leaving", "verdict")}
    return pa.RecordBatch.from_pydict(columns)


def answer(batches: Iterable[Any]) -> Iterator[Any]:
    """What each worker of Spark does."""
    for batch in batches:
        yield batch_of(grasps_of(batch).answered())


def carry(batches: Iterable[Any]) -> Iterator[Any]:
    """The table through Spark with nothing asked: what :func:`answer` costs beside its calls."""
    for batch in batches:
        grasps = grasps_of(batch)
        yield batch_of(np.zeros(len(grasps.id), dtype=ANSWER))


def table_of(grasps: ManyGrasps) -> Any:
    """The grasps as a table of Arrow, vectors as lists of doubles."""
    lists = {
        name: pa.FixedSizeListArray.from_arrays(pa.array(column.reshape(-1)), 3 * FINGERS).cast(pa.list_(pa.float64()))
        for name, column in (("points", grasps.points), ("normals", grasps.normals))
    }
    return pa.table({"id": grasps.id, **lists, "friction": grasps.friction, "squeeze": grasps.squeeze})


def answers_in(path: Path) -> Answers:
    """The answers that a table of SCHEMA has."""
    table = pq.read_table(path)
    answers = np.empty(table.num_rows, dtype=ANSWER)
    for name in ANSWER.names or ():
        answers[name] = table[name].to_numpy()
    return answers


def session(cores: int = 2) -> SparkSession:
    """A session of Spark on this machine, whose workers run this Python and take one core each."""
    # Beside `spark-submit` Spark reads only the environment for this, not `spark.pyspark.python`.
    os.environ["PYSPARK_PYTHON"] = sys.executable
    spark = (
        SparkSession.builder.master(f"local[{cores}]")
        .appName("grasp-lcp")
        .config("spark.executorEnv.RAYON_NUM_THREADS", "1")
        .config("spark.sql.files.maxPartitionBytes", str(SPLIT))
        .config("spark.ui.enabled", "false")
        .config("spark.ui.showConsoleProgress", "false")
        .getOrCreate()
    )
    spark.sparkContext.setLogLevel("ERROR")
    for file in (__file__, many_grasps.__file__):
        # Workers look functions up by the names of their modules.
        spark.sparkContext.addPyFile(str(file))
    return spark


def onsets_in_spark(grasps: DataFrame) -> DataFrame:
    """A table of grasps to a table of answers."""
    return grasps.mapInArrow(answer, SCHEMA)


def main(arguments: list[str] | None = None) -> int:
    """Asks in Spark and in one process, compares and prints; 1 if anything differs."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("grasps", type=int, nargs="?", default=1_000_000)
    rows = parser.parse_args(arguments).grasps
    clock = time.perf_counter
    with TemporaryDirectory() as folder:
        asked, alone, spread, carried = (Path(folder, name) for name in ("grasps.parquet", "alone.parquet", "spread", "carried"))
        pq.write_table(table_of(at_random(rows)), asked, row_group_size=50_000, compression="none")

        times = [clock()]
        (whole,) = pq.read_table(asked).combine_chunks().to_batches()
        grasps = grasps_of(whole)
        times.append(clock())
        expected = grasps.answered()
        times.append(clock())
        pq.write_table(pa.Table.from_batches([batch_of(expected)]), alone)
        times.append(clock())

        spark = session()
        onsets_in_spark(spark.read.parquet(str(asked)).limit(1)).collect()
        times.append(clock())
        onsets_in_spark(spark.read.parquet(str(asked))).write.parquet(str(spread))
        times.append(clock())
        spark.read.parquet(str(asked)).mapInArrow(carry, SCHEMA).write.parquet(str(carried))
        times.append(clock())
        comparison = compared(answers_in(spread), expected)
        spark.stop()

    print(paced("one process, the call alone", rows, times[2] - times[1]))
    print(paced("one process, from file to file", rows, times[3] - times[0]))
    print(paced("Spark on local[2], from file to file", rows, times[5] - times[4]))
    print(paced("Spark with nothing asked", rows, times[6] - times[5]))
    print(f"{'Spark until its workers answer a first row':<44}{times[4] - times[3]:8.3f} s")
    print(comparison)
    return 0 if comparison.same else 1


if __name__ == "__main__":
    sys.exit(main())
