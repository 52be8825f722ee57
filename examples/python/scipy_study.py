"""A SciPy optimiser on a study: Parapet judges the designs, SciPy chooses them.

Differential evolution asks for a generation at a time; the study's own scalar (the weighted sum of its
objectives) is what it minimises, and a design that breaks a constraint gets a penalty.

    python3 examples/python/scipy_study.py [SPACING_MM] [GENERATIONS]
"""

from __future__ import annotations

import sys

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import differential_evolution

import parapet as pp

FAILED = 1e3
"""Worse than any design."""

PENALTY = 10.0
"""Worse than any feasible design, and worse the farther beyond its limits a design is."""


def judge(study: pp.Study, x: NDArray[np.float64]) -> list[float]:
    """Value of each design of a generation [n_designs]; x is [n_variables, n_designs]."""
    names = [variable.name for variable in study.variables]
    designs = [dict(zip(names, map(float, column))) for column in np.atleast_2d(x.T)]
    beyond = [max(0.0, *study.violations(design), 0.0) for design in designs]
    allowed = [design for design, excess in zip(designs, beyond) if excess <= 0.0]
    records = iter(study.evaluate_all(allowed))
    values = []
    for excess in beyond:
        if excess > 0.0:  # refused by a formula: nothing was simulated
            values.append(FAILED * (1.0 + excess))
            continue
        record = next(records)
        margins = [one["margin"] for one in record["constraints"] if not one["satisfied"]]
        short = sum(-margin for margin in margins if margin is not None)
        if record.scalar is None:
            values.append(FAILED)
        else:
            values.append(record.scalar if record.feasible else record.scalar + PENALTY * (1.0 + short))
    return values


def main(spacing_mm: float = 15.0, generations: float = 3) -> pp.Record:
    study = pp.Study("quickstart", spacing_m=spacing_mm / 1000.0)
    bounds = [(variable.lower, variable.upper) for variable in study.variables]
    first = study.spec["method"]["starts"][0]  # a design that people have thought of
    result = differential_evolution(
        lambda x: np.array(judge(study, np.asarray(x))),
        bounds,
        maxiter=int(generations),
        popsize=4,
        seed=1,
        x0=[first[variable.name] for variable in study.variables],
        polish=False,
        vectorized=True,
        updating="deferred",
    )
    feasible = [r for r in study.records if r.ok and r.feasible]
    record = min(feasible, key=lambda r: float("inf") if r.scalar is None else r.scalar)
    assert record.scalar == result.fun
    print(f"{len(study.records)} designs; best {record!r}")
    for name, value in record["design"].items():
        print(f"  {name} {value:.4g}")
    return record


if __name__ == "__main__":
    main(*(float(word) for word in sys.argv[1:]))
