# SPDX-License-Identifier: BSD-3-Clause
"""Reading a batch's folder: what is there, what is missing, what is damaged."""
import json
import math
import unittest
from pathlib import Path

import numpy as np
from batch_folder import BatchFolder
from monoslam_report.errors import ReportError
from monoslam_report.experiment import read_experiment
from monoslam_report.results import Cell, read_results

CIRCLE = Cell("circle", "default")


class FolderTest(unittest.TestCase):
    def setUp(self):
        self.batch = BatchFolder()
        self.addCleanup(self.batch.close)

    def refused(self, read, *words: str) -> None:
        with self.assertRaises(ReportError) as raised:
            read()
        message = str(raised.exception)
        self.assertNotIn("\n", message)
        for word in words:
            self.assertIn(word, message)


class Results(FolderTest):
    def test_keeps_the_order_of_the_batch(self):
        for strategy in ("zeta", "alpha"):
            for seed in (2, 1):
                self.batch.add(strategy, seed)
        results = read_results(self.batch.collect())
        self.assertEqual(results.strategies, ["zeta", "alpha"])
        self.assertEqual([job.seed for job in results.jobs_of(CIRCLE, "zeta")], [2, 1])

    def test_no_file_names_the_command_that_writes_it(self):
        self.refused(lambda: read_results(self.batch.path), "results.csv", "--collect")

    def test_a_missing_column_is_named(self):
        (self.batch.path / "results.csv").write_text("sequence,strategy\na,b\n")
        self.refused(lambda: read_results(self.batch.path), "'variant' is missing")

    def test_an_unknown_status_is_named_with_its_line(self):
        self.batch.add("a", 1)
        self.batch.add("a", 2, status="lost")
        self.refused(lambda: read_results(self.batch.collect()), "line 3", "'lost'")

    def test_an_empty_table_is_refused(self):
        (self.batch.path / "results.csv").write_text("")
        self.refused(lambda: read_results(self.batch.path), "results.csv")

    def test_names_that_look_like_no_value_stay_names(self):
        self.batch.add("none", 1, sequence="NA")
        results = read_results(self.batch.collect())
        self.assertEqual((results.cells[0].sequence, results.strategies), ("NA", ["none"]))


class Jobs(FolderTest):
    def job(self, **kind):
        folder = self.batch.add("a", 1, **kind)
        return folder, read_results(self.batch.collect()).jobs[0]

    def test_paths_are_aligned(self):
        _, job = self.job()
        self.assertLess(job.track.position_error_m.max(), 0.01)
        self.assertLess(job.track.rotation_error_deg.max(), 1e-6)
        self.assertAlmostEqual(job.track.scale, 1)

    def test_scale_is_fitted_only_without_a_target(self):
        _, job = self.job(run_map_known=0)
        self.assertNotEqual(job.track.scale, 1)
        self.assertAlmostEqual(job.track.scale, 1, places=2)

    def test_missing_files_are_notes(self):
        folder, job = self.job()
        (folder / "frames.csv").unlink()
        self.assertIsNone(job.frames)
        self.assertIn("frames.csv: no such file", job.notes[0])

    def test_damaged_files_are_notes(self):
        folder, job = self.job()
        (folder / "map.csv").write_text("a,b\n1,2\n")
        (folder / "trajectory.tum").write_text("1 2 3\n")
        self.assertIsNone(job.map)
        self.assertIsNone(job.track)
        self.assertEqual(len(job.notes), 2)

    def test_runs_without_truth_have_no_track_and_no_note(self):
        folder, job = self.job()
        (folder / "groundtruth.tum").unlink()
        self.assertIsNone(job.track)
        self.assertEqual(job.notes, [])

    def test_errors_csv_stands_in_for_the_truth(self):
        folder, job = self.job()
        (folder / "groundtruth.tum").unlink()
        (folder / "errors.csv").write_text("t_s,position_error_m,rotation_error_rad,nees,x_m,y_m,z_m,true_x_m,true_y_m,"
                                           "true_z_m\n100,0.5,0.1,6,1,2,3,1,2,3.5\n101,0.5,0.1,,1,2,3,1,2,3.5\n")
        np.testing.assert_allclose(job.track.truth[0], [1, 2, 3.5])
        self.assertAlmostEqual(job.track.rotation_error_deg[0], math.degrees(0.1))

    def test_failed_runs_are_not_read(self):
        _, job = self.job(status="failed")
        self.assertEqual((job.frames, job.track, job.notes), (None, None, []))
        self.assertEqual(job.error, "ran away")


class Experiments(FolderTest):
    def write(self, content) -> Path:
        (self.batch.path / "report.json").write_text(json.dumps(content))
        return self.batch.path

    def test_none_is_none(self):
        self.assertIsNone(read_experiment(self.batch.path))

    def test_tables_and_text_become_sections(self):
        (self.batch.path / "t.csv").write_text('a,b\n1,"2, 3"\n')
        sections = read_experiment(self.write({"sections": [{"title": "T", "text": "*x*", "table": "t.csv"}]})).sections
        self.assertIn("<em>x</em>", sections[0].blocks[0])
        self.assertEqual(sections[0].blocks[1].rows, [["1", "2, 3"]])

    def test_a_missing_figure_is_named(self):
        self.write({"sections": [{"title": "T", "figure": "figures/x"}]})
        self.refused(lambda: read_experiment(self.batch.path), "sections[0].figure", "figures/x.svg")

    def test_an_unknown_key_is_named(self):
        self.write({"sections": [{"title": "T", "tabel": "t.csv"}]})
        self.refused(lambda: read_experiment(self.batch.path), "sections[0]", "'tabel'")

    def test_broken_json_is_one_line(self):
        (self.batch.path / "report.json").write_text("{")
        self.refused(lambda: read_experiment(self.batch.path), "report.json")


if __name__ == "__main__":
    unittest.main()
