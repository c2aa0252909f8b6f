"""The report of an office in Chromium: on a phone, on a desk, on paper. Usage: test_report_page.py PATH_TO_UPS"""
import os
import re
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..")
sys.path.insert(0, os.path.join(HERE, "..", "support"))
from browser import browse, chromium, look_at  # noqa: E402

PHONE, DESK = 360, 1280
A4 = (595.3, 841.9)  # points


class OfficePage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="ups-report-")
        cls.addClassCleanup(cls.folder.cleanup)
        scene, cls.page = os.path.join(cls.folder.name, "office.glb"), os.path.join(cls.folder.name, "report.html")
        subprocess.run([sys.executable, os.path.join(ROOT, "samples", "report", "make_office.py"), "--out", scene],
                       check=True, stdout=subprocess.DEVNULL)
        subprocess.run([PROGRAM, "render", scene, "--iterations", "32", "--size", "96x64", "--seed", "3", "--out",
                        cls.folder.name, "--report", "--targets",
                        os.path.join(ROOT, "samples", "report", "targets.json")], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.found, cls.console = look_at(cls.page, PHONE, DESK)

    def test_console_is_silent_and_nothing_is_fetched(self):
        self.assertEqual(self.console, [])
        self.assertEqual([frame["fetched"] for frame in self.found.values()], [[], []])

    def test_no_part_lies_outside(self):
        self.assertLessEqual(self.found["phone"]["width"], PHONE)
        self.assertLessEqual(self.found["desk"]["width"], DESK)
        self.assertEqual(self.found["desk"]["hidden"], 0)  # on a phone wide tables and plans scroll by themselves

    def test_pictures_are_shown(self):
        for frame in self.found.values():
            self.assertGreaterEqual(len(frame["images"]), 1)
            for words, pixels, width in frame["images"]:
                self.assertTrue(words)
                self.assertGreater(pixels, 60, words)
                self.assertGreater(width, 60, words)
            self.assertGreater(frame["letters"], 3000)

    def test_on_paper(self):
        path = os.path.join(self.folder.name, "report.pdf")
        _, console = browse("--no-pdf-header-footer", f"--print-to-pdf={path}", "file://" + self.page)
        self.assertEqual(console, [])
        with open(path, "rb") as file:
            pdf = file.read()
        boxes = re.findall(rb"/MediaBox\s*\[\s*([\d.\s-]+)\]", pdf)
        pages = len(re.findall(rb"/Type\s*/Page\b(?!s)", pdf))
        self.assertGreaterEqual(pages, 4)
        self.assertLessEqual(pages, 16)
        for box in boxes:
            left, bottom, right, top = map(float, box.split())
            self.assertAlmostEqual(right - left, A4[0], delta=1)
            self.assertAlmostEqual(top - bottom, A4[1], delta=1)
        self.assertGreaterEqual(len(boxes), 1)


class BrokenPage(unittest.TestCase):
    """What the checks above would say of a page that is not in order."""

    def test_it_is_noticed(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "broken.html")
            with open(path, "w", encoding="utf-8") as file:
                file.write('<body><div style="width:2000px">wide</div><img alt="fetched" src="http://127.0.0.1:9/nothing.png">'
                           '<script>console.error("wrong")</script>')
            found, console = look_at(path, PHONE, DESK)
        self.assertTrue(any("wrong" in line for line in console))
        self.assertGreater(found["phone"]["width"], PHONE)
        self.assertTrue(found["desk"]["fetched"])


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    if chromium() is None:
        print("skipped: no Chromium (Debian: apt-get install chromium)")
        sys.exit(77)
    unittest.main()
