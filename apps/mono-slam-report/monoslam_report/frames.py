# SPDX-License-Identifier: BSD-3-Clause
"""Example frames with the rejected pairs marked: pictures of mono-slam --pictures."""
import re
import shutil
from pathlib import Path

from .context import Context
from .figures import Figure, picture
from .job import Job
from .page import Section
from .rerun import Rerun

MOST_PICTURES = 12
PER_RUN = 2
NUMBER = re.compile(r"frame_(\d+)\.jpg$")


def section(context: Context, rerun: Rerun | None) -> Section:
    out = Section("Example frames")
    out.say("Pictures as `mono-slam --pictures` draws them, of the frames in which most pairs were rejected. Ellipses: "
            "where a landmark is searched (99 %). Green: matched. Red: found, but rejected. Yellow: not found. Blue "
            "squares: new landmarks.")
    chosen = [(job, number) for job in candidates(context, rerun) for number in worst_frames(job)]
    for job, number in chosen[:MOST_PICTURES]:
        found = picture_of(context, job, number, rerun)
        if found:
            out.blocks.append(found)
    if len(out.blocks) == 1:
        out.say("*No run has pictures, or nothing was rejected. `mono-slam-report RESULTS --pictures BATCH.ini` runs "
                "mono-slam once more to draw some.*")
    elif len(chosen) > MOST_PICTURES:
        out.say(f"The first {MOST_PICTURES} of {len(chosen)}.")
    return out


def candidates(context: Context, rerun: Rerun | None) -> list[Job]:
    """The first seed of every strategy that ended; with pictures already, unless they can be made."""
    firsts = [jobs[0] for cell in context.drawn_cells() for name in context.results.strategies_of(cell)
              if (jobs := context.results.done(cell, name))]
    return [job for job in firsts if rerun or (job.folder / "pictures").is_dir()]


def worst_frames(job: Job) -> list[int]:
    if job.frames is None or "index" not in job.frames:
        return []
    table = job.frames[job.frames["rejected"] > 0]
    there = numbers_in(job.folder / "pictures")
    if there:
        table = table[table["index"].isin(there)]
    return [int(i) for i in table.nlargest(PER_RUN, "rejected", keep="first")["index"]]


def numbers_in(folder: Path) -> set[int]:
    return {int(NUMBER.search(file.name)[1]) for file in folder.glob("frame_*.jpg") if NUMBER.search(file.name)}


def picture_of(context: Context, job: Job, number: int, rerun: Rerun | None) -> Figure | None:
    """Kept in RESULTS/figures, so that the report need not run mono-slam twice for it."""
    kept = context.figures.path(f"frame_{number:06d}_{job.sequence}_{job.strategy}_{job.variant}_seed{job.seed}.jpg")
    drawn = job.folder / "pictures" / f"frame_{number:06d}.jpg"
    if drawn.exists():
        shutil.copyfile(drawn, kept)
    elif rerun:
        rerun.draw(job, number, kept)
    else:
        return None
    row = job.frames[job.frames["index"] == number].iloc[0]
    caption = (f"{job.sequence}, {job.strategy}, {job.variant}, seed {job.seed}, frame {number}: {row['rejected']:.0f} "
               f"of {row['pairs']:.0f} pairs rejected.")
    return Figure(picture(kept, caption), caption)
