"""The scenes by which the choice of techniques is judged, by name; `make(name, folder)` writes one.

Called by choose.py, must_show.py and equivalence.py.
"""
import contextlib
import io
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(HERE, "..", "scenes_common"))
import rooms  # noqa: E402
import make_conference  # noqa: E402


def conference(scene):
    """The conference room with meters over its table and beside it."""
    with contextlib.redirect_stdout(io.StringIO()):
        make_conference.build(scene)
    x, y = make_conference.TABLE_AT
    rooms.workplane(scene, "table", (x - 1.6, y - 0.5), (x + 1.6, y + 0.5), make_conference.TABLE_Z + 0.1, 16, 5)
    rooms.workplane(scene, "floor", (0.3, 0.3), (make_conference.LENGTH - 0.3, 1.0), 0.3, 16, 2)


ROOMS = {
    "office": (rooms.office, {}),
    "office_glass": (rooms.office, {"effects": ("pane",)}),
    "hall": (rooms.hall, {"luminaires": 1024}),
    "atrium": (rooms.atrium, {}),
    "conference": (conference, {}),
    "glass_box": (rooms.glass_box, {}),
}
SIZES = {"bathroom": "160x120"}  # of cameras; elsewhere
SIZE = "128x96"


def run_script(script, path, *options):
    command = [sys.executable, os.path.join(HERE, script), *options, "--out", path]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return path


def make(name, folder, **options):
    """Writes `name` into the folder; `options` replace those of ROOMS."""
    path = os.path.join(folder, "scene.glb")
    os.makedirs(folder, exist_ok=True)
    if name == "bathroom":
        return run_script("../bathroom/make_bathroom.py", path)
    build, words = ROOMS[name]
    return rooms.write(path, build, **{**words, **options})


NAMES = (*ROOMS, "bathroom")
