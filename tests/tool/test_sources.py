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

    def test_far_away_both_tables_tell_the_same_places(self):
        scene = two_lights()
        for node in scene["nodes"]:
            x, y, z = node.get("translation", [0, 0, 0])
            node["translation"] = [x + 4500000.123, y, z + 0.0625]
        self.assertEqual(self.render(scene, "--separate", "luminaires").returncode, 0)
        total, parts = self.table("work_plane.csv"), self.table("work_plane_luminaires.csv")
        for whole, part in zip(total, parts):
            self.assertEqual([part[k] for k in ("x_m", "y_m", "z_m")], [whole[k] for k in ("x_m", "y_m", "z_m")])
        self.assertAlmostEqual(total[0]["x_m"] % 1, 0.623, delta=1e-5)

    def test_columns_bear_the_nodes_names(self):
        scene = two_lights()
        scene["nodes"][1]["name"] = "desk lamp"
        scene["nodes"][5]["name"] = "desk lamp"
        scene["meshes"].append({"primitives": [dict(scene["meshes"][0]["primitives"][0], material=1)]})
        scene["materials"].append({"emissiveFactor": [1, 1, 1]})
        scene["nodes"].append({"name": "sky/panel", "mesh": 1, "translation": [0, 3, 0]})
        emitter = {"emitter": {"shape": "disc", "radius_m": 0.01, "flux_lm": 100}}
        scene["nodes"].append({"name": "spot", "translation": [0, 1, 0],
                               "extras": {"ups": {"fixture": {"parts": [emitter]}}}})
        scene["scenes"][0]["nodes"] += [7, 8]
        run = self.render(scene, "--separate", "luminaires")
        self.assertEqual(run.returncode, 0, run.stderr)
        names = {"desk_lamp", "desk_lamp_2", "sky_panel", "spot"}
        sources = json.loads(run.stdout)["sources"]
        self.assertEqual(set(sources), names)
        self.assertAlmostEqual(sources["desk_lamp"]["flux_lm"], 400 * math.pi, delta=0.01)
        self.assertAlmostEqual(sources["desk_lamp_2"]["flux_lm"], 200 * math.pi, delta=0.01)
        self.assertAlmostEqual(sources["sky_panel"]["flux_lm"], 16 * math.pi, delta=0.01)  # 1 cd/m^2 over 16 m^2
        self.assertAlmostEqual(sources["spot"]["flux_lm"], 100, delta=0.01)
        (first, *_), total = self.table("work_plane_luminaires.csv"), self.table("work_plane.csv")[0]
        self.assertEqual(set(first) - {"x_m", "y_m", "z_m"},
                         {name + column for name in names for column in ("_lx", "_standard_error_lx")})
        self.assertAlmostEqual(sum(first[name + "_lx"] for name in names), total["illuminance_lx"],
                               delta=1e-4 * total["illuminance_lx"])

    def test_a_warning_of_a_file_is_told_once(self):
        with open(os.path.join(self.folder.name, "odd.ies"), "w", encoding="utf-8") as file:
            file.write(test_program.IES.replace("TILT=NONE", "TILT=gone.tlt"))
        scene = two_lights()
        lamp = {"luminaire": {"file": "odd.ies"}}
        scene["nodes"][1] = {"translation": [1, 2, -0.5], "rotation": test_program.UP, "extras": {"ups": lamp}}
        scene["nodes"][5] = {"name": "Lamp", "translation": [0, 2, -0.5], "rotation": test_program.UP,
                             "extras": {"ups": lamp}}
        run = self.render(scene)
        self.assertEqual(run.returncode, 0, run.stderr)
        warnings = json.loads(run.stdout)["warnings"]
        told = [w for w in warnings if "odd.ies" in w]
        self.assertNotEqual(told, [])
        self.assertEqual(len(set(told)), len(told))
        for warning in told:
            what = warning.split(": ", 1)[1]
            self.assertEqual([w for w in warnings if what in w], [warning])

    def test_a_part_is_counted_once(self):
        scene = two_lights()
        parts = [{"emitter": {"shape": "disc", "radius_m": 0.01, "flux_lm": 100}},
                 {"reflector": {"profile": "cone", "aperture_radius_m": -1}}]
        scene["nodes"][5] = {"extras": {"ups": {"fixture": {"parts": parts}}}}
        run = self.render(scene)
        self.assertEqual(run.returncode, 1)
        self.assertIn("parts[1].reflector: aperture_radius_m is -1", run.stderr)
        self.assertNotIn("part 2", run.stderr)

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

    def test_observers(self):
        scene = two_lights()
        # Eyes beside each other, 1 m up: "desk 1" looks north to the lights, the other one away from them.
        for name, turn in (("desk 1", [0, 0, 0, 1]), ("away", [0, 1, 0, 0])):
            scene["nodes"].append({"translation": [0, 1, 3], "rotation": turn,
                                   "extras": {"ups": {"observer": {"name": name, "metric": "ugr"}}}})
            scene["scenes"][0]["nodes"].append(len(scene["nodes"]) - 1)
        run = self.render(scene)
        report = json.loads(run.stdout)
        self.assertEqual(set(report["observers"]), {"desk 1", "away"})
        seen, away = report["observers"]["desk 1"], report["observers"]["away"]
        self.assertTrue(seen["rated"])
        self.assertGreater(seen["ugr"], 0)
        self.assertGreater(seen["background_cd_m2"], 0)
        self.assertGreaterEqual(seen["ugr_standard_error"], 0)
        self.assertLessEqual(seen["ugr_low"], seen["ugr"])
        self.assertAlmostEqual(sum(s["share"] for s in seen["sources"]), 1, delta=1e-5)
        self.assertTrue(all(s["small"] and s["luminance_cd_m2"] == -1 for s in seen["sources"]))  # point lights
        self.assertEqual((away["rated"], away["ugr"], away["sources"]), (False, -1, []))
        self.assertTrue(any(w.startswith("observer desk 1: ") and "no luminance" in w for w in report["warnings"]))
        self.assertNotIn("desk 1", report["meters"])

    def test_wrong_observers(self):
        for words, message in (({"metric": "dgp"}, "must be ugr"), ({"position_index": "x"}, "table or guth"),
                               ({"height": 1}, "height")):
            scene = two_lights()
            scene["nodes"][6]["extras"] = {"ups": {"observer": words}}
            run = self.render(scene)
            self.assertEqual(run.returncode, 1, words)
            self.assertIn(message, run.stderr)

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
