"""Specs of a few dozen particles: real simulations that take a moment. And how the program is called."""

from __future__ import annotations

import copy
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from typing import Any

CASE: dict[str, Any] = {
    "format": "parapet-case/1",
    "name": "tiny",
    "channel": {"length_m": 1.2},
    "reservoir": {"length_m": 0.2, "height_m": 0.1},
    "barriers": [{"foot_x_m": 0.4, "height_m": 0.06, "deflector": {"angle_deg": 30, "length_m": 0.04}}],
    "numerics": {"spacing_m": 0.02},
    "run": {"stop_time_s": 0.5},
}

STUDY: dict[str, Any] = {
    "format": "parapet-study/1",
    "name": "tiny",
    "case": {key: value for key, value in CASE.items() if key != "format"},
    "variables": {
        "deflector_angle_deg": {"lower": 0, "upper": 60},
        "upstream_height_m": {"lower": 0.04, "upper": 0.1},
    },
    "objectives": [
        {"metric": "barrier_1_slam_force_n_per_m", "goal": "minimize", "statistic": "worst"},
        {"name": "plate_m", "expression": "upstream_height_m + 0.04", "goal": "minimize"},
    ],
    "constraints": [{"metric": "retention_efficiency", "lower": 0.2}],
    "scenarios": [
        {"name": "runny", "weight": 0.5, "set": {"yield_stress_pa": 40}},
        {"name": "stiff", "weight": 0.5, "set": {"yield_stress_pa": 150}},
    ],
    "method": {"algorithm": "BAYESIAN", "max_evaluations": 10, "seed": 1},
    "recordings": "none",
}

SWEEP: dict[str, Any] = {
    "format": "parapet-sweep/1",
    "name": "tiny",
    "source": "nobody",
    "case": STUDY["case"],
    "rows": [
        {"id": "bare", "changes": {"barriers": [{"foot_x_m": 0.4, "height_m": 0.06}]}},
        {"id": "lifted"},
    ],
}

DESIGN = {"deflector_angle_deg": 45, "upstream_height_m": 0.07}

TIMES = ("wall_time_s", "cpu_time_s", "crc32c", "git_revision")


def study(**members: Any) -> dict[str, Any]:
    """The study with members replaced."""
    return {**copy.deepcopy(STUDY), **members}


def without_times(record: Any) -> Any:
    """A record without what differs between two runs of the same design."""
    if isinstance(record, dict):
        return {key: without_times(value) for key, value in record.items() if key not in TIMES}
    if isinstance(record, list):
        return [without_times(item) for item in record]
    return record


def log_of(folder: Path) -> list[Any]:
    """The log of a study without times."""
    lines = (folder / "evaluations.jsonl").read_text().splitlines()
    return [without_times(json.loads(line)) for line in lines]


def program() -> str:
    """The program `parapet` of this build."""
    return os.environ["PARAPET_PROGRAM"]


def run(*arguments: str, cwd: Path, code: int = 0, **options: Any) -> subprocess.CompletedProcess[str]:
    """Runs a command that must end with a code."""
    done = subprocess.run(arguments, cwd=cwd, capture_output=True, text=True, timeout=600, **options)
    assert done.returncode == code, f"{arguments}: exit code {done.returncode}\n{done.stdout}{done.stderr}"
    return done


def module(*arguments: str) -> list[str]:
    """python3 -m parapet."""
    return [sys.executable, "-m", "parapet", *arguments]


class InFolder(unittest.TestCase):
    """A test with a folder of its own that holds the specs."""

    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)
        for name, spec in (("case", CASE), ("study", STUDY), ("sweep", SWEEP)):
            self.write(f"{name}.json", spec)

    def write(self, name: str, content: Any) -> str:
        path = self.folder / name
        path.write_text(content if isinstance(content, str) else json.dumps(content))
        return str(path)
