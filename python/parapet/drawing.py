"""Drawings of a case as SVG."""

from __future__ import annotations

import math
from typing import Any, Sequence

Point = tuple[float, float]


def _to_world(corners: Sequence[Sequence[float]], slope: float) -> list[Point]:
    """Channel axes [m] to the world's: x to the right, y down the page, the bed falling."""
    c, s = math.cos(slope), math.sin(slope)
    return [(x * c + z * s, x * s - z * c) for x, z in corners]


def _path(points: Sequence[Point], closed: bool = True) -> str:
    text = " L".join(f"{x:.4f},{y:.4f}" for x, y in points)
    return f"M{text}{' Z' if closed else ''}"


def case_svg(scene: dict[str, Any], width_px: int = 640) -> str:
    """The released block, the bed, barriers and solids, gravity down, all lengths at one scale.

    Args:
        scene: of ``Case.scene()``; lengths in m.
    """
    slope = math.radians(scene["slope_deg"])
    length = scene["domain"]["length_m"]
    block_l, block_h = scene["reservoir"]["length_m"], scene["reservoir"]["height_m"]
    block = _to_world([(0, 0), (block_l, 0), (block_l, block_h), (0, block_h)], slope)
    bed = _to_world([(0, 0), (length, 0)], slope)
    solids = [_to_world(barrier["outline"], slope) for barrier in scene["barriers"]]
    solids += [_to_world(solid, slope) for solid in scene["solids"]]
    points = block + bed + [point for solid in solids for point in solid]
    margin = 0.03 * length
    left, right = min(p[0] for p in points) - margin, max(p[0] for p in points) + margin
    top, bottom = min(p[1] for p in points) - margin, max(p[1] for p in points) + margin
    line = (right - left) / width_px  # one pixel [m]
    height_px = width_px * (bottom - top) / (right - left)
    shapes = [f'<path d="{_path(block)}" fill="#8a6d4b"/>']
    shapes += [f'<path d="{_path(solid)}" fill="#39424e"/>' for solid in solids]
    shapes.append(
        f'<path d="{_path(bed, closed=False)}" stroke="#39424e" stroke-width="{2 * line:.5f}" fill="none"/>'
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width_px}" height="{height_px:.0f}" '
        f'viewBox="{left:.4f} {top:.4f} {right - left:.4f} {bottom - top:.4f}">'
        f"{''.join(shapes)}</svg>"
    )
