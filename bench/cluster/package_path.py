"""PYTHONPATH for processes that are started in other folders."""

import os


def hold_anywhere() -> None:
    """Makes the places of PYTHONPATH absolute, for every process that is started from now on."""
    places = [place for place in os.environ.get("PYTHONPATH", "").split(os.pathsep) if place]
    if places:
        os.environ["PYTHONPATH"] = os.pathsep.join(os.path.abspath(place) for place in places)
