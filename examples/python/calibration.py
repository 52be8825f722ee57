"""Calibration: yield stress and consistency from an observed front or deposit, and a study that carries the spread.

What was observed is where the front was at some times (observed_front.csv: time [s], place along the bed
[m]), or how deep the deposit was at some places (observed_deposit.csv: place along the bed [m], depth
[m]). Simulations at points spread over the ranges give each of these numbers as a quadratic in ln(tau_y) and
ln(K); its misfit to the observation gives the posterior of the two over the ranges.
Its sigma points - five pairs whose weighted mean and covariance are those of the posterior (Julier and
Uhlmann, Proc. IEEE 92 (2004) 401-422) - become the scenarios of a study.

    python3 examples/python/calibration.py [front | deposit] [SPACING_MM] [POINTS]
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.stats import qmc

import parapet as pp

Floats = NDArray[np.float64]

YIELD_STRESS_PA = (30.0, 270.0)
CONSISTENCY_PA_SN = (1.5, 13.5)

SPREAD = "times or over {:.2f} (one standard deviation)"


def open_channel(yield_stress_pa: float, consistency_pa_sn: float) -> pp.Case:
    """The shipped channel without its barrier."""
    case = pp.load_case("single_barrier")
    case.barriers = []
    case.material.yield_stress_pa = yield_stress_pa
    case.material.consistency_pa_sn = consistency_pa_sn
    return case


def front_at(times_s: Floats, yield_stress_pa: float, consistency_pa_sn: float, spacing_m: float) -> Floats:
    """Place of the front along an open channel at these times [m]."""
    case = open_channel(yield_stress_pa, consistency_pa_sn)
    case.run.stop_time_s = float(times_s[-1]) + 0.1
    series = pp.simulate(case, spacing_m=spacing_m, frames=0).series
    known = np.isfinite(series["front_x_m"])
    return np.interp(times_s, series["time_s"][known], series["front_x_m"][known])


def deposit_at(places_m: Floats, yield_stress_pa: float, consistency_pa_sn: float, spacing_m: float) -> Floats:
    """Depth of what has come to rest on a slope of 6 degrees, at places that are evenly apart [m].

    Each particle is shared by the two places beside it, so that the depth does not jump.
    """
    case = open_channel(yield_stress_pa, consistency_pa_sn)
    case.channel.slope_deg = 6.0
    case.run.stop_time_s = 3.0
    case.run.until_rest = True
    x_m = pp.simulate(case, spacing_m=spacing_m, frames=2).frames[-1].x_m.astype(np.float64)
    step_m = places_m[1] - places_m[0]
    shares = np.maximum(0.0, 1.0 - np.abs(x_m[:, None] - places_m) / step_m)
    return shares.sum(axis=0) * spacing_m**2 / step_m


Observable = Callable[[Floats, float, float, float], Floats]

OBSERVABLES: dict[str, tuple[Observable, float]] = {"front": (front_at, 0.02), "deposit": (deposit_at, 0.004)}
"""What is compared, and the standard deviation of observation and model together [m]."""


def quadratic(theta: Floats) -> Floats:
    """Terms of a full quadratic in two variables: theta [n, 2] gives [n, 6]."""
    a, b = theta.T
    return np.stack([np.ones_like(a), a, b, a * a, a * b, b * b], axis=1)


def posterior(
    theta: Floats, simulated_m: Floats, observed_m: Floats, sigma_m: float
) -> tuple[Floats, Floats]:
    """Mean [2] and covariance [2, 2] of theta over the box of the points that were simulated.

    Args:
        theta: [n_points, 2]; simulated_m: [n_points, n_observed]; observed_m: [n_observed].
        sigma_m: of the observation and of the model together, as a standard deviation [m].
    """
    fit = np.linalg.lstsq(quadratic(theta), simulated_m, rcond=None)[0]
    missed = simulated_m - quadratic(theta) @ fit  # by the quadratic: it counts as noise too
    sigma = np.hypot(sigma_m, missed.std(axis=0, ddof=6))
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


def calibrate(
    what: str, at: Floats, observed_m: Floats, spacing_m: float, points: int
) -> tuple[Floats, Floats]:
    """Mean [2] and covariance [2, 2] of ln(tau_y [Pa]) and ln(K [Pa s^n]) that an observation leaves."""
    simulate, sigma_m = OBSERVABLES[what]
    low, high = np.log([YIELD_STRESS_PA, CONSISTENCY_PA_SN]).T
    theta = qmc.scale(qmc.Sobol(2, seed=1).random(points), low, high)
    simulated_m = np.array([simulate(at, float(t), float(k), spacing_m) for t, k in np.exp(theta)])
    return posterior(theta, simulated_m, observed_m, sigma_m)


def main(what: str = "front", spacing_mm: str = "20", points: str = "16") -> pp.Study:
    spacing_m = float(spacing_mm) / 1000.0
    observed = Path(__file__).parent / f"observed_{what}.csv"
    at, observed_m = np.loadtxt(observed, delimiter=",", skiprows=1).T
    mean, covariance = calibrate(what, at, observed_m, spacing_m, int(points))
    tau, k = np.exp(mean)
    spread = np.sqrt(np.diag(covariance))
    print(f"tau_y {tau:.3g} Pa, {SPREAD.format(np.exp(spread[0]))}")
    print(f"K {k:.3g} Pa s^n, {SPREAD.format(np.exp(spread[1]))}")
    pairs, weights = sigma_points(mean, covariance)
    scenarios = []
    for number, (pair, weight) in enumerate(zip(np.exp(pairs), weights), 1):
        values = {"yield_stress_pa": float(pair[0]), "consistency_pa_sn": float(pair[1])}
        scenarios.append({"name": f"event_{number}", "weight": float(weight), "set": values})
    study = pp.Study("quickstart", spacing_m=spacing_m)
    study = study.changed(name="calibrated", scenarios=scenarios)
    for one in study.spec["scenarios"]:
        print(f"  {one['name']}: weight {one['weight']:.3f}, {one['set']}")
    return study


if __name__ == "__main__":
    study = main(*sys.argv[1:])
    study.save("calibrated.json")
    print("written: calibrated.json; go on with: python3 -m parapet optimize calibrated.json")
