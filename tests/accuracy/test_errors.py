#!/usr/bin/env python3
"""The arithmetic of samples/accuracy, by cases with known answers."""
import os
import sys
import unittest

sys.path[:0] = [os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "samples", folder)
                for folder in ("scenes_common", "accuracy")]
import need_numpy  # noqa: E402,F401
import errors  # noqa: E402
import foretold  # noqa: E402

ROOT = [(1.0, 0.04), (4.0, 0.02), (16.0, 0.01)]  # falls with the square root of time


def meters(values, bound=0.0):
    return {"set": [{"illuminance_lx": value, "error_bound_lx": bound} for value in values]}


class Against(unittest.TestCase):
    def test_percentiles_and_mean(self):
        reference = meters([100.0] * 100)
        found = errors.against(meters([101.0] * 90 + [110.0] * 10), reference)
        self.assertAlmostEqual(found["true_median"], 0.01)
        self.assertAlmostEqual(found["true_p95"], 0.10)
        self.assertAlmostEqual(found["mean_off"], 0.019)

    def test_dark_meters_count_as_a_twentieth_of_the_mean(self):
        found = errors.against(meters([100.0, 100.0, 1.0]), meters([100.0, 100.0, 0.0]))
        mean = 200 / 3
        self.assertAlmostEqual(found["true_p95"], 0.9 * 1 / (0.05 * mean))  # between the second and the third

    def test_share_of_bounds_that_hold(self):
        values = [100.5] * 95 + [102.0] * 5
        self.assertAlmostEqual(errors.against(meters(values, 1.0), meters([100.0] * 100))["bounds_held"], 0.95)
        # The reference's own bound counts, too: hypot(1, 2) > 2.
        self.assertAlmostEqual(errors.against(meters(values, 1.0), meters([100.0] * 100, 2.0))["bounds_held"], 1.0)
        self.assertEqual(errors.against(meters(values, -1.0), meters([100.0] * 100))["bounds_held"], errors.UNKNOWN)

    def test_stated_bound_is_unknown_where_half_the_meters_have_none(self):
        few = {"set": meters([100.0] * 3, 2.0)["set"] + meters([100.0] * 2, -1.0)["set"]}
        self.assertAlmostEqual(errors.stated_bound(few), 0.02)
        self.assertEqual(errors.stated_bound({"set": few["set"][1:]}), errors.UNKNOWN)


class AgainstTime(unittest.TestCase):
    def test_time_to_a_level(self):
        self.assertEqual(errors.time_to(ROOT, 0.05), ("sooner", 1.0))
        self.assertEqual(errors.time_to(ROOT, 0.005), ("later", 16.0))
        self.assertEqual(errors.time_to([(1.0, -1.0)], 0.05), ("unknown", -1.0))
        status, seconds = errors.time_to(ROOT, 0.04 / 2 ** 0.5)
        self.assertEqual(status, "reached")
        self.assertAlmostEqual(seconds, 2.0)

    def test_an_error_that_rises_again_is_not_reached_yet(self):
        status, seconds = errors.time_to([(1, 0.04), (2, 0.01), (4, 0.04), (16, 0.01)], 0.02)
        self.assertEqual(status, "reached")
        self.assertAlmostEqual(seconds, 8.0)
        self.assertEqual(errors.time_to([(1, 0.04), (2, 0.01), (4, 0.04)], 0.02), ("later", 4))

    def test_error_at_a_time(self):
        self.assertAlmostEqual(errors.at_time(ROOT, 2.0), 0.04 / 2 ** 0.5)
        self.assertEqual(errors.at_time(ROOT, 20.0), errors.UNKNOWN)
        self.assertEqual(errors.at_time([], 1.0), errors.UNKNOWN)


class Predictions(unittest.TestCase):
    def test_predicted_beside_actual(self):
        curve = [{"time_s": s, "median_relative_error": e, "worst_relative_error": 1.0} for s, e in ROOT]
        made = [{"relative_error": 0.05, "seconds": 0.5, "low": 0.4, "high": 0.6, "limited_by": "noise"},
                {"relative_error": 0.02, "seconds": 4.5, "low": 3.0, "high": 6.0, "limited_by": "noise"},
                {"relative_error": 0.005, "seconds": -1, "low": -1, "high": -1, "limited_by": "bias"}]
        first, last = errors.predicted_and_actual(made, "median", curve, 2.0, 0.5, 1.0)  # 5 % was there already
        self.assertEqual((first["relative_error"], first["status"]), (0.02, "reached"))
        self.assertAlmostEqual(first["predicted_seconds"], 9.0)
        self.assertAlmostEqual(first["high_seconds"], 12.0)
        self.assertAlmostEqual(first["actual_seconds"], 2.0)
        self.assertEqual((last["status"], last["predicted_seconds"], last["actual_seconds"]), ("later", -1.0, 8.0))

    def test_within_the_limits(self):
        def row(status, actual, low, high):
            return {"status": status, "actual_seconds": actual, "low_seconds": low, "high_seconds": high}
        self.assertTrue(errors.came_true(row("reached", 2, 1, 3)))
        self.assertFalse(errors.came_true(row("reached", 4, 1, 3)))
        self.assertFalse(errors.came_true(row("reached", 0.5, 1, -1)))
        self.assertTrue(errors.came_true(row("reached", 400, 1, -1)))
        self.assertIs(errors.came_true(row("later", 4, 1, 3)), False)  # not there yet, and should have been
        self.assertIsNone(errors.came_true(row("later", 2, 1, 3)))
        self.assertFalse(errors.came_true(row("reached", 2, -1, -1)))  # was to be never
        self.assertIsNone(errors.came_true(row("later", 2, -1, -1)))


class Foretelling(unittest.TestCase):
    """An error of 0.04 sqrt(16 / n) meets 1 % after 256 iterations; 2 s are spent before the first, 0.1 s on each."""
    class Render:
        def __init__(self, seconds):
            self.seconds = seconds

        def render(self, _method, _seed, limit):
            count = 320 if limit[0] == "--target-error" else int(limit[1])
            curve = [{"time_s": 2 + 0.1 * n, "iterations": n, "median_relative_error": 0.04 * (16 / n) ** 0.5}
                     for n in (16, 64, 128, 320) if n <= count]
            made = {"relative_error": 0.01, "seconds": self.seconds, "low": 20.0, "high": 40.0, "limited_by": "noise"}
            return {"iterations": count, "time_s": 3 * (2 + 0.1 * count), "convergence": curve,  # by a slower clock
                    "prediction": [{**made, **{key: 3 * made[key] for key in ("seconds", "low", "high")
                                               if made[key] >= 0}}]}

    def test_foretold_over_actual(self):
        row = foretold.compare(self.Render(2 + 25.6), "median", 0.01, 1)
        self.assertAlmostEqual(row["actual_iterations"], 256)
        self.assertEqual(row["made_at_iterations"], 64)
        self.assertAlmostEqual(row["ratio"], 1)
        self.assertEqual(row["came_true"], 1)
        row = foretold.compare(self.Render(2 + 2 * 25.6), "median", 0.01, 1)
        self.assertAlmostEqual(row["ratio"], 2)

    def test_what_is_foretold_never(self):
        row = foretold.compare(self.Render(-1), "median", 0.01, 1)
        self.assertEqual((row["ratio"], row["foretold_iterations"]), (errors.UNKNOWN, errors.UNKNOWN))
        self.assertEqual(foretold.told_of(row), "never")

    def test_what_ends_too_soon_foretells_nothing(self):
        row = foretold.compare(self.Render(1), "median", 0.05, 1)
        self.assertEqual((row["status"], row["ratio"]), ("sooner", errors.UNKNOWN))


if __name__ == "__main__":
    unittest.main()
