"""Rooms that several checks share: an office, a hall, an atrium, a room with a box of glass. Each is a function of a
GltfBuilder and the folder that gets the luminaires' file; `write` makes the scene's file of one.

Called by scripts that measure what effects cost and whether the techniques were well chosen.
"""
import contextlib
import io
import math
import os

import need_numpy  # noqa: F401
import numpy as np
import plant
from gltf_builder import Frame, GltfBuilder
from ies import write_axial
from png import encode, srgb_bytes
from shapes import Mesh, box, lathe, merged, quad, rounded_box

LUMINAIRE = "downlight.ies"
PAINTS = {"floor": 0.2, "walls": 0.5, "ceiling": 0.7, "wood": [0.45, 0.30, 0.18], "leaf": [0.10, 0.30, 0.08],
          "clay": 0.4}


def write(path, build, **options):
    """Writes the scene of `build` and the file of its luminaires beside it."""
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    scene = GltfBuilder("UPS rooms.py")
    build(scene, **options)
    with contextlib.redirect_stdout(io.StringIO()):  # the builder says what it has written
        scene.write(path)
    gamma = np.arange(0, 181, 5.0)
    candela = 1000 * np.maximum(np.cos(np.radians(gamma)), 0) ** 4
    write_axial(os.path.join(os.path.dirname(os.path.abspath(path)), LUMINAIRE), gamma, candela,
                [("TEST", "computed by rooms.py"), ("TESTLAB", "none"), ("ISSUEDATE", "2026-01-01"),
                 ("MANUFAC", "UPS samples"), ("LUMINAIRE", "downlight, cos^4")])
    return path


def paint(scene, name, **words):
    return scene.material(name, {"model": "matte", "reflectance": PAINTS.get(name, 0.5), **words})


def add_luminaires(scene, length, width, height, columns, rows, flux):
    """A regular grid of points that share `flux`, lm."""
    for k in range(columns * rows):
        at = ((k % columns + 0.5) * length / columns, (k // columns + 0.5) * width / rows, height)
        scene.luminaire(f"luminaire {k + 1}", Frame.upright(at), file=LUMINAIRE, flux_lm=flux / (columns * rows))


def inside(low, high):
    """The faces of a box turned inwards: {"floor", "walls", "ceiling": Mesh}."""
    faces = box(low, high)
    turned = Mesh(faces.positions, faces.triangles[:, ::-1], -faces.normals)
    heights = turned.positions[turned.triangles][:, :, 2]
    floor, ceiling = (np.all(heights == z, axis=1) for z in (low[2], high[2]))
    return {name: Mesh(turned.positions, turned.triangles[chosen], turned.normals)
            for name, chosen in (("floor", floor), ("walls", ~(floor | ceiling)), ("ceiling", ceiling))}


def add_shell(scene, length, width, height, floor=None, left_out=()):
    for name, face in inside((0, 0, 0), (length, width, height)).items():
        if name == "floor" and floor is not None:
            scene.shape(name, quad((0, 0, 0), (length, 0, 0), (0, width, 0), (1.2, 1.2)), floor)
        elif name not in left_out:
            scene.shape(name, face, paint(scene, name))


def workplane(scene, name, low, high, z, columns, rows):
    scene.meters(name, Frame.upright(((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, z)), width_m=high[0] - low[0],
                 height_m=high[1] - low[1], columns=columns, rows=rows)


# ---- office ---------------------------------------------------------------------------------------------------------

OFFICE = (8.0, 6.0, 3.0)


def boards(scene):
    """glTF's coated boards: colour and roughness differ from board to board."""
    rng = np.random.default_rng(3)
    tone = np.repeat(np.repeat(rng.uniform(0.12, 0.32, (8, 2)), 16, 0), 64, 1)
    gloss = np.repeat(np.repeat(rng.uniform(0.35, 0.6, (8, 2)), 16, 0), 64, 1)
    colour = scene.texture("boards", encode(srgb_bytes(tone[..., None] * np.array([1.0, 0.72, 0.45]))))
    rough = np.stack([np.zeros_like(gloss), gloss, np.zeros_like(gloss)], -1)  # glTF: roughness is green
    packed = scene.texture("boards, roughness", encode((255 * rough).astype(np.uint8)))
    return scene.textured("boards", colour, None, 1.0, roughness=packed)


def add_desks(scene, glossy):
    top = scene.material("desk top", {"model": "plastic", "reflectance": 0.4, "roughness": 0.2, "ior": 1.5} if glossy
                         else {"model": "matte", "reflectance": 0.4})
    legs = scene.material("legs", {"model": "metal", "reflectance": 0.8, "roughness": 0.3} if glossy
                          else {"model": "matte", "reflectance": 0.4})
    tops, feet = [], []
    for x in (1.0, 3.4, 5.8):
        for y in (1.6, 3.6):
            tops.append(box((x, y, 0.69), (x + 1.6, y + 0.8, 0.72)))
            feet += [box((x + dx, y + 0.05, 0), (x + dx + 0.05, y + 0.75, 0.69)) for dx in (0.05, 1.5)]
    scene.shape("desk tops", merged(tops), top)
    scene.shape("desk feet", merged(feet), legs)


def add_water(scene):
    """A basin of 2 m x 0.8 m along a wall, with an open surface of water."""
    (x0, y0), (x1, y1), rim, level = (3.0, 5.15), (5.0, 5.95), 0.45, 0.40
    sides = inside((x0, y0, 0.05), (x1, y1, rim))
    outside = [quad((x0 - 0.05, y0 - 0.05, 0), (x1 - x0 + 0.1, 0, 0), (0, 0, rim)),
               quad((x0 - 0.05, y1 + 0.05, 0), (0, y0 - y1 - 0.1, 0), (0, 0, rim)),
               quad((x1 + 0.05, y0 - 0.05, 0), (0, y1 - y0 + 0.1, 0), (0, 0, rim))]
    edge = [quad((x0 - 0.05, a, rim), (x1 - x0 + 0.1, 0, 0), (0, 0.05, 0)) for a in (y0 - 0.05, y1)]
    edge += [quad((a, y0, rim), (0.05, 0, 0), (0, y1 - y0, 0)) for a in (x0 - 0.05, x1)]
    scene.shape("basin", merged([sides["floor"], sides["walls"], *outside, *edge]), paint(scene, "basin"))
    scene.shape("water", quad((x0, y0, level), (x1 - x0, 0, 0), (0, y1 - y0, 0)),
                scene.material("water", {"model": "glass", "ior": 1.33, "absorption_per_m": [0.60, 0.12, 0.08]}))


def add_downlight(scene, flux=1000.0):
    """A lamp of 9 mm in a specular paraboloid, in a black can below the ceiling."""
    focal, rim, hole = 0.004, 0.025, 0.008
    end = rim ** 2 / (4 * focal) - focal
    parts = [{"emitter": {"shape": "disc", "radius_m": 0.0045, "flux_lm": flux}},
             {"reflector": {"profile": "paraboloid", "focal_length_m": focal, "inner_radius_m": hole,
                            "aperture_radius_m": rim, "finish": "specular_aluminium"}}]
    x, y, z, can = 4.0, 3.0, 2.7, rim + 0.002
    scene.fixture("downlight", Frame.upright((x, y, z + end)), parts)
    scene.shape("can", lathe([[(can, 0), (can, 2 * end)], [(can, 2 * end), (0, 2 * end)]]).moved(x, y, z),
                scene.material("black", {"model": "matte", "reflectance": 0.0}))


def office(scene, effects=(), columns=4, rows=2, grid=(32, 24)):
    """8 m x 6 m x 3 m under eight downlights, photometric points that share 32,000 lm; 768 meters. `effects`: words of
    desks, gloss, pane, mirror, texture, downlight, water; `grid`: columns and rows of meters."""
    length, width, height = OFFICE
    add_shell(scene, length, width, height, boards(scene) if "texture" in effects else None)
    add_luminaires(scene, length, width, height - 0.01, columns, rows, 32000.0)
    if "desks" in effects:
        add_desks(scene, "gloss" in effects)
    if "pane" in effects:
        scene.shape("picture glass", quad((3, 0.01, 1.2), (0, 0, 1), (1, 0, 0)),
                    scene.material("picture glass", {"model": "glazing"}))
    if "mirror" in effects:
        scene.shape("mirror", quad((0.01, 4, 0.9), (0, -1.5, 0), (0, 0, 1.2)),
                    scene.material("mirror", {"model": "mirror", "reflectance": 0.9}))
    if "downlight" in effects:
        add_downlight(scene)
    if "water" in effects:
        add_water(scene)
    workplane(scene, "workplane", (0, 0), (length, width), 0.75, *grid)


# ---- hall, atrium, glass --------------------------------------------------------------------------------------------

def hall(scene, luminaires=64):
    """40 m x 40 m x 5 m under a square grid of `luminaires` points, of 240,000 lm together however many; 256 meters."""
    side, n = 40.0, math.isqrt(luminaires)
    if n * n != luminaires:
        raise ValueError(f"{luminaires} luminaires: a square number is wanted")
    for name, face in inside((0, 0, 0), (side, side, 5)).items():
        scene.shape(name, face, paint(scene, name, reflectance=0.5))
    add_luminaires(scene, side, side, 4.9, n, n, 240000.0)
    workplane(scene, "workplane", (0, 0), (side, side), 0.75, 16, 16)


def ball(radius, facets_around):
    """Of facets_around x facets_around / 2 faces with smooth normals."""
    angle = np.linspace(0, np.pi, facets_around // 2 + 1)
    sine, cosine = np.sin(angle), np.cos(angle)
    sine[[0, -1]] = 0
    return lathe([np.stack([radius * sine, radius * cosine, sine, cosine], 1)], facets_around)


def box_with_balls(scene, facets_around=384):
    """A box of twelve quads, 2 m wide, with a mirror ball and a glass ball under a point light, and a camera: what small
    research renderers are shown with."""
    colours = {"white": 0.76, "red": [0.60, 0.06, 0.06], "green": [0.10, 0.50, 0.10]}
    paints = {name: scene.material(name, {"model": "matte", "reflectance": c}) for name, c in colours.items()}

    def halves(corner, a, b):
        corner, half, b = np.array(corner, float), np.array(a) / 2, np.array(b)
        return [quad(corner, half, b), quad(corner + half, half, b)]

    scene.shape("white", merged(halves((-1, -1, -1), (2, 0, 0), (0, 2, 0)) + halves((-1, 1, 1), (2, 0, 0), (0, -2, 0)) +
                                halves((-1, 1, -1), (2, 0, 0), (0, 0, 2)) + halves((1, -1, -1), (-2, 0, 0), (0, 0, 2))),
                paints["white"])
    scene.shape("red", merged(halves((-1, -1, -1), (0, 2, 0), (0, 0, 2))), paints["red"])
    scene.shape("green", merged(halves((1, 1, -1), (0, -2, 0), (0, 0, 2))), paints["green"])
    for name, x, y, words in (("mirror", -0.45, 0.3, {"model": "mirror", "reflectance": 1.0}),
                              ("glass", 0.45, -0.3, {"model": "glass", "ior": 1.5})):
        scene.shape(name + " ball", ball(0.4, facets_around).moved(x, y, -0.6), scene.material(name, words))
    scene.point_light("lamp", (0, 0, 0.8), 50)
    scene.camera("view", (0, -0.97, 0), (0, 1, -0.2), 80, 512, 512)


def add_plants(scene, places, scale):
    parts = (("pots", plant.pot(), "clay"), ("soil", plant.soil(), "clay"), ("leaves", plant.leaves(), "leaf"))
    for name, part, material in parts:
        scene.shape(name, merged([part.scaled(scale, scale, scale).turned("z", 70 * k).moved(x, y, 0)
                                  for k, (x, y) in enumerate(places)]), paint(scene, material))


def atrium(scene):
    """30 m x 20 m x 12 m with a roof of 50 panes between beams, galleries along two walls, furniture; 400 luminaires,
    of which 240 hang below the roof and 160 below the galleries, 600,000 lm; 384 meters on the floor; a camera. Outside
    it is night."""
    length, width, height, deep = 30.0, 20.0, 12.0, 3.0
    add_shell(scene, length, width, height, left_out=("ceiling",))
    beams = [box((x - 0.1, 0, height - 0.4), (x + 0.1, width, height + 0.1)) for x in np.linspace(0, length, 11)]
    beams += [box((0, y - 0.1, height - 0.4), (length, y + 0.1, height + 0.1)) for y in np.linspace(0, width, 6)]
    scene.shape("beams", merged(beams), paint(scene, "beams"))
    panes = [quad((3 * i, 4 * j + 4, height), (3, 0, 0), (0, -4, 0)) for i in range(10) for j in range(5)]
    scene.shape("roof", merged(panes), scene.material("roof", {"model": "glazing"}))
    levels = (4.0, 8.0)
    slabs = [box((0, y, z - 0.3), (length, y + deep, z)) for z in levels for y in (0, width - deep)]
    scene.shape("galleries", merged(slabs), paint(scene, "ceiling"))
    rails = [quad((0, y, z), (length, 0, 0), (0, 0, 1.1)) for z in levels for y in (deep, width - deep)]
    scene.shape("rails", merged(rails), scene.material("rails", {"model": "glazing"}))
    for k in range(240):
        at = ((k % 24 + 0.5) * length / 24, deep + 0.3 + (k // 24 + 0.5) * (width - 2 * deep - 0.6) / 10, 11.5)
        scene.luminaire(f"roof {k + 1}", Frame.upright(at), file=LUMINAIRE, flux_lm=2000.0)
    for k in range(160):
        at = ((k % 40 + 0.5) * length / 40, (deep / 2, width - deep / 2)[k // 40 % 2], levels[k // 80] - 0.31)
        scene.luminaire(f"gallery {k + 1}", Frame.upright(at), file=LUMINAIRE, flux_lm=750.0)
    tables = [(x, y) for x in np.linspace(4, 22, 7) for y in (5.5, 14.5)]
    scene.shape("tables", merged([rounded_box((x, y - 0.5, 0.70), (x + 1.8, y + 0.5, 0.74), 0.01, 2)
                                  for x, y in tables]), paint(scene, "wood"))
    scene.shape("seats", merged([rounded_box((x + dx, y + dy - 0.2, 0.1), (x + dx + 0.45, y + dy + 0.2, 0.45), 0.03, 2)
                                 for x, y in tables for dx in (0.2, 1.1) for dy in (-0.8, 0.8)]), paint(scene, "seats"))
    scene.shape("desk", box((25.75, 8.5, 0), (26.75, 11.5, 1.1)),
                scene.material("desk", {"model": "plastic", "reflectance": 0.5, "roughness": 0.25, "ior": 1.5}))
    add_plants(scene, [(x, y) for x in (3, 9, 15, 21, 27) for y in (9, 11)], 2.5)
    workplane(scene, "floor", (0, 0), (length, width), 0.002, 24, 16)
    scene.camera("view", (1.0, 7.0, 1.7), (20, 11.5, 4.0), 60, 320, 240)


def glass_box(scene):
    """8 m x 6 m x 3 m with a room of 3 m x 3 m behind panes and under a pane in one corner, a partition of four panes,
    a block of solid glass on a table; 12 luminaires, one of them behind the panes; meters within and without; a
    camera."""
    length, width, height = OFFICE
    add_shell(scene, length, width, height)
    add_luminaires(scene, length, width, height - 0.01, 4, 3, 40000.0)
    glazing = scene.material("glazing", {"model": "glazing"})
    low, high = (0.8, 0.8), (3.8, 3.8)
    walls = [quad((low[0] + i, y, 0), (1, 0, 0), (0, 0, 2.4)) for i in range(3) for y in (low[1], high[1])]
    walls += [quad((x, low[1] + i, 0), (0, 1, 0), (0, 0, 2.4)) for i in range(3) for x in (low[0], high[0])]
    walls.append(quad((*low, 2.4), (3, 0, 0), (0, 3, 0)))
    scene.shape("glass room", merged(walls), glazing)
    scene.shape("partition", merged([quad((5.2, 1.5 * i + 0.01, 0), (0, 1.48, 0), (0, 0, 2.4)) for i in range(4)]),
                glazing)
    scene.luminaire("within", Frame.upright((2.3, 2.3, 2.3)), file=LUMINAIRE, flux_lm=2000.0)
    scene.shape("tables", merged([box((1.7, 1.9, 0.68), (2.9, 2.7, 0.72)), box((6.0, 2.4, 0.68), (7.4, 3.2, 0.72))]),
                paint(scene, "wood"))
    scene.shape("block", box((6.5, 2.6, 0.721), (6.8, 2.9, 1.02)),
                scene.material("block", {"model": "glass", "ior": 1.52}))
    workplane(scene, "within", low, high, 0.75, 10, 10)
    workplane(scene, "beyond", (5.3, 0), (length, width), 0.75, 9, 20)
    workplane(scene, "between", (3.9, 0), (5.1, width), 0.75, 4, 20)
    scene.camera("view", (7.6, 5.6, 1.6), (3.0, 2.6, 0.9), 62, 320, 240)
