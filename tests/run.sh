#!/usr/bin/env bash
# Installs what is missing, builds, runs the tests; the last line counts them. Only evo, Snakemake and
# the report's packages, each for tests of their own, come from PyPI.
#     tests/run.sh [--full]      --full adds the slow suites and the benchmarks
set -euo pipefail
cd "$(dirname "$0")/.."

test_preset=release
case ${1-} in
    '') ;;
    --full) test_preset=full ;;
    *) echo "usage: tests/run.sh [--full]" >&2; exit 2 ;;
esac

apps/install-packages.sh tests worlds
apps/mono-slam-report/install.sh </dev/null ||
    echo "the report's packages cannot be installed (PyPI out of reach?): its tests and compare_with_evo will be skipped" >&2
apps/mono-slam-batch/workflow/install.sh </dev/null ||
    echo "Snakemake cannot be installed (PyPI out of reach?): batch_workflow will be skipped" >&2
cmake --preset release
cmake --build --preset release

results=$PWD/build/release/tests.xml
rm -f "$results"
status=0
ctest --preset "$test_preset" --output-junit "$results" || status=$?

if [[ $test_preset == full ]]; then
    for bench in build/release/bin/bench_*; do
        [[ -x $bench ]] || continue
        echo "== ${bench##*/}"
        "$bench" || { status=1; echo "${bench##*/} failed" >&2; }
    done
fi

count() { grep -m 1 -o "$1=\"[0-9]*\"" "$results" | tr -dc '0-9'; }
[[ -s $results ]] || { echo "no test results in $results" >&2; exit 1; }
failed=$(count failures)
skipped=$(($(count skipped) + $(count disabled)))
echo "$(($(count tests) - failed - skipped)) passed, $failed failed, $skipped skipped"
exit "$status"
