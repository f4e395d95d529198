"""Base class of answers, and converters from the JSON data of the scene format to arrays."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from typing import Any, Literal, TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._grasp_lcp import words_of, words_of_name, words_of_number

Array = NDArray[np.float64]
# A load: an array of a force, or of a force and a moment, or a mapping as in scenes: {"force": ..., "moment": ..., "at": ...} or
# {"mass": ..., "at": ..., "gravity": ..., "accelerated": ..., "inertia": ..., "turning": ...}.
Load: TypeAlias = ArrayLike | Mapping[str, Any]
Quantity: TypeAlias = Literal["squeeze", "friction", "load", "arm", "angle", "force"]
Tree = dict[str, Any]

# Words of the scene format for numbers that JSON does not have.
_WORDS = {"infinite": float("inf"), "-infinite": float("-inf"), "not a number": float("nan")}

ViewT = TypeVar("ViewT", bound="View")


def number(value: Any) -> float:
    """Converts a number of the scene format, which may be a word for infinity or NaN."""
    return _WORDS[value] if isinstance(value, str) else float(value)


def optional_number(value: Any) -> float | None:
    """Converts a number of the scene format, or None if it is absent."""
    return None if value is None else number(value)


def _numbers(value: Any) -> Any:
    return [_numbers(item) for item in value] if isinstance(value, list) else number(value)


def array(value: Any) -> Array:
    """A read-only array, so that answers cannot be changed by accident."""
    made = np.array(_numbers(value), dtype=np.float64)
    made.setflags(write=False)
    return made


def rows(values: Iterable[Any], columns: int) -> Array:
    """A read-only array of shape (rows, columns), also if there are no rows."""
    made = np.array([_numbers(value) for value in values], dtype=np.float64).reshape(-1, columns)
    made.setflags(write=False)
    return made


def _joined(first: Any, second: Any) -> list[Any]:
    return [*first, *(second if isinstance(second, list) else [second])]


def load_of(tree: Mapping[str, Any]) -> Array:
    """Force and moment of a load, joined to one row."""
    return array(_joined(tree["force"], tree["moment"]))


def motion_of(tree: Mapping[str, Any]) -> Array:
    """Translation and rotation of a motion, joined to one row."""
    return array(_joined(tree["translation"], tree["rotation"]))


def motions_of(trees: Iterable[Mapping[str, Any]], columns: int) -> Array:
    """Motions, one a row, shape (k, columns)."""
    return rows((_joined(tree["translation"], tree["rotation"]) for tree in trees), columns)


def axes_of(data: Any) -> int | None:
    """Number of coordinate axes of the first force or translation in the data of an answer; None without one."""
    if isinstance(data, list):
        return next(filter(None, map(axes_of, data)), None)
    if not isinstance(data, dict):
        return None
    found = next((data[name] for name in ("force", "translation") if isinstance(data.get(name), list)), None)
    return axes_of(list(data.values())) if found is None else len(found)


def short(values: Iterable[float]) -> str:
    """Numbers in brackets for a ``repr``, with six digits."""
    return "(" + ", ".join(words_of_number(value) for value in values) + ")"


def label_of(tree: Mapping[str, Any], kind: str) -> str:
    """The label of a contact, a joint or a tendon: its name with control characters escaped, or its kind and its number."""
    return words_of_name(str(tree["name"])) if tree.get("name") else f"{kind} {tree[kind]}"


class View:
    """A part of an answer. Two views are equal if their types and all their data are equal."""

    def __init__(self, tree: Tree) -> None:
        self._own = tree

    @property
    def _tree(self) -> Tree:
        return self._own

    @classmethod
    def from_dict(cls: type[ViewT], tree: Mapping[str, Any]) -> ViewT:
        """Restores an answer from the dictionary that :meth:`to_dict` returned."""
        return cls.from_json(json.dumps(tree))

    @classmethod
    def from_json(cls: type[ViewT], text: str) -> ViewT:
        """Restores an answer from the text that :meth:`to_json` returned."""
        tree = json.loads(text)
        if not isinstance(tree, dict):
            raise ValueError(f"text: a {type(tree).__name__} of JSON given, must be an object")
        return cls(tree)

    def to_json(self) -> str:
        """The answer as JSON text in the format of scenes. Reading it back gives the same bits of every number."""
        return json.dumps(self._tree)

    def to_dict(self) -> Tree:
        """The answer as a new dictionary in the format of scenes."""
        tree: Tree = json.loads(self.to_json())
        return tree

    def _words(self, kind: str, axes: int) -> str:
        """The description that the crate prints for this part of an answer."""
        return words_of(kind, self.to_json(), axes)

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and isinstance(other, View) and other._tree == self._tree

    def __hash__(self) -> int:
        return hash((type(self), json.dumps(self._tree, sort_keys=True)))

    def __reduce__(self) -> tuple[Any, ...]:
        return (_restored, (type(self), self.to_json()))


def _restored(kind: type[ViewT], text: str) -> ViewT:
    return kind.from_json(text)
