"""Bathtub with its water, basin, taps, shower: the shapes that make the room a bathroom.

Called by make_bathroom.py. Each function returns a mesh in its own frame, metres, +Z up.
"""
import numpy as np

from shapes import Mesh, arc, check_closed, curve, lathe, merged, rounded_box, sheet, tube

TUB_LENGTH, TUB_WIDTH, TUB_HEIGHT = 1.70, 0.76, 0.56  # along y, x, z; the origin is the middle of its footprint
TUB_DEPTH = 0.46
RIM_ROUNDING = 0.018
WATER_Z = TUB_HEIGHT - 0.10
WATER_CELL = 0.008


def _ring(half_x, half_y, exponent, z, count=160):
    """Closed superellipse |x/a|^n + |y/b|^n = 1 at a height; round for n = 2, nearly a rectangle for large n."""
    angle = np.arange(count) * 2 * np.pi / count
    c, s = np.cos(angle), np.sin(angle)
    reach = (np.abs(c) ** exponent + np.abs(s) ** exponent) ** (-1 / exponent)
    return np.stack([half_x * reach * c, half_y * reach * s, np.full(count, z)], -1)


def _inside(t):
    """Half lengths, exponent and height of the tub's inner wall: t = 0 under the rim, 1 above the bottom's rounding."""
    return (TUB_WIDTH / 2 - 0.075 - 0.075 * t ** 1.6, TUB_LENGTH / 2 - 0.085 - 0.170 * t ** 1.4, 4.6 - 1.4 * t,
            TUB_HEIGHT - RIM_ROUNDING - (TUB_DEPTH - 0.06 - RIM_ROUNDING) * t)


def bathtub():
    """One loft: the apron from the floor, the rounded rim, the inner wall, its turn into the bottom, the bottom."""
    half_x, half_y = TUB_WIDTH / 2, TUB_LENGTH / 2
    rings = [_ring(half_x, half_y, 40, z) for z in (0.0, 0.02, TUB_HEIGHT - 0.06)]
    for a in np.radians(np.linspace(0, 90, 7)):
        shrink = 0.012 * (1 - np.cos(a))
        rings.append(_ring(half_x - shrink, half_y - shrink, 40, TUB_HEIGHT - 0.012 * (1 - np.sin(a))))
    lip_x, lip_y, lip_n, _ = _inside(0)
    for a in np.radians(np.linspace(90, 0, 9)):
        grow = RIM_ROUNDING * (1 - np.cos(a))
        rings.append(_ring(lip_x + grow, lip_y + grow, lip_n, TUB_HEIGHT - RIM_ROUNDING * (1 - np.sin(a))))
    rings += [_ring(*_inside(t)) for t in np.linspace(0, 1, 25)[1:]]
    foot_x, foot_y, foot_n, foot_z = _inside(1)
    for a in np.radians(np.linspace(0, 90, 9)[1:]):
        shrink = 0.07 * (1 - np.cos(a)) + 0.02 * np.sin(a)
        rings.append(_ring(foot_x - shrink, foot_y - shrink, foot_n, foot_z - 0.055 * np.sin(a)))
    for scale in (0.8, 0.6, 0.4, 0.2, 0.0):
        rings.append(_ring((foot_x - 0.09) * scale, (foot_y - 0.09) * scale, foot_n, foot_z - 0.06 + 0.005 * scale))
    return sheet(rings, wrap=True)


def water():
    """Open surface with ripples, front side up, cut off just behind the tub's wall; analytic normals."""
    t = (TUB_HEIGHT - RIM_ROUNDING - WATER_Z) / (TUB_DEPTH - 0.06 - RIM_ROUNDING)
    half_x, half_y, exponent, _ = _inside(t)
    margin = 0.006
    nx, ny = (int(np.ceil((half + margin) / WATER_CELL)) + 1 for half in (half_x, half_y))
    x, y = np.meshgrid(np.arange(-nx, nx + 1) * WATER_CELL, np.arange(-ny, ny + 1) * WATER_CELL)
    rng = np.random.default_rng(5)
    z, slope_x, slope_y = (np.zeros_like(x) for _ in range(3))
    for length in (0.31, 0.23, 0.17, 0.14, 0.11, 0.095, 0.08, 0.07):
        direction, phase = rng.uniform(0, 2 * np.pi, 2)
        k = 2 * np.pi / length
        kx, ky = k * np.cos(direction), k * np.sin(direction)
        height = 0.034 / k  # each wave tilts the surface by up to 2 degrees
        z += height * np.sin(kx * x + ky * y + phase)
        slope_x += height * kx * np.cos(kx * x + ky * y + phase)
        slope_y += height * ky * np.cos(kx * x + ky * y + phase)
    grid = sheet(np.stack([x, y, WATER_Z + z], -1), normals=np.stack([-slope_x, -slope_y, np.ones_like(x)], -1))
    within = (np.abs(x / (half_x + margin)) ** exponent + np.abs(y / (half_y + margin)) ** exponent <= 1).reshape(-1)
    triangles = grid.triangles[within[grid.triangles].any(axis=1)]
    used, renumbered = np.unique(triangles, return_inverse=True)
    normals = grid.normals[used]
    return Mesh(grid.positions[used], renumbered.reshape(-1, 3),
                normals / np.linalg.norm(normals, axis=1, keepdims=True))


def basin():
    """Bowl that stands on the vanity, an oval of 0.46 m x 0.38 m."""
    outer = curve([(0.095, 0), (0.125, 0.012), (0.165, 0.05), (0.186, 0.10), (0.190, 0.118)])
    lip = arc((0.1855, 0.118), 0.0045, 0, 180, 8)
    inner = curve([(0.181, 0.118), (0.172, 0.085), (0.145, 0.045), (0.10, 0.022), (0.05, 0.016), (0, 0.015)])
    bowl = lathe([[(0, 0), (0.095, 0)], np.vstack([outer, lip[1:-1], inner])], 96)
    return check_closed(bowl, "basin").scaled(1.2, 1.0, 1.0)


def basin_drain():
    return lathe([[(0.024, 0.0152), (0.024, 0.019)], [(0.024, 0.019), (0, 0.020)]], 32)


def basin_tap():
    """Pillar tap, spout towards -y."""
    post = lathe([[(0, 0), (0.026, 0)], [(0.026, 0), (0.026, 0.006)], [(0.026, 0.006), (0.017, 0.008)],
                  [(0.017, 0.008), (0.017, 0.245)], [(0.017, 0.245), (0, 0.247)]], 32)
    spout = tube(curve([(0, 0, 0.195), (0, -0.05, 0.205), (0, -0.11, 0.203), (0, -0.135, 0.19), (0, -0.14, 0.165)]),
                 0.0095, 24)
    lever = tube([(0, 0.004, 0.252), (0, -0.075, 0.272)], [0.006, 0.0045], 16)
    return merged([post, spout, lever])


def tub_tap():
    """Spout and two handles out of a wall at y = 0, towards -y."""
    spout = tube(curve([(0, 0, 0), (0, -0.08, 0.004), (0, -0.15, -0.004), (0, -0.175, -0.045)]), 0.014, 24)
    parts = [spout, tube([(0, 0.001, 0), (0, -0.008, 0)], 0.032, 32)]
    for side in (-0.12, 0.12):
        parts += [tube([(side, 0.001, 0), (side, -0.008, 0)], 0.030, 32),
                  tube([(side, -0.008, 0), (side, -0.045, 0)], 0.011, 20),
                  tube([(side, -0.045, 0), (side, -0.062, 0)], [0.022, 0.020], 32),
                  tube([(side - 0.04, -0.054, 0), (side + 0.04, -0.054, 0)], 0.006, 16)]
    return merged(parts)


def shower():
    """Riser pipe on a wall at y = 0 with an overhead rose; z = 0 is the foot of the riser."""
    pipe = tube(curve([(0, -0.05, 0), (0, -0.05, 0.6), (0, -0.05, 1.15), (0, -0.10, 1.25), (0, -0.28, 1.27),
                       (0, -0.34, 1.25), (0, -0.35, 1.21)], 8), 0.010, 20)
    rose = lathe([[(0, 1.19), (0.098, 1.19)], [(0.098, 1.19), (0.10, 1.196), (0.098, 1.202)],
                  [(0.098, 1.202), (0.03, 1.208), (0, 1.215)]], 64).moved(0, -0.35, 0)
    brackets = [tube([(0, 0.001, z), (0, -0.05, z)], 0.008, 16) for z in (0.06, 1.05)]
    return merged([pipe, rose, *brackets])


def towel_rail(length):
    """Along x, 60 mm before a wall at y = 0."""
    bar = tube([(-length / 2, -0.06, 0), (length / 2, -0.06, 0)], 0.009, 24)
    posts = [tube([(x, 0.001, 0), (x, -0.066, 0)], [0.014, 0.011], 24) for x in (-length / 2 + 0.02, length / 2 - 0.02)]
    return merged([bar, *posts])


def towel_ladder():
    """Heated rail, 0.5 m x 1.3 m, before a wall at y = 0 that it faces away from towards +y; z = 0 is its foot."""
    rungs = [0.06 + 0.075 * k for k in range(17) if k not in (5, 11)]
    parts = [tube([(x, 0.06, 0), (x, 0.06, 1.3)], 0.013, 24) for x in (-0.25, 0.25)]
    parts += [tube([(-0.25, 0.06, z), (0.25, 0.06, z)], 0.009, 16) for z in rungs]
    parts += [tube([(x, -0.001, z), (x, 0.06, z)], 0.008, 16) for x in (-0.25, 0.25) for z in (0.12, 1.18)]
    return merged(parts)


def solid_pane(low, high):
    """A sheet of glass with eased edges."""
    return check_closed(rounded_box(low, high, 0.0015, 2), "pane")
