"""`ups info` of photometric files (page, table, folder, JSON, plots) and `ups convert`. Usage:
test_info.py PATH_TO_UPS [unittest options]"""
import json
import math
import os
import re
import struct
import sys
import unittest
import xml.etree.ElementTree as ElementTree
import zlib

import test_program

HERE = os.path.dirname(os.path.abspath(__file__))
PROFILES = os.path.join(HERE, "..", "..", "photometry", "data")
DATA = os.path.join(HERE, "..", "photometry", "data")
SVG = "{http://www.w3.org/2000/svg}"


def ies(gammas, candelas, opening="0 0 0", lumens=-1, watts=10, keywords="[MANUFAC] this project"):
    """An axially symmetric lamp."""
    return (f"IESNA:LM-63-2002\n[TEST] none\n{keywords}\nTILT=NONE\n1 {lumens} 1 {len(gammas)} 1 1 2 {opening}\n"
            f"1 1 {watts}\n" + " ".join(map(str, gammas)) + "\n0\n" + " ".join(map(str, candelas)) + "\n")


LAMBERTIAN = ies(range(0, 91, 5), [1000 * math.cos(math.radians(g)) for g in range(0, 91, 5)], "-0.2 -0.2 0", 4000)


def png_size(data):
    """Width and height of an 8-bit RGB PNG whose data unpack to that."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    width, height, depth, kind = struct.unpack(">IIBB", data[16:26])
    assert (depth, kind) == (8, 2)
    at, packed = 8, b""
    while at < len(data):
        size, name = struct.unpack(">I4s", data[at:at + 8])
        if name == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += 12 + size
    raw = zlib.decompress(packed)
    assert len(raw) == height * (1 + 3 * width)
    return width, height


def tm25(rays):
    """A ray file of x, y, z in mm, a direction and lumens each."""
    head = b"TM25" + struct.pack("<iiffQ", 2013, 0, math.nan, math.nan, len(rays)) + b"2026-01-01T00:00:00"
    head = head.ljust(256, b"\0") + struct.pack("<8i", 1, 1, 0, 0, 1, 0, 0, 0)
    return head.ljust(36288, b"\0") + b"".join(struct.pack("<7f", *ray) for ray in rays)


def narrow_rays(count):
    """100 lm evenly in a cone of 3 degrees about the nadir, by the golden angle: without chance."""
    rays = []
    for i in range(count):
        z = 1 - (i + 0.5) / count * (1 - math.cos(math.radians(3)))
        s, c = math.sqrt(1 - z * z), math.radians(137.50776405 * i)
        rays.append((5 * math.cos(i), 5 * math.sin(i), 0, s * math.cos(c), s * math.sin(c), -z, 100 / count))
    return rays


class Info(test_program.ProgramTest):
    def info(self, *arguments, code=0):
        done = self.run_program("info", *arguments, "--json", code=code)
        return json.loads(done.stdout)["files"]

    def test_numbers_of_a_lambertian_disc(self):
        (lamp,) = self.info(self.write("lamp.ies", LAMBERTIAN))
        area = math.pi * 0.01
        self.assertAlmostEqual(lamp["flux_lm"], 1000 * math.pi, delta=1e-3)
        self.assertEqual(lamp["down_flux_lm"], lamp["flux_lm"])
        self.assertEqual(lamp["up_flux_lm"], 0)
        self.assertEqual(lamp["peak_cd"], 1000)
        self.assertAlmostEqual(lamp["light_output_ratio"], math.pi / 4, delta=1e-6)
        self.assertAlmostEqual(lamp["efficacy_lm_per_w"], 100 * math.pi, delta=1e-3)
        for plane in ("c0_c180", "c90_c270"):
            self.assertAlmostEqual(lamp["beam"][plane]["angle_deg"], 120, delta=1e-4)
            self.assertAlmostEqual(lamp["beam"][plane]["to_deg"], 60, delta=1e-4)
            self.assertEqual(lamp["beam"][plane]["peak_deg"], 0)
        zones = {(z["from_deg"], z["to_deg"]): z["flux_lm"] for z in lamp["zonal_flux"]}
        self.assertEqual(set(zones), {(0, 30), (0, 40), (0, 60), (0, 90), (90, 180)})
        for (start, end), flux in zones.items():  # the band rule is exact for cos(gamma) on even steps
            if end <= 90:
                self.assertAlmostEqual(flux, 1000 * math.pi * math.sin(math.radians(end)) ** 2, delta=1e-2)
        self.assertEqual([row["c_deg"] for row in lamp["luminance"]], [0, 90, 180, 270])
        for row in lamp["luminance"]:
            for value in row["luminance_cd_m2"]:
                self.assertAlmostEqual(value, 1000 / area, delta=1)
        self.assertEqual(lamp["opening"], {"shape": "disc", "size_m": [0.2, 0.2, 0]})
        self.assertIn({"name": "MANUFAC", "value": "this project"}, lamp["keywords"])
        self.assertEqual(lamp["warnings"], [])

    def test_a_scene_without_geometry_has_no_bounds(self):
        scene = test_program.room()
        for nodes, low, high in (([1, 3], None, None), ([0, 1, 3], [-2, -2, 0], [2, 2, 0])):
            scene["scenes"][0]["nodes"] = nodes
            (told,) = self.info(self.write("room.gltf", scene))
            self.assertEqual(told["triangles"], 2 if 0 in nodes else 0)
            self.assertEqual((told["bounds_min_m"], told["bounds_max_m"]), (low, high))

    def test_page(self):
        text = self.run_program("info", self.write("lamp.ies", LAMBERTIAN)).stdout
        for words in ("flux: 3141.59 lm", "light output ratio: 78.5 %", "luminous efficacy: 314.2 lm/W",
                      "beam angle (50 % of the plane's peak): C0-C180 120.0 deg, C90-C270 120.0 deg",
                      "0-30 deg 785.398 (25.0 %)", "90-180 deg 0 (0.0 %)", "mean luminance", "31831"):
            self.assertIn(words, text)
        # An absolute point source that is the same everywhere has no ratio, no beam and no luminance.
        text = self.run_program("info", self.write("all.ies", ies([0, 90, 180], [7, 7, 7]))).stdout
        self.assertIn("beam angle (50 % of the plane's peak): C0-C180 none, C90-C270 none", text)
        self.assertIn("absolute photometry", text)
        for words in ("luminance of the opening", "light output ratio"):
            self.assertNotIn(words, text)

    def test_data_sheet(self):
        path = self.write("lamp.ies", LAMBERTIAN)
        (lamp,) = self.info(path)
        sheet = lamp["data_sheet"]
        for value, expected in zip(sheet["flux_code"], (43.75, 75, 93.75, 100, 78.54)):
            self.assertAlmostEqual(value, expected, delta=0.3)
        self.assertAlmostEqual(sheet["high_luminance"]["luminance_cd_m2"][0], 31831, delta=40)
        self.assertAlmostEqual(sheet["spacing_criterion"]["c0_c180"], 1.29, delta=0.01)
        self.assertAlmostEqual(sheet["spacing_criterion"]["diagonal"], 1.41, delta=0.01)
        self.assertEqual(sheet["nema_type"], {"horizontal": 7, "vertical": 7})
        self.assertEqual([sheet["bug"][k] for k in ("backlight", "uplight", "glare", "type_v")], [1, 0, 1, True])
        table = sheet["ugr_table"]
        self.assertEqual((table["lamp_flux_lm"], table["reflectances"][0]), (4000, "70/50/20"))
        self.assertEqual(len(table["rooms"]), 19)
        room = table["rooms"][10]
        self.assertEqual(room["room"], "4H 8H")
        self.assertAlmostEqual(room["crosswise"][0], room["endwise"][0], delta=0.02)
        self.assertEqual(len(sheet["utilisation"]["rooms"]), 10)
        self.assertEqual(sheet["candela"][0]["intensity_cd"][0], 1000)
        self.assertAlmostEqual(sum(z["flux_lm"] for z in sheet["zonal_flux"]), lamp["flux_lm"], delta=0.01)
        text = self.run_program("info", path).stdout
        for words in ("CIE flux code: 44 75 94 100 79", "NEMA type: 7 x 7", "BUG rating: B1 U0 G1",
                      f"  4H 8H {room['crosswise'][0]:12.1f}", "room index", "  90   "):
            self.assertIn(words, text)
        rows = [line.split(",") for line in self.run_program("info", "--csv", path).stdout.splitlines()]
        self.assertEqual(rows[0], ["file", "table", "row", "column", "value"])
        self.assertTrue(all(len(row) == 5 and float(row[4]) is not None for row in rows[1:]))
        value = {tuple(row[1:4]): float(row[4]) for row in rows[1:]}
        self.assertAlmostEqual(value["ugr_endwise", "4H 8H", "70/50/20"], room["endwise"][0], delta=1e-4)
        self.assertEqual(value["candela", "0", "C0"], 1000)
        self.run_program("info", "--csv", "--json", path, code=2)

    def test_data_sheet_without_an_opening(self):
        path = self.write("all.ies", ies([0, 90, 180], [7, 7, 7]))
        (lamp,) = self.info(path)
        self.assertNotIn("ugr_table", lamp["data_sheet"])
        self.assertEqual(lamp["data_sheet"]["high_luminance"]["highest_cd_m2"], -1)
        self.assertIn("UGR table: none", self.run_program("info", path).stdout)
        scene = self.write("room.gltf", test_program.room())
        self.assertIn("--csv", self.run_program("info", "--csv", scene, code=1).stderr)

    def test_folder_is_a_sorted_table_that_survives_broken_files(self):
        for name, content in (("b.IES", LAMBERTIAN), ("a.ies", ies([0, 90, 180], [7, 7, 7])), ("notes.txt", "no"),
                              ("c.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 2")):
            self.write(name, content)
        os.mkdir(self.path("folder.ies"))
        done = self.run_program("info", self.folder.name, code=1)
        lines = done.stdout.splitlines()
        self.assertEqual([line.split()[0] for line in lines], ["file", "a.ies", "b.IES", "c.ies"])
        self.assertIn("3141.59", lines[2])
        self.assertIn("120.0", lines[2])
        self.assertRegex(lines[3], r"^c\.ies\s+error: line 3: ")
        self.assertRegex(done.stderr, r"ups: error: .*c\.ies: line 3: ")
        files = self.info(self.folder.name, code=1)
        self.assertEqual([os.path.basename(f["file"]) for f in files], ["a.ies", "b.IES", "c.ies"])
        self.assertIn("line 3", files[2]["error"])
        self.assertNotIn("error", files[1])

    def test_several_files_may_be_of_any_kind(self):
        lamp, scene = self.write("lamp.ies", LAMBERTIAN), self.write("room.gltf", test_program.room())
        lines = self.run_program("info", lamp, scene, self.path("gone.ldt"), code=1).stdout.splitlines()
        self.assertEqual([line.split()[0] for line in lines], ["file", "lamp.ies", "room.gltf", "gone.ldt"])
        self.assertIn("glTF scene", lines[2])
        files = self.info(lamp, scene)
        self.assertEqual([f["kind"] for f in files], ["photometry", "scene"])
        self.assertEqual(files[1]["triangles"], 2)
        self.assertEqual([s["name"] for s in files[1]["sensors"]], ["work_plane", "spot", "view"])
        (broken,) = self.info(self.path("gone.ies"), code=1)
        self.assertIn("gone.ies", broken["error"])

    def test_folders_are_searched_in_depth(self):
        os.makedirs(self.path("shop/rails/deep"))
        os.makedirs(self.path("shop/a"))
        for name in ("shop/b.ies", "shop/rails/a.ies", "shop/rails/deep/a.ies", "shop/a/z.ldt"):
            self.write(name, LAMBERTIAN)
        self.write("elsewhere.ies", LAMBERTIAN)
        os.symlink("..", self.path("shop/rails/loop"))
        os.symlink(self.path("elsewhere.ies"), self.path("shop/link.ies"))
        names = ["a/z.ldt", "b.ies", "link.ies", "rails/a.ies", "rails/deep/a.ies"]
        self.assertEqual([os.path.relpath(f["file"], self.path("shop")) for f in self.info(self.path("shop"))], names)
        lines = self.run_program("info", self.path("shop")).stdout.splitlines()
        self.assertEqual([line.split()[0] for line in lines], ["file", *names])

    def test_a_file_is_read_by_its_content(self):
        ldt = os.path.join(DATA, "l04_isym3.ldt")
        with open(ldt, "rb") as file:
            content = file.read()
        (right,) = self.info(ldt)
        for name, warnings in (("x.ies", 1), ("x.txt", 0), ("x", 0), ("x.xml", 1), ("x.ldt", 0)):
            (other,) = self.info(self.write(name, content))
            self.assertEqual({k: v for k, v in other.items() if k not in ("file", "warnings")},
                             {k: v for k, v in right.items() if k not in ("file", "warnings")})
            new = other["warnings"][len(right["warnings"]):]
            self.assertEqual(len(new), warnings)
            for warning in new:
                self.assertIn(f"its name ends in {name[1:]}, but it is EULUMDAT by its content", warning)
        (lamp,) = self.info(self.write("lamp.ldt", LAMBERTIAN))
        self.assertEqual(lamp["format"], "IES LM-63-2002")
        (scene,) = self.info(self.write("scene.json", test_program.room()))
        self.assertEqual(scene["kind"], "scene")
        # What neither its content nor its name makes a file of: both readings are told.
        (broken,) = self.info(self.write("broken.ldt", "nothing\n"), code=1)
        self.assertIn("TILT", broken["error"])
        self.assertIn("read as what its name says, .ldt: ", broken["error"])

    def test_control_characters_never_reach_a_terminal(self):
        steering = "a\x1b[31mred\x07\x7f\x9b\u202e\ttab"
        lamp = self.write("l\x1b[2Jamp.ies", LAMBERTIAN.replace("this project", steering))
        scene = test_program.room()
        scene["nodes"][0]["name"] = "n\x1bode"
        scene["nodes"][0]["skin"] = 0
        scene["nodes"][0]["extensions"] = {"X\x1b[5m": {}}
        scene = self.write("room.gltf", scene)
        bad = self.write("b\x1bad.ies", "IESNA:LM-63-2002\nTILT=NONE\nx\x1b[1my 1 1\n")
        for arguments, code in ((["info", lamp], 0), (["info", lamp, bad], 1), (["info", bad], 1), (["info", scene], 0),
                                (["convert", bad, self.path("o.ldt")], 1), (["render", "\x1b[1m", "\x1b]"], 2),
                                (["info", lamp, "--json"], 0), (["info", lamp, bad, "--json"], 1),
                                (["render", scene, "--iterations", "16"], 0)):
            done = self.run_program(*arguments, code=code)
            for text in (done.stdout, done.stderr):
                raw = [c for c in text if (ord(c) < 32 and c != "\n") or 127 <= ord(c) < 160 or c == "\u202e"]
                self.assertEqual(raw, [], msg=(arguments, text))
        text = self.run_program("info", lamp).stdout
        self.assertIn("MANUFAC=a\\x1b[31mred\\x07\\x7f\\x9b\\u202e\\x09tab", text)
        self.assertIn("n\\x1bode", self.run_program("info", scene).stdout)
        (file,) = self.info(lamp)  # JSON means the same characters
        self.assertIn({"name": "MANUFAC", "value": steering}, file["keywords"])
        self.assertEqual(file["file"], lamp)

    def test_lamp_sets(self):
        (file,) = self.info(os.path.join(DATA, "l04_isym3.ldt"))
        self.assertEqual(file["lamp_set_count"], len(file["lamp_sets"]))
        lines = ["maker", "1", "1", "1", "0", "2", "90", "report", "name", "number", "file", "date", "100", "0", "0",
                 "0", "0", "0", "0", "0", "0", "100", "80", "1", "0", "2"]
        lines += ["1", "LED", "1000", "3000", "80", "11.5", "2", "T5 lamp", "5000", "warm white", "1B", "60"]
        lines += ["0"] * 10 + ["0", "0", "90", "300", "0"]
        two = self.write("two.ldt", "\n".join(lines) + "\n")
        (file,) = self.info(two)
        self.assertEqual(file["lamp_sets"], [
            {"count": 1, "type": "LED", "flux_lm": 1000, "input_power_w": 11.5, "colour_temperature_k": 3000,
             "colour_rendering_index": 80, "colour": "3000", "colour_rendering": "80", "chosen": True},
            {"count": 2, "type": "T5 lamp", "flux_lm": 5000, "input_power_w": 60, "colour_temperature_k": -1,
             "colour_rendering_index": -1, "colour": "warm white", "colour_rendering": "1B", "chosen": False}])
        text = self.run_program("info", two).stdout
        self.assertIn("lamp sets: 2, alternatives\n  1: 1 x LED, 1000 lm, 11.5 W, 3000 K, CRI 80 (taken)\n"
                      "  2: 2 x T5 lamp, 5000 lm, 60 W, colour warm white, colour rendering 1B\n", text)
        text = self.run_program("info", self.write("a.ies", LAMBERTIAN)).stdout
        self.assertIn("lamps: 1 x lamp, 4000 lm, 10 W\n", text)

    def test_axes_of_openings(self):
        # LM-63-2002, table 1: width along C90, length along C0, height; -: a curved side.
        for opening, axis, words in (("0 0.5 0", "x", "line 0.5 m along x"), ("0.5 0 0", "y", "line 0.5 m along y"),
                                     ("-0.1 -0.1 0.4", "z", "cylinder 0.1 x 0.1 x 0.4 m along z"),
                                     ("-0.1 0.4 -0.1", "x", "cylinder 0.4 x 0.1 x 0.1 m along x"),
                                     ("0.4 -0.1 -0.1", "y", "cylinder 0.1 x 0.4 x 0.1 m along y")):
            lamp = self.write("lamp.ies", ies([0, 90], [100, 0], opening))
            (file,) = self.info(lamp)
            self.assertEqual(file["opening"].get("axis"), axis, msg=opening)
            self.assertIn("opening: " + words, self.run_program("info", lamp).stdout)
        (file,) = self.info(self.write("lamp.ies", ies([0, 90], [100, 0], "0.5 0.2 0")))
        self.assertNotIn("axis", file["opening"])

    def test_folders_without_photometry(self):
        os.mkdir(self.path("empty"))
        self.expect_failure("info", self.path("empty"), words=["empty", ".ies"])

    def test_a_tilt_file_is_found_beside_whatever_its_case(self):
        lamp = ("IESNA:LM-63-1995\n[TEST] none\n[MANUFAC] x\nTILT=Lamp.TLT\n"
                "1 -1 1 3 1 1 2 0 0 0\n1 1 10\n0 45 90\n0\n9 9 9\n")
        path = self.write("lamp.ies", lamp)
        (without,) = self.info(path)
        self.write("lamp.tlt", "1\n3\n0 45 90\n1 0.9 0.8\n")
        (given,) = self.info(path)
        self.assertNotEqual(without["warnings"], given["warnings"])
        self.assertEqual(given["flux_lm"], without["flux_lm"])  # the factors hold for a tilted luminaire alone
        self.write("lamp.tlt", "1\n3\n0 45\n")
        (broken,) = self.info(path, code=1)
        self.assertIn("lamp.ies", broken["error"])

    def test_types_that_other_programs_mix_up(self):
        files = self.info(os.path.join(DATA, "s08_typeC_asym.ies"), os.path.join(DATA, "s09_typeB_asym.ies"),
                          os.path.join(DATA, "s10_typeA_asym.ies"))
        self.assertEqual([f["photometric_type"] for f in files], ["C", "B", "A"])
        for other in files[1:]:
            for plane in ("c0_c180", "c90_c270"):
                for key in ("from_deg", "to_deg"):
                    self.assertAlmostEqual(other["beam"][plane][key], files[0]["beam"][plane][key], delta=0.15)


class Plots(test_program.ProgramTest):
    def plot(self, profile, *names):
        arguments = [word for name in names for word in ("--plot", self.path(name))]
        self.run_program("info", profile, *arguments)

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def texts(self, name):
        """What it says to those who cannot see it: its labels."""
        return ElementTree.fromstring(self.read(name)).find(SVG + "desc").text.splitlines()

    def paths(self, name, ink, width):
        """Points of the lines of that ink and width, in the order they are drawn."""
        def is_wanted(path):
            style = {key: path.get(key) for key in ("stroke", "stroke-width")}
            style.update(word.strip().split(":") for word in path.get("style", "").split(";") if ":" in word)
            shares = re.findall(r"([\d.]+)%", style["stroke"] or "")
            rgb = "#" + "".join(f"{round(2.55 * float(share)):02x}" for share in shares)
            return rgb == ink and float(style["stroke-width"]) == float(width)
        return [[tuple(map(float, point.split())) for point in p.get("d").strip()[1:].split("L")]
                for p in ElementTree.fromstring(self.read(name)).iter(SVG + "path") if is_wanted(p)]

    def test_svg_and_png(self):
        self.plot(os.path.join(PROFILES, "wall_washer.ies"), "washer.svg", "washer.png", "washer.pdf", "again.pdf")
        root = ElementTree.fromstring(self.read("washer.svg"))
        self.assertEqual(root.tag, SVG + "svg")
        width, height = (float(root.get(side).removesuffix("px")) for side in ("width", "height"))
        self.assertEqual(list(map(float, root.get("viewBox").split())), [0, 0, width, height])
        self.assertEqual(root.get("role"), "img")
        said = [root.find(SVG + "title"), root.find(SVG + "desc")]
        self.assertIn("wall_washer.ies", said[0].text)
        self.assertEqual(root.get("aria-labelledby").split(), [e.get("id") for e in said])
        self.assertEqual(png_size(self.read("washer.png")), (2 * width, 2 * height))
        pdf = self.read("washer.pdf")
        self.assertEqual(pdf, self.read("again.pdf"))  # without the time of day
        self.assertEqual(pdf[:5], b"%PDF-")
        box = re.search(rb"/MediaBox \[ *0 0 ([\d.]+) ([\d.]+) *\]", pdf)
        self.assertEqual([float(side) for side in box.groups()], [0.75 * width, 0.75 * height])  # points of pixels
        texts = self.texts("washer.svg")
        for words in ("wall_washer.ies", "Luminous intensity, cd", "C0-C180", "C90-C270", "180\u00b0", "30\u00b0"):
            self.assertIn(words, texts)
        self.assertTrue(any("800 lm" in t for t in texts), msg=texts)
        self.assertTrue(any("592.94 cd" in t for t in texts), msg=texts)

    def test_several_plots_of_several_files(self):
        lamp, wide = self.write("lamp.ies", LAMBERTIAN), self.write("wide.ies", ies([0, 60, 90], [9, 9, 9]))
        self.run_program("info", lamp, "--plot", self.path("a.svg"), self.path("b.png"))
        self.run_program("info", "--plot", self.path("c.svg"), self.path("d.png"), lamp)
        for name in ("a.svg", "c.svg"):
            self.assertIn("lamp.ies", self.texts(name))
        self.assertEqual(self.read("b.png"), self.read("d.png"))
        os.mkdir(self.path("more"))
        third = self.write("more/lamp.ies", LAMBERTIAN.replace("4000", "5000"))
        self.run_program("info", lamp, wide, third, "--plot", self.path("p.svg"), self.path("p.png"))
        for suffix, file in (("lamp", "lamp.ies"), ("wide", "wide.ies"), ("lamp_2", "lamp.ies")):
            self.assertIn(file, self.texts(f"p_{suffix}.svg"))
            self.assertEqual(self.read(f"p_{suffix}.png")[:4], b"\x89PNG")
        self.assertEqual(self.read("p_lamp.svg"), self.read("a.svg"))
        self.assertFalse(os.path.exists(self.path("p.svg")))

    def test_a_downlight_has_its_cone_in_numbers(self):
        self.plot(self.write("lamp.ies", LAMBERTIAN), "lamp.svg")
        texts = self.texts("lamp.svg")
        self.assertIn("Luminous intensity, cd/klm", texts)  # its lamps have 4000 lm
        self.assertIn("250", texts)                         # the ring of its peak
        self.assertIn("beam 120.0\u00b0", texts)
        self.assertNotIn("180\u00b0", texts)                # nothing shines up: half a circle
        self.assertIn(f"{2 * math.tan(math.radians(60)):.2f}", texts)  # as wide 1 m below
        self.assertIn("1000", texts)                        # lx there
        self.assertIn("62.5", texts)                        # 4 m below; at the edges 1 m below 500 cos^3(60 deg) too

    def test_what_has_no_cone_says_so(self):
        self.plot(self.write("all.ies", ies([0, 90, 180], [7, 7, 7])), "all.svg", "all.png")
        self.assertTrue(any(t.startswith("No cone") for t in self.texts("all.svg")))
        self.plot(self.write("dark.ies", ies([0, 90, 180], [0, 0, 0])), "dark.svg", "dark.png")
        texts = self.texts("dark.svg")
        for words in ("No cone: no light.", "no light", "beam no light"):
            self.assertIn(words, texts)

    def test_names_with_what_xml_reserves(self):
        lamp = self.write("a<b>&\"c\" \u00fc.ies", LAMBERTIAN.replace("this project", "R&D <x> \u00e9"))
        self.plot(lamp, "lamp.svg", "lamp.png")
        texts = self.texts("lamp.svg")
        self.assertIn("a<b>&\"c\" \u00fc.ies", texts)
        self.assertIn("R&D <x> \u00e9", texts)

    def test_the_plane_of_a_peak_beside_both_planes_is_drawn(self):
        # C0, C30, ... C330; the light around C210, gamma 40 alone: rings reach its 1300 cd, no other curve leaves zero.
        table = [[1300 if (c, g) == (210, 40) else 0 for g in range(0, 91, 10)] for c in range(0, 360, 30)]
        table.append(table[0])
        lamp = ("IESNA:LM-63-2002\n[TEST] none\n[MANUFAC] x\nTILT=NONE\n1 -1 1 10 13 1 2 0 0 0\n1 1 10\n"
                "0 10 20 30 40 50 60 70 80 90\n0 30 60 90 120 150 180 210 240 270 300 330 360\n")
        self.plot(self.write("aside.ies", lamp + "\n".join(" ".join(map(str, row)) for row in table) + "\n"),
                  "aside.svg", "aside.png")
        texts = self.texts("aside.svg")
        self.assertIn("C30-C210", texts)
        self.assertIn("1500", texts)
        curve = self.paths("aside.svg", "#008060", "2.2")[0]
        centre = self.paths("aside.svg", "#005caf", "2.2")[0][0]  # of a plane without light: a dot
        radius = max(math.hypot(x - centre[0], y - centre[1]) for x, y in curve)
        ring = max(math.hypot(x - centre[0], y - centre[1]) for x, y in self.paths("aside.svg", "#cdcdcd", "1.2")[0])
        self.assertAlmostEqual(radius / ring, 1300 / 1500, delta=1e-3)
        self.assertTrue(all(x <= centre[0] + 0.01 for x, y in curve))  # C210 is the far half: on the left
        self.plot(self.write("lamp.ies", LAMBERTIAN), "lamp.svg")
        self.assertEqual(self.paths("lamp.svg", "#008060", "2.2"), [])

    def test_both_wings_of_a_batwing(self):
        wings = ies(range(0, 91, 5), [100 + 900 * math.sin(math.radians(2 * g)) ** 2 for g in range(0, 91, 5)])
        lamp = self.write("wings.ies", wings)
        text = self.run_program("info", lamp).stdout
        self.assertRegex(text, r"C0-C180 \d+\.\d deg \(\d+\.\d to \d+\.\d\) in one of 2 lobes, C90")
        self.plot(lamp, "wings.svg")
        texts = self.texts("wings.svg")
        beam = next(b for b in texts if b.startswith("beam ") and "(" in b)
        start, end = beam[beam.index("(") + 1:-1].split(" to ")
        self.assertIn(f"C0-C180 in the table: one of 2 lobes, from {start}\u00b0 to {end}\u00b0", texts)
        edges = [line for line in self.paths("wings.svg", "#005caf", "2") if len(line) == 2]
        apex = edges[0][1]
        tangents = sorted((x - apex[0]) / (y - apex[1]) for line in edges for x, y in line if (x, y) != apex)
        self.assertEqual(len(tangents), 4)
        for left, right in zip(tangents[:2], reversed(tangents[2:])):
            self.assertAlmostEqual(left, -right, delta=1e-3)
        self.assertAlmostEqual(tangents[2] / tangents[3],
                               math.tan(math.radians(float(start))) / math.tan(math.radians(float(end))), delta=2e-3)
        # A ripple at half the peak is not a lobe; one lobe needs no note.
        ripple = self.write("ripple.ies", ies([0, 20, 40, 45, 50, 60, 90], [1000, 1000, 480, 530, 480, 20, 0]))
        self.assertNotIn("lobes", self.run_program("info", ripple).stdout)

    def test_a_plane_with_dust_has_no_light(self):
        planes = [[dust if c % 180 == 0 else 1000 if (c, g) == (90, 30) else 0 for g in range(0, 91, 10)]
                  for c in range(0, 361, 90) for dust in [1e-30 if c == 180 else 0]]
        lamp = ("IESNA:LM-63-2002\n[TEST] none\n[MANUFAC] x\nTILT=NONE\n1 -1 1 10 5 1 2 0 0 0\n1 1 10\n"
                "0 10 20 30 40 50 60 70 80 90\n0 90 180 270 360\n")
        lamp = self.write("dust.ies", lamp + "\n".join(" ".join(map(str, row)) for row in planes) + "\n")
        self.assertIn("C0-C180 no light, C90-C270 10.0 deg (25.0 to 35.0)", self.run_program("info", lamp).stdout)
        self.plot(lamp, "dust.svg")
        texts = self.texts("dust.svg")
        self.assertIn("beam no light", texts)
        self.assertIn("beam 10.0\u00b0 (25.0 to 35.0)", texts)
        self.assertEqual([p for p in self.paths("dust.svg", "#005caf", "2") if len(p) == 2], [])  # no cone of it

    def test_large_and_small_numbers_have_no_exponent(self):
        self.plot(self.write("pencil.ies", ies([0, 0.1, 0.2, 0.3, 90], [9e6, 5e6, 1e6, 0, 0])), "pencil.svg")
        texts = self.texts("pencil.svg")
        self.assertIn("Luminous intensity, Mcd", texts)
        for ring in ("2", "4", "6", "8", "10"):
            self.assertIn(ring, texts)
        self.assertTrue(any("peak 9 Mcd at" in t for t in texts), msg=texts)
        half = 0.1 + 0.1 * 0.5 / 4  # where 5e6 to 1e6 cd pass 4.5e6
        self.assertIn(f"{2 * math.tan(math.radians(half)):.4f}", texts)  # width 1 m below
        self.plot(self.write("faint.ies", ies([0, 90, 180], [2e-3, 2e-3, 2e-3])), "faint.svg")
        self.assertIn("Luminous intensity, mcd", self.texts("faint.svg"))
        for text in texts + self.texts("faint.svg"):
            self.assertNotRegex(text, r"\de[+-]\d")

    def test_accents_are_drawn(self):
        pictures = set()
        for name, maker in (("a", "\u00dcnic\u00f6de Stra\u00dfe"), ("b", "Unicode Strasse"), ("c", "Unicode Stra\u00dfe")):
            os.makedirs(self.path(name))
            lamp = self.write(name + "/lamp.ies", LAMBERTIAN.replace("this project", maker))
            self.plot(lamp, name + ".png")
            pictures.add(self.read(name + ".png"))
        self.assertEqual(len(pictures), 3)

    def test_a_needle_is_drawn_to_its_peak(self):
        self.plot(self.write("needle.ies", ies([0, 0.01, 0.02, 90], [900, 900, 0, 0])), "needle.svg")

        def heights(ink, width):  # of the one path of more than two points: not the legend's
            (points,) = [p for p in self.paths("needle.svg", ink, width) if len(p) > 2]
            return [y for x, y in points]

        lowest = max(heights("#005caf", "2.2"))
        bottom, top = max(heights("#cdcdcd", "1.2")), min(heights("#cdcdcd", "1.2"))
        self.assertAlmostEqual((lowest - top) / (bottom - top), 0.9, delta=0.01)  # 900 cd on rings up to 1000

    def test_errors(self):
        lamp = self.write("lamp.ies", LAMBERTIAN)
        for name in ("lamp.gif", "lamp"):
            self.assertIn(".svg", self.run_program("info", lamp, "--plot", self.path(name), code=2).stderr)
        self.run_program("info", "--plot", self.path("x.svg"), code=2)
        self.expect_failure("info", self.write("room.gltf", test_program.room()), "--plot", self.path("x.svg"),
                            words=["--plot", "room.gltf"])
        before = sorted(os.listdir(self.folder.name))
        for name in ("x.svg", "x.png", "x.pdf"):
            self.expect_failure("info", lamp, "--plot", self.path("no/" + name), words=[name])
            os.mkdir(self.path(name))
            self.expect_failure("info", lamp, "--plot", self.path(name), words=[name])
            os.rmdir(self.path(name))
        self.assertEqual(sorted(os.listdir(self.folder.name)), before)


class Convert(test_program.ProgramTest):
    def info(self, path):
        return json.loads(self.run_program("info", path, "--json").stdout)["files"][0]

    def test_both_ways_keep_the_distribution(self):
        for name in ("s08_typeC_asym.ies", "s18_90_270.ies", "l04_isym3.ldt", "s17_isotropic_10000lm.ies"):
            with self.subTest(name=name):
                first = self.info(os.path.join(DATA, name))
                self.run_program("convert", os.path.join(DATA, name), self.path("a.ldt"))
                self.run_program("convert", self.path("a.ldt"), self.path("b.ies"))
                for path, start in (("a.ldt", "EULUMDAT"), ("b.ies", "IES LM-63-2019")):
                    second = self.info(self.path(path))
                    self.assertEqual(second["format"], start)
                    # EULUMDAT rounds intensities to six characters: 5e-5 of the peak at most, far less in the sum.
                    self.assertAlmostEqual(second["flux_lm"], first["flux_lm"], delta=1e-5 * first["flux_lm"])
                    for plane in ("c0_c180", "c90_c270"):
                        self.assertAlmostEqual(second["beam"][plane]["angle_deg"], first["beam"][plane]["angle_deg"],
                                               delta=0.01)
                    self.assertEqual(second["opening"], first["opening"])

    def test_links_stay_and_lead_to_files_or_to_the_output(self):
        source = os.path.join(DATA, "s08_typeC_asym.ies")
        os.mkdir(self.path("there"))
        os.symlink(os.path.join("there", "lamp.ldt"), self.path("link.ldt"))
        os.symlink("/dev/stdout", self.path("output.ldt"))
        for _ in range(2):  # the file is not there yet; it is
            self.run_program("convert", source, self.path("link.ldt"))
            self.assertTrue(os.path.islink(self.path("link.ldt")))
            self.assertEqual(os.listdir(self.path("there")), ["lamp.ldt"])
        printed = self.run_program("convert", source, self.path("output.ldt")).stdout
        with open(self.path("there/lamp.ldt"), encoding="latin-1", newline="") as file:
            self.assertEqual(printed.splitlines(), file.read().splitlines())
        self.assertTrue(os.path.islink(self.path("output.ldt")))

    def test_rays_become_their_far_field(self):
        lamp = self.write("lamp.tm25ray", tm25(narrow_rays(5000)))
        first = self.info(lamp)
        self.assertAlmostEqual(first["flux_lm"], 100, delta=1e-4)
        self.assertAlmostEqual(first["down_flux_lm"] + first["up_flux_lm"], first["flux_lm"], delta=1e-9)
        self.assertTrue(any("is a sample of 5000 rays" in w for w in first["warnings"]))
        peak = 100 / (2 * math.pi * (1 - math.cos(math.radians(3))))
        # Rays without chance, but the highest of a table's nodes: what the intensity is the flux and the beam tell, to
        # 1e-6 and 0.7 %.
        self.assertAlmostEqual(first["peak_cd"] / peak, 1, delta=0.05)
        done = self.run_program("convert", lamp, self.path("lamp.ies"))
        self.assertIn("lamp.ies: a far-field table of the 5000 rays is written; where they start is lost", done.stderr)
        second = self.info(self.path("lamp.ies"))
        self.assertAlmostEqual(second["flux_lm"], 100, delta=0.1)
        for info in (first, second):
            for plane in ("c0_c180", "c90_c270"):
                self.assertAlmostEqual(info["beam"][plane]["angle_deg"], 6, delta=0.02)

    def test_losses_are_told(self):
        def told(source, target):
            lines = self.run_program("convert", source, self.path(target)).stderr.splitlines()
            return [line for line in lines if target in line]

        tilted = os.path.join(DATA, "s06_tilt_include.ies")
        self.assertEqual(len(told(tilted, "a.ldt")), 1)
        self.assertIn("the TILT table is lost", told(tilted, "a.ldt")[0])
        self.assertEqual(told(tilted, "a.ies"), [])
        ball = self.write("ball.ies", ies([0, 90, 180], [7, 7, 7], "-0.2 -0.3 -0.4"))
        self.assertIn("opening: ellipsoid 0.3 x 0.2 x 0.4 m", self.run_program("info", ball).stdout)
        seen, shape = sorted(told(ball, "b.ldt"), key=lambda line: "is written as" in line)
        self.assertIn("the opening, ellipsoid 0.3 x 0.2 x 0.4 m, is written as box 0.3 x 0.2 x 0.4 m", shape)
        self.assertRegex(seen, "the opening of the written file has .* that of the light")
        self.assertEqual(told(ball, "b.ies"), [])
        self.assertEqual(told(self.write("lamp.ies", LAMBERTIAN), "c.ldt"), [])

    def test_customs_of_planes_are_told(self):
        """The data sheet's front is another plane of the other format (the light itself stays where it was)."""
        source = os.path.join(DATA, "s08_typeC_asym.ies")
        told = [self.run_program("convert", *files).stderr for files in
                ((source, self.path("a.ldt")), (self.path("a.ldt"), self.path("b.ies")), (source, self.path("c.ies")))]
        self.assertIn("a.ldt: C planes keep their numbers, though customs differ: its data sheet takes C90 and not C0", told[0])
        self.assertIn("b.ies: C planes keep their numbers, though customs differ: its data sheet takes C0 and not C90", told[1])
        self.assertNotIn("customs", told[2])

    def test_light_that_parts_is_told(self):
        # A patch of 0.2 degrees far off the axis, which no step of 0.05 degrees of C and gamma follows.
        patch = self.write("patch.ies", "IESNA:LM-63-2002\n[TEST] x\nTILT=NONE\n1 -1 1 2 2 2 2 0 0 0\n1 1 10\n"
                                        "30 30.2\n20 20.2\n1000 1000\n1000 1000\n")
        before = self.info(patch)
        lines = self.run_program("convert", patch, self.path("patch.ldt")).stderr.splitlines()
        after = self.info(self.path("patch.ldt"))
        part = after["flux_lm"] / before["flux_lm"] - 1
        self.assertGreater(abs(part), 1e-3)
        told = [line for line in lines if "the flux of the written table" in line]
        self.assertEqual(len(told), 1)
        self.assertIn(f"{after['flux_lm']:.6g} lm, that of the light {before['flux_lm']:.6g} lm", told[0])

    def test_errors(self):
        lamp = self.write("lamp.ies", LAMBERTIAN)
        old = self.write("old.ldt", "kept")
        bright = self.write("bright.ies", "IESNA:LM-63-2002\n[TEST] x\nTILT=NONE\n1000 1e12 1 2 1 1 2 0 0 0\n1 1 1\n"
                                          "0 90\n0\n1 1\n")
        self.expect_failure("convert", bright, old, words=["old.ldt", "1e+15 lm"])
        with open(old, encoding="utf-8") as file:
            self.assertEqual(file.read(), "kept")
        os.remove(old)
        os.remove(bright)
        self.assertIn(".ldt", self.run_program("convert", lamp, self.path("lamp.txt"), code=2).stderr)
        self.run_program("convert", lamp, code=2)
        self.expect_failure("convert", lamp, self.path("lamp.ies"), words=["lamp.ies", "is the file that is read"])
        with open(lamp, encoding="utf-8") as file:
            self.assertEqual(file.read(), LAMBERTIAN)
        self.expect_failure("convert", self.path("gone.ies"), self.path("x.ldt"), words=["gone.ies"])
        self.expect_failure("convert", self.write("room.gltf", test_program.room()), self.path("x.ldt"),
                            words=["room.gltf"])
        self.expect_failure("convert", self.write("bad.ies", "TILT=NONE\n1 2"), self.path("x.ldt"), words=["bad.ies"])
        self.expect_failure("convert", lamp, self.path("no/x.ldt"), words=["x.ldt"])
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["bad.ies", "lamp.ies", "room.gltf"])


if __name__ == "__main__":
    test_program.PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
