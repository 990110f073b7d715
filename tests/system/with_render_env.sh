#!/usr/bin/env bash
# Runs a Python test of this folder with the packages and modules of datasets/scenes.
#     tests/system/with_render_env.sh NAME.py      77: these packages cannot be installed
set -euo pipefail
here=$(realpath "$(dirname "$0")")
datasets=$here/../../datasets
env=${MONOSLAM_RENDER_ENV:-${XDG_CACHE_HOME:-$HOME/.cache}/monoslam-render}
"$datasets/render.sh" --sensor --help >/dev/null || # makes the environment
    [[ -e $env/ready ]] || { echo "skipped: $env cannot be made (PyPI out of reach?)"; exit 77; }
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$datasets/scenes exec "$env/bin/python" "$here/$1"
