#!/usr/bin/env python3
"""The page of samples/accuracy in a browser: is it shown whole, with all pictures, without an error, on a phone, too?

  test_page.py FOLDER     of test_tables.py
"""
import os
import re
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from browser import browse, chromium, look_at  # noqa: E402

PHONE, DESK = 390, 1200


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.path = os.path.join(FOLDER, "report.html")
        cls.found, cls.console = look_at(cls.path, PHONE, DESK)

    def test_console_is_silent(self):
        self.assertEqual(self.console, [])

    def test_nothing_is_fetched(self):
        with open(self.path, encoding="utf-8") as file:
            found = re.findall(r'(?:src|href)\s*=\s*"(?!data:|#)|url\(|@import|<script', file.read())
        self.assertEqual(found, [])

    def test_all_images_are_shown(self):
        for name, frame in self.found.items():
            self.assertGreaterEqual(len(frame["images"]), 12)  # 3 rooms by 2 at least, 6 settings
            for words, pixels, width in frame["images"]:
                self.assertTrue(words)
                self.assertGreater(pixels, 100, words)
                self.assertGreater(width, 0.5 * PHONE, (name, words))

    def test_no_part_lies_outside(self):
        self.assertLessEqual(self.found["phone"]["width"], PHONE)
        self.assertLessEqual(self.found["desk"]["width"], DESK)
        self.assertEqual([frame["hidden"] for frame in self.found.values()], [0, 0])

    def test_it_is_not_blank(self):
        import matplotlib.image
        self.assertGreater(self.found["desk"]["letters"], 5000)
        picture = os.path.join(FOLDER, "page.png")
        height = self.found["desk"]["height"]
        browse(f"--window-size={DESK},{height}", f"--screenshot={picture}", "file://" + self.path)
        shown = matplotlib.image.imread(picture)[..., :3]
        self.assertGreater(shown.shape[0], 0.9 * height)
        dark = shown.min(axis=2) < 0.6
        for k in range(10):  # ink in every tenth of the page
            tenth = dark[k * len(dark) // 10:(k + 1) * len(dark) // 10]
            self.assertGreater(tenth.mean(), 0.003, k)
            self.assertLess(tenth.mean(), 0.5, k)


class BrokenPage(unittest.TestCase):
    """What the checks above would say of a page that is not in order."""

    def test_it_is_noticed(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "broken.html")
            with open(path, "w", encoding="utf-8") as file:
                file.write('<body><img alt="none" src="data:image/png;base64,AAAA"><div style="width:2000px">wide</div>'
                           '<img alt="fetched" src="nothing.png"><script>console.error("wrong")</script>')
            found, console = look_at(path, PHONE, DESK)
        self.assertTrue(any("wrong" in line for line in console))
        self.assertEqual([pixels for _, pixels, _ in found["phone"]["images"]], [0, 0])
        self.assertGreater(found["phone"]["width"], PHONE)


if __name__ == "__main__":
    FOLDER = os.path.abspath(sys.argv[1])
    if chromium() is None:
        print("skipped: no Chromium (Debian: apt-get install chromium)")
        sys.exit(77)
    if not os.path.exists(os.path.join(FOLDER, "report.html")):
        print(f"skipped: no report.html in {FOLDER}; samples.accuracy makes it where there is matplotlib")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
