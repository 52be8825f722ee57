"""A sweep: how the angle of a deflector trades retention for the length of the jump.

    python3 examples/python/sweep.py [SPACING_MM]
"""

from __future__ import annotations

import sys

import parapet as pp


def main(spacing_mm: float = 20.0) -> None:
    case = pp.load_case("single_barrier")
    print(f"{'angle':>6} {'retained':>9} {'launched':>9} {'slam':>9}")
    print(f"{'deg':>6} {'-':>9} {'m':>9} {'N/m':>9}")
    for angle in range(0, 90, 15):
        case.barriers[0].deflector.angle_deg = angle
        metrics = pp.simulate(case, spacing_m=spacing_mm / 1000.0, frames=0).metrics
        columns = ("retention_efficiency", "launch_length_m", "barrier_1_slam_force_n_per_m")
        values = ["-" if metrics[key] is None else f"{metrics[key]:.3g}" for key in columns]
        print(f"{angle:6d} " + " ".join(f"{value:>9}" for value in values))


if __name__ == "__main__":
    main(*(float(word) for word in sys.argv[1:]))
