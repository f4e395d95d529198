"""Two contacts in space: coordinate axes in such an order that their free motion, the rotation about the line between them, has the last pivot.

That pivot is rounding. With the axis closest to the line last, no other pivot is small, so that rounding does not decide which motion is free.
"""

from __future__ import annotations

from typing import Any


class AlongTheLine:
    """A cyclic order of the axes for each scene, the axis closest to the line last."""

    def __init__(self, xp: Any, points: Any) -> None:
        self.xp = xp
        x, y, z = (abs(points[..., 1, k] - points[..., 0, k]) for k in range(3))
        self.is_x = (x >= y) & (x >= z)
        self.is_y = ~self.is_x & (y >= z)

    def _cycled(self, of: Any, first: Any, second: Any) -> Any:
        """Vectors (..., 3) with axes one place on, y z x, where ``first`` says so, and two places on where ``second`` does."""
        behind = (1,) * (of.ndim - first.ndim)
        first, second = first.reshape(*first.shape, *behind), second.reshape(*second.shape, *behind)
        x, y, z = (of[..., k : k + 1] for k in range(3))
        one, two = (self.xp.concatenate(each, axis=-1) for each in ((y, z, x), (z, x, y)))
        return self.xp.where(first, one, self.xp.where(second, two, of))

    def _all(self, data: list[Any], first: Any, second: Any) -> list[Any]:
        def load(of: Any) -> Any:
            return self.xp.concatenate([self._cycled(half, first, second) for half in (of[..., :3], of[..., 3:])], axis=-1)

        points, normals, friction, stiffness, command, base, direction = data
        vectors = [self._cycled(each, first, second) for each in (points, normals, command)]
        return [vectors[0], vectors[1], friction, stiffness, vectors[2], load(base), load(direction)]

    def there(self, data: list[Any]) -> list[Any]:
        """Data, or derivatives by them, along these axes."""
        return self._all(data, self.is_x, self.is_y)

    def back(self, data: list[Any]) -> list[Any]:
        """The same along the axes given."""
        return self._all(data, self.is_y, self.is_x)
