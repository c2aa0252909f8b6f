"""Cases of simple sources, of the far field, of integrating spheres and of furnaces: the answers hold in closed form at
every distance, for any number of reflections."""
import math
import os

import need_numpy  # noqa: F401
import numpy as np
import references as ref
from fixture_parts import BLACK, inside, ring
from gltf_builder import Frame, GltfBuilder
from harness import Case, Check
from ies import write_axial
from shapes import Mesh, box, check_closed, icosphere, quad

LUMINANCE = 1000.0  # cd/m2
WORLD = Frame.upright((0, 0, 0))  # with this frame a node's local axes are the world's


def start():
    return GltfBuilder("UPS sources_and_furnaces.py")


def emitter(scene, luminance=LUMINANCE, reflectance=0.0):
    return scene.material("emitter", {"model": "matte", "reflectance": reflectance}, luminance=luminance)


def face_down(x0, x1, y0, y1, z=0.0):
    return quad((x0, y0, z), (0, y1 - y0, 0), (x1 - x0, 0, 0))


# Simple sources.

DISTANCES = (1.01, 1.1, 1.5, 2, 5, 20, 100)  # from the centre of the sphere, in radii


def build_sphere(path):
    scene, radius = start(), 0.1
    ball = icosphere(radius, 5)
    # The luminance that gives the polyhedron the flux of the sphere.
    scene.shape("ball", check_closed(ball, "ball"), emitter(scene, LUMINANCE * 4 * math.pi * radius ** 2 / ball.area()))
    directions = np.array([[math.cos(k), math.sin(k), 0.7 * math.cos(3 * k)] for k in range(len(DISTANCES))])
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    scene.meters("around", WORLD, points_m=(directions * radius * np.array(DISTANCES)[:, None]).tolist(),
                 normals=(-directions).tolist())
    scene.write(path)


def case_sphere():
    """E = pi L r^2 / d^2 at every distance from the centre."""
    checks = [Check("around", math.pi * LUMINANCE / d ** 2, i, f"{d:g} radii") for i, d in enumerate(DISTANCES)]
    return Case("source_sphere", "luminous sphere: inverse square at every distance", build_sphere, checks)


def build_flat(path, shape, points, normals):
    scene = start()
    scene.shape("source", shape, emitter(scene))
    scene.meters("points", WORLD, points_m=[list(p) for p in points], normals=[list(n) for n in normals])
    scene.write(path)


def case_disc():
    """On the axis E = pi L R^2 / (R^2 + d^2)."""
    radius, distances = 0.3, (0.03, 0.3, 2.0, 6.0)
    checks = [Check("points", math.pi * LUMINANCE * radius ** 2 / (radius ** 2 + d ** 2), i, f"{d:g} m")
              for i, d in enumerate(distances)]
    points = [(0, 0, -d) for d in distances]
    return Case("source_disc", "luminous disc of 0.6 m, on its axis",
                lambda path: build_flat(path, ring(0, radius, segments=512), points, [(0, 0, 1)] * len(points)), checks)


# An irregular heptagon in a tilted plane: star-shaped about its first corner, so a fan of triangles.
HEPTAGON = np.array([(0.0, 0.0), (0.9, -0.3), (1.3, 0.2), (1.0, 0.5), (1.2, 1.0), (0.5, 0.8), (-0.2, 0.7)])


def polygon_corners():
    u, v = np.array([0.8, 0.0, 0.6]), np.array([0.0, 1.0, 0.0])
    return [np.array([0.1, -0.2, 1.0]) + a * u + b * v for a, b in HEPTAGON]


def cases_polygons():
    square = [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    wall = [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)]
    heptagon = polygon_corners()
    fan = Mesh(np.array(heptagon), np.array([[0, k + 1, k] for k in range(1, 6)]))
    up, slant = (0, 0, 1), tuple(np.array([2, -1, 3]) / math.sqrt(14))
    settings = [
        ("source_square", "luminous square of 1 m, parallel", square, face_down(0, 1, 0, 1, 1.0),
         [((0.5, 0.5, 0), up, "below the centre"), ((0, 0, 0), up, "below a corner"), ((-2, 3, 0), up, "far aside")]),
        ("source_wall", "luminous square of 1 m, across the meters' plane", wall, quad((0, 0, 0), (0, 0, 1), (1, 0, 0)),
         [((0, 1, 0), up, "1 m from a corner"), ((0.5, 0.1, 0.4), up, "half below the horizon")]),
        ("source_polygon", "luminous heptagon, tilted", heptagon, fan,
         [((0.5, 0.2, 0), up, "below"), ((1.0, -0.5, 0.4), slant, "slanting"),
          ((1.5, 1.5, 1.2), (0, -1, 0), "cut by the horizon")]),
    ]
    cases = []
    for name, title, corners, shape, meters in settings:
        checks = [Check("points", math.pi * LUMINANCE * ref.polygon_factor(p, np.array(n, float), corners), i, label)
                  for i, (p, n, label) in enumerate(meters)]
        cases.append(Case(name, title, lambda path, shape=shape, meters=meters:
                          build_flat(path, shape, [m[0] for m in meters], [m[1] for m in meters]), checks))
    return cases


# How far is far? Luminaires of the largest dimension D = 0.1 m, each in a compartment of its own, all with the same
# intensities I0 cos(gamma): on their axes the point formula I / d^2 is high by 25 % at D, by 1 % at five times D (a
# disc: exactly (D / 2d)^2). The luminous openings of their files make the difference; without one it is the point
# formula.

SIZE, TIMES = 0.1, (1, 2, 3, 5, 7, 10, 15)
SPACING = 1.0
CANDELA = 10.0  # of each, at the photometric zero: so that none drowns the others in noise
SIDE, WIDTH = SIZE / math.sqrt(2), SIZE / 200  # of a square whose diagonal is D; of a line
FIVE_TIMES = {"disc": (-SIZE, -SIZE, 0), "square": (SIDE, SIDE, 0), "line": (WIDTH, SIZE, 0), "point": (0, 0, 0)}


def build_five_times(path):
    scene = start()
    black = scene.material("black", BLACK)
    gamma = list(range(91))
    for i, (name, opening) in enumerate(FIVE_TIMES.items()):
        file = f"{os.path.splitext(path)[0]}_{name}.ies"
        write_axial(file, gamma, [CANDELA * math.cos(math.radians(g)) for g in gamma],
                    [("TEST", f"a luminous {name} of 100 mm")], digits=6, opening=opening)
        x = i * SPACING
        # The photometric zero, local -z, points down.
        scene.luminaire(name, Frame.upright((x, 0, 0)), file=os.path.basename(file))
        scene.shape(f"wall {i}", quad((x + SPACING / 2, -1, -1.8), (0, 2, 0), (0, 0, 2)), black)
        scene.meters(name, WORLD, points_m=[[x, 0, -k * SIZE] for k in TIMES], normals=[[0, 0, 1]] * len(TIMES))
    scene.write(path)


def five_times_lux(name, d):
    width, length, _ = FIVE_TIMES[name]
    if name in ("square", "line"):
        corners = ref.horizontal(-length / 2, length / 2, -width / 2, width / 2, 0.0)
        return math.pi * CANDELA / (width * length) * ref.polygon_factor((0, 0, -d), (0, 0, 1), corners)
    return CANDELA / (d ** 2 + (length / 2) ** 2)


def case_five_times():
    checks = []
    for name in FIVE_TIMES:
        for i, k in enumerate(TIMES):
            lux = five_times_lux(name, k * SIZE)
            high = 100 * (CANDELA / (k * SIZE) ** 2 / lux - 1)
            checks.append(Check(name, lux, i, f"{name}, {k} D", f"I / d^2 is {high:.2f} % high"))
    return Case("five_times", "five-times rule: openings of luminaire files, disc, square, line and point",
                build_five_times, checks, fast={"pt": 832})  # all methods shoot the same shadow rays


# Integrating spheres of 1 m radius. The references take the area of the polyhedron.

FLUX = 10000.0  # lm


def wall_of_sphere(level=4):
    return inside(icosphere(1.0, level, smooth=False))


def on_triangles(mesh, chosen):
    """Centroids and normals as words of meters."""
    at = mesh.positions[mesh.triangles[chosen]].mean(axis=1)
    normal = mesh.face_vectors()[chosen]
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    return dict(points_m=np.round(at, 7).tolist(), normals=np.round(normal, 7).tolist())


def port_sphere(port):
    """The wall, and a black port around the lower pole of about this share of the area; their exact shares."""
    mesh = wall_of_sphere()
    low = mesh.positions[mesh.triangles].mean(axis=1)[:, 2] < 2 * port - 1
    parts = [Mesh(mesh.positions, mesh.triangles[keep]) for keep in (~low, low)]
    return parts, parts[1].area() / mesh.area(), mesh.area()


def build_port(path, rho, port):
    scene = start()
    (wall, cap), _, _ = port_sphere(port)
    scene.shape("wall", wall, scene.material("wall", {"model": "matte", "reflectance": rho}))
    scene.shape("port", cap, scene.material("black", BLACK))
    scene.point_light("source", (0, 0, 0), FLUX / (4 * math.pi))
    scene.meters("wall", WORLD, **on_triangles(wall, np.linspace(0, len(wall.triangles) - 1, 16).astype(int)))
    scene.meters("port", WORLD, **on_triangles(cap, np.linspace(0, len(cap.triangles) - 1, 8).astype(int)))
    scene.write(path)


def case_port(rho, port, **more):
    """The first flux lies evenly on wall and port, as all that follows: E = Phi / (A (1 - rho (1 - f)))."""
    _, share, area = port_sphere(port)
    lux = FLUX / (area * (1 - rho * (1 - share)))
    return Case(f"sphere_port_{100 * rho:.0f}", f"integrating sphere, reflectance {rho:g}, port {port:.0%}",
                lambda path: build_port(path, rho, port),
                [Check("wall", lux),
                 Check("port", lux, note=f"{100 * lux * share * area / FLUX:.1f} % of the flux leaves")], **more)


OFFSET, OFF_RHO = 0.5, 0.7


def build_off_centre(path):
    scene, wall = start(), wall_of_sphere()
    scene.shape("wall", wall, scene.material("wall", {"model": "matte", "reflectance": OFF_RHO}))
    scene.point_light("source", (OFFSET, 0, 0), FLUX / (4 * math.pi))
    scene.meters("wall", WORLD, **on_triangles(wall, off_centre_triangles(wall)))
    scene.write(path)


def off_centre_triangles(wall):
    """The nearest to the source, the farthest, and some between."""
    order = np.argsort(wall.positions[wall.triangles].mean(axis=1)[:, 0])
    return order[np.linspace(0, len(order) - 1, 5).astype(int)]


def case_off_centre():
    """Wherever the source stands, reflected light is the same everywhere: E = direct + rho Phi / (A (1 - rho))."""
    wall = wall_of_sphere()
    meters = on_triangles(wall, off_centre_triangles(wall))
    checks = []
    for i, (p, n) in enumerate(zip(meters["points_m"], meters["normals"])):
        to_source = np.array([OFFSET, 0, 0]) - p
        direct = FLUX / (4 * math.pi) * (to_source @ n) / np.linalg.norm(to_source) ** 3
        reflected = OFF_RHO * FLUX / (wall.area() * (1 - OFF_RHO))
        checks.append(Check("wall", direct + reflected, i, f"x {p[0]:+.2f} m",
                            f"direct {100 * direct / (direct + reflected):.0f} %"))
    return Case("sphere_off_centre", "integrating sphere, reflectance 0.7, source off the centre", build_off_centre,
                checks, iterations=256, fast={"ups": 96, "pt": 32})


# Furnaces.

def add_guests(scene, materials):
    """Things that stand in the way, one a material. With facets: eye paths lose light by interpolated normals, in
    grazing directions that the normal lets through and the facet does not; smooth, they cost the balance 0.2 %."""
    for k, (name, ups) in enumerate(materials.items()):
        angle = 2 * math.pi * k / len(materials)
        at = (0.55 * math.cos(angle), 0.55 * math.sin(angle), 0.1 * k - 0.2)
        scene.shape(name, check_closed(icosphere(0.25, 3, smooth=False), name).moved(*at), scene.material(name, ups))


GUESTS = {"white": {"model": "matte", "reflectance": 1}, "mirror": {"model": "mirror", "reflectance": 1},
          "glass": {"model": "glass", "ior": 1.5}, "rough glass": {"model": "glass", "ior": 1.5, "roughness": 0.5},
          "rough metal": {"model": "metal", "reflectance": 1, "roughness": 0.5}}


# Where, and what they face. Cells, not points: photons merged around a point would bring the curvature of caustics with
# them.
WHITE_CELLS = [((0, 0, 0), (1, 0, 0)), ((0.3, 0.2, -0.2), (1, 1, 0)), ((0, 0, 0.5), (0.1, 0, -1)),
               ((-0.2, 0.1, 0.1), (-1, 0, 0)), ((-0.4, -0.75, 0.1), (0, 1, 0))]


def build_white_furnace(path):
    scene = start()
    scene.shape("room", inside(box((-1, -1, -1), (1, 1, 1))), emitter(scene))
    add_guests(scene, GUESTS)
    for k, (at, normal) in enumerate(WHITE_CELLS):
        scene.meters(f"cell_{k}", Frame.facing(at, normal), width_m=0.1, height_m=0.1, columns=2, rows=2, area=True)
    scene.write(path)


def case_white_furnace():
    """In front of a uniform luminance nothing that only scatters can be seen: E = pi L."""
    checks = [Check(f"cell_{k}", math.pi * LUMINANCE) for k in range(len(WHITE_CELLS))]
    return Case("furnace_white", "white furnace: things of reflectance 1 in a luminous room", build_white_furnace,
                checks, iterations={"ups": 512, "bpt": 384, "pt": 128}, fast={"ups": 160, "pt": 64})


FURNACE_RHO, FURNACE_L = 0.8, 100.0


def build_furnace(path):
    scene = start()
    wall = emitter(scene, FURNACE_L, FURNACE_RHO)
    scene.shape("room", inside(box((0, 0, 0), (4, 3, 2.5))), wall)
    scene.shape("box", box((1, 1, 0.2), (2, 2, 1)), wall)
    meters = [((3, 1, 0), (0, 0, 1)), ((0, 1.5, 2), (1, 0, 0)), ((3, 2, 1.3), (0.3, -2, 1)), ((1.5, 1.5, 1), (0, 0, 1))]
    scene.meters("anywhere", WORLD, points_m=[list(p) for p, _ in meters], normals=[list(n) for _, n in meters])
    scene.write(path)


def case_furnace():
    """L = Le / (1 - rho) everywhere, whatever the shape."""
    lux = math.pi * FURNACE_L / (1 - FURNACE_RHO)
    return Case("furnace", "closed furnace: all surfaces emit and reflect 0.8", build_furnace,
                [Check("anywhere", lux, i, f"meter {i}") for i in range(4)], iterations=256, fast={"ups": 160})


# A closed room loses no light: with walls, things and a lamp of reflectance 1 all of it ends in the floor,
# (1 - rho) E A = Phi.

FLOOR_RHO, LAMP_RADIUS = 0.2, 0.3


def build_balance(path, guests):
    scene = start()
    room = inside(box((-1, -1, -1), (1, 1, 1)))
    floor = room.positions[room.triangles][:, :, 2].max(axis=1) < 0
    for name, keep, rho in (("walls", ~floor, 1.0), ("floor", floor, FLOOR_RHO)):
        scene.shape(name, Mesh(room.positions, room.triangles[keep]),
                    scene.material(name, {"model": "matte", "reflectance": rho}))
    add_guests(scene, {name: GUESTS[name] for name in guests})
    lamp = icosphere(LAMP_RADIUS, 3, smooth=False)
    scene.shape("lamp", lamp.moved(0, 0, 0.6), emitter(scene, FLUX / (math.pi * lamp.area()), 1.0))
    scene.meters("floor", Frame.upright((0, 0, -1)), width_m=2, height_m=2, columns=4, rows=4, area=True)
    scene.write(path)


def case_balance(name, guests, **more):
    return Case(name, f"flux conservation: closed room, {', '.join(guests)}; the floor takes all",
                lambda path: build_balance(path, guests), [Check("floor", FLUX / (4 * (1 - FLOOR_RHO)))],
                iterations={"ups": 64, "bpt": 64, "pt": 256}, **more)


def cases():
    return [
        case_disc(), case_sphere(), *cases_polygons(), case_five_times(),
        case_port(0.9, 0.05, fast={"ups": 20}), case_port(0.95, 0.02, fast=()), case_port(0.98, 0.05, fast=()),
        case_off_centre(),
        case_white_furnace(), case_furnace(),
        case_balance("flux_balance", ("glass", "mirror", "white"), fast={"ups": 24}),
        case_balance("flux_balance_rough", ("rough glass", "rough metal"), fast=()),
    ]
