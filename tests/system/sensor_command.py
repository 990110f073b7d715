# SPDX-License-Identifier: BSD-3-Clause
"""Each effect of render.sh --sensor does what its unit says: a camera slides before a plane of known depth."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import cv2
import numpy as np

import sensor
import sensor_effects as fx
from sequence_files import SequenceFiles

WIDTH, HEIGHT, F, Z_M, RATE_HZ, FRAMES = 160, 120, 100.0, 2.0, 20.0, 4
SPEED_PX = 6.0  # of the picture a frame, to the left


def edge_x(frame):
    """Column of a black-to-white edge in a frame."""
    return 90.5 - SPEED_PX * frame


def texture(frame):
    """Black left and white right of the edge, over marks that let optical flow find the motion everywhere."""
    u = np.arange(8 * WIDTH) / 8 - 0.4375
    world = u + SPEED_PX * frame
    line = np.where(world > edge_x(0), 190.0, 60.0) + 14 * np.sin(world / 3.1)
    rows = 1 + 0.12 * np.sin(np.arange(HEIGHT) / 4.0)[:, None]
    return np.clip(rows * line.reshape(WIDTH, 8).mean(axis=1), 0, 255).astype(np.uint8)


def write_sequence(folder, depth=True, image=texture):
    (folder / "gray").mkdir(parents=True)
    (folder / "depth").mkdir()
    (folder / "camera.yaml").write_text(f"width: {WIDTH}\nheight: {HEIGHT}\nfx: {F}\nfy: {F}\ncx: 79.5\ncy: 59.5\n")
    stamps = [(i + 1) / RATE_HZ for i in range(FRAMES)]
    (folder / "rgb.txt").write_text("".join(f"{t:.6f} gray/{i:04d}.png\n" for i, t in enumerate(stamps)))
    (folder / "groundtruth.txt").write_text(
        "".join(f"{t:.6f} {SPEED_PX * Z_M / F * i:.9f} 0 0 0 0 0 1\n" for i, t in enumerate(stamps))
    )
    for i in range(FRAMES):
        cv2.imwrite(str(folder / f"gray/{i:04d}.png"), image(i))
        if depth:
            cv2.imwrite(str(folder / f"depth/{i:04d}.png"), np.full((HEIGHT, WIDTH), round(5000 * Z_M), np.uint16))


def edge_columns(grey):
    """Sub-pixel column where each row passes the middle of the edge near the middle of the picture."""
    g = cv2.GaussianBlur(grey.astype(float), (1, 1), 0)
    level = 0.5 * (np.percentile(g, 15, axis=1) + np.percentile(g, 85, axis=1))
    columns = []
    for row, middle in zip(g, level):
        over = np.flatnonzero((row[:-1] < middle) & (row[1:] >= middle))
        k = over[np.abs(over - 84).argmin()]
        columns.append(k + (middle - row[k]) / (row[k + 1] - row[k]))
    return np.array(columns)


class Sensor(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.work = Path(temporary.name)

    def run_sensor(self, *options, source="in", output="out", status=0):
        done = subprocess.run(
            [sys.executable, sensor.__file__, str(self.work / source), str(self.work / output), *options],
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.returncode, status, done.stderr)
        return SequenceFiles(self.work / output) if status == 0 else done.stderr

    def flat(self, grey=128):
        write_sequence(self.work / "in", image=lambda i: np.full((HEIGHT, WIDTH), grey, np.uint8))

    def test_nothing_asked_changes_nothing(self):
        write_sequence(self.work / "in")
        np.testing.assert_array_equal(self.run_sensor().grey(1), texture(1))

    def test_noise_has_its_sigma_and_its_seed(self):
        self.flat()
        first = self.run_sensor("--noise", "3").grey(0)
        self.assertAlmostEqual(first.std(), 3.0, delta=0.15)
        np.testing.assert_array_equal(first, self.run_sensor("--noise", "3", output="again").grey(0))
        self.assertTrue((first != self.run_sensor("--noise", "3", "--seed", "2", output="other").grey(0)).any())

    def test_vignetting_takes_its_share_in_the_corners(self):
        self.flat()
        light = fx.linear_light(self.run_sensor("--vignetting", "0.5").grey(0))
        self.assertAlmostEqual(light[0, 0] / light[60, 80], 0.5, delta=0.02)

    def test_gain_wanders_with_its_spread(self):
        gains = np.log(fx.wandering_gain(np.arange(20000) / 15.0, 0.2, 5))
        self.assertAlmostEqual(gains.std(), 0.2, delta=0.02)
        self.assertAlmostEqual(np.corrcoef(gains[:-15], gains[15:])[0, 1], np.exp(-1), delta=0.08)
        self.flat()
        files = self.run_sensor("--gain", "0.2", "--seed", "5")
        light = [fx.linear_light(files.grey(i)).mean() for i in range(FRAMES)]
        wanted = fx.wandering_gain(files.stamps, 0.2, 5)
        np.testing.assert_allclose(light / light[0], wanted / wanted[0], rtol=0.02)

    def test_rolling_shutter_shears_the_edge(self):
        for depth in (True, False):
            with self.subTest(depth=depth):
                source, output = f"in{depth}", f"out{depth}"
                write_sequence(self.work / source, depth)
                files = self.run_sensor("--rolling-shutter", "40", source=source, output=output)
                x = edge_columns(files.grey(1))
                wanted = edge_x(1) - SPEED_PX * 0.040 * RATE_HZ * (np.arange(HEIGHT) / HEIGHT - 0.5)
                self.assertLess(np.abs(x - wanted)[10:-10].max(), 0.35)
                self.assertAlmostEqual(files.yaml["readout_s"], 0.040)

    def test_motion_blur_smears_over_the_exposure(self):
        for depth in (True, False):
            with self.subTest(depth=depth):
                source = f"in{depth}"
                write_sequence(self.work / source, depth)
                grey = self.run_sensor("--motion-blur", "50", source=source, output=f"out{depth}").grey(1).astype(float)
                around = int(edge_x(1))
                slope, sharp = (np.diff(g[60, around - 6 : around + 8]).max() for g in (grey, texture(1).astype(float)))
                self.assertLess(
                    slope, 0.4 * sharp
                )  # 6 px long: a sixth of the step a pixel, not the whole in one or two
                self.assertAlmostEqual(np.median(edge_columns(grey)), edge_x(1), delta=0.6)

    def test_distortion_is_that_of_the_written_camera(self):
        dots = np.array([[30, 25], [130, 30], [80, 60], [40, 95], [125, 90]], float)

        def dotted(_):
            v, u = np.mgrid[0:HEIGHT, 0:WIDTH]
            return np.clip(40 + sum(200 * np.exp(-((u - x) ** 2 + (v - y) ** 2) / 6) for x, y in dots), 0, 255).astype(
                np.uint8
            )

        write_sequence(self.work / "in", image=dotted)
        for lens in ("-0.2,0.05", "0.1,0"):
            files = self.run_sensor("--distortion", lens, output="out" + lens)
            c, grey = files.camera, files.grey(0).astype(float)
            rays = np.column_stack([(dots - [79.5, 59.5]) / F, np.ones(len(dots))])
            K = np.array([[c.fx, 0, c.cx], [0, c.fy, c.cy], [0, 0, 1]])
            wanted = cv2.projectPoints(rays, np.zeros(3), np.zeros(3), K, np.array(files.lens()))[0].reshape(-1, 2)
            for x, y in wanted:
                if not (6 < x < WIDTH - 7 and 6 < y < HEIGHT - 7):
                    continue
                u, v = np.meshgrid(np.arange(round(x) - 5, round(x) + 6), np.arange(round(y) - 5, round(y) + 6))
                weight = grey[v, u] - 40
                self.assertLess(
                    np.hypot((weight * u).sum() / weight.sum() - x, (weight * v).sum() / weight.sum() - y), 0.1
                )
            self.assertGreater(np.abs(wanted - dots).max(), 1.0)
            self.assertGreater(grey.min(), 30)  # no black rim

    def test_jpeg_of_lower_quality_is_smaller_and_worse(self):
        write_sequence(self.work / "in")
        size, error = {}, {}
        for quality in ("95", "20"):
            files = self.run_sensor("--jpeg", quality, output=quality)
            path = files.folder / files.pictures[1]
            self.assertEqual(path.suffix, ".jpg")
            size[quality], error[quality] = path.stat().st_size, np.abs(files.grey(1).astype(float) - texture(1)).mean()
        self.assertLess(size["20"], 0.6 * size["95"])
        self.assertGreater(error["20"], 2 * error["95"])

    def test_bad_input_is_one_line_and_changes_nothing(self):
        write_sequence(self.work / "in")
        (self.work / "out").mkdir()
        (self.work / "out/mine.txt").write_text("mine")
        self.assertIn("nothing was changed", self.run_sensor("--noise", "1", status=1))
        self.assertEqual([p.name for p in (self.work / "out").iterdir()], ["mine.txt"])
        self.assertIn("--jpeg", self.run_sensor("--jpeg", "0", output="new", status=2))
        self.assertIn("--distortion", self.run_sensor("--distortion", "1", output="new", status=2))
        self.assertIn("camera.yaml", self.run_sensor(source="out", output="new", status=1))


if __name__ == "__main__":
    unittest.main()
