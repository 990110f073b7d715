#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A batch of two runs becomes one self-contained page; what is wrong is one line.
#     tests/system/report.sh PROGRAMS      77: the report's venv is not there; tests/run.sh makes it
set -euo pipefail
programs=$1
root=$(realpath "$(dirname "$0")/../..")
venv=${MONOSLAM_REPORT_VENV:-$root/build/venv-report}
cmp -s "$root/apps/mono-slam-report/requirements.txt" "$venv/installed.txt" ||
    { echo "skipped: no $venv, or of other versions; apps/mono-slam-report/install.sh makes it"; exit 77; }
export MONOSLAM_PROGRAMS=$programs
report=$programs/mono-slam-report
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$1" >&2; exit 1; }

cat >"$work/batch.ini" <<END
[batch]
output = two words
strategies = hohct mhda
[sequence.desk]
rawlog = $root/datasets/desk/desk.rawlog
truth = {folder}/groundtruth.txt
config = $root/config/desk.ini
rawlog.frame_count = 40
END
"$programs/mono-slam-batch" "$work/batch.ini"
results="$work/two words"

mkdir "$results/tables"
printf 'method,nodes\nprinted,219\n' >"$results/tables/nodes.csv"
cat >"$results/report.json" <<'END'
{"title": "An experiment", "intro": "With *words* before.",
 "sections": [{"title": "Nodes a search", "text": "Beside the printed ones.", "table": "tables/nodes.csv"}]}
END
"$report" "$results" --pictures "$work/batch.ini"
"$venv/bin/python" "$root/tests/system/check_report.py" "$results" "Nodes a search" hohct mhda

# What is kept is used again, and nothing depends on the time.
cp "$results/report.html" "$work/first.html"
"$report" "$results"
cmp "$work/first.html" "$results/report.html" || fail "a second report of the same runs differs"

# refused WORDS ARGUMENT...: one line that has WORDS, and a status other than 0.
refused()
{
    local words=$1 said
    shift
    if said=$("$report" "$@" 2>&1); then fail "not refused: $*"; fi
    [[ $said == *"$words"* && $(wc -l <<<"$said") == 1 ]] || fail "'$words' expected, not: $said"
}
refused "no such folder" "$work/nowhere"
refused "no strategy 'jcbb'" "$results" --reference jcbb
refused "results.csv" "$root/config"
mkdir "$work/foreign"
cp "$results/results.csv" "$work/foreign"
echo "precious" >"$work/foreign/report.html"
refused "not of mono-slam-report" "$work/foreign"
[[ $(cat "$work/foreign/report.html") == precious ]] || fail "a foreign file was replaced"

# Runs whose files are gone are said, and the page still has every section.
rm -r "$results"/jobs/desk/mhda
"$report" "$results" 2>"$work/said"
grep -q "mhda.*frames.csv: no such file" "$work/said" || fail "a missing file was not told"
"$venv/bin/python" "$root/tests/system/check_report.py" "$results" "Nodes a search" hohct
