#!/usr/bin/env python3
"""The page of samples/accuracy in a browser: is it shown whole, with all pictures, without an error, on a phone, too?

  test_page.py FOLDER     of test_tables.py
"""
import html
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PHONE, DESK = 390, 1200
# The page in two frames; the outer one says what is within.
FRAMES = """<!doctype html><body style="margin:0">
<iframe id="phone" src="%(page)s" width="%(phone)d" height="900"></iframe>
<iframe id="desk" src="%(page)s" width="%(desk)d" height="900"></iframe><pre id="found"></pre><script>
onload = () => {
  const found = {};
  for (const frame of document.querySelectorAll("iframe")) {
    const page = frame.contentDocument, root = page.documentElement;
    found[frame.id] = {
      images: [...page.images].map(i => [i.alt, i.complete && i.naturalWidth, i.getBoundingClientRect().width]),
      width: root.scrollWidth, height: root.scrollHeight, letters: page.body.innerText.length,
      hidden: [...page.querySelectorAll(".scroll")].filter(e => e.scrollWidth > e.clientWidth + 1).length
    };
  }
  document.getElementById("found").textContent = JSON.stringify(found);
};
</script>"""


def browser(*words):
    """(standard output, lines of the console)."""
    with tempfile.TemporaryDirectory() as profile:
        done = subprocess.run([CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                               "--allow-file-access-from-files", "--enable-logging=stderr",
                               f"--user-data-dir={profile}", *words], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, timeout=240)
    if done.returncode != 0:
        raise AssertionError(f"{CHROMIUM} ended with {done.returncode}:\n{done.stderr}")
    return done.stdout, [line for line in done.stderr.splitlines() if "CONSOLE" in line]


def look_at(page):
    """({frame: what is in it}, lines of the console)."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "frames.html")
        with open(path, "w", encoding="utf-8") as file:
            file.write(FRAMES % {"page": "file://" + page, "phone": PHONE, "desk": DESK})
        shown, console = browser(f"--window-size={DESK + PHONE + 60},1000", "--dump-dom", "file://" + path)
    found = re.search(r'<pre id="found">(.*?)</pre>', shown, re.S)
    return json.loads(html.unescape(found.group(1))), console


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.path = os.path.join(FOLDER, "report.html")
        cls.found, cls.console = look_at(cls.path)

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
        browser(f"--window-size={DESK},{height}", f"--screenshot={picture}", "file://" + self.path)
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
            found, console = look_at(path)
        self.assertTrue(any("wrong" in line for line in console))
        self.assertEqual([pixels for _, pixels, _ in found["phone"]["images"]], [0, 0])
        self.assertGreater(found["phone"]["width"], PHONE)


if __name__ == "__main__":
    FOLDER = os.path.abspath(sys.argv[1])
    CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if CHROMIUM is None:
        print("skipped: no Chromium (Debian: apt-get install chromium)")
        sys.exit(77)
    if not os.path.exists(os.path.join(FOLDER, "report.html")):
        print(f"skipped: no report.html in {FOLDER}; samples.accuracy makes it where there is matplotlib")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
