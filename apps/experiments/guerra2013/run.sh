#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The experiments of Guerra et al. 2013, from rendered images to report.html; goes on where it was.
#     apps/experiments/guerra2013/run.sh [--quick] [--worlds DIR] [--output DIR] [--jobs N]
#         [--document FILE] [--datasets DIR] [--no-build]
# With --worlds the sequences that are complete there are used and the others named. Without it they are
# rendered where they are missing: to MONOSLAM_WORLDS, or build/worlds and, with --quick, build/worlds-quick.
# Output: build/guerra2013, build/guerra2013-quick. Real sequences: --datasets, or MONOSLAM_DATASETS, or
# ../shared/datasets, where they are there.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
root=$(realpath "$here/../../..")
build=yes arguments=()
for argument in "$@"; do
    if [[ $argument == --no-build ]]; then build=; else arguments+=("$argument"); fi
done
if [[ -n $build ]]; then (
    cd "$root"
    cmake --preset release >/dev/null
    cmake --build --preset release --target mono-slam mono-slam-batch mono-slam-eval images2rawlog \
        association-bench >&2
); fi
venv=${MONOSLAM_REPORT_VENV:-$root/build/venv-report}
"$root/apps/mono-slam-report/install.sh"

# What evo and matplotlib keep in the home folder goes to the venv instead.
mkdir -p "$venv/home"
HOME=$venv/home MPLCONFIGDIR=$venv/home PYTHONPATH=$root/apps/mono-slam-report PYTHONDONTWRITEBYTECODE=1 \
    exec "$venv/bin/python" "$here/experiment.py" "${arguments[@]}"
