"""The search by ask and tell."""

from __future__ import annotations

import json
from typing import Any, Mapping, Optional, Sequence, Union

from . import _native
from .study import Design, Front, Record, Study


class Search:
    """The Bayesian search of ``parapet optimize`` by ask and tell.

    With one design asked and told at a time it asks for the designs that the program asks for with one
    job. Designs that were asked and not yet told are taken into account, so any number may be out.
    """

    def __init__(self, study: Study, *, seed: Optional[int] = None) -> None:
        """Begins a search.

        Args:
            seed: instead of the study's own.

        Raises:
            InputError: for a method other than BAYESIAN.
        """
        self.study = study if seed is None else study.changed(method={"seed": seed})
        self._native = _native.Search(self.study.native)
        self._out: dict[int, Design] = {}

    def ask(self, count: int = 1) -> list[Design]:
        """The next designs; fewer when the search needs answers first, none when it is over."""
        designs = []
        for _ in range(count):
            asked = self._native.ask()
            if asked is None:
                break
            id, values, spacing, stage = asked
            self._out[id] = Design(values, id, spacing, stage)
            designs.append(self._out[id])
        return designs

    def tell(
        self,
        designs: Union[Design, Sequence[Design]],
        records: Union[Mapping[str, Any], Sequence[Mapping[str, Any]]],
    ) -> None:
        """The answers, in the order of the designs.

        Raises:
            ValueError: for a record of another design than the one that was asked.
        """
        asked = [designs] if isinstance(designs, Design) else list(designs)
        answers = [records] if isinstance(records, Mapping) else list(records)
        if len(asked) != len(answers):
            raise ValueError(f"{len(asked)} designs, but {len(answers)} records")
        for design, record in zip(asked, answers):
            self._native.tell(design.id, json.dumps(record))
            self._out.pop(design.id, None)

    def tell_other(self, record: Mapping[str, Any]) -> None:
        """A design that nobody asked for, evaluated at one of the study's spacings."""
        self._native.tell_other(json.dumps(record))

    @property
    def pending(self) -> list[Design]:
        """Asked and not told."""
        return list(self._out.values())

    @property
    def stop_reason(self) -> str:
        """Why nothing more is asked: ``budget``, ``stagnation``, ...; empty while it goes on."""
        return self._native.stop_reason()

    @property
    def records(self) -> list[Record]:
        """What was told, in order."""
        return [Record(one) for one in self._native.records()]

    def front(self) -> Front:
        """The best trade-offs of what was told."""
        return Front(*self._native.front())

    def front_json(self) -> dict[str, Any]:
        """The same with the surrogates' estimates: the content of ``pareto.json``."""
        return self._native.front_json()
