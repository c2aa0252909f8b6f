#!/usr/bin/env python3
"""A bathroom of 3.2 m x 2.6 m x 2.5 m lit by four modelled downlights and two measured wall lamps: bathroom.glb.

Most of the light has passed a reflector and a lens before it enters the room, so nearly all of it is caustic; the room
shows it again in a mirror, through glass and through water. Writes wall_light.ies beside the scene. Run by hand; the
result is kept in the repository. Here is where everything stands; its shapes are in the modules beside this one.
"""
import argparse
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
import furnishings as things  # noqa: E402
import lamps  # noqa: E402
import plant  # noqa: E402
import sanitary  # noqa: E402
import tiles  # noqa: E402
from gltf_builder import Frame, GltfBuilder  # noqa: E402
from shapes import box, merged, plate_with_holes, quad, rounded_box, sphere, tube  # noqa: E402

LENGTH, WIDTH, HEIGHT = 3.2, 2.6, 2.5          # x, y, z
BAND = (1.2, 1.4)                              # coloured tiles between these heights
TUB_AT = (0.385, 1.745, 0.0)
VANITY_X, VANITY_WIDTH, VANITY_DEPTH, VANITY_Z, VANITY_HEIGHT = 1.80, 1.10, 0.48, 0.40, 0.42
COUNTER_Z = VANITY_Z + VANITY_HEIGHT + 0.03
MIRROR = ((1.35, 1.02), (2.25, 1.98))          # (x, z) of two corners
WALL_LAMP_XS, WALL_LAMP_Z = (1.22, 2.38), 1.62
DOWNLIGHTS = [(0.45, 1.70), (1.80, 1.95), (1.10, 0.65), (2.40, 0.80)]
DOWNLIGHT_FLUX = 850.0
CHROMIUM = {"model": "metal", "ior": [3.14, 3.18, 2.36], "k": [3.31, 3.33, 3.12], "roughness": 0.06}


def add_materials(scene):
    wall = [scene.texture(f"wall tiles {kind}", image)
            for kind, image in zip(("colour", "roughness", "normal"), tiles.wall_tiles())]
    floor = [scene.texture(f"floor tiles {kind}", image)
             for kind, image in zip(("colour", "roughness", "normal"), tiles.floor_tiles())]
    oak = scene.texture("oak", tiles.oak())
    m = {"white tiles": scene.textured("white tiles", wall[0], wall[2], 1.0, roughness=wall[1]),
         "teal tiles": scene.textured("teal tiles", wall[0], wall[2], 1.0, (0.06, 0.36, 0.40), wall[1]),
         "floor tiles": scene.textured("floor tiles", floor[0], floor[2], 1.0, roughness=floor[1]),
         "oak": scene.textured("oak", oak, None, 0.4)}
    scattering = {
        "plaster": {"model": "matte", "reflectance": 0.84},
        "ceramic": {"model": "plastic", "reflectance": [0.82, 0.82, 0.80], "roughness": 0.05, "ior": 1.52},
        "counter": {"model": "plastic", "reflectance": [0.72, 0.71, 0.68], "roughness": 0.15, "ior": 1.5},
        "chrome": CHROMIUM,
        "aluminium": {"model": "mirror", "reflectance": 0.88},
        "trim": {"model": "matte", "reflectance": 0.75},
        "mirror": {"model": "mirror", "reflectance": [0.90, 0.92, 0.91]},
        "lens": {"model": "glass", "ior": 1.5},
        "glass": {"model": "glass", "ior": 1.52},
        "pane": {"model": "glass", "ior": 1.52, "absorption_per_m": [4.0, 1.2, 2.2]},
        "green glass": {"model": "glass", "ior": 1.52, "absorption_per_m": [160.0, 25.0, 90.0]},
        "water": {"model": "glass", "ior": 1.33, "absorption_per_m": [0.60, 0.12, 0.08]},
        "glazing": {"model": "glazing", "ior": 1.52},
        "white towel": {"model": "matte", "reflectance": [0.80, 0.79, 0.75]},
        "coral towel": {"model": "matte", "reflectance": [0.72, 0.26, 0.17]},
        "teal towel": {"model": "matte", "reflectance": [0.06, 0.30, 0.34]},
        "mat": {"model": "matte", "reflectance": [0.62, 0.58, 0.50]},
        "door paint": {"model": "plastic", "reflectance": [0.76, 0.76, 0.74], "roughness": 0.35, "ior": 1.5},
        "soap": {"model": "plastic", "reflectance": [0.75, 0.55, 0.50], "roughness": 0.5, "ior": 1.4},
        "clay": {"model": "matte", "reflectance": [0.46, 0.20, 0.11]},
        "soil": {"model": "matte", "reflectance": [0.06, 0.04, 0.03]},
        "leaf": {"model": "plastic", "reflectance": [0.07, 0.24, 0.05], "roughness": 0.4, "ior": 1.4},
        "duck": {"model": "plastic", "reflectance": [0.85, 0.60, 0.03], "roughness": 0.2, "ior": 1.5},
        "beak": {"model": "plastic", "reflectance": [0.85, 0.22, 0.02], "roughness": 0.2, "ior": 1.5},
        "black": {"model": "plastic", "reflectance": 0.02, "roughness": 0.2, "ior": 1.5},
    }
    m.update({name: scene.material(name, words) for name, words in scattering.items()})
    return m


def add_room(scene, m):
    period = tiles.WALL_PERIOD_M

    def strip(z0, z1):
        up = (0, 0, z1 - z0)
        return [quad((0, 0, z0), (0, WIDTH, 0), up, period), quad((LENGTH, WIDTH, z0), (0, -WIDTH, 0), up, period),
                quad((LENGTH, 0, z0), (-LENGTH, 0, 0), up, period), quad((0, WIDTH, z0), (LENGTH, 0, 0), up, period)]

    scene.shape("white tiles", merged(strip(0, BAND[0]) + strip(BAND[1], HEIGHT)), m["white tiles"])
    scene.shape("teal tiles", merged(strip(*BAND)), m["teal tiles"])
    over = 0.01  # floor and ceiling reach past the walls: no light escapes along their edges
    floor = quad((-over, -over, 0), (LENGTH + 2 * over, 0, 0), (0, WIDTH + 2 * over, 0), tiles.FLOOR_PERIOD_M)
    scene.shape("floor", floor, m["floor tiles"])
    scene.shape("ceiling", plate_with_holes((-over, LENGTH + over), (-over, WIDTH + over), HEIGHT, DOWNLIGHTS,
                                            lamps.CEILING_HOLE_RADIUS, 0.2), m["plaster"])
    scene.shape("door", things.door(0.80, 2.05).moved(1.35, 0, 0), m["door paint"])
    scene.shape("door handle", things.door_handle().moved(1.02, 0.018, 1.02), m["chrome"])


def add_lamps(scene, m):
    bulb = lamps.downlight_emitter()
    emitter = scene.material("emitter", {"model": "matte", "reflectance": 0.0},
                             luminance=DOWNLIGHT_FLUX / (math.pi * bulb.area()))
    fixture = scene.mesh("downlight", (lamps.downlight_reflector(), m["aluminium"]),
                         (lamps.downlight_trim(), m["trim"]), (lamps.downlight_lens(), m["lens"]), (bulb, emitter))
    for k, (x, y) in enumerate(DOWNLIGHTS, 1):
        scene.place(f"downlight {k}", fixture, (x, y, HEIGHT))
    body = scene.mesh("wall lamp", (lamps.wall_lamp_body(), m["chrome"]))
    for k, x in enumerate(WALL_LAMP_XS, 1):
        at = (x, WIDTH - lamps.WALL_LAMP_REACH, WALL_LAMP_Z)
        scene.place(f"wall lamp {k} body", body, at)
        scene.luminaire(f"wall lamp {k}", Frame.upright(at), file="wall_light.ies", opening=True)


def add_bath(scene, m):
    x, y, _ = TUB_AT
    scene.place("bathtub", scene.mesh("bathtub", (sanitary.bathtub(), m["ceramic"])), TUB_AT)
    scene.place("water", scene.mesh("water", (sanitary.water(), m["water"])), TUB_AT)
    scene.shape("tub tap", sanitary.tub_tap().moved(x, WIDTH, 0.74), m["chrome"])
    scene.shape("shower", sanitary.shower().moved(x, WIDTH, 0.92), m["chrome"])
    # The screen stands 2 mm above the rim: a fixed pane of solid glass, and a hinged leaf of thin glazing.
    pane_x, foot = 0.735, sanitary.TUB_HEIGHT + 0.002
    scene.shape("screen", sanitary.solid_pane((pane_x - 0.004, 1.84, foot), (pane_x + 0.004, WIDTH - 0.012, 2.0)),
                m["pane"])
    scene.shape("screen leaf", quad((pane_x, 1.47, foot), (0, 0.35, 0), (0, 0, 2.0 - foot)), m["glazing"])
    rails = [box((pane_x - 0.010, WIDTH - 0.014, foot), (pane_x + 0.010, WIDTH + 0.001, 2.004)),
             tube([(pane_x, 1.83, foot), (pane_x, 1.83, 2.004)], 0.009, 20),
             tube([(pane_x, 1.463, foot), (pane_x, 1.463, 2.004)], 0.007, 20)]
    scene.shape("screen rails", merged(rails), m["chrome"])
    for name, part in zip(("duck", "beak", "black"), things.duck()):
        scene.shape(f"duck {name}", part.turned("z", -60).moved(0.47, 1.30, sanitary.WATER_Z), m[name])


def add_vanity(scene, m):
    x, period = VANITY_X, tiles.OAK_PERIOD_M
    size = (VANITY_WIDTH, VANITY_DEPTH, VANITY_HEIGHT)
    scene.shape("vanity", things.vanity(*size, period).moved(x, WIDTH, VANITY_Z), m["oak"])
    scene.shape("vanity handles", things.vanity_handles(*size).moved(x, WIDTH, VANITY_Z), m["chrome"])
    half, front = VANITY_WIDTH / 2 + 0.01, WIDTH - VANITY_DEPTH - 0.01
    counter = rounded_box((x - half, front, COUNTER_Z - 0.03), (x + half, WIDTH, COUNTER_Z), 0.004)
    scene.shape("counter", counter, m["counter"])
    scene.shape("basin", sanitary.basin().moved(x, WIDTH - 0.25, COUNTER_Z), m["ceramic"])
    scene.shape("basin drain", sanitary.basin_drain().moved(x, WIDTH - 0.25, COUNTER_Z), m["chrome"])
    scene.shape("basin tap", sanitary.basin_tap().moved(x, WIDTH - 0.045, COUNTER_Z), m["chrome"])
    (x0, z0), (x1, z1) = MIRROR
    scene.shape("mirror back", box((x0 - 0.006, WIDTH - 0.020, z0 - 0.006), (x1 + 0.006, WIDTH, z1 + 0.006)), m["trim"])
    scene.shape("mirror", quad((x0, WIDTH - 0.021, z0), (x1 - x0, 0, 0), (0, 0, z1 - z0)), m["mirror"])
    on_counter = COUNTER_Z + 0.0005  # glass does not touch what it stands on
    scene.shape("drinking glass", things.drinking_glass().moved(1.46, 2.20, on_counter), m["glass"])
    scene.shape("bottle", things.bottle().moved(1.32, 2.23, on_counter), m["green glass"])
    scene.shape("glass sphere", sphere(0.042, 48, 96).moved(2.20, 2.22, on_counter + 0.042), m["glass"])
    scene.shape("soap dish", things.soap_dish().moved(2.13, 2.42, COUNTER_Z), m["ceramic"])
    scene.shape("soap", things.soap().turned("z", 25).moved(2.13, 2.42, COUNTER_Z), m["soap"])


def add_furnishings(scene, m):
    rail_x, rail_z = 2.78, 1.30
    scene.shape("towel rail", sanitary.towel_rail(0.62).moved(rail_x, WIDTH, rail_z), m["chrome"])
    scene.shape("hanging towel", things.hanging_towel(0.42, 0.62, 0.52, 1).moved(rail_x - 0.02, WIDTH - 0.06, rail_z),
                m["coral towel"])
    scene.shape("towel ladder", sanitary.towel_ladder().moved(0.50, 0, 0.55), m["chrome"])
    scene.shape("ladder towel", things.hanging_towel(0.40, 0.42, 0.36, 2).turned("z", 180).moved(0.50, 0.06, 1.585),
                m["teal towel"])
    scene.shape("bath mat", things.bath_mat(0.80, 0.50).moved(1.08, 1.50, 0), m["mat"])
    stool_at = (0.92, 0.55, 0)
    scene.shape("stool", things.stool(tiles.OAK_PERIOD_M).moved(*stool_at), m["oak"])
    for k, (towel, name) in enumerate(zip(things.folded_towels(), ("teal towel", "white towel", "coral towel")), 1):
        scene.shape(f"folded towel {k}", towel.turned("z", 6 * k - 10).moved(0.92, 0.55, 0.42), m[name])
    for name, part in (("clay", plant.pot()), ("soil", plant.soil()), ("leaf", plant.leaves())):
        scene.shape(f"plant {name}", part.moved(2.80, 2.30, 0), m[name])


def add_check_sensors(scene):
    """Few enough for path tracing, which hardly ever finds the downlights' emitters."""
    for name, z in (("floor", 0.002), ("workplane", 0.75)):
        scene.meters(name, Frame.upright((2.30, 1.05, z)), width_m=1.5, height_m=1.8, columns=4, rows=4)


def add_floor_meters(scene):
    scene.meters("floor", Frame.upright((2.30, 1.05, 0.002)), width_m=1.7, height_m=2.0, columns=12, rows=10)


def add_sensors(scene):
    add_floor_meters(scene)
    scene.meters("workplane", Frame.upright((1.975, 1.05, 0.75)), width_m=2.25, height_m=2.0, columns=16, rows=12)
    scene.meters("face", Frame.facing((VANITY_X, 1.85, 1.55), (0, 1, 0)), width_m=0.36, height_m=0.48,
                 columns=6, rows=8)
    add_view(scene, 640, 480)


def add_view(scene, width, height):
    scene.camera("view", (3.02, 0.14, 1.56), (1.16, 1.86, 0.86), 62, width, height)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", default=os.path.join(HERE, "bathroom.glb"))
    sensors = parser.add_mutually_exclusive_group()
    sensors.add_argument("--check", action="store_true", help="32 meters and no camera: for a check by path tracing")
    sensors.add_argument("--floor", action="store_true", help="the meters of the floor alone and no camera")
    sensors.add_argument("--picture", action="store_true", help="a camera of 320 x 240 and no meters: for comparisons")
    arguments = parser.parse_args()
    scene = GltfBuilder("UPS make_bathroom.py")
    materials = add_materials(scene)
    for add in (add_room, add_lamps, add_bath, add_vanity, add_furnishings):
        add(scene, materials)
    if arguments.picture:
        add_view(scene, 320, 240)
    elif arguments.floor:
        add_floor_meters(scene)
    else:
        (add_check_sensors if arguments.check else add_sensors)(scene)
    os.makedirs(os.path.dirname(os.path.abspath(arguments.out)), exist_ok=True)
    scene.write(arguments.out)
    lamps.write_wall_lamp_ies(os.path.join(os.path.dirname(os.path.abspath(arguments.out)), "wall_light.ies"))


if __name__ == "__main__":
    main()
