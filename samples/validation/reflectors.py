"""Cases of mirror optics around a small source: parabolic and elliptical reflectors.

All light that matters comes by way of a mirror. A spherical source of radius r and luminance L sends to a point of the
mirror at the distance r_1 the same flux as a point source of pi L r^2 in its centre, in a cone of half-angle
asin(r / r_1). The luminance of the polyhedron that stands for the sphere is L; its flux, pi L times its own area.
"""
import math

import need_numpy  # noqa: F401
import numpy as np
import references as ref
from fixture_parts import BLACK, SEGMENTS, add_square
from gltf_builder import GltfBuilder
from harness import Case, Check
from optics import integral
from shapes import icosphere, lathe

LUMINANCE = 1e6  # cd/m2
RHO = 0.9
AXIS_CELL = 0.003  # half its side, m
RINGS = 256  # between them unit normals are interpolated: wrong in proportion to the square of their distance

NO_DELTA = "the source has no extent, and all light passes a mirror: only photons that land on the cells carry it"
TOO_SMALL = "eye paths find so small a source too seldom"


class Source:
    """A black sphere that emits, at the origin."""

    def __init__(self, radius):
        self.radius, self.mesh = radius, icosphere(radius, 4)
        self.flux = math.pi * LUMINANCE * self.mesh.area()

    def add(self, scene, at):
        black = scene.material("source", BLACK, luminance=LUMINANCE)
        scene.shape("source", self.mesh.moved(*at), black)


def returning_share(half_angle, separation, steps=100):
    """Of a cone of light that a mirror turns by `separation` from its way to the source: what hits the source again,
    which fills a cone of the same half-angle. Weighted by the cosine to the mirror's normal, which lies between."""
    if separation >= 2 * half_angle:
        return 0.0
    a = (np.arange(steps) + 0.5) * half_angle / steps
    b = ((np.arange(steps) + 0.5) * 2 * math.pi / steps)[:, None]
    to_source = np.cos(a) * math.cos(separation) + np.sin(a) * np.cos(b) * math.sin(separation)
    to_normal = np.cos(a) * math.cos(separation / 2) + np.sin(a) * np.cos(b) * math.sin(separation / 2)
    weight = to_normal * np.sin(a) * np.ones_like(b)
    return float(np.sum(weight * (to_source > math.cos(half_angle))) / np.sum(weight))


def reflected_flux(source, limit, distance, separation):
    """Flux that leaves the mirror and misses the source; the mirror reaches to `limit`, an angle at the source from the
    axis, is `distance(angle)` away and turns light by `separation(angle)`."""
    angles = (np.arange(400) + 0.5) * limit / 400
    kept = np.array([1 - returning_share(math.asin(source.radius / distance(a)), separation(a)) for a in angles])
    return RHO * source.flux / 2 * float(np.sum(np.sin(angles) * kept)) * limit / 400


def square_share(half_side, distance):
    """Of all directions: a centred square. A sphere that is wholly visible sends there as much as its centre would."""
    return ref.rectangle_solid_angle(2 * half_side, 2 * half_side, distance) / (4 * math.pi)


def square_mean(function, half_side):
    """Of a function of the distance from the axis."""
    t, w = np.polynomial.legendre.leggauss(8)
    x, y = np.meshgrid(half_side * t, half_side * t)
    return float(np.sum(np.outer(w, w) / 4 * function(np.hypot(x, y))))


def bright_aperture(source, rim, below_rim, below_source, half_side):
    """Mean over a cell from which all of the mirror, out to its rim, shows the source: pi L (rho (F_mirror - F_source)
    + F_source), as the source hides the middle of the mirror. F: configuration factors of a disc, for a parallel
    element off its axis (Hamilton and Morgan 1952), and of a sphere."""
    def lux(x):
        r2, d2 = rim ** 2, below_rim ** 2
        mirror = (1 - (x ** 2 + d2 - r2) / np.sqrt((x ** 2 + d2 + r2) ** 2 - 4 * x ** 2 * r2)) / 2
        sphere = source.radius ** 2 * below_source / (x ** 2 + below_source ** 2) ** 1.5
        return math.pi * LUMINANCE * (RHO * (mirror - sphere) + sphere)
    return square_mean(lux, half_side)


class Parabola:
    """Opens downwards; the aperture, of radius `rim`, lies at z = 0."""

    def __init__(self, focal_length, rim, segments=SEGMENTS, rings=RINGS):
        self.f, self.rim = focal_length, rim
        self.depth = rim ** 2 / (4 * focal_length)
        self.focus = self.depth - focal_length
        self.rim_angle = 2 * math.atan(rim / (2 * focal_length))
        r = np.linspace(0, rim, rings + 1)
        z, down = self.depth - r ** 2 / (4 * focal_length), np.full_like(r, -2 * focal_length)
        self.mesh = lathe([np.stack([r, z, -r, down], 1)], segments)

    def distance(self, angle):
        """From the focus, at this angle from the vertex."""
        return self.f / math.cos(angle / 2) ** 2

    def add(self, scene):
        scene.shape("reflector", self.mesh, scene.material("mirror", {"model": "mirror", "reflectance": RHO}))

    def beam(self, source, half_side, below):
        """Mean over a square cell that catches the whole beam, and what comes straight from the source."""
        flux = reflected_flux(source, self.rim_angle, self.distance, lambda angle: angle)
        direct = source.flux * square_share(half_side, below + self.focus)
        return (flux + direct) / (4 * half_side ** 2)

    def beam_radius(self, source, below):
        """The largest: each point of the mirror sends a cone down."""
        h = np.linspace(0, self.rim, 1000)
        r1 = self.f + h ** 2 / (4 * self.f)
        drop = below + self.depth - h ** 2 / (4 * self.f)
        return float(np.max(h + drop * np.tan(np.arcsin(source.radius / r1))))

    def axis(self, source, half_side, below):
        """Mean over a small cell on the axis, where all of the aperture shows the source."""
        corner = math.sqrt(2) * half_side
        h = np.linspace(0, self.rim, 1000)
        r1, drop = self.f + h ** 2 / (4 * self.f), below + self.depth - h ** 2 / (4 * self.f)
        if (r1 * (h + corner) / np.hypot(h + corner, drop)).max() > source.radius:
            raise ValueError("the aperture is not wholly bright there")
        return bright_aperture(source, self.rim, below, below + self.focus, half_side)


def parabola_case(name, rim, radius, below, half_side, on_axis=None, fine=1, **more):
    mirror, source = Parabola(0.020, rim, fine * SEGMENTS, fine * RINGS), Source(radius)
    if mirror.beam_radius(source, below) > half_side:
        raise ValueError("the cell does not catch the beam")

    def build(path):
        scene = GltfBuilder("UPS reflectors.py")
        mirror.add(scene)
        source.add(scene, (0, 0, mirror.focus))
        add_square(scene, "beam", half_side, (0, 0, -below))
        if on_axis:
            add_square(scene, "axis", AXIS_CELL, (0, 0, -on_axis))
        scene.write(path)

    share = (1 - math.cos(mirror.rim_angle)) / 2
    checks = [Check("beam", mirror.beam(source, half_side, below), note=f"mirror catches {100 * share:.1f} %")]
    if on_axis:
        checks.append(Check("axis", mirror.axis(source, AXIS_CELL, on_axis),
                            note=f"{1000 * on_axis:g} mm below the aperture"))
    return Case(name, f"parabolic reflector, f 20 mm, rim {1000 * rim:g} mm, source {1000 * radius:g} mm", build,
                checks, **more)


def collimated_case():
    """A point source of I in the focus: its light leaves parallel, E = rho I / r_1^2 with r_1 = f + h^2 / 4f at the
    height h over the axis, at any distance; straight light comes on top."""
    mirror, candela = Parabola(0.020, 0.060), 1000.0
    cells = {"middle": (0.0, 0.0, 0.020), "side": (0.035, 0.0, 0.030)}  # centre and side
    planes = {"near": 0.05, "far": 1.0}

    def lux(x, y, below):
        d = below + mirror.focus
        return (RHO * candela / (mirror.f + (x * x + y * y) / (4 * mirror.f)) ** 2
                + candela * d / (x * x + y * y + d * d) ** 1.5)

    def mean(x, y, side, below):
        def column(at):
            return integral(lambda v: lux(at, v, below), y - side / 2, y + side / 2)
        return integral(lambda u: np.array([column(at) for at in u]), x - side / 2, x + side / 2) / side ** 2

    def build(path):
        scene = GltfBuilder("UPS reflectors.py")
        mirror.add(scene)
        scene.point_light("source", (0, 0, mirror.focus), candela)
        for where, below in planes.items():
            for name, (x, y, side) in cells.items():
                add_square(scene, f"{name}_{where}", side / 2, (x, y, -below), columns=1)
        scene.write(path)

    checks = [Check(f"{name}_{where}", mean(*cell, below)) for where, below in planes.items()
              for name, cell in cells.items()]
    return Case("parabola_point", "parabolic reflector, point source: parallel light", build, checks, ("ups",),
                cannot=(("bpt", NO_DELTA), ("pt", NO_DELTA)))


class Ellipse:
    """From the vertex above the focus F1, at the origin, to the plane of F1; opens downwards, F2 at z = -2c."""

    def __init__(self, semi_axis, half_distance, segments=SEGMENTS, rings=RINGS):
        self.a, self.c = semi_axis, half_distance
        self.b = math.sqrt(semi_axis ** 2 - half_distance ** 2)
        t = np.linspace(0, math.acos(half_distance / semi_axis), rings + 1)
        r, z = self.b * np.sin(t), self.a * np.cos(t)
        self.mesh = lathe([np.stack([r, z - self.c, -r / self.b ** 2, -z / self.a ** 2], 1)], segments)
        self.magnification = (self.a + self.c) / (self.a - self.c)  # the largest, at the vertex

    def distance(self, angle):
        """From F1, at this angle from the vertex."""
        return self.b ** 2 / (self.a + self.c * math.cos(angle))

    def separation(self, angle):
        """Angle between the ways to F1 and to F2."""
        r1 = self.distance(angle)
        r2 = 2 * self.a - r1
        return math.acos(max(-1.0, min(1.0, (r1 ** 2 + r2 ** 2 - 4 * self.c ** 2) / (2 * r1 * r2))))

    def focus(self, source, half_side):
        """Mean over a small cell around F2, from which every ray into the mirror ends on the source."""
        if math.sqrt(2) * half_side > source.radius * (2 * self.a * self.a / self.b ** 2 - 1):
            raise ValueError("the mirror is not wholly bright there")
        return bright_aperture(source, self.b ** 2 / self.a, 2 * self.c, 2 * self.c, half_side)


def ellipse_case(name, half_distance, radius, fine=1, **more):
    mirror, source = Ellipse(0.1, half_distance, fine * SEGMENTS, fine * RINGS), Source(radius)
    flux = reflected_flux(source, math.pi / 2, mirror.distance, mirror.separation)
    squares = {"image": 1.02 * mirror.magnification * radius, "around": 2 * mirror.magnification * radius}

    def build(path):
        scene = GltfBuilder("UPS reflectors.py")
        scene.shape("reflector", mirror.mesh, scene.material("mirror", {"model": "mirror", "reflectance": RHO}))
        source.add(scene, (0, 0, 0))
        add_square(scene, "focus", AXIS_CELL, (0, 0, -2 * half_distance))
        for square, half_side in squares.items():
            add_square(scene, square, half_side, (0, 0, -2 * half_distance), 4 if square == "image" else 8)
        scene.write(path)

    checks = [Check("focus", mirror.focus(source, AXIS_CELL), note="F2")]
    for square, half_side in squares.items():
        direct = source.flux * square_share(half_side, 2 * half_distance)
        checks.append(Check(square, (flux + direct) / (4 * half_side ** 2),
                            note=f"half a side {half_side / radius / mirror.magnification:.2f} m r"))
    return Case(name, f"elliptical reflector, c/a {half_distance / 0.1:g}, m {mirror.magnification:.0f}, "
                f"source {1000 * radius:g} mm", build, checks, **more)


def cases():
    small = dict(methods=("ups",), cannot=(("bpt", TOO_SMALL), ("pt", TOO_SMALL)))
    return [
        parabola_case("parabola", 0.040, 0.008, 0.05, 0.055, on_axis=0.26, fast={"ups": 224, "pt": 224},
                      iterations=256),
        parabola_case("parabola_small", 0.060, 0.001, 0.05, 0.065, **small),
        collimated_case(),
        ellipse_case("ellipse", 0.05, 0.005, fast={"ups": 40}, iterations={"bpt": 128, "pt": 128}),
        parabola_case("parabola_40", 0.040, 0.001, 0.3, 0.06, fast=(), **small),
        parabola_case("parabola_100", 0.100, 0.001, 0.3, 0.105, fast=(), **small),
        # Twice as fine: what the facets cost.
        parabola_case("parabola_fine", 0.040, 0.008, 0.05, 0.055, on_axis=0.26, fine=2, fast=(), iterations=256),
        ellipse_case("ellipse_fine", 0.05, 0.005, fine=2, fast=(), iterations={"bpt": 128, "pt": 128}),
        ellipse_case("ellipse_9", 0.08, 0.002, fast=(), iterations={"bpt": 1024, "pt": 1024}),
    ]
