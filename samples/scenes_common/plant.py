"""A plant in a pot, 0.23 m across and up to 0.9 m high: pot, soil, leaves. Called by the scene generators."""
import numpy as np

from shapes import arc, lathe, merged, sheet


def pot():
    return lathe([[(0, 0), (0.095, 0)], [(0.095, 0), (0.115, 0.20)], arc((0.111, 0.20), 0.004, 0, 180, 6),
                  [(0.107, 0.20), (0.105, 0.17)]], 64)


def soil():
    return lathe([[(0.1055, 0.172), (0, 0.176)]], 32)


def leaves(count=26):
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
