"""Smoothly blended solids: distance fields of simple bodies, their union without creases, and its surface as a mesh.

Called by the scene generators for shapes that no lathe turns. A field maps (n, 3) points to distances, negative inside.
"""
import numpy as np

from shapes import Mesh, unit


def capsule(start, end, start_radius, end_radius=None):
    """A bar with round ends whose radius changes along it."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    end_radius = start_radius if end_radius is None else end_radius

    def field(points):
        along = end - start
        t = np.clip((points - start) @ along / (along @ along), 0, 1)
        return np.linalg.norm(points - start - t[:, None] * along, axis=1) - (start_radius + t * (end_radius - start_radius))
    return field


def ellipsoid(centre, radii):
    """Nearly the distance; exact at the surface."""
    centre, radii = np.asarray(centre, float), np.asarray(radii, float)

    def field(points):
        q = (points - centre) / radii
        length = np.maximum(np.linalg.norm(q, axis=1), 1e-9)
        return length * (length - 1) / np.maximum(np.linalg.norm(q / radii, axis=1), 1e-9)
    return field


def blended(fields, width):
    """Union whose creases are filled over `width` metres: the polynomial smooth minimum."""
    def field(points):
        result = fields[0](points)
        for other in fields[1:]:
            d = other(points)
            h = np.clip(0.5 + 0.5 * (d - result) / width, 0, 1)
            result = d + h * (result - d) - width * h * (1 - h)
        return result
    return field


def _corner(grid, offset):
    """The value of each cell's corner: `offset` is 0 or 1 an axis."""
    return grid[tuple(slice(o, o + n - 1) for o, n in zip(offset, grid.shape))]


def _net_vertices(value):
    """(cells the surface crosses, the mean of the crossings of their edges), in cells."""
    total, count = np.zeros((*(n - 1 for n in value.shape), 3)), np.zeros([n - 1 for n in value.shape])
    for axis in range(3):
        for b in (0, 1):
            for c in (0, 1):
                start = np.roll((0, b, c), axis)
                a, z = _corner(value, start), _corner(value, start + np.eye(3, dtype=int)[axis])
                crossed = (a < 0) != (z < 0)
                t = np.where(crossed, a / np.where(crossed, a - z, 1), 0)
                count += crossed
                total += crossed[..., None] * (start + t[..., None] * np.eye(3)[axis])
    cells = np.argwhere(count > 0)
    return cells, cells + total[count > 0] / count[count > 0][:, None]


def _net_triangles(value, number):
    """Two a crossed edge, between the vertices of the four cells around it; number: of each cell's vertex."""
    triangles = []
    for axis in range(3):
        v, n = np.moveaxis(value, (axis, (axis + 1) % 3, (axis + 2) % 3), (0, 1, 2)), number
        n = np.moveaxis(n, (axis, (axis + 1) % 3, (axis + 2) % 3), (0, 1, 2))
        near, far = v[:-1, 1:-1, 1:-1] < 0, v[1:, 1:-1, 1:-1] < 0
        ring = np.stack([n[:, :-1, :-1], n[:, 1:, :-1], n[:, 1:, 1:], n[:, :-1, 1:]], -1)
        for quads in (ring[near & ~far], ring[far & ~near][:, ::-1]):
            triangles += [quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]
    return np.concatenate(triangles)


def surface(field, low, high, cell):
    """Where the field is 0, by surface nets: one vertex in each cell that the surface crosses, at the mean of its
    crossings (Gibson 1998), then drawn onto the surface along the gradient. The normals are the gradient's."""
    low = np.asarray(low, float)
    size = np.ceil((np.asarray(high, float) - low) / cell).astype(int) + 1
    nodes = np.stack(np.meshgrid(*(np.arange(n) for n in size), indexing="ij"), -1)
    value = field((low + cell * nodes).reshape(-1, 3)).reshape(size)
    cells, points = _net_vertices(value)
    if (cells == 0).any() or (cells == size - 2).any():
        raise ValueError("the surface leaves the box")
    number = np.full(size - 1, -1)
    number[tuple(cells.T)] = np.arange(len(cells))
    points = low + cell * points

    def gradient(at):
        step = 0.1 * cell * np.eye(3)
        return np.stack([field(at + d) - field(at - d) for d in step], 1) / (0.2 * cell)

    for _ in range(2):
        slope = gradient(points)
        move = field(points)[:, None] * slope / np.maximum((slope ** 2).sum(1), 0.25)[:, None]
        points = points - np.clip(move, -0.4 * cell, 0.4 * cell)
    return Mesh(points, _net_triangles(value, number), unit(gradient(points)))
