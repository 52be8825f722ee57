"""Calibration: yield stress and consistency from an observed front, and a study that carries the spread.

The observation is where the front was at some times (observed_front.csv: time [s], place along the bed
[m]). Simulations at points spread over the ranges give the place at each of these times as a quadratic in
ln(tau_y) and ln(K); its misfit to the observation gives the posterior of the two over the ranges.
Its sigma points - five pairs whose weighted mean and covariance are those of the posterior (Julier and
Uhlmann, Proc. IEEE 92 (2004) 401-422) - become the scenarios of a study.

    python3 examples/python/calibration.py [SPACING_MM] [POINTS]
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.stats import qmc

import parapet as pp

Floats = NDArray[np.float64]

YIELD_STRESS_PA = (30.0, 270.0)
CONSISTENCY_PA_SN = (1.5, 13.5)
SIGMA_M = 0.02
"""Of the observation and of the model together, as a standard deviation of the front's place [m]."""

SPREAD = "times or over {:.2f} (one standard deviation)"


def front_at(times_s: Floats, yield_stress_pa: float, consistency_pa_sn: float, spacing_m: float) -> Floats:
    """Place of the front along an open channel at these times [m]."""
    case = pp.load_case("single_barrier")
    case.barriers = []
    case.run.stop_time_s = float(times_s[-1]) + 0.1
    case.material.yield_stress_pa = yield_stress_pa
    case.material.consistency_pa_sn = consistency_pa_sn
    series = pp.simulate(case, spacing_m=spacing_m, frames=0).series
    known = np.isfinite(series["front_x_m"])
    return np.interp(times_s, series["time_s"][known], series["front_x_m"][known])


def quadratic(theta: Floats) -> Floats:
    """Terms of a full quadratic in two variables: theta [n, 2] gives [n, 6]."""
    a, b = theta.T
    return np.stack([np.ones_like(a), a, b, a * a, a * b, b * b], axis=1)


def posterior(theta: Floats, simulated_m: Floats, observed_m: Floats) -> tuple[Floats, Floats]:
    """Mean [2] and covariance [2, 2] of theta over the box of the points that were simulated.

    Args:
        theta: [n_points, 2]; simulated_m: [n_points, n_times]; observed_m: [n_times].
    """
    fit = np.linalg.lstsq(quadratic(theta), simulated_m, rcond=None)[0]
    missed = simulated_m - quadratic(theta) @ fit  # by the quadratic: it counts as noise too
    sigma = np.hypot(SIGMA_M, missed.std(axis=0, ddof=6))
    axes = [np.linspace(theta[:, k].min(), theta[:, k].max(), 121) for k in range(2)]
    grid = np.stack([g.ravel() for g in np.meshgrid(*axes)], axis=1)
    level = np.sum(((quadratic(grid) @ fit - observed_m) / sigma) ** 2, axis=1)
    weight = np.exp(-0.5 * (level - level.min()))
    weight /= weight.sum()
    mean = weight @ grid
    return mean, (grid - mean).T @ ((grid - mean) * weight[:, None])


def sigma_points(mean: Floats, covariance: Floats) -> tuple[Floats, Floats]:
    """Five points [5, 2] and their weights [5] with this mean and covariance."""
    n, centre = len(mean), 1.0 / 3.0
    root = np.linalg.cholesky(covariance * n / (1.0 - centre))
    points = np.vstack([mean, mean + root.T, mean - root.T])
    return points, np.array([centre] + 2 * n * [(1.0 - centre) / (2 * n)])


def main(spacing_mm: float = 20.0, points: float = 16) -> pp.Study:
    observed = Path(__file__).parent / "observed_front.csv"
    times_s, places_m = np.loadtxt(observed, delimiter=",", skiprows=1).T
    low, high = np.log([YIELD_STRESS_PA, CONSISTENCY_PA_SN]).T
    theta = qmc.scale(qmc.Sobol(2, seed=1).random(int(points)), low, high)
    simulated_m = [front_at(times_s, float(t), float(k), spacing_mm / 1000.0) for t, k in np.exp(theta)]
    mean, covariance = posterior(theta, np.array(simulated_m), places_m)
    tau, k = np.exp(mean)
    spread = np.sqrt(np.diag(covariance))
    print(f"tau_y {tau:.3g} Pa, {SPREAD.format(np.exp(spread[0]))}")
    print(f"K {k:.3g} Pa s^n, {SPREAD.format(np.exp(spread[1]))}")
    pairs, weights = sigma_points(mean, covariance)
    scenarios = []
    for number, (pair, weight) in enumerate(zip(np.exp(pairs), weights), 1):
        values = {"yield_stress_pa": float(pair[0]), "consistency_pa_sn": float(pair[1])}
        scenarios.append({"name": f"event_{number}", "weight": float(weight), "set": values})
    study = pp.Study("quickstart", spacing_m=spacing_mm / 1000.0)
    study = study.changed(name="calibrated", scenarios=scenarios)
    for one in study.spec["scenarios"]:
        print(f"  {one['name']}: weight {one['weight']:.3f}, {one['set']}")
    return study


if __name__ == "__main__":
    study = main(*(float(word) for word in sys.argv[1:]))
    study.save("calibrated.json")
    print("written: calibrated.json; go on with: python3 -m parapet optimize calibrated.json")
