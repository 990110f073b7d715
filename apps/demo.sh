#!/usr/bin/env bash
# From a fresh clone to a path and a map: installs what is missing, builds, runs the shipped sequence.
#     apps/demo.sh [OUTPUT]      OUTPUT is a folder, build/demo by default; our own files in it are replaced
set -euo pipefail
cd "$(dirname "$0")/.."
output=${1:-build/demo}

apps/install-packages.sh
cmake --preset release -D MONOSLAM_BUILD_TESTS=OFF
cmake --build --preset release

build/release/bin/mono-slam config/desk.ini --output "$output" --pictures --force
echo
build/release/bin/mono-slam-eval --groundtruth datasets/desk/groundtruth.txt "$output"
echo
echo "pictures:"
find "$output" \( -name '*top*.png' -o -name '*top*.jpg' \) | sort
find "$output" \( -name '*.png' -o -name '*.jpg' \) ! -name '*top*' | sort | sed -n '1p;$p'
