"""How busy the asker keeps many workers, whose tasks only sleep.

    PYTHONPATH=build/python python3 bench/cluster/asker.py [WORKERS] [SECONDS] [ALGORITHM] [EVENTS]

The workers are threads of four processes. A task sleeps for ten seconds and answers with the outcome of a real
simulation of the same study, simulated once. Busy is the sum of all sleeps over the workers' time from the
first task's begin to the last one's end.
"""

from __future__ import annotations

import functools
import json
import random
import sys
import tempfile
import time
import zlib
from pathlib import Path
from typing import Any

import parapet as pp
from parapet import _native, worker
from parapet.cluster import Cluster, DaskService


def sleep_task(task: str, outcome: bytes, seconds: float) -> bytes:
    """Sleeps, and answers with an outcome whose first metrics are drawn anew."""
    begin = time.time()
    time.sleep(seconds)
    answer = json.loads(zlib.decompress(outcome))
    draw = random.Random(json.loads(task)["key"])
    for metric in answer["metrics"]:
        if isinstance(metric["value"], float):
            metric["value"] *= draw.uniform(0.9, 1.1)
    answer["report"]["slept"] = [begin, time.time()]
    return zlib.compress(json.dumps(answer).encode(), 1)


class Measured(DaskService):
    """Notes when the tasks slept."""

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        self.slept: list[tuple[float, float]] = []

    def poll(self, timeout_s: float) -> Any:
        answer = super().poll(timeout_s)
        if answer is not None and answer[1] is not None:
            begin, end = json.loads(answer[1])["report"]["slept"]
            self.slept.append((begin, end))
        return answer


def main(workers: str = "200", seconds: str = "10", algorithm: str = "BAYESIAN", events: str = "29") -> None:
    from distributed import Client, LocalCluster

    count, sleep_s, n_events = int(workers), float(seconds), int(events)
    scenarios = [
        {"name": f"event_{k}", "weight": 1.0, "set": {"yield_stress_pa": 60.0 + k}} for k in range(n_events)
    ]
    study = pp.Study("dual_deflector", spacing_m=0.02)
    case = study.case({v.name: 0.5 * (v.lower + v.upper) for v in study.variables})
    task = {
        "format": "parapet-simulation-task/1", "label": "", "design": {}, "scenario": "", "threads": 1,
        "key": case.hash(), "case": case.to_dict(),
    }
    outcome = worker.run_task(json.dumps(task))
    designs = 5 * count // n_events  # about five rounds of all workers
    objectives = [one for one in study.spec["objectives"] if "retention" in one.get("metric", "")]
    heights = "upstream_height_m + downstream_height_m"
    objectives.append({"name": "total_height_m", "expression": heights, "goal": "minimize"})
    study = study.changed(
        name="asker", recordings="none", objectives=objectives, method={"algorithm": algorithm, "max_evaluations": designs},
        **({"scenarios": scenarios} if n_events > 1 else {}),
    )
    local = LocalCluster(n_workers=4, threads_per_worker=count // 4, dashboard_address=None)
    cluster = Cluster(lambda: Client(local), print)
    cluster.wait_for_threads(count)
    services: list[Measured] = []

    def make(places: int) -> Measured:
        services.append(Measured(cluster, functools.partial(sleep_task, outcome=outcome, seconds=sleep_s)))
        return services[-1]

    with tempfile.TemporaryDirectory() as name:
        study.save(Path(name) / "study.json")
        arguments = ["parapet", "optimize", f"{name}/study.json", "--out", f"{name}/out", "--jobs", str(count), "-q"]
        _native.run_program(arguments, make)
    slept = services[0].slept
    begin, end = min(b for b, _ in slept), max(e for _, e in slept)
    busy = sum(e - b for b, e in slept)
    print(f"{algorithm}, {n_events} event(s) a design: {len(slept)} tasks of {sleep_s:g} s on {count} workers")
    print(f"busy {100 * busy / (count * (end - begin)):.1f} % over all, from the first begin to the last end")
    # The last tasks leave workers without work in any study: until the last one has begun.
    last = max(b for b, _ in slept)
    until = sum(min(e, last) - b for b, e in slept if b < last)
    print(f"busy {100 * until / (count * (last - begin)):.1f} % until the last task began")
    cluster.close()
    local.close()


if __name__ == "__main__":
    main(*sys.argv[1:])
