# SPDX-License-Identifier: BSD-3-Clause
"""The report's sections from the measured runs."""
import claims
import figures
import moved_object
import pictures
import planes
import real
import sweeps
from tables import spread, table2

NAMES = {"paper": "the paper's settings", "ours": "our defaults"}
PLANE_SEEDS = 5


def cells_of(runs, sequences):
    """{"paper settings, 200 frames": runs ...}, the paper's own first."""
    table = runs[runs.batch.isin(["table2", *(f"capped-{s.frames}" for s in sequences)])]
    return {(configuration, s.frames): table[(table.configuration == configuration) & (table.sequence == s.name)]
            for configuration in NAMES for s in sequences}


def write_table2(document, cells, caps):
    for (configuration, frames), runs in cells.items():
        title, name = f"Table 2: {NAMES[configuration]}, {frames} frames", f"table2_{configuration}_{frames}"
        document.add(title, "Medians over the seeds, the paper's single runs beside them. "
                     f"Stopped at a cap: {caps}.", table2(runs), name)
        document.add(f"{title}, over the seeds", "Median (middle half; worst). Better than MHDA: seeds of those that both "
                     "have, p of the two-sided sign test.", spread(runs), f"spread_{configuration}_{frames}")
    for frames in sorted({frames for _, frames in cells}):
        figure = f"table2_{frames}"
        figures.table2({c: runs for (c, f), runs in cells.items() if f == frames}, document.output / "figures", figure)
        document.add(f"Every run, {frames} frames", "Dots: runs; bars: their medians; crosses: the paper.", figure=figure)


def write_recovery(document, runs, cells, disturbed, folders):
    name, first, last = moved_object.moved_frames(folders[0])
    judged = {}
    for configuration in NAMES:
        own = runs[(runs.batch == "recovery") & (runs.configuration == configuration)]
        judged[configuration] = moved_object.judge(own, cells[configuration, disturbed.frames], document.output, folders)
        document.add(
            f"Recovery: {NAMES[configuration]}",
            f"The {name} is displaced from frame {first} to {last} of {disturbed.frames}; all else is as in the "
            f"undisturbed sequence. Before: median error of {moved_object.BEFORE} frames; end: of the last "
            f"{moved_object.AFTER}. Recovered: never lost, and at the end at most {moved_object.RECOVERED:g} times the "
            "median error of the method's undisturbed runs. Landmarks on the object: born before it moves and predicted "
            "within what its displacement covers and uncovers; accepted pairs of theirs are wrong from then on.",
            moved_object.table(judged[configuration]), f"recovery_{configuration}")
    return judged


def draw_recovery(document, runs, cells, disturbed, folders):
    name, first, last = moved_object.moved_frames(folders[0])
    own = runs[(runs.batch == "recovery") & (runs.configuration == "paper")]
    figures.recovery(own, cells["paper", disturbed.frames], document.output, (first, last), document.output / "figures")
    document.add("Recovery over time", f"Position error with the paper's settings, median and middle half of the seeds; "
                 f"red: the {name} moves.", figure="recovery")
    pictures.montage(disturbed, folders, first, last, document.output)
    document.add("The object in the image", "Seed 1, the paper's settings. Ellipses: 99 % of the prediction; green: matched, "
                 "red: rejected, yellow: not found, grey: not searched; blue squares: new landmarks.",
                 figure="recovery_frames")


def write_planes(document, cells, folder):
    runs = next(iter(cells.values()))
    pairs = planes.collect(runs[runs.variant == "plain"], document.output, folder, PLANE_SEEDS)
    figures.depth_planes(pairs, document.output / "figures")
    document.add("Rejections by depth", f"The paper's settings, first {PLANE_SEEDS} seeds: pairs by true depth, in thirds. "
                 "A method that believes the majority's plane rejects the others' landmarks.",
                 planes.table(pairs), "depth_planes", "depth_planes")
    return pairs


def write_sweeps(document, runs, size):
    figures.sweep(runs, list(size.sweeps), document.output / "figures")
    document.add("MHDA's parameters", f"The paper's settings, {size.sweep_seeds} seeds, one parameter changed; P also where "
                 "an object is displaced. Bars: middle half.", sweeps.table(runs, list(size.sweeps)), "sweeps", "sweeps")


def write_rates(document, runs, size):
    own = runs[runs.batch.isin(["rates", "rates-capped"])]
    by_configuration = {c: own[own.configuration == c] for c in NAMES}
    figures.rates(by_configuration, document.output / "figures")
    width, height = size.rate_size
    for configuration, rows in by_configuration.items():
        document.add(f"Frame rates at {width}x{height}: {NAMES[configuration]}",
                     f"The first {size.rate_frames} frames of the office, resized to {width}x{height} by the mean of the "
                     "covered pixels; focal lengths and principal point are scaled along each axis, so that pixels are a "
                     "little wider than high. 50 landmarks are to be measured a frame (`map.measured_target`, "
                     "`association.max_measured`). One run at a time; frame rate: inverse of the mean CPU time.",
                     sweeps.rates_table(rows), f"rates_{configuration}", "rates" if configuration == "paper" else None)
    return by_configuration["paper"]


def write_real(document, runs):
    own = runs[runs.batch == "real"]
    if own.empty:
        document.add("Real sequences", "Not run: no folder of real sequences is present (`MONOSLAM_DATASETS`).")
        return
    for configuration in NAMES:
        document.add(f"Real sequences: {NAMES[configuration]}", "Medians over the runs. Errors after the "
                     "alignment that is named (SE3: metric by its board; Sim3: free scale); without truth: gap at the "
                     "return, in percent of the length.", real.table(own[own.configuration == configuration]),
                     f"real_{configuration}")


def verdicts(cells, judged, pairs, points, rates):
    named = claims.Cells({f"{NAMES[c]}, {frames} frames": runs for (c, frames), runs in cells.items()})
    return [claims.best_position(named), claims.cheaper(named), claims.fastest(named), claims.worst_two(named),
            claims.depth_planes(named, pairs), claims.matching_against_jcbb(named), claims.order(named),
            claims.two_particles(points), claims.recovers(judged), claims.frame_rate(rates),
            claims.only_two_in_time(rates)]
