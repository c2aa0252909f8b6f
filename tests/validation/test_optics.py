"""Are the references of the fixture cases right where others are known? No rendering."""
import math
import os
import sys
import unittest

SAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "samples")
sys.path[:0] = [os.path.join(SAMPLES, "validation"), os.path.join(SAMPLES, "scenes_common")]
import lenses  # noqa: E402
import numpy as np  # noqa: E402
import optics  # noqa: E402
import reflectors  # noqa: E402


class Interfaces(unittest.TestCase):
    def test_hemispherical_transmittance_of_a_plate(self):
        for index, known in ((1.5, 0.850939), (1.52, 0.846424)):
            diffuse = optics.through_hole(1 / math.pi, 1, lambda c, n=index: optics.plates_transmittance(c, n))
            self.assertAlmostEqual(diffuse, known, 5)

    def test_stacks_at_normal_incidence(self):
        for plates, known in ((1, 12 / 13), (2, 6 / 7), (3, 0.8), (4, 0.75)):
            for polarised in (True, False):
                self.assertAlmostEqual(float(optics.plates_transmittance(1.0, 1.5, plates, polarised)), known, 12)

    def test_a_small_cell_sees_what_a_point_sees(self):
        """sin^2 = 0.36; and without glass E = pi L sin^2."""
        def transmittance(cosine):
            return optics.plates_transmittance(cosine, 1.5)
        point = optics.through_hole(1000, 0.36, transmittance)
        self.assertAlmostEqual(optics.through_hole_mean(1000, 0.06, 0.08, 1e-6, transmittance) / point, 1, 8)
        self.assertAlmostEqual(optics.through_hole(1000, 0.36), 360 * math.pi, 9)


class Lenses(unittest.TestCase):
    def test_crossings(self):
        """Back focal distances in mm for heights of 1, 10 and 20 mm, by the formulas of a single ray."""
        for convex_first, known in ((True, (95.9884, 94.8310, 91.1454)), (False, (99.9550, 95.4180, 80.4864))):
            lens = lenses.plano_convex(convex_first)
            for height, distance in zip((0.001, 0.010, 0.020), known):
                self.assertAlmostEqual(-1000 * lenses.crossing(lens, height), distance, 4)

    def test_stigmatic_lens(self):
        for height in (0.001, 0.03, 0.06):
            self.assertAlmostEqual(lenses.crossing(lenses.stigmatic(), height), -0.1, 9)

    def test_no_light_is_lost_at_the_interfaces(self):
        h = np.linspace(0.0001, 0.01, 50)
        rays = optics.Rays(h, h * 0 + 1, h * 0, h * 0 - 1, h * 0 + 1)
        total = sum(out.share for _, out in lenses.plano_convex(True).leaving(rays, depth=8))
        np.testing.assert_allclose(total, 1, atol=1e-5)

    def test_ring_in_a_square(self):
        half_inside = math.hypot(1, math.tan(math.pi / 8))
        share = optics.share_inside_square(np.array([0.0, 1.0, math.sqrt(2), half_inside]), 1.0)
        np.testing.assert_allclose(share, [1, 1, 0, 0.5], atol=1e-12)


class Reflectors(unittest.TestCase):
    def test_shares_of_isotropic_light(self):
        for rim, known in ((0.04, 0.5), (0.06, 0.692308), (0.1, 0.862069)):
            source, mirror = reflectors.Source(1e-5), reflectors.Parabola(0.02, rim, 8, 8)
            flux = reflectors.reflected_flux(source, mirror.rim_angle, mirror.distance, lambda angle: angle)
            self.assertAlmostEqual(flux / (reflectors.RHO * source.flux), known, 4)

    def test_ellipse(self):
        mirror = reflectors.Ellipse(0.1, 0.05, 8, 8)
        self.assertAlmostEqual(mirror.magnification, 3, 12)
        self.assertAlmostEqual(mirror.distance(math.pi / 2), 0.075, 12)  # the latus rectum
        self.assertAlmostEqual(mirror.separation(0), 0, 6)
        self.assertAlmostEqual(mirror.separation(math.pi / 2), math.atan2(0.1, 0.075), 12)

    def test_light_that_returns_to_the_source(self):
        self.assertAlmostEqual(reflectors.returning_share(0.3, 0), 1, 12)
        self.assertEqual(reflectors.returning_share(0.3, 0.6), 0)
        # Narrow cones are circles in a plane: two of radius 1 with their centres 1 apart share
        # (2 pi / 3 - sqrt 3 / 2) / pi.
        overlap = (2 * math.pi / 3 - math.sqrt(3) / 2) / math.pi
        self.assertAlmostEqual(reflectors.returning_share(0.001, 0.001, 400), overlap, 3)

    def test_bright_aperture_on_the_axis(self):
        """pi L (rho (sin^2 a - s^2) + s^2)."""
        source = reflectors.Source(0.008)
        aperture, seen = 0.04 ** 2 / (0.04 ** 2 + 0.26 ** 2), (0.008 / 0.26) ** 2
        expected = math.pi * reflectors.LUMINANCE * (reflectors.RHO * (aperture - seen) + seen)
        self.assertAlmostEqual(reflectors.bright_aperture(source, 0.04, 0.26, 0.26, 1e-9) / expected, 1, 9)


if __name__ == "__main__":
    unittest.main()
