"""The process that simulates tasks for a worker: python3 -m parapet._task_process.

One request a line on standard input, one answer a line on standard output:

    simulate THREADS TASK    ok OUTCOME     both as JSON
    identity                 ok IDENTITY    as JSON
                             error SENTENCE

It ends when its input ends: the worker has gone.
"""

from __future__ import annotations

import json
import os
import queue
import sys
import threading

from parapet import _native


def _answer(simulator: _native.TaskSimulator, request: str) -> str:
    word, _, rest = request.partition(" ")
    try:
        if word == "identity":
            return "ok " + json.dumps(_native.identity())
        threads, _, task = rest.partition(" ")
        return "ok " + simulator.simulate(task, int(threads))
    except Exception as error:  # whatever it is, the asker must learn of it
        return "error " + " ".join(f"{type(error).__name__}: {error}".split())


def _read(requests: queue.SimpleQueue[str]) -> None:
    for line in sys.stdin:
        requests.put(line.rstrip("\n"))
    os._exit(0)  # also in the middle of a simulation


def main() -> None:
    requests: queue.SimpleQueue[str] = queue.SimpleQueue()
    threading.Thread(target=_read, args=(requests,), daemon=True).start()
    simulator = _native.TaskSimulator()
    while True:
        print(_answer(simulator, requests.get()), flush=True)


if __name__ == "__main__":
    main()
