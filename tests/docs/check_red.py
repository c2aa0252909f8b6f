#!/usr/bin/env python3
"""Do the checks of the documentation see what they are for? In a copy of its sources one thing is broken at a time, and
the check must end with 1 and name it. Called by ctest."""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PARTS = ("include/ups", "samples/docs", "tests/docs/examples", "bindings/c_header.py")


class Copy:
    def __init__(self, folder):
        self.root = Path(folder)
        for part in PARTS:
            source, target = ROOT / part, self.root / part
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copytree(source, target) if source.is_dir() else shutil.copy(source, target)

    def edit(self, path, pattern, to):
        file = self.root / path
        text = file.read_text(encoding="utf-8")
        changed, count = re.subn(pattern, to, text, count=1, flags=re.S | re.M)
        assert count == 1, f"{path} has no {pattern}"
        file.write_text(changed, encoding="utf-8")

    def run(self, script, *arguments):
        done = subprocess.run([sys.executable, self.root / "samples/docs" / script, *map(str, arguments)],
                              capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr


def pages(copy):
    return copy.run("make_pages.py", copy.root / "input")


def markdown(copy):
    return copy.run("check_links.py", "markdown")


def built(copy):
    html = copy.root / "html"
    html.mkdir()
    (html / "a.html").write_text('<a id="here" href="b.html#there">b</a>', encoding="utf-8")
    (html / "b.html").write_text('<p id="elsewhere"></p><img src="none.png">', encoding="utf-8")
    return copy.run("check_links.py", "built", html)


def no_page(copy):
    (copy.root / "html/search").mkdir(parents=True)
    return copy.run("check_links.py", "functions", copy.root / "html")


SCENE = "tests/docs/examples/scene.c"
CASES = {
    "a function without an example": (lambda c: c.edit(SCENE, r" */\* \[ups_scene_create\] \*/\n", ""), pages,
                                      "scene.c: a marker of an example without its other"),
    "an example that is gone": (lambda c: c.edit(SCENE, r" */\* \[ups_scene_create\] \*/(.*?) */\* \[end\] \*/\n",
                                                 r"\1"), pages, "1 functions without an example"),
    "an example that does not call": (lambda c: c.edit(SCENE, r"\[ups_scene_create\]", "[ups_scene_commit]"), pages,
                                      "the example of ups_scene_commit does not call it"),
    "two examples of one": (lambda c: c.edit("tests/docs/examples/commit.c", r"\[ups_scene_start_commit\]",
                                             "[ups_scene_start_commit ups_job_destroy]"), pages,
                            "ups_job_destroy has two examples"),
    "a function that no theme lists": (lambda c: c.edit("samples/docs/functions.txt", r"^ups_replay: .*?\n", ""), pages,
                                       "ups_replay"),
    "a function that is not declared": (lambda c: c.edit("samples/docs/functions.txt", r"^ups_replay: ",
                                                         "ups_vision: Sees.\nups_replay: "), pages, "ups_vision"),
    "a link to no file": (lambda c: (c.root / "a.md").write_text("# A\n[b](none.md)\n", encoding="utf-8"), markdown,
                          "none.md): there is no such file"),
    "a link to no heading": (lambda c: (c.root / "a.md").write_text("# A\n[b](#b)\n", encoding="utf-8"), markdown,
                             "there is no such heading"),
    "an anchor that is not built": (lambda c: None, built, "b.html#there: there is no such anchor"),
    "a picture that is not built": (lambda c: None, built, "none.png: there is no such file"),
    "a page that is not built": (lambda c: None, no_page, "ups_replay has no page"),
}


def main():
    wrong = []
    for name, (break_it, check, told) in CASES.items():
        with tempfile.TemporaryDirectory() as folder:
            copy = Copy(folder)
            break_it(copy)
            status, said = check(copy)
            if status != 1 or told not in said:
                wrong.append(f"{name}: ended with {status}, said {said.strip()[-300:]!r}")
    print(*wrong, sep="\n", end="\n" if wrong else "")
    print(f"{len(CASES) - len(wrong)} of {len(CASES)} faults are seen")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
