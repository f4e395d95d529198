"""The tutorial runs as a script, writes its pictures, and what it prints is true."""

import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from itertools import pairwise
from pathlib import Path

import pytest

for needed in ("matplotlib", "scipy"):
    pytest.importorskip(needed, reason=f"{needed} is not installed: pip install 'grasp-lcp[test]'")

TUTORIAL = Path(__file__).parents[1] / "examples" / "tutorial.py"
PICTURES = ("tutorial_onsets.png", "tutorial_error.png", "tutorial_grasp.svg")
NUMBER = r"([-+0-9.e]+)"


def run(folder: Path, *arguments: str, **environment: str) -> str:
    """What the tutorial prints."""
    clean = {name: value for name, value in os.environ.items() if name != "GRASP_LCP_OUTPUT"}
    given = clean | {"MPLBACKEND": "agg"} | environment
    done = subprocess.run([sys.executable, str(TUTORIAL), *arguments], cwd=folder, env=given, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def ran(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """The folder it ran in, and what it printed."""
    folder = tmp_path_factory.mktemp("tutorial")
    printed = run(folder)
    print(printed)
    return folder, printed


def found(pattern: str, printed: str) -> tuple[float, ...]:
    """The numbers of the first line that matches."""
    match = re.search(pattern, printed)
    assert match is not None, f"{pattern} is not printed"
    return tuple(float(number) for number in match.groups())


def test_pictures_are_written(ran: tuple[Path, str]) -> None:
    for name in PICTURES:
        picture = ran[0] / "output" / name
        assert picture.stat().st_size > 10_000
        if picture.suffix == ".png":
            assert picture.read_bytes().startswith(b"\x89PNG")
    drawn = ElementTree.parse(ran[0] / "output" / "tutorial_grasp.svg").getroot()
    words = "".join(drawn.itertext())
    assert drawn.tag.endswith("svg") and "thumb" in words and "Onset of sliding" in words


def test_one_grasp_holds_less_than_its_contacts_could(ran: tuple[Path, str]) -> None:
    (epsilon,) = found(rf"ε: {NUMBER} N", ran[1])
    (least,) = found(rf"WeakestDirection: {NUMBER} N", ran[1])
    (does,) = found(rf"does hold: {NUMBER} N", ran[1])
    could, at_most = found(rf"could hold: <LoadLimit at factor {NUMBER} to {NUMBER}>", ran[1])
    assert does == pytest.approx(least, rel=1e-10)
    # The disagreement that the text is about; and no direction can be balanced less than ε says.
    assert least < epsilon < could <= at_most
    parts = re.split(r"under (?:half of that|ε along it): ", ran[1])
    assert len(parts) == 3 and parts[1].count(": sticks, force") == 3
    assert parts[2].count(": sticks, force") == 2 and ": slides, force" in parts[2]


def test_all_candidates_are_answered(ran: tuple[Path, str]) -> None:
    (candidates,) = found(rf"{NUMBER} candidates of three fingers", ran[1])
    (shape,) = found(r"<Onsets \((\d+), 200\): \d+ leaves", ran[1])
    counts = re.findall(r"(\d+) (\w+)[,>]", ran[1][ran[1].index("<Onsets") :].splitlines()[0])
    assert candidates == shape > 5000
    statuses = {"leaves", "never", "not_sticking", "gives_way", "unclear"}
    assert sum(int(count) for count, name in counts if name in statuses) == 200 * shape
    strong, of = found(rf"{NUMBER} of {NUMBER} candidates hold 4.905 N", ran[1])
    assert of == candidates and 0 < strong < candidates


def test_the_best_are_ranked_by_what_they_hold(ran: tuple[Path, str]) -> None:
    lines = ran[1].split("candidate   worst of 200 directions")[1].splitlines()[1:6]
    rows = [[float(word) for word in line.split()] for line in lines]
    worst = [row[1] for row in rows]
    assert worst == sorted(worst, reverse=True) and worst[0] > 4.905
    for _, sampled, exact, _ in rows:
        # No direction is weaker than the weakest, and 200 of them come near it.
        assert exact <= sampled + 1e-3 and sampled < 1.05 * exact


def test_errors_are_those_of_the_text(ran: tuple[Path, str]) -> None:
    table = ran[1].split("onset of sliding by")[1].splitlines()[1:9]
    errors: dict[str, tuple[float, float]] = {}
    for line in table:
        name, _, median, worst = re.split(r"\s{2,}", line.strip())
        errors[name] = float(median), float(worst)
    assert errors["onsets, all candidates"][1] < 1e-9
    assert errors["onsets, complete=True"] == errors["onsets, all candidates"]
    assert errors["Grasp.onset, one by one"][1] < 1e-12
    assert errors["numpy and scipy's bisection"][1] < 1e-9
    medians = [errors[f"polygon of {facets} facets"][0] for facets in (4, 8, 16, 32)]
    for coarse, fine in pairwise(medians):
        # Twice the facets miss a circle by a quarter.
        assert 2 < coarse / fine < 8
    assert 1e-3 < medians[-1] < 1e-2


def test_output_goes_where_it_is_told_to(tmp_path: Path) -> None:
    run(tmp_path, GRASP_LCP_OUTPUT="told")
    assert sorted(path.name for path in (tmp_path / "told").iterdir()) == sorted(PICTURES)
    run(tmp_path, "named", GRASP_LCP_OUTPUT="elsewhere")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["named", "told"]
