#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What requirements.txt names, to build/venv-report (another folder by MONOSLAM_REPORT_VENV); nothing
# when it is there. Two calls at the same time do not disturb each other.
set -euo pipefail
here=$(dirname "$(realpath "$0")")
wanted=$here/requirements.txt
venv=${MONOSLAM_REPORT_VENV:-$(realpath -m "$here/../../build/venv-report")}
mkdir -p "$(dirname "$venv")"
exec 9>"$venv.lock"
flock 9
cmp -s "$wanted" "$venv/installed.txt" && exit 0
echo "Installing the report's Python packages to $venv" >&2
python3 -m venv --clear "$venv"
"$venv/bin/pip" install --quiet --disable-pip-version-check --retries 1 -r "$wanted"
cp "$wanted" "$venv/installed.txt"
