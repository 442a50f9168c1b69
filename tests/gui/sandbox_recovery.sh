#!/usr/bin/env bash
# A sandbox that is killed leaves what was not saved: the next one offers it, and opens it.
#   sandbox_recovery.sh WORK_FOLDER SULFURCHAMBER
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
is_kept() { grep --quiet '"box"' state/sulfurchamber/recovery/*.json 2> /dev/null; }
nothing_is_kept() { ! is_kept; }
has_box() { xdotool key ctrl+s sleep 0.5 && grep --quiet '"box"' scene.json; }

"$2" --width 1280 --height 800 --autosave 1 scene.json > sandbox.log 2>&1 &
pid=$!
trap 'kill $pid 2> /dev/null || true' EXIT
wait_until 30 window_opened || fail "no window; the sandbox said: $(cat sandbox.log)"
wait_until 30 picture_is_drawn || fail "the window stays empty"
xdotool windowfocus "$(tail -1 window)"
sleep 1
xdotool mousemove 600 300 sleep 0.3 key b sleep 0.3 click 1
wait_until 15 is_kept || fail "nothing is kept in $PWD/state"
kill -KILL "$pid"
wait "$pid" 2> /dev/null || true

"$2" --width 1280 --height 800 > sandbox.log 2>&1 &
pid=$!
wait_until 30 window_opened || fail "no second window: $(cat sandbox.log)"
sleep 3
take_picture offer.png
xdotool key Return
sleep 2
take_picture recovered.png
wait_until 10 has_box || fail "the box is not back; see $PWD/offer.png and $PWD/recovered.png"
wait_until 40 nothing_is_kept || fail "what was recovered and saved is still kept"
kill -0 "$pid" || fail "the sandbox ended early: $(cat sandbox.log)"
