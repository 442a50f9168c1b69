#!/usr/bin/env bash
# What a player sets is kept: another language, another key. And a crash leaves a report.
#   game_settings.sh WORK_FOLDER QUAOAR LEVEL
set -euo pipefail
# shellcheck source=tests/gui/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
game=$2
level=$3
enter_work_folder "$1"
settings=config/quaoar/settings.json
log=state/quaoar/quaoar.log

window_opened() { xdotool search --onlyvisible --name 'Escape from Quaoar' > window 2> /dev/null; }
picture_is_drawn() { take_picture start.png && [[ $(colours_of start.png) -gt 1000 ]]; }
# What swings may hang where it hung before: it lies still where it also did in between.
view_is_still() {
    take_picture rope.png
    sleep 0.4
    take_picture between.png
    sleep 0.4
    take_picture later.png
    (($(changed_pixels rope.png between.png) < 8000 && $(changed_pixels rope.png later.png) < 8000))
}
view_has_moved() { take_picture moved.png && (($(changed_pixels rope.png moved.png) > 28000)); }
# One key after the other: taps that fall between two frames are one.
press() {
    for key in "$@"; do
        xdotool key "$key"
        sleep 0.4
    done
}
setting_is() { grep --quiet "$1" "$settings"; }
start_game() {
    "$game" --level "$level" --size 960x540 > game.log 2>&1 &
    pid=$!
    wait_until 30 window_opened || fail "no window; the game said: $(cat game.log)"
    wait_until 30 picture_is_drawn || fail "the window stays empty"
    xdotool windowfocus "$(tail -1 window)" mousemove 315 90
    sleep 0.5
}
trap 'kill $pid 2> /dev/null || true' EXIT

# A file that a player has written: German, and I instead of W.
mkdir -p config/quaoar
cat > "$settings" <<'END'
{"version": 1, "settings": {"language": "de", "input.reel_in": ["key:I"]}}
END
start_game
xdotool mousedown 1
# Where processors are busy, seconds of the game pass between two pictures, and the hero rolls: three
# tries. If W reeled in, it would move the view in each, or leave nothing for I to reel in.
for try in 1 2 3; do
    wait_until 60 view_is_still || fail "it goes on to roll; see $PWD/later.png"
    xdotool keydown w
    sleep 1.5
    take_picture w.png
    xdotool keyup w
    (($(changed_pixels rope.png w.png) >= 20000)) || break
    [[ $try -lt 3 ]] || fail "W still reels in; see $PWD/w.png"
done
xdotool keydown i
wait_until 30 view_has_moved || fail "I does not reel in; see $PWD/moved.png"
xdotool keyup i mouseup 1

# Escape, options, first entry: the next language after German is Italian.
press Escape Down Down Return
take_picture german.png
press Return
wait_until 10 setting_is '"language": "it"' || fail "the language is not kept: $(cat $settings)"
take_picture italian.png
(($(changed_pixels german.png italian.png) > 500)) || fail "the same words; see $PWD/italian.png"
setting_is '"input.reel_in"' || fail "the key was forgotten: $(cat $settings)"

# In the list of controls the first entry is what fires: now with F instead of the mouse.
press Down Down Down Down Return
take_picture controls.png
press Return Return f
wait_until 10 setting_is '"key:F"' || fail "the new key is not kept: $(cat $settings)"
press Escape Escape Escape
sleep 1

kill -SEGV "$pid"
status=0
wait "$pid" || status=$?
[[ $status -eq 139 ]] || fail "the crash ended with $status"
report=$(cat state/quaoar/crashes/crash-*.txt)
for line in '^quaoar [0-9]' '^ended by: SIGSEGV' '^state: hash [0-9a-f]{16} at tick [0-9]+' \
    'level 01-cold-wake begins'; do
    grep --quiet -E "$line" <<< "$report" || fail "the report lacks '$line': $report"
done

# The next start finds everything, and fires with F.
start_game
press_until_rope() { xdotool keydown f sleep 1 keyup f && take_picture f.png && (($(changed_pixels start.png f.png) > 300)); }
wait_until 20 press_until_rope || fail "F does not fire; see $PWD/f.png"
press Escape Up Return
wait "$pid" || fail "the game ended with status $?: $(cat game.log)"
trap - EXIT
grep --quiet 'level 01-cold-wake begins' "$log" || fail "the log: $(cat $log)"
grep -E '^state' <<< "$report"
