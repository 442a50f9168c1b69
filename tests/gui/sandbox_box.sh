#!/usr/bin/env bash
# Drops a box in the sandbox's window with mouse and keyboard, lets it fall and saves the scene: with the
# box where it was put, because the plan is saved and not the moment.
#   sandbox_box.sh WORK_FOLDER SULFURCHAMBER
set -euo pipefail
# shellcheck source=tests/gui/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_work_folder "$1"

cat > scene.json <<'END'
{"format": "sulfur-scene", "version": 1,
 "blueprints": {"floor": {"shape": "floor", "from": [-5, 0], "to": [5, 0]}},
 "bodies": [{"id": "floor", "blueprint": "floor"}]}
END

window_opened() { xdotool search --onlyvisible --class sulfurchamber > window 2> /dev/null; }
picture_is_drawn() { take_picture start.png && [[ $(colours_of start.png) -gt 1000 ]]; }
box_is_seen() { take_picture box.png && (($(changed_pixels empty.png box.png) > 1000)); }
box_has_fallen() { take_picture fallen.png && (($(changed_pixels box.png fallen.png) > 1500)); }
# Before saving the file has no body beside the floor.
scene_is_saved() { xdotool mousemove 88 42 sleep 0.3 click 1 sleep 1 && grep --quiet '"box"' scene.json; }

"$2" --width 1280 --height 800 scene.json > sandbox.log 2>&1 &
pid=$!
trap 'kill $pid 2> /dev/null || true' EXIT

wait_until 30 window_opened || fail "no window; the sandbox said: $(cat sandbox.log)"
wait_until 30 picture_is_drawn || fail "the window stays empty"
xdotool windowfocus "$(tail -1 window)"
xdotool mousemove 17 124 click 1 sleep 0.5 mousemove 600 200 sleep 1
take_picture empty.png
xdotool click 1
wait_until 20 box_is_seen || fail "no box appears; see $PWD/box.png"
xdotool key space
wait_until 20 box_has_fallen || fail "the box does not fall; see $PWD/fallen.png"
sleep 2
xdotool key space
wait_until 20 scene_is_saved || fail "saving does not write the box into $PWD/scene.json"
take_picture end.png

# It lies on the floor now, but it was put at about 5 m.
height=$(sed -nE 's/.*"id": "box".*"position": \[[^,]+, ([-0-9.e]+)\].*/\1/p' scene.json)
awk -v y="$height" 'BEGIN { exit !(y > 4 && y < 6) }' ||
    fail "the box is at ${height:-no} m, expected about 5 m; see $PWD/scene.json"
grep --quiet positions scene.json && fail "the moment is in $PWD/scene.json"
kill -0 "$pid" || fail "the sandbox ended early: $(cat sandbox.log)"
echo "box at $height m; $(colours_of end.png) colours"
