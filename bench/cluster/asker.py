"""How busy the asker keeps many workers, whose tasks only sleep.

    PYTHONPATH=build/python python3 bench/cluster/asker.py [WORKERS] [SECONDS] [ALGORITHM] [EVENTS] [ROUNDS] [JOBS]

The workers are threads of four processes, the scheduler is a fifth one, as people start them. A task sleeps for ten
seconds and answers with the outcome of a real simulation of the same study, simulated once. Busy is the sum of all
sleeps over the workers' time from the first task's begin to the last one's begin: after that the last tasks leave
workers without work in any study. The processor time is that of the asker alone: Dask's client, the search, the log.
"""

from __future__ import annotations

import functools
import json
import os
import random
import resource
import sys
import tempfile
import time
import zlib
from pathlib import Path
from typing import Any, Optional

root = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(root / "tests/python"))

import parapet as pp  # noqa: E402
from dask_processes import DaskProcesses  # noqa: E402
from parapet import _native, worker  # noqa: E402
from parapet.cluster import Cluster, DaskService, places_for  # noqa: E402

PROCESSES = 4


def sleep_task(task: str, parts: tuple[str, str], seconds: float) -> bytes:
    """Takes so long, nearly all of it asleep, and answers with an outcome of which two numbers are drawn anew."""
    begin = time.time()
    value = random.Random(json.loads(task)["key"]).uniform(0.5, 1.0)
    slept = json.dumps([begin, begin + seconds])
    packed = zlib.compress(str(value).join(parts).replace('"slept"', slept, 1).encode(), 1)
    time.sleep(max(0.0, begin + seconds - time.time()))
    return packed


class Measured(DaskService):
    """Notes when the tasks slept."""

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        self.slept: list[tuple[float, float]] = []

    def poll(self, timeout_s: float) -> Any:
        answer = super().poll(timeout_s)
        if answer is not None and answer[1] is not None:
            begin, end = answer[1].rpartition('"slept_s": [')[2].split("]")[0].split(",")
            self.slept.append((float(begin), float(end)))
        return answer


def the_study(algorithm: str, n_events: int, designs: int) -> pp.Study:
    """dual_deflector with so many events and designs, what particles of 20 mm can tell of it."""
    scenarios = [
        {"name": f"event_{k}", "weight": 1.0, "set": {"yield_stress_pa": 60.0 + k}} for k in range(n_events)
    ]
    study = pp.Study("dual_deflector", spacing_m=0.02)
    objectives = [one for one in study.spec["objectives"] if "retention" in one.get("metric", "")]
    heights = "upstream_height_m + downstream_height_m"
    objectives.append({"name": "total_height_m", "expression": heights, "goal": "minimize"})
    return study.changed(
        name="asker", recordings="none", objectives=objectives, method={"algorithm": algorithm, "max_evaluations": designs},
        **({"scenarios": scenarios} if n_events > 1 else {}),
    )


def an_outcome(study: pp.Study) -> tuple[str, str]:
    """That of the design in the middle, as text before and after the value of the study's metric."""
    case = study.case({v.name: 0.5 * (v.lower + v.upper) for v in study.variables})
    task = {
        "format": "parapet-simulation-task/1", "label": "", "design": {}, "scenario": "", "threads": 1,
        "key": case.hash(), "case": case.to_dict(),
    }
    outcome = json.loads(zlib.decompress(worker.run_task(json.dumps(task))))
    outcome["report"]["slept_s"] = "slept"
    for metric in outcome["metrics"]:
        if metric["key"] == study.spec["objectives"][0]["metric"]:
            metric["value"] = "value"
    before, _, after = json.dumps(outcome).partition('"value": "value"')
    return before + '"value": ', after


def main(
    workers: str = "200",
    seconds: str = "10",
    algorithm: str = "BAYESIAN",
    events: str = "29",
    rounds: str = "6",
    jobs: Optional[str] = None,
) -> None:
    from distributed import Client

    count, sleep_s, n_events = int(workers), float(seconds), int(events)
    study = the_study(algorithm, n_events, int(rounds) * count // n_events)
    parts = an_outcome(study)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        dask = DaskProcesses(folder)
        dask.start_scheduler()
        for _ in range(PROCESSES):
            dask.start_worker("--nthreads", str(count // PROCESSES))
        cluster = Cluster(lambda: Client(dask.address), print)
        cluster.wait_for_threads(count)
        services: list[Measured] = []

        def make(places: int) -> Measured:
            services.append(Measured(cluster, functools.partial(sleep_task, parts=parts, seconds=sleep_s)))
            return services[-1]

        study.save(folder / "study.json")
        under_way = int(jobs) if jobs else places_for(count)
        arguments = ["parapet", "optimize", str(folder / "study.json"), "--out", str(folder / "out"), "-q"]
        before = resource.getrusage(resource.RUSAGE_SELF)
        _native.run_program([*arguments, "--jobs", str(under_way)], make)
        after = resource.getrusage(resource.RUSAGE_SELF)
        cluster.close()
        dask.close()
    slept = services[0].slept
    begin, end, last = min(b for b, _ in slept), max(e for _, e in slept), max(b for b, _ in slept)
    busy = sum(e - b for b, e in slept)
    until = sum(min(e, last) - b for b, e in slept if b < last)
    own = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    print(
        f"{algorithm}, {n_events} event(s) a design: {len(slept)} tasks of {sleep_s:g} s on {count} workers, "
        f"{under_way} under way; load of the machine {os.getloadavg()[0]:.1f}"
    )
    print(f"busy {100 * until / (count * (last - begin)):.1f} % until the last task began")
    print(f"busy {100 * busy / (count * (end - begin)):.1f} % with the end, when there is no more to begin")
    print(f"processor time of the asker {1000 * own / len(slept):.1f} ms a task")


if __name__ == "__main__":
    main(*sys.argv[1:])
