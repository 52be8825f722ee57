"""The program `parapet` from Python: python3 -m parapet VERB ...

The verbs optimize, table3 and recommend simulate on the workers of a Dask cluster: that of --scheduler, or
one on this machine. All others are as in the program.
"""

from __future__ import annotations

import argparse
import os
import sys
from typing import Any, Callable, Optional, Sequence

from parapet import _native

VERBS = ("optimize", "table3", "recommend")

EPILOGUE = """
Workers are started as always, for example `dask-worker tcp://HOST:8786 --nthreads 1 --nworkers auto`, with
this package of the same revision installed; docs/cluster has recipes. Whoever reaches a Dask scheduler can
run programs as its user: use it in a network that you trust, or with the --tls options.

Examples:
  python3 -m parapet optimize quickstart
  python3 -m parapet optimize my_study.json --scheduler tcp://head:8786 --out runs/my_study

The options of the verb itself:
"""


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python3 -m parapet VERB",
        add_help=False,
        allow_abbrev=False,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Options of the verbs optimize, table3 and recommend, for the cluster that simulates:",
        epilog=EPILOGUE,
    )
    add = parser.add_argument
    add("--scheduler", metavar="ADDRESS", help="of a Dask scheduler, such as tcp://HOST:8786")
    add("--scheduler-file", metavar="FILE", help="that `dask-scheduler --scheduler-file` has written")
    add("--wait-for", metavar="N", type=int, default=1, help="begin with N threads of workers (default: 1)")
    add("--patience-s", metavar="S", type=float, default=60.0, help="of waiting for a lost scheduler [s]")
    add("--tls-ca", metavar="FILE", help="certificate of the authority; then all traffic is encrypted")
    add("--tls-cert", metavar="FILE", help="own certificate")
    add("--tls-key", metavar="FILE", help="own key")
    add("-j", "--jobs", metavar="N", type=int, help="simulations under way (default: the threads; from 16 on half more)")
    return parser


def _close(local: Any) -> None:
    local.close(timeout=10)


def _connector(options: argparse.Namespace) -> tuple[Callable[[], Any], Callable[[], None]]:
    """How to reach the cluster, and how to leave it."""
    from distributed import Client, LocalCluster, Security

    if options.scheduler is None and options.scheduler_file is None:
        local = LocalCluster(
            n_workers=options.jobs or len(os.sched_getaffinity(0)),
            threads_per_worker=1,
            dashboard_address=None,
            silence_logs=50,
        )
        return lambda: Client(local, timeout=20), lambda: _close(local)
    security = None
    if options.tls_ca:
        security = Security(
            tls_ca_file=options.tls_ca,
            tls_client_cert=options.tls_cert,
            tls_client_key=options.tls_key,
            require_encryption=True,
        )

    def connect() -> Any:
        if options.scheduler_file is not None:
            return Client(scheduler_file=options.scheduler_file, security=security, timeout=5)
        return Client(options.scheduler, security=security, timeout=5)

    return connect, lambda: None


def _on_cluster(options: argparse.Namespace, rest: list[str], quiet: bool) -> int:
    import logging

    from .cluster import Cluster, ClusterLost, DaskService, places_for

    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # what matters is said here

    def say(text: str) -> None:
        if not quiet or not text.startswith("info"):
            print(text, file=sys.stderr, flush=True)

    connect, leave = _connector(options)
    try:
        cluster = Cluster(connect, say, options.patience_s)
    except OSError as error:
        print(f"error: no scheduler at {options.scheduler or options.scheduler_file}: {error}", file=sys.stderr)
        leave()
        return 1
    try:
        threads = cluster.wait_for_threads(options.wait_for)
        say(f"info: {threads} thread(s) of {len(cluster.workers.threads)} worker(s)")
        jobs = options.jobs or places_for(threads)
        return _native.run_program(
            ["parapet", *rest, "--jobs", str(jobs)], lambda places: DaskService(cluster)
        )
    except ClusterLost as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    finally:
        cluster.close()
        leave()


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Runs a verb and gives the exit code: 0 done, 1 failed, 2 bad input, 130 interrupted."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    words = [word for before, word in zip(["", *given], given) if before != "--log-level"]
    verb = next((word for word in words if not word.startswith("-")), "")
    if verb not in VERBS:
        return _native.run_program(["parapet", *given], None)
    parser = _parser()
    if "-h" in given or "--help" in given:
        print(parser.format_help(), flush=True)
        return _native.run_program(["parapet", *given], None)
    options, rest = parser.parse_known_args(given)
    return _on_cluster(options, rest, quiet="-q" in rest or "--quiet" in rest)


if __name__ == "__main__":
    sys.exit(main())
