"""What can go wrong, as exceptions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Sequence


@dataclass(frozen=True)
class Issue:
    """One thing that is wrong in an input.

    Attributes:
        file: where the input came from, as it was given.
        pointer: JSON pointer to the place, for example ``/barriers/0/height_m``.
        value: what stands there, as JSON text; empty when something is missing.
        problem: one sentence saying what is wrong.
        allowed: what is allowed there.
    """

    file: str
    pointer: str
    value: str
    problem: str
    allowed: str

    def __str__(self) -> str:
        parts = [part for part in (self.file, self.pointer, self.value) if part]
        text = ": ".join([*parts, self.problem])
        return f"{text}; allowed: {self.allowed}" if self.allowed else text


class InputError(ValueError):
    """Bad input: every issue at once.

    Attributes:
        issues: at least one :class:`Issue`.
        file, pointer, value: those of the first issue.
    """

    def __init__(self, issues: Sequence[Issue]) -> None:
        super().__init__("\n".join(str(issue) for issue in issues))
        self.issues = tuple(issues)

    @property
    def file(self) -> str:
        return self.issues[0].file

    @property
    def pointer(self) -> str:
        return self.issues[0].pointer

    @property
    def value(self) -> str:
        return self.issues[0].value

    def __reduce__(self) -> tuple[type, tuple[Sequence[Issue]]]:
        return (type(self), (self.issues,))


class FileError(OSError):
    """A file cannot be read or written; the message names it and says why."""
