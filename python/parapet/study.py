"""Studies: what may vary, what is wanted, and designs judged by it."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import Any, Iterable, Mapping, Optional, Sequence, Union, overload

from . import _native
from .case import Case, PathLike
from .units import millimetres

Value = Union[float, str]


def cores() -> int:
    """Cores that this process may use."""
    return len(os.sched_getaffinity(0))


def _text(value: Mapping[str, Any]) -> str:
    def plain(item: Any) -> Any:
        return item.item() if hasattr(item, "item") else item

    return json.dumps({str(key): plain(item) for key, item in value.items()}, allow_nan=False)


class Design(dict[str, Value]):
    """A design that a search asks for: a number for each active variable, an option's name for a choice.

    Attributes:
        id: number of the question; :meth:`Search.tell` needs it.
        spacing_m: particle spacing at which it is wanted [m].
        stage: ``start``, ``initial``, ``search``, ``explore`` or ``confirm``.
    """

    def __init__(self, values: Mapping[str, Value], id: int, spacing_m: float, stage: str) -> None:
        super().__init__(values)
        self.id = id
        self.spacing_m = spacing_m
        self.stage = stage


class Record(dict[str, Any]):
    """An evaluated design, as it stands in a study's log (docs/guide.md)."""

    @property
    def ok(self) -> bool:
        """Whether every simulation ended well and every objective has a value."""
        return bool(self["status"] == "ok")

    @property
    def feasible(self) -> bool:
        """Whether it meets every constraint."""
        return bool(self["feasible"])

    @property
    def metrics(self) -> dict[str, Optional[float]]:
        """Metrics; with scenarios their weighted means. None where there is no value."""
        metrics: dict[str, Optional[float]] = self["metrics"]
        return metrics

    @property
    def objectives(self) -> dict[str, Optional[float]]:
        """Value of each objective by its name, in its own unit and sense."""
        return {one["metric"]: one["value"] for one in self["objectives"]}

    @property
    def scalar(self) -> Optional[float]:
        """The weighted sum of the objectives, to be minimised; None when failed."""
        scalar: Optional[float] = self["objective_scalar"]
        return scalar

    @property
    def spacing_m(self) -> float:
        """Particle spacing [m]."""
        return float(self["spacing_m"])

    def __repr__(self) -> str:
        parts = [f"{name} {value:.4g}" for name, value in self.objectives.items() if value is not None]
        if not self.ok:
            parts = [f"failed: {self['reason']}"]
        elif not self.feasible:
            parts.append("not feasible")
        return f"<Record {self['id']}: {', '.join(parts)}>"


class Front(Sequence[Record]):
    """The best trade-offs: feasible designs at the finest spacing that none dominates.

    Attributes:
        hypervolume: that they dominate, in the product of the objectives' units.
    """

    def __init__(self, records: Iterable[Mapping[str, Any]], hypervolume: float) -> None:
        self._records = [Record(record) for record in records]
        self.hypervolume = hypervolume

    @overload
    def __getitem__(self, index: int) -> Record: ...
    @overload
    def __getitem__(self, index: slice) -> list[Record]: ...
    def __getitem__(self, index: Union[int, slice]) -> Union[Record, list[Record]]:
        return self._records[index]

    def __len__(self) -> int:
        return len(self._records)

    def __repr__(self) -> str:
        return f"<Front of {len(self)} design(s), hypervolume {self.hypervolume:.4g}>"


@dataclass(frozen=True)
class Variable:
    """An input that may vary: ``kind`` is ``continuous``, ``integer`` or ``choice`` (with options).

    Bounds are in the unit that the name carries.
    """

    name: str
    kind: str
    lower: float
    upper: float
    options: tuple[str, ...]


class Study:
    """What may vary, what is wanted, under which events (docs/studies.md).

    Attributes:
        records: what was evaluated through this object, in order.
    """

    def __init__(
        self, source: Union[PathLike, Mapping[str, Any]], *, spacing_m: Optional[float] = None
    ) -> None:
        """Reads a study: a file, the name of a shipped one, or its content.

        Args:
            spacing_m: one particle spacing instead of the study's own [m].

        Raises:
            InputError: with every mistake in it.
        """
        if isinstance(source, Mapping):
            text = json.dumps(source, allow_nan=False)
            name = str(source.get("name", "study"))
            self.native = _native.Study.parse(text, name, millimetres(spacing_m))
        else:
            self.native = _native.Study.load(os.fspath(source), millimetres(spacing_m))
        self.records: list[Record] = []

    @classmethod
    def of(cls, native: _native.Study) -> Study:
        """A study that was read already."""
        study = cls.__new__(cls)
        study.native = native
        study.records = []
        return study

    @property
    def name(self) -> str:
        return self.native.name

    @property
    def variables(self) -> list[Variable]:
        """In the study's order."""
        return [Variable(n, k, lo, up, tuple(o)) for n, k, lo, up, o in self.native.variables()]

    @property
    def objectives(self) -> dict[str, str]:
        """``maximize`` or ``minimize`` by the objective's name."""
        return {name: "maximize" if up else "minimize" for name, up in self.native.objectives()}

    @property
    def scenarios(self) -> dict[str, float]:
        """Weight of each scenario; empty: the case's own event is the only one."""
        return dict(self.native.scenarios())

    @property
    def spacings_m(self) -> list[float]:
        """Particle spacings at which designs may be simulated, finest first [m]."""
        return list(self.native.spacings())

    @property
    def spec(self) -> dict[str, Any]:
        """A copy of the study's file with every default written out."""
        return self.native.resolved()

    def changed(self, **members: Any) -> Study:
        """Another study: this one with members of its file replaced, for example ``scenarios=[...]``.

        A dict is merged into the one that is there: ``changed(method={"seed": 2})``.
        """
        spec = self.spec
        for key, value in members.items():
            if isinstance(value, Mapping) and isinstance(spec.get(key), dict):
                spec[key] = {**spec[key], **value}
            else:
                spec[key] = value
        return Study(spec)

    def save(self, path: PathLike) -> None:
        """Writes the study's file."""
        with open(path, "w", encoding="utf-8") as file:
            json.dump(self.spec, file, indent=2)
            file.write("\n")

    def case(
        self,
        design: Mapping[str, Value],
        *,
        scenario: Optional[str] = None,
        spacing_m: Optional[float] = None,
    ) -> Case:
        """The case of a design, under a scenario (default: the base event)."""
        data = self.native.design_case(_text(design), scenario or "", spacing_m)
        return Case(data, self.name)

    def violations(self, design: Mapping[str, Value]) -> list[float]:
        """How far a design is beyond each limit on a formula, scaled; <= 0 is within. Simulates nothing."""
        return list(self.native.violations(_text(design)))

    def evaluate(
        self,
        design: Mapping[str, Value],
        *,
        spacing_m: Optional[float] = None,
        scenario: Optional[str] = None,
        jobs: Optional[int] = None,
    ) -> Record:
        """Simulates a design under every event, or one, and judges it. Ctrl-C ends it.

        Args:
            spacing_m: particle spacing [m]; default: what a search asked for, else the finest.
            jobs: simulations side by side; where there are fewer events, threads of each.

        Raises:
            InputError: for a wrong design. A simulation that fails is a record with ``ok`` false.
        """
        return self._evaluate([design], spacing_m, scenario, jobs)[0]

    def evaluate_all(
        self,
        designs: Iterable[Mapping[str, Value]],
        *,
        spacing_m: Optional[float] = None,
        scenario: Optional[str] = None,
        jobs: Optional[int] = None,
    ) -> list[Record]:
        """The same for several designs, as many simulations side by side as there are ``jobs``."""
        return self._evaluate(list(designs), spacing_m, scenario, jobs)

    def _evaluate(
        self,
        designs: Sequence[Mapping[str, Value]],
        spacing_m: Optional[float],
        scenario: Optional[str],
        jobs: Optional[int],
    ) -> list[Record]:
        questions = []
        for design in designs:
            own = design.spacing_m if isinstance(design, Design) else None
            questions.append((_text(design), spacing_m if spacing_m is not None else own, scenario or ""))
        if not questions:
            return []
        records = [Record(one) for one in self.native.evaluate(questions, jobs or cores())]
        for record in records:
            record["id"] = f"{len(self.records) + 1:04d}"
            self.records.append(record)
        return records

    def front(self, records: Optional[Iterable[Mapping[str, Any]]] = None) -> Front:
        """The best trade-offs among records; default: what was evaluated through this object."""
        chosen: Iterable[Mapping[str, Any]] = self.records if records is None else records
        return Front(*_native.front(self.native, [json.dumps(record) for record in chosen]))

    def __repr__(self) -> str:
        return (
            f"<Study {self.name!r}: {len(self.variables)} variable(s), "
            f"{len(self.objectives)} objective(s), {len(self.records)} evaluated>"
        )
