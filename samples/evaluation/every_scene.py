"""Every scene of the samples and of the tests that `ups render` can run: `every_scene()` gives {name: make(folder) ->
path of the scene}. What has further words for `ups render` has them in `OPTIONS`.

Called by equivalence.py, whose --list prints the names.
"""
import contextlib
import io
import json
import os
import sys

import judged_scenes
from judged_scenes import HERE, rooms, run_script

SCRIPTS = {
    "bathroom_check": ("../bathroom/make_bathroom.py", "--check"),
    "bathroom_picture": ("../bathroom/make_bathroom.py", "--picture"),
    "office_panels": ("make_office.py",),
    "caustic": ("make_caustic.py",),
    "cornell": ("make_cornell.py",),
    "sphere_0.5": ("make_sphere.py", "0.5"),
    "sphere_0.95": ("make_sphere.py", "0.95"),
    "sphere_offset": ("make_sphere.py", "0.9", "--offset", "0.6"),
    "statue": ("make_statue.py",),
    "torus": ("make_torus.py",),
    "treasures": ("make_treasures.py",),
    "downlight": ("../fixtures/make_downlight.py",),
    "downlight_clear": ("../fixtures/make_downlight.py", "--cover", "clear"),
    "downlight_frosted": ("../fixtures/make_downlight.py", "--cover", "frosted"),
    "downlight_two_part": ("../fixtures/make_downlight.py", "--reflector", "two-part"),
}
HALLS = (16, 10000)  # beside that of judged_scenes
OPTIONS = {}  # name: words
TESTS = {"program_room": ("test_program", "room"), "two_lights": ("test_sources", "two_lights")}


def script(name):
    return lambda folder: run_script(SCRIPTS[name][0], os.path.join(folder, "scene.glb"), *SCRIPTS[name][1:])


def room(build, words):
    return lambda folder: rooms.write(os.path.join(folder, "scene.glb"), build, **words)


def case(build):
    def make(folder):
        path = os.path.join(folder, "scene.glb")
        with contextlib.redirect_stdout(io.StringIO()):
            build(path)
        return path
    return make


def of_a_test(module, function):
    def make(folder):
        path = os.path.join(folder, "scene.gltf")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(getattr(__import__(module), function)(), file)
        return path
    return make


def every_scene():
    sys.path += [os.path.join(HERE, "..", folder) for folder in ("effects", "fixtures", "validation")]
    sys.path.append(os.path.join(HERE, "..", "..", "tests", "tool"))
    import cost_of_effects
    import goniometer_cases
    import optics_cases
    import validate
    scenes = {name: lambda folder, name=name: judged_scenes.make(name, folder) for name in judged_scenes.NAMES}
    scenes |= {f"hall_{n}": room(rooms.hall, {"luminaires": n}) for n in HALLS}
    scenes |= {f"effects_{k}": room(rooms.office, words) for k, (_, words) in enumerate(cost_of_effects.steps())}
    scenes |= {name: script(name) for name in SCRIPTS}
    scenes |= {f"optics_{c.name}": case(c.build) for c in optics_cases.cases()}
    scenes |= {f"goniometer_{c.name}": case(c.build) for c in goniometer_cases.cases()}
    scenes |= {f"validation_{c.name}": case(c.build) for c in validate.all_cases()}
    OPTIONS.update({f"validation_{c.name}": list(c.options) for c in validate.all_cases()})
    scenes |= {f"test_{name}": of_a_test(*where) for name, where in TESTS.items()}
    return scenes
