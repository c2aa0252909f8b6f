"""Closed forms for the validation cases; no case depends on a table. Metres, lumen, candela, lux."""
import math

import need_numpy  # noqa: F401
import numpy as np


def point_source(intensity, height, offset):
    """E on a plane under a Lambertian point: I0 cos^2(theta) / d^2 = I0 h^2 / d^4."""
    return intensity * height ** 2 / (height ** 2 + offset[0] ** 2 + offset[1] ** 2) ** 2


def polygon_factor(point, normal, corners):
    """Configuration factor of a polygon, E = pi L F, by Lambert's formula (Photometria, 1760): the sum over edges of
    the angle that an edge spans times the cosine between normal and the edge's plane, over 2 pi. Corners below the
    point's horizon are cut off first."""
    relative = [np.subtract(c, point) for c in corners]
    above = [v @ np.asarray(normal, float) for v in relative]
    seen = []
    for i, (a, ha) in enumerate(zip(relative, above)):
        b, hb = relative[(i + 1) % len(relative)], above[(i + 1) % len(relative)]
        if ha >= 0:
            seen.append(a)
        if ha * hb < 0:
            seen.append(a + ha / (ha - hb) * (b - a))
    total = 0.0
    for i, a in enumerate(seen):
        across = np.cross(a, seen[(i + 1) % len(seen)])
        length = np.linalg.norm(across)
        if length > 1e-15:
            total += math.atan2(length, a @ seen[(i + 1) % len(seen)]) * (across @ normal) / length
    return abs(float(total)) / (2 * math.pi)


def horizontal(x0, x1, y0, y1, z):
    """Corners of a rectangle."""
    return [(x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z)]


def vertical(x0, x1, y, z0, z1):
    return [(x0, y, z0), (x1, y, z0), (x1, y, z1), (x0, y, z1)]


def rectangle_solid_angle(width, height, distance):
    """Of a rectangle seen from its axis."""
    w2, h2, d2 = width ** 2, height ** 2, 4 * distance ** 2
    return 4 * math.asin(width * height / math.sqrt((w2 + d2) * (h2 + d2)))


def lowest_seen(point_y, point_z, wall_y, box_y, box_height):
    """How much of a wall a box on the floor hides, box_y its front and back: the lowest height in sight."""
    along = [(wall_y - point_y) / (y - point_y) for y in box_y]
    return max(0.0, *(point_z + (box_height - point_z) * a for a in along))


def cube_mean(flux, side, reflectance):
    """Mean illuminance of all faces by the balance of energy; of each face, where the source is at the centre."""
    return flux / (6 * side ** 2 * (1 - reflectance))


def slab_transmittance(degrees, ior, absorption_per_m, thickness, polarised=True):
    """Clear glass with all reflections between its faces (Fresnel, Snell, Lambert and Bouguer), without interference.
    Polarised: exact, each polarisation for itself. Otherwise every face sees unpolarised light, which is what a
    program computes whose paths carry no polarisation from one face to the next."""
    cos_i = math.cos(math.radians(degrees))
    sin_t = math.sin(math.radians(degrees)) / ior
    cos_t = math.sqrt(1 - sin_t ** 2)
    s = ((cos_i - ior * cos_t) / (cos_i + ior * cos_t)) ** 2
    p = ((ior * cos_i - cos_t) / (ior * cos_i + cos_t)) ** 2
    passage = math.exp(-absorption_per_m * thickness / cos_t)

    def through(r):
        return (1 - r) ** 2 * passage / (1 - (r * passage) ** 2)
    return (through(s) + through(p)) / 2 if polarised else through((s + p) / 2)


def tregenza(degrees):
    """The transmittance of 6 mm clear glass that CIE 171 uses (Tregenza and Sharples, algorithm 2.34)."""
    c = math.cos(math.radians(degrees))
    return float(np.polyval([-1.775827, 4.014235, -1.428919, -3.058376, 3.156075, -0.028378], c))


def disc_through_slab(luminance, radius, distance, thickness, ior, transmittance):
    """E at a point on the axis of a disc behind a slab parallel to it; `transmittance` of degrees. E is the integral of
    2 pi L tau sin cos, as the slab turns no direction and keeps luminance but for tau. It moves rays sideways, which
    the largest angle takes into account; `distance` includes the slab."""
    def reached(angle):
        refracted = math.asin(math.sin(angle) / ior)
        return (distance - thickness) * math.tan(angle) + thickness * math.tan(refracted)
    low, high = 0.0, math.pi / 2 - 1e-9
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if reached(middle) < radius else (low, middle)
    nodes, weights = np.polynomial.legendre.leggauss(200)
    angles = low * (nodes + 1) / 2
    values = [transmittance(math.degrees(a)) * math.sin(2 * a) for a in angles]
    return math.pi * luminance * low / 2 * float(weights @ values)
