"""Scenes at the limits of numbers: no file that the program writes of them holds a number that is not finite.
Usage: test_extremes.py PATH_TO_UPS [unittest options]"""
import json
import os
import re
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../samples/scenes_common"))
import need_numpy  # noqa: E402,F401
import numpy as np  # noqa: E402
import test_goniometer  # noqa: E402
import test_program  # noqa: E402
from exr import read_channels  # noqa: E402

NOT_FINITE = re.compile(r"(?i)(?<![a-z_])[-+]?(nan|inf|infinity)(?![a-z_])")
EMBEDDED = re.compile(r"data:[a-z/+-]+;base64,[A-Za-z0-9+/=]+|<style>.*?</style>|<script>.*?</script>", re.DOTALL)
TEXTS = (".csv", ".json", ".svg", ".html", ".ies", ".ldt")


def room(lamps=(100.0,), scale=1.0, offset=(0, 0, 0), model="matte", **material):
    """test_program.room() with these lamps side by side, so many times as large, so far away, its floor of a material."""
    scene = test_program.room()
    scene["extensions"]["KHR_lights_punctual"]["lights"] = [{"type": "point", "intensity": i} for i in lamps]
    scene["materials"][0]["extras"]["ups"] = {"model": model, **material}
    nodes = scene["nodes"]
    del nodes[1]  # its lamp
    for i in range(len(lamps)):
        nodes.append({"name": f"lamp {i}", "translation": [1 - 0.1 * i, 2, -0.5],
                      "extensions": {"KHR_lights_punctual": {"light": i}}})
    nodes.append({"name": "eye", "translation": [0, 1.2, 1.5], "extras": {"ups": {"observer": {}}}})
    for x, kind in ((0.2, "cylindrical"), (0.4, "vector")):
        nodes.append({"name": kind, "rotation": test_program.UP, "translation": [x, 1, 0],
                      "extras": {"ups": {"meters": {"points_m": [[0, 0, 0]], "normals": [[0, 0, 1]], "kind": kind}}}})
    nodes.append({"name": "all", "scale": [scale] * 3, "translation": list(offset), "children": list(range(len(nodes)))})
    scene["scenes"] = [{"nodes": [len(nodes) - 1]}]
    return scene


class Extremes(test_program.ProgramTest):
    def expect_finite(self, name, content):
        found = NOT_FINITE.search(EMBEDDED.sub("", content))
        if found:
            self.fail(f"{name}: {content[max(0, found.start() - 80):found.end() + 40]}")

    def expect_finite_files(self, folder):
        """How many were read."""
        count = 0
        for name in sorted(os.listdir(folder)):
            path = os.path.join(folder, name)
            if name.endswith(".exr"):
                image, _ = read_channels(path)
                self.assertTrue(np.isfinite(image).all(), name)
            elif name.endswith(TEXTS):
                with open(path, encoding="utf-8") as file:
                    self.expect_finite(name, file.read())
            else:
                continue
            count += 1
        return count

    def expect_finite_render(self, scene, *more):
        out = self.path("out")
        done = self.run_program("render", self.write("room.gltf", scene), "--json", "--iterations", 24, "--seed", 7, "--out",
                                out, "--report", "--separate", "luminaires", "--technique-images", 3, "--smooth", "--above",
                                100, "--ratio", "spot/work_plane", *more)

        def refuse(word):
            self.fail(f"JSON: {word}")
        json.loads(done.stdout, parse_constant=refuse)
        self.expect_finite("standard output", done.stdout)
        self.assertGreaterEqual(self.expect_finite_files(out), 12, os.listdir(out))

    def test_what_is_not_finite_is_noticed(self):
        for text in ("1,nan,2", "<td>-inf</td>", "0 NaN", '{"a": Infinity}'):
            self.assertRegex(text, NOT_FINITE)
        self.assertNotRegex("information, banana, in financial info 1e5", NOT_FINITE)

    def test_candelas(self):
        self.expect_finite_render(room([10.0 ** e for e in range(-6, 10)]))
        self.expect_finite_render(room([1e-6]))
        self.expect_finite_render(room([1e9]))

    def test_no_light(self):
        self.expect_finite_render(room([0.0]))

    def test_units_and_far_away(self):
        self.expect_finite_render(room(scale=1e5))
        self.expect_finite_render(room(scale=1e-3))
        self.expect_finite_render(room(offset=(1e5, 0, -1e5)))

    def test_materials(self):
        for roughness in (0.1, 1e-3, 1e-5, 0):
            self.expect_finite_render(room(model="metal", reflectance=0.999, roughness=roughness))
        self.expect_finite_render(room(model="matte", reflectance=1))
        self.expect_finite_render(room(model="matte", reflectance=0))

    def test_methods(self):
        for method in ("ups", "bpt", "pt", "lt", "ppm", "sppm", "bpm"):
            self.expect_finite_render(room([1e-6, 1e9], model="metal", reflectance=0.9, roughness=0.01), "--method", method)

    def test_goniometer(self):
        for flux in (1e-6, 1e9):
            fixture = test_goniometer.fixture()
            fixture["ups"]["fixture"]["parts"][0]["emitter"]["flux_lm"] = flux
            scene = self.write("cone.gltf", test_goniometer.scene_of(
                {"name": "cone", "rotation": test_program.UP, "extras": fixture},
                test_goniometer.goniometer("photometry", c_step_deg=90, gamma_step_deg=10)))
            for ending in ("ies", "ldt"):
                done = self.run_program("goniometer", scene, "--iterations", 32, "--out", self.path(f"{flux:g}.{ending}"))
                self.expect_finite("standard output", done.stdout)
        self.assertEqual(self.expect_finite_files(self.folder.name), 4)


if __name__ == "__main__":
    test_program.PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
