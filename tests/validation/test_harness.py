"""Does the validation judge as it says, and are its closed forms right where others are known? No rendering."""
import math
import os
import sys
import unittest

SAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "samples")
sys.path[:0] = [os.path.join(SAMPLES, "validation"), os.path.join(SAMPLES, "scenes_common")]
import harness  # noqa: E402
import references as ref  # noqa: E402
from harness import Case, Check  # noqa: E402


class Judging(unittest.TestCase):
    def passed(self, value, error, reference=100.0, **check):
        case = Case("case", "case", None, [])
        return harness.judge(case, "pt", Check("set", reference, 0, **check), (value, error, 0.0), 64, 1.0).passed

    def test_half_a_percent_or_three_standard_errors(self):
        self.assertIs(self.passed(100.49, 0.01), True)
        self.assertIs(self.passed(100.51, 0.01), False)
        self.assertIs(self.passed(99.49, 0.01), False)
        self.assertIs(self.passed(100.56, 0.19), True)
        self.assertIs(self.passed(100.58, 0.19), False)

    def test_noise_is_no_excuse(self):
        self.assertIs(self.passed(100, 0.21), False)
        self.assertIs(self.passed(100, -1), False)  # not known
        self.assertIs(self.passed(math.nan, 0.01), False)

    def test_dark_is_dark(self):
        self.assertIs(self.passed(0, 0, reference=0), True)
        self.assertIs(self.passed(1e-6, 1e-6, reference=0), False)

    def test_what_is_not_judged_does_not_pass(self):
        self.assertIsNone(self.passed(100, 0.01, judged=False))


class Growing(unittest.TestCase):
    def growth(self, *errors, reference=100.0):
        case = Case("case", "case", None, [])
        return harness.growth([harness.judge(case, "pt", Check("set", reference, 0), (reference, e, 0.0), 64, 1.0)
                               for e in errors])

    def test_the_noisiest_check_decides(self):
        self.assertEqual(self.growth(0.1, 0.4), 5)  # 1.1 * (0.4 / 0.2)^2
        self.assertEqual(self.growth(0.21), 2)
        self.assertEqual(self.growth(30.0), 8)
        self.assertEqual(self.growth(0.6, -1.0), 4)


class ClosedForms(unittest.TestCase):
    def test_parallel_squares(self):
        """Of a unit square at unit distance, over its corner: (2 / (2 pi sqrt 2)) atan(1 / sqrt 2)."""
        corner = math.atan(math.sqrt(0.5)) / (math.pi * math.sqrt(2))
        self.assertAlmostEqual(ref.polygon_factor((0, 0, 0), (0, 0, 1), ref.horizontal(0, 1, 0, 1, 1)), corner, 12)
        # Four squares side by side, and turned upside down.
        floor = ref.horizontal(-1, 1, -1, 1, 0)
        self.assertAlmostEqual(ref.polygon_factor((0, 0, 1), (0, 0, -1), floor), 4 * corner, 12)

    def test_horizon_hides_half_of_an_endless_wall(self):
        wall = ref.vertical(-1e4, 1e4, 1, -1e4, 1e4)
        self.assertAlmostEqual(ref.polygon_factor((0, 0, 0), (0, 0, 1), wall), 0.5, 3)
        self.assertAlmostEqual(ref.polygon_factor((0, 0, 0), (0, 1, 0), wall), 1, 3)
        self.assertEqual(ref.polygon_factor((0, 0, 0), (0, -1, 0), wall), 0)

    def test_faces_of_a_room_fill_the_sphere(self):
        whole = 2 * ref.rectangle_solid_angle(4, 4, 1.5) + 4 * ref.rectangle_solid_angle(4, 3, 2)
        self.assertAlmostEqual(whole, 4 * math.pi, 12)

    def test_glass(self):
        """2 n / (n^2 + 1) at normal incidence; all of one polarisation passes at Brewster's angle."""
        self.assertAlmostEqual(ref.slab_transmittance(0, 1.5, 0, 0.006), 2 * 1.5 / 3.25, 12)
        s = ((1 - 1.5 ** 2) / (1 + 1.5 ** 2)) ** 2
        expected = (1 + (1 - s) / (1 + s)) / 2
        self.assertAlmostEqual(ref.slab_transmittance(math.degrees(math.atan(1.5)), 1.5, 0, 0.006), expected, 12)
        self.assertAlmostEqual(ref.slab_transmittance(0, 1, 100, 0.01), math.exp(-1), 12)

    def test_disc_through_nothing(self):
        """pi L R^2 / (R^2 + d^2)."""
        through = ref.disc_through_slab(1000, 2, 0.5, 0.006, 1, lambda degrees: 1)
        self.assertAlmostEqual(through, math.pi * 1000 * 4 / 4.25, 6)


if __name__ == "__main__":
    unittest.main()
