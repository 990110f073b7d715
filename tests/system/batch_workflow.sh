#!/usr/bin/env bash
# Snakemake and mono-slam-batch give the same results, and Snakemake redoes nothing.
#     tests/system/batch_workflow.sh PROGRAMS      77: Snakemake is not installed
set -euo pipefail
export MONOSLAM_PROGRAMS=$1
root=$(realpath "$(dirname "$0")/../..")
workflow=$root/apps/mono-slam-batch/workflow
[[ -e $root/build/venv-snakemake/installed.txt ]] || { echo "skipped: no build/venv-snakemake"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$1" >&2; exit 1; }

cat >"$work/batch.ini" <<END
[batch]
output = own
strategies = hohct spatial_nn
[sequence.desk]
rawlog = $root/datasets/desk/desk.rawlog
truth = {folder}/groundtruth.txt
config = $root/config/desk.ini
rawlog.frame_count = 20
END
"$1/mono-slam-batch" "$work/batch.ini"
"$workflow/run.sh" "$work/batch.ini" "$work/two words" --cores 2 --quiet
again=$("$workflow/run.sh" "$work/batch.ini" "$work/two words" --cores 2 2>&1)
[[ $again == *"Nothing to be done"* ]] || fail "Snakemake runs finished jobs again: $again"

# All but the columns of times.
figures()
{
    awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i !~ /^time_/) kept[i] = 1 }
             { for (i = 1; i <= NF; ++i) if (i in kept) printf "%s,", $i; print "" }' "$1"
}
diff <(figures "$work/own/results.csv") <(figures "$work/two words/results.csv") || fail "results differ"

mkdir "$work/other"
touch "$work/other/precious"
if "$workflow/run.sh" "$work/batch.ini" "$work/other"; then fail "a folder of somebody else was used"; fi
