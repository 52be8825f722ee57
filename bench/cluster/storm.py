"""Nothing is lost: workers killed all the time, the scheduler twice; the log is that of a quiet run.

    PYTHONPATH=build/python python3 bench/cluster/storm.py [SPEC] [EVALUATIONS] [SECONDS] [ALGORITHM]

Four workers; one is killed every SECONDS (5). The quiet run is one of the program `parapet` (PARAPET_PROGRAM, default build/bin/parapet) with
four jobs. The two logs are compared line by line, but for times and the checksums over them.
"""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

root = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(root / "tests/python"))

import parapet as pp  # noqa: E402
from dask_processes import DaskProcesses  # noqa: E402
from package_path import hold_anywhere  # noqa: E402
from tiny import log_of  # noqa: E402

WORKERS = 4


def lines(folder: Path) -> int:
    log = folder / "evaluations.jsonl"
    return log.read_text().count("\n") if log.exists() else 0


class Storm:
    """Keeps workers alive and kills them."""

    def __init__(self, folder: Path, between_s: float) -> None:
        self.dask = DaskProcesses(folder)
        self.between_s = between_s
        self.random = random.Random(1)
        self.worker_kills = self.scheduler_kills = 0
        self.dask.start_scheduler()
        self.next_kill = time.monotonic() + between_s

    def step(self, kill_scheduler: bool) -> None:
        self.dask.forget_ended_workers()
        while len(self.dask.workers) < WORKERS:
            self.dask.start_worker()
        if kill_scheduler:
            self.dask.kill_scheduler()
            self.scheduler_kills += 1
            time.sleep(1.0)
            self.dask.start_scheduler()
        elif time.monotonic() >= self.next_kill:
            self.dask.kill_worker(self.random.choice(sorted(self.dask.workers)))
            self.worker_kills += 1
            self.next_kill = time.monotonic() + self.between_s


def main(spec: str = "dual_deflector", evaluations: str = "300", between_s: str = "5", algorithm: str = "BAYESIAN") -> int:
    hold_anywhere()
    program = os.environ.get("PARAPET_PROGRAM", str(root / "build/bin/parapet"))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        study = pp.Study(spec, spacing_m=0.02)
        method = {"max_evaluations": int(evaluations), "algorithm": algorithm}
        study = study.changed(
            name="storm", method=method, recordings="none", objectives=coarse_objectives(study)
        )
        study.save(folder / "study.json")
        options = ["optimize", "study.json", "--jobs", str(WORKERS), "--quiet", "--out"]
        begin = time.monotonic()
        subprocess.run([program, *options, "quiet"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        quiet_s = time.monotonic() - begin
        print(f"quiet run: {lines(folder / 'quiet')} designs in {quiet_s:.0f} s", flush=True)

        storm = Storm(folder, float(between_s))
        begin = time.monotonic()
        said = begin
        scheduler_at = [int(evaluations) // 3, 2 * int(evaluations) // 3]
        command = [sys.executable, "-m", "parapet", *options, "storm", "--scheduler", storm.dask.address]
        with subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL) as process:
            while process.poll() is None:
                done = lines(folder / "storm")
                due = bool(scheduler_at) and done >= scheduler_at[0]
                if due:
                    scheduler_at.pop(0)
                storm.step(due)
                if time.monotonic() - said > 30.0:
                    said = time.monotonic()
                    print(f"  {done} designs, {storm.worker_kills} workers killed", flush=True)
                time.sleep(0.1)
        storm.dask.close()
        print(
            f"storm: {lines(folder / 'storm')} designs in {time.monotonic() - begin:.0f} s, exit code "
            f"{process.returncode}; workers killed {storm.worker_kills}, scheduler {storm.scheduler_kills}"
        )
        return 0 if same(log_of(folder / "quiet"), log_of(folder / "storm")) else 1


def coarse_objectives(study: pp.Study) -> list[Any]:
    """Those that particles of 20 mm can tell: launches need finer ones."""
    return [one for one in study.spec["objectives"] if "launch" not in one.get("metric", "")]


def same(quiet: list[Any], storm: list[Any]) -> bool:
    """Whether the logs are equal, and where they are not."""
    different = [k for k, (a, b) in enumerate(zip(quiet, storm)) if a != b]
    equal = len(quiet) == len(storm) and not different
    print(f"logs: {len(quiet)} and {len(storm)} lines, {'equal' if equal else f'{len(different)} differ'}")
    if different:
        k = different[0]
        print(f"first: {json.dumps(quiet[k])}\n  and: {json.dumps(storm[k])}")
    return equal


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
