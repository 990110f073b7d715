# SPDX-License-Identifier: BSD-3-Clause
"""Example frames with the rejected pairs marked: pictures of mono-slam --pictures."""
import re
from pathlib import Path

from .context import Context
from .figures import Figure, picture
from .job import Job
from .page import Section
from .rerun import Rerun

MOST_PICTURES = 12
PER_RUN = 2
APART = 10  # frames; neighbours look alike
NUMBER = re.compile(r"frame_(\d+)\.jpg$")


def section(context: Context, rerun: Rerun | None) -> Section:
    out = Section("Example frames")
    out.say("Pictures as `mono-slam --pictures` draws them, of the frames in which most pairs were rejected. Ellipses: "
            "where a landmark is searched (99 %). Green: matched. Red: found, but rejected. Yellow: not found. Blue "
            "squares: new landmarks.")
    chosen = [(job, number) for job in first_runs(context) for number in worst_frames(job)
              if rerun or source(context, job, number)]
    out.blocks += [picture_of(context, job, number, rerun) for job, number in chosen[:MOST_PICTURES]]
    if not chosen:
        out.say("*No run has pictures, or nothing was rejected. `mono-slam-report RESULTS --pictures BATCH.ini` runs "
                "mono-slam once more to draw some.*")
    elif len(chosen) > MOST_PICTURES:
        out.say(f"The first {MOST_PICTURES} of {len(chosen)}.")
    return out


def first_runs(context: Context) -> list[Job]:
    return [jobs[0] for cell in context.drawn_cells() for name in context.results.strategies_of(cell)
            if (jobs := context.results.done(cell, name))]


def worst_frames(job: Job) -> list[int]:
    if job.frames is None or "index" not in job.frames:
        return []
    table = job.frames[job.frames["rejected"] > 0]
    there = numbers_in(job.folder / "pictures")  # mono-slam may have drawn only every nth
    if there:
        table = table[table["index"].isin(there)]
    chosen = []
    for i in table.sort_values("rejected", ascending=False, kind="stable")["index"]:
        if len(chosen) < PER_RUN and all(abs(i - other) >= APART for other in chosen):
            chosen.append(int(i))
    return chosen


def numbers_in(folder: Path) -> set[int]:
    return {int(NUMBER.search(file.name)[1]) for file in folder.glob("frame_*.jpg") if NUMBER.search(file.name)}


def kept(context: Context, job: Job, number: int) -> Path:
    """In RESULTS/figures, so that a picture is drawn once; the run's key in its name keeps older ones apart."""
    return context.figures.path(f"frame_{number:06d}_{job.sequence}_{job.strategy}_{job.variant}_{job.folder.name}.jpg")


def source(context: Context, job: Job, number: int) -> Path | None:
    files = [job.folder / "pictures" / f"frame_{number:06d}.jpg", kept(context, job, number)]
    return next((file for file in files if file.exists()), None)


def picture_of(context: Context, job: Job, number: int, rerun: Rerun | None) -> Figure:
    file = source(context, job, number)
    if file is None:
        file = kept(context, job, number)
        rerun.draw(job, number, file)
    row = job.frames[job.frames["index"] == number].iloc[0]
    caption = (f"{job.sequence}, {job.strategy}, {job.variant}, seed {job.seed}, frame {number}: {row['rejected']:.0f} "
               f"of {row['pairs']:.0f} pairs rejected.")
    return Figure(picture(file, caption), caption)
