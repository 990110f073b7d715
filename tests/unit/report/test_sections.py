# SPDX-License-Identifier: BSD-3-Clause
"""What the figures and tables of a report are computed from."""
import math
import unittest

import numpy as np
import pandas as pd
from batch_folder import BatchFolder
from monoslam_report import summary
from monoslam_report.bands import band
from monoslam_report.consistency import nees_of, nis_of
from monoslam_report.context import Context
from monoslam_report.cost import log_eq14, log_eq15
from monoslam_report.figures import FigureFolder, inline
from monoslam_report.maps import ellipses
from monoslam_report.page import short
from monoslam_report.rejections import rates
from monoslam_report.results import Cell, read_results
from monoslam_report.style import SERIES, Look

CIRCLE = Cell("circle", "default")


class Curves(unittest.TestCase):
    def test_eq14_is_the_printed_sum(self):
        for n in range(2, 30):
            for r in range(1, n):
                printed = 2**n - sum(2 ** (n - i) for i in range(1, r + 1))
                self.assertAlmostEqual(float(log_eq14(n, r)), math.log10(printed), places=9)

    def test_eq15_is_the_printed_sum(self):
        for n in (1, 2, 12, 50):
            for r in range(1, 8):
                printed = sum(n**i for i in range(1, r + 1))
                self.assertAlmostEqual(float(log_eq15(n, r)), math.log10(printed), places=9)

    def test_eq15_of_many_pairs_does_not_overflow(self):
        self.assertAlmostEqual(float(log_eq15(100, 300)), 600 + math.log10(100 / 99), places=6)


class Bands(unittest.TestCase):
    def test_are_over_the_seeds_at_equal_times(self):
        t = np.arange(5.0)
        got = band([(t, t), (t, t + 1), (t, t + 5)])
        np.testing.assert_allclose(got["median"], t + 1)
        np.testing.assert_allclose(got["most"] - got["least"], 5)

    def test_have_few_points_however_many_frames(self):
        t = np.arange(20000.0)
        self.assertLessEqual(len(band([(t, t)], points=100)), 101)

    def test_leave_out_what_is_not_finite(self):
        self.assertEqual(len(band([(np.array([0.0, 1]), np.array([math.nan, math.inf]))])), 0)


class Ellipses(unittest.TestCase):
    def test_hold_95_percent(self):
        P = np.array([[4.0, 1.5, 0], [1.5, 1, 0], [0, 0, 1]])
        (width,), (height,), (angle,) = ellipses(P[None])
        drawn = np.random.default_rng(1).multivariate_normal([0, 0], P[:2, :2], 20000)
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        along, across = drawn @ [c, s], drawn @ [-s, c]
        inside = (2 * along / width) ** 2 + (2 * across / height) ** 2 < 1
        self.assertAlmostEqual(inside.mean(), 0.95, delta=0.006)


class Inlined(unittest.TestCase):
    SVG = ('<?xml version="1.0"?><!DOCTYPE svg "http://x"><svg width="5pt" height="5pt" viewBox="0 0 5 5" '
           'xmlns="http://www.w3.org/2000/svg"><metadata>http://y</metadata><defs><path id="m"/></defs>'
           f'<use xlink:href="#m" clip-path="url(#c)" style="fill: {SERIES[0][0]}; stroke: #123456"/></svg>')

    def test_refer_to_nothing_outside_and_follow_the_scheme(self):
        got = inline(self.SVG, "one", 'a "label"')
        self.assertNotIn("http", got)
        self.assertIn("var(--series0)", got)
        self.assertIn("#123456", got)
        self.assertTrue(got.startswith("<svg"))

    def test_two_in_one_page_keep_apart(self):
        got = inline(self.SVG, "one", "")
        for text in ('id="one-m"', 'href="#one-m"', "url(#one-c)"):
            self.assertIn(text, got)


class OfABatch(unittest.TestCase):
    def setUp(self):
        self.batch = BatchFolder()
        self.addCleanup(self.batch.close)

    def context(self) -> Context:
        results = read_results(self.batch.collect())
        return Context(results, FigureFolder(self.batch.path), Look(results.strategies), results.strategies[0])

    def test_failed_runs_lose_and_pending_ones_say_nothing(self):
        self.batch.add("a", 1, SE3_ate_rmse_mm=2.0)
        self.batch.add("a", 2, SE3_ate_rmse_mm=2.0)
        self.batch.add("b", 1, status="failed")
        self.batch.add("b", 2, status="pending")
        context = self.context()
        got = summary.values(context, CIRCLE, "b", summary.POSITION)
        self.assertEqual(got[1], math.inf)
        self.assertTrue(math.isnan(got[2]))
        self.assertEqual(summary.tested(context, CIRCLE, "b", summary.POSITION)[:3], (0, 1, 0))

    def test_failed_runs_without_any_truth_say_nothing(self):
        self.batch.add("a", 1)
        self.batch.add("b", 1, status="failed")
        self.assertTrue(math.isnan(summary.values(self.context(), CIRCLE, "b", summary.POSITION)[1]))

    def test_seeds_are_paired_by_number_not_by_order(self):
        for seed, error in ((1, 1.0), (2, 5.0)):
            self.batch.add("a", seed, SE3_ate_rmse_mm=error)
        for seed, error in ((2, 4.0), (1, 0.5)):
            self.batch.add("b", seed, SE3_ate_rmse_mm=error)
        self.assertEqual(summary.tested(self.context(), CIRCLE, "b", summary.POSITION)[:3], (2, 0, 0))

    def test_nis_of_a_consistent_filter_is_inside_its_bounds(self):
        for seed in range(60):
            self.batch.add("a", seed)
        tables = [nis_of(job) for job in self.context().results.jobs]
        together = pd.concat(tables)
        self.assertAlmostEqual(together["inside"].mean(), 0.95, delta=0.02)
        self.assertAlmostEqual(together["ratio"].mean(), 1, delta=0.03)

    def test_nees_leaves_out_the_pose_that_aligns(self):
        folder = self.batch.add("a", 1)
        (folder / "errors.csv").write_text("t_s,nees\n100,0\n100.1,6\n100.2,60\n100.3,\n")
        got = nees_of(self.context().results.jobs[0])
        self.assertEqual(list(got["ratio"]), [1, 10])
        self.assertEqual(list(got["inside"]), [True, False])

    def test_no_joint_distance_is_no_nis(self):
        folder = self.batch.add("a", 1)
        table = pd.read_csv(folder / "frames.csv").assign(joint_d2=0)
        table.to_csv(folder / "frames.csv", index=False)
        self.assertIsNone(nis_of(self.context().results.jobs[0]))


class Rates(unittest.TestCase):
    def test_pool_pairs_and_count_frames(self):
        table = pd.DataFrame({"pairs": [10, 30, 0], "rejected": [1, 3, 0]})
        got = rates([table, table.assign(rejected=0)])
        np.testing.assert_allclose(got["pairs"], [5, 5, 0])
        np.testing.assert_allclose(got["frames"], [50, 50, 0])


class Numbers(unittest.TestCase):
    def test_have_three_digits(self):
        shown = {0.0: "0", 12.0: "12", 0.01234: "0.0123", 1.0001: "1.00", 45678.9: "45679", math.inf: "∞", 1e-7: "1.00e-07"}
        for number, text in shown.items():
            self.assertEqual(short(number), text)


if __name__ == "__main__":
    unittest.main()
