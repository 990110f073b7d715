#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The second paper's experiment: runs, tables, figures, report.html.
#     apps/experiments/soto2013/run.sh [--quick] [--worlds DIR] [--output DIR] [--jobs N]
# Builds the programs, unless MONOSLAM_PROGRAMS names the folder that they are in.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
root=$(realpath "$here/../../..")
if [[ -z ${MONOSLAM_PROGRAMS-} ]]; then
    export MONOSLAM_PROGRAMS=$root/build/release/bin
    cd "$root"
    cmake --preset release >/dev/null
    cmake --build --preset release --target images2rawlog mono-slam mono-slam-batch mono-slam-eval >/dev/null
    cd "$OLDPWD"
fi
export MONOSLAM_REPORT_VENV=${MONOSLAM_REPORT_VENV:-$root/build/venv-report}
"$root/apps/mono-slam-report/install.sh" </dev/null
# What evo and matplotlib keep in the home folder goes to the venv instead.
mkdir -p "$MONOSLAM_REPORT_VENV/home"
HOME=$MONOSLAM_REPORT_VENV/home MPLCONFIGDIR=$MONOSLAM_REPORT_VENV/home PYTHONDONTWRITEBYTECODE=1 \
    PYTHONPATH=$root/apps/mono-slam-report exec "$MONOSLAM_REPORT_VENV/bin/python" "$here/run.py" "$@"
