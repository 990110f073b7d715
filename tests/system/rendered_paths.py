# SPDX-License-Identifier: BSD-3-Clause
"""Paths and marks of the rendered worlds keep what the experiments rely on; nothing is rendered here."""

import functools
import unittest

import numpy as np

import lab
import office
import trajectory as tj
from reprojection import PAPER_M, TARGET_W

FREE_M = 0.2  # of the camera from any box


@functools.cache
def every():
    return lab.sequences(False) + office.sequences(False) + lab.sequences(True) + office.sequences(True)


class Paths(unittest.TestCase):
    def test_names_and_lengths(self):
        sequences = lab.sequences(False)
        self.assertEqual(
            sorted(s.name for s in sequences),
            sorted(f"lab_{kind}_{k}" for kind in ("uturn", "turn", "rails", "corridor") for k in range(1, 6)),
        )
        self.assertTrue(all(450 <= len(s.poses) <= 1050 for s in sequences))
        self.assertLess(abs(sum(len(s.poses) for s in sequences) - 12000), 600)
        self.assertEqual(
            [(s.name, len(s.poses)) for s in office.sequences(False)], [("office", 600), ("office_moved", 200)]
        )

    def test_office_moved_follows_the_same_path_and_displaces_one_box(self):
        resting, moved = office.sequences(False)
        np.testing.assert_array_equal(resting.poses[:200], moved.poses)
        shift = np.linalg.norm(np.subtract(moved.moving(199)[0].centre, resting.moving(199)[0].centre))
        self.assertTrue(0.03 < shift < 0.1, shift)
        self.assertEqual(moved.moving(office.MOVED_FROM), resting.moving(office.MOVED_FROM))

    def test_target_is_wholly_in_view_in_frame_0(self):
        for s in every():
            paper = s.camera.project(s.poses[0], TARGET_W * [PAPER_M[0] / 0.21, PAPER_M[1] / 0.1485, 0])
            with self.subTest(s.name):
                self.assertTrue((paper > 3).all() and (paper < [s.camera.width - 4, s.camera.height - 4]).all(), paper)

    def test_straight_is_exactly_three_metres(self):
        for s in [s for s in every() if "uturn" in s.name]:
            first, last = s.segments["straight"]
            way = s.poses[first : last + 1, 1:4]
            self.assertAlmostEqual(np.linalg.norm(way[-1] - way[0]), 3.0, places=8)
            across = np.cross(way - way[0], (way[-1] - way[0]) / 3)
            self.assertLess(np.abs(across).max(), 1e-8, s.name)

    def test_turns_almost_close(self):
        for s in [s for s in lab.sequences(False) if "_turn" in s.name]:
            ends = [tj.rotation(s.poses[i, 4:])[:2, 2] for i in s.segments["turn"]]
            angle = np.degrees(np.arccos(ends[0] @ ends[1] / np.prod(np.linalg.norm(ends, axis=1))))
            self.assertTrue(5 < angle < 40, f"{s.name}: {angle}")

    def test_camera_runs_into_no_box(self):
        for s in every():
            for i in range(0, len(s.poses), 5):
                near = [b.centre for b in s.still + s.moving(i) if b.holds(s.poses[i, 1:4], FREE_M)]
                self.assertFalse(near, f"{s.name}, frame {i}")

    def test_motion_is_smooth(self):
        for s in every():
            step = np.linalg.norm(np.diff(s.poses[:, 1:4], axis=0), axis=1)
            self.assertLess(step.max() - step[len(step) // 2], 0.02, s.name)
            self.assertLess(np.abs(np.linalg.norm(s.poses[:, 4:], axis=1) - 1).max(), 1e-8)

    def test_marks_lie_within_the_sequence(self):
        for s in every():
            for o in s.objects:
                self.assertIn(o["kind"], ("moving", "moved", "crossing_edges", "repeated"))
                self.assertTrue(0 <= o["from_frame"] < o["to_frame"] < len(s.poses), (s.name, o))
            for first, last in s.segments.values():
                self.assertTrue(0 <= first < last < len(s.poses), s.name)

    def test_clutter_differs_between_sequences_and_repeats_with_its_seed(self):
        first, second, again = lab.clutter(1), lab.clutter(2), lab.clutter(1)
        self.assertEqual(first, again)
        self.assertNotEqual(first, second)


if __name__ == "__main__":
    unittest.main()
