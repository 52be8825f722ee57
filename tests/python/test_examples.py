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

    def test_calibration_hands_its_spread_to_a_study(self) -> None:
        for what in ("front", "deposit"):
            with self.subTest(what):
                self.calibrated(what)

    def calibrated(self, what: str) -> None:
        done = tiny.run(sys.executable, str(SCRIPTS / "calibration.py"), what, "20", "16", cwd=self.folder)
        study = pp.Study(self.folder / "calibrated.json")
        self.assertAlmostEqual(sum(study.scenarios.values()), 1.0)
        self.assertEqual(len(study.scenarios), 5)
        spec = json.loads((self.folder / "calibrated.json").read_text())
        centre = spec["scenarios"][0]["set"]
        # The observations were made at 10 mm with 90 Pa and 4.526 Pa s^n. One of them cannot tell the two
        # apart well: where one is too large the other is too small.
        tau, k = centre["/material/yield_stress_pa"], centre["/material/consistency_pa_sn"]
        self.assertTrue(45.0 < tau < 180.0, done.stdout)
        self.assertTrue(2.2 < k < 9.1, done.stdout)

    def test_calibration_finds_a_made_up_truth(self) -> None:
        """What was simulated with other values is found again, within the spread that is stated."""
        module = load("calibration")
        observed = {"front": np.arange(0.2, 0.75, 0.1), "deposit": np.arange(0.1, 1.65, 0.1)}
        low, high = np.log([module.YIELD_STRESS_PA, module.CONSISTENCY_PA_SN]).T
        for what, at in observed.items():
            simulate, sigma_m = module.OBSERVABLES[what]
            for truth in ((60.0, 8.0), (150.0, 3.0)):
                with self.subTest(what, truth=truth):
                    made_m = simulate(at, *truth, 0.02)
                    mean, covariance = module.calibrate(what, at, made_m, 0.02, 16)
                    off = np.log(truth) - mean
                    # 95 % of a normal distribution of two variables: chi-square below 5.99.
                    self.assertLess(off @ np.linalg.solve(covariance, off), 5.99, (truth, np.exp(mean)))
                    # It says more than the ranges did: a uniform density has the width over sqrt(12).
                    before = np.prod((high - low) ** 2 / 12.0)
                    self.assertLess(np.linalg.det(covariance), before / 10.0)

    def test_sigma_points_keep_mean_and_covariance(self) -> None:
        module = load("calibration")
        mean, covariance = np.array([1.0, 2.0]), np.array([[0.3, 0.1], [0.1, 0.2]])
        points, weights = module.sigma_points(mean, covariance)
        np.testing.assert_allclose(weights @ points, mean)
        centred = points - mean
        np.testing.assert_allclose((centred * weights[:, None]).T @ centred, covariance)


if __name__ == "__main__":
    unittest.main()
