"""Runs the program `ups` on small scenes, right and wrong ones, and checks what it promises: exit codes, messages,
JSON, tables and images. Usage: test_program.py PATH_TO_UPS [unittest options]"""
import base64
import csv
import json
import math
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))

PROGRAM = None
UP = [-0.70710678, 0, 0, 0.70710678]  # local +Z to glTF's +Y

IES = """IESNA:LM-63-2002
[TEST] none
[MANUFAC] this project
TILT=NONE
1 -1 1 3 1 1 2 0 0 0
1 1 10
0 45 90
0
100 100 100
"""

PIXEL = base64.b64decode("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5Er"
                         "kJggg==")  # a PNG of one

CSV_HEADER = ("x_m,y_m,z_m,nx,ny,nz,illuminance_lx,standard_error_lx,bias_lx,error_bound_lx,direct_lx,indirect_lx")


def room():
    """A matte floor of 4 m x 4 m, a point light of 100 cd 2 m above (1, 0.5) in world x, y, a grid on the floor that
    faces up, a point, and a camera that looks down."""
    positions = struct.pack("<12f", -2, 0, 2, 2, 0, 2, 2, 0, -2, -2, 0, -2)
    indices = struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    data = positions + indices
    down = [-0.70710678, 0, 0, 0.70710678]
    return {
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": len(data),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "materials": [{"extras": {"ups": {"model": "matte", "reflectance": 0.5}}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.9, "znear": 0.1, "aspectRatio": 1.5}}],
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 100}]}},
        "scene": 0,
        "scenes": [{"nodes": [0, 1, 2, 3, 4]}],
        "nodes": [
            {"mesh": 0},
            {"translation": [1, 2, -0.5], "extensions": {"KHR_lights_punctual": {"light": 0}}},
            {"name": "work plane", "translation": [0, 0, 0], "rotation": UP,
             "extras": {"ups": {"meters": {"width_m": 4, "height_m": 2, "columns": 4, "rows": 2}}}},
            {"name": "spot", "rotation": UP, "translation": [1, 0, -0.5],
             "extras": {"ups": {"meters": {"points_m": [[0, 0, 0]], "normals": [[0, 0, 1]]}}}},
            {"name": "view", "camera": 0, "translation": [0, 4, 0], "rotation": down,
             "extras": {"ups": {"width": 24, "height": 16, "illuminance_camera": True}}},
        ],
    }


def with_image(scene, uri):
    """It is read, though no surface shows it."""
    scene["images"], scene["textures"] = [{"uri": uri}], [{"source": 0}]
    scene["materials"].append({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})
    return scene


# Of room().
FILES = sorted(["spot.csv", "view.exr", "view.png", "work_plane.csv", "work_plane.exr"] +
               [f"{name}.{ending}" for name in ("view_illuminance", "view_luminance", "work_plane")
                for ending in ("pdf", "png", "svg")])


class ProgramTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="ups-tool-")
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, content):
        if not isinstance(content, (str, bytes)):
            content = json.dumps(content)
        with open(self.path(name), "wb") as file:
            file.write(content.encode() if isinstance(content, str) else content)
        return self.path(name)

    def run_program(self, *arguments, code=0):
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder.name, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, timeout=120)
        self.assertEqual(done.returncode, code, msg=f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def render(self, *arguments, scene=None):
        scene = self.write("room.gltf", scene or room())
        return json.loads(self.run_program("render", scene, "--json", "--seed", 7, *arguments).stdout)

    def expect_failure(self, *arguments, words, code=1):
        done = self.run_program(*arguments, code=code)
        self.assertEqual(done.stdout, "")
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertNotRegex(done.stderr, r"\bups_\w+: ")  # names of C functions say nothing to people


class Usage(ProgramTest):
    def test_wrong_usage_is_2(self):
        scene = self.write("room.gltf", room())
        for arguments in ([], ["paint"], ["render"], ["render", scene, "--fast"], ["render", scene, "more"],
                          ["render", scene, "--method", "magic"], ["render", scene, "--time", "-1"],
                          ["render", scene, "--time", "nan"], ["render", scene, "--time", "soon"],
                          ["render", scene, "--iterations", "0"], ["render", scene, "--iterations", "-5"],
                          ["render", scene, "--out", ""],
                          ["render", scene, "--target-error", "0"], ["render", scene, "--seed", "-1"],
                          ["render", scene, "--target-of", "best"], ["render", scene, "--above", "nan"],
                          ["render", scene, "--above", "1e400"],
                          ["render", scene, "--seed", "x"], ["render", scene, "--seed", "18446744073709551616"],
                          ["render", scene, "--iterations", "4294967296"], ["render", scene, "--threads", "-1"],
                          ["render", scene, "--threads", "4294967296"], ["render", scene, "--iterations", "0x10"],
                          ["render", scene, "--size", "640"], ["render", scene, "--size", "0x9"],
                          ["render", scene, "--size", "640x480x3"], ["render", scene, "--out"], ["info"],
                          ["compare", "a.exr"]):
            with self.subTest(arguments=arguments):
                done = self.run_program(*arguments, code=2)
                self.assertEqual(done.stdout, "")
                self.assertNotEqual(done.stderr, "")

    def test_an_unknown_command_is_named(self):
        done = self.run_program("paint", code=2)
        for word in ("'paint' is no command", "render", "replay", "goniometer", "info", "map", "convert", "compare"):
            self.assertIn(word, done.stderr)

    def test_words_that_are_not_built_yet_say_so(self):
        scene = self.write("room.gltf", room())
        for arguments in (["render", scene, "--state", "a"], ["render", scene, "--resume", "a"],
                          ["merge", "a", "b", "--out", "c"], ["report", "a"]):
            with self.subTest(arguments=arguments):
                self.assertRegex(self.run_program(*arguments, code=2).stderr,
                                 "(--state|--resume|ups merge|ups report):? is not built yet")

    def test_numbers_that_no_render_can_hold_name_their_option(self):
        scene = self.write("room.gltf", room())
        for option, value in (("--seed", "18446744073709551616"), ("--target-error", "1e-300"),
                              ("--target-error", "1e300"), ("--target-error", "inf")):
            with self.subTest(option=option, value=value):
                done = self.run_program("render", scene, "--time", 1, option, value, code=2)
                self.assertIn(option, done.stderr)
                self.assertIn(value, done.stderr)
        largest = str(2**64 - 1)
        done = self.run_program("render", scene, "--iterations", 16, "--seed", largest, "--json")
        self.assertEqual(json.loads(done.stdout)["seed"], int(largest))

    def test_zeros_before_a_number_are_no_octal(self):
        scene = self.write("room.gltf", room())
        summary = json.loads(self.run_program("render", scene, "--iterations", "016", "--seed", "09", "--threads", "01",
                                              "--light-paths", "010", "--json").stdout)
        self.assertEqual((summary["iterations"], summary["seed"], summary["threads"]), (16, 9, 1))

    def test_help_and_version_are_0(self):
        self.assertRegex(self.run_program("--version").stdout, r"^ups \d+\.\d+\.\d+\n$")
        for arguments in (["--help"], ["render", "--help"], ["info", "--help"], ["compare", "--help"]):
            self.assertNotEqual(self.run_program(*arguments).stdout, "")
        self.assertIn("relative_mse", self.run_program("compare", "--help").stdout)


class BrokenFiles(ProgramTest):
    def broken(self, change, words, command="render"):
        scene = room()
        change(scene)
        self.expect_failure(command, self.write("broken.gltf", scene), words=["broken.gltf"] + words)

    def test_files_that_are_not_there(self):
        self.expect_failure("render", "none.gltf", words=["none.gltf"])
        self.expect_failure("info", "none.gltf", words=["none.gltf"])
        self.expect_failure("info", "none.ies", words=["none.ies"])
        self.expect_failure("compare", "a.exr", "b.exr", words=["a.exr"])
        scene = room()
        scene["nodes"][0]["extras"] = {"ups": {"luminaire": {"file": "gone.ies"}}}
        self.write("room.gltf", scene)
        here = os.getcwd()
        os.chdir(self.folder.name)
        self.addCleanup(os.chdir, here)
        self.expect_failure("render", "room.gltf", words=["gone.ies", "no such file"])

    def test_files_that_might_never_end(self):
        os.mkfifo(self.path("pipe.ies"))
        scene = room()
        scene["nodes"][0]["extras"] = {"ups": {"luminaire": {"file": "pipe.ies"}}}
        self.write("room.gltf", scene)
        for arguments in (["info", self.path("pipe.ies")], ["info", "/dev/zero"], ["render", "/dev/zero"],
                          ["render", self.path("pipe.ies")], ["render", self.path("room.gltf")],
                          ["convert", self.path("pipe.ies"), self.path("out.ldt")], ["compare", "/dev/zero", "a.exr"],
                          ["render", self.write("right.gltf", room()), "--targets", self.path("pipe.ies")]):
            self.expect_failure(*arguments, words=["a device or a pipe"])
        self.expect_failure("render", self.path("right.gltf"), "--targets", self.folder.name, words=["is a folder"])

    def test_a_pipe_that_is_open(self):
        for command, text in (("info", IES), ("render", json.dumps(room()))):
            more = ["--iterations", "1"] if command == "render" else []
            done = subprocess.run([PROGRAM, command, "/dev/stdin", *more], input=text.encode(), capture_output=True,
                                  timeout=60)
            self.assertEqual(done.returncode, 0, msg=done.stderr)

    def test_bad_content(self):
        self.expect_failure("render", self.write("bad.gltf", "{"), words=["bad.gltf", "JSON"])
        self.expect_failure("render", self.write("lamp.ies", IES), words=["lamp.ies", "photometric file", "ups info"])
        self.expect_failure("render", self.write("bad.glb", b"glTF\2\0\0\0"), words=["bad.glb", "truncated"])
        self.expect_failure("info", self.write("bad.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 2"), words=["bad.ies"])
        self.expect_failure("info", self.write("bad.txt", ""), words=["bad.txt", ".gltf"])
        self.expect_failure("compare", self.write("a.exr", "no image"), self.path("a.exr"), words=["a.exr"])

    def test_scenes_that_name_what_is_wrong(self):
        def material(scene): scene["materials"][0]["extras"]["ups"]["reflectence"] = 1
        def node(scene): scene["nodes"][2]["extras"]["ups"]["meters"]["colums"] = 1
        def luminaire(scene): scene["nodes"][0]["extras"] = {"ups": {"luminaire": {"file": "gone.ies"}}}
        def sky(scene): scene["scenes"][0]["extras"] = {"ups": {"sky": {"cie_type": 5}}}
        def meters(scene): scene["nodes"][2]["extras"]["ups"]["meters"]["kind"] = "round"
        def nothing(scene): scene["scenes"][0]["nodes"] = [0, 1]
        def index(scene): scene["accessors"][0]["count"] = 3
        def extension(scene): scene["extensionsRequired"] = ["XYZ_fancy"]
        self.broken(material, ["material 0", "reflectence"])
        self.broken(node, ["node 2", "work plane", "colums"])
        self.broken(luminaire, ["node 0", "gone.ies"])
        self.broken(sky, ["sky", "not built"])
        self.broken(meters, ["node 2", "work plane", "vector"])
        self.broken(nothing, ["nothing to render"])
        self.broken(index, ["mesh 0", "index 3"])
        self.broken(extension, ["XYZ_fancy"], command="info")

    def test_files_outside_the_scenes_folder(self):
        os.mkdir(self.path("scene"))
        self.write("lamp.ies", IES)
        scene = room()
        scene["nodes"][0]["extras"] = {"ups": {"luminaire": {"file": "../lamp.ies"}}}
        file = self.write("scene/room.gltf", scene)
        for command in (["info"], ["render", "--iterations", 16], ["goniometer", "--iterations", 16]):
            self.expect_failure(command[0], file, *command[1:],
                                words=["node 0", "../lamp.ies", "outside the scene's folder", "--allow-outside"])
            self.run_program(command[0], file, *command[1:], "--allow-outside")

    def test_out_that_is_a_file(self):
        self.expect_failure("render", self.write("room.gltf", room()), "--out", self.path("room.gltf"),
                            words=["room.gltf"])


class Render(ProgramTest):
    def test_shares_and_ratios_that_were_asked_for(self):
        result = self.render("--iterations", 32, "--above", 1, "--above", 1e6, "--ratio", "spot/work_plane")
        meters = result["meters"]
        for statistics in meters.values():
            self.assertEqual(statistics["share_above"]["1"], {"value": 1, "low": 1, "high": 1})
            self.assertEqual(statistics["share_above"]["1000000"]["value"], 0)
        ratio = result["ratios"]["spot/work_plane"]
        self.assertAlmostEqual(ratio["value"], meters["spot"]["mean_lx"] / meters["work_plane"]["mean_lx"], delta=1e-5)
        self.assertLessEqual(ratio["low"], ratio["value"])
        self.assertGreaterEqual(ratio["high"], ratio["value"])
        self.assertNotIn("meter_by_meter", ratio)  # 1 meter, 8 meters
        self.expect_failure("render", self.path("room.gltf"), "--time", 1000, "--ratio", "spot/floor",
                            words=["no meters of the name floor; it has work_plane, spot"], code=2)
        self.assertIn("not two names", self.run_program("render", self.path("room.gltf"), "--ratio", "spot", code=2).stderr)

    def test_the_modelling_index_meter_by_meter(self):
        scene = room()
        upright = json.loads(json.dumps(scene["nodes"][2]))
        upright["name"] = "upright"
        upright["extras"]["ups"]["meters"]["kind"] = "cylindrical"
        scene["scenes"][0]["nodes"].append(len(scene["nodes"]))
        scene["nodes"].append(upright)
        out, path = self.path("out"), self.write("modelling.gltf", scene)
        run = self.run_program("render", path, "--iterations", 64, "--seed", 1, "--out", out, "--json",
                               "--ratio", "upright/work_plane")
        def table(name):
            with open(os.path.join(out, name + ".csv")) as file:
                return [float(row["illuminance_lx"]) for row in csv.DictReader(file)]
        points = [a / b for a, b in zip(table("upright"), table("work_plane"))]
        told = json.loads(run.stdout)["ratios"]["upright/work_plane"]["meter_by_meter"]
        self.assertEqual(told["count"], 8)
        for end, value in (("least", min(points)), ("greatest", max(points))):
            self.assertAlmostEqual(told[end]["value"], value, delta=1e-5)
            self.assertLess(told[end]["low"], value)
            self.assertGreater(told[end]["high"], value)
        self.assertIn("meter by meter from", self.run_program("render", path, "--iterations", 16, "--ratio",
                                                              "upright/work_plane").stdout)

    def test_the_text_has_an_interval_beside_each_number(self):
        text = self.run_program("render", self.write("room.gltf", room()), "--iterations", 32).stdout
        number = r"([\d.e+-]+)"
        for what in ("mean", "min", "max"):
            found = re.search(rf"meters work_plane: .*\b{what} {number} lx \({number} to {number}\)", text)
            self.assertIsNotNone(found, text)
            value, low, high = map(float, found.groups())
            self.assertLessEqual(low, high)
            if what == "mean":  # the least of noisy readings may lie below its interval
                self.assertLessEqual(low, value)
                self.assertLessEqual(value, high)

    def test_the_text_says_what_is_unknown(self):
        text = self.run_program("render", self.write("room.gltf", room()), "--iterations", 3).stdout
        self.assertRegex(text, r"meters work_plane: mean [\d.]+ lx, min [\d.]+ lx, max [\d.]+ lx,")
        self.assertIn("worst error unknown", text)
        self.assertNotRegex(text, r"(?<![\w.(])-1\b")

    def test_json(self):
        result = self.render("--iterations", 32, "--threads", 1)
        self.assertEqual(set(result), {"scene", "method", "techniques", "effects", "iterations", "time_s", "threads",
                                       "seed", "flux", "dropped_samples", "work", "memory", "meters", "cameras",
                                       "convergence", "warnings", "choice", "prediction", "advice", "largest_error",
                                       "largest_samples", "maintenance_factor", "observers"})
        self.assertEqual(result["observers"], {})
        self.assertEqual(result["scene"], self.path("room.gltf"))
        self.assertEqual(result["iterations"], 32)
        self.assertEqual(result["seed"], 7)
        self.assertEqual(result["threads"], 1)
        self.assertEqual(set(result["work"]), {"rays", "eye_paths", "light_paths", "connections", "merges"})
        self.assertGreater(result["work"]["eye_paths"], 0)
        self.assertEqual(set(result["flux"]), {"emitted_lm", "absorbed_lm", "escaped_lm", "balance_standard_error_lm"})
        self.assertAlmostEqual(result["flux"]["emitted_lm"], 400 * math.pi, delta=0.01)
        memory = result["memory"]
        self.assertEqual(set(memory), {"scene_bytes", "working_bytes", "light_bytes", "result_bytes", "peak_bytes",
                                       "allowed_bytes", "resident_bytes"})
        self.assertGreater(memory["allowed_bytes"], memory["peak_bytes"])
        self.assertGreater(memory["peak_bytes"], memory["scene_bytes"] + memory["result_bytes"])
        self.assertEqual(list(result["meters"]), ["work_plane", "spot"])
        for statistics in result["meters"].values():
            self.assertEqual(set(statistics), {"kind", "mean_lx", "min_lx", "max_lx", "uniformity",
                                               "mean_standard_error_lx", "mean_error_bound_lx", "percentile_5_lx",
                                               "uniformity_low", "uniformity_high", "worst_relative_error_bound",
                                               "min_low_lx", "min_high_lx", "max_low_lx", "max_high_lx", "diversity",
                                               "diversity_low", "diversity_high", "percentiles_lx"})
            self.assertEqual(set(statistics["percentiles_lx"]), {"5", "50", "95"})
            self.assertEqual(set(statistics["percentiles_lx"]["50"]), {"value", "low", "high"})
            if statistics["uniformity_low"] >= 0:
                self.assertLessEqual(statistics["uniformity_low"], statistics["uniformity"])
                self.assertGreaterEqual(statistics["uniformity_high"], statistics["uniformity_low"])
        self.assertEqual(set(result["cameras"]), {"view"})
        self.assertEqual({k: result["cameras"]["view"][k] for k in ("width", "height")}, {"width": 24, "height": 16})
        self.assertGreater(result["cameras"]["view"]["mean_luminance_cd_m2"], 0)
        self.assertEqual(set(result["choice"]), {"work_plane", "spot", "view"})
        for choice in result["choice"].values():
            self.assertEqual(set(choice), {"techniques", "light_paths", "photons", "predicted_gain"})
            self.assertLessEqual(set(choice["techniques"]), set(result["techniques"]))
        for point in result["convergence"]:
            self.assertEqual(set(point), {"time_s", "iterations", "median_relative_error", "p95_relative_error",
                                          "worst_relative_error", "mean_relative_error", "bias_share", "rays",
                                          "light_paths", "eye_paths", "bytes"})
            self.assertGreater(point["bytes"], 1e6)
        self.assertEqual([p["relative_error"] for p in result["prediction"]], [0.05, 0.02, 0.01, 0.005])
        for p in result["prediction"]:
            self.assertEqual(set(p), {"relative_error", "seconds", "low", "high", "limited_by"})
            self.assertIn(p["limited_by"], ("noise", "bias"))
        self.assertEqual(set(result["largest_error"]), {"meters", "index", "position_m", "relative_error",
                                                        "bias_share"})
        # 100 cd, 2 m straight above, on a floor that sees nothing else: 100 / 2^2 lx, without chance.
        self.assertAlmostEqual(result["meters"]["spot"]["mean_lx"], 25, delta=1e-4 * 25)
        self.assertEqual(os.listdir(self.folder.name), ["room.gltf"])  # without --out no file

    def test_nothing_is_foretold_of_a_short_render(self):
        result = self.render("--iterations", 2)
        self.assertEqual([p["relative_error"] for p in result["prediction"]], [0.05, 0.02, 0.01, 0.005])
        for p in result["prediction"]:
            self.assertEqual([p["seconds"], p["low"], p["high"]], [-1, -1, -1])

    def test_warnings_name_the_meters(self):
        scene = room()
        scene["nodes"][3]["extras"]["ups"]["meters"]["normals"] = [[0, 0, -1]]  # faces the floor, which is black
        scene["materials"][0]["extras"]["ups"]["reflectance"] = 0
        warnings = self.render("--iterations", 16, scene=scene)["warnings"]
        self.assertTrue(any(w.startswith("meters spot: ") for w in warnings), msg=warnings)

    def test_warnings_name_parts_of_the_file(self):
        """What the core, which counts from 1, calls material 2."""
        scene = room()
        scene["materials"].append({"name": "Glass", "alphaMode": "MASK", "pbrMetallicRoughness":
                                   {"baseColorFactor": [1, 1, 1, 0.2]}, "extras": {"ups": {"model": "glass"}}})
        number = len(scene["materials"]) - 1
        scene["meshes"].append({"primitives": [dict(scene["meshes"][0]["primitives"][0], material=number)]})
        nodes = len(scene["nodes"])
        scene["nodes"].append({"name": "material 1", "mesh": len(scene["meshes"]) - 1, "translation": [0, 1, 0]})
        scene["scenes"][0]["nodes"].append(nodes)
        path = self.write("room.gltf", scene)
        info = json.loads(self.run_program("info", path, "--json").stdout)["files"][0]
        for warnings in (info["warnings"], self.render("--iterations", 1, scene=scene)["warnings"]):
            told = [w for w in warnings if "is of glass" in w]
            self.assertEqual([w.startswith(f'material {number} "Glass": ') for w in told], [True], msg=warnings)
        self.assertTrue(any('"Glass"' in line for line in info["techniques"] + info["effects"]), msg=info)

    def test_options_without_effect_are_told(self):
        idle = ["--technique-images", 2, "--separate", "luminaires", "--smooth", "--exposure", 5, "--map-scale", "log"]
        told = [w for w in self.render("--iterations", 1, *idle)["warnings"] if "no effect" in w]
        self.assertEqual([w.split(" ")[0] for w in told],
                         ["--technique-images", "--separate", "--smooth", "--exposure", "--map-..."], msg=told)
        self.assertTrue(all("--out" in w for w in told), msg=told)
        used = self.render("--iterations", 1, "--out", self.path("used"), "--size", "8x8", *idle)["warnings"]
        self.assertFalse([w for w in used if "no effect" in w], msg=used)
        scene = room()
        for node in scene["nodes"]:
            if node.pop("camera", None) is not None:
                node.pop("extras", None)
        warnings = self.render("--iterations", 1, "--size", "8x8", scene=scene)["warnings"]
        self.assertIn("--size has no effect: the scene has no camera", warnings)

    def test_choice(self):
        eye = ["emitter_hit", "light_sample"]
        asked = self.render("--method", "ups", "--iterations", 4, "--light-paths", 4096)["choice"]
        self.assertEqual(asked["work_plane"], {"techniques": [*eye, "connect", "merge"],
                                               "light_paths": 4096, "photons": "all", "predicted_gain": 1})
        self.assertEqual(asked["view"]["techniques"], [*eye, "connect", "sensor_connect", "merge"])
        for choice in self.render("--iterations", 4)["choice"].values():  # a matte floor
            self.assertEqual({k: choice[k] for k in ("techniques", "light_paths", "photons")},
                             {"techniques": eye, "light_paths": 0, "photons": "none"})
            self.assertGreaterEqual(choice["predicted_gain"], 1)

    def test_files(self):
        out = self.path("deep/out")
        result = self.render("--iterations", 32, "--out", out)
        self.assertEqual(sorted(os.listdir(out)), FILES)
        for name in os.listdir(out):
            with open(os.path.join(out, name), "rb") as file:
                start = file.read(8)
            if name.endswith(".png"):
                self.assertEqual(start, b"\x89PNG\r\n\x1a\n")
            if name.endswith(".exr"):
                self.assertEqual(start[:4], b"\x76\x2f\x31\x01")
        with open(os.path.join(out, "work_plane.csv"), encoding="ascii") as file:
            self.assertEqual(file.readline(), CSV_HEADER + "\n")
            file.seek(0)
            rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]
        self.assertEqual(len(rows), 8)
        self.assertEqual([(r["x_m"], r["y_m"]) for r in rows],
                         [(x, y) for y in (-0.5, 0.5) for x in (-1.5, -0.5, 0.5, 1.5)])
        for row in rows:
            self.assertAlmostEqual(row["z_m"], 0, places=6)
            self.assertAlmostEqual(row["nz"], 1, places=6)
            # Inverse square and cosine of the point light at (1, 0.5, 2), without chance.
            squared = (row["x_m"] - 1) ** 2 + (row["y_m"] - 0.5) ** 2 + 4
            self.assertAlmostEqual(row["illuminance_lx"] / (100 * 2 / squared ** 1.5), 1, delta=1e-4)
            self.assertAlmostEqual(row["direct_lx"] + row["indirect_lx"], row["illuminance_lx"], delta=1e-3)
            self.assertGreaterEqual(row["error_bound_lx"], 0)
        mean = sum(r["illuminance_lx"] for r in rows) / 8
        self.assertAlmostEqual(result["meters"]["work_plane"]["mean_lx"], mean, delta=1e-3 * mean)
        self.assertEqual(result["meters"]["work_plane"]["kind"], "planar")

    def test_meters_of_every_kind(self):
        scene = room()
        scene["materials"][0]["extras"]["ups"]["reflectance"] = 0
        # From (0, 0, 0.5) the light is 1.5 m above and 1 m, 0.5 m beside: 100 cd over 3.5 m2.
        beam, slope = 100 / 3.5, [1 / 3.5 ** 0.5, 0.5 / 3.5 ** 0.5, 1.5 / 3.5 ** 0.5]
        sine = (1 - slope[2] ** 2) ** 0.5
        expected = {"cylindrical": sine / 3.14159265, "semicylindrical": (sine + slope[1]) / 3.14159265,
                    "hemispherical": (1 + slope[1]) / 4, "spherical": 0.25, "vector": 1}
        for kind in expected:
            # glTF's -Z is the world's +Y.
            points = {"points_m": [[0, 0.5, 0]], "normals": [[0, 0, -1]], "kind": kind, "name": kind}
            scene["scenes"][0]["nodes"].append(len(scene["nodes"]))
            scene["nodes"].append({"extras": {"ups": {"meters": points}}})
        out = self.path("out")
        result = self.render("--iterations", 16, "--out", out, scene=scene)
        for kind, share in expected.items():
            self.assertEqual(result["meters"][kind]["kind"], kind)
            with open(os.path.join(out, kind + ".csv"), encoding="ascii") as file:
                row = {k: float(v) for k, v in next(csv.DictReader(file)).items()}
            self.assertAlmostEqual(row["illuminance_lx"] / (beam * share), 1, delta=1e-4, msg=kind)
            self.assertEqual("vector_x_lx" in row, kind == "vector")
        for axis, part in zip("xyz", slope):
            self.assertAlmostEqual(row[f"vector_{axis}_lx"], beam * part, delta=1e-3)
            self.assertEqual(row[f"vector_{axis}_standard_error_lx"], 0)
            self.assertLess(row[f"vector_{axis}_error_bound_lx"], 0.01)
            self.assertAlmostEqual(row[f"vector_{axis}_direct_lx"], beam * part, delta=1e-3)
            self.assertEqual((row[f"vector_{axis}_bias_lx"], row[f"vector_{axis}_indirect_lx"]), (0, 0))

    def test_a_file_that_cannot_be_written_does_not_take_the_others(self):
        out = self.path("out")
        os.mkdir(out)
        for name in ("view.exr", "work_plane.csv"):  # links that lead into no folder
            os.symlink(self.path("none/" + name), os.path.join(out, name))
        done = self.run_program("render", self.write("room.gltf", room()), "--iterations", 16, "--json", "--out", out,
                                code=1)
        self.assertIn("work_plane", json.loads(done.stdout)["meters"])
        errors = done.stderr.splitlines()
        for name in ("view.exr", "work_plane.csv"):
            self.assertTrue(any("error" in line and name in line for line in errors), msg=done.stderr)
        self.assertEqual(sorted(os.listdir(out)), FILES)
        self.assertEqual([name for name in os.listdir(out) if not os.path.exists(os.path.join(out, name))],
                         [name for name in os.listdir(out) if name in ("view.exr", "work_plane.csv")])

    def test_folders_in_the_place_of_files_fail_before_the_render(self):
        scene = self.write("room.gltf", room())
        for name, more in (("view.exr", []), ("view_illuminance.svg", []), ("work_plane.csv", []), ("spot.pdf", []),
                           ("report.html", ["--report"]), ("view_techniques.exr", ["--technique-images", 2]),
                           ("spot_luminaires.csv", ["--separate", "luminaires"])):
            out = self.path("out_" + name)
            os.makedirs(os.path.join(out, name))
            self.expect_failure("render", scene, "--time", 1000, "--out", out, *more,
                                words=["--out", name, "is a folder"])
            self.assertEqual(os.listdir(out), [name])

    def test_two_that_would_write_one_file_fail_before_the_render(self):
        scene = room()
        scene["nodes"][2]["extras"]["ups"]["meters"]["name"] = "spot_luminaires"
        path = self.write("room.gltf", scene)
        self.expect_failure("render", path, "--time", 1000, "--separate", "luminaires", "--out", self.path("out"),
                            words=["--out", "two of the scene's", "spot_luminaires.csv"])
        self.run_program("render", path, "--iterations", 1, "--out", self.path("out"))

    def test_files_that_the_scene_reads_fail_before_the_render(self):
        def image(scene):
            with_image(scene, "work%5Fplane.png")  # as a URI may write it
            return "work_plane.png", PIXEL

        def buffer(scene):
            data = scene["buffers"][0]["uri"].partition(",")[2]
            scene["buffers"][0]["uri"] = "view.exr"
            return "view.exr", base64.b64decode(data)

        def luminaire(scene):
            scene["nodes"][0]["extras"] = {"ups": {"luminaire": {"file": "spot.csv"}}}
            return "spot.csv", IES

        def light(scene):
            scene["extensionsUsed"].append("EXT_lights_ies")
            scene["extensions"]["EXT_lights_ies"] = {"lights": [{"uri": "./spot.csv"}]}
            scene["nodes"][0]["extensions"] = {"EXT_lights_ies": {"light": 0}}
            return "spot.csv", IES

        os.symlink(".", self.path("here"))
        for change in (image, buffer, luminaire, light):
            scene = room()
            name, content = change(scene)
            self.write(name, content)
            text = json.dumps(scene).encode()
            text += b" " * (-len(text) % 4)
            self.write("room.gltf", text)
            self.write("room.glb", struct.pack("<4s3I4s", b"glTF", 2, 20 + len(text), len(text), b"JSON") + text)
            before = sorted(os.listdir(self.folder.name))
            for file, out in (("room.gltf", "."), ("room.gltf", "here"), ("room.glb", self.folder.name)):
                with self.subTest(change=change.__name__, file=file, out=out):
                    self.expect_failure("render", file, "--time", 1000, "--out", out,
                                        words=["--out", name, f"the scene {file} reads"])
            self.assertEqual(sorted(os.listdir(self.folder.name)), before)
            self.run_program("render", "room.glb", "--iterations", 1, "--out", "out")
            os.remove(self.path(name))
        self.write("report.html", room())
        self.expect_failure("render", "report.html", "--time", 1000, "--report", "--out", ".",
                            words=["--out", "report.html", "the scene report.html reads"])

    def test_drawings_do_not_replace_what_the_scene_reads(self):
        self.write("room.gltf", with_image(room(), "paint.png"))
        self.write("paint.png", PIXEL)
        self.run_program("render", "room.gltf", "--iterations", 1, "--out", "out")
        self.expect_failure("map", "out/work_plane.csv", "paint.png", "--scene", "room.gltf",
                            words=["OUT", "paint.png", "reads"])
        self.expect_failure("replay", "room.gltf", "--sample", "spot/0/0/eye/0/1", "--plot", "paint.png",
                            words=["--plot", "paint.png", "reads"])
        with open(self.path("paint.png"), "rb") as file:
            self.assertEqual(file.read(), PIXEL)

    def test_outputs_do_not_replace_a_tilt_file(self):
        """That an IES file names, which the scene names."""
        self.write("lamp.ies", IES.replace("TILT=NONE", "tilt = Spot.csv"))
        tilt = "1\n2\n0 90\n1 0.9\n"
        self.write("spot.csv", tilt)
        scene = room()
        scene["nodes"][1]["extras"] = {"ups": {"luminaire": {"file": "lamp.ies"}}}
        self.expect_failure("render", self.write("room.gltf", scene), "--time", 1000, "--out", ".",
                            words=["--out", "spot.csv", "room.gltf reads"])
        with open(self.path("spot.csv"), encoding="utf-8") as file:
            self.assertEqual(file.read(), tilt)

    def test_a_folder_that_takes_no_file_fails_before_the_render(self):
        out = self.path("out")
        if os.geteuid() == 0:
            if not os.path.isdir("/proc/self"):
                self.skipTest("root may write everywhere here")
            out = "/proc/self"
        else:
            os.mkdir(out, 0o500)
        scene = self.write("room.gltf", room())
        self.expect_failure("render", scene, "--time", 1000, "--out", out, words=["--out", out])

    def test_a_grid_too_wide_for_a_picture(self):
        scene, out = room(), self.path("out")
        maps = ["grid.pdf", "grid.png", "grid.svg"]
        for columns, files in ((16385, ["grid.csv", "grid.exr", *maps]), (65537, ["grid.csv", *maps])):
            with self.subTest(columns=columns):
                scene["nodes"][2]["extras"]["ups"]["meters"].update(columns=columns, rows=1, name="grid")
                done = self.run_program("render", self.write("room.gltf", scene), "--iterations", 1, "--method", "pt",
                                        "--size", "4x4", "--json", "--out", out)
                warnings = [w for w in json.loads(done.stdout)["warnings"] if "grid.exr" in w and "65536" in w]
                self.assertEqual(len(warnings), columns > 65536, msg=done.stdout)
                self.assertEqual(sorted(name for name in os.listdir(out) if name.startswith("grid")), files)
                self.assertIn("view.png", os.listdir(out))
                for name in os.listdir(out):
                    os.remove(os.path.join(out, name))

    def test_same_bits_whatever_the_threads(self):
        tables = []
        for threads in (1, 2):
            out = self.path(f"out{threads}")
            self.render("--iterations", 16, "--threads", threads, "--out", out)
            with open(os.path.join(out, "work_plane.csv"), "rb") as file:
                tables.append(file.read())
        self.assertEqual(tables[0], tables[1])

    def test_size(self):
        result = self.render("--iterations", 16, "--size", "10x5")
        self.assertEqual({k: result["cameras"]["view"][k] for k in ("width", "height")}, {"width": 10, "height": 5})

    def test_exposure_and_smoothing_change_the_picture_alone(self):
        files = {}
        for name, options in (("plain", []), ("smooth", ["--smooth"]), ("given", ["--exposure", 5.5])):
            out = self.path(name)
            view = self.render("--iterations", 32, "--out", out, *options)["cameras"]["view"]
            with open(os.path.join(out, "view.exr"), "rb") as exr, open(os.path.join(out, "view.png"), "rb") as png:
                files[name] = (view, exr.read(), png.read())
        for name in ("smooth", "given"):
            self.assertEqual(files[name][1], files["plain"][1])  # not a bit of the image
            self.assertNotEqual(files[name][2], files["plain"][2])
        self.assertEqual([files[n][0]["smoothed"] for n in files], [False, True, False])
        self.assertEqual([files[n][0]["exposure"] for n in files], ["chosen", "chosen", "given"])
        self.assertEqual(files["smooth"][0]["exposure_ev100"], files["plain"][0]["exposure_ev100"])
        self.assertAlmostEqual(files["given"][0]["exposure_ev100"], 5.5, places=9)
        self.assertIn(b"tEXtComment\0smoothed for display", files["smooth"][2])
        self.assertNotIn(b"smoothed", files["plain"][2])
        self.assertIn(b"tEXtExposure\0EV100 5.50: 5.657 cd/m2 is shown as an 18 % grey", files["given"][2])  # 2^5.5 / 8
        self.assertIn(b"5th and 95th percentile", files["plain"][2])
        for bad in ("bright", 101, "nan"):
            self.run_program("render", "room.gltf", "--exposure", bad, code=2)

    def test_projection_and_layers(self):
        scene = room()
        view = next(node for node in scene["nodes"] if node.get("name") == "view")
        words = view.setdefault("extras", {}).setdefault("ups", {})
        words.update({"projection": "equidistant", "width": 24, "height": 16, "layers": ["albedo", "depth", "id"]})
        out = self.path("out")
        camera = self.render("--iterations", 16, "--out", out, scene=scene)["cameras"]["view"]
        self.assertEqual((camera["projection"], camera["width"], camera["height"]), ("equidistant", 24, 16))
        with open(os.path.join(out, "view.exr"), "rb") as file:
            header = file.read(4000)
        for channel in ("albedo.R", "albedo.G", "albedo.B", "depth.Z", "id.Y", "R", "standard_error.R"):
            self.assertIn(b"\0" + channel.encode() + b"\0", header)
        self.assertNotIn(b"normal.X", header)
        self.assertIn(b"equidistant", header)
        info = json.loads(self.run_program("info", self.write("room.gltf", scene), "--json").stdout)
        sensors = {s["name"]: s for s in info["files"][0]["sensors"]}
        self.assertEqual(sensors["view"]["projection"], "equidistant")
        words["projection"] = "fisheye"
        self.expect_failure("render", self.write("room.gltf", scene), words=["projection", "equisolid"])

    def test_methods_bear_their_words(self):
        for method in ("ups", "pt", "lt", "bpt", "ppm"):
            with self.subTest(method=method):
                self.assertEqual(self.render("--iterations", 16, "--method", method)["method"], method)

    @unittest.skipIf(sys.platform == "win32", "no pseudoterminals")
    def test_the_bar_fits_the_terminal(self):
        """What wraps could not be written over: no line is wider than the terminal."""
        from terminal import drawn_by
        scene = self.write("room.gltf", room())
        for columns in (80, 30):
            process, drawn = drawn_by(lambda stream: subprocess.Popen(
                [PROGRAM, "render", scene, "--time", "1.5"], stdout=subprocess.DEVNULL, stderr=stream), columns)
            self.assertEqual(process.wait(60), 0)
            lines = [line for line in re.split(rb"[\r\n]", drawn) if line.startswith(b"[")]
            self.assertGreater(len(lines), 1)
            self.assertLess(max(map(len, lines)), columns)

    def test_what_is_too_dark_for_a_picture_does_not_take_the_rest(self):
        dark = room()
        dark["extensions"]["KHR_lights_punctual"]["lights"][0]["intensity"] = 1e-33
        report = self.render("--iterations", 8, scene=dark)
        self.assertGreater(report["meters"]["spot"]["mean_lx"], 0)
        self.assertNotIn("exposure_ev100", report["cameras"]["view"])

    def test_time_limit(self):
        result = self.render("--time", 2)
        self.assertGreater(result["time_s"], 0)
        self.assertLess(result["time_s"], 100)  # or nothing has ended it

    def test_target_error(self):
        result = self.render("--target-error", 0.05, "--time", 1000, scene=self.lit_by_its_ceiling())
        self.assertGreaterEqual(result["iterations"], 16)
        for name, statistics in result["meters"].items():
            self.assertGreaterEqual(statistics["worst_relative_error_bound"], 0, msg=name)
            self.assertLessEqual(statistics["worst_relative_error_bound"], 0.05, msg=name)
        self.assertLessEqual(result["convergence"][-1]["worst_relative_error"], 0.05)

    def lit_by_its_ceiling(self):
        """The room with a ceiling: light that is reflected has noise."""
        scene = room()
        scene["nodes"].append({"mesh": 0, "translation": [0, 3, 0]})
        scene["scenes"][0]["nodes"].append(5)
        return scene

    def test_target_of(self):
        scene, iterations = self.lit_by_its_ceiling(), {}
        for word in ("worst", "p95", "mean", "median"):
            result = self.render("--target-error", 0.002, "--time", 100, "--target-of", word, scene=scene)
            self.assertLessEqual(result["convergence"][-1][word + "_relative_error"], 0.002, msg=word)
            iterations[word] = result["iterations"]
        self.assertEqual(self.render("--target-error", 0.002, "--time", 100, scene=scene)["iterations"],
                         iterations["worst"])
        self.assertLess(iterations["median"], iterations["worst"])

    def test_advice(self):
        scene = self.lit_by_its_ceiling()
        seconds = max(1.5, math.ceil(self.render("--iterations", 64, scene=scene)["time_s"]))  # slow builds, too
        result = self.render("--target-error", 1e-5, "--time", seconds, scene=scene)
        worst, out_of_reach = result["largest_error"], f"within {seconds:g} s the target is out of reach"
        self.assertIn(worst["meters"], result["meters"])
        self.assertEqual(worst["relative_error"], result["convergence"][-1]["worst_relative_error"])
        [advice] = result["advice"]
        self.assertTrue(advice.startswith(out_of_reach), msg=advice)
        self.assertRegex(advice, r"^within [\d.]+ s the target is out of reach: at this rate 0\.001 % "
                                 r"(after \S+ (s|min|h) \(.* to .*\)|(perhaps )?never at this rate.*), limited by "
                                 rf"noise; meter {worst['index']} of {worst['meters']}, at \(.*\), has the largest "
                                 r"error, \S+ %$")
        self.assertEqual(self.render("--target-error", 0.1, "--time", 100, scene=scene)["advice"], [])
        done = self.run_program("render", self.path("room.gltf"), "--target-error", "1e-5", "--time", seconds)
        self.assertIn("advice: " + out_of_reach, done.stdout)
        self.assertIn("accuracy: 5 % after ", done.stdout)

    def test_text(self):
        done = self.run_program("render", self.write("room.gltf", room()), "--iterations", 16)
        for word in ("work_plane", "spot", "view", "lx", "cd/m^2"):
            self.assertIn(word, done.stdout)

    def test_text_of_a_scene_far_down(self):
        folder = os.path.join(*["long" * 50] * 4)
        os.makedirs(self.path(folder))
        scene = self.write(os.path.join(folder, "room.gltf"), room())
        lines = self.run_program("render", scene, "--iterations", 16, "--seed", 5).stdout.splitlines()
        self.assertTrue(lines[0].startswith(scene + ": method "), msg=lines[0])
        self.assertTrue(lines[0].endswith("seed 5"), msg=lines[0])

    def start_under(self, number, handler, *arguments):
        """Whoever runs the tests may have been told to ignore signals (nohup, the background)."""
        return subprocess.Popen([PROGRAM, "render", *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                text=True, preexec_fn=lambda: signal.signal(number, handler))

    def test_interrupt_writes_what_is_there(self):
        scene = self.write("room.gltf", room())
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            out = self.path(f"out{int(number)}")
            for patience in (2, 10, 50):  # until an iteration is done
                process = self.start_under(number, signal.SIG_DFL, scene, "--time", "300", "--json", "--out", out)
                time.sleep(patience)
                process.send_signal(number)
                stdout, stderr = process.communicate(timeout=100)
                if stdout:
                    break
            self.assertEqual(process.returncode, 128 + number, msg=stderr)
            self.assertGreaterEqual(json.loads(stdout)["iterations"], 1)
            self.assertIn("interrupted", stderr)
            self.assertIn("work_plane.csv", os.listdir(out))

    def test_signals_that_are_ignored_stay_so(self):
        scene = self.write("room.gltf", room())
        numbers = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
        processes = [self.start_under(number, signal.SIG_IGN, scene, "--time", "4", "--json") for number in numbers]
        time.sleep(2)
        for number, process in zip(numbers, processes):
            process.send_signal(number)
        for process in processes:
            stdout, stderr = process.communicate(timeout=100)
            self.assertEqual(process.returncode, 0, msg=stderr)
            self.assertGreater(json.loads(stdout)["time_s"], 3)


class MemoryLimit(ProgramTest):
    def test_a_render_beyond_the_limit_is_refused(self):
        scene = self.write("room.gltf", room())
        out = self.path("out")
        self.expect_failure("render", scene, "--iterations", 4, "--size", "2000x1500", "--memory-limit", "100M", "--out",
                            out, words=["want about", "--memory-limit allows 100 MB", "fewer pixels ("])
        self.assertEqual(os.listdir(out), [])
        limited = self.render("--iterations", 4, "--memory-limit", "0.2GB")
        self.assertEqual(limited["memory"]["allowed_bytes"], 200000000)
        self.assertEqual(self.render("--iterations", 4)["meters"], limited["meters"])

    def test_what_is_no_number_of_bytes(self):
        scene = self.write("room.gltf", room())
        for text in ("", "0", "-1", "much", "1X", "1MiB", "1 G", "1e30", "nan"):
            with self.subTest(text=text):
                done = self.run_program("render", scene, "--memory-limit", text, code=2)
                self.assertIn("--memory-limit", done.stderr)


class InfoAndCompare(ProgramTest):
    def test_info_of_a_scene(self):
        text = self.run_program("info", self.write("room.gltf", room())).stdout
        for word in ("triangles: 2", "1 lights", "work_plane", "4 x 2", "view", "24 x 16", "effects", "techniques"):
            self.assertIn(word, text)

    def test_info_of_a_photometric_file(self):
        text = self.run_program("info", self.write("Lamp.IES", IES)).stdout
        for word in ("LM-63-2002", "628", "peak: 100 cd", "symmetry: axial", "opening: point", "MANUFAC"):
            self.assertIn(word, text)

    def test_compare(self):
        for seed, name in ((1, "a"), (2, "b")):
            self.run_program("render", self.write("room.gltf", room()), "--iterations", 16, "--seed", seed, "--method",
                             "pt", "--out", self.path(name))
        a, b = self.path("a/view.exr"), self.path("b/view.exr")
        same = json.loads(self.run_program("compare", a, a, "--json").stdout)
        self.assertEqual(set(same), {"rmse", "relative_mse", "mean_a", "mean_b", "worst_pixel", "channels"})
        self.assertEqual((same["rmse"], same["relative_mse"]), (0, 0))
        other = json.loads(self.run_program("compare", a, b, "--json").stdout)
        self.assertEqual(other["mean_a"], same["mean_a"])
        self.assertGreater(other["mean_b"], 0)
        self.assertEqual(len(other["worst_pixel"]), 2)
        self.assertIn("worst pixel", self.run_program("compare", a, b).stdout)
        grid = self.path("a/work_plane.exr")
        self.assertGreater(json.loads(self.run_program("compare", grid, grid, "--json").stdout)["mean_a"], 0)
        self.expect_failure("compare", a, grid, words=["24 x 16", "4 x 2"])


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
