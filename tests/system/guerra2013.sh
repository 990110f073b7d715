#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# apps/experiments/guerra2013 --quick from its images, which are rendered where they are missing: all
# tables and figures are there and the totals add up. Exit 77: skipped.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
root=$here/../..
skip() { echo "skipped: $1"; exit 77; }
export MONOSLAM_WORLDS=$root/build/worlds-quick
"$root/apps/mono-slam-report/install.sh" </dev/null || skip "the report's Python packages cannot be installed"
[[ -e $MONOSLAM_WORLDS/lab_turn_1/rgb.txt ]] || command -v povray >/dev/null || skip "povray is not installed"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
experiment=("$root/apps/experiments/guerra2013/run.sh" --no-build --quick --output)
"${experiment[@]}" "$folder/out" --document "$folder/doc.md"
cmp "$folder/out/guerra2013.md" "$folder/doc.md"
python3 "$here/check_guerra2013.py" "$folder/out"

# Once more: nothing is run again, so all but nothing changes.
cp -r "$folder/out/tables" "$folder/before"
"${experiment[@]}" "$folder/out"
diff -r "$folder/before" "$folder/out/tables"

# refused WORDS ARGUMENT...: the last line has WORDS, and nothing of the user's is replaced.
refused()
{
    local words=$1 said
    shift
    if said=$("${experiment[@]}" "$@" 2>&1); then echo "not refused: $*" >&2; exit 1; fi
    [[ $(tail -n 1 <<<"$said") == *"$words"* ]] || { echo "'$words' expected, not: $said" >&2; exit 1; }
}
mkdir "$folder/mine" "$folder/empty"
echo precious >"$folder/mine/results.csv"
refused "not of this experiment" "$folder/mine"
[[ $(cat "$folder/mine/results.csv") == precious ]]
refused "no such folder" "$folder/new" --worlds "$folder/nowhere"
refused "none of its sequences is complete" "$folder/new" --worlds "$folder/empty"
refused "at least 1" "$folder/new" --jobs 0
