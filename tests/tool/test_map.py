"""Maps of meters and images: `ups render --out` and `ups map`. Usage: test_map.py PATH_TO_UPS [unittest options]"""
import os
import re
import sys
import unittest
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../samples/scenes_common"))
import need_numpy  # noqa: E402,F401
import numpy as np  # noqa: E402
import test_program  # noqa: E402
from exr import read_channels  # noqa: E402
from test_compare import write_exr  # noqa: E402
from test_info import png_size  # noqa: E402

SVG = "{http://www.w3.org/2000/svg}"
HEADER = "x_m,y_m,z_m,nx,ny,nz,illuminance_lx,standard_error_lx,bias_lx,error_bound_lx,direct_lx,indirect_lx\n"


def table(points):
    """Of (x, y, z, lx, bound), facing up."""
    return HEADER + "".join(f"{x},{y},{z},0,0,1,{lx},1,0,{bound},{lx},0\n" for x, y, z, lx, bound in points)


class Maps(test_program.ProgramTest):
    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def svg(self, name):
        """Title and description."""
        root = ElementTree.fromstring(self.read(name))
        self.assertEqual((root.tag, root.get("role")), (SVG + "svg", "img"))
        return root.find(SVG + "title").text, root.find(SVG + "desc").text

    def grid(self):
        return self.write("plane.csv", table([(0.5 * c, 0.5 * r, 0.8, 400 + 10 * c + r, 15)
                                              for r in range(12) for c in range(16)]))

    def test_a_render_draws_them_and_map_draws_the_same_again(self):
        scene, out = self.write("room.gltf", test_program.room()), self.path("out")
        self.run_program("render", scene, "--iterations", 32, "--out", out)
        again = [self.path("again" + ending) for ending in (".png", ".svg", ".pdf")]
        self.run_program("map", os.path.join(out, "work_plane.csv"), *again, "--scene", scene, "--title", "work_plane")
        self.assertEqual(self.read("out/work_plane.png")[:4], b"\x89PNG")
        title, told = self.svg("out/work_plane.svg")
        self.assertEqual(title, "Illuminance: work_plane")
        self.assertRegex(told, r"^Illuminance, lx: work_plane. mean \d.* U0 0\.\d.*lines at .* lx\.$")
        self.assertEqual(png_size(self.read("again.png")), png_size(self.read("out/work_plane.png")))
        for kind, unit in (("luminance", "cd/m\u00b2"), ("illuminance", "lx")):
            self.assertIn(unit, self.svg(f"out/view_{kind}.svg")[1])
            options = ["--illuminance"] if kind == "illuminance" else []
            self.run_program("map", os.path.join(out, "view.exr"), self.path("view.png"), *options)
            self.assertEqual(self.read("view.png"), self.read(f"out/view_{kind}.png"))
            self.assertNotIn("U0", self.svg(f"out/view_{kind}.svg")[1])
        self.run_program("map", os.path.join(out, "work_plane.exr"), self.path("grid.svg"))
        self.assertRegex(self.svg("grid.svg")[1], r", U0 0\.\d")

    def test_sizes_and_page(self):
        self.run_program("map", self.grid(), *(self.path("map" + e) for e in (".png", ".svg", ".pdf")))
        root = ElementTree.fromstring(self.read("map.svg"))
        width, height = (float(root.get(side).removesuffix("px")) for side in ("width", "height"))
        self.assertLessEqual(width, 680)   # 180 mm
        self.assertLessEqual(height, 570)  # half a page of A4
        self.assertEqual(png_size(self.read("map.png")), (round(2 * width), round(2 * height)))
        pdf = self.read("map.pdf")
        self.assertEqual(pdf[:5], b"%PDF-")
        box = re.search(rb"/MediaBox \[ *0 0 ([\d.]+) ([\d.]+) *\]", pdf)
        for side, size in zip(box.groups(), (width, height)):
            self.assertAlmostEqual(float(side), 0.75 * size, delta=0.01)

    def test_a_table_from_a_spreadsheet(self):
        """Written again with a byte order mark and line ends of Windows: the same drawing."""
        with open(self.grid(), encoding="utf-8") as file:
            text = file.read()
        self.run_program("map", self.path("plane.csv"), self.path("as_written.svg"))
        os.mkdir(self.path("again"))  # of the same name, which is the drawing's title
        with open(self.path("again/plane.csv"), "w", encoding="utf-8-sig", newline="\r\n") as file:
            file.write(text)
        self.run_program("map", self.path("again/plane.csv"), self.path("again.svg"))
        self.assertEqual(self.read("again.svg"), self.read("as_written.svg"))

    def test_scales_ranges_and_verdicts(self):
        file = self.grid()
        told = {}
        for name, options in (("linear", []), ("log", ["--map-scale", "log"]), ("range", ["--map-range", "100:900"]),
                              ("verdict", ["--map-threshold", "500"]), ("grey", ["--map-colours", "grey"]),
                              ("cells", ["--map-cells"])):
            self.run_program("map", file, self.path(name + ".svg"), self.path(name + ".png"), *options)
            told[name] = self.svg(name + ".svg")[1]
        self.assertEqual(len({self.read(name + ".png") for name in told}), 6)
        self.assertIn("lines at 400, 420, 440, 460, 480, 500, 520, 540, 560, 580 lx", told["linear"])
        self.assertIn("lines at 100, 200, 300, 400, 500, 600, 700, 800, 900 lx", told["range"])
        values = [400 + 10 * c + r for r in range(12) for c in range(16)]
        met, not_met = sum(v - 15 >= 500 for v in values), sum(v + 15 < 500 for v in values)
        self.assertIn(f"is met at {met}, not sure at {192 - met - not_met}, not met at {not_met}.", told["verdict"])

    def test_lines_of_a_grids_image_are_those_of_its_table(self):
        """One meter of 1000 lx among 300: lines at 500, 600, 700, 800 and 900 go around it."""
        lux = [[1000 if (r, c) == (5, 7) else 300 for c in range(16)] for r in range(12)]
        file = self.write("grid.csv", table([(0.5 * c, 0.5 * r, 0.8, lux[r][c], 15)
                                             for r in range(12) for c in range(16)]))
        write_exr(self.path("grid.exr"), 16, 12, {"Y": [v for row in reversed(lux) for v in row]})
        told = {}
        for name in (file, self.path("grid.exr")):
            self.run_program("map", name, self.path("grid.svg"), "--map-range", "500:1500")
            told[name] = re.sub(", 95 % bound of the worst value [0-9.]+ %", "", self.svg("grid.svg")[1])
            lines = re.findall(rb'stroke-opacity[:=]"?0\.9[;"]', self.read("grid.svg"))
            self.assertGreaterEqual(len(lines), 5, msg=name)
        self.assertEqual(len(set(told.values())), 1, msg=told)

    def test_hatching_takes_no_more_room_than_the_map(self):
        """Of cells that are not sure, scattered as noise has them: a line each would write all cells anew each."""
        rng = np.random.default_rng(3)
        file = self.write("noisy.csv", table([(0.1 * c, 0.1 * r, 0.8, lx, 15) for r in range(60) for c in range(60)
                                              for lx in [rng.choice([450, 495, 505, 600])]]))
        self.run_program("map", file, self.path("map.svg"), "--map-threshold", 500)
        self.assertRegex(self.svg("map.svg")[1], r"not sure at 1[78]\d\d")
        self.assertLess(self.read("map.svg").count(b"<clipPath"), 20)

    def test_verdicts_of_images(self):
        """By each pixel's bound: as many of each as the image's own numbers say; without a bound nothing is sure."""
        scene, out = self.write("room.gltf", test_program.room()), self.path("out")
        self.run_program("render", scene, "--iterations", 32, "--out", out, "--map-threshold", 3,
                         "--map-threshold-luminance", 0.5)
        pixels, names = read_channels(os.path.join(out, "view.exr"))
        plane = {name: pixels[:, i] for i, name in enumerate(names)}
        luminance = 0.2126 * plane["R"] + 0.7152 * plane["G"] + 0.0722 * plane["B"]
        images = {"luminance": (luminance, plane["error_bound.Y"], 0.5),
                  "illuminance": (plane["illuminance.Y"], plane["error_bound.illuminance.Y"], 3)}
        for kind, (value, bound, least) in images.items():
            known = bound >= 0
            met, not_met = (known & (value - bound >= least)).sum(), (known & (value + bound < least)).sum()
            told = self.svg(f"out/view_{kind}.svg")[1]
            counts = {word: int(count) for word, count in re.findall(r"(not met|not sure|met) at (\d+)", told)}
            self.assertGreater(met, 0)
            self.assertGreater(not_met, 0)
            for word, count in (("met", met), ("not met", not_met), ("not sure", value.size - met - not_met)):
                self.assertAlmostEqual(counts.get(word, 0), count, delta=2, msg=(kind, word, told))  # float's rounding
        image, drawing = os.path.join(out, "view.exr"), self.path("view.svg")
        self.run_program("map", image, drawing, "--map-threshold-luminance", 0.5, "--title", "view")
        self.assertEqual(self.svg("view.svg")[1], self.svg("out/view_luminance.svg")[1])
        self.run_program("map", image, drawing, "--illuminance", "--map-threshold", 3, "--title", "view")
        self.assertEqual(self.svg("view.svg")[1], self.svg("out/view_illuminance.svg")[1])
        self.expect_failure("map", image, drawing, "--map-threshold", 3, words=["--map-threshold-luminance", "cd/m2"],
                            code=2)
        self.expect_failure("map", image, drawing, "--illuminance", "--map-threshold-luminance", 3, words=["lux"],
                            code=2)
        grid = os.path.join(out, "work_plane.exr")
        self.run_program("map", grid, drawing, "--map-threshold", 3)
        self.assertRegex(self.svg("view.svg")[1], r"Of 8 values, 3 lx is .*met at ")

    def test_a_fisheye_is_of_its_image_circle(self):
        """The render's own drawing and that of its file are the same (before: the black corners counted as dark)."""
        room = test_program.room()
        room["nodes"][4]["extras"]["ups"].update(width=24, height=24, projection="equidistant")
        out = self.path("out")
        self.run_program("render", self.write("room.gltf", room), "--iterations", 16, "--out", out)
        self.run_program("map", os.path.join(out, "view.exr"), self.path("view.svg"), "--title", "view")
        self.assertEqual(self.read("view.svg"), self.read("out/view_luminance.svg"))
        self.run_program("map", os.path.join(out, "view.exr"), self.path("view.svg"), "--title", "view",
                         "--illuminance")
        self.assertEqual(self.read("view.svg"), self.read("out/view_illuminance.svg"))

    def test_a_single_row_column_or_cell_is_a_grid(self):
        """Of which `ups render` draws maps, too."""
        for columns, rows in ((5, 1), (1, 5), (2, 1), (1, 1)):
            places = [(0.5 * x, 0.5 * y, 0, 100 + x + y, 2) for y in range(rows) for x in range(columns)]
            self.run_program("map", self.write("row.csv", table(places)), self.path("row.svg"))
            self.assertIn("U0", self.svg("row.svg")[1], msg=(columns, rows))

    def test_the_mean_of_a_surface_is_by_area(self):
        """As the program tells it of a render; of points it is by their number."""
        rows = [(0, 0, 0, 100, 2, 10)] + [(1 + 0.1 * i, i % 2, 0, 500, 2, 0.005) for i in range(9)]
        lines = table([row[:5] for row in rows]).splitlines()
        by_area = [lines[0] + ",triangle,area_m2"] + [f"{line},{i},{row[5]}"
                                                      for i, (line, row) in enumerate(zip(lines[1:], rows))]
        for text, mean, uniformity in (("\n".join(by_area), "mean 101.8 lx", "U0 0.982"),
                                       ("\n".join(lines), "mean 460 lx", "U0 0.217")):
            self.run_program("map", self.write("floor.csv", text), self.path("floor.svg"))
            told = self.svg("floor.svg")[1]
            self.assertIn(mean, told)
            self.assertIn(uniformity, told)

    def test_vectors_are_told_as_such(self):
        lines = table([(x, y, 0, 100, 2) for y in range(3) for x in range(3)]).splitlines()
        text = "\n".join([lines[0] + ",vector_x_lx"] + [line + ",50" for line in lines[1:]])
        self.run_program("map", self.write("vectors.csv", text), self.path("vectors.svg"))
        self.assertEqual(self.svg("vectors.svg")[0], "Length of the light vector: vectors")

    def test_errors(self):
        file = self.grid()
        out = self.path("x.svg")
        for options, words in ((["--map-range", "5"], ["--map-range", "LOW:HIGH"]),
                               (["--map-range", "9:5"], ["--map-range"]), (["--map-scale", "cube"], ["--map-scale"]),
                               (["--map-scale", "log", "--map-range", "0:5"], ["above 0"]),
                               (["--map-scale", "log", "--map-range-luminance", "0:5"], ["above 0"]),
                               (["--map-threshold", "-3"], ["--map-threshold", "-3"])):
            error = self.run_program("map", file, out, *options, code=2).stderr
            for word in words:
                self.assertIn(word, error)
        self.expect_failure("map", file, out, "--illuminance", words=["--illuminance", "plane.csv", "table"], code=2)
        self.expect_failure("map", self.write("x.exr", "x"), out, "--scene", "gone.gltf", words=["--scene", "x.exr"],
                            code=2)
        self.run_program("map", file, self.path("x.gif"), code=2)
        self.run_program("map", file, code=2)
        broken = {"line 3: has 2 of the 12 fields": table([(0, 0, 0, 5, 1)]) + "1,0\n",
                  "no column": "a,b\n1,2\n", "no number": table([(0, 0, 0, "x", 1)]), "empty": "", "no meter": HEADER,
                  "one line": table([(x, 2 * x, 0, 5, 1) for x in (0, 1, 3)]),
                  "no plane": table([(0, 0, 0, 5, 1), (1, 0, 0, 5, 1), (0, 1, 0, 5, 1), (1, 1, 1, 5, 1),
                                     (2, 1, 5, 5, 1)])}
        for words, text in broken.items():
            bad = self.write("bad.csv", text)
            self.expect_failure("map", bad, out, words=["bad.csv", *words.split()])
        self.expect_failure("map", self.path("none.csv"), out, words=["none.csv"])
        self.expect_failure("map", self.path("none.exr"), out, words=["none.exr"])
        self.expect_failure("map", self.write("t.txt", "x"), out, words=["t.txt", ".csv"])
        self.expect_failure("map", file, self.path("no/x.pdf"), words=["x.pdf"])
        self.assertFalse(os.path.exists(out))


if __name__ == "__main__":
    test_program.PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
