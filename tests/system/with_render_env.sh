#!/usr/bin/env bash
# Runs a Python test of this folder with the packages and modules of datasets/scenes.
#     tests/system/with_render_env.sh NAME.py
set -euo pipefail
here=$(realpath "$(dirname "$0")")
datasets=$here/../../datasets
"$datasets/render.sh" --sensor --help >/dev/null # makes the environment
env=${MONOSLAM_RENDER_ENV:-${XDG_CACHE_HOME:-$HOME/.cache}/monoslam-render}
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$datasets/scenes exec "$env/bin/python" "$here/$1"
