# SPDX-License-Identifier: BSD-3-Clause
"""The sections of the report: which tables and figures stand where."""
import batches
import causes
import cost
import initialization
import node_figures
import node_tables
import node_verdicts
import pair_figures
import paper
import path_verdicts
import times
import track_figures
import trajectories
import verdicts
from document import Section
from plan import CONFIG, DEFAULTS, PAIRS


def tables_of_searches(problems, runs, frames):
    """Tables 1 to 5, two of them in two parts."""
    return {table.name: table for table in (
        node_tables.lengths(problems, runs), node_tables.nodes(problems, runs),
        node_tables.work(problems), node_tables.sizes(problems),
        node_tables.rejections(problems, runs), times.table5(frames), times.parts(frames))}


def of_searches(output, problems, runs, frames):
    node_figures.nodes(problems, output)
    node_figures.times(frames, output)
    node_figures.sizes(problems, output)
    node_figures.places(problems, runs, output)
    tables = tables_of_searches(problems, runs, frames)
    return [
        Section("Lengths and searches", "", [tables["table1"]]),
        Section("Nodes", "All methods on the same recorded problems. Nodes of HOHCT and JCBB: calls of "
                "the recursion; of MRPT's: as it counts them, also where nothing had to be rejected. MRPT's "
                "JCBB has no joint test; with one candidate each it visits every pair once. A search that "
                "reached its cap has at least the nodes that are counted.",
                [tables["table2"], tables["table2_work"]], "nodes"),
        Section("Pairs and rejected pairs", "",
                [tables["table3"], tables["table4"], node_tables.pairs(problems)], "sizes"),
        Section("Time of a frame", "Whole runs, each method with its own map; images are decoded already. "
                "The first frame of a run, which finds the target and the first corners, stands apart. A search "
                "that is not finished ended at its cap.", [tables["table5"], tables["table5_parts"]],
                "times"),
        Section("Where searches happen", "", [node_tables.along_track(problems),
                                              node_tables.by_sequence(problems, runs)], "places"),
        Section("Cost against n and r", "Fits are least squares of the logarithm; a dash stands where there "
                f"are fewer than {cost.LEAST} searches.",
                [cost.equations(problems), cost.growth(problems), cost.exponents(problems)])]


def of_real(problems, runs, frames):
    tables = tables_of_searches(problems, runs, frames)
    for name, table in tables.items():
        table.name = f"{name}_real"
    return Section("Real sequences", "The same methods on the shared real sequences, 640x480 or 752x480 at "
                   "30 frames a second. Only the chessboard gives a scale; in the others the unit is the "
                   "median depth of the first landmarks.",
                   [*tables.values(), node_tables.by_sequence(problems, runs, "by_sequence_real")])


def of_paths(output, rendered, rows, measured):
    sections = []
    for name, config, figure in (("validation", CONFIG, "figure5"),
                                 ("defaults", DEFAULTS, "figure5_defaults")):
        if track_figures.figure5(output, rendered, rows[name], PAIRS[config.name], figure):
            sections.append(Section(
                f"Figure 5: maps and paths, config/{config.name}", "Top views; of every cell the run of "
                "median error. Runs are metric by the target in the first frame; only the first pose is "
                "aligned.", [], figure))
    track_figures.gaps(measured["validation"], PAIRS[CONFIG.name], output)
    tables = [table(*what, config.name) for name, config in (("validation", CONFIG),
                                                             ("defaults", DEFAULTS))
              for table, what in ((trajectories.compared, (measured[name],)),
                                  (trajectories.tracking, (rows[name],)))]
    sections.append(Section(
        "Straight, turn, closing gap", "Estimates with HOHCT and without validation. Length: between "
        "the ends of the marked straight. Opening: change of heading over the marked turn. Gap: from the "
        "end as estimated to the true end, both seen from the first pose, by which a run is aligned. Pairs "
        "of the same seed, two-sided sign test. A run that has no pose where one is needed counts as worse "
        "than any other.", tables, "gaps"))
    return sections


def of_pairs(output, rendered, judged):
    captions = pair_figures.both(judged, rendered, output)
    titles = {"figure6": "Figure 6: rejected because of a repeated design",
              "figure7": "Figure 7: rejected on a composite landmark"}
    sections = [Section("What is rejected", " ".join(causes.RULES.split()),
                        [causes.table(judged)])]
    for name, title in titles.items():
        sections.append(Section(title, captions[name], [], name) if name in captions else
                        Section(title, "No rejected pair of this kind in these sequences."))
    return sections


def of_initialization(output, rows):
    frames = batches.all_frames(output, rows)
    track_figures.initialization(rows, output)
    return Section("Delayed and undelayed initialisation", "HOHCT as a branch and bound, since 50 pairs are "
                   "too many to enumerate; the answer is the same. Errors: ATE after SE3 alignment.",
                   [initialization.compared(rows, frames), initialization.tests(rows)],
                   "initialization")


def all_of(output, rendered, rows, evidence, real):
    """rows: of each batch; real: evidence of the real sequences. Writes the figures."""
    judged = causes.of_rejected(evidence["problems"], rendered)
    found = [decide(**evidence) for decide in node_verdicts.ALL]
    turning = "validation" in rows
    if turning:
        measured = {name: trajectories.measure(output, rendered, rows[name])
                    for name in ("validation", "defaults")}
        found += [decide(measured=measured["validation"], **rows)
                  for decide in path_verdicts.OF_VALIDATION]
    found += [path_verdicts.fewer_features(**rows), path_verdicts.precise(judged)]
    found = [verdict for verdict in found if verdict]
    verdicts.table(found).write(output)
    sections = [Section("Which of the paper's claims hold", verdicts.listed(found)),
                Section("What does not add up in the paper", paper.SLIPS),
                *of_searches(output, **evidence)]
    sections += of_paths(output, rendered, rows, measured) if turning else []
    sections += of_pairs(output, rendered, judged)
    sections.append(of_initialization(output, rows["initialization"]))
    return sections + ([of_real(**real)] if real else [])
