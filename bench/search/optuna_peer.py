#!/usr/bin/python3
"""Runs Optuna on a problem of the comparison.

usage: optuna_peer.py SAMPLER SEEDS BUDGET OUT.json ORACLE_COMMAND...

SAMPLER is tpe or nsga2, SEEDS their number, BUDGET the evaluations of a run (0: the problem's).
ORACLE_COMMAND is bench_search_oracle with its arguments; it evaluates one design a line. Designs that
the cheap constraints refuse are not evaluated and do not count, as for every other method; Optuna is
told their violation, and the worst objectives seen so far, which it does not use where a constraint
is violated.
"""

import json
import subprocess
import sys
import time
import warnings

import optuna

LABELS = {"tpe": "TPE (Optuna)", "nsga2": "NSGA-II (Optuna)"}


class Oracle:
    """The evaluator at the other end of a pipe."""

    def __init__(self, command):
        self.process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1
        )
        line = self.process.stdout.readline()
        if not line:
            sys.exit("optuna_peer: the oracle did not start")
        self.problem = json.loads(line)

    def ask(self, x):
        self.process.stdin.write(json.dumps({"x": x}) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())


def violations(trial):
    """What Optuna calls constraints: above 0 is violated."""
    return trial.user_attrs["violations"]


def make_sampler(name, seed):
    if name == "tpe":
        return optuna.samplers.TPESampler(
            seed=seed, multivariate=True, constraints_func=violations
        )
    return optuna.samplers.NSGAIISampler(
        seed=seed, population_size=20, constraints_func=violations
    )


def run(name, seed, budget, oracle):
    problem = oracle.problem
    study = optuna.create_study(
        directions=["minimize"] * problem["objectives"],
        sampler=make_sampler(name, seed),
    )
    steps, own = [], 0.0
    worst = [0.0] * problem["objectives"]
    bounds = list(zip(problem["variables"], problem["lower"], problem["upper"]))
    for _ in range(50 * budget):
        if len(steps) == budget:
            break
        start = time.perf_counter()
        trial = study.ask()
        x = [trial.suggest_float(key, low, high) for key, low, high in bounds]
        own += time.perf_counter() - start
        answer = oracle.ask(x)
        start = time.perf_counter()
        if answer["allowed"]:
            steps.append({"x": x, "level": 0, "seconds": problem["seconds"]})
        if answer["allowed"] and not answer["ok"]:
            study.tell(trial, state=optuna.trial.TrialState.FAIL)
        else:
            limits = answer.get("violations", [0.0] * problem["limits"])
            trial.set_user_attr("violations", answer["cheap"] + limits)
            objectives = answer.get("objectives", worst)
            worst = [max(pair) for pair in zip(worst, objectives)]
            study.tell(trial, objectives)
        own += time.perf_counter() - start
    return {"seed": seed, "own_seconds": own, "steps": steps}


def main():
    if len(sys.argv) < 6:
        sys.exit(__doc__)
    name, seeds, budget, out = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), sys.argv[4]
    if name not in LABELS:
        sys.exit(f"optuna_peer: no sampler {name}; there are: {', '.join(LABELS)}")
    warnings.simplefilter("ignore", optuna.exceptions.ExperimentalWarning)
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    oracle = Oracle(sys.argv[5:])
    budget = budget or oracle.problem["budget"]
    runs = [run(name, seed, budget, oracle) for seed in range(1, seeds + 1)]
    method = f"optuna_{name}"
    label = LABELS[name] + (f", {seeds} runs" if name == "tpe" else "")
    with open(out, "w", encoding="utf-8") as file:
        json.dump({"method": method, "label": label, "family": method, "runs": runs}, file)


if __name__ == "__main__":
    main()
