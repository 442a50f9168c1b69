#!/usr/bin/env bash
# Where nothing can be written, both programs run and end as ever, and say what is lost.
#   no_home.sh WORK_FOLDER QUAOAR SULFURCHAMBER
set -euo pipefail
# shellcheck source=tests/gui/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
game=$2
sandbox=$3
enter_work_folder "$1"
# Not even root can make a folder there.
export XDG_CONFIG_HOME=/proc/no/config XDG_STATE_HOME=/proc/no/state XDG_DATA_HOME=/proc/no/data

window_opened() { xdotool search --onlyvisible "$@" > window 2> /dev/null; }
picture_is_drawn() { take_picture start.png && [[ $(colours_of start.png) -gt 1000 ]]; }
says() { grep --quiet "$1" "$log" || fail "it does not say '$1': $(cat "$log")"; }
has_ended() { ! kill -0 "$pid" 2> /dev/null; }
trap 'kill $pid 2> /dev/null || true' EXIT

# ended_by KEY...: one key after the other ends the program, well.
ended_by() {
    xdotool windowfocus "$(tail -1 window)"
    sleep 0.5
    for key in "$@"; do
        xdotool key "$key"
        sleep 0.5
    done
    wait_until 20 has_ended || fail "it does not end; see $PWD/start.png"
    wait "$pid" || fail "it ended with status $?: $(cat "$log")"
    says 'the log cannot be written'
    says 'crash reports cannot be made'
    says 'settings could not be saved'
}

log=game.log
"$game" --size 640x360 > $log 2>&1 &
pid=$!
wait_until 30 window_opened --name 'Escape from Quaoar' || fail "no window: $(cat $log)"
wait_until 30 picture_is_drawn || fail "the game's window stays empty"
ended_by F12 Up Return
says 'quaoar-1.png: its folder cannot be made'

log=sandbox.log
"$sandbox" > $log 2>&1 &
pid=$!
wait_until 30 window_opened --class sulfurchamber || fail "no window: $(cat $log)"
wait_until 30 picture_is_drawn || fail "the sandbox's window stays empty"
ended_by ctrl+q
trap - EXIT
cat game.log sandbox.log
