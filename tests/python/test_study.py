"""Studies, the search by ask and tell, advice."""

from __future__ import annotations

import json
import pickle
import subprocess
import sys
import unittest

import parapet as pp
import tiny


class Study(tiny.InFolder):
    def test_evaluate_is_that_of_the_program(self) -> None:
        design = json.dumps(tiny.DESIGN)
        theirs = tiny.run(tiny.program(), "evaluate", "study.json", "--design", design, cwd=self.folder)
        study = pp.Study(tiny.STUDY)
        ours = study.evaluate(tiny.DESIGN)
        self.assertEqual(tiny.without_times(ours), tiny.without_times(json.loads(theirs.stdout)))
        self.assertEqual(study.records, [ours])
        one_by_one = [study.evaluate({**tiny.DESIGN, "deflector_angle_deg": a}) for a in (10, 20)]
        together = study.evaluate_all([{**tiny.DESIGN, "deflector_angle_deg": a} for a in (10, 20)])
        for left, right in zip(one_by_one, together):
            left["id"] = right["id"] = ""
            self.assertEqual(tiny.without_times(left), tiny.without_times(right))

    def test_one_scenario_and_another_spacing(self) -> None:
        study = pp.Study(tiny.STUDY)
        record = study.evaluate(tiny.DESIGN, scenario="stiff", spacing_m=0.025)
        self.assertEqual([one["name"] for one in record["scenarios"]], ["stiff"])
        self.assertEqual(record.spacing_m, 0.025)
        case = study.case(tiny.DESIGN, scenario="stiff", spacing_m=0.025)
        self.assertEqual(case.material.yield_stress_pa, 150)
        self.assertEqual(case.hash(), record["scenarios"][0]["case_hash"])
        self.assertEqual(pp.simulate(case, frames=0).metrics, record.metrics)
        with self.assertRaises(KeyError):
            study.evaluate(tiny.DESIGN, scenario="wet")

    def test_wrong_designs_and_studies(self) -> None:
        study = pp.Study(tiny.STUDY)
        with self.assertRaises(pp.InputError) as caught:
            study.evaluate({**tiny.DESIGN, "deflector_angle_deg": 99})
        self.assertEqual(caught.exception.pointer, "/deflector_angle_deg")
        self.assertEqual(caught.exception.value, "99")
        again = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual(again.issues, caught.exception.issues)
        with self.assertRaises(pp.InputError):
            study.changed(method={"algorithm": "MAGIC"})

    def test_search_asks_for_the_designs_of_the_program(self) -> None:
        tiny.run(
            *(tiny.program(), "optimize", "study.json", "--out", "out", "--jobs", "1", "--quiet"),
            cwd=self.folder,
        )
        study = pp.Study(self.folder / "study.json")
        search = pp.Search(study)
        while asked := search.ask():
            search.tell(asked, [study.evaluate(asked[0])])
        theirs = tiny.log_of(self.folder / "out")
        self.assertEqual(len(theirs), 10)
        self.assertEqual([tiny.without_times(r) for r in search.records], theirs)
        self.assertEqual(search.stop_reason, "budget")
        pareto = json.loads((self.folder / "out/pareto.json").read_text())
        self.assertEqual([r["id"] for r in search.front()], [d["id"] for d in pareto["designs"]])
        self.assertEqual(search.front().hypervolume, pareto["hypervolume"])
        folder = pp.load_study_folder(self.folder / "out")
        self.assertEqual(folder.state, "done")
        self.assertEqual([r["id"] for r in folder.front()], [r["id"] for r in search.front()])
        self.assertEqual(len(folder.records), 10)

    def test_ask_for_several_and_tell_in_any_order(self) -> None:
        study = pp.Study(tiny.STUDY)
        search = pp.Search(study, seed=2)
        designs = search.ask(4)
        self.assertEqual(len(designs), 4)
        records = [study.evaluate(design) for design in designs]
        with self.assertRaises(ValueError):
            search.tell(designs[0], records[1])
        search.tell(designs[::-1], records[::-1])
        self.assertEqual(search.pending, [])
        with self.assertRaises(ValueError):
            search.tell(designs[0], records[0])
        search.tell_other(study.evaluate(tiny.DESIGN))
        self.assertEqual(len(search.records), 5)

    def test_advice_is_that_of_the_program(self) -> None:
        tiny.run(
            *(tiny.program(), "optimize", "study.json", "--out", "out", "--quiet"), cwd=self.folder
        )
        out = str(self.folder / "out")
        tiny.run(tiny.program(), "recommend", out, "--no-confirm", "--quiet", cwd=self.folder)
        theirs = json.loads((self.folder / "out/recommendation.json").read_text())
        before = sorted((p.name, p.stat().st_mtime_ns) for p in (self.folder / "out").iterdir())
        ours = pp.recommend(self.folder / "out")
        after = sorted((p.name, p.stat().st_mtime_ns) for p in (self.folder / "out").iterdir())
        self.assertEqual(ours.json, theirs)
        self.assertEqual(ours.text, (self.folder / "out/recommendation.md").read_text())
        self.assertEqual(ours.design, theirs["recommended"]["design"])
        self.assertEqual(before, after)

    def test_plots(self) -> None:
        import matplotlib

        matplotlib.use("Agg")
        study = pp.Study(tiny.STUDY)
        study.evaluate_all([{**tiny.DESIGN, "deflector_angle_deg": a} for a in (5, 25, 50)])
        axes = pp.plot.front(study)
        self.assertEqual(axes.get_xlabel(), "barrier_1_slam_force_n_per_m")
        drawn = sum(len(dots.get_offsets()) for dots in axes.collections)
        self.assertEqual(drawn, 3)
        figure = pp.plot.flow(pp.simulate(tiny.CASE))
        self.assertGreaterEqual(sum(bool(a.get_title()) for a in figure.axes), 4)
        pp.plot.series(pp.simulate(tiny.CASE), "front_x_m")


class Stream(tiny.InFolder):
    """parapet evaluate --stdin-jsonl as Python calls it, directly and as ssh would."""

    def ask(self, command: list[str]) -> list[dict[str, object]]:
        with subprocess.Popen(
            command, cwd=self.folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1
        ) as process:
            assert process.stdin is not None and process.stdout is not None
            answers = []
            for angle in (10, 20, 30):  # each question waits for the answer before it
                line = {"id": f"a{angle}", "design": {**tiny.DESIGN, "deflector_angle_deg": angle}}
                process.stdin.write(json.dumps(line) + "\n")
                answers.append(json.loads(process.stdout.readline()))
            process.stdin.close()
            self.assertEqual(process.wait(timeout=60), 0)
        return answers

    def test_one_process_answers_question_by_question(self) -> None:
        direct = self.ask([tiny.program(), "evaluate", "study.json", "--stdin-jsonl", "--quiet"])
        self.assertEqual([answer["id"] for answer in direct], ["a10", "a20", "a30"])
        self.assertTrue(all(answer["status"] == "ok" for answer in direct))
        # What ssh does with a command: its words, joined, to a shell on the other side.
        words = " ".join([tiny.program(), "evaluate", "study.json", "--stdin-jsonl", "--quiet"])
        remote = self.ask(["sh", "-c", words])
        self.assertEqual(tiny.without_times(remote), tiny.without_times(direct))

    def test_a_shell_pipe_gets_a_record_for_each_line(self) -> None:
        lines = "".join(
            json.dumps({"id": f"a{angle}", "design": {**tiny.DESIGN, "deflector_angle_deg": angle}}) + "\n"
            for angle in (10, 20, 1000)  # the last one is out of bounds
        )
        self.write("designs.jsonl", lines)
        words = f"cat designs.jsonl | {tiny.program()} evaluate study.json --stdin-jsonl --jobs 2 --quiet | cat > records.jsonl"
        tiny.run("sh", "-c", words, cwd=self.folder)
        records = [json.loads(line) for line in (self.folder / "records.jsonl").read_text().splitlines()]
        self.assertEqual(sorted(record["id"] for record in records), ["a10", "a1000", "a20"])
        wrong = next(record for record in records if record["id"] == "a1000")
        self.assertIn("1000", json.dumps(wrong))
        self.assertNotEqual(wrong.get("status"), "ok")


class Types(unittest.TestCase):
    def test_the_package_is_typed(self) -> None:
        try:
            import mypy  # noqa: F401
        except ImportError:
            self.skipTest("mypy is not installed")
        import os

        root = os.environ["PARAPET_SOURCE"]
        done = subprocess.run(
            [sys.executable, "-m", "mypy", "--config-file", "pyproject.toml"],
            cwd=root, capture_output=True, text=True,
        )
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
