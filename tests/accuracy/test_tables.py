#!/usr/bin/env python3
"""samples/accuracy/run.sh --fast: are its tables whole, and do they say what the renders did?

  test_tables.py UPS FOLDER     the report stays in the folder, for test_page.py
"""
import csv
import math
import os
import shutil
import subprocess
import sys
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
METHODS = {"auto", "ups", "pt"}
SCENES = {"office", "atrium", "bathroom"}
KNOBS = {"light_paths", "alpha", "threads", "meters", "pixels", "path_length"}
WORDS = {"scene", "method", "kind", "status", "knob", "value", "limited_by", "criterion"}
STATUSES = {"reached", "sooner", "later", "unknown"}


def table(name):
    with open(os.path.join(FOLDER, name + ".csv"), newline="", encoding="utf-8") as file:
        return [{key: value if key in WORDS else float(value) for key, value in row.items()}
                for row in csv.DictReader(file)]


class Tables(unittest.TestCase):
    def test_every_number_is_finite(self):
        for name in ("errors", "convergence", "times", "predictions", "knobs", "references"):
            for row in table(name):
                for key, value in row.items():
                    self.assertTrue(key in WORDS or math.isfinite(value), f"{name}: {key} = {value}")

    def test_every_method_in_every_scene_with_rising_budgets(self):
        rows = table("errors")
        self.assertEqual({(r["scene"], r["method"]) for r in rows}, {(s, m) for s in SCENES for m in METHODS})
        for scene in SCENES:
            for method in METHODS:
                mine = [r for r in rows if (r["scene"], r["method"]) == (scene, method)]
                budgets = [r["budget_s"] for r in mine]
                self.assertGreaterEqual(len(budgets), 2)
                self.assertTrue(all(a < b for a, b in zip(budgets, budgets[1:])), budgets)
                self.assertEqual(len({r["seed"] for r in mine}), len(mine))
                for r in mine:
                    self.assertGreaterEqual(r["iterations"], 1)
                    self.assertGreater(min(r["time_s"], r["cpu_s"], r["seconds"], r["true_p95"]), 0)
                    self.assertGreaterEqual(r["true_p95"], r["true_median"])

    def test_errors_are_those_of_the_light(self):
        # No test of accuracy, for which these renders are too short and their noise unknown (tests/analytic and
        # tests/agreement are): rows are of this scene and in its units. The office has no light that a method cannot
        # find: 5 % is far beyond the noise of any mean of 768 meters.
        for r in table("errors"):
            if r["scene"] == "office":
                self.assertLess(abs(r["mean_off"]), 0.05, r["method"])
        missing = {(r["scene"], r["method"]) for r in table("errors") if r["light_missing"]}
        self.assertIn(("atrium", "pt"), missing)  # points of light, seen in glass
        self.assertFalse({m for _, m in missing} & {"auto", "ups"})

    def test_curves_run_forward(self):
        rows = table("convergence")
        for scene in SCENES:
            for method in METHODS:
                mine = [r for r in rows if (r["scene"], r["method"]) == (scene, method)]
                for key in ("seconds", "time_s", "iterations"):
                    self.assertTrue(all(a[key] < b[key] for a, b in zip(mine, mine[1:])), (scene, method, key))

    def test_times_for_both_errors_and_all_levels(self):
        rows = table("times")
        self.assertEqual({(r["scene"], r["method"], r["kind"], r["error"]) for r in rows},
                         {(s, m, kind, error) for s in SCENES for m in METHODS for kind in ("stated", "true")
                          for error in (0.05, 0.02, 0.01)})
        for r in rows:
            self.assertIn(r["status"], STATUSES)
            self.assertEqual(r["status"] == "unknown", r["seconds"] < 0)
            self.assertFalse(r["kind"] == "true" and r["status"] == "unknown")

    def test_every_knob_has_its_values(self):
        rows = table("knobs")
        self.assertEqual({r["knob"] for r in rows}, KNOBS)
        for knob in KNOBS:
            mine = [r for r in rows if r["knob"] == knob]
            self.assertEqual(len({r["value"] for r in mine}), len(mine))
            for r in mine:
                self.assertGreater(min(r["cpu_ms_per_iteration"], r["clock_ms_per_iteration"], r["seconds"]), 0)
                self.assertEqual(r["true_p95"] < 0, knob == "meters")

    def test_paths_cut_short_lack_light(self):
        error, _ = (r["true_p95"] for r in table("knobs") if r["knob"] == "path_length")
        self.assertGreater(error, 0.05)  # two edges: one reflection at most

    def test_page_and_pictures_are_there(self):
        for name in ("report.html", "accuracy.png", *(f"true_{s}.png" for s in SCENES),
                     *(f"knob_{k}.png" for k in KNOBS)):
            self.assertGreater(os.path.getsize(os.path.join(FOLDER, name)), 5000, name)


class Usage(unittest.TestCase):
    def refused(self, *words):
        done = subprocess.run(["bash", RUN, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 2, done.stderr)
        return done.stderr

    def test_wrong_words(self):
        self.assertIn("--seconds 0", self.refused("--ups", UPS, "--seconds", "0"))
        self.assertIn("no such program", self.refused("--ups", os.path.join(FOLDER, "nothing")))


if __name__ == "__main__":
    UPS, FOLDER = (os.path.abspath(path) for path in sys.argv[1:3])
    RUN = os.path.join(ROOT, "samples", "accuracy", "run.sh")
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        print("skipped: no python3 imports numpy and matplotlib (Debian: python3-matplotlib)")
        sys.exit(77)
    shutil.rmtree(FOLDER, ignore_errors=True)
    shorter = ["--seconds", "0.1", "--light-paths", "256"] if os.environ.get("UPS_TEST_EFFORT") == "low" else []
    subprocess.run(["bash", RUN, "--fast", *shorter, "--ups", UPS, "--out", FOLDER], check=True)
    unittest.main(argv=sys.argv[:1])
