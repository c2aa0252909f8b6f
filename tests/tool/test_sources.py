"""`ups render --separate` and goniometers in a scene: tables, JSON and messages. Usage: test_sources.py PATH_TO_UPS"""
import csv
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

import test_program

PROGRAM = None


def two_lights():
    """The room of test_program with a second light of 50 cd in group 4, and a goniometer."""
    scene = test_program.room()
    scene["nodes"][1]["extras"] = {"ups": {"group": 9}}
    scene["nodes"].append({"translation": [-1, 2, 0.5], "extensions": {"KHR_lights_punctual": {"light": 1}},
                           "extras": {"ups": {"group": 4}}})
    scene["extensions"]["KHR_lights_punctual"]["lights"].append({"type": "point", "intensity": 50})
    scene["nodes"].append({"name": "far field", "rotation": test_program.UP,
                           "extras": {"ups": {"goniometer": {"symmetry": "axial", "gamma_step_deg": 10}}}})
    scene["scenes"][0]["nodes"] += [5, 6]
    return scene


class SourcesTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="ups-sources-")
        self.addCleanup(self.folder.cleanup)

    def render(self, scene, *options):
        path = os.path.join(self.folder.name, "scene.gltf")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(scene, file)
        return subprocess.run([PROGRAM, "render", path, "--iterations", "16", "--out", self.folder.name, "--json",
                               *options], capture_output=True, text=True)

    def table(self, name):
        with open(os.path.join(self.folder.name, name), newline="", encoding="utf-8") as file:
            return [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]

    def test_luminaires_add_up(self):
        run = self.render(two_lights(), "--separate", "luminaires")
        self.assertEqual(run.returncode, 0, run.stderr)
        report = json.loads(run.stdout)
        self.assertAlmostEqual(report["sources"]["luminaire_1"]["flux_lm"], 400 * math.pi, delta=0.01)
        self.assertAlmostEqual(report["sources"]["luminaire_2"]["flux_lm"], 200 * math.pi, delta=0.01)
        total, parts = self.table("work_plane.csv"), self.table("work_plane_luminaires.csv")
        self.assertEqual(list(parts[0])[3:], ["luminaire_1_lx", "luminaire_1_standard_error_lx", "luminaire_2_lx",
                                             "luminaire_2_standard_error_lx"])
        self.assertEqual(len(total), len(parts))
        for whole, part in zip(total, parts):
            self.assertAlmostEqual(part["luminaire_1_lx"] + part["luminaire_2_lx"], whole["illuminance_lx"],
                                   delta=1e-5 * whole["illuminance_lx"])
            self.assertGreater(part["luminaire_2_lx"], 0)

    def test_groups_have_their_numbers(self):
        run = self.render(two_lights(), "--separate", "groups")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(list(json.loads(run.stdout)["sources"]), ["group_4", "group_9"])
        self.assertIn("group_9_lx", self.table("spot_groups.csv")[0])

    def test_without_separate_there_is_no_table(self):
        run = self.render(two_lights())
        self.assertNotIn("sources", json.loads(run.stdout))
        self.assertFalse([name for name in os.listdir(self.folder.name) if "luminaires" in name or "groups" in name])

    def test_goniometer(self):
        run = self.render(two_lights(), "--method", "lt")
        self.assertEqual(run.returncode, 0, run.stderr)
        report = json.loads(run.stdout)["goniometers"]["far_field"]
        nodes = self.table("far_field.csv")
        self.assertEqual([n["gamma_deg"] for n in nodes], [10.0 * i for i in range(19)])
        zenith = nodes[-1]  # both lights straight, half of what the floor takes comes back as well
        self.assertGreater(zenith["intensity_cd"], 150)
        self.assertEqual(nodes[1]["intensity_cd"] < 150, True)  # the floor is in the way
        self.assertAlmostEqual(report["flux_lm"] / (600 * math.pi), report["light_output_ratio"], delta=1e-4)

    def test_wrong_words(self):
        for words, expected in (({"symmetry": "round"}, "symmetry"), ({"gamma_step_deg": 7}, "gamma_step_deg"),
                                ({"symmetry": "axial", "c_step_deg": 15}, "axial has one plane"),
                                ({"gamma_deg": [0, 10, 5]}, "gamma_deg[2]"), ({"planes": 3}, "planes"),
                                ({"symmetry": "quadrants", "c_deg": [0, 10]}, "symmetric")):
            scene = two_lights()
            scene["nodes"][6]["extras"]["ups"]["goniometer"] = words
            run = self.render(scene)
            self.assertEqual(run.returncode, 1, words)
            self.assertIn(expected, run.stderr)
            self.assertIn("node 6", run.stderr)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
