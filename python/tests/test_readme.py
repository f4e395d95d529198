"""What the README prints is what its program prints, and every block of Python in it runs."""

import contextlib
import io
import re
from pathlib import Path

import numpy as np
import pytest

import grasp_lcp


def test_the_first_program_of_the_readme() -> None:
    text = (Path(__file__).parents[1] / "README.md").read_text()
    program, printed = re.findall(r"```(?:python|text)\n(.*?)```", text, flags=re.DOTALL)[:2]
    shown = io.StringIO()
    with contextlib.redirect_stdout(shown):
        exec(compile(program, "README.md", "exec"), {})
    assert shown.getvalue() == printed


@pytest.mark.parametrize("page", ["README.md", "python/README.md"])
def test_every_block_runs(page: str) -> None:
    """Blocks of Python run as they stand, with the arrays of many grasps that their text takes as given."""
    count, half = 50, np.array([[-0.04, 0.0], [0.04, 0.0]])
    given: dict[str, object] = {
        "points": half * np.linspace(0.8, 1.2, count)[:, None, None],
        "normals": np.array([[1.0, 0.0], [-1.0, 0.0]]),
        "direction": [0.0, -1.0],
        "mu": 0.5,
        "onsets": grasp_lcp.onsets,
        "onset_gradients": grasp_lcp.onset_gradients,
        "hold_batch": grasp_lcp.hold_batch,
        "need_batch": grasp_lcp.need_batch,
    }
    text = (Path(__file__).parents[2] / page).read_text()
    blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    assert blocks
    for block in blocks:
        exec(compile(block, page, "exec"), given)
    if page == "README.md":
        assert given["jaws"].onset([0, -1]).factor == pytest.approx(8.0)  # type: ignore[attr-defined]
    else:
        # Two jaws slide at 2 μ N, wherever they are level: N = 10 N by a command of 10 mm on 1000 N/m.
        assert given["found"].factor == pytest.approx(np.full(count, 10.0))  # type: ignore[attr-defined]
        assert given["verdicts"].holds.all()  # type: ignore[attr-defined]
        assert given["needed"].amount == pytest.approx(np.full(count, 0.1))  # type: ignore[attr-defined]
        assert given["slopes"].friction.sum(axis=-1) == pytest.approx(np.full(count, 20.0))  # type: ignore[attr-defined]


def test_the_block_for_accelerators_runs() -> None:
    jnp = pytest.importorskip("jax.numpy")
    from grasp_lcp.jax import onset_factor

    text = (Path(__file__).parents[1] / "README.md").read_text()
    (block,) = re.findall(r"```py\n(.*?)```", text, re.DOTALL)
    points = jnp.array([[[-0.04, 0.0], [0.04, 0.0]]])
    given = {"onset_factor": onset_factor, "points": points, "normals": -points, "direction": jnp.array([0.0, -1.0]), "mu": 0.5}
    exec(compile(block, "README.md", "exec"), given)
    # Two jaws of 8 N each.
    assert float(given["factor"][0]) == pytest.approx(8.0, rel=1e-6)
