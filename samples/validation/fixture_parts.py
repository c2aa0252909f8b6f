"""Pieces of scenes that the fixture cases share: square cells, round screens, rooms."""
import math

import need_numpy  # noqa: F401
import numpy as np
from gltf_builder import Frame
from shapes import Mesh, lathe

BLACK = {"model": "matte", "reflectance": 0}
SEGMENTS = 256


def add_square(scene, name, half_side, at, columns=4):
    """Cells facing up. Only their mean is asked for; more of them get more eye paths an iteration."""
    scene.meters(name, Frame.upright(at), width_m=2 * half_side, height_m=2 * half_side, columns=columns, rows=columns,
                 area=True)


def equal_area(radius, segments=SEGMENTS):
    """Radius of the corners of a regular polygon that is as large as the circle."""
    return radius * math.sqrt(2 * math.pi / segments / math.sin(2 * math.pi / segments))


def ring(inner, outer, z=0.0, segments=SEGMENTS):
    """Flat, facing down, from one circle to another; from 0: a disc."""
    return lathe([np.array([[equal_area(inner, segments), z], [equal_area(outer, segments), z]])], segments)


def inside(mesh):
    """Turned inside out: a room."""
    return Mesh(mesh.positions, mesh.triangles[:, ::-1], None if mesh.normals is None else -mesh.normals)
