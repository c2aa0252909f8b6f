"""Scenes whose meters' illuminance is known in closed form and comes by photons alone: from a flat mirror, through a
water surface, from a parabolic reflector, from mirrors of 2 cm. Called by calibrate.py and the tests.

All stand in black rooms, so that nothing but the light of the formula reaches a meter.
"""
import contextlib
import io
import os
import sys
from dataclasses import dataclass
from typing import Callable

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", folder) for folder in ("scenes_common", "evaluation", "validation")]
import need_numpy  # noqa: E402,F401
import numpy as np  # noqa: E402
from fixture_parts import BLACK, inside  # noqa: E402
from gltf_builder import Frame, GltfBuilder  # noqa: E402
from optics import fresnel  # noqa: E402
from reflectors import RHO, Parabola  # noqa: E402
from shapes import box, merged, quad  # noqa: E402

CANDELA = 1000.0
MIRROR = {"model": "mirror", "reflectance": RHO}


@dataclass(frozen=True)
class Known:
    name: str
    title: str
    build: Callable[[GltfBuilder], None]  # all but the meters
    points: np.ndarray                    # the meters, which face up
    lux: np.ndarray                       # what they must read
    words: tuple                          # of `ups render`
    size: str = ""                        # of cameras: it has none

    def scene(self, folder):
        """Its file, written into the folder."""
        path = os.path.join(folder, self.name + ".gltf")
        scene = GltfBuilder("UPS known_light.py")
        self.build(scene)
        scene.meters("meters", Frame.upright((0, 0, 0)), points_m=self.points.tolist())
        write_quietly(scene, path)
        return path

    def truth(self, _ups, _scene, _folder):
        """(lx, standard error) of the meters."""
        return self.lux, np.zeros_like(self.lux)


def write_quietly(scene, path):
    with contextlib.redirect_stdout(io.StringIO()):  # the builder says what it has written
        scene.write(path)


def paths(light_paths, iterations):
    return "--light-paths", str(light_paths), "--iterations", str(iterations)


def add_room(scene, low, high):
    scene.shape("room", inside(box(low, high)), scene.material("black", BLACK))


def square_of(count, centre, pitch, z):
    """count x count points, `pitch` apart."""
    at = (np.arange(count) - (count - 1) / 2) * pitch
    x, y = np.meshgrid(centre[0] + at, centre[1] + at)
    return np.stack([x.ravel(), y.ravel(), np.full(x.size, z)], 1)


def photon_mirror(scene):
    """A mask without holes: such a mirror shows no lamp as its image, so that photons carry the light it reflects."""
    return scene.material("mirror", MIRROR, alphaMode="MASK")


# ---- flat mirrors: as much light as the lamp's image behind them would bring -----------------------------------------

def facing_down(centre, z, side):
    return quad((centre[0] - side / 2, centre[1] - side / 2, z), (0, side, 0), (side, 0, 0))


def from_image(points, lamp, mirror_z):
    image = np.array([lamp[0], lamp[1], 2 * mirror_z - lamp[2]])
    return RHO * CANDELA * (image[2] - points[:, 2]) / np.linalg.norm(image - points, axis=1) ** 3


LARGE, LARGE_Z, BELOW = 2.0, 2.999, (2.9, 3.0, 0.9)  # side and height of a mirror; a lamp that lies below the meters


def large_mirror(scene):
    add_room(scene, (0, 0, 0), (6, 6, 3))
    scene.shape("mirror", facing_down((3, 3), LARGE_Z, LARGE), photon_mirror(scene))
    scene.point_light("lamp", BELOW, CANDELA)


def mirror(iterations):
    """2 m x 2 m at the ceiling, over a lamp that stands below the meters."""
    points = square_of(5, (3, 3), 0.25, 0.95)
    return Known(f"mirror_{iterations}", f"flat mirror, {iterations} iterations of 16384 light paths", large_mirror,
                 points, from_image(points, BELOW, LARGE_Z), paths(16384, iterations))


AT_EDGE = 7


def mirror_edge(beside):
    """Eight meters under the same mirror, half a metre apart; AT_EDGE stands so far within the edge of its light."""
    points = np.array([(x, y, 0.95) for x in (2.0, 2.5, 3.0, 3.5) for y in (2.5, 3.5)])
    image_z = 2 * LARGE_Z - BELOW[2]
    edge = BELOW[0] + (3 + LARGE / 2 - BELOW[0]) * (image_z - 0.95) / (image_z - LARGE_Z)
    points[AT_EDGE] = edge - beside, 3.0, 0.95
    return Known("mirror_edge", "flat mirror, beside the edge of its light", large_mirror, points,
                 from_image(points, BELOW, LARGE_Z), ())


# Where the patches of light lie, m: the meter of a 7 x 7 grid (column, row) and the patch's centre beside it. Each
# patch is 4 cm wide, so that a meter more than 2 cm beside its centre is dark.
PATCHES = (((1, 1), (0.000, 0.000)), ((3, 1), (0.010, 0.000)), ((5, 1), (0.012, 0.012)), ((1, 3), (0.016, 0.000)),
           ((3, 3), (0.000, -0.017)), ((5, 3), (-0.025, 0.000)), ((1, 5), (0.005, 0.005)), ((3, 5), (0.030, 0.030)),
           ((5, 5), (-0.015, 0.010)))


def caustic(light_paths, iterations):
    """Mirrors of 2 cm at the ceiling throw patches of 4 cm onto meters 10 cm apart; a screen keeps the lamp's own light
    away. The lamp is a spot whose cone holds all of them, and no light but theirs matters."""
    lamp, z, side, pitch = np.array([1.0, 3.0, 1.0]), 2.999, 0.02, 0.1
    image = np.array([lamp[0], lamp[1], 2 * z - lamp[2]])
    points = square_of(7, (5, 3), pitch, 1.0)
    patches = np.array([points[7 * row + column, :2] + beside for (column, row), beside in PATCHES])
    scale = (image[2] - z) / (image[2] - points[0, 2])  # from the meters' plane, by the image, to the mirrors'
    centres = image[:2] + scale * (patches - image[:2])
    crossings = image[:2] + scale * (points[:, :2] - image[:2])
    lit = (np.abs(crossings[:, None] - centres).max(2) < side / 2).any(1)

    def build(scene):
        add_room(scene, (0, 0, 0), (6, 6, 3))
        scene.shape("screen", box((2.5, 2, 0), (2.6, 4, 1.2)), scene.material("black", BLACK))
        scene.shape("mirrors", merged([facing_down(c, z, side) for c in centres]), photon_mirror(scene))
        aim = np.array([*centres.mean(0), z]) - lamp
        widest = max(angle_between(aim, np.array([*c, z]) - lamp) for c in centres)
        scene.spot_light("lamp", lamp, aim, CANDELA, widest + 0.02, widest + 0.03)

    return Known(f"caustic_{light_paths * iterations}", f"patches of 4 cm, {iterations} iterations of {light_paths} "
                 "light paths", build, points, np.where(lit, from_image(points, lamp, z), 0.0),
                 paths(light_paths, iterations))


def angle_between(a, b):
    return float(np.arccos(np.dot(a, b) / np.linalg.norm(a) / np.linalg.norm(b)))


# ---- a water surface ------------------------------------------------------------------------------------------------

WATER = 1.33


def under_water(radius, height, depth, index):
    """From a point source at this height over the surface to points at this depth: the light between the angles t and
    t + dt from the plumb line, and so from the radius r(t) = height tan t + depth tan t', with sin t = index sin t', to
    r + dr, falls on 2 pi r dr: E = I T sin t / (r dr/dt), T by Fresnel."""
    low, high = np.zeros_like(radius), np.arctan(radius / height)  # refraction brings light nearer to the plumb line
    for _ in range(60):
        t = (low + high) / 2
        too_far = height * np.tan(t) + depth * np.tan(np.arcsin(np.sin(t) / index)) > radius
        low, high = np.where(too_far, low, t), np.where(too_far, t, high)
    within = np.arcsin(np.sin(t) / index)
    slope = height / np.cos(t) ** 2 + depth * np.cos(t) / (index * np.cos(within) ** 3)
    # sin t / r, in a form that has a value on the plumb line.
    around = 1 / (height / np.cos(t) + depth / (index * np.cos(within)))
    s, p = fresnel(np.cos(t), index)
    return CANDELA * (1 - (s + p) / 2) * around / slope


def water():
    """A lamp 1 m over a pool of 1 m, 25 meters 0.5 m apart on its floor."""
    lamp, level = (2.1, 2.0, 2.0), 1.0
    points = square_of(5, (2, 2), 0.5, 0.01)

    def build(scene):
        add_room(scene, (0, 0, 0), (4, 4, 3))
        scene.shape("water", quad((0, 0, level), (4, 0, 0), (0, 4, 0)),
                    scene.material("water", {"model": "glass", "ior": WATER}))
        scene.point_light("lamp", lamp, CANDELA)

    radius = np.hypot(points[:, 0] - lamp[0], points[:, 1] - lamp[1])
    return Known("water", "under a water surface", build, points,
                 under_water(radius, lamp[2] - level, level - 0.01, WATER), paths(16384, 64))


# ---- a parabolic reflector ------------------------------------------------------------------------------------------

def parabola():
    """A point source in the focus (f 50 mm, rim 100 mm); 25 meters on the axis and beside it, at five distances, all
    lit alike by the parallel light: E = rho I / r^2 with r = f + h^2 / 4f from the focus to the mirror at the height h
    over the axis; straight light comes on top. Nearer than half a metre its facets change that by less than 0.1 %."""
    reflector = Parabola(0.050, 0.100)
    points = np.array([(x, 0.0, -below) for below in (0.1, 0.2, 0.3, 0.4, 0.5) for x in (0, 0.02, 0.04, 0.06, 0.08)])

    def build(scene):
        add_room(scene, (-1, -1, -1), (1, 1, 1))
        reflector.add(scene)
        scene.point_light("source", (0, 0, reflector.focus), CANDELA)

    h2, down = points[:, 0] ** 2 + points[:, 1] ** 2, reflector.focus - points[:, 2]
    truth = RHO * CANDELA / (reflector.f + h2 / (4 * reflector.f)) ** 2 + CANDELA * down / (h2 + down ** 2) ** 1.5
    return Known("parabola", "a parabolic reflector's beam", build, points, truth, paths(16384, 64))
