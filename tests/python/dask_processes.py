"""A Dask scheduler and workers as processes that can be killed, as people start them by hand."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path
from typing import Optional


def free_port() -> int:
    """A port that nobody listens at."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


class DaskProcesses:
    """Scheduler and workers on this machine; each of their outputs goes to a file of the folder."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.port = free_port()
        self.address = f"tcp://127.0.0.1:{self.port}"
        self.scheduler: Optional[subprocess.Popen[bytes]] = None
        self.workers: dict[str, subprocess.Popen[bytes]] = {}
        self._started = 0

    def _start(
        self, log: str, module: str, *arguments: str, python: str = sys.executable, **environment: str
    ) -> subprocess.Popen[bytes]:
        with open(self.folder / log, "ab") as output:
            return subprocess.Popen(
                [python, "-m", module, *arguments],
                cwd=self.folder,
                stdout=output,
                stderr=output,
                env={**os.environ, **environment},
            )

    def start_scheduler(self) -> None:
        """The same address each time."""
        self.scheduler = self._start(
            *("scheduler.log", "distributed.cli.dask_scheduler", "--host", "127.0.0.1"),
            *("--port", str(self.port), "--no-dashboard", "--no-show"),
        )
        for _ in range(600):
            with socket.socket() as probe:
                if probe.connect_ex(("127.0.0.1", self.port)) == 0:
                    return
            time.sleep(0.1)
        raise RuntimeError("the scheduler does not come up")

    def start_worker(self, *arguments: str, **environment: str) -> str:
        """A worker of one thread without a nanny; its name."""
        self._started += 1
        name = f"w{self._started}"
        self.workers[name] = self._start(
            *(f"{name}.log", "distributed.cli.dask_worker", self.address, "--nthreads", "1"),
            *("--no-nanny", "--no-dashboard", "--name", name, *arguments),
            **environment,
        )
        return name

    def kill_worker(self, name: str) -> None:
        """By SIGKILL."""
        worker = self.workers.pop(name)
        worker.kill()
        worker.wait()

    def kill_scheduler(self) -> None:
        """By SIGKILL. Its workers end by themselves."""
        assert self.scheduler is not None
        self.scheduler.kill()
        self.scheduler.wait()

    def forget_ended_workers(self) -> None:
        """Those that have ended by themselves."""
        for name in [name for name, worker in self.workers.items() if worker.poll() is not None]:
            del self.workers[name]

    def close(self) -> None:
        """Ends all."""
        everybody = [*self.workers.values(), *([self.scheduler] if self.scheduler else [])]
        for process in everybody:
            process.send_signal(signal.SIGTERM)
        for process in everybody:
            try:
                process.wait(timeout=15)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
