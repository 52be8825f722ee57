"""The scripts of examples/python, coarse."""

from __future__ import annotations

import importlib.util
import json
import os
import sys
import unittest
from pathlib import Path
from types import ModuleType

import numpy as np

import parapet as pp
import tiny

SCRIPTS = Path(os.environ["PARAPET_SOURCE"]) / "examples/python"


def load(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(name, SCRIPTS / f"{name}.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Examples(tiny.InFolder):
    def test_sweep(self) -> None:
        shown = tiny.run(sys.executable, str(SCRIPTS / "sweep.py"), "25", cwd=self.folder).stdout
        rows = [line.split() for line in shown.splitlines()[2:]]
        self.assertEqual([row[0] for row in rows], ["0", "15", "30", "45", "60", "75"])
        self.assertTrue(all(0.0 < float(row[1]) <= 1.0 for row in rows), shown)

    def test_scipy(self) -> None:
        record = load("scipy_study").main(15.0, 1)
        self.assertTrue(record.feasible)

    def test_optuna(self) -> None:
        try:
            import optuna  # noqa: F401
        except ImportError:
            self.skipTest("python3-optuna is not installed")
        front = load("optuna_study").main(15.0, 8)
        self.assertGreaterEqual(len(front), 1)

    def test_calibration(self) -> None:
        done = tiny.run(sys.executable, str(SCRIPTS / "calibration.py"), "20", "16", cwd=self.folder)
        study = pp.Study(self.folder / "calibrated.json")
        self.assertAlmostEqual(sum(study.scenarios.values()), 1.0)
        self.assertEqual(len(study.scenarios), 5)
        spec = json.loads((self.folder / "calibrated.json").read_text())
        centre = spec["scenarios"][0]["set"]
        # The observation was made at 10 mm with 90 Pa and 4.526 Pa s^n. One front cannot tell the two
        # apart well: where one is too large the other is too small.
        tau, k = centre["/material/yield_stress_pa"], centre["/material/consistency_pa_sn"]
        self.assertTrue(45.0 < tau < 180.0, done.stdout)
        self.assertTrue(2.2 < k < 9.1, done.stdout)

    def test_sigma_points_keep_mean_and_covariance(self) -> None:
        module = load("calibration")
        mean, covariance = np.array([1.0, 2.0]), np.array([[0.3, 0.1], [0.1, 0.2]])
        points, weights = module.sigma_points(mean, covariance)
        np.testing.assert_allclose(weights @ points, mean)
        centred = points - mean
        np.testing.assert_allclose((centred * weights[:, None]).T @ centred, covariance)


if __name__ == "__main__":
    unittest.main()
