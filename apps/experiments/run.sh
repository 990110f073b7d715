#!/usr/bin/env bash
# One experiment, built and run; the table goes to the terminal and to build/experiments/NAME.md.
#     apps/experiments/run.sh front-end|validation DEPTH_FOLDER_OF_DESK
#     apps/experiments/run.sh subset-search SEEDS
#     apps/experiments/run.sh recovery
set -euo pipefail
[[ $# -eq 2 && $1 =~ ^(front-end|validation|subset-search)$ || $# -eq 1 && $1 == recovery ]] ||
    { echo "usage: $0 front-end|validation DEPTH_FOLDER_OF_DESK | subset-search SEEDS | recovery" >&2; exit 2; }
[[ $1 =~ ^(subset-search|recovery)$ ]] || depth=$(realpath "$2")
cd "$(dirname "$0")/../.."
program=build/release/bin/experiment-$1
output=build/experiments
mkdir -p "$output"
cmake --preset release -D MONOSLAM_BUILD_EXPERIMENTS=ON >&2
cmake --build --preset release --target "experiment-$1" >&2

if [[ $1 == recovery ]]; then
    "$program" "$(nproc)" | tee "$output/$1.md"
elif [[ $1 == front-end ]]; then
    "$program" config/desk.ini datasets/desk "$depth" | tee "$output/$1.md"
elif [[ $1 == subset-search ]]; then
    {
        printf '\n### Times\n\n'
        "$program" times "$2"
        printf '\n### Second tests\n\n'
        "$program" second-tests "$2"
    } | tee "$output/$1.md"
else
    {
        printf '\n### desk\n\n'
        "$program" config/desk.ini datasets/desk "$depth" "$output/desk" 60 120 180
        printf '\n### desk_moving\n\n'
        "$program" config/desk.ini datasets/desk_moving motion "$output/moving" 40 60 80 100
    } | tee "$output/$1.md"
fi
