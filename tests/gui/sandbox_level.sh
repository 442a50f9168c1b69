#!/usr/bin/env bash
# A level from nothing: made in the sandbox, checked, played there, proven, published; and then found
# and begun in the game's own menu.
#   sandbox_level.sh WORK_FOLDER SULFURCHAMBER QUAOAR
set -euo pipefail
# shellcheck source=tests/gui/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
sandbox=$2
game=$3
enter_work_folder "$1"
folder=$PWD

cat > level.txt <<END
do level-new
expect problem = 0
await level.checked = 1 60
expect level.problems = 0
do place-checkpoint
click 8 0.4
do place-wind
drag 5.2 -1.4 6.4 0.6
do place-pickup
click 5.8 1.4
do place-hint
click 9 1.2
expect steps = 4
field text Well done
expect steps = 5
tool select
drag 11 0.6 10.6 0.7
expect level.selected = 1
field radius 0.8
thing zones 0
field pulse yes
field pulse no
key Ctrl+Z
key Ctrl+Z
await level.checked = 1 60
expect level.problems = 0
screenshot $folder/editing.png
# Into the ground with the exit: it is told, and a click goes there.
drag 10.6 0.7 10.6 -1
await level.checked = 1 60
expect level.problems > 0
expect level.playable = 0
do level-problem
expect level.selected = 1
key Ctrl+Z
await level.checked = 1 60
expect level.playable = 1
# Play in the same window, and back to where one was.
key F5
await playtest = 1 30
await playtest.ticks > 100 30
expect playtest.time = 0
keep-key D 0.8
await playtest.time > 0.2 30
screenshot $folder/playing.png
key Escape
expect playtest = 0
expect level.playable = 1
expect time = 0
# A way through it, beside the editing; an edit makes the proof void.
key F6
await level.proof = 2 200
do level-stop
await level.searching = 0 20
screenshot $folder/proven.png
do level-medals
await level.proof = 2 60
thing hints 0
do nudge-up
expect level.proof = 3
key Ctrl+Z
expect level.proof = 2
save $folder/mine.json
do level-publish
expect problem = 0
quit
END
"$sandbox" --script level.txt > sandbox.log 2>&1 || fail "the sandbox: $(cat sandbox.log)"
[[ -f mine.proof ]] || fail "no proof lies beside the saved level"
published=data/quaoar/levels/new-level
[[ -f $published.json && -f $published.proof ]] || fail "nothing was published: $(find data)"
"$game" --headless --verify "$published.json" || fail "the published proof does not hold"

# The game, with one level of its own before it.
mkdir levels
cat > levels/room.json <<END
{"format": "sulfur-scene", "version": 1,
 "level": {"name": "Room", "number": 1, "spawn": [0, 0.3],
           "exit": {"position": [1.9, 0.6], "radius": 0.6},
           "bounds": {"min": [-4, -1], "max": [4, 4]}, "killDepth": -3,
           "medals": {"gold": 5, "silver": 10, "bronze": 20}},
 "blueprints": {"room": {"shape": "ground", "kind": "fixed", "closed": true,
                         "points": [[-2, 0], [2.6, 0], [2.6, 3], [-2, 3]]}},
 "bodies": [{"id": "room", "blueprint": "room"}]}
END
export QUAOAR_LEVELS=$PWD/levels
window_opened() { xdotool search --onlyvisible --name 'Escape from Quaoar' > window 2> /dev/null; }
picture_is_drawn() { take_picture title.png && [[ $(colours_of title.png) -gt 1000 ]]; }
log_says() { grep --quiet "$1" game.log; }
"$game" --size 960x540 > game.log 2>&1 &
pid=$!
trap 'kill $pid 2> /dev/null || true' EXIT
wait_until 30 window_opened || fail "no window; the game said: $(cat game.log)"
wait_until 30 picture_is_drawn || fail "the window stays empty"
xdotool windowfocus "$(tail -1 window)"
sleep 0.5
for key in Down Down Return Right; do
    xdotool key "$key"
    sleep 0.5
done
sleep 1
take_picture menu.png
xdotool key Return
wait_until 15 log_says 'level new-level begins' ||
    { take_picture begin.png; fail "the level does not begin; see $PWD/menu.png"; }
