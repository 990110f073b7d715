#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The experiments of Guerra et al. 2013, from rendered images to report.html; goes on where it was.
#     apps/experiments/guerra2013/run.sh [--quick] [--worlds DIR] [--output DIR] [--jobs N]
#         [--document FILE] [--datasets DIR]
# Without --worlds (or MONOSLAM_WORLDS) the sequences are rendered to build/worlds, those of --quick to
# build/worlds-quick, where they are missing. Output: build/guerra2013, build/guerra2013-quick. Real
# sequences: MONOSLAM_DATASETS or ../shared/datasets, where they are there.
set -euo pipefail
root=$(realpath "$(dirname "$0")/../../..")
quick= worlds=${MONOSLAM_WORLDS-} output= rest=()
while (($#)); do
    case $1 in
        --quick) quick=-quick rest+=("$1") ;;
        --worlds | --output)
            [[ $# -ge 2 ]] || { echo "run.sh: $1: a folder is missing" >&2; exit 2; }
            if [[ $1 == --worlds ]]; then worlds=$2; else output=$2; fi
            shift ;;
        *) rest+=("$1") ;;
    esac
    shift
done
: "${output:=$root/build/guerra2013$quick}"

python=${MONOSLAM_REPORT_VENV:-$root/build/venv-report}/bin/python
"$root/apps/mono-slam-report/install.sh"
if [[ -z $worlds ]]; then
    worlds=$root/build/worlds$quick
    world=lab
    [[ -n $quick ]] && world=quick
    "$root/datasets/render.sh" "$worlds" --world "$world" >&2
fi
(
    cd "$root"
    [[ -f build/release/build.ninja ]] || cmake --preset release >&2
    cmake --build --preset release --target mono-slam mono-slam-batch mono-slam-eval images2rawlog \
        association-bench >&2
)
export PYTHONPATH=$root/apps/mono-slam-report PYTHONDONTWRITEBYTECODE=1
"$python" "$root/apps/experiments/guerra2013/experiment.py" --worlds "$worlds" --output "$output" "${rest[@]}"
"$root/apps/mono-slam-report/mono-slam-report" "$output"
