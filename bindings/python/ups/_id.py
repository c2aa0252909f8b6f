"""What the ids of things have in common. Called by _ffi, whose ids are structs of C."""
from __future__ import annotations


class Id:
    """Equal where they are of one kind and name the same thing."""
    v: int

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Id) and type(other) is type(self) and other.v == self.v

    def __hash__(self) -> int:
        return hash((type(self), self.v))

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.v})"
