"""Furniture and small things of the bathroom: vanity, door, towels, glassware, plant, duck.

Called by make_bathroom.py. Each function returns a mesh in its own frame, metres, +Z up.
"""
import numpy as np

from shapes import arc, check_closed, curve, lathe, merged, quad, rounded_box, sheet, sphere, tube


def textured_box(low, high, period):
    """Box with texture coordinates; the texture's u runs horizontally."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    dx, dy, dz = np.diag(np.subtract(high, low))
    return merged([quad((x0, y0, z0), dx, dz, period), quad((x1, y0, z0), dy, dz, period),
                   quad((x1, y1, z0), -dx, dz, period), quad((x0, y1, z0), -dy, dz, period),
                   quad((x0, y0, z1), dx, dy, period), quad((x0, y1, z0), dx, -dy, period)])


def vanity(width, depth, height, period):
    """Carcass with two drawer fronts before it; the wall is at y = 0, the fronts face -y."""
    carcass = textured_box((-width / 2, -depth + 0.02, 0), (width / 2, 0, height), period)
    half = height / 2
    fronts = [textured_box((-width / 2 + 0.002, -depth, z0 + 0.004),
                           (width / 2 - 0.002, -depth + 0.018, z0 + half - 0.004), period) for z0 in (0, half)]
    return merged([carcass, *fronts])


def vanity_handles(width, depth, height):
    bars = []
    for z in (height * 0.5 - 0.035, height - 0.035):
        bars.append(tube([(-0.09, -depth - 0.025, z), (0.09, -depth - 0.025, z)], 0.005, 16))
        bars += [tube([(x, -depth - 0.025, z), (x, -depth + 0.001, z)], 0.004, 12) for x in (-0.075, 0.075)]
    return merged(bars)


def door(width, height):
    """Slab with two raised panels in a frame, on a wall at y = 0, facing +y."""
    frame = [rounded_box((x - 0.035, -0.005, 0), (x + 0.035, 0.03, height + 0.07), 0.004, 2)
             for x in (-width / 2 - 0.035, width / 2 + 0.035)]
    frame.append(rounded_box((-width / 2, -0.005, height), (width / 2, 0.03, height + 0.07), 0.004, 2))
    slab = rounded_box((-width / 2, -0.005, 0.004), (width / 2, 0.018, height), 0.003, 2)
    panels = [rounded_box((-width / 2 + 0.12, 0.0, z0), (width / 2 - 0.12, 0.026, z1), 0.007, 3)
              for z0, z1 in ((0.15, 0.90), (1.08, height - 0.14))]
    return merged([*frame, slab, *panels])


def door_handle():
    """Rose and lever before a door leaf at y = 0, facing +y."""
    lever = tube(curve([(0, 0, 0), (0, 0.035, 0), (0.02, 0.05, 0), (0.12, 0.05, 0)], 5), 0.009, 20)
    return merged([tube([(0, -0.001, 0), (0, 0.008, 0)], 0.026, 32), lever])


def hanging_towel(width, front, back, seed):
    """A cloth over a bar along x at the origin, in folds; one sheet with wavy sides."""
    over = arc((0, 0), 0.013, 0, 180, 10)
    path = np.vstack([[(0.013, -front + front * t) for t in np.linspace(0, 1, 30)[:-1]], over,
                      [(-0.013, -back * t) for t in np.linspace(0, 1, 26)[1:]]])
    down = np.clip(-path[:, 1], 0, None)[:, None]
    x = np.linspace(-width / 2, width / 2, 61)[None, :]
    phase = np.random.default_rng(seed).uniform(0, 6, 3)
    wave = (0.011 * np.sin(2 * np.pi * x / 0.16 + phase[0] + down * 1.5)
            + 0.006 * np.sin(2 * np.pi * x / 0.083 + phase[1] - down * 2))
    loosening = np.minimum(down / 0.35, 1) ** 1.3
    side = np.where(path[:, :1] > 0, 1, -1)
    spread = x * (1 - 0.05 * loosening * np.cos(x * 9))
    y = path[:, :1] + loosening * (wave + 0.010 * side)
    z = np.broadcast_to(path[:, 1:], y.shape) - 0.004 * loosening * np.sin(2 * np.pi * x / 0.4 + phase[2])
    # The front hangs towards -y.
    return sheet(np.stack([np.broadcast_to(spread, y.shape), -y, z], -1)[::-1])


def bath_mat(length, width):
    """Ribbed mat along y; the origin is the middle of its underside."""
    base = rounded_box((-width / 2, -length / 2, 0.001), (width / 2, length / 2, 0.012), 0.004, 2)
    ribs = [rounded_box((-width / 2 + 0.03, y - 0.014, 0.006), (width / 2 - 0.03, y + 0.014, 0.018), 0.0055, 3)
            for y in np.arange(-length / 2 + 0.05, length / 2 - 0.04, 0.036)]
    return merged([base, *ribs])


def stool(period):
    """Round seat on three legs, 0.42 m high."""
    seat = rounded_box((-0.16, -0.13, 0.39), (0.16, 0.13, 0.42), 0.012, 4)
    seat.uvs = seat.positions[:, :2] / np.asarray(period)
    legs = []
    for x, y in ((-0.12, -0.09), (0.12, -0.09), (-0.12, 0.09), (0.12, 0.09)):
        leg = tube([(x * 1.15, y * 1.15, 0), (x, y, 0.395)], [0.012, 0.016], 16)
        leg.uvs = leg.positions[:, [2, 0]] / np.asarray(period)
        legs.append(leg)
    return merged([seat, *legs])


def folded_towels():
    """Three, one upon the other; the origin is the middle of the pile's underside."""
    return [rounded_box((-0.125, -0.10, 0.001 + z), (0.125 - inset, 0.10, z + 0.044), 0.016, 5)
            for z, inset in ((0.0, 0.0), (0.046, 0.006), (0.092, 0.002))]


def drinking_glass():
    """Closed solid, 110 mm high, with an 8 mm bottom."""
    rim = arc((0.0358, 0.109), 0.0012, 0, 180, 8)
    wall = np.vstack([[(0.0335, 0.003), (0.034, 0.02)], rim, [(0.0315, 0.02), (0.031, 0.014)]])
    return check_closed(lathe([[(0, 0), (0.031, 0)], [(0.031, 0), (0.0325, 0.0008), (0.0335, 0.003)], wall,
                               [(0.031, 0.014), (0.028, 0.010), (0.02, 0.0085), (0, 0.008)]], 72), "drinking glass")


def bottle():
    """Closed solid with a hollow, 190 mm high."""
    outer = curve([(0.030, 0), (0.0355, 0.006), (0.0365, 0.02), (0.0365, 0.11), (0.031, 0.138), (0.016, 0.156),
                   (0.0125, 0.170), (0.0125, 0.188)])
    lip = arc((0.0110, 0.188), 0.0015, 0, 180, 6)
    inner = curve([(0.0095, 0.188), (0.0095, 0.170), (0.0130, 0.154), (0.0275, 0.136), (0.0325, 0.11), (0.0325, 0.02),
                   (0.028, 0.010), (0.016, 0.007), (0, 0.006)])
    return check_closed(lathe([[(0, 0), (0.030, 0)], np.vstack([outer, lip[1:-1], inner])], 72), "bottle")


def soap_dish():
    return lathe([[(0, 0), (0.05, 0)], curve([(0.05, 0), (0.062, 0.010), (0.066, 0.022)]),
                  arc((0.0645, 0.022), 0.0015, 0, 180, 6),
                  curve([(0.063, 0.022), (0.056, 0.012), (0.04, 0.008), (0, 0.007)])], 64)


def soap():
    return rounded_box((-0.036, -0.024, 0.010), (0.036, 0.024, 0.034), 0.0115, 6)


def plant_pot():
    return lathe([[(0, 0), (0.095, 0)], [(0.095, 0), (0.115, 0.20)], arc((0.111, 0.20), 0.004, 0, 180, 6),
                  [(0.107, 0.20), (0.105, 0.17)]], 64)


def plant_soil():
    return lathe([[(0.1055, 0.172), (0, 0.176)]], 32)


def plant_leaves(count=26):
    """Long arching blades out of the pot."""
    rng = np.random.default_rng(21)
    blades = []
    for k in range(count):
        azimuth = k * 2.39996 + rng.uniform(-0.25, 0.25)
        length, lean = rng.uniform(0.38, 0.72), rng.uniform(0.25, 0.95)
        t = np.linspace(0, 1, 15)[:, None]
        out = 0.02 + length * (lean * t ** 1.7) * 0.75
        up = 0.165 + length * (t - lean * 0.55 * t ** 2.6)
        half = 0.019 * np.sin(np.pi * np.clip(t * 0.94 + 0.06, 0, 1)) ** 0.7 + 0.0005
        across = np.array([-1.0, 0.0, 1.0])[None, :]
        crease = 0.25 * half * np.abs(across)
        c, s = np.cos(azimuth), np.sin(azimuth)
        grid = np.stack([out * c - half * across * s, out * s + half * across * c, up + crease], -1)
        blades.append(sheet(grid))
    return merged(blades)


def duck():
    """(body and head, beak, eyes): a rubber duck that looks towards +x; z = 0 is its water line."""
    body = sphere(1, 24, 40).scaled(0.058, 0.043, 0.036).moved(0, 0, 0.014)
    tail = sphere(1, 12, 24).scaled(0.026, 0.016, 0.011).turned("y", 38).moved(-0.056, 0, 0.034)
    head = sphere(0.029, 20, 36).moved(0.030, 0, 0.063)
    beak = sphere(1, 12, 24).scaled(0.016, 0.014, 0.0045).moved(0.062, 0, 0.058)
    eyes = [sphere(0.0042, 10, 16).moved(0.052, y, 0.071) for y in (-0.0155, 0.0155)]
    return merged([body, tail, head]), beak, merged(eyes)
