"""Cases of CIE 171:2006, "Test cases to assess the accuracy of lighting computer programs"."""
import math

import need_numpy  # noqa: F401
from gltf_builder import Frame, GltfBuilder
from harness import Case, Check
from shapes import Mesh, box

FLUX = 10000.0  # lm


def inside(low, high):
    """The faces of a box turned inwards: a room."""
    outward = box(low, high)
    return Mesh(outward.positions, outward.triangles[:, ::-1])


def face_cells(scene, width, depth, height):
    """One cell a face of a room with a corner at the origin, facing inwards: sets floor, ceiling, west, east, south,
    north."""
    w, d, h = width, depth, height
    faces = {"floor": ((w / 2, d / 2, 0), (1, 0, 0), (0, 1, 0), w, d),
             "ceiling": ((w / 2, d / 2, h), (0, 1, 0), (1, 0, 0), d, w),
             "west": ((0, d / 2, h / 2), (0, 1, 0), (0, 0, 1), d, h),
             "east": ((w, d / 2, h / 2), (0, 0, 1), (0, 1, 0), h, d),
             "south": ((w / 2, 0, h / 2), (0, 0, 1), (1, 0, 0), h, w),
             "north": ((w / 2, d, h / 2), (1, 0, 0), (0, 0, 1), w, h)}
    for name, (centre, x, y, along_x, along_y) in faces.items():
        scene.meters(name, Frame(centre, x, y), width_m=along_x, height_m=along_y, columns=1, rows=1, area=True)
    return list(faces)


def build_5_4(path):
    scene = GltfBuilder("UPS cie171.py")
    scene.shape("room", inside((0, 0, 0), (4, 4, 3)), scene.material("black", {"model": "matte", "reflectance": 0}))
    scene.point_light("source", (2, 2, 1.5), FLUX / (4 * math.pi))
    face_cells(scene, 4, 4, 3)
    scene.write(path)


def cases():
    checks = [Check(f, 2210.66 / 16 if f in ("floor", "ceiling") else 1394.67 / 12)
              for f in ("floor", "ceiling", "west", "east", "south", "north")]
    return [Case("cie_5_4", "CIE 171, 5.4: flux conservation", build_5_4, checks)]
