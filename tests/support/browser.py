"""A page in headless Chromium: what its console says, and how it fits a phone and a desk. Used by tests of pages."""
import html
import json
import os
import re
import shutil
import subprocess
import tempfile

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
      hidden: [...page.querySelectorAll(".scroll")].filter(e => e.scrollWidth > e.clientWidth + 1).length,
      fetched: frame.contentWindow.performance.getEntriesByType("resource").map(e => e.name)
                    .filter(n => !n.startsWith("data:"))
    };
  }
  document.getElementById("found").textContent = JSON.stringify(found);
};
</script>"""


def chromium():
    """Its path; None: there is none."""
    return next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


def browse(*words):
    """(standard output, lines of the console)."""
    with tempfile.TemporaryDirectory() as profile:
        done = subprocess.run([chromium(), "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                               "--allow-file-access-from-files", "--enable-logging=stderr",
                               f"--user-data-dir={profile}", *words], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, timeout=240)
    if done.returncode != 0:
        raise AssertionError(f"{chromium()} ended with {done.returncode}:\n{done.stderr}")
    return done.stdout, [line for line in done.stderr.splitlines() if "CONSOLE" in line]


def look_at(page, phone, desk):
    """({"phone", "desk": what is in a frame of that width}, lines of the console)."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "frames.html")
        with open(path, "w", encoding="utf-8") as file:
            file.write(FRAMES % {"page": "file://" + page, "phone": phone, "desk": desk})
        shown, console = browse(f"--window-size={desk + phone + 60},1000", "--dump-dom", "file://" + path)
    found = re.search(r'<pre id="found">(.*?)</pre>', shown, re.S)
    return json.loads(html.unescape(found.group(1))), console
