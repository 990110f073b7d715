# SPDX-License-Identifier: BSD-3-Clause
"""What a verdict on one of the paper's claims is, and how all of them are written."""
from dataclasses import dataclass

from cells import Table
from node_tables import of
from plan import PRINTED

HOLDS, FAILS, PART, OPEN = "holds", "does not hold", "in part", "not decided"
SURE = 0.05  # two-sided p below which a difference counts


@dataclass
class Verdict:
    claim: str
    verdict: str
    numbers: str
    why: str = ""


LEAST_SEARCHES = 30  # fewer decide nothing


def counted(decide):
    """A verdict is open where there are too few searches."""
    def careful(problems, **rest):
        verdict = decide(problems=problems, **rest)
        if len(of(problems, PRINTED)) < LEAST_SEARCHES:
            verdict.verdict = OPEN
        return verdict
    return careful


def listed(verdicts):
    """As Markdown, with a count of the verdicts before."""
    counts = ", ".join(f"{word}: {sum(v.verdict == word for v in verdicts)}"
                       for word in (HOLDS, PART, FAILS, OPEN))
    lines = [f"- **{v.claim}: {v.verdict}.** {v.numbers}. {v.why}".rstrip() for v in verdicts]
    return f"{counts}.\n\n" + "\n".join(lines)


def table(verdicts):
    return Table("claims", "The paper's claims", [
        {"claim": v.claim, "verdict": v.verdict, "numbers": v.numbers, "why": v.why}
        for v in verdicts])
