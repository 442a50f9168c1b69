#!/usr/bin/env bash
# The sandbox remembers what was opened and switched on; and a crash leaves a report.
#   sandbox_settings.sh WORK_FOLDER SULFURCHAMBER SCENE
set -euo pipefail
# shellcheck source=tests/gui/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
sandbox=$2
scene=$3
enter_work_folder "$1"
settings=config/sulfurchamber/settings.json

window_opened() { xdotool search --onlyvisible --class sulfurchamber > window 2> /dev/null; }
picture_is_drawn() { take_picture start.png && [[ $(colours_of start.png) -gt 1000 ]]; }
picture_is_as_before() {
    take_picture start.png
    (($(changed_pixels start.png skeleton.png) < 2000))
}
has_ended() { ! kill -0 "$pid" 2> /dev/null; }
start_sandbox() {
    "$sandbox" "$@" > sandbox.log 2>&1 &
    pid=$!
    wait_until 30 window_opened || fail "no window; the sandbox said: $(cat sandbox.log)"
    wait_until 30 picture_is_drawn || fail "the window stays empty"
    xdotool windowfocus "$(tail -1 window)"
    sleep 1
}
trap 'kill $pid 2> /dev/null || true' EXIT

# The theme and the step of the grid that were chosen before.
mkdir -p "$(dirname "$settings")"
echo '{"version": 1, "settings": {"theme": "light", "view.grid-step": 0.5}}' > "$settings"
start_sandbox --width 1100 --height 700 "$scene"
take_picture plain.png
(($(pixels_like plain.png '#f6f5f4' 300x20+700+0) > 4000)) || fail "no light theme; see $PWD/plain.png"
xdotool key k
sleep 1
take_picture skeleton.png
(($(changed_pixels plain.png skeleton.png) > 400)) || fail "no skeleton; see $PWD/skeleton.png"
xdotool key ctrl+q
wait_until 10 has_ended || fail "Ctrl+Q does not end it"
wait "$pid" || fail "it ended with status $?: $(cat sandbox.log)"
for line in '"theme": "light"' '"view.grid-step": 0.5' '"view.skeleton": true' '"window.width": 1100' '"window.height": 700' \
    "$(basename "$scene")"; do
    grep --quiet "$line" "$settings" || fail "the settings lack $line: $(cat $settings)"
done

# Without options it comes back as large, and shows what was switched on.
start_sandbox "$scene"
geometry=$(xdotool getwindowgeometry "$(tail -1 window)" | sed -nE 's/.*Geometry: //p')
[[ $geometry == 1100x700 ]] || fail "the window is $geometry"
# (Its panels may be there before the canvas.)
wait_until 15 picture_is_as_before || fail "another picture; see $PWD/start.png"
xdotool key space
sleep 3
kill -SEGV "$pid"
status=0
wait "$pid" || status=$?
trap - EXIT
[[ $status -eq 139 ]] || fail "the crash ended with $status"
report=$(cat state/sulfurchamber/crashes/crash-*.txt)
for line in '^sulfurchamber [0-9]' '^ended by: SIGSEGV' '^state: hash [0-9a-f]{16} at tick [0-9]+'; do
    grep --quiet -E "$line" <<< "$report" || fail "the report lacks '$line': $report"
done
grep -E '^state' <<< "$report"
