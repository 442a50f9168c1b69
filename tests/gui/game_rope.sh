#!/usr/bin/env bash
# Plays the game's window with mouse and keyboard: a rope is fired, sticks and is reeled in.
#   game_rope.sh WORK_FOLDER QUAOAR LEVEL
set -euo pipefail
# shellcheck source=tests/gui/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
game=$2
level=$3
enter_work_folder "$1"

window_opened() { xdotool search --onlyvisible --name 'Escape from Quaoar' > window 2> /dev/null; }
picture_is_drawn() { take_picture start.png && [[ $(colours_of start.png) -gt 1000 ]]; }
# The rope is amber and goes up from the hero, who stands at the left.
rope_pixels() { pixels_like "$1" '#FFB347' 165x225+225+75; }
rope_is_seen() { take_picture rope.png && (($(rope_pixels rope.png) > $(rope_pixels start.png) + 170)); }
view_has_moved() { take_picture reeled.png && (($(changed_pixels rope.png reeled.png) > 28000)); }
game_has_ended() { ! kill -0 "$pid" 2> /dev/null; }

"$game" --level "$level" --record "$PWD/run.recording" --size 960x540 > game.log 2>&1 &
pid=$!
trap 'kill $pid 2> /dev/null || true' EXIT

wait_until 30 window_opened || fail "no window; the game said: $(cat game.log)"
wait_until 30 picture_is_drawn || fail "the window stays empty"
xdotool windowfocus "$(tail -1 window)" mousemove 315 90
sleep 0.5
xdotool mousedown 1
wait_until 30 rope_is_seen || fail "no rope was fired; see $PWD/rope.png"
xdotool keydown w
wait_until 30 view_has_moved || fail "reeling in does not lift the hero; see $PWD/reeled.png"
xdotool keyup w mouseup 1
sleep 0.3
take_picture released.png

# Out through the pause menu, whose last entry is Quit.
xdotool key Escape
sleep 0.5
take_picture paused.png
(($(changed_pixels released.png paused.png) > 28000)) || fail "Escape does not pause"
xdotool key Up
sleep 0.3
xdotool key Return
wait_until 10 game_has_ended || fail "Quit does not end the game; see $PWD/paused.png"
wait "$pid" || fail "the game ended with status $?: $(cat game.log)"
trap - EXIT

# The window wrote down what was played; without a window it must go the same way.
awk '/^inputs/ { on = 1 } on && $4 % 2 == 1 { fire = 1 } on && $4 == 3 { reel = 1 }
     END { exit !(fire && reel) }' run.recording || fail "the recording lacks the rope"
mkdir replay
cp "$level" replay/
cp run.recording "replay/$(basename "$level" .json).proof"
verdict=$("$game" --headless --verify "replay/$(basename "$level")" 2>&1 || true)
[[ $verdict == *"not finished"* && $verdict != *"another state"* ]] ||
    fail "the replay without a window differs: $verdict"
echo "rope: $(rope_pixels rope.png) pixels, start: $(colours_of start.png) colours; $verdict"
