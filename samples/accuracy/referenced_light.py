"""Rooms without a closed form, whose meters are judged by one long render: an office with IES luminaires, an atrium
under glass and the sample bathroom. Called by calibrate.py and stopping.py.

The reference is made once and kept as long as scene and words stay the same. Its own standard error adds to what a
bound is to hold (calibration.py); what its bias may be adds nothing, so it can only make the shares that are told
smaller.
"""
import os
import subprocess
import sys
from dataclasses import dataclass
from typing import Callable

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", folder) for folder in ("scenes_common", "evaluation", "validation")]
import need_numpy  # noqa: E402,F401
import numpy as np  # noqa: E402
import rooms  # noqa: E402
from harness import noise  # noqa: E402
from renders import Renderer, read_table  # noqa: E402

BATHROOM = os.path.join(HERE, "..", "bathroom")
SEED = 2 ** 40 + 1  # beyond the seeds of the readings


@dataclass(frozen=True)
class Referenced:
    name: str
    title: str
    make: Callable[[str], str]  # the scene's file, in a folder where it is to be made
    words: tuple                # of `ups render`, of the readings
    method: str                 # the reference's
    reference_words: tuple
    size: str = "32x24"         # of cameras: the meters are what is judged

    def scene(self, folder):
        return self.make(folder)

    def truth(self, ups, scene, folder, sets=None):
        """(lx, standard error) of the meters, of all or of these sets."""
        out = os.path.join(folder, "reference")
        summary = Renderer(ups, scene, size=self.size).reference(self.method, SEED, list(self.reference_words), out)
        rows = [row for name in sets or summary["meters"] for row in read_table(out, name)]
        return (np.array([row["illuminance_lx"] for row in rows]),
                np.array([noise(row["standard_error_lx"], row["error_bound_lx"]) for row in rows]))


def make_office(folder):
    return rooms.write(os.path.join(folder, "office.glb"), rooms.office, effects=("desks", "gloss"))


def make_atrium(folder):
    return rooms.write(os.path.join(folder, "atrium.glb"), rooms.atrium)


def make_bathroom_floor(folder):
    path = os.path.join(folder, "bathroom.glb")
    subprocess.run([sys.executable, os.path.join(BATHROOM, "make_bathroom.py"), "--floor", "--out", path], check=True,
                   stdout=subprocess.DEVNULL)
    return path


def office():
    """By path tracing, which finds all of its light: points over matte and glossy things."""
    return Referenced("office", "an office with IES luminaires", make_office, ("--iterations", "32"), "pt",
                      ("--iterations", "8192"))


def atrium():
    """Its roof and rails mirror 400 luminaires: light that only photons find, with edges beside whole rows of meters. The
    reference has 64 times as many of them."""
    return Referenced("atrium", "an atrium under a glass roof", make_atrium, ("--iterations", "64"), "ups",
                      ("--light-paths", "131072", "--iterations", "512"))


def bathroom():
    """All meters. No technique but merging finds some of its light: the reference is of the same kind, with 64 times the
    iterations. A first radius of its own would cost it more than it gains: of 5 cm, that of the walks loses 1.3 %."""
    return Referenced("bathroom", "the bathroom's meters", lambda _: os.path.join(BATHROOM, "bathroom.glb"),
                      ("--iterations", "32"), "ups", ("--iterations", "2048"))
