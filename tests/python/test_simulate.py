"""Cases and their simulations."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
import time
import unittest
import xml.etree.ElementTree

import numpy as np

import parapet as pp
import tiny


class Simulate(tiny.InFolder):
    def test_result_is_that_of_the_program(self) -> None:
        tiny.run(tiny.program(), "simulate", "case.json", "--out", "out", "--quiet", cwd=self.folder)
        theirs = json.loads((self.folder / "out/result.json").read_text())
        ours = pp.simulate(self.folder / "case.json")
        for result in (theirs, ours.json):
            del result["timing"]
        self.assertEqual(json.dumps(ours.json), json.dumps(theirs))
        lines = (self.folder / "out/series.csv").read_text().splitlines()
        self.assertEqual(lines[0].split(","), list(ours.series.dtype.names))
        for line, row in zip(lines[1:], ours.series, strict=True):
            numbers = [float(text) if text else float("nan") for text in line.split(",")]
            np.testing.assert_array_equal(numbers, list(row))

    def test_members_are_read_set_and_checked(self) -> None:
        case = pp.load_case(tiny.CASE)
        self.assertEqual(case.barriers[0].deflector.angle_deg, 30)
        case.barriers[0].deflector.angle_deg = np.float64(45)
        case.numerics["spacing_m"] = 0.025
        result = pp.simulate(case, frames=0)
        self.assertEqual(result.json["case"]["barriers"][0]["deflector"]["angle_deg"], 45)
        self.assertEqual(result.json["provenance"]["spacing_m"], 0.025)
        self.assertEqual(result.frames, [])
        with self.assertRaises(AttributeError):
            case.barriers[0].angle
        case.barriers[0].height_m = -1
        with self.assertRaises(pp.InputError) as caught:
            case.check()
        self.assertEqual(caught.exception.pointer, "/barriers/0/height_m")
        self.assertEqual(caught.exception.value, "-1")
        self.assertEqual(caught.exception.file, case.source_file)

    def test_spacing_is_the_programs(self) -> None:
        for spacing_mm in (12.3, 17.1, 23.7):
            result = pp.simulate(self.folder / "case.json", spacing_m=spacing_mm / 1000, frames=0)
            self.assertEqual(result.json["provenance"]["spacing_m"], spacing_mm / 1000)

    def test_errors_name_file_place_and_value(self) -> None:
        self.write("wrong.json", {**tiny.CASE, "reservoir": {"length_m": "long"}})
        with self.assertRaises(pp.InputError) as caught:
            pp.load_case(self.folder / "wrong.json")
        issue = caught.exception.issues[0]
        self.assertTrue(issue.file.endswith("wrong.json"))
        self.assertEqual(issue.pointer, "/reservoir/length_m")
        self.assertEqual(issue.value, '"long"')
        self.assertIn(issue.problem, str(caught.exception))
        with self.assertRaises(pp.InputError):
            pp.load_case("no_such_case")

    def test_frames_change_nothing_and_are_evenly_spread(self) -> None:
        with_frames = pp.simulate(tiny.CASE, frames=8)
        without = pp.simulate(tiny.CASE, frames=0)
        for result in (with_frames, without):
            del result.json["timing"]
        self.assertEqual(with_frames.json, without.json)
        times = [frame.time_s for frame in with_frames.frames]
        self.assertTrue(3 <= len(times) <= 9, times)
        self.assertEqual(times[-1], with_frames.json["stop_time_s"])
        steps = np.diff(times)[:-1]
        np.testing.assert_allclose(steps, steps[0], rtol=0.2)
        frame = with_frames.frames[1]
        self.assertEqual(frame.x_m.shape, frame.speed_m_s.shape)
        self.assertGreater(frame.speed_m_s.max(), 0.0)

    def test_uncertainty_progress_and_frame(self) -> None:
        calls: list[tuple[float, float]] = []
        result = pp.simulate(tiny.CASE, uncertainty=True, progress=lambda now, end: calls.append((now, end)))
        self.assertGreater(result.uncertainty["retention_efficiency"]["expanded_95"], 0.0)
        self.assertTrue(all(0.0 <= now <= end for now, end in calls))
        self.assertEqual(result.to_frame().index.name, "time_s")

    def test_a_drawing_is_svg_of_every_barrier(self) -> None:
        case = pp.load_case(tiny.CASE)
        case.barriers.append({"spacing_m": 0.3, "height_m": 0.1})
        tree = xml.etree.ElementTree.fromstring(case._repr_svg_())
        paths = tree.findall("{http://www.w3.org/2000/svg}path")
        self.assertEqual(len(paths), 2 + len(case.barriers))

    def test_a_notebook_shows_a_table_of_the_metrics_and_the_drawing(self) -> None:
        result = pp.simulate(tiny.CASE, frames=0)
        shown = result._repr_html_()
        self.assertIn("<svg", shown)
        self.assertEqual(shown.count("<tr>"), len(result.metrics))

    def test_other_threads_go_on(self) -> None:
        count = 0
        ended = threading.Event()

        def tick() -> None:
            nonlocal count
            while not ended.is_set():
                count += 1
                time.sleep(0.001)

        thread = threading.Thread(target=tick)
        thread.start()
        begin = time.monotonic()
        pp.simulate("single_barrier", spacing_m=0.015, frames=0, threads=1)
        elapsed = time.monotonic() - begin
        ended.set()
        thread.join()
        # With the lock held the other thread would not run once.
        self.assertGreater(count, 5, f"in {elapsed:.1f} s")

    def test_ctrl_c_ends_a_simulation(self) -> None:
        script = (
            "import signal\n"
            "import parapet as pp\n"
            # who starts the tests in the background may have had it ignored
            "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
            "def progress(now, end):\n"
            "    print('running', flush=True)\n"
            "try:\n"
            "    pp.simulate('single_barrier', spacing_m=0.002, progress=progress)\n"
            "except KeyboardInterrupt:\n"
            "    print('interrupted')\n"
        )
        with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True) as process:
            assert process.stdout is not None
            self.assertEqual(process.stdout.readline(), "running\n")
            process.send_signal(signal.SIGINT)
            try:
                rest, _ = process.communicate(timeout=120)
            finally:
                process.kill()
        self.assertEqual(process.returncode, 0)
        self.assertTrue(rest.endswith("interrupted\n"), rest)

    def test_waiting_threads_sleep(self) -> None:
        script = "import parapet, ctypes; ctypes.CDLL('libgomp.so.1').omp_display_env(1)"
        environment = {k: v for k, v in os.environ.items() if not k.startswith(("OMP", "GOMP"))}
        shown = tiny.run(sys.executable, "-c", script, cwd=self.folder, env=environment).stderr
        self.assertIn("OMP_WAIT_POLICY = 'PASSIVE'", shown)


if __name__ == "__main__":
    unittest.main()
