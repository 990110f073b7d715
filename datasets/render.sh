#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
set -eu
here=$(CDPATH= cd -- "$(dirname -- "$0")" && pwd)
case " $* " in
*" --world "*) tool=render_worlds.py ;;
*) tool=render.py ;;
esac
if [ $# -eq 0 ] || [ "$1" = "--help" ] || [ "$1" = "-h" ]; then
    cat <<'USAGE'
usage: render.sh OUTPUT [options]      renders desk/ and desk_moving/ (images and the depth of all frames)
       render.sh --check               reprojects frames into each other and tells the grey-level difference

Needs povray 3.7 and python3 with venv (Debian: apt install povray python3-venv). The Python packages of
scenes/requirements.txt go into a virtual environment, ${MONOSLAM_RENDER_ENV:-~/.cache/monoslam-render}, made when
missing. Frames already in OUTPUT are kept: run it again after an interruption. About 4 s an image, 1 s a depth.

options:
  --sequence desk|desk_moving   only this sequence (repeatable)
  --what gray depth             only images or only depth
  --depth-every N               depth of every Nth frame only
  --jpeg-step N                 JPEG quantiser step (16; smaller is larger and better)
USAGE
    [ $# -gt 0 ]
    exit
fi
command -v povray >/dev/null || { echo "render.sh: povray is not installed" >&2; exit 1; }
env=${MONOSLAM_RENDER_ENV:-${XDG_CACHE_HOME:-$HOME/.cache}/monoslam-render}
if [ ! -e "$env/ready" ]; then
    python3 -m venv "$env"
    "$env/bin/pip" install --quiet --requirement "$here/scenes/requirements.txt"
    touch "$env/ready"
fi
export PYTHONDONTWRITEBYTECODE=1
if [ "$1" = "--check" ]; then
    shift
    exec "$env/bin/python" "$here/scenes/check_geometry.py" "$@"
fi
exec "$env/bin/python" "$here/scenes/$tool" "$@"
