"""The samples that weigh most, as `ups render` lists them, and `ups replay`. Usage:
test_replay.py PATH_TO_UPS [unittest options]"""
import json
import math
import os
import re
import shlex
import sys
import unittest
import xml.etree.ElementTree as xml

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import test_program  # noqa: E402


class Replay(test_program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.method = ("--method", "ups", "--light-paths", 4096)
        self.result = self.render(*self.method, "--iterations", 12)
        self.scene = self.path("room.gltf")

    def replay(self, address, *arguments):
        return self.run_program("replay", self.scene, "--sample", address, *self.method, *arguments).stdout

    def test_what_is_listed_comes_again(self):
        samples = self.result["largest_samples"]
        self.assertGreater(len(samples), 4)
        self.assertEqual([s["share"] for s in samples], sorted((s["share"] for s in samples), reverse=True))
        for sample in samples[:4]:
            path = json.loads(self.replay(sample["address"], "--json"))
            self.assertAlmostEqual(path["value"] / sample["value"], 1, delta=1e-5)
            self.assertEqual(path["vertices"][0]["event"], "start")
            self.assertGreater(len(path["contributions"]), 0)
            for c in path["contributions"]:
                self.assertGreater(c["weight"], 0)
                self.assertLessEqual(c["weight"], 1)
            self.assertRegex(path["text"], "[Cc]ontributions")
        text = self.replay(samples[0]["address"])
        self.assertIn("weight", text)
        self.assertIn("iteration", text)

    def test_other_options_are_another_render(self):
        sample = next(s for s in self.result["largest_samples"] if s["sensor"] == "view")
        column, row = (int(n) for n in sample["address"].split("/")[1].split(","))
        self.assertEqual(sample["index"], row * 24 + column)
        self.expect_failure("replay", self.scene, "--size", "8x8", "--sample", "view/20,3/0/eye/0/7",
                            words=["20,3", "no index of view"], code=2)

    def test_what_is_printed_traces_that_sample(self):
        """Of a render with options of its own, in a file with a blank."""
        scene = self.write("a room.gltf", test_program.room())
        options = ["--method=ppm", "--size", "16x16", "--light-paths", 16, "--iterations", 4]
        told = self.run_program("render", scene, *options).stdout
        listed = json.loads(self.run_program("render", scene, *options, "--json").stdout)["largest_samples"][0]
        command = re.search(r"look into it: ups (replay .*)", told).group(1)
        path = json.loads(self.run_program(*shlex.split(command), "--json").stdout)
        self.assertAlmostEqual(path["value"] / listed["value"], 1, delta=1e-5)

    def test_what_is_printed_has_every_option_that_changes_samples(self):
        values = {"--techniques": "emitter_hit,merge", "--max-path-length": 5, "--light-paths": 16,
                  "--merge-radius": 0.2, "--alpha": 0.7, "--glossy-alpha": 0.3, "--perturbation": "virtual",
                  "--technique-images": 2}
        described = self.run_program("replay", "--help").stdout.split("Method in detail:")[1]
        self.assertEqual(sorted(re.findall(r"^  (--[a-z-]+)", described, re.MULTILINE)), sorted(values))
        values.update({"--method": "ppm", "--size": "16x16", "--separate": "luminaires"})
        options = [word for option in values.items() for word in option]
        flags = ["--allow-outside", "--iterations", 4]
        told = self.run_program("render", self.scene, *options, *flags).stdout
        listed = json.loads(self.run_program("render", self.scene, *options, *flags, "--json").stdout)
        command = re.search(r"look into it: ups (replay .*)", told).group(1)
        for option, value in values.items():
            self.assertIn(f" {option} {value} ", command)
        self.assertIn(" --allow-outside ", command)
        for word in ("--iterations", "--json", "--threads"):
            self.assertNotIn(word, command)
        path = json.loads(self.run_program(*shlex.split(command), "--json").stdout)
        self.assertAlmostEqual(path["value"] / listed["largest_samples"][0]["value"], 1, delta=1e-5)

    def test_a_render_that_splits_by_technique_is_traced_again(self):
        """It keeps all techniques, where without that option the program might have chosen some of them."""
        options = ["--technique-images", "2"]
        for sample in self.render(*options, "--iterations", 4)["largest_samples"][:4]:
            path = json.loads(self.run_program("replay", self.scene, "--sample", sample["address"], *options,
                                               "--json").stdout)
            self.assertAlmostEqual(path["value"] / sample["value"], 1, delta=1e-5)

    def test_a_drawing_in_plan_and_section(self):
        address = self.result["largest_samples"][0]["address"]
        for name in ("path.svg", "path.png"):
            self.replay(address, "--plot", self.path(name))
            self.assertGreater(os.path.getsize(self.path(name)), 1000)
        root = xml.parse(self.path("path.svg")).getroot()
        words = root.find("{http://www.w3.org/2000/svg}desc").text
        for word in ("Plan", "Section", "eye path"):
            self.assertIn(word, words)

    def test_a_drawing_has_the_vertices_at_their_places(self):
        """The sample's own walk, edge by edge: in plan, then in a section along it, both by the scale that is drawn."""
        for sample in self.result["largest_samples"][:4]:
            path = json.loads(self.replay(sample["address"], "--json", "--plot", self.path("path.svg")))
            places = [v["position_m"] for v in path["vertices"] if v["walk"] == 0]
            self.assertGreater(len(places), 1)
            edges = [[b - a for a, b in zip(*pair)] for pair in zip(places, places[1:])]
            x, y = max(([b - a for a, b in zip(places[0], v["position_m"])][:2] for v in path["vertices"]),
                       key=lambda d: math.hypot(*d))
            along = [c / math.hypot(x, y) * (-1 if x < 0 else 1) for c in (x, y)]
            with open(self.path("path.svg"), encoding="utf-8") as f:
                svg = f.read()
            lines = {width: [[float(n) for n in line] for line in
                             re.findall(rf'stroke-width:{width};[^>]* d="M (\S+) (\S+) L (\S+) (\S+) "', svg)]
                     for width in ("2", "1.8")}
            metres = float(re.search(r"^([\d.]+) m$", svg, re.MULTILINE).group(1))
            scale = (lines["2"][-1][2] - lines["2"][-1][0]) / metres
            expected = [(e[0] * scale, -e[1] * scale) for e in edges]
            expected += [((e[0] * along[0] + e[1] * along[1]) * scale, -e[2] * scale) for e in edges]
            self.assertEqual(len(lines["1.8"]), len(expected))
            for line, edge in zip(lines["1.8"], expected):
                for found, wanted in zip((line[2] - line[0], line[3] - line[1]), edge):
                    self.assertAlmostEqual(found, wanted, delta=0.02)  # of 900 points

    def test_a_wrong_address_says_what_is_wrong(self):
        for address, words in (("moon/0/0/eye/0/1", ["moon", "there are", "spot"]), ("spot/x/0/eye/0/1", ["'x'"]),
                               ("spot/999/0/eye/0/1", ["'999'", "no index of spot"])):
            with self.subTest(address=address):
                self.expect_failure("replay", self.scene, "--sample", address, *self.method, words=words, code=2)
        self.expect_failure("replay", self.scene, "--sample", "spot/0/0/light/4096/1", *self.method,
                            words=["--sample: iteration 0", "no such path"], code=2)
        for address, words in (("spot", ["NAME/INDEX"]), ("spot/0/0/up/0/1", ["'up'", "eye"]),
                               ("spot/0/0/eye/0/-1", ["'-1'"])):
            with self.subTest(address=address):
                wrong = self.run_program("replay", self.scene, "--sample", address, *self.method, code=2).stderr
                for word in ["--sample", *words]:
                    self.assertIn(word, wrong)
        self.run_program("replay", self.scene, code=2)


if __name__ == "__main__":
    test_program.PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
