"""`ups render --report` and `--targets`: what the page says, whether it is whole and safe, verdicts, wrong files.
Usage: test_report.py PATH_TO_UPS. In a browser and on paper: test_report_page.py."""
import base64
import html.parser
import json
import os
import re
import shlex
import struct
import subprocess
import sys
import unittest

import test_goniometer
import test_program

VOID = {"meta", "link", "img", "br", "hr", "input"}
NASTY = "lamp <script>alert(1)</script> & \"quotes\" 'too'"


class Page(html.parser.HTMLParser):
    """Elements of a page, and what is not in order about them."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.open, self.wrong, self.elements, self.text, self.sections = [], [], [], [], {}
        self.feed(text)
        self.close()
        self.wrong += [f"<{tag}> is never closed" for tag in self.open]

    def handle_starttag(self, tag, attributes):
        self.elements.append((tag, dict(attributes), list(self.open)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.elements.append((tag, dict(attributes), list(self.open)))

    def handle_endtag(self, tag):
        if not self.open or self.open[-1] != tag:
            self.wrong.append(f"</{tag}> within {self.open}")
        else:
            self.open.pop()

    def handle_data(self, data):
        if self.open and self.open[-1] not in ("style", "script"):
            self.text.append(data)

    def of(self, *tags):
        return [(tag, attributes, within) for tag, attributes, within in self.elements if tag in tags]

    def words(self):
        return re.sub(r"\s+", " ", "".join(self.text))


def lamp_room():
    """The room of test_program with a luminaire whose file's keywords are no kind words."""
    scene = test_program.room()
    scene["nodes"][1] = {"name": "desk lamp", "translation": [1, 2, -0.5], "rotation": test_program.UP,
                         "extras": {"ups": {"luminaire": {"file": "lamp.ies"}}}}
    return scene


class ReportTest(test_program.ProgramTest):
    def report(self, *options, scene=None, targets=None, folder="out"):
        self.write("lamp.ies", test_program.IES.replace("this project", NASTY))
        path = self.write("a & b.gltf", scene or lamp_room())
        if targets is not None:
            options = (*options, "--targets", self.write("targets.json", targets))
        done = self.run_program("render", path, "--json", "--seed", 7, "--out", self.path(folder), "--report", *options)
        with open(self.path(folder + "/report.html"), encoding="utf-8") as file:
            return file.read(), json.loads(done.stdout)


class WholePage(ReportTest):
    def setUp(self):
        super().setUp()
        self.html, self.json = self.report("--iterations", 48, targets={
            "standard": "A & B",
            "areas": [{"name": "<b>desk</b>", "meters": "work_plane", "mean_lx": 1, "uniformity": 1}]})
        self.page = Page(self.html)

    def test_it_is_well_formed(self):
        self.assertTrue(self.html.startswith("<!DOCTYPE html>"))
        self.assertEqual(self.page.wrong, [])
        ids = [a["id"] for _, a, _ in self.page.elements if "id" in a]
        self.assertEqual(len(ids), len(set(ids)))
        self.assertNotIn("nan", self.page.words().split())
        self.assertNotRegex(self.page.words(), r"\bn/a\b")  # which the folder's name may end in, before "/a & b"

    def test_nothing_is_fetched_and_nothing_runs(self):
        self.assertEqual(self.page.of("script", "iframe", "object", "embed"), [])
        for tag, attributes, _ in self.page.elements:
            for name in ("src", "href", "xlink:href", "poster", "action"):
                self.assertRegex(attributes.get(name, "#"), r"^(#|data:)", (tag, name))
            self.assertFalse([name for name in attributes if name.startswith("on")], tag)
        self.assertEqual(re.findall(r"url\((?!#)|@import", self.html), [])
        policy = [a["content"] for _, a, _ in self.page.of("meta") if a.get("http-equiv") == "Content-Security-Policy"]
        self.assertIn("default-src 'none'", policy[0])

    def test_it_can_be_read_aloud(self):
        self.assertEqual([a["lang"] for _, a, _ in self.page.of("html")], ["en"])
        levels = [int(tag[1]) for tag, _, _ in self.page.of("h1", "h2", "h3", "h4")]
        self.assertEqual(levels.count(1), 1)
        self.assertTrue(all(b <= a + 1 for a, b in zip(levels, levels[1:])), levels)
        for _, attributes, _ in self.page.of("img"):
            self.assertTrue(attributes.get("alt"))
        ids = {a["id"] for _, a, _ in self.page.elements if "id" in a}
        drawings = [a for _, a, _ in self.page.of("svg")]
        self.assertGreaterEqual(len(drawings), 4)  # plan, section, polar diagram, accuracy
        for attributes in drawings:
            self.assertEqual(attributes.get("role"), "img")
            self.assertLessEqual(set(attributes["aria-labelledby"].split()), ids)
        tables = self.page.of("table")
        self.assertEqual(len(self.page.of("caption")), len(tables))
        for _, attributes, _ in self.page.of("th"):
            self.assertIn(attributes.get("scope"), ("col", "row"))
        links = {a["href"][1:] for _, a, _ in self.page.of("a")}
        self.assertLessEqual(links, ids)
        self.assertGreaterEqual(len(links), 8)

    def test_it_says_what_was_asked_for(self):
        words = self.page.words()
        for heading in ("In short", "Requirements", "Scene", "Luminaires", "Illuminance", "Pictures", "Flux balance",
                        "What was simulated, and why", "Accuracy and time", "How to read the numbers",
                        "How it was calculated"):
            self.assertIn(heading, words)
        for fact in ("lamp.ies", NASTY, "<b>desk</b>", "desk_lamp", "work_plane", "view", "ups 0.1.0",
                     "interreflection", "light sample", "middle grey", "Escaped from the scene", "EV100"):
            self.assertIn(fact, words)
        mean = self.json["meters"]["work_plane"]["mean_lx"]
        self.assertIn(f"{mean:.3f}" if mean < 10 else f"{mean:.2f}", words)

    def test_contrast_of_all_pairs(self):
        style = re.search(r"<style>(.*?)</style>", self.html, re.S).group(1)
        pairs = 0
        for selector, body in re.findall(r"([^{}]+)\{([^{}]*)\}", style):
            colours = dict(re.findall(r"(?<![-\w])(color|background): (#[0-9a-f]{3,6})", body))
            if "color" not in colours:
                continue
            pairs += 1
            ratio = contrast(colours["color"], colours.get("background", "#fff"))
            self.assertGreaterEqual(ratio, 4.5, selector.strip())  # WCAG 2.1, 1.4.3, AA
        self.assertGreaterEqual(pairs, 10)
        self.assertAlmostEqual(contrast("#000", "#ffffff"), 21, places=6)
        self.assertLess(contrast("#999", "#fff"), 4.5)


def contrast(a, b):
    """WCAG 2.1's ratio of the relative luminances of two colours."""
    def luminance(colour):
        digits = colour[1:] if len(colour) == 7 else "".join(2 * c for c in colour[1:])
        linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4
                  for c in (int(digits[k:k + 2], 16) / 255 for k in (0, 2, 4))]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    low, high = sorted((luminance(a), luminance(b)))
    return (high + 0.05) / (low + 0.05)


class Repeated(ReportTest):
    def test_the_same_result_makes_the_same_page(self):
        os.environ["SOURCE_DATE_EPOCH"] = "1700000000"
        self.addCleanup(os.environ.pop, "SOURCE_DATE_EPOCH")
        pages = [self.report("--iterations", 32, "--threads", threads)[0] for threads in (1, 2)]
        self.assertIn("2023-11-14 22:13 UTC", pages[0])
        timed = r'<section id="(accuracy|repeat)".*?</section>'
        first, second = (re.sub(timed, "", page, flags=re.S) for page in pages)
        self.assertEqual(first, second)

    def test_its_command_gives_the_same_numbers(self):
        page, first = self.report("--time", "2", "--target-error=1e-9")
        command = re.search(r"<pre><code>(.*?)</code></pre>", page).group(1)
        words = shlex.split(html.unescape(command))
        self.assertEqual(words[0], "ups")
        self.assertFalse([w for w in words if w.startswith(("--time", "--target-error"))])
        again = subprocess.run([test_program_path(), *words[1:]], stdout=subprocess.PIPE, text=True, check=True)
        self.assertEqual(json.loads(again.stdout)["meters"], first["meters"])

    def test_without_meters_or_without_cameras_sections_are_left_out(self):
        scene = lamp_room()
        scene["scenes"][0]["nodes"] = [0, 1, 4]
        page = Page(self.report("--iterations", 16, scene=scene)[0])
        self.assertEqual(page.wrong, [])
        self.assertNotIn("Illuminance of", page.words())
        self.assertNotIn("Requirements", page.words())
        self.assertIn("Pictures", page.words())
        scene["scenes"][0]["nodes"] = [0, 1, 2]
        words = Page(self.report("--iterations", 1, scene=scene)[0]).words()
        self.assertIn("Illuminance", words)
        self.assertNotIn("Pictures", words)
        self.assertNotIn("Accuracy and time", words)  # one iteration knows no error

    def test_the_page_needs_a_folder(self):
        scene = self.write("room.gltf", test_program.room())
        done = self.run_program("render", scene, "--iterations", 16, "--report", code=2)
        self.assertIn("--out", done.stderr)
        self.run_program("render", scene, "--iterations", 16, "--out", self.path("plain"))
        self.assertNotIn("report.html", os.listdir(self.path("plain")))


class Targets(ReportTest):
    def judge(self, area, iterations=48):
        page, result = self.report("--iterations", iterations,
                                   targets={"areas": [{"meters": "work_plane", **area}]})
        (verdict,) = result["targets"]
        return verdict, result["meters"]["work_plane"], Page(page).words()

    def test_verdicts_follow_the_interval(self):
        probe, meters, _ = self.judge({"mean_lx": 1})
        self.assertEqual((probe["verdict"], probe["quantity"], probe["meters"]), ("met", "mean_lx", "work_plane"))
        bound = meters["mean_error_bound_lx"]
        self.assertGreater(bound, 0)
        self.assertAlmostEqual(probe["low"], meters["mean_lx"] - bound)
        self.assertAlmostEqual(probe["high"], meters["mean_lx"] + bound)
        below, above = meters["mean_lx"] - 1.01 * bound, meters["mean_lx"] + 1.01 * bound
        self.assertEqual(self.judge({"mean_lx": below})[0]["verdict"], "met")
        self.assertEqual(self.judge({"mean_lx": above})[0]["verdict"], "not_met")
        self.assertEqual(self.judge({"mean_lx": meters["mean_lx"] - 0.9 * bound})[0]["verdict"], "not_sure")
        self.assertEqual(self.judge({"uniformity": 0.999})[0]["verdict"], "not_met")
        self.assertEqual(self.judge({"min_lx": 1e-3})[0]["verdict"], "met")

    def test_paths_that_were_cut_are_told(self):
        for method in ("ups", "pt"):
            html, result = self.report("--iterations", 16, "--method", method, "--max-path-length", 1)
            self.assertRegex("\n".join(result["warnings"]),
                             r"paths end after 1 edge, as was asked for: readings " +
                             (r"lack the light that goes on, \d+(\.\d+)? % of what is emitted" if method == "ups" else
                              r"may lack the light that goes on(\n|$)"))
            self.assertIn("Paths were cut, as was asked for", html)
            self.assertNotIn("no light is lost", html)
            self.assertNotIn("larger than chance", html)
            html, result = self.report("--iterations", 16, "--method", method)
            self.assertNotIn("paths end after", "\n".join(result["warnings"]))
            self.assertIn("no light is lost", html)

    def test_the_text_has_a_line_a_verdict(self):
        """With or without a page and JSON."""
        scene = lamp_room()
        scene["nodes"].append({"translation": [0, 1.2, 1.5], "extras": {"ups": {"observer": {"name": "<eye>"}}}})
        scene["scenes"][0]["nodes"].append(5)
        _, result = self.report("--iterations", 48, scene=scene, targets={"areas": [
            {"name": "desk\ntop", "meters": "work_plane", "mean_lx": 1, "uniformity": 0.999},
            {"observers": "<eye>", "ugr": 39}]})

        def lines(iterations):
            done = self.run_program("render", self.path("a & b.gltf"), "--seed", 7, "--iterations", iterations,
                                    "--targets", self.path("targets.json"))
            return [line for line in done.stdout.splitlines() if line.startswith("target ")]
        words = {"mean_lx": ("mean", " lx", "least", 1e-3), "uniformity": ("uniformity", "", "least", 1e-3),
                 "ugr": ("UGR", "", "most", 0.01)}
        told = lines(48)
        self.assertEqual([v["verdict"] for v in result["targets"]], ["met", "not_met", "met"])
        self.assertEqual(len(told), 3)
        for line, verdict in zip(told, result["targets"]):
            quantity, unit, side, precision = words[verdict["quantity"]]
            where = "desk_top: meters work_plane" if "meters" in verdict else "<eye>: observer <eye>"
            found = re.fullmatch(rf"target {where}: {quantity} ([\d.]+){unit} \(([\d.]+) to ([\d.]+)\), required at "
                                 rf"{side} {verdict['required']:g}{unit}: {verdict['verdict'].replace('_', ' ')}", line)
            self.assertIsNotNone(found, line)
            for number, key in zip(found.groups(), ("value", "low", "high")):
                self.assertAlmostEqual(float(number), verdict[key], delta=precision * max(1, verdict[key]), msg=line)
        for line in lines(2)[:2]:
            self.assertRegex(line, r" [\d.]+( lx)?, required at least [\d.]+( lx)?: not sure$")

    def test_what_falls_short_is_not_rounded_up(self):
        _, meters, _ = self.judge({"mean_lx": 1})
        required = float(f"{meters['mean_lx']:.1f}")  # where the page would write the mean as if it were met
        for required in (required, required + 0.1):
            verdict, _, words = self.judge({"mean_lx": required})
            table = words.split("Requirements")[-1]
            shown = float(re.search(r"Mean illuminance [≥\s]*[\d.]+ lx.*?([\d.]+) lx", table).group(1))
            self.assertEqual(shown < required, meters["mean_lx"] < required, (shown, required))
            self.assertNotEqual(shown, required)
            self.assertIn(verdict["verdict"].replace("_", " "), words)

    def test_meters_of_surfaces_and_a_lightmap_are_on_it(self):
        scene = lamp_room()
        floor = scene["meshes"][0]["primitives"][0]["attributes"]
        uv = struct.pack("<8f", 0, 0, 0.75, 0, 0.75, 1, 0, 1)  # a quarter of the texels is empty
        scene["buffers"].append({"byteLength": len(uv), "uri": "data:application/octet-stream;base64," +
                                 base64.b64encode(uv).decode()})
        scene["bufferViews"].append({"buffer": 1, "byteLength": len(uv)})
        scene["accessors"].append({"bufferView": len(scene["bufferViews"]) - 1, "componentType": 5126, "count": 4,
                                   "type": "VEC2"})
        floor["TEXCOORD_0"] = len(scene["accessors"]) - 1
        for name, words in (("faces", {"surface": True}), ("texels", {"lightmap": {"width": 16, "height": 8}})):
            scene["nodes"].append({"name": name, "mesh": 0, "translation": [0, -0.1, 0],
                                   "extras": {"ups": {"meters": words}}})
            scene["scenes"][0]["nodes"].append(len(scene["nodes"]) - 1)
        page, result = self.report("--iterations", 16, "--ratio", "work_plane/work_plane", scene=scene)
        page = Page(page)
        self.assertEqual(page.wrong, [])
        words = page.words()
        self.assertIn("faces 2 triangles, horizontal, at -0.10 m", words)
        self.assertIn("texels 16 \u00d7 8 texels, horizontal, at -0.10 m", words)
        self.assertIn("Least, meter by meter", words)
        self.assertLessEqual({"faces", "texels"}, set(result["meters"]))

    def test_glare_must_be_at_most(self):
        scene = lamp_room()
        scene["nodes"].append({"translation": [0, 1.2, 1.5], "extras": {"ups": {"observer": {"name": "<eye>"}}}})
        scene["scenes"][0]["nodes"].append(5)

        def judge(ugr):
            page, result = self.report("--iterations", 48, scene=scene,
                                       targets={"areas": [{"observers": "<eye*", "ugr": ugr}]})
            (verdict,) = result["targets"]
            self.assertEqual((verdict["observer"], verdict["quantity"]), ("<eye>", "ugr"))
            return verdict["verdict"], result["observers"]["<eye>"], Page(page)
        verdict, observer, page = judge(39)
        self.assertEqual(verdict, "met")
        self.assertEqual(page.wrong, [])
        self.assertIn("What troubles most", page.words())
        self.assertIn("<eye>", page.words())
        self.assertIn(f"{observer['ugr']:.1f}", page.words())
        self.assertIn("observer <eye>: eye paths", page.words())  # by name: to the library, meters with a number
        self.assertNotRegex(page.words(), r"meters \d+:")
        self.assertGreater(observer["ugr_low"], 1)
        self.assertLess(observer["ugr_low"], observer["ugr_high"])
        self.assertEqual(judge(observer["ugr_high"] + 0.001)[0], "met")
        self.assertEqual(judge(observer["ugr_low"] - 0.001)[0], "not_met")
        self.assertEqual(judge((observer["ugr_low"] + observer["ugr_high"]) / 2)[0], "not_sure")

    def test_without_known_errors_nothing_is_sure(self):
        verdict, _, _ = self.judge({"uniformity": 0.01}, iterations=2)
        self.assertEqual(verdict["verdict"], "not_sure")

    def test_rows_of_the_standard(self):
        _, result = self.report("--iterations", 32, targets={"include": "en12464-1.json", "areas": [
            {"name": "desks", "row": "office.writing", "meters": ["work*", "sp?t"]},
            {"name": "around", "row": "office.writing", "part": "surround", "meters": "work_plane",
             "uniformity": 0.3}, {"name": "shelves", "row": "library.shelves", "meters": "spot"}]})
        found = [(v["area"], v["meters"], v["quantity"], v["required"]) for v in result["targets"]]
        self.assertEqual(found, [
            ("desks", "work_plane", "mean_lx", 500), ("desks", "work_plane", "uniformity", 0.6),
            ("desks", "spot", "mean_lx", 500), ("desks", "spot", "uniformity", 0.6),
            ("around", "work_plane", "mean_lx", 300), ("around", "work_plane", "uniformity", 0.3),
            ("shelves", "spot", "mean_lx", 200), ("shelves", "spot", "uniformity", 0.6)])

    def test_parts_of_a_row_are_of_their_kind_of_meters(self):
        scene = lamp_room()
        scene["nodes"][2]["extras"]["ups"]["meters"]["kind"] = "cylindrical"
        areas = [{"name": "faces", "row": "office.writing", "part": "cylindrical", "meters": "*"}]
        targets = {"include": "en12464-1.json", "areas": areas}
        _, result = self.report("--iterations", 16, scene=scene, targets=targets)
        self.assertEqual({v["meters"] for v in result["targets"]}, {"work_plane"})
        self.expect_failure("render", self.write("room.gltf", test_program.room()), "--iterations", 16,
                            "--targets", self.write("targets.json", targets), words=["no cylindrical meters '*'"])

    def test_a_luminaire_shines_as_its_file_whatever_the_maintenance(self):
        def sheet(factor):
            scene = lamp_room()
            scene["scenes"][0]["extras"] = {"ups": {"maintenance_factor": factor}}
            words = Page(self.report("--iterations", 16, scene=scene)[0]).words()
            return re.search(r"Luminance from 65.*?cd/m", words), re.search(r"Schedule.*?|Luminaires as they.*?Places",
                                                                           words).group(0)
        new, old = sheet(1), sheet(0.8)
        self.assertEqual(new[0] and new[0].group(0), old[0] and old[0].group(0))
        self.assertEqual(new[1].replace(" in the scene", ""),
                         old[1].replace(" in the scene, new, without the maintenance factor", ""))

    def test_a_fixture_shines_new_whatever_the_maintenance(self):
        """Its emitter and a luminaire have the maintenance factor in the scene, a light has none (before: 800 lm)."""
        scene = lamp_room()
        scene["scenes"][0]["extras"] = {"ups": {"maintenance_factor": 0.8}}
        scene["scenes"][0]["nodes"].append(len(scene["nodes"]))
        scene["nodes"].append({"name": "downlight", "rotation": test_program.UP, "translation": [0, 2.5, 0],
                               "extras": test_goniometer.fixture()})
        words = Page(self.report("--iterations", 16, scene=scene)[0]).words()
        self.assertRegex(words, r"emitter of a fixture.*? ?1 ?1000 ?1000")
        self.assertIn("2 light sources", words)

    def test_a_dimmed_luminaires_peak_is_dimmed(self):
        def peak(dimming):
            scene = lamp_room()
            scene["nodes"][1]["extras"]["ups"]["luminaire"]["dimming"] = dimming
            words = Page(self.report("--iterations", 16, scene=scene)[0]).words()
            return float(re.search(r"Peak ([\d.]+) cd", words).group(1)), "0.5 of what its file says" in words
        (whole, told), (half, told_of_half) = peak(1), peak(0.5)
        self.assertAlmostEqual(half / whole, 0.5, delta=0.001)
        self.assertEqual((told, told_of_half), (False, True))

    def test_what_is_wrong_with_a_file(self):
        area = {"meters": "work_plane", "mean_lx": 100}
        for content, words in (
                ("{", ["no JSON", "line 1"]), ("[]", ["must be an object"]), ({}, ["areas", "must be a list"]),
                ({"areas": []}, ["areas"]), ({"areas": [area], "aeras": 1}, ["'aeras'", "areas"]),
                ({"areas": [{"meters": "work_plane"}]}, ["areas[0]", "mean_lx"]),
                ({"areas": [{"mean_lx": 5}]}, ["areas[0]", "meters"]),
                ({"areas": [{**area, "mean_lx": "many"}]}, ["areas[0].mean_lx", "number greater than 0", "many"]),
                ({"areas": [{**area, "mean_lx": -5}]}, ["areas[0].mean_lx", "-5"]),
                ({"areas": [{**area, "uniformity": 60}]}, ["areas[0].uniformity", "at most 1"]),
                ({"areas": [{**area, "mean": 60}]}, ["areas[0]", "'mean'", "mean_lx"]),
                ({"areas": [{**area, "meters": 7}]}, ["areas[0].meters", "name"]),
                ({"areas": [{**area, "meters": "desk*"}]}, ["no meters 'desk*'", "work_plane, spot"]),
                ({"areas": [{**area, "observers": "eye", "ugr": 19}]}, ["no observer 'eye'"]),
                ({"areas": [{**area, "row": "office.writing"}]}, ["areas[0].row", "office.writing", "include"]),
                ({"include": "none.json", "areas": [area]}, ["include", "none.json"]),
                ({"include": "en12464-1.json", "areas": [{**area, "row": "ofice"}]}, ["'ofice'", "office.writing"]),
                ({"include": "en12464-1.json", "areas": [{"meters": "spot", "row": "office.cad", "part": "roof"}]},
                 ["areas[0].part", "task", "roof"]),
                ({"include": "en12464-1.json", "areas": [{"meters": "spot", "row": "office.cad", "part": "walls"}]},
                 ["areas[0].part", "says nothing of 'walls'"]),
                ({"rows": {"mine": {"task": {"mean": 3}}}, "areas": [area]}, ["rows.mine.task", "'mean'"])):
            with self.subTest(content=content):
                self.expect_failure("render", self.write("room.gltf", test_program.room()), "--iterations", 16,
                                    "--targets", self.write("targets.json", content),
                                    words=["targets.json", *words])
        self.expect_failure("render", self.write("room.gltf", test_program.room()), "--targets", self.path("none.json"),
                            words=["none.json", "cannot be read"])


def test_program_path():
    return test_program.PROGRAM


if __name__ == "__main__":
    test_program.PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
