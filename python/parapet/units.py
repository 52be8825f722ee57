"""Units at the border to the libraries."""

from __future__ import annotations

from decimal import Decimal
from typing import Optional


def millimetres(metres: Optional[float]) -> Optional[float]:
    """The decimal number times a thousand: 0.0123 m is 12.3 mm, as one would type it."""
    return None if metres is None else float(Decimal(repr(float(metres))) * 1000)
