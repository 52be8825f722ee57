"""Studies on Dask workers: the same folder and log as the program's, whatever dies."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import threading
import time
import unittest
import zlib
from pathlib import Path
from typing import Any, Callable

import tiny

try:
    import distributed
    import psutil
except ImportError:
    distributed = None

from dask_processes import DaskProcesses
from parapet import worker


def wait_until(condition: Callable[[], bool], seconds: float = 120.0) -> None:
    deadline = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError("it does not come to pass")
        time.sleep(0.05)


def lines(folder: Path) -> int:
    log = folder / "evaluations.jsonl"
    return log.read_text().count("\n") if log.exists() else 0


class TaskProcesses(unittest.TestCase):
    """What a worker does, without Dask."""

    @staticmethod
    def task(case: dict[str, Any]) -> str:
        import parapet as pp

        resolved = pp.load_case(case)
        task = {
            "format": "parapet-simulation-task/1", "label": "0001", "design": {}, "scenario": "",
            "threads": 4, "key": resolved.hash(), "case": resolved.to_dict(),
        }
        return json.dumps(task)

    def test_outcome_is_that_of_a_simulation(self) -> None:
        import parapet as pp

        outcome = json.loads(zlib.decompress(worker.run_task(self.task(tiny.CASE))))
        self.assertEqual(outcome["format"], "parapet-simulation-outcome/1")
        metrics = {one["key"]: one["value"] for one in outcome["metrics"]}
        self.assertEqual(metrics, pp.simulate(tiny.CASE, frames=0).metrics)

    def test_a_changed_task_is_an_error(self) -> None:
        changed = json.loads(self.task(tiny.CASE))
        changed["case"]["reservoir"]["height_m"] = 0.09
        with self.assertRaises(worker.TaskError) as caught:
            worker.run_task(json.dumps(changed))
        self.assertIn("changed on the way", str(caught.exception))

    @unittest.skipIf(distributed is None, "python3-distributed is not installed")
    def test_a_task_whose_process_dies_three_times_has_failed(self) -> None:
        long_case = {**tiny.CASE, "numerics": {"spacing_m": 0.0015}, "run": {"stop_time_s": 5.0}}
        answer: list[bytes] = []
        thread = threading.Thread(target=lambda: answer.append(worker.run_task(self.task(long_case))))
        thread.start()
        killed: set[int] = set()
        while len(killed) < worker.MOST_DEATHS:
            for child in psutil.Process().children():
                if child.pid not in killed and "parapet._task_process" in child.cmdline():
                    time.sleep(0.3)
                    child.send_signal(signal.SIGKILL)
                    killed.add(child.pid)
            time.sleep(0.05)
        thread.join(timeout=60)
        outcome = json.loads(zlib.decompress(answer[0]))
        self.assertFalse(outcome["ok"])
        self.assertEqual(
            outcome["reason"], "the process that simulated it died 3 times: SIGKILL, SIGKILL, SIGKILL"
        )

    def test_identity_is_the_same_each_time(self) -> None:
        own = worker.own_identity()
        worker.own_identity.cache_clear()
        self.assertEqual(worker.own_identity(), own)
        self.assertRegex(own["probe"], "^[0-9a-f]{16}$")


@unittest.skipIf(distributed is None, "python3-distributed is not installed")
class Places(unittest.TestCase):
    def test_few_workers_get_as_many_simulations_and_many_half_more(self) -> None:
        from parapet.cluster import places_for

        self.assertEqual([places_for(n) for n in (1, 4, 15, 16, 200)], [1, 4, 15, 24, 300])


@unittest.skipIf(distributed is None, "python3-distributed is not installed")
class OnThisMachine(tiny.InFolder):
    """Without --scheduler."""

    def test_study_confirmation_and_sweep_are_the_programs(self) -> None:
        verbs = (
            ("optimize", "study.json", "--out", "{}/study", "--jobs", "2"),
            ("recommend", "{}/study", "--jobs", "2"),
            ("table3", "sweep.json", "--out", "{}/sweep", "--jobs", "2"),
        )
        for verb in verbs:
            ours, theirs = ([word.format(who) for word in verb] for who in ("ours", "theirs"))
            tiny.run(*tiny.module(*ours, "--quiet"), cwd=self.folder)
            tiny.run(tiny.program(), *theirs, "--quiet", cwd=self.folder)
        ours, theirs = self.folder / "ours", self.folder / "theirs"
        self.assertEqual(tiny.log_of(ours / "study"), tiny.log_of(theirs / "study"))
        self.assertEqual(len(tiny.log_of(ours / "study")), 10)
        for name in ("confirmations.jsonl",):
            both = [
                sorted(
                    (tiny.without_times(json.loads(line)) for line in (who / "study" / name).read_text().splitlines()),
                    key=lambda record: str(record["id"]),
                )
                for who in (ours, theirs)
            ]
            self.assertEqual(*both)
        for row in ("bare", "lifted"):
            both = [json.loads((who / f"sweep/rows/{row}.json").read_text()) for who in (ours, theirs)]
            for one in both:
                del one["timing"]
            self.assertEqual(*(json.dumps(one) for one in both))
            csv = [(who / f"sweep/rows/{row}.csv").read_text() for who in (ours, theirs)]
            self.assertEqual(*csv)
        # Each folder holds what the other does.
        for folder in ("study", "sweep"):
            names = [sorted(str(p.relative_to(who / folder)) for p in (who / folder).rglob("*")) for who in (ours, theirs)]
            self.assertEqual(*names)

    def test_a_study_that_knows_its_undisturbed_flow_is_the_programs(self) -> None:
        """Without scenarios the flow without barriers is simulated first, and goes along with every task."""
        objectives = [{"metric": "barrier_1_slam_force_n_per_m", "goal": "minimize"}]
        method = {"algorithm": "SOBOL", "max_evaluations": 3, "seed": 1}
        self.write("one.json", tiny.study(scenarios=[], objectives=objectives, method=method))
        end = ("optimize", "one.json", "--quiet", "--jobs", "1", "--out")
        tiny.run(*tiny.module(*end, "ours"), cwd=self.folder)
        tiny.run(tiny.program(), *end, "theirs", cwd=self.folder)
        log = tiny.log_of(self.folder / "ours")
        self.assertEqual(log, tiny.log_of(self.folder / "theirs"))
        self.assertEqual(len(log), 3)
        self.assertTrue((self.folder / "ours/approach.json").exists())

    def test_either_resumes_the_others_study(self) -> None:
        def until_half(command: list[str], folder: str) -> None:
            with subprocess.Popen(
                [*command, "optimize", "study.json", "--out", folder, "--jobs", "2"],
                cwd=self.folder, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            ) as process:
                wait_until(lambda: lines(self.folder / folder) >= 4)
                process.send_signal(signal.SIGINT)
                self.assertEqual(process.wait(timeout=60), 130)
            self.assertLess(lines(self.folder / folder), 10)

        end = ("optimize", "study.json", "--quiet", "--out")
        tiny.run(tiny.program(), *end, "whole", "--jobs", "2", cwd=self.folder)
        until_half(tiny.module(), "a")
        tiny.run(tiny.program(), *end, "a", "--jobs", "1", cwd=self.folder)
        until_half([tiny.program()], "b")
        tiny.run(*tiny.module(*end, "b", "--jobs", "3"), cwd=self.folder)
        whole = tiny.log_of(self.folder / "whole")
        self.assertEqual(tiny.log_of(self.folder / "a"), whole)
        self.assertEqual(tiny.log_of(self.folder / "b"), whole)

    def test_bad_input_and_help_are_the_programs(self) -> None:
        shown = tiny.run(*tiny.module("optimize", "no_such_study"), cwd=self.folder, code=2)
        self.assertIn("there is no such file", shown.stderr)
        shown = tiny.run(*tiny.module("optimize", "--help"), cwd=self.folder)
        self.assertIn("--scheduler", shown.stdout)
        self.assertIn("--mix-revisions", shown.stdout)
        shown = tiny.run(*tiny.module("check", "study.json"), cwd=self.folder)
        self.assertIn("study.json: ok", shown.stdout)


@unittest.skipIf(distributed is None, "python3-distributed is not installed")
class OnACluster(tiny.InFolder):
    """With --scheduler."""

    def setUp(self) -> None:
        super().setUp()
        self.dask = DaskProcesses(self.folder)
        self.addCleanup(self.dask.close)
        self.dask.start_scheduler()

    def start(self, *more: str) -> subprocess.Popen[str]:
        command = tiny.module(
            "optimize", "study.json", "--out", "out", "--scheduler", self.dask.address, *more
        )
        return subprocess.Popen(command, cwd=self.folder, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)

    def whole_log(self, jobs: int) -> list[Any]:
        tiny.run(
            *(tiny.program(), "optimize", "study.json", "--out", "whole", "--jobs", str(jobs), "--quiet"),
            cwd=self.folder,
        )
        return tiny.log_of(self.folder / "whole")

    def test_other_workers_are_refused_by_name(self) -> None:
        self.write(
            "other_bits.py",
            "from parapet import worker\n"
            "own = dict(worker.own_identity(), probe='0123456789abcdef', git_revision='old')\n"
            "worker.own_identity = lambda: own\n",
        )
        other = self.dask.start_worker("--preload", "other_bits.py")
        # Without parapet, wherever it is installed: the interpreter that a virtual environment stands on.
        bare = self.dask.start_worker(python=getattr(sys, "_base_executable", sys.executable), PYTHONPATH="")
        own = self.dask.start_worker()
        process = self.start("--wait-for", "1")
        _, said = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 0, said)
        self.assertRegex(said, f"the worker {other} at tcp://[0-9.:]+ is refused: git_revision is 'old' instead of")
        self.assertIn("probe is '0123456789abcdef' instead of", said)
        self.assertRegex(said, "the worker tcp://[0-9.:]+ is refused: .*parapet")
        self.assertNotIn(f"worker {own} at", said)
        self.assertNotIn("parapet-", (self.folder / f"{bare}.log").read_text())
        self.assertEqual(tiny.log_of(self.folder / "out"), self.whole_log(1))

    def test_nothing_is_lost_with_workers_and_scheduler(self) -> None:
        # So long that it outlasts the scheduler.
        method = {**tiny.STUDY["method"], "max_evaluations": 40}
        self.write("study.json", tiny.study(method=method))
        whole = self.whole_log(2)
        names = [self.dask.start_worker() for _ in range(2)]
        process = self.start("--wait-for", "2")
        wait_until(lambda: lines(self.folder / "out") >= 2)
        self.dask.kill_worker(names[0])
        self.dask.start_worker()
        wait_until(lambda: lines(self.folder / "out") >= 4)
        self.dask.kill_scheduler()
        time.sleep(1.0)
        self.dask.start_scheduler()
        for worker_process in list(self.dask.workers):
            self.dask.kill_worker(worker_process)
        for _ in range(2):
            self.dask.start_worker()
        _, said = process.communicate(timeout=300)
        # Whether it says that the scheduler is lost is a matter of time: a client that finds the new one
        # within a second has only lost its tasks.
        self.assertEqual(process.returncode, 0, said)
        self.assertEqual(tiny.log_of(self.folder / "out"), whole)

    def test_a_lost_scheduler_ends_it_and_the_same_command_resumes(self) -> None:
        whole = self.whole_log(1)
        self.dask.start_worker()
        process = self.start("--patience-s", "2")
        wait_until(lambda: lines(self.folder / "out") >= 3)
        self.dask.kill_scheduler()
        _, said = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 1, said)
        self.assertIn("the same command resumes", said)
        self.dask.start_scheduler()
        self.dask.start_worker()
        process = self.start()
        _, said = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 0, said)
        self.assertEqual(tiny.log_of(self.folder / "out"), whole)


if __name__ == "__main__":
    unittest.main()
