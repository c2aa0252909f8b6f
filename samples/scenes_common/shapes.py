"""Triangle meshes of simple shapes in metres, +Z up: boxes, plates with holes, lathe work, tubes, lofts, spheres.

Called by the scene generators, which place the meshes and hand them to gltf_builder. Front sides are counter-clockwise
and follow the normals; `check_closed` proves that a solid is watertight and turned outwards, which glass must be.
"""
from dataclasses import dataclass
from typing import Optional

import numpy as np


@dataclass
class Mesh:
    positions: np.ndarray                 # (n, 3)
    triangles: np.ndarray                 # (m, 3)
    normals: Optional[np.ndarray] = None  # (n, 3); None: flat triangles
    uvs: Optional[np.ndarray] = None      # (n, 2)
    tangents: Optional[np.ndarray] = None  # (n, 4), as in glTF

    def moved(self, x, y, z):
        return self._mapped(np.eye(3), (x, y, z))

    def scaled(self, x, y, z):
        return self._mapped(np.diag([x, y, z]).astype(float), (0, 0, 0))

    def turned(self, axis, degrees):
        """Right-handed turn about the axis 'x', 'y' or 'z' through the origin."""
        c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
        i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
        matrix = np.eye(3)
        matrix[i, i], matrix[i, j], matrix[j, i], matrix[j, j] = c, -s, s, c
        return self._mapped(matrix, (0, 0, 0))

    def _mapped(self, matrix, shift):
        if np.linalg.det(matrix) <= 0:
            raise ValueError("a mesh is not to be mirrored: its sides would change places")
        normals = tangents = None
        if self.normals is not None:
            normals = unit(self.normals @ np.linalg.inv(matrix))
        if self.tangents is not None:
            tangents = np.concatenate([unit(self.tangents[:, :3] @ matrix.T), self.tangents[:, 3:]], axis=1)
        return Mesh(self.positions @ matrix.T + np.asarray(shift, float), self.triangles, normals, self.uvs, tangents)

    def face_vectors(self):
        """Twice the area times the normal of each triangle."""
        a, b, c = (self.positions[self.triangles[:, k]] for k in range(3))
        return np.cross(b - a, c - a)

    def area(self):
        """Of the mesh as it is written: coordinates rounded to single precision."""
        rounded = Mesh(self.positions.astype(np.float32).astype(float), self.triangles)
        return 0.5 * np.linalg.norm(rounded.face_vectors(), axis=1).sum()

    def volume(self):
        a, b, c = (self.positions[self.triangles[:, k]] for k in range(3))
        return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6


def unit(vectors):
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(length > 0, length, 1)


def merged(meshes):
    """One mesh of several that carry the same attributes."""
    meshes = list(meshes)
    start = np.cumsum([0] + [len(m.positions) for m in meshes])

    def stack(name):
        values = [getattr(m, name) for m in meshes]
        if all(v is None for v in values):
            return None
        if any(v is None for v in values):
            raise ValueError(f"some of the meshes have no {name}")
        return np.concatenate(values)

    triangles = np.concatenate([m.triangles + s for m, s in zip(meshes, start)])
    return Mesh(stack("positions"), triangles, stack("normals"), stack("uvs"), stack("tangents"))


def check_closed(mesh, name):
    """Every edge is shared by two triangles in opposite directions and the normals point outwards, or an error."""
    keys = np.round(mesh.positions * 1e7).astype(np.int64)
    _, welded = np.unique(keys, axis=0, return_inverse=True)
    triangles = welded.reshape(-1)[mesh.triangles]
    tails, heads = triangles[:, [0, 1, 2]].ravel(), triangles[:, [1, 2, 0]].ravel()
    count = len(keys)  # more than any corner's number: an edge is one number, too
    forward, backward = np.sort(tails * count + heads), np.sort(heads * count + tails)
    if (forward[1:] == forward[:-1]).any() or not np.array_equal(forward, backward):
        raise ValueError(f"{name}: the solid is not closed")
    if mesh.volume() <= 0:
        raise ValueError(f"{name}: the solid is turned inside out")
    if mesh.normals is not None:
        corner = mesh.normals[mesh.triangles].sum(axis=1)
        if (np.einsum("ij,ij->i", corner, mesh.face_vectors()) < 0).any():
            raise ValueError(f"{name}: some normals disagree with their triangles")
    return mesh


def smooth_normals(positions, triangles):
    """Vertex normals from the area-weighted triangles; vertices at one place share theirs."""
    mesh = Mesh(positions, triangles)
    _, welded = np.unique(np.round(positions * 1e7).astype(np.int64), axis=0, return_inverse=True)
    welded = welded.reshape(-1)
    total = np.zeros((welded.max() + 1, 3))
    for k in range(3):
        np.add.at(total, welded[triangles[:, k]], mesh.face_vectors())
    return unit(total[welded])


def _grid_triangles(rows, columns, wrap):
    """Triangles of a grid of vertices; with `wrap` the last column joins the first."""
    i = np.arange(rows - 1)[:, None]
    j = np.arange(columns if wrap else columns - 1)[None, :]
    a, b = i * columns + j, i * columns + (j + 1) % columns
    c, d = a + columns, b + columns
    return np.stack([np.stack([a, b, d], -1), np.stack([a, d, c], -1)], -2).reshape(-1, 3)


def _without_slivers(positions, triangles):
    """Drops triangles with two corners at one place: the poles of lathe work."""
    p = positions[triangles]
    same = [np.linalg.norm(p[:, k] - p[:, (k + 1) % 3], axis=1) < 1e-9 for k in range(3)]
    return triangles[~(same[0] | same[1] | same[2])]


def sheet(points, wrap=False, normals=None, uvs=None, smooth=True):
    """Surface through a (rows, columns, 3) grid; its front shows columns running right, rows running up."""
    points = np.asarray(points, float)
    rows, columns, _ = points.shape
    positions = points.reshape(-1, 3)
    triangles = _without_slivers(positions, _grid_triangles(rows, columns, wrap))
    if normals is not None:
        normals = np.asarray(normals, float).reshape(-1, 3)
    elif smooth:
        normals = smooth_normals(positions, triangles)
    return Mesh(positions, triangles, normals, None if uvs is None else np.asarray(uvs, float).reshape(-1, 2))


def quad(corner, along_u, along_v, metres_per_uv=None):
    """Parallelogram whose front normal is along_u x along_v. With `metres_per_uv`: texture coordinates in that
    unit, and tangents."""
    corner, along_u, along_v = (np.asarray(v, float) for v in (corner, along_u, along_v))
    positions = np.array([corner, corner + along_u, corner + along_u + along_v, corner + along_v])
    normal = unit(np.cross(along_u, along_v))
    mesh = Mesh(positions, np.array([[0, 1, 2], [0, 2, 3]]), np.tile(normal, (4, 1)))
    if metres_per_uv is not None:
        u_axis, v_axis = unit(along_u), unit(along_v)
        # glTF's v runs down the image.
        mesh.uvs = np.stack([positions @ u_axis, -(positions @ v_axis)], 1) / np.asarray(metres_per_uv, float)
        mesh.tangents = np.tile(np.append(u_axis, 1.0), (4, 1))
    return mesh


def box(low, high):
    (x0, y0, z0), (x1, y1, z1) = low, high
    dx, dy, dz = (x1 - x0, 0, 0), (0, y1 - y0, 0), (0, 0, z1 - z0)
    back = [tuple(-v for v in d) for d in (dx, dy)]
    return merged([quad((x0, y0, z0), dx, dz), quad((x1, y0, z0), dy, dz), quad((x1, y1, z0), back[0], dz),
                   quad((x0, y1, z0), back[1], dz), quad((x0, y0, z1), dx, dy), quad((x0, y1, z0), dx, back[1])])


def rounded_box(low, high, radius, steps=4):
    """Box with round edges and corners: a sphere pulled apart in eight."""
    low, high = np.asarray(low, float), np.asarray(high, float)
    half = (high - low) / 2 - radius
    quarter = np.linspace(0, np.pi / 2, steps + 1)
    turn = np.concatenate([quarter + k * np.pi / 2 for k in range(4)])
    side = np.repeat([[1, 1], [-1, 1], [-1, -1], [1, -1]], steps + 1, axis=0)
    tilt = np.concatenate([quarter - np.pi / 2, quarter])
    up = np.repeat([-1, 1], steps + 1)
    normals = np.stack([np.cos(tilt)[:, None] * np.cos(turn), np.cos(tilt)[:, None] * np.sin(turn),
                        np.sin(tilt)[:, None] * np.ones_like(turn)], -1)
    signs = np.stack([np.broadcast_to(side[:, 0], normals.shape[:2]), np.broadcast_to(side[:, 1], normals.shape[:2]),
                      np.broadcast_to(up[:, None], normals.shape[:2])], -1)
    body = sheet((low + high) / 2 + signs * half + radius * normals, wrap=True, normals=normals)
    (x0, y0), (x1, y1) = low[:2] + radius, high[:2] - radius
    top = quad((x0, y0, high[2]), (x1 - x0, 0, 0), (0, y1 - y0, 0))
    bottom = quad((x0, y1, low[2]), (x1 - x0, 0, 0), (0, y0 - y1, 0))
    return merged([body, top, bottom])


def lathe(sections, segments=64):
    """Surface of revolution about z. Each section is a smooth run of (r, z) or (r, z, normal_r, normal_z); sections
    meet in creases. Walking along the profile the front lies to the right: bottom, outside, top for a solid."""
    angle = np.arange(segments) * 2 * np.pi / segments
    ring = np.stack([np.cos(angle), np.sin(angle)], -1)
    parts = []
    for section in sections:
        section = np.asarray(section, float)
        r, z = section[:, 0], section[:, 1]
        if section.shape[1] == 4:
            normal = unit(section[:, 2:])
        else:
            edge = unit(np.diff(section, axis=0))
            along = unit(np.concatenate([edge[:1], edge[:-1] + edge[1:], edge[-1:]]))
            normal = np.stack([along[:, 1], -along[:, 0]], -1)
        points = np.concatenate([r[:, None, None] * ring, np.broadcast_to(z[:, None, None], (len(r), segments, 1))], 2)
        normals = np.concatenate([normal[:, :1, None] * ring,
                                  np.broadcast_to(normal[:, 1, None, None], (len(r), segments, 1))], 2)
        parts.append(sheet(points, wrap=True, normals=normals))
    return merged(parts)


def arc(centre, radius, from_degrees, to_degrees, steps):
    """Points of a circle in the (r, z) plane of a lathe; degrees from the r axis towards z."""
    angle = np.radians(np.linspace(from_degrees, to_degrees, steps + 1))
    points = np.stack([centre[0] + radius * np.cos(angle), centre[1] + radius * np.sin(angle)], -1)
    points[np.abs(points[:, 0]) < 1e-12, 0] = 0
    return points


def curve(points, steps=6):
    """Catmull-Rom curve through (r, z) or (x, y, z) points."""
    p = np.asarray(points, float)
    p = np.vstack([2 * p[0] - p[1], p, 2 * p[-1] - p[-2]])
    out = [p[1]]
    for a, b, c, d in zip(p, p[1:], p[2:], p[3:]):
        for t in np.linspace(0, 1, steps + 1)[1:]:
            out.append(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t ** 2
                              + (3 * b - 3 * c + d - a) * t ** 3))
    return np.array(out)


def torus(radius, tube_radius, segments=96, around=48):
    """Ring about z; tube_radius is that of its bar."""
    angle = np.radians(np.arange(around + 1) * 360 / around)
    normal = np.stack([np.cos(angle), np.sin(angle)], -1)
    return lathe([np.concatenate([normal * tube_radius + (radius, 0), normal], 1)], segments)


def sphere(radius, rings=24, segments=48):
    angle = np.radians(np.linspace(-90, 90, rings + 1))
    normal = np.stack([np.cos(angle), np.sin(angle)], -1)
    normal[[0, -1], 0] = 0
    return lathe([np.concatenate([radius * normal, normal], 1)], segments)


def icosphere(radius, level, smooth=True):
    """Icosahedron with each triangle cut in four `level` times, all corners on the sphere."""
    g = (1 + 5 ** 0.5) / 2
    points = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
              (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    points = [np.asarray(p) / np.linalg.norm(p) for p in points]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
             (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11),
             (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(level):
        middle = {}

        def between(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                middle[key] = len(points)
                points.append((points[a] + points[b]) / np.linalg.norm(points[a] + points[b]))
            return middle[key]

        finer = []
        for a, b, c in faces:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    normals = np.array(points)
    return Mesh(radius * normals, np.array(faces), normals if smooth else None)


def tube(path, radius, segments=16, capped=True):
    """Round bar along a polyline; bends are smooth. `radius` may be one number a point."""
    path = np.asarray(path, float)
    radius = np.broadcast_to(radius, len(path))
    edge = unit(np.diff(path, axis=0))
    along = unit(np.concatenate([edge[:1], edge[:-1] + edge[1:], edge[-1:]]))
    side = unit(np.cross(along[0], np.eye(3)[np.argmin(np.abs(along[0]))]))
    angle = np.arange(segments) * 2 * np.pi / segments
    rings, normals = [], []
    for point, direction, r in zip(path, along, radius):
        side = unit(side - direction * (side @ direction))  # the frame is carried along without twist
        other = np.cross(direction, side)
        normal = np.cos(angle)[:, None] * side + np.sin(angle)[:, None] * other
        normals.append(normal)
        rings.append(point + r * normal)
    parts = [sheet(rings, wrap=True, normals=normals)]
    if capped:
        for ring, centre, direction, turn in ((rings[0], path[0], -along[0], -1), (rings[-1], path[-1], along[-1], 1)):
            corners = np.vstack([ring[::turn], centre])
            k = np.arange(segments)
            fan = np.stack([k, (k + 1) % segments, np.full(segments, segments)], -1)
            parts.append(Mesh(corners, fan, np.tile(direction, (len(corners), 1))))
    return merged(parts)


def plate_with_holes(x_range, y_range, z, holes, hole_radius, cell, segments=64):
    """Horizontal plate, front side down, with round holes at the (x, y) of `holes`; each sits in a square cell of side
    `cell`, and the plate between the cells is cut along their edges, so that every edge is shared."""
    xs = sorted({*x_range, *(x + s * cell / 2 for x, _ in holes for s in (-1, 1))})
    ys = sorted({*y_range, *(y + s * cell / 2 for _, y in holes for s in (-1, 1))})
    parts = []
    for x0, x1 in zip(xs, xs[1:]):
        for y0, y1 in zip(ys, ys[1:]):
            inside = [(x, y) for x, y in holes if x0 < x < x1 and y0 < y < y1]
            if not inside:
                parts.append(quad((x0, y1, z), (x1 - x0, 0, 0), (0, y0 - y1, 0)))
                continue
            (x, y), angle = inside[0], np.radians(45 + np.arange(segments) * 360 / segments)
            ring = np.stack([np.cos(angle), np.sin(angle)], -1)
            square = ring / np.abs(ring).max(axis=1, keepdims=True) * cell / 2
            grid = np.stack([np.concatenate([np.array([x, y]) + loop, np.full((segments, 1), z)], 1)
                             for loop in (square, ring * hole_radius)])
            parts.append(sheet(grid[::-1], wrap=True, normals=np.broadcast_to([0.0, 0, -1], grid.shape)))
    return merged(parts)
