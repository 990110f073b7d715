#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Unit tests of mono-slam-report.      77: its venv is not there; tests/run.sh makes it
set -euo pipefail
here=$(dirname "$(realpath "$0")")
root=$(realpath "$here/../../..")
venv=${MONOSLAM_REPORT_VENV:-$root/build/venv-report}
cmp -s "$root/apps/mono-slam-report/requirements.txt" "$venv/installed.txt" ||
    { echo "skipped: no $venv, or of other versions; apps/mono-slam-report/install.sh makes it"; exit 77; }
mkdir -p "$venv/home"
HOME=$venv/home MPLCONFIGDIR=$venv/home PYTHONPATH=$root/apps/mono-slam-report PYTHONDONTWRITEBYTECODE=1 \
    exec "$venv/bin/python" -m unittest discover -s "$here" "$@"
