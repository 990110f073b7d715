# SPDX-License-Identifier: BSD-3-Clause
"""Runs mono-slam once more for pictures of some frames, with the command that made the run."""
import os
import shlex
import shutil
import subprocess
import tempfile
from pathlib import Path

from .errors import ReportError
from .job import Job


class Rerun:
    def __init__(self, batch: Path, results: Path, programs: Path):
        """Asks mono-slam-batch for the commands of \\p batch."""
        call = [programs / "mono-slam-batch", batch, "--output", results, "--list"]
        self._commands = {}
        for line in output_of(call).splitlines():
            words = shlex.split(line)
            slam = words[:words.index("&&")]
            self._commands[Path(slam[slam.index("--output") + 1]).resolve()] = slam
        self._drawn: dict[Path, tempfile.TemporaryDirectory] = {}

    def draw(self, job: Job, number: int, destination: Path) -> None:
        made = self._pictures(job) / f"frame_{number:06d}.jpg"
        if not made.exists():
            raise ReportError(f"{job.folder}: frame {number} was not drawn by mono-slam --pictures")
        part = destination.with_suffix(".part")
        shutil.copyfile(made, part)
        os.replace(part, destination)

    def _pictures(self, job: Job) -> Path:
        folder = job.folder.resolve()
        if folder not in self._commands:
            raise ReportError(f"{job.folder}: not a run of the batch given with --pictures, or that has changed")
        if folder not in self._drawn:
            self._drawn[folder] = tempfile.TemporaryDirectory(prefix="mono-slam-report-")
            command = list(self._commands[folder])
            command[command.index("--output") + 1] = self._drawn[folder].name
            output_of([*command, "--pictures"])
        return Path(self._drawn[folder].name) / "pictures"


def output_of(command: list) -> str:
    try:
        run = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    except OSError as error:
        raise ReportError(f"{command[0]}: {error.strerror}") from None
    if run.returncode:
        said = (run.stderr or run.stdout).strip().splitlines()
        raise ReportError(f"{Path(command[0]).name}: {said[-1] if said else f'exit status {run.returncode}'}")
    return run.stdout
