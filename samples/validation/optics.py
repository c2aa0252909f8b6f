"""References for light at interfaces and through lenses, beside references.py; used by the modules of fixtures.

Interfaces are smooth and without absorption. Light that crosses several is followed in two ways: with each polarisation
on its own, as nature has it, or unpolarised before every interface, as a renderer without polarisation has it.
"""
import math
from dataclasses import dataclass

import need_numpy  # noqa: F401
import numpy as np


def integral(function, low, high, points=64):
    """Gauss-Legendre."""
    t, w = np.polynomial.legendre.leggauss(points)
    return (high - low) / 2 * float(np.sum(w * function((low + high) / 2 + (high - low) / 2 * t)))


def fresnel(cos_i, index):
    """Reflectances (s, p) for the relative index n_t / n_i; 1 under total reflection."""
    square = 1 - (1 - cos_i ** 2) / index ** 2
    cos_t = np.sqrt(np.maximum(square, 0))
    s = ((cos_i - index * cos_t) / (cos_i + index * cos_t)) ** 2
    p = ((index * cos_i - cos_t) / (index * cos_i + cos_t)) ** 2
    return np.where(square > 0, s, 1.0), np.where(square > 0, p, 1.0)


def plates_transmittance(cos_i, index, plates=1, polarised=True):
    """Of parallel plates with all reflections between their 2k faces: T = (1 - R) / (1 + (2k - 1) R) (Stokes 1862)."""
    s, p = fresnel(cos_i, index)
    reflectances = (s, p) if polarised else ((s + p) / 2,)
    return sum((1 - r) / (1 + (2 * plates - 1) * r) for r in reflectances) / len(reflectances)


def through_hole(luminance, sine_squared, transmittance=lambda cos_i: np.ones_like(cos_i)):
    """E on the axis of a round hole of this sin^2 of the half-angle, before a uniform luminance: with u = sin^2 a,
    E = pi L integral of T du."""
    return math.pi * luminance * integral(lambda u: transmittance(np.sqrt(1 - u)), 0, sine_squared, 200)


def through_hole_mean(luminance, radius, height, side, transmittance):
    """The same as mean over a square below the hole: E = L integral of T cos^2 / d^2 over the hole."""
    t, w = np.polynomial.legendre.leggauss(24)
    r, weight = radius * (t + 1) / 2, w * radius / 2
    angle = (np.arange(64) + 0.5) * 2 * math.pi / 64
    hole_x, hole_y = np.outer(r, np.cos(angle)), np.outer(r, np.sin(angle))
    area = np.outer(weight * r, np.full(64, 2 * math.pi / 64))
    t, w = np.polynomial.legendre.leggauss(6)
    total = 0.0
    for x, wx in zip(t * side / 2, w / 2):
        for y, wy in zip(t * side / 2, w / 2):
            d2 = (hole_x - x) ** 2 + (hole_y - y) ** 2 + height ** 2
            cosine = height / np.sqrt(d2)
            total += wx * wy * float(np.sum(area * transmittance(cosine) * cosine ** 2 / d2))
    return luminance * total


@dataclass
class Conic:
    """z = height + c r^2 / (1 + sqrt(1 - (1 + K) c^2 r^2)); c: curvature at the vertex, K: conic constant."""
    height: float
    curvature: float = 0.0
    conic: float = 0.0

    def z(self, r):
        c = self.curvature
        return self.height + c * r * r / (1 + np.sqrt(1 - (1 + self.conic) * (c * r) ** 2))

    def slope(self, r):
        c = self.curvature
        return c * r / np.sqrt(1 - (1 + self.conic) * (c * r) ** 2)


@dataclass
class Rays:
    """In a plane through the axis: position (x, z), unit direction (u, w), share of the light."""
    x: np.ndarray
    z: np.ndarray
    u: np.ndarray
    w: np.ndarray
    share: np.ndarray

    def at(self, height):
        with np.errstate(divide="ignore", invalid="ignore"):  # level rays have no share
            return self.x + self.u / self.w * (height - self.z)


@dataclass
class Lens:
    """Between an upper and a lower surface of revolution out to the radius `rim`. Rays in a plane through the axis stay
    in it, so tracing them is exact: each interface splits a ray by Fresnel and Snell."""
    top: Conic
    bottom: Conic
    rim: float
    index: float

    def edge_height(self):
        return float(self.top.z(np.array(self.rim)) - self.bottom.z(np.array(self.rim)))

    def leaving(self, rays, inside=False, depth=6):
        """All that leaves a bundle that comes from outside: a list of (goes_up, Rays)."""
        if depth == 0:
            return []
        # Outside, a ray that goes up meets the bottom first; inside, the top.
        up = bool(rays.w[0] > 0)
        surface = self.top if up == inside else self.bottom
        hit, normal_u, normal_w = _meet(surface, rays)
        share = np.where(np.abs(hit.x) <= self.rim, rays.share, 0)  # what meets the edge is given up
        turned = np.sign(hit.u * normal_u + hit.w * normal_w)
        normal_u, normal_w = normal_u * turned, normal_w * turned  # along the ray
        cos_i = np.minimum(hit.u * normal_u + hit.w * normal_w, 1)
        index = 1 / self.index if inside else self.index
        reflectance = sum(fresnel(cos_i, index)) / 2
        bent = np.sqrt(np.maximum(1 - (1 - cos_i ** 2) / index ** 2, 0)) - cos_i / index
        through = Rays(hit.x, hit.z, hit.u / index + bent * normal_u, hit.w / index + bent * normal_w,
                       share * (1 - reflectance))
        back = Rays(hit.x, hit.z, hit.u - 2 * cos_i * normal_u, hit.w - 2 * cos_i * normal_w, share * reflectance)
        out = [(up, through)] if inside else [(not up, back)]
        inner = back if inside else through
        return out + (self.leaving(inner, True, depth - 1) if inner.share.max() > 1e-7 else [])


def _meet(surface, rays):
    """Where rays meet a surface, by Newton's method, and its normal there."""
    t = (surface.height - rays.z) / rays.w
    for _ in range(20):
        x = np.clip(rays.x + t * rays.u, -_reach(surface), _reach(surface))
        t = t - (rays.z + t * rays.w - surface.z(x)) / (rays.w - surface.slope(x) * rays.u)
    x = rays.x + t * rays.u
    slope = surface.slope(np.clip(x, -_reach(surface), _reach(surface)))
    length = np.hypot(slope, 1)
    return Rays(x, rays.z + t * rays.w, rays.u, rays.w, rays.share), -slope / length, 1 / length


def _reach(surface):
    """The largest radius at which the conic is defined, less a little."""
    square = (1 + surface.conic) * surface.curvature ** 2
    return 0.999 / math.sqrt(square) if square > 0 else 1e9


def share_inside_square(radius, half_side):
    """Of a thin ring around the centre of a square."""
    angle = np.arccos(np.clip(half_side / np.maximum(radius, 1e-30), -1, 1))
    cut = np.where(radius >= half_side * math.sqrt(2), 0.0, 1 - 4 / math.pi * angle)
    return np.where(radius <= half_side, 1.0, cut)


def focused_illuminance(lens, lux, inner, outer, height, half_side, rings=40000):
    """Mean over a square cell on the axis at `height`, behind the lens: of a parallel beam `lux` from above that a
    screen lets in between two radii."""
    h = inner + (np.arange(rings) + 0.5) * (outer - inner) / rings
    zero = np.zeros_like(h)
    flux = lux * 2 * math.pi * h * (outer - inner) / rings
    above = zero + 1.0
    total = 0.0
    for up, rays in lens.leaving(Rays(h, above, zero, zero - 1, flux)):
        if not up:
            total += float(np.sum(rays.share * share_inside_square(np.abs(rays.at(height)), half_side)))
    return total / (4 * half_side ** 2)
