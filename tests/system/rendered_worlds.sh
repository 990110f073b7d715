#!/usr/bin/env bash
# The quick world is rendered, goes on after a kill, and its pictures, depth and poses belong together.
#     tests/system/rendered_worlds.sh PROGRAMS      77: POV-Ray is not installed
set -euo pipefail
root=$(realpath "$(dirname "$0")/../..")
render=$root/datasets/render.sh
command -v povray >/dev/null || { echo "skipped: povray is not installed"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$1" >&2; exit 1; }
clean=(--world quick --noise 0 --jpeg-step 1 --jobs 4)

# Interrupted, then finished; what was there stays as it was.
"$render" "$work/worlds" "${clean[@]}" &
for _ in $(seq 600); do
    [[ -e $work/worlds/lab_turn_1/gray/0005.jpg ]] && break
    sleep 0.1
done
kill -TERM $!
wait $! && fail "a killed render says that it is done"
[[ -e $work/worlds/lab_turn_1/gray/0005.jpg ]] || fail "nothing was rendered before the kill"
before=$(sha256sum "$work"/worlds/*/gray/*.jpg; stat -c '%n %Y' "$work"/worlds/*/gray/*.jpg)
"$render" "$work/worlds" "${clean[@]}"
while read -r line; do
    grep -qxF "$line" <(sha256sum "$work"/worlds/*/gray/*.jpg; stat -c '%n %Y' "$work"/worlds/*/gray/*.jpg) || fail "rendered twice: $line"
done <<<"$before"

for sequence in "lab_uturn_1 90 9" "lab_turn_1 90 9" "office 40 40" "office_moved 40 40"; do
    read -r name images depths <<<"$sequence"
    [[ $(find "$work/worlds/$name/gray" -name '*.jpg' | wc -l) == "$images" ]] || fail "$name: not $images pictures"
    [[ $(find "$work/worlds/$name/depth" -name '*.png' | wc -l) == "$depths" ]] || fail "$name: not $depths depth pictures"
done
"$render" --check "$work"/worlds/lab_uturn_1 "$work"/worlds/lab_turn_1 "$work"/worlds/office || fail "the geometry is wrong"

# A pose that is wrong by two centimetres must be found.
cp -r "$work/worlds/lab_turn_1" "$work/wrong"
awk '!/^#/ { $2 += 0.02 * (NR % 2) } { print }' "$work/worlds/lab_turn_1/groundtruth.txt" >"$work/wrong/groundtruth.txt"
"$render" --check "$work/wrong" && fail "the check does not see wrong poses"

# Other settings in the same folder are refused.
"$render" "$work/worlds" --world quick --noise 3 2>"$work/refused" && fail "two renders were mixed"
grep -q "other settings" "$work/refused" || fail "no reason given: $(cat "$work/refused")"

# Our programs read them and find the target in the first frame.
name=lab_turn_1
"$1/images2rawlog" --format tum --input "$work/worlds/$name" --camera "$work/worlds/$name/camera.yaml" \
    --groundtruth "$work/worlds/$name/groundtruth.txt" --output "$work/$name.rawlog"
"$1/mono-slam" "$root/config/desk.ini" "$work/$name.rawlog" --output "$work/run" --set rawlog.frame_count=5 | tee "$work/said"
grep -q "^5 frames: 5 tracking" "$work/said" || fail "the target is not found in the first frame"
