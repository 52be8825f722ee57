"""Cases: one design under one event, as an object whose members are those of the JSON file."""

from __future__ import annotations

import copy
import json
import os
from typing import Any, Iterator, Mapping, Union

from . import _native, drawing

PathLike = Union[str, "os.PathLike[str]"]


def _wrapped(value: Any) -> Any:
    if isinstance(value, dict):
        return Node(value)
    if isinstance(value, list) and any(isinstance(item, dict) for item in value):
        return Nodes(value)
    return value


def _plain(value: Any) -> Any:
    if isinstance(value, Node):
        return value.to_dict()
    if isinstance(value, (list, tuple, Nodes)):
        return [_plain(item) for item in value]
    if isinstance(value, Mapping):
        return {str(key): _plain(item) for key, item in value.items()}
    if hasattr(value, "item") and not isinstance(value, (str, bytes)):  # a number of numpy
        return value.item()
    return value


class Node:
    """A JSON object: ``node.height_m`` and ``node["height_m"]`` are the same member."""

    _data: dict[str, Any]

    def __init__(self, data: dict[str, Any]) -> None:
        object.__setattr__(self, "_data", data)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return _wrapped(self._data[name])
        except KeyError:
            raise AttributeError(f"no member {name}; there are: {', '.join(self._data)}") from None

    def __setattr__(self, name: str, value: Any) -> None:
        self._data[name] = _plain(value)

    def __delattr__(self, name: str) -> None:
        if name not in self._data:
            raise AttributeError(name)
        del self._data[name]

    def __getitem__(self, name: str) -> Any:
        return _wrapped(self._data[name])

    def __setitem__(self, name: str, value: Any) -> None:
        self._data[name] = _plain(value)

    def __contains__(self, name: object) -> bool:
        return name in self._data

    def __iter__(self) -> Iterator[str]:
        return iter(self._data)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._data]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Node) and self._data == other._data

    def __repr__(self) -> str:
        return json.dumps(self._data, indent=1)

    def to_dict(self) -> dict[str, Any]:
        """A copy as plain dicts and lists."""
        copied: dict[str, Any] = copy.deepcopy(self._data)
        return copied


class Nodes:
    """A JSON list of objects."""

    def __init__(self, items: list[Any]) -> None:
        self._items = items

    def __getitem__(self, index: int) -> Any:
        return _wrapped(self._items[index])

    def __setitem__(self, index: int, value: Any) -> None:
        self._items[index] = _plain(value)

    def __delitem__(self, index: int) -> None:
        del self._items[index]

    def __len__(self) -> int:
        return len(self._items)

    def __iter__(self) -> Iterator[Any]:
        return (_wrapped(item) for item in self._items)

    def append(self, value: Any) -> None:
        self._items.append(_plain(value))

    def __repr__(self) -> str:
        return json.dumps(self._items, indent=1)


class Case(Node):
    """A case: channel, reservoir, material, barriers, numerics and run, every default written out.

    Members are read and set as attributes (``case.material.yield_stress_pa = 120``). Nothing is checked
    until :meth:`check`, a drawing or a simulation; a wrong member is then an :class:`InputError` that
    names its place.
    """

    source_file: str

    def __init__(self, data: Mapping[str, Any], source_file: str = "case") -> None:
        super().__init__(_plain(data))
        object.__setattr__(self, "source_file", source_file)

    def __setattr__(self, name: str, value: Any) -> None:
        if name == "source_file":
            object.__setattr__(self, name, value)
        else:
            super().__setattr__(name, value)

    def text(self) -> str:
        """The case as JSON text."""
        return json.dumps(self._data, allow_nan=False)

    def check(self) -> Case:
        """The same case with every default written out.

        Raises:
            InputError: for everything that is wrong with it.
        """
        return Case(_native.resolve_case(self.text(), self.source_file), self.source_file)

    def copy(self) -> Case:
        """A case of its own."""
        return Case(self._data, self.source_file)

    def save(self, path: PathLike) -> None:
        """Writes the case file, for example for ``parapet simulate``."""
        with open(path, "w", encoding="utf-8") as file:
            json.dump(self._data, file, indent=2)
            file.write("\n")

    def hash(self) -> str:
        """16 hex digits of everything that decides the result."""
        return _native.case_hash(self.text(), self.source_file)

    def scene(self) -> dict[str, Any]:
        """Outlines for drawings: corners [x, z] in channel axes [m] (docs/page.md)."""
        return _native.scene(self.text(), self.source_file)

    def _repr_svg_(self) -> str:
        return drawing.case_svg(self.scene())

    def __repr__(self) -> str:
        return f"<Case {self._data.get('name', '')!r}, {len(self._data.get('barriers', []))} barrier(s)>"


def load_case(source: Union[PathLike, Mapping[str, Any]]) -> Case:
    """Reads a case: a file, the name of a shipped one, or its content as a dict.

    Raises:
        InputError: with every mistake in it.
    """
    if isinstance(source, Mapping):
        return Case(source).check()
    data, file = _native.load_case(os.fspath(source))
    return Case(data, file)
