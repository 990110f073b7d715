# SPDX-License-Identifier: BSD-3-Clause
"""mono-slam-report RESULTS: one self-contained page of a batch of mono-slam-batch."""
import argparse
import os
import sys
from pathlib import Path

from .build import Options, build
from .errors import ReportError


def positive(text: str) -> int:
    number = int(text)
    if number < 1:
        raise ValueError
    return number


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="mono-slam-report", description=__doc__.split(": ", 1)[1])
    parser.add_argument("results", type=Path, metavar="RESULTS",
                        help="output folder of mono-slam-batch, or of an experiment; report.html and figures go there")
    parser.add_argument("--reference", metavar="STRATEGY",
                        help="with which all others are compared; default: the first of the batch")
    parser.add_argument("--cells", type=positive, default=6, metavar="N",
                        help="sequences and variants that get figures (default 6); tables have all")
    parser.add_argument("--paths", type=positive, default=3, metavar="N",
                        help="runs of a strategy whose paths are drawn (default 3)")
    parser.add_argument("--pictures", type=Path, metavar="BATCH.ini",
                        help="run mono-slam once more for pictures of the frames with most rejected pairs")
    parser.add_argument("--programs", type=Path, default=Path(os.environ.get("MONOSLAM_PROGRAMS", ".")), metavar="DIR",
                        help="folder of mono-slam-batch, for --pictures")
    parser.add_argument("--force", action="store_true", help="replace a report.html that is not ours")
    return parser.parse_args()


def main() -> int:
    args = arguments()
    options = Options(args.reference, args.cells, args.paths, args.pictures, args.programs, args.force)
    try:
        report, notes = build(args.results, options)
    except (ReportError, OSError) as error:
        print(f"mono-slam-report: {error}", file=sys.stderr)
        return 1
    for note in notes[:5]:
        print(f"not read: {note}", file=sys.stderr)
    if len(notes) > 5:
        print(f"not read: {len(notes) - 5} more, see the report", file=sys.stderr)
    print(report)
    return 0


if __name__ == "__main__":
    sys.exit(main())
