#!/usr/bin/env bash
# Types numbers into a field: what is out of range is refused, undo is followed at once and stays undone
# when the field loses the focus, and a drag of the slider is a step of its own.
#   sandbox_fields.sh WORK_FOLDER SULFURCHAMBER
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
canvas() { xdotool mousemove 500 300 click 1 sleep 0.4; }
# Types into the field of gravity, which is the uppermost of the side panel.
type_gravity() { xdotool mousemove 1170 145 click --repeat 3 1 sleep 0.3 type "$1"; xdotool key Return sleep 0.4; }
gravity() {
    xdotool key ctrl+s sleep 0.8
    sed -nE 's/.*"gravity": \[[^,]+, ([-0-9.e]+)\].*/\1/p' scene.json
}
expect_gravity() {
    local is
    is=$(gravity)
    [[ ${is:--9.81} == "$1" ]] || { take_picture wrong.png; fail "$2: gravity is ${is:--9.81}, expected $1"; }
}

"$2" --width 1280 --height 800 scene.json > sandbox.log 2>&1 &
pid=$!
trap 'kill $pid 2> /dev/null || true' EXIT
wait_until 30 window_opened || fail "no window; the sandbox said: $(cat sandbox.log)"
wait_until 30 picture_is_drawn || fail "the window stays empty"
xdotool windowfocus "$(tail -1 window)"
sleep 1

type_gravity 12.5
canvas
expect_gravity -12.5 "a number is taken"
take_picture before.png
type_gravity 9999
take_picture refused.png
(($(changed_pixels before.png refused.png) > 3000)) || fail "nothing tells that 9999 is refused"
canvas
expect_gravity -12.5 "9999 is refused"
type_gravity 3
xdotool key ctrl+z sleep 0.4
canvas
expect_gravity -12.5 "undo stays undone when the canvas is clicked"
xdotool key ctrl+shift+z sleep 0.4
expect_gravity -3 "redo is still there"
# A drag of the slider, then a number, without a click in between: two steps.
xdotool mousemove 1138 176 mousedown 1 sleep 0.2 mousemove 1225 176 sleep 0.2 mouseup 1 sleep 0.4
dragged=$(gravity)
[[ $dragged != -3 ]] || { take_picture wrong.png; fail "the slider does not move"; }
type_gravity 5
canvas
expect_gravity -5 "a number after a drag"
xdotool key ctrl+z sleep 0.4
expect_gravity "$dragged" "undo of the number leaves the drag"
xdotool key ctrl+z sleep 0.4
expect_gravity -3 "undo of the drag"
kill -0 "$pid" || fail "the sandbox ended early: $(cat sandbox.log)"
if grep -E 'Gtk-|BUG|CRITICAL' sandbox.log; then fail "GTK complains"; fi
