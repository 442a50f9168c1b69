#!/usr/bin/env bash
# Plays at random with the sandbox. Its memory ceases to grow: the history lies on the disk, and what the
# worlds of the moment take is less than 256 MiB.
#   sandbox_memory.sh WORK_FOLDER SULFURCHAMBER
# PLAY=600 in the environment plays for ten minutes, SEED=N in another way.
set -euo pipefail
# shellcheck source=tests/gui/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_work_folder "$1"

# What a person may do in a window of 1280x800, as commands for xdotool.
random_input() {
    awk -v seed="${SEED:-1}" '
    function at() { return int(100 + 750 * rand()) " " int(120 + 580 * rand()) }
    function one_of(text,  words, n) { n = split(text, words); return words[1 + int(n * rand())] }
    function act(dice) {
        if (dice < 0.20) return "key " one_of("v b o j r g p x e w y l h u q n 1 2 Return")
        if (dice < 0.50) return "mousemove " at() " click 1"
        if (dice < 0.70) return "mousemove " at() " mousedown 1 mousemove " at() " sleep 0.1 mouseup 1"
        if (dice < 0.73) return "click " one_of("4 5")
        if (dice < 0.81) return "key ctrl+" one_of("z z z d c v x")
        if (dice < 0.84) return "key " one_of("Delete Escape period plus minus Left Up bracketleft ctrl+m")
        if (dice < 0.86) return "key ctrl+a"
        if (dice < 0.87) return "key ctrl+a Delete"
        if (dice < 0.90) return "key " one_of("a t c k i s m")
        if (dice < 0.92) return "key d"
        if (dice < 0.95) return "key f"
        return "key space"
    }
    BEGIN {
        srand(seed)
        for (i = 0; i < 200000; ++i) print act(rand()) " sleep 0.05"
    }'
}
window_opened() { xdotool search --onlyvisible --class sulfurchamber > window 2> /dev/null; }
# MiB; what is mapped from files is not the program's own.
memory() { awk '/^RssAnon/ { print int($2 / 1024) }' "/proc/$pid/status"; }

random_input > input
"$2" --width 1280 --height 800 > sandbox.log 2>&1 &
pid=$!
trap 'kill $pid $player 2> /dev/null || true' EXIT
player=
wait_until 30 window_opened || fail "no window; the sandbox said: $(cat sandbox.log)"
sleep 2
xdotool windowfocus "$(tail -1 window)"
start=$(memory)
echo "0 s: $start MiB"
xdotool input &
player=$!
for ((second = 1; second <= ${PLAY:-10}; ++second)); do
    sleep 1
    kill -0 "$pid" 2> /dev/null || fail "it ended early: $(cat sandbox.log)"
    ((second % 10)) || echo "$second s: $(memory) MiB"
    (($(memory) <= start + 256)) || fail "it takes $(memory) MiB, at the start $start"
done
