"""Optuna on a study with two objectives and constraints, by its own ask and tell.

    apt-get install python3-optuna        # or pip install optuna
    python3 examples/python/optuna_study.py [SPACING_MM] [TRIALS]
"""

from __future__ import annotations

import sys
import warnings
from typing import Any, Sequence

import optuna

import parapet as pp


def design_of(study: pp.Study, trial: Any) -> dict[str, float | str]:
    """What Optuna suggests for each variable of the study."""
    design: dict[str, float | str] = {}
    for variable in study.variables:
        if variable.kind == "choice":
            design[variable.name] = trial.suggest_categorical(variable.name, variable.options)
        elif variable.kind == "integer":
            design[variable.name] = trial.suggest_int(variable.name, int(variable.lower), int(variable.upper))
        else:
            design[variable.name] = trial.suggest_float(variable.name, variable.lower, variable.upper)
    return design


def beyond_limits(trial: Any) -> Sequence[float]:
    """Constraints as Optuna wants them: <= 0 is met."""
    limits: Sequence[float] = trial.user_attrs["beyond"]
    return limits


def main(spacing_mm: float = 15.0, trials: float = 12) -> pp.Front:
    study = pp.Study("dual_deflector", spacing_m=spacing_mm / 1000.0)
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    warnings.simplefilter("ignore", optuna.exceptions.ExperimentalWarning)  # constraints_func
    sampler = optuna.samplers.NSGAIISampler(seed=1, population_size=6, constraints_func=beyond_limits)
    search = optuna.create_study(directions=list(study.objectives.values()), sampler=sampler)
    while len(study.records) < int(trials):
        trial = search.ask()
        design = design_of(study, trial)
        if max(study.violations(design), default=0.0) > 0.0:  # a formula refuses it: nothing to simulate
            search.tell(trial, state=optuna.trial.TrialState.FAIL)
            continue
        record = study.evaluate(design)
        values = list(record.objectives.values())
        trial.set_user_attr("beyond", [0.0 if one["satisfied"] else 1.0 for one in record["constraints"]])
        if record.ok and None not in values:
            search.tell(trial, values)
        else:
            search.tell(trial, state=optuna.trial.TrialState.FAIL)
    front = study.front()
    print(f"{len(study.records)} designs, {front!r}")
    for record in front:
        print("  " + ", ".join(f"{name} {value:.4g}" for name, value in record.objectives.items()))
    return front


if __name__ == "__main__":
    main(*(float(word) for word in sys.argv[1:]))
