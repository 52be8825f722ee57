"""Simulations of one case."""

from __future__ import annotations

import html
import json
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Mapping, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _native
from .case import Case, PathLike, load_case
from .units import millimetres

if TYPE_CHECKING:
    import pandas

Progress = Callable[[float, float], None]


@dataclass(frozen=True)
class Frame:
    """The particles at one instant.

    Attributes:
        time_s: time since the release [s].
        x_m, z_m: position in channel axes, x along the bed and z normal to it, float32 [n_particles] [m].
        u_m_s, w_m_s: velocity along x and z, float32 [n_particles] [m/s].
        pressure_pa: float32 [n_particles] [Pa].
    """

    time_s: float
    x_m: NDArray[np.float32]
    z_m: NDArray[np.float32]
    u_m_s: NDArray[np.float32]
    w_m_s: NDArray[np.float32]
    pressure_pa: NDArray[np.float32]

    @property
    def speed_m_s(self) -> NDArray[np.float32]:
        """Speed, float32 [n_particles] [m/s]."""
        return np.hypot(self.u_m_s, self.w_m_s)


class Result:
    """What one simulation gave.

    Attributes:
        case: the case that was simulated, every default written out.
        json: the content of ``result.json`` of ``parapet simulate``: the same, but for ``timing``.
        series: structured array [n_samples], one float64 field for each quantity (``time_s`` first; the
            names carry the units); NaN where a quantity is not defined.
        frames: :class:`Frame` objects, evenly spread over the run; the last state is among them.
    """

    def __init__(self, answer: Mapping[str, Any]) -> None:
        self.json: dict[str, Any] = answer["json"]
        self.case = Case(self.json["case"], self.json["name"])
        columns = list(answer["columns"])
        table = np.frombuffer(answer["series"], dtype=np.float64).reshape(-1, max(1, len(columns)))
        self.series: NDArray[np.void] = np.zeros(len(table), dtype=[(c, np.float64) for c in columns])
        for k, column in enumerate(columns):
            self.series[column] = table[:, k]
        self.frames = [
            Frame(time, *(np.frombuffer(part, dtype=np.float32) for part in parts))
            for time, *parts in answer["frames"]
        ]

    @property
    def ok(self) -> bool:
        """Whether the run ended well."""
        return bool(self.json["status"] == "ok")

    @property
    def reason(self) -> str:
        """Why it did not; empty for a run that ended well."""
        return str(self.json["reason"])

    @property
    def metrics(self) -> dict[str, Optional[float]]:
        """Every metric (docs/metrics.md); the names carry the units. None where there is no value."""
        metrics: dict[str, Optional[float]] = self.json["metrics"]
        return metrics

    @property
    def metrics_absent(self) -> dict[str, str]:
        """Why a metric has no value."""
        absent: dict[str, str] = self.json["metrics_absent"]
        return absent

    @property
    def uncertainty(self) -> dict[str, dict[str, Any]]:
        """Of each metric, where it was asked for: ``expanded_95`` and its parts, in the metric's unit."""
        uncertainty: dict[str, dict[str, Any]] = self.json.get("uncertainty", {})
        return uncertainty

    @property
    def warnings(self) -> list[dict[str, Any]]:
        """What the result must not be read without: key, value, limit and a sentence."""
        warnings: list[dict[str, Any]] = self.json["warnings"]
        return warnings

    def to_frame(self) -> pandas.DataFrame:
        """The series as a pandas DataFrame with the time [s] as index."""
        import pandas

        return pandas.DataFrame(self.series).set_index("time_s")

    def save(self, path: PathLike) -> None:
        """Writes ``result.json``."""
        with open(path, "w", encoding="utf-8") as file:
            json.dump(self.json, file, indent=2, ensure_ascii=False)
            file.write("\n")

    def __repr__(self) -> str:
        retained = self.metrics.get("retention_efficiency")
        text = "" if retained is None else f", retention_efficiency {retained:.4g}"
        return f"<Result {self.json['name']!r}: {self.json['status']}{text}>"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{html.escape(key)}</td><td>{'-' if value is None else format(value, '.6g')}</td></tr>"
            for key, value in self.metrics.items()
        )
        notes = "".join(f"<p>{html.escape(str(one['text']))}</p>" for one in self.warnings)
        return f"{self.case._repr_svg_()}{notes}<table>{rows}</table>"


def simulate(
    case: Union[Case, PathLike, Mapping[str, Any]],
    *,
    spacing_m: Optional[float] = None,
    uncertainty: bool = False,
    threads: Optional[int] = None,
    jobs: Optional[int] = None,
    frames: int = 48,
    progress: Optional[Progress] = None,
) -> Result:
    """Simulates one case. Ctrl-C ends it; other Python threads go on meanwhile.

    Args:
        case: a :class:`Case`, a file, the name of a shipped case, or its content.
        spacing_m: particle spacing instead of the case's [m].
        uncertainty: give each metric its numerical uncertainty (95 %) from eight further, coarser runs.
        threads: of the simulation; the result does not depend on it. Default: as many cores as help.
        jobs: with ``uncertainty``, simulations side by side.
        frames: states of the particles to keep, at most; 0 for none. The result does not depend on it.
        progress: called with the time that is simulated and the time at which the run ends at the
            latest [s].

    Raises:
        InputError: for a wrong case. A run that goes wrong is a result with ``ok`` false.
    """
    given = case if isinstance(case, Case) else load_case(case)
    answer = _native.simulate(
        given.text(),
        given.source_file,
        millimetres(spacing_m),
        threads,
        jobs or len(os.sched_getaffinity(0)),
        uncertainty,
        frames,
        progress,
    )
    return Result(answer)
