"""Cases of glass: plano-convex and stigmatic lenses, the limit of etendue, stacks of plates.

Collimated light (a directional light) that a lens gathers, or a large luminous surface seen through it. Lenses hang
with their axis upright, light comes from above. The references split each ray at each interface, so they contain what
inner reflections bring; only light that leaves by the lens's edge they give up, less than 1e-4.
"""
import math

import need_numpy  # noqa: F401
import numpy as np
from fixture_parts import BLACK, SEGMENTS, add_square, equal_area, inside, ring
from gltf_builder import Frame, GltfBuilder
from harness import Case, Check
from optics import (Conic, Lens, Rays, focused_illuminance, integral, plates_transmittance, through_hole,
                    through_hole_mean)
from shapes import box, check_closed, icosphere, lathe, plate_with_holes, quad

LUX = 1000.0  # of collimated light, across it
LUMINANCE = 1000.0  # cd/m2
N = 1.5
GLASS = {"model": "glass", "ior": N}
PARALLEL = "parallel light reaches a meter through glass by light paths alone"
RINGS = 256


def lens_mesh(lens, segments, rings):
    r = np.linspace(0, lens.rim, rings + 1)
    one = np.ones_like(r)
    bottom = np.stack([r, lens.bottom.z(r), lens.bottom.slope(r), -one], 1)
    top = np.stack([r, lens.top.z(r), -lens.top.slope(r), one], 1)[::-1]
    edge = [] if lens.edge_height() < 1e-6 else [np.stack([bottom[-1, :2], top[0, :2]])]
    return check_closed(lathe([bottom, *edge, top], segments), "lens")


def add_points(scene, name, at, count=4):
    """Meters at one place, facing up: more of them get more eye paths an iteration."""
    scene.meters(name, Frame.upright(at), points_m=[[0, 0, 0]] * count, normals=[[0, 0, 1]] * count)


# Lenses in collimated light.

def plano_convex(convex_first):
    """R = 50 mm, f = R / (n - 1) = 100 mm, 6 mm thick, with a sharp edge; the last vertex lies at z = 0."""
    rim = math.sqrt(0.05 ** 2 - 0.044 ** 2)
    top, bottom = (Conic(0.006, -1 / 0.05), Conic(0.0)) if convex_first else (Conic(0.006), Conic(0.0, 1 / 0.05))
    return Lens(top, bottom, rim, N)


def stigmatic():
    """A plane and a hyperboloid of conic constant -n^2 and vertex radius f (n - 1): all light that is parallel to the
    axis crosses it f = 100 mm below the vertex, which lies at z = 0."""
    return Lens(Conic(0.030), Conic(0.0, 1 / (0.1 * (N - 1)), -N * N), 0.062, N)


def crossing(lens, height):
    """z at which a ray that comes parallel to the axis at this height crosses the axis behind the lens."""
    h = np.array([height])
    rays = lens.leaving(Rays(h, h * 0 + 1, h * 0, h * 0 - 1, h * 0 + 1))[1][1]
    return float(rays.z[0] - rays.x[0] / rays.u[0] * rays.w[0])


def focus_case(name, title, lens, zone, cells, fine=1, **more):
    """Light through a hole of these radii onto square cells: {name: (z, half a side)}."""
    segments, rings = fine * SEGMENTS, fine * RINGS
    inner, outer = zone

    def build(path):
        scene = GltfBuilder("UPS lenses.py")
        scene.shape("lens", lens_mesh(lens, segments, rings), scene.material("glass", GLASS))
        black = scene.material("black", BLACK)
        above = max(float(lens.top.z(np.array(r))) for r in (0.0, lens.rim)) + 0.001
        scene.shape("screen", ring(outer, lens.rim + 0.001, above, segments), black)
        if inner:
            scene.shape("stop", ring(0, inner, above, segments), black)
        scene.directional_light("light", (0, 0, -1), LUX)
        for cell, (z, half_side) in cells.items():
            add_square(scene, cell, half_side, (0, 0, z), columns=1)
        scene.write(path)

    checks = [Check(cell, focused_illuminance(lens, LUX, inner, outer, z, half_side),
                    note=f"{-1000 * z:.2f} mm behind the lens, {2000 * half_side:g} mm wide")
              for cell, (z, half_side) in cells.items()]
    return Case(name, title, build, checks, ("ups",), cannot=(("bpt", PARALLEL), ("pt", PARALLEL)), **more)


def plano_convex_case(convex_first, half_side, suffix="", **more):
    """How much crosses the axis where does spherical aberration tell: cells where rays of three heights do so."""
    lens, side = plano_convex(convex_first), "convex" if convex_first else "plane"
    cells = {f"h_{h}_mm": (crossing(lens, h / 1000), half_side) for h in (1, 10, 20)}
    return focus_case(f"lens_{side}_first{suffix}", f"plano-convex lens, {side} side first", lens, (0, 0.020), cells,
                      **more)


def zone_case(convex_first, **more):
    """Light of one zone alone, where it crosses the axis: in a cell as wide as it is there."""
    lens, side, zone = plano_convex(convex_first), "convex" if convex_first else "plane", (0.019, 0.020)
    ends = [crossing(lens, h) for h in zone]
    half_side = abs(ends[1] - ends[0]) * zone[1] / abs(ends[1])
    cells = {"crossing": (sum(ends) / 2, half_side)}
    return focus_case(f"lens_{side}_first_zone", f"plano-convex lens, {side} side first, zone of 19 to 20 mm", lens,
                      zone, cells, **more)


# A lens before a large luminous surface: E = pi L T sin^2 of the half-angle at which it is seen, for any lens.

def build_etendue(path, lens, hole, height):
    scene = GltfBuilder("UPS lenses.py")
    scene.shape("lens", lens_mesh(lens, SEGMENTS, RINGS), scene.material("glass", GLASS))
    black = scene.material("black", BLACK)
    top = float(lens.top.z(np.array(0.0)))
    scene.shape("screen", ring(hole, 0.2, top + 0.001), black)
    scene.shape("emitter", quad((-0.2, -0.2, top + 0.05), (0, 0.4, 0), (0.4, 0, 0)),
                scene.material("emitter", BLACK, luminance=LUMINANCE))
    add_points(scene, "focus", (0, 0, height))
    scene.write(path)


def case_etendue():
    """A meter in the focus of the stigmatic lens. Rays from it leave the lens parallel, so the hole in the screen lets
    in those that meet the lens within the same radius."""
    lens, hole, height = stigmatic(), 0.060, -0.1
    limit = hole / math.hypot(hole, float(lens.bottom.z(np.array(hole))) - height)  # sin of the half-angle

    def transmitted(sine_squared):
        sine = np.sqrt(sine_squared)
        zero = np.zeros_like(sine)
        rays = Rays(zero, zero + height, sine, np.sqrt(1 - sine_squared), zero + 1)
        return sum(np.where(np.abs(out.at(lens.top.height + 0.001)) < hole + 1e-9, out.share, 0)
                   for up, out in lens.leaving(rays) if up)
    lux = math.pi * LUMINANCE * integral(transmitted, 0, limit ** 2, 400)
    share = lux / (math.pi * LUMINANCE * limit ** 2)
    return Case("etendue", "etendue: luminous surface through a lens, sin a 0.43",
                lambda path: build_etendue(path, lens, hole, height),
                [Check("focus", lux, note=f"T {share:.4f}, pi L sin^2 a {math.pi * LUMINANCE * limit ** 2:.1f}")],
                iterations={"ups": 1024})


# Inside glass, n^2 more: the centre of a ball sees the furnace in all directions, E = n^2 pi L; so does every point
# nearer to it than R / n, from where nothing is totally reflected.

def build_immersed(path):
    scene = GltfBuilder("UPS lenses.py")
    scene.shape("room", inside(box((-1, -1, -1), (1, 1, 1))), scene.material("emitter", BLACK, luminance=LUMINANCE))
    scene.shape("ball", check_closed(icosphere(0.3, 5), "ball"), scene.material("glass", GLASS))
    for name, x in (("centre", 0.0), ("aside", 0.15)):
        add_points(scene, name, (x, 0, 0))
    scene.write(path)


def case_immersed():
    lux = N * N * math.pi * LUMINANCE
    return Case("etendue_immersed", "etendue: meters inside a glass ball in a luminous room, n^2 pi L", build_immersed,
                [Check("centre", lux), Check("aside", lux)], fast=("bpt", "pt"))


# Stacks of plates, 1 to 4 side by side.

PLATES = (1, 2, 3, 4)
PITCH, HALF, THICKNESS, GAP = 0.5, 0.24, 0.004, 0.004  # HALF: half a side of the plates


def add_stacks(scene, bottom):
    glass = scene.material("glass", GLASS)
    for k in PLATES:
        for i in range(k):
            z = bottom + i * (THICKNESS + GAP)
            x = k * PITCH
            scene.shape(f"plate {k}.{i}", box((x - HALF, -HALF, z), (x + HALF, HALF, z + THICKNESS)), glass)


def build_plates(path):
    scene = GltfBuilder("UPS lenses.py")
    add_stacks(scene, 0)
    scene.directional_light("light", (0, 0, -1), LUX)
    for k in PLATES:
        add_square(scene, f"plates_{k}", 0.22, (k * PITCH, 0, -0.01), columns=1)
    scene.write(path)


def case_plates():
    checks = [Check(f"plates_{k}", LUX * float(plates_transmittance(1.0, N, k)),
                    note=f"T {float(plates_transmittance(1.0, N, k)):.4f}") for k in PLATES]
    return Case("plates", "stacks of 1 to 4 plates in parallel light: T = (1 - R) / (1 + (2k - 1) R)", build_plates,
                checks, ("ups",), iterations=512, cannot=(("bpt", PARALLEL), ("pt", PARALLEL)))


HOLE, BELOW, CELL = 0.06, 0.08, 0.02  # radius of the screen's hole, its height over the cells, side of their square


def build_plates_cone(path):
    """Cells in compartments of their own, each under a hole in a screen below the plates."""
    scene = GltfBuilder("UPS lenses.py")
    black = scene.material("black", BLACK)
    add_stacks(scene, BELOW + 0.005)
    for k in PLATES:
        x = k * PITCH
        scene.shape(f"screen {k}", square_with_hole(0.2499, HOLE, BELOW).moved(x, 0, 0), black)
        scene.shape(f"wall {k}", quad((x + PITCH / 2, -HALF, 0), (0, 2 * HALF, 0), (0, 0, BELOW + 0.06)), black)
        add_square(scene, f"plates_{k}", CELL / 2, (x, 0, 0))
    scene.shape("emitter", quad((PITCH / 2, -HALF, BELOW + 0.07), (0, 2 * HALF, 0), (4 * PITCH, 0, 0)),
                scene.material("emitter", BLACK, luminance=LUMINANCE))
    scene.write(path)


def square_with_hole(half_side, radius, z, segments=SEGMENTS):
    return plate_with_holes((-half_side, half_side), (-half_side, half_side), z, [(0, 0)],
                            equal_area(radius, segments), 1.9 * half_side, segments)


def case_plates_cone():
    checks = []
    for k in PLATES:
        exact, judged = (through_hole_mean(LUMINANCE, HOLE, BELOW, CELL,
                                           lambda c, p=p, k=k: plates_transmittance(c, N, k, p)) for p in (True, False))
        checks.append(Check(f"plates_{k}", judged, note=f"with polarisation {100 * (exact / judged - 1):+.2f} %"))
    return Case("plates_cone", "stacks of 1 to 4 plates under a luminous surface, within 43 degrees", build_plates_cone,
                checks, iterations=192, fast={"ups": 72}, long=True)


# Diffuse light through one plate: a luminous box over it, the meter close below, a screen with a hole that ends what is
# counted at 87 degrees.

def build_diffuse(path, solid):
    scene = GltfBuilder("UPS lenses.py")
    black = scene.material("black", BLACK)
    scene.shape("screen", square_with_hole(1.6, 1.0, 0.05), black)
    if solid:
        plate = check_closed(box((-1.5, -1.5, 0.051), (1.5, 1.5, 0.055)), "plate")
        scene.shape("plate", plate, scene.material("glass", GLASS))
    else:
        scene.shape("plate", quad((-1.5, -1.5, 0.051), (3, 0, 0), (0, 3, 0)),
                    scene.material("glazing", {"model": "glazing", "ior": N}))
    dome = inside(box((-1.6, -1.6, 0.05), (1.6, 1.6, 1.0)))
    dome.triangles = dome.triangles[:-4]  # without top and bottom
    emitter = scene.material("emitter", BLACK, luminance=LUMINANCE)
    scene.shape("sides", dome, emitter)
    scene.shape("top", quad((-1.6, -1.6, 1.0), (0, 3.2, 0), (3.2, 0, 0)), emitter)
    add_points(scene, "below", (0, 0, 0))
    scene.write(path)


def case_diffuse(solid):
    limit = 1 / (1 + 0.05 ** 2)
    exact, judged = (through_hole(LUMINANCE, limit, lambda c, p=p: plates_transmittance(c, N, 1, p))
                     for p in (True, not solid))
    hemispherical = through_hole(1 / math.pi, 1, lambda c: plates_transmittance(c, N))
    if solid:
        name, what = "plate_diffuse_solid", "solid glass"
        note = f"with polarisation {100 * (exact / judged - 1):+.2f} %"
    else:
        name, what, note = "plate_diffuse", "a thin pane", f"T of the hemisphere {hemispherical:.4f}"
    return Case(name, f"diffuse light through {what}",
                lambda path: build_diffuse(path, solid), [Check("below", judged, note=note)])


def cases():
    return [
        focus_case("lens_stigmatic", "stigmatic lens, all light to one point", stigmatic(), (0, 0.060),
                   {"focus": (-0.1, 0.0005)}),
        plano_convex_case(True, 0.0004),
        plano_convex_case(False, 0.001),
        # Twice as fine: what the facets cost.
        plano_convex_case(True, 0.0004, "_fine", fine=2, fast=()),
        zone_case(True, fast=()),
        zone_case(False, fast=()),
        case_etendue(),
        case_immersed(),
        case_plates(),
        case_plates_cone(),
        case_diffuse(False),
        case_diffuse(True),
    ]
