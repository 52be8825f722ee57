"""The asker's side: a study's simulations on the workers of a Dask cluster.

The study itself runs here, in the program's own loop, and its folder is the truth. A cluster is hands:
it is given tasks, and whatever it loses is given again.
"""

from __future__ import annotations

import collections
import functools
import itertools
import queue
import time
import zlib
from concurrent.futures import CancelledError
from dataclasses import dataclass, field
from typing import Any, Callable, Optional

from distributed import Client, Future, KilledWorker
from distributed.comm import CommClosedError

from .worker import identify, own_identity, run_task

Say = Callable[[str], None]
Task = Callable[[str], bytes]

LOST = (OSError, CommClosedError, TimeoutError, CancelledError)
"""What a connection that goes away raises; TimeoutError of asyncio is the built-in one from 3.11 on."""


AT_ONCE = 32
"""Outcomes that are fetched together at most."""

MANY_THREADS = 16
"""From so many threads of workers on, some tasks wait at the scheduler."""


def places_for(threads: int) -> int:
    """Simulations under way for workers of so many threads: half as many more where they are many.

    A worker then finds its next task there, whatever the asker is doing meanwhile.
    """
    return threads if threads < MANY_THREADS else threads + threads // 2


class ClusterLost(RuntimeError):
    """No scheduler can be reached any more."""


@dataclass
class _OpenTask:
    """Tickets that wait for the same simulation."""

    text: str
    tickets: list[int]
    future: Optional[Future] = None
    attempt: int = 0
    allowed: frozenset[str] = frozenset()


@dataclass
class Workers:
    """Which workers may simulate: those whose program and bits are the asker's.

    Attributes:
        expected: identity that a worker must have (see ``parapet.worker.own_identity``).
        threads: by address, of the workers that were admitted and are there.
        refused: by address, why.
    """

    expected: dict[str, Any]
    say: Say
    threads: dict[str, int] = field(default_factory=dict)
    refused: dict[str, str] = field(default_factory=dict)

    def update(self, client: Client) -> bool:
        """Asks new workers who they are. True when there is a new one that may simulate."""
        there = set(client.scheduler_info()["workers"])
        for address in set(self.threads) - there:
            del self.threads[address]
        for address in set(self.refused) - there:
            del self.refused[address]
        new = sorted(there - set(self.threads) - set(self.refused))
        if not new:
            return False
        answers = client.run(identify, workers=new, on_error="return")
        for address in new:
            if address in answers:
                self._judge(address, answers[address])
        return any(address in self.threads for address in new)

    def _judge(self, address: str, answer: Any) -> None:
        if isinstance(answer, BaseException):
            if isinstance(answer, LOST):
                return  # gone already
            why, name = f"{type(answer).__name__}: {answer}", address
        else:
            own, name = answer["identity"], f"{answer['name']} at {address}"
            why = "; ".join(
                f"{key} is {own.get(key)!r} instead of {value!r}"
                for key, value in self.expected.items()
                if own.get(key) != value
            )
        if why:
            self.refused[address] = why
            self.say(f"warning: the worker {name} is refused: {why}")
        else:
            self.threads[address] = answer["threads"]


class Cluster:
    """A connection to a scheduler that is made again when it breaks.

    Args:
        connect: gives a client, or raises OSError when there is no scheduler.
        patience_s: how long to try before giving up [s].
    """

    def __init__(
        self, connect: Callable[[], Client], say: Say, patience_s: float = 60.0
    ) -> None:
        self._connect = connect
        self._say = say
        self._patience_s = patience_s
        self._lost_at: Optional[float] = None
        self._look_at = 0.0
        self.client: Optional[Client] = connect()
        self.workers = Workers(own_identity(), say)

    def look(self) -> bool:
        """Looks after connection and workers, at most once a second.

        Returns:
            False when the connection broke or is broken: what was handed in is lost.

        Raises:
            ClusterLost: when patience is at an end.
        """
        if self.client is not None and self.client.status != "running":
            self._drop()
        if time.monotonic() < self._look_at:
            return self.client is not None
        self._look_at = time.monotonic() + 1.0
        try:
            if self.client is None:
                self.client = self._connect()
                self._say("info: the scheduler is there again")
            self._lost_at = None
            self.workers.update(self.client)
        except LOST:
            self._drop()
        return self.client is not None

    def _drop(self) -> None:
        now = time.monotonic()
        if self._lost_at is None:
            self._lost_at = now
            self._say(f"warning: the scheduler is lost; trying again for {self._patience_s:g} s")
        if self.client is not None:
            client, self.client = self.client, None
            try:
                client.close(timeout=2)
            except Exception:  # it is gone
                pass
        self.workers.threads.clear()
        self.workers.refused.clear()
        if now - self._lost_at > self._patience_s:
            raise ClusterLost("the scheduler is gone; nothing is lost, and the same command resumes")

    def wait_for_threads(self, least: int = 1) -> int:
        """Waits until admitted workers have so many threads, and gives their number."""
        said = False
        while True:
            self.look()
            threads = sum(self.workers.threads.values())
            if threads >= least:
                return threads
            if not said:
                self._say(f"info: waiting for workers with {least} thread(s), {threads} there")
                said = True
            time.sleep(0.2)

    def close(self) -> None:
        """Leaves the cluster; the workers stay."""
        if self.client is not None:
            self.client.close()


class DaskService:
    """Simulates tasks on a cluster, as ``parapet._native.run_program`` asks it to.

    A task that goes away with its worker or with the scheduler is handed in again, as often as it takes.

    Args:
        task: what a worker does with a task; another one is for tests and measurements.
    """

    def __init__(self, cluster: Cluster, task: Task = run_task) -> None:
        self._cluster = cluster
        self._task = task
        self._open: dict[str, _OpenTask] = {}
        self._ended: queue.SimpleQueue[tuple[str, int]] = queue.SimpleQueue()
        self._ready: collections.deque[tuple[Any, ...]] = collections.deque()
        self._attempts = itertools.count(1)
        self._look_at = 0.0

    def submit(self, ticket: int, key: str, task: str) -> None:
        """Hands a task in. Tasks of the same key are simulated once."""
        known = self._open.get(key)
        if known is not None:
            known.tickets.append(ticket)
            return
        self._open[key] = _OpenTask(task, [ticket])
        self._hand_in(key)

    def poll(self, timeout_s: float) -> Optional[tuple[Any, ...]]:
        """An outcome ``(ticket, json)`` or a failure ``(ticket, None, why)``; None when there is none.

        Raises:
            ClusterLost: when no scheduler can be reached any more.
        """
        self._look()
        if self._ready:
            return self._ready.popleft()
        ended: list[tuple[str, int]] = []
        try:
            ended.append(self._ended.get(timeout=timeout_s) if timeout_s > 0 else self._ended.get_nowait())
            while len(ended) < AT_ONCE:
                ended.append(self._ended.get_nowait())
        except queue.Empty:
            pass
        if ended:
            self._take(ended)
        return self._ready.popleft() if self._ready else None

    def cancel(self) -> None:
        """Nothing that was handed in is wanted any more."""
        for open_task in self._open.values():
            self._release(open_task)
        self._open.clear()

    def close(self) -> None:
        """The same, at the end."""
        self.cancel()

    def _look(self) -> None:
        """Hands in again what was lost, and what no worker could take before; twice a second."""
        if time.monotonic() < self._look_at:
            return
        self._look_at = time.monotonic() + 0.5
        connected = self._cluster.look()
        there = set(self._cluster.workers.threads)
        for key, open_task in self._open.items():
            if not connected:
                open_task.future, open_task.allowed = None, frozenset()
            elif open_task.allowed.isdisjoint(there):  # none of those that were allowed is left
                self._hand_in(key)

    def _hand_in(self, key: str) -> None:
        open_task = self._open[key]
        self._release(open_task)
        client, there = self._cluster.client, frozenset(self._cluster.workers.threads)
        if client is None or not there:
            return
        open_task.attempt = attempt = next(self._attempts)
        open_task.allowed = there
        try:
            # The name holds the case and the bits: the same simulation wherever it comes from.
            future = client.submit(
                self._task,
                open_task.text,
                key=f"parapet-{key}-{self._cluster.workers.expected['probe']}-{attempt}",
                workers=list(there),
                allow_other_workers=False,
                pure=False,
            )
            future.add_done_callback(lambda _: self._ended.put((key, attempt)))
            open_task.future = future
        except LOST:
            open_task.allowed = frozenset()

    def _release(self, open_task: _OpenTask) -> None:
        future, open_task.future = open_task.future, None
        if future is None:
            return
        try:
            future.cancel()
        except Exception:  # the cluster has gone
            pass

    def _take(self, ended: list[tuple[str, int]]) -> None:
        """Fetches the outcomes of tasks that have ended, all by one message."""
        done: dict[str, Future] = {}
        for key, attempt in ended:
            open_task = self._open.get(key)
            if open_task is None or open_task.attempt != attempt or open_task.future is None:
                continue  # of an attempt that was given up
            if open_task.future.status == "finished":
                done[key] = open_task.future
            else:
                self._take_failed(key, open_task.future)
        if not done:
            return
        client = self._cluster.client
        fetched: dict[str, bytes] = {}
        try:
            if client is not None:  # those whose worker goes away meanwhile are left out
                gather = functools.partial(client.gather, done, errors="skip", asynchronous=True)
                fetched = client.sync(gather, callback_timeout=20)
        except LOST:
            pass
        for key in done:
            if key in fetched:
                outcome = zlib.decompress(fetched[key]).decode()
                self._answer(key, *((ticket, outcome) for ticket in self._open[key].tickets))
            else:
                self._hand_in(key)

    def _take_failed(self, key: str, future: Future) -> None:
        try:
            future.result(timeout=20)
        except (KilledWorker, *LOST):
            self._hand_in(key)
        except Exception as error:  # the task's own: it would fail again
            why = f"{type(error).__name__}: {error}"
            self._answer(key, *((ticket, None, why) for ticket in self._open[key].tickets))
        else:
            self._hand_in(key)

    def _answer(self, key: str, *answers: tuple[Any, ...]) -> None:
        self._ready.extend(answers)
        del self._open[key]
