#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The second paper's experiment: runs, tables, figures, report.html.
#     apps/experiments/soto2013/run.sh [--quick] [--worlds DIR] [--output DIR] [--jobs N]
set -euo pipefail
here=$(realpath "$(dirname "$0")")
cwd=$PWD
cd "$here/../../.."
root=$PWD
report=$root/apps/mono-slam-report
[[ " $* " == *" --no-build "* ]] || {
    cmake --preset release >/dev/null
    cmake --build --preset release --target images2rawlog mono-slam mono-slam-batch mono-slam-eval >&2
}
"$report/install.sh"
venv=${MONOSLAM_REPORT_VENV:-$root/build/venv-report}
cd "$cwd"
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$report exec "$venv/bin/python" "$here/run.py" "$@"
