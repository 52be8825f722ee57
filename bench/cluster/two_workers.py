"""How much faster two workers are than one, on two cores.

    PYTHONPATH=build/python python3 bench/cluster/two_workers.py [ROUNDS]

The same designs of experiments, one simulation each, with one worker and with two in turns. Times are of the
wall, from the first to the last line of the log, so that starting Dask does not count.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import parapet as pp


def timed(folder: Path, jobs: int) -> float:
    """Seconds of the simulations of one study."""
    out = folder / f"jobs{jobs}-{time.monotonic_ns()}"
    command = [sys.executable, "-m", "parapet", "optimize", "study.json", "--quiet"]
    command += ["--jobs", str(jobs), "--out", str(out)]
    log = out / "evaluations.jsonl"
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL) as process:
        while not (log.exists() and log.stat().st_size > 0):
            time.sleep(0.005)
        begin, first = time.monotonic(), log.read_text().count("\n")
        count = first
        end = begin
        while process.poll() is None:
            now = log.read_text().count("\n")
            if now != count:
                count, end = now, time.monotonic()
            time.sleep(0.005)
    return (end - begin) / (count - first)


def main(rounds: str = "5") -> None:
    study = pp.Study("single_deflector", spacing_m=0.01)
    method = {"algorithm": "SOBOL", "max_evaluations": 24}
    study = study.changed(name="pair", method=method, recordings="none")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        study.save(folder / "study.json")
        ratios = []
        for _ in range(int(rounds)):
            one, two = timed(folder, 1), timed(folder, 2)
            ratios.append(one / two)
            print(f"{one:.3f} s a design with one worker, {two:.3f} s with two: {ratios[-1]:.2f}", flush=True)
    print(f"median {statistics.median(ratios):.2f} on {len(os.sched_getaffinity(0))} cores")


if __name__ == "__main__":
    main(*sys.argv[1:])
