"""How much faster two workers are than one, on two cores, and what of it the cores themselves can give.

    PYTHONPATH=build/python python3 bench/cluster/two_workers.py [ROUNDS] [SPACING_MM]

The same designs of experiments, one simulation each, in turns: with one worker and with two, and by the program
`parapet` (PARAPET_PROGRAM, default build/bin/parapet) with one job and with two. Times are of the wall, for each
design from the first to the last line of the log, so that starting does not count. The program needs no Dask:
its ratio is what two cores are worth on this machine with its load. Processor seconds are of the whole command.
"""

from __future__ import annotations

import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from package_path import hold_anywhere

root = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("PARAPET_PROGRAM", str(root / "build/bin/parapet"))
DESIGNS = 24
COMMANDS = {"workers": [sys.executable, "-m", "parapet"], "program": [PROGRAM]}


def timed(folder: Path, who: str, jobs: int) -> tuple[float, float]:
    """Seconds of the wall and of the processors for one design."""
    out = folder / f"{who}{jobs}-{time.monotonic_ns()}"
    command = [*COMMANDS[who], "optimize", "study.json", "--quiet", "--jobs", str(jobs), "--out", str(out)]
    log = out / "evaluations.jsonl"
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL) as process:
        while not (log.exists() and log.stat().st_size > 0):
            if process.poll() is not None:
                sys.exit(f"{' '.join(command)} ended without a log, with status {process.returncode}")
            time.sleep(0.005)
        begin, first = time.monotonic(), log.read_text().count("\n")
        count = first
        end = begin
        while process.poll() is None:
            now = log.read_text().count("\n")
            if now != count:
                count, end = now, time.monotonic()
            time.sleep(0.005)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return (end - begin) / (count - first), used / count


def main(rounds: str = "5", spacing_mm: str = "10") -> None:
    import parapet as pp

    hold_anywhere()
    study = pp.Study("single_deflector", spacing_m=float(spacing_mm) / 1000.0)
    method = {"algorithm": "SOBOL", "max_evaluations": DESIGNS}
    study = study.changed(name="pair", method=method, recordings="none")
    ratios: dict[str, list[float]] = {who: [] for who in COMMANDS}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        study.save(folder / "study.json")
        for _ in range(int(rounds)):
            for who in COMMANDS:
                (one, used_one), (two, used_two) = timed(folder, who, 1), timed(folder, who, 2)
                ratios[who].append(one / two)
                print(
                    f"{who}: {one:.3f} s a design with one, {two:.3f} s with two: {ratios[who][-1]:.2f}; "
                    f"processor {used_one:.3f} and {used_two:.3f} s",
                    flush=True,
                )
    workers, program = (statistics.median(ratios[who]) for who in ("workers", "program"))
    print(
        f"medians: workers {workers:.2f}, program {program:.2f} on {len(os.sched_getaffinity(0))} cores; "
        f"load of the machine {os.getloadavg()[0]:.1f}"
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
