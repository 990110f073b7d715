#!/usr/bin/env bash
# Snakemake, which Debian 12 has only in an older version, to build/venv-snakemake; nothing when it is there.
set -euo pipefail
wanted=$(realpath "$(dirname "$0")")/requirements.txt
cd "$(dirname "$0")/../../.."
venv=build/venv-snakemake
cmp -s "$wanted" "$venv/installed.txt" && exit 0
echo "Installing Snakemake to $venv" >&2
python3 -m venv --clear "$venv"
"$venv/bin/pip" install --quiet --disable-pip-version-check --retries 1 -r "$wanted"
cp "$wanted" "$venv/installed.txt"
