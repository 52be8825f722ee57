"""What runs on a Dask worker: simulations, each in a process of its own, and who the worker is."""

from __future__ import annotations

import asyncio
import functools
import json
import os
import queue
import signal
import subprocess
import sys
import zlib
from typing import Any

from . import _native

MOST_DEATHS = 3
"""So often may the process of a task die; then the design has failed. A worker that goes away with its
processes does not count."""


class ProcessDied(Exception):
    """The process of a task has ended before it answered."""


class TaskError(RuntimeError):
    """A task that is no task of this version."""


class TaskProcess:
    """A process that simulates one task after the other."""

    def __init__(self) -> None:
        environment = {**os.environ}
        if "GOMP_SPINCOUNT" not in environment:
            environment.setdefault("OMP_WAIT_POLICY", "passive")
        self._process = subprocess.Popen(
            [sys.executable, "-m", "parapet._task_process"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            bufsize=1,
            env=environment,
        )

    @property
    def pid(self) -> int:
        return self._process.pid

    def ask(self, request: str) -> str:
        """The answer to a request.

        Raises:
            ProcessDied: saying how.
            TaskError: with what the process says of the request.
        """
        assert self._process.stdin is not None and self._process.stdout is not None
        try:
            self._process.stdin.write(request + "\n")
            self._process.stdin.flush()
            answer = self._process.stdout.readline()
        except OSError:
            answer = ""
        if not answer.endswith("\n"):
            raise ProcessDied(self._how_it_ended())
        word, _, rest = answer.rstrip("\n").partition(" ")
        if word != "ok":
            raise TaskError(rest)
        return rest

    def _how_it_ended(self) -> str:
        self._process.kill()  # if it only closed its output
        status = self._process.wait()
        if status >= 0:
            return f"exit code {status}"
        try:
            return signal.Signals(-status).name
        except ValueError:
            return f"signal {-status}"

    def close(self) -> None:
        """Ends it."""
        if self._process.stdin is not None:
            self._process.stdin.close()
        self._process.kill()
        self._process.wait()
        if self._process.stdout is not None:
            self._process.stdout.close()


@functools.lru_cache(maxsize=None)
def _idle_processes() -> queue.LifoQueue[TaskProcess]:
    """Those of this worker that wait for a task."""
    return queue.LifoQueue()


def _take_process() -> TaskProcess:
    try:
        return _idle_processes().get_nowait()
    except queue.Empty:
        return TaskProcess()


def run_task(task: str, threads: int = 1) -> bytes:
    """Simulates a task, format ``parapet-simulation-task/1``.

    Returns:
        Its outcome, format ``parapet-simulation-outcome/1``, compressed by zlib. A task whose process dies
        three times has failed with that reason.
    """
    deaths: list[str] = []
    while len(deaths) < MOST_DEATHS:
        process = _take_process()
        try:
            outcome = process.ask(f"simulate {threads} {task}")
        except ProcessDied as died:
            deaths.append(str(died))
            process.close()
            continue
        except BaseException:
            _idle_processes().put(process)
            raise
        _idle_processes().put(process)
        return zlib.compress(outcome.encode(), 1)
    reason = f"the process that simulated it died {MOST_DEATHS} times: {', '.join(deaths)}"
    return zlib.compress(_native.failed_outcome(reason).encode(), 1)


@functools.lru_cache(maxsize=None)
def own_identity() -> dict[str, Any]:
    """Version, revision, physics, compiler and the hash of a short simulation of this machine."""
    process = TaskProcess()
    try:
        identity: dict[str, Any] = json.loads(process.ask("identity"))
    finally:
        process.close()
    return identity


async def identify(dask_worker: Any = None) -> dict[str, Any]:
    """The identity of a worker, with its name and the number of its threads."""
    loop = asyncio.get_running_loop()
    own = await loop.run_in_executor(None, own_identity)
    state = getattr(dask_worker, "state", dask_worker)
    return {
        "identity": own,
        "name": str(getattr(dask_worker, "name", "")),
        "threads": int(getattr(state, "nthreads", 1)),
    }
