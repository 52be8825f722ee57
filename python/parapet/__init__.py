"""Debris flow against barriers: simulate a design, search for a better one, on one machine or many.

    import parapet as pp

    case = pp.load_case("single_barrier")
    case.barriers[0].deflector.angle_deg = 60
    result = pp.simulate(case, spacing_m=0.01)
    result.metrics["retention_efficiency"]

The numbers are those of the program ``parapet``, to the bit: both call the same libraries. SI units;
where a name carries a unit (``_m``, ``_deg``), the number has it. ``python3 -m parapet`` is the program
itself, with studies on the workers of a Dask cluster (``--scheduler``).
"""

from __future__ import annotations

import os as _os

# Before OpenMP is loaded: threads that wait sleep instead of spinning, as in the program. Spinning
# threads keep from its core the very thread that they wait for as soon as anything else runs.
if "OMP_WAIT_POLICY" not in _os.environ and "GOMP_SPINCOUNT" not in _os.environ:
    _os.environ["OMP_WAIT_POLICY"] = "passive"

from . import _native, plot
from .advice import Recommendation, StudyFolder, load_study_folder, recommend
from .case import Case, load_case
from .errors import FileError, InputError, Issue
from .search import Search
from .simulation import Frame, Result, simulate
from .study import Design, Front, Record, Study, Variable

__version__: str = _native.version
__git_revision__: str = _native.git_revision


def shipped_specs() -> list[str]:
    """Names of the specs that come with Parapet: for :func:`load_case` and :class:`Study`."""
    return list(_native.shipped_names())


__all__ = [
    "Case",
    "Design",
    "FileError",
    "Frame",
    "Front",
    "InputError",
    "Issue",
    "Recommendation",
    "Record",
    "Result",
    "Search",
    "Study",
    "StudyFolder",
    "Variable",
    "load_case",
    "load_study_folder",
    "plot",
    "recommend",
    "shipped_specs",
    "simulate",
]
