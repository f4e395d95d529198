"""What the README prints is what its program prints."""

import contextlib
import io
import re
from pathlib import Path


def test_the_first_program_of_the_readme() -> None:
    text = (Path(__file__).parents[1] / "README.md").read_text()
    program, printed = re.findall(r"```(?:python|text)\n(.*?)```", text, flags=re.DOTALL)[:2]
    shown = io.StringIO()
    with contextlib.redirect_stdout(shown):
        exec(compile(program, "README.md", "exec"), {})
    assert shown.getvalue() == printed
