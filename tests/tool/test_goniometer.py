"""`ups goniometer`: what it measures, writes and refuses, and whether its file lights a room as the fixture does.
Usage: test_goniometer.py PATH_TO_UPS [unittest options]"""
import csv
import json
import math
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import test_program

RADIUS, END = 0.015, 0.02  # of the fixture's aperture; how far below its lamp that lies
FLUX = 1000.0
HEIGHT, FLOOR = 5.0, 8.0  # of the fixture above the floor; side of the floor, m


def fixture(**more):
    """A lamp of 1 cm in a white cone: its light has no sharp edge."""
    return {"ups": {"fixture": {"parts": [
        {"emitter": {"radius_m": 0.005, "flux_lm": FLUX}},
        {"reflector": {"profile": "cone", "inner_radius_m": 0.005, "aperture_radius_m": RADIUS, "depth_m": END,
                       "finish": "matte_white"}}]}, **more}}


def scene_of(*nodes, meshes=False):
    scene = test_program.room()
    for key in ("cameras", "extensions", "extensionsUsed") + (() if meshes else ("meshes", "materials")):
        del scene[key]
    if not meshes:
        for key in ("buffers", "bufferViews", "accessors"):
            del scene[key]
    scene["nodes"] = list(nodes)
    scene["scenes"] = [{"nodes": list(range(len(nodes)))}]
    return scene


def alone(*more):
    return scene_of({"name": "cone light", "rotation": test_program.UP, "extras": fixture()}, *more)


def goniometer(name, **words):
    return {"name": name, "extras": {"ups": {"goniometer": words}}}


def room(light, height):
    """A floor and a wall, both matte, 5 x 5 cells on the floor. The mesh is the floor of 4 m x 4 m in glTF's x, z."""
    half, large = 0.70710678, {"mesh": 0, "scale": [2, 1, 2]}
    return scene_of(
        large, {**large, "rotation": [0, 0, half, half], "translation": [FLOOR / 2, FLOOR / 2, 0]},
        {"name": "light", "rotation": test_program.UP, "translation": [0, height, 0], "extras": light},
        {"name": "floor", "rotation": test_program.UP,
         "extras": {"ups": {"meters": {"width_m": FLOOR, "height_m": FLOOR, "columns": 5, "rows": 5, "area": True}}}},
        meshes=True)


def read_table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]


class GoniometerTest(test_program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.scene = self.write("cone_light.gltf", alone())

    def measure(self, *options, scene=None, code=0):
        done = self.run_program("goniometer", scene or self.scene, "--json", *options, code=code)
        return json.loads(done.stdout)

    def info(self, name):
        done = self.run_program("info", self.path(name), "--json")
        return json.loads(done.stdout)["files"][0]


class Measures(GoniometerTest):
    def test_balance_peak_and_files(self):
        options = ("--symmetry", "axial", "--iterations", 16, "--opening", f"disc:{2 * RADIUS}",
                   "--keyword", "MANUFAC=Example", "--keyword", "lumcat=A1")
        report = self.measure(*options, "--out", self.path("a.ies"), "--errors", self.path("a.csv"),
                              "--plot", self.path("a.svg"), "--plot", self.path("a.png"))
        flux = report["flux"]
        self.assertEqual(report["method"], "lt")
        self.assertEqual(report["grid"], {"c_count": 1, "gamma_count": 73, "symmetry": "axial"})
        self.assertAlmostEqual(flux["emitted_lm"], FLUX, delta=1e-3)
        # Roulette ends paths: the balance holds but for noise. Five standard errors: 1 of 6000 seeds fails (t of 15
        # degrees of freedom); 0.7 % of the flux is found in 97 cases of 100 and more.
        self.assertLess(abs(flux["residual_lm"]), 5 * flux["out_standard_error_lm"] + 1e-6 * FLUX)
        self.assertLess(flux["out_standard_error_lm"], 1e-3 * FLUX)
        self.assertTrue(0.7 < report["light_output_ratio"] < 0.95, report["light_output_ratio"])
        self.assertAlmostEqual(report["light_output_ratio"], flux["out_lm"] / flux["emitted_lm"], delta=1e-9)
        table = read_table(self.path("a.csv"))
        self.assertEqual([row["gamma_deg"] for row in table], [2.5 * i for i in range(73)])
        peak = max(table, key=lambda row: row["intensity_cd"])
        self.assertAlmostEqual(report["peak"]["intensity_cd"], peak["intensity_cd"], delta=1e-3)
        self.assertEqual(report["peak"]["gamma_deg"], peak["gamma_deg"])
        scale = [max(row["intensity_cd"], 0.05 * peak["intensity_cd"]) for row in table]
        worst = max(range(73), key=lambda i: table[i]["error_bound_cd"] / scale[i])
        self.assertEqual(report["errors"]["worst_gamma_deg"], table[worst]["gamma_deg"])
        for beam in (report["beam"]["c0_c180"], report["field"]["c90_c270"]):
            self.assertLessEqual(beam["low_deg"], beam["angle_deg"])
            self.assertGreaterEqual(beam["high_deg"], beam["angle_deg"])
        self.assertAlmostEqual(report["errors"]["worst_relative_error_bound"],
                               table[worst]["error_bound_cd"] / scale[worst], delta=1e-6)
        # A cone open below, but for the slits between the chords of the lamp's edge and the cone's round rim: two thirds
        # of the chords' 1e-4 of the radius wide in the mean, so 4/3 1e-4 of the lamp's area. No more passes than the
        # lamp gives off on as much area, and that spread by the cosine.
        slits = 4 / 3 * 1e-4 * FLUX / math.pi
        self.assertLess(max(row["intensity_cd"] for row in table if row["gamma_deg"] > 120), slits)
        with open(self.path("a.svg"), encoding="utf-8") as file:
            self.assertIn("cone_light", file.read())
        with open(self.path("a.png"), "rb") as file:
            self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")
        self.check_file("a.ies", report)
        self.measure(*options, "--out", self.path("a.ldt"))
        self.check_file("a.ldt", report)

    def check_file(self, name, report):
        """The file, read back: the flux within the digits of its numbers, seven for .ies, six characters for .ldt."""
        read = self.info(name)
        digits = 5.1e-5 if name.endswith(".ldt") else 1e-5
        self.assertEqual(read["warnings"], [], name)
        self.assertAlmostEqual(read["interpolated_flux_lm"], report["flux"]["out_lm"], delta=digits * FLUX)
        self.assertAlmostEqual(read["flux_lm"], report["flux"]["band_rule_lm"], delta=digits * FLUX)
        self.assertAlmostEqual(read["rated_flux_lm"], FLUX, delta=1e-3)
        self.assertAlmostEqual(read["light_output_ratio"], report["flux"]["band_rule_lm"] / FLUX, delta=1.1 * digits)
        self.assertAlmostEqual(read["light_output_ratio"], report["light_output_ratio"], delta=0.002)  # interpolated
        self.assertEqual(read["symmetry"], "axial")
        self.assertEqual(read["opening"]["shape"], "disc")
        self.assertAlmostEqual(read["opening"]["size_m"][0], 2 * RADIUS, delta=1e-6)
        self.assertAlmostEqual(read["peak_cd"], report["peak"]["intensity_cd"],
                               delta=digits * read["peak_cd"] if name.endswith(".ldt") else 1e-4)
        words = {k["name"]: k["value"] for k in read["keywords"]}
        self.assertEqual((words["MANUFAC"], words["LUMCAT"], words["LUMINAIRE"]), ("Example", "A1", "cone_light"))
        self.assertRegex(words["TEST"], r"^UPS \d+\.\d+\.\d+, worst error \S+ %, lt, 16 iterations, seed 1$")

    def test_the_file_tells_of_light_beyond_its_table(self):
        """The ratio counts all light that leaves; what the angles do not hold is in no intensity."""
        scene = self.write("narrow.gltf", alone(goniometer("narrow", gamma_deg=[0, 10, 20, 30], c_step_deg=90)))
        self.run_program("goniometer", scene, "--iterations", 16, "--out", self.path("narrow.ies"))
        told = next(k["value"] for k in self.info("narrow.ies")["keywords"] if k["name"] == "OTHER")
        ratio, beyond = (float(n) / 100 for n in re.search(r"ratio (\S+) %, of which (\S+) % beyond", told).groups())
        self.assertGreater(beyond, 0.1)
        self.assertAlmostEqual(self.info("narrow.ies")["interpolated_flux_lm"] / FLUX, ratio - beyond, delta=0.03)

    def test_text_and_same_seed_same_file(self):
        for name in ("a.ies", "b.ies"):
            text = self.run_program("goniometer", self.scene, "--iterations", 4, "--c-step", 45, "--gamma-step", 5,
                                    "--seed", 3, "--symmetry", "quadrants", "--out", self.path(name)).stdout
        for words in ("8 C-planes x 37 gamma angles, symmetry quadrants", "emitted by the sources",
                      "light output ratio: ", "beam angle", "field angle", "error of a node"):
            self.assertIn(words, text)
        with open(self.path("a.ies"), "rb") as a, open(self.path("b.ies"), "rb") as b:
            self.assertEqual(a.read(), b.read())
        self.assertEqual(self.info("a.ies")["symmetry"], "quadrants")

    def test_text_says_how_far_it_is_known(self):
        """95 % by Student's t of the batches, of which there are 16 at the most; of three iterations nothing is known."""
        options = ["--c-step", 45, "--gamma-step", 5, "--seed", 3]
        for iterations, t in ((4, 3.182), (8, 2.365), (32, 2.131)):
            text = self.run_program("goniometer", self.scene, "--iterations", iterations, *options).stdout
            report = self.measure("--iterations", iterations, *options)
            for what, bound in (("out of the scene .*", t * report["flux"]["out_standard_error_lm"]),
                                ("light output ratio: .*", 100 * t * report["light_output_ratio_standard_error"])):
                told = re.search(what + r" \+- (\S+)( %)? \(95 %\)", text)
                self.assertIsNotNone(told, text)
                self.assertAlmostEqual(float(told[1]), bound, delta=0.051 * bound)
        text = self.run_program("goniometer", self.scene, "--iterations", 3, *options).stdout
        for what in (r"out of the scene +[\d.]+ \+- unknown", r"light output ratio: [\d.]+ % \+- unknown",
                     r"peak: [\d.]+ cd \+- unknown,", "median unknown, worst unknown"):
            self.assertRegex(text, what)
        self.assertNotRegex(text, r"(\+-|within) -")

    def test_it_ends_at_its_target(self):
        report = self.measure("--symmetry", "axial", "--gamma-step", 5, "--target-error", 0.02)  # no limit of time
        self.assertGreaterEqual(report["iterations"], 32)

    def test_methods_agree(self):
        """Flux out by each within six combined standard errors: four comparisons, about one alarm in 1000 seeds (t of 7
        to 14 degrees of freedom). An error of 1 % is found in 97 cases of 100 and more."""
        runs = [self.measure("--symmetry", "axial", "--gamma-step", 10, "--iterations", 8, "--method", method)
                for method in ("lt", "ups", "bpt", "sppm", "bpm")]
        for run in runs[1:]:
            a, b = runs[0]["flux"], run["flux"]
            error = math.hypot(a["out_standard_error_lm"], b["out_standard_error_lm"])
            self.assertTrue(0 < error < 0.0012 * a["out_lm"], (run["method"], error))
            self.assertLess(abs(a["out_lm"] - b["out_lm"]), 6 * error + 1e-6 * FLUX, run["method"])

    def test_maintenance_is_no_matter_of_the_luminaire(self):
        scene = alone()
        own = self.measure("--iterations", 8, "--seed", 3)
        scene["scenes"][0]["extras"] = {"ups": {"maintenance_factor": 0.5}}
        done = self.run_program("goniometer", self.write("old.gltf", scene), "--json", "--iterations", 8, "--seed", 3)
        self.assertEqual(json.loads(done.stdout)["flux"], own["flux"])
        self.assertIn("maintenance factor of 0.5 is left out", done.stderr)

    def test_a_name_with_control_characters(self):
        """It stands in a line of the distribution, which has none, and is UTF-8."""
        for stem in ("my\tlamp", "my\udcfflamp"):  # the second: the byte 0xff
            self.write(stem + ".gltf", alone())
            self.run_program("goniometer", self.path(stem + ".gltf"), "--iterations", 4, "--out", self.path("a.ies"))
            words = {k["name"]: k["value"] for k in self.info("a.ies")["keywords"]}
            self.assertEqual(words["LUMINAIRE"], "my_lamp")
            os.remove(self.path("a.ies"))

    def test_the_scenes_own_goniometer(self):
        """One upright, one whose nadir is the world's zenith: what is down lies at gamma 180."""
        over = {"rotation": [0.70710678, 0, 0, 0.70710678], **goniometer("over", gamma_step_deg=10)}
        upright = {"rotation": test_program.UP, **goniometer("upright", gamma_step_deg=5)}
        scene = self.write("two.gltf", alone(over, upright))
        for name, count, lit in (("over", 19, -1), ("upright", 37, 0)):
            report = self.measure("--name", name, "--iterations", 4, "--errors", self.path("t.csv"), scene=scene)
            self.assertEqual(report["goniometer"], name)
            self.assertEqual(report["grid"]["gamma_count"], count)
            first_plane = [row["intensity_cd"] for row in read_table(self.path("t.csv"))[:count]]
            self.assertGreater(first_plane[lit], 100)
            self.assertLess(first_plane[-1 - lit], 1)

    def test_other_sensors_are_left_out(self):
        scene = alone()
        more = room({}, 1)["nodes"][3]
        scene["nodes"].append(more)
        scene["scenes"][0]["nodes"].append(1)
        report = self.measure("--iterations", 4, scene=self.write("meters.gltf", scene))
        self.assertEqual(report["method"], "lt")

    def test_an_interrupted_run_writes_what_there_is(self):
        for patience in (1, 5, 20):  # until an iteration is done
            run = subprocess.Popen([test_program.PROGRAM, "goniometer", self.scene, "--time", "60", "--out",
                                    self.path("cut.ies")], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
            time.sleep(patience)
            run.send_signal(signal.SIGINT)
            out, err = run.communicate(timeout=60)
            self.assertEqual(run.returncode, 130, err)
            if out:
                break
            self.assertFalse(os.path.exists(self.path("cut.ies")))
        self.assertIn("interrupted", err)
        self.assertIn("flux balance", out)
        self.assertAlmostEqual(self.info("cut.ies")["rated_flux_lm"], FLUX, delta=1e-3)
        self.assertEqual([name for name in os.listdir(self.folder.name) if name.endswith(".tmp")], [])


class InARoom(GoniometerTest):
    def readings(self, name, light, height):
        """Of the cells, and what the program says of all of them."""
        scene = self.write(name + ".gltf", room(light, height))
        done = self.run_program("render", scene, "--light-paths", 32768, "--iterations", 24, "--seed", 11,
                                "--out", self.path(name), "--json")
        return read_table(os.path.join(self.path(name), "floor.csv")), json.loads(done.stdout)["meters"]["floor"]

    def test_the_file_lights_a_room_as_the_fixture_does(self):
        """Cells of 1.6 m, 5 m below an aperture of 3 cm, 166 times as far; the file's centre lies halfway between lamp
        and aperture. 25 comparisons of two renders of 16 batches each, within 4 combined standard errors and the file's
        own errors: the noise alone fails for less than 3 seeds in 100 (t of 15 to 30 degrees of freedom), the file's
        errors, of its worst node towards the cell, make that fewer. Of the mean over the cells, within 0.5 % or four
        errors of at most 0.17 %, 1 % is found in 95 cases of 100."""
        report = self.measure("--symmetry", "axial", "--iterations", 32, "--seed", 5, "--opening", f"disc:{2 * RADIUS}",
                              "--out", self.path("cone.ies"), "--errors", self.path("cone.csv"))
        own, all_own = self.readings("fixture", fixture(), HEIGHT)
        file, all_file = self.readings("file", {"ups": {"luminaire": {"file": "cone.ies"}}}, HEIGHT - END / 2)
        nodes = read_table(self.path("cone.csv"))
        flux_error = report["flux"]["out_standard_error_lm"] / report["flux"]["out_lm"]
        self.assertEqual(len(own), 25)
        shares = []
        for a, b in zip(own, file):
            noise = 4 * math.hypot(a["standard_error_lx"], b["standard_error_lx"])
            of_file = self.direct_error(nodes, a["x_m"], a["y_m"]) + 4 * flux_error * a["indirect_lx"]
            shares.append((noise + of_file) / a["illuminance_lx"])
            self.assertLess(abs(a["illuminance_lx"] - b["illuminance_lx"]), noise + of_file, (a, b, noise, of_file))
        self.assertLess(max(shares), 0.1, "the comparison says something")
        self.assertLess(sum(shares) / 25, 0.05)
        noise = math.hypot(flux_error, *(m["mean_standard_error_lx"] / m["mean_lx"] for m in (all_own, all_file)))
        self.assertLess(noise, 0.0017)
        self.assertLess(abs(all_own["mean_lx"] / all_file["mean_lx"] - 1), max(0.005, 4 * noise), noise)

    @staticmethod
    def direct_error(nodes, x, y):
        """Of the illuminance by the file: the largest error of the intensities towards the cell (4 standard errors and
        blur), by the cosine law at the cell's centre."""
        half, step = FLOOR / 10, 2.5
        distance = [math.hypot(x + i * half, y + j * half) for i in (-1, 0, 1) for j in (-1, 0, 1)]
        angles = [math.degrees(math.atan2(d, HEIGHT)) for d in distance]
        seen = [n for n in nodes if min(angles) - step < n["gamma_deg"] < max(angles) + step]
        error = max(4 * n["standard_error_cd"] + abs(n["bias_cd"]) for n in seen)
        gamma = math.atan2(math.hypot(x, y), HEIGHT)
        return error * math.cos(gamma) ** 3 / HEIGHT ** 2


class Refuses(GoniometerTest):
    def test_options_name_what_would_be_right(self):
        for options, words in (
                (["--out", "lamp.txt"], [".ies or .ldt", "lamp.txt"]), (["--errors", "e.txt"], [".csv"]),
                (["--plot", "p.gif"], [".svg, .png or .pdf"]), (["--c-step", "7"], ["--c-step", "divide 360", "'7'"]),
                (["--c-step", "-15"], ["0.1 to 360"]), (["--c-step", "nan"], ["--c-step"]),
                (["--gamma-step", "7"], ["--gamma-step", "divide 180"]), (["--gamma-step", "0"], ["0.1 to 180"]),
                (["--c-step", "360"], ["--symmetry axial"]), (["--symmetry", "round"], ["quadrants"]),
                (["--symmetry", "axial", "--c-step", "15"], ["--c-step", "one plane"]),
                (["--symmetry", "quadrants", "--c-step", "60"], ["divide 90"]),
                (["--symmetry", "c90-c270", "--c-step", "40"], ["divide 90"]),
                (["--symmetry", "c0-c180", "--c-step", "24"], ["divide 180"]),
                (["--c-step", "0.1", "--gamma-step", "0.1"], ["4000000", "larger step"]),
                (["--opening", "disc"], ["disc:DIAMETER"]), (["--opening", "disc:-1"], ["disc:DIAMETER"]),
                (["--opening", "rectangle:1"], ["rectangle:XxY"]), (["--opening", "rectangle:1x"], ["rectangle:XxY"]),
                (["--keyword", "x"], ["NAME=VALUE"]), (["--keyword", "A]=x"], ["NAME=VALUE"]),
                (["--keyword", "A=x\ny"], ["one line"]), (["--keyword", "A=x\udcff"], ["--keyword", "UTF-8", "x\\xff"]),
                (["--method", "pt"], ["--method", "lt"])):
            with self.subTest(options=options):
                done = self.run_program("goniometer", self.scene, *options, code=2)
                self.assertEqual(done.stdout, "")
                for word in words:
                    self.assertIn(word, done.stderr)

    def test_places_for_files_are_looked_at_first(self):
        os.mkdir(self.path("a.ies"))
        for option, path, words in (("--out", "none/lamp.ies", ["--out", "no folder"]),
                                    ("--out", "a.ies", ["is a folder"]),
                                    ("--errors", "none/e.csv", ["--errors", "no folder"]),
                                    ("--plot", "none/p.svg", ["--plot", "no folder"])):
            with self.subTest(path=path):
                self.expect_failure("goniometer", self.scene, option, self.path(path), "--time", 1000, words=words)

    def test_files_that_the_scene_reads_stay(self):
        lamp = {"rotation": test_program.UP, "extras": {"ups": {"luminaire": {"file": "lamp.ies"}}}}
        scene, file = self.write("lamp.gltf", scene_of(lamp)), self.write("lamp.ies", test_program.IES)
        self.expect_failure("goniometer", scene, "--time", 1000, "--out", file, words=["--out", "lamp.ies", "reads"])
        with open(file, encoding="utf-8") as text:
            self.assertEqual(text.read(), test_program.IES)
        self.run_program("goniometer", scene, "--iterations", 4, "--out", self.path("again.ies"))

    def test_scenes(self):
        dark = self.write("dark.gltf", scene_of({"name": "nothing"}))
        self.expect_failure("goniometer", dark, words=["dark.gltf", "nothing in it emits light", "fixture"])
        one = self.write("one.gltf", alone(goniometer("far field", gamma_step_deg=5)))
        for option, value in (("--c-step", 30), ("--gamma-step", 5), ("--symmetry", "axial")):
            self.expect_failure("goniometer", one, option, value, words=[option, "far_field", "in the file"], code=2)
        self.run_program("goniometer", one, "--iterations", 4, "--opening", "rectangle:0.3x0.1", "--out",
                         self.path("one.ies"))
        opening = self.info("one.ies")["opening"]
        self.assertEqual((opening["shape"], opening["size_m"][:2]), ("rectangle", [0.3, 0.1]))
        self.expect_failure("goniometer", one, "--name", "near", words=["--name near", "far_field"], code=2)
        two = self.write("two.gltf", alone(goniometer("a"), goniometer("b")))
        self.expect_failure("goniometer", two, words=["2 goniometers", "--name", "a, b"], code=2)
        self.expect_failure("goniometer", self.scene, "--name", "a", words=["--name a", "has no goniometer"], code=2)
        down = {"rotation": test_program.UP, "extensions": {"KHR_lights_punctual": {"light": 0}}}
        above = scene_of({"rotation": test_program.UP, **goniometer("up", gamma_deg=[150, 170])}, down)
        above["extensionsUsed"] = ["KHR_lights_punctual"]
        above["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "spot", "spot": {}}]}}
        above = self.write("above.gltf", above)
        self.expect_failure("goniometer", above, "--iterations", 4, "--out", self.path("up.ies"),
                            words=["range of gamma"])
        self.assertFalse(os.path.exists(self.path("up.ies")))
        self.expect_failure("goniometer", "none.gltf", words=["none.gltf"])

    def test_closed_scenes_let_no_light_out(self):
        inside = {"parts": [{"emitter": {"radius_m": 0.01, "flux_lm": 1}},
                            {"reflector": {"profile": "polyline", "finish": "black", "smooth": False,
                                           "points_m": [[0, 0.1], [0.1, 0], [0, -0.1]]}}]}
        closed = self.write("closed.gltf", scene_of({"extras": {"ups": {"fixture": inside}}}))
        self.expect_failure("goniometer", closed, "--iterations", 4, words=["no light leaves the scene", "alone"])


if __name__ == "__main__":
    test_program.PROGRAM = sys.argv.pop(1)
    unittest.main()
