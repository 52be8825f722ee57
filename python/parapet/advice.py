"""Studies on disk, and which of their designs to build."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Iterator, Mapping, Optional, Sequence

from . import _native
from .case import PathLike
from .study import Front, Record, Study, Value, cores


class Recommendation:
    """Which design to build, and what is known of it.

    Attributes:
        json: the content of ``recommendation.json``.
        text: the same in words, as Markdown.
    """

    def __init__(self, content: dict[str, Any], text: str) -> None:
        self.json = content
        self.text = text

    @property
    def design(self) -> Optional[dict[str, Value]]:
        """The recommended design; None when none meets every constraint."""
        recommended = self.json.get("recommended")
        return None if recommended is None else dict(recommended["design"])

    def _repr_markdown_(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<Recommendation: {self.design}>"


def recommend(
    folder: PathLike,
    *,
    rule: str = "",
    weights: Optional[Mapping[str, float]] = None,
    limits: Sequence[str] = (),
    confirm: bool = False,
    repeats: int = 2,
    jobs: Optional[int] = None,
) -> Recommendation:
    """Advice from a study's folder; writes nothing unless it is to confirm.

    Args:
        rule: ``best``, ``knee``, ``balanced``, ``weights`` or ``limits``; default as in ``parapet recommend``.
        weights: of the objectives, for the rule ``weights``.
        limits: such as ``launch_length_m<=0.1``, for the rule ``limits``.
        confirm: simulate the design again with ``repeats`` near ones first (``confirmations.jsonl``).
    """
    listed = ",".join(f"{name}={value!r}" for name, value in (weights or {}).items())
    content, text = _native.recommend(
        os.fspath(folder), rule, listed, list(limits), confirm, repeats, jobs or cores()
    )
    return Recommendation(content, text)


@dataclass(frozen=True)
class StudyFolder:
    """A folder of ``parapet optimize``.

    Attributes:
        state: ``running``, ``done``, ``interrupted`` or ``failed``; empty when there is no summary.
        confirmations: runs that confirm a recommended design.
        damage: a sentence for each line or file that is not what was written.
    """

    study: Study
    state: str
    records: list[Record]
    confirmations: list[Record]
    damage: list[str]

    def front(self) -> Front:
        """The best trade-offs in the log."""
        return self.study.front(self.records)

    def __iter__(self) -> Iterator[Record]:
        return iter(self.records)


def load_study_folder(folder: PathLike) -> StudyFolder:
    """Reads a study's folder and changes nothing; it may belong to a study that still runs."""
    loaded = _native.load_folder(os.fspath(folder))
    return StudyFolder(
        Study.of(loaded["study"]),
        loaded["state"],
        [Record(one) for one in loaded["records"]],
        [Record(one) for one in loaded["confirmations"]],
        list(loaded["damage"]),
    )
