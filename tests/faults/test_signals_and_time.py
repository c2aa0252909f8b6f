"""Signals and a clock that is set back while the program renders and writes.
Usage: test_signals_and_time.py PATH_TO_UPS PATH_TO_LIBDISTURBANCES [unittest options]"""
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import faults
from preload import preloaded

DISTURBANCES = None
SOURCES = Path(__file__).resolve().parent.parent.parent / "src"


def disturbed(how):
    return preloaded(DISTURBANCES) | {"UPS_DISTURB": how}


class Time(faults.FaultTest):
    def test_the_clock_is_disturbed(self):
        look = "import time; first = time.time(); raise SystemExit(7 if time.time() < first else 0)"
        self.run_program([sys.executable, "-c", look], code=7, env=disturbed("clock"))

    def test_time_of_day_that_runs_backwards(self):
        scene, _ = self.write_scene()
        begin = time.monotonic()
        done = self.run_program([faults.program, "render", str(scene), "--time", "2", "--json", "--size", "10x8"],
                                env=disturbed("clock"))
        took, report = time.monotonic() - begin, json.loads(done.stdout)
        times = [point["time_s"] for point in report["convergence"]]
        self.assertTrue(0 < report["time_s"] <= took)
        self.assertEqual(times, sorted(times))
        self.assertGreater(min(times), 0)

    def test_no_source_asks_for_the_time_of_day(self):
        names = re.compile(r"system_clock|high_resolution_clock|gettimeofday|CLOCK_REALTIME|\btime\((NULL|nullptr|0)\)")
        for path in SOURCES.rglob("*.[ch]*"):
            if path.name == "page_words.cpp":  # the date on a report
                continue
            self.assertIsNone(names.search(path.read_text()), msg=path)


class Signals(faults.FaultTest):
    def test_interrupted_system_calls_change_nothing(self):
        scene, _ = self.write_scene()
        quiet, ticking = self.folder / "quiet", self.folder / "ticking"
        self.run_program(self.command(scene, quiet))
        done = self.run_program(self.command(scene, ticking), env=disturbed("ticks"))
        self.assertIn("ticked", done.stderr)
        self.assertEqual(self.results(ticking), self.results(quiet))

    def test_signals_that_end_the_program(self):
        """They ask for what was found so far, before there is anything they end it at once. Files are always whole; a
        signal that comes once there is something leaves all of them."""
        scene, _ = self.write_scene()
        out, other = self.folder / "out", self.folder / "other"
        self.run_program(self.command(scene, out))
        old = self.results(out)
        for name in ("SIGINT", "SIGTERM", "SIGHUP"):
            number = getattr(signal, name)

            def ends_with_files(wait_s):
                command = [faults.program, "render", str(scene), "--time", "60", "--out", str(other), "--size", "60x40"]
                # Whoever runs the tests may have been told to ignore it (nohup).
                process = self.start(command, preexec_fn=lambda: signal.signal(number, signal.SIG_DFL))
                time.sleep(wait_s)
                process.send_signal(number)
                _, errors = process.communicate(timeout=faults.HANG_S)
                self.assertIn(process.returncode, (128 + number, -number),
                              msg=f"{name}: {faults.died_of(process.returncode)}\n{errors}")
                return process.returncode == 128 + number

            for _ in range(faults.rounds(3, 30)):
                ends_with_files(self.random.uniform(0, 1))
            shutil.rmtree(other, ignore_errors=True)
            self.assertTrue(any(ends_with_files(wait_s) for wait_s in (2, 4, 8, 16)), msg=name)
            self.assertEqual(set(self.results(other)), set(old), msg=name)
            for exr in other.glob("*.exr"):
                self.run_program([faults.program, "compare", str(exr), str(exr)])
        self.assertEqual(self.results(out), old)

    def test_nobody_reads_the_output(self):
        scene, _ = self.write_scene()
        out = self.folder / "out"
        for ignored in (False, True):
            handler = signal.SIG_IGN if ignored else signal.SIG_DFL
            process = self.start(self.command(scene, out, "--json"), restore_signals=False,
                                 preexec_fn=lambda: signal.signal(signal.SIGPIPE, handler))
            process.stdout.close()
            errors = process.stderr.read()
            process.wait(timeout=faults.HANG_S)
            process.stderr.close()
            self.assertEqual(process.returncode, 1 if ignored else -signal.SIGPIPE, msg=errors)
            if ignored:
                self.assertIn("cannot write to standard output", errors)
            self.assertIn("view.exr", os.listdir(out))  # files come first
            self.run_program([faults.program, "compare", str(out / "view.exr"), str(out / "view.exr")])


if __name__ == "__main__":
    DISTURBANCES = os.path.abspath(sys.argv.pop(2))
    faults.main()
