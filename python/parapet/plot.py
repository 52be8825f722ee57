"""Pictures with matplotlib, which is only needed here."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Optional, Sequence, Union

import numpy as np

from .advice import StudyFolder
from .search import Search
from .simulation import Frame, Result
from .study import Front, Study

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


def _moving(frames: Sequence[Frame], count: int) -> list[Frame]:
    """Frames of the time in which the flow moves, evenly spread."""
    energy = [float(np.sum(frame.speed_m_s**2)) for frame in frames]
    level = 0.02 * max(energy, default=0.0)
    moving = [k for k, value in enumerate(energy) if value >= level]
    first, last = (moving[0], moving[-1]) if moving else (0, len(frames) - 1)
    chosen = np.unique(np.linspace(first, last, count).round().astype(int))
    return [frames[k] for k in chosen]


def flow(result: Result, *, panels: int = 6, columns: int = 2) -> Figure:
    """The particles coloured by speed [m/s] at several times, gravity down, lengths in m."""
    import matplotlib.pyplot as plt

    if not result.frames:
        raise ValueError("no frames were kept: simulate with frames greater than 0")
    frames = _moving(result.frames, panels)
    scene = result.case.scene()
    slope = math.radians(scene["slope_deg"])
    c, s = math.cos(slope), math.sin(slope)
    rows = math.ceil(len(frames) / columns)
    figure, grid = plt.subplots(
        rows, columns, figsize=(6.5 * columns, 2.9 * rows), sharex=True, sharey=True, squeeze=False,
        layout="constrained",
    )
    fastest = max(float(frame.speed_m_s.max(initial=0.0)) for frame in frames)
    dots = None
    for axes, frame in zip(grid.flat, frames):
        dots = axes.scatter(
            frame.x_m * c + frame.z_m * s,
            frame.z_m * c - frame.x_m * s,
            c=frame.speed_m_s, s=2.0, vmin=0.0, vmax=fastest, cmap="viridis", linewidths=0,
        )
        outlines = [barrier["outline"] for barrier in scene["barriers"]] + scene["solids"]
        for outline in outlines:
            x, z = np.array(outline).T
            axes.fill(x * c + z * s, z * c - x * s, color="#39424e")
        reach = scene["domain"]["length_m"]
        axes.plot([0.0, reach * c], [0.0, -reach * s], color="#39424e")
        axes.set_title(f"{frame.time_s:.2f} s", fontsize=9)
        axes.set_aspect("equal")
    for axes in list(grid.flat)[len(frames) :]:
        axes.set_visible(False)
    if dots is not None:
        figure.colorbar(dots, ax=grid, label="speed [m/s]")
    return figure


def series(result: Result, names: Union[str, Sequence[str]], *, ax: Optional[Axes] = None) -> Axes:
    """Quantities of the time series over time [s]."""
    import matplotlib.pyplot as plt

    axes = plt.subplots()[1] if ax is None else ax
    for name in [names] if isinstance(names, str) else names:
        axes.plot(result.series["time_s"], result.series[name], label=name)
    axes.set_xlabel("time [s]")
    axes.legend()
    return axes


def front(
    source: Union[Study, Search, StudyFolder],
    *,
    objectives: Optional[tuple[str, str]] = None,
    ax: Optional[Axes] = None,
) -> Axes:
    """Two objectives of every design that ended well, and the best trade-offs among them.

    Args:
        objectives: their names; default: the first two.
    """
    import matplotlib.pyplot as plt

    study = source if isinstance(source, Study) else source.study
    names = list(study.objectives)
    if len(names) < 2:
        raise ValueError("a front needs two objectives; the study has one")
    first, second = objectives or (names[0], names[1])
    records, best = source.records, source.front()
    finest = study.spacings_m[0]
    axes = plt.subplots()[1] if ax is None else ax
    for text, keep in (("tried", True), ("not feasible", False)):
        chosen = [r for r in records if r.ok and r.feasible is keep and r.spacing_m == finest]
        axes.scatter(
            [r.objectives[first] for r in chosen], [r.objectives[second] for r in chosen],
            s=12, color="0.6" if keep else "#d08770", marker="o" if keep else "x", label=text,
        )
    _mark(axes, best, first, second)
    axes.set_xlabel(first)
    axes.set_ylabel(second)
    axes.legend()
    return axes


def _mark(axes: Axes, best: Front, first: str, second: str) -> None:
    points = sorted((r.objectives[first], r.objectives[second]) for r in best)  # type: ignore[type-var]
    axes.plot([p[0] for p in points], [p[1] for p in points], "o-", color="#2e6f9e", label="front")
