#!/usr/bin/env bash
# A batch by Snakemake, which install.sh installs when it is not there yet.
#     apps/mono-slam-batch/workflow/run.sh BATCH.ini OUTPUT [SNAKEMAKE_OPTION ...]
# Without options: one job a core on this machine. What is finished is not run again.
set -euo pipefail
[[ $# -ge 2 ]] || { echo "usage: $0 BATCH.ini OUTPUT [SNAKEMAKE_OPTION ...]" >&2; exit 2; }
batch=$(realpath "$1")
mkdir -p "$2"
output=$(realpath "$2")
shift 2
[[ $# -gt 0 ]] || set -- --cores all
here=$(realpath "$(dirname "$0")")
root=$(realpath "$here/../../..")
programs=${MONOSLAM_PROGRAMS:-$root/build/release/bin}
[[ -x $programs/mono-slam-batch ]] ||
    { echo "$0: $programs/mono-slam-batch: not built; MONOSLAM_PROGRAMS names its folder" >&2; exit 1; }

"$here/install.sh" </dev/null
collect() { "$programs/mono-slam-batch" "$batch" --output "$output" --collect; }
collect >/dev/null  # refuses a bad batch, and a folder of somebody else
# A failed job leaves the others running; results.csv is written of what there is.
status=0
"$root/build/venv-snakemake/bin/snakemake" --snakefile "$here/Snakefile" --directory "$output" --keep-going \
    --rerun-incomplete --rerun-triggers mtime "$@" \
    --config "batch=$batch" "output=$output" "programs=$programs" || status=$?
collect || status=$?
exit "$status"
