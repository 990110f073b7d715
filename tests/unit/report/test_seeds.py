# SPDX-License-Identifier: BSD-3-Clause
"""Statistics over seeds: against numbers worked out by hand, numpy, and the binomial formula."""
import math
import unittest

import numpy as np
from monoslam_report.seeds import sign_test, summary


class SummaryOfSeeds(unittest.TestCase):
    def test_agrees_with_numpy(self):
        rng = np.random.default_rng(3)
        for n in range(1, 30):
            values = rng.normal(size=n)
            got = summary(values)
            np.testing.assert_allclose(
                [got.quartiles[0], got.median, got.quartiles[1]], np.quantile(values, [0.25, 0.5, 0.75]))
            self.assertEqual(got.n, n)

    def test_worst_is_the_largest_magnitude(self):
        self.assertEqual(summary([1, -7, 3]).worst, -7)

    def test_leaves_out_what_was_not_measured(self):
        self.assertEqual(summary([None, 2.0, math.nan, 4.0]), (3.0, (2.5, 3.5), 4.0, 2))

    def test_nothing_measured_is_no_number(self):
        empty = summary([None])
        self.assertEqual(empty.n, 0)
        self.assertTrue(math.isnan(empty.median) and math.isnan(empty.worst))

    def test_failed_runs_are_worse_than_every_number(self):
        got = summary([1, 2, 3, math.inf, math.inf, math.inf, math.inf])
        self.assertEqual((got.median, got.quartiles, got.worst), (math.inf, (2.5, math.inf), math.inf))
        self.assertEqual(summary([math.inf] * 3).iqr, 0)


class SignTestOfSeeds(unittest.TestCase):
    def test_p_is_the_binomial_one(self):
        # 1 of 6 or fewer, or 5 of 6 or more: 2 (1 + 6) / 64.
        got = sign_test([1, 1, 1, 1, 1, 9], [2, 2, 2, 2, 2, 2])
        self.assertEqual(got[:3], (5, 1, 0))
        self.assertAlmostEqual(got.p, 14 / 64)

    def test_exchanging_the_two_exchanges_wins_and_losses(self):
        a, b = [1, 5, 3, 3, 8], [2, 4, 6, 3, 9]
        first, second = sign_test(a, b), sign_test(b, a)
        self.assertEqual(first, (second.losses, second.wins, second.ties, second.p))

    def test_ties_and_missing_say_nothing(self):
        self.assertEqual(sign_test([1, 2, None, math.nan], [1, 2, 3, 4]), (0, 0, 2, 1.0))

    def test_a_failed_run_loses(self):
        self.assertEqual(sign_test([math.inf], [1e9])[:3], (0, 1, 0))

    def test_unequal_numbers_of_seeds_are_refused(self):
        with self.assertRaises(ValueError):
            sign_test([1, 2], [1])


if __name__ == "__main__":
    unittest.main()
