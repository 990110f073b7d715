#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
set -eu
here=$(CDPATH= cd -- "$(dirname -- "$0")" && pwd)
if [ $# -eq 0 ] || [ "$1" = "--help" ] || [ "$1" = "-h" ]; then
    cat <<'USAGE'
usage: render.sh OUTPUT --world office|lab|quick [options]   renders a world of sequences; --help after --world tells more
       render.sh OUTPUT [options]                renders desk/ and desk_moving/ (images and the depth of all frames)
       render.sh --sensor INPUT OUTPUT [options] a rendered sequence as a cheap camera records it; see --sensor --help
       render.sh --check FOLDER...               reprojects the frames of rendered sequences into each other
       render.sh --check                         the same with frames of desk rendered for it
       render.sh --describe                      tables of the worlds and of what a picture costs

Needs povray 3.7 and python3 with venv (apps/install-packages.sh worlds). The Python packages of
scenes/requirements.txt go into a virtual environment, ${MONOSLAM_RENDER_ENV:-~/.cache/monoslam-render}, made when
missing. Frames already in OUTPUT are kept: run it again after an interruption.

options of desk (about 4 s an image, 1 s a depth):
  --sequence desk|desk_moving   only this sequence (repeatable)
  --what gray depth             only images or only depth
  --depth-every N               depth of every Nth frame only
  --jpeg-step N                 JPEG quantiser step (16; smaller is larger and better)
USAGE
    [ $# -gt 0 ]
    exit
fi
tool=render.py
case "$1 ${2-}" in
"--sensor "*) tool=sensor.py; shift ;;
"--check "[!-]*) tool=check_sequence.py; shift ;;
"--check "*) tool=check_geometry.py; shift ;;
"--describe "*) tool=describe_worlds.py; shift ;;
*) case " $* " in *" --world "* | *" --world="*) tool=render_worlds.py ;; esac ;;
esac
case $tool in
render*.py | check_geometry.py | describe_worlds.py)
    command -v povray >/dev/null || { echo "render.sh: povray is not installed: apps/install-packages.sh worlds" >&2; exit 1; } ;;
esac
env=${MONOSLAM_RENDER_ENV:-${XDG_CACHE_HOME:-$HOME/.cache}/monoslam-render}
if [ ! -e "$env/ready" ]; then
    python3 -m venv "$env"
    "$env/bin/pip" install --quiet --requirement "$here/scenes/requirements.txt"
    touch "$env/ready"
fi
export PYTHONDONTWRITEBYTECODE=1
exec "$env/bin/python" "$here/scenes/$tool" "$@"
