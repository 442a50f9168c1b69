#!/usr/bin/env bash
# The whole way of a player with keyboard and mouse: first start, options, a level, a pause with the
# rope held, retry, finish, the next level, quit; and the next start finds the progress.
#   game_whole.sh WORK_FOLDER QUAOAR
set -euo pipefail
# shellcheck source=tests/gui/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
game=$2
enter_work_folder "$1"
log=game.log
progress=data/quaoar/progress.json

# Two rooms in which a rope to the right, reeled in, leads to the exit.
mkdir levels
for number in 1 2; do
    cat > "levels/room-$number.json" <<END
{"format": "sulfur-scene", "version": 1,
 "level": {"name": "Room $number", "number": $number, "spawn": [0, 0.3],
           "exit": {"position": [1.9, 0.6], "radius": 0.6},
           "bounds": {"min": [-4, -1], "max": [4, 4]}, "killDepth": -3,
           "medals": {"gold": 5, "silver": 10, "bronze": 20}},
 "blueprints": {"room": {"shape": "ground", "kind": "fixed", "closed": true,
                         "points": [[-2, 0], [2.6, 0], [2.6, 3], [-2, 3]]}},
 "bodies": [{"id": "room", "blueprint": "room"}]}
END
done
export QUAOAR_LEVELS=$PWD/levels

window_opened() { xdotool search --onlyvisible --name 'Escape from Quaoar' > window 2> /dev/null; }
picture_is_drawn() { take_picture start.png && [[ $(colours_of start.png) -gt 1000 ]]; }
game_has_ended() { ! kill -0 "$pid" 2> /dev/null; }
log_says() { grep --quiet "$1" "$log"; }
press() {
    for key in "$@"; do
        xdotool key "$key"
        sleep 0.4
    done
}
start_game() {
    "$game" --size 960x540 > game.log 2>&1 &
    pid=$!
    wait_until 30 window_opened || fail "no window; the game said: $(cat game.log)"
    wait_until 30 picture_is_drawn || fail "the window stays empty"
    xdotool windowfocus "$(tail -1 window)" mousemove 900 200
    sleep 0.5
}
trap 'kill $pid 2> /dev/null || true' EXIT

start_game
# Options, sound, effects a little lower; back to the title, where "Play" is two up.
press Down Down Down Return Down Return Left Escape Escape Up Up Up
# The story comes before the first level; Escape skips it.
press Return
sleep 1
begun=$SECONDS
press Escape
wait_until 10 log_says 'level room-1 begins' || { take_picture begin.png; fail "Play does not begin; see $PWD/begin.png"; }
((SECONDS - begun <= 3)) || fail "the first level takes $((SECONDS - begun)) s to begin"

# A rope to the right wall; its pause keeps it, though the button is let go meanwhile.
xdotool mousemove 900 190
sleep 0.3
xdotool mousedown 1
sleep 1
press Escape
xdotool mouseup 1
press Escape
sleep 2
take_picture resumed.png
# Retry, and now to the exit.
press r
xdotool mousemove 900 190
sleep 0.3
xdotool mousedown 1
sleep 0.5
xdotool keydown w
wait_until 40 log_says 'level room-1 finished' || { take_picture lost.png; fail "no way; see $PWD/lost.png"; }
xdotool keyup w mouseup 1
sleep 2
take_picture finished.png
press Return
wait_until 10 log_says 'level room-2 begins' || fail "no next level; see $PWD/finished.png"

# Out through the pause menu, whose last entry is Quit. Where processors are busy a press may come
# before the one before it has its effect.
quit_game() {
    press Escape Up Return
    wait_until 5 game_has_ended
}
wait_until 30 quit_game || fail "Quit does not end the game"
wait "$pid" || fail "the game ended with status $?: $(cat game.log)"
grep --quiet '"level.room-1.finished": true' "$progress" || fail "no progress: $(cat $progress)"
grep --quiet '"sound.volume": 90' config/quaoar/settings.json || fail "the volume was forgotten"
[[ -s data/quaoar/replays/room-1.recording ]] || fail "the best run was not kept"

# The next start goes on with level 2.
start_game
take_picture continue.png
press Return
wait_until 10 log_says 'level room-2 begins' || fail "it does not continue; see $PWD/continue.png"
press Escape Up Return
wait_until 10 game_has_ended || fail "Quit does not end the game"
wait "$pid" || fail "the game ended with status $?: $(cat game.log)"
trap - EXIT
grep -o '"level.room-1[^,]*' "$progress" | tr '\n' ' '
