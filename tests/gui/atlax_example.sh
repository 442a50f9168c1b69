#!/usr/bin/env bash
# Plays one script on the example of atlax, built with each backend, and compares what both said and
# what both drew.
#   atlax_example.sh WORK_FOLDER EXAMPLE_SDL EXAMPLE_WX DROP_FILE
set -euo pipefail
# shellcheck source=tests/gui/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
example_sdl=$2
example_wx=$3
drop_file=$4
enter_work_folder "$1"

# On this layout the umlaut is a key; else it would be put on one for a moment only, which a program
# that looks later does not find.
setxkbmap de
# A window manager gives focus, fullscreen and minimising their meaning.
openbox > openbox.log 2>&1 &
manager=$!
pid=
trap 'kill $manager $pid 2> /dev/null || true' EXIT

manager_answers() { xdotool get_num_desktops > /dev/null 2>&1; }
window_opened() { xdotool search --onlyvisible --name 'Atlax example' > window 2> /dev/null; }
said() { grep --quiet --line-regexp --fixed-strings -- "$1" "$backend/said"; }
said_since() { tail -n "+$((mark + 1))" "$backend/said" | grep --quiet --line-regexp -- "$1"; }
example_ended() { ! kill -0 "$pid" 2> /dev/null; }
picture_taken() { [[ -s $backend/picture$1.png ]]; }

# step WHAT EXPECTED COMMAND...: the example must answer the command with a line (a pattern).
step() {
    local what=$1 expected=$2
    shift 2
    mark=$(wc -l < "$backend/said")
    "$@"
    wait_until 10 said_since "$expected" ||
        fail "$backend: $what: no line '$expected'; see $PWD/$backend/said"
}

# To the window, not to the screen, whose borders differ.
point() { xdotool mousemove --sync --window "$window" "$1" "$2"; }
point_and_click() { point "$1" "$2"; xdotool click "$3"; }
double_click() { point "$1" "$2"; xdotool click --repeat 2 --delay 60 1; }
press() { xdotool key --clearmodifiers "$@"; }
put_on_clipboard() { printf '%s' "$1" | xclip -selection clipboard -in > /dev/null; }
resize_to() { xdotool windowsize "$window" "$1" "$2"; }

wait_until 30 manager_answers || fail "openbox does not manage the display: $(cat openbox.log)"

start_example() {
    backend=$1
    mkdir "$backend"
    "$2" --still --pictures "$PWD/$backend" > "$backend/said" 2> "$backend/log" &
    pid=$!
    wait_until 60 window_opened || fail "$backend: no window: $(cat "$backend/log")"
    window=$(tail -1 window)
    wait_until 30 said "started 640 480 scale 100 %" ||
        fail "$backend: not started: $(cat "$backend/said")"
    xdotool windowactivate "$window"
    wait_until 10 said "focus gained" || fail "$backend: no focus"
    point 300 300
}

play_input() {
    step "a key" "key W up" press w
    step "a key with Control" "key A down with Control" press ctrl+a
    step "arrow keys" "key Left up" press Left
    step "Tab" "key Tab up" press Tab
    step "left button" "button Left up at 100 120" point_and_click 100 120 1
    step "right button" "button Right up at 200 220" point_and_click 200 220 3
    step "double click" "button Left down twice at 50 60" double_click 50 60
    step "wheel down" "wheel 0 -1 at 50 60" xdotool click 5
    step "wheel right" "wheel 1 0 at 50 60" xdotool click 7
}

play_text() {
    press F2
    step "text" "text b" xdotool type 'Ab'
    step "text beyond ASCII" "text ü" xdotool key udiaeresis
    press F2
    press F3
    sleep 0.5
    local copied
    copied=$(timeout 5 xclip -selection clipboard -out)
    [[ $copied == "Abü" ]] || fail "$backend: the clipboard holds '$copied', not 'Abü'"
    put_on_clipboard 'Wäldchen'
    step "clipboard of another program" "clipboard Wäldchen" press F4
    touch "$backend/dropped.txt"
    step "a dropped file" "dropped $PWD/$backend/dropped.txt" \
        "$drop_file" "$window" 100 100 "$backend/dropped.txt"
}

play_window() {
    step "a smaller window" "size 400 300 scale 100 %" press F7
    step "the smallest window" "size 1 1 scale 100 %" resize_to 1 1
    step "a larger window" "size 640 480 scale 100 %" press F8
    step "fullscreen" "size $(xdotool getdisplaygeometry) scale 100 %" press F11
    step "no fullscreen" "size 640 480 scale 100 %" press F11
    step "minimised" "focus lost" press F9
    sleep 0.5
    step "restored" "focus gained" xdotool windowmap "$window" windowactivate "$window"
}

# The shape itself cannot be asked for under X11; each must only do no harm.
play_cursors() {
    press F5 F5 F5 F5 F5 F5 F5 F5 F5
    press F6
    press F6
    step "alive after all cursors" "key C up" press c
}

play_pictures() {
    xdotool windowactivate --sync "$window"
    point 300 300
    sleep 0.5
    press F12
    wait_until 10 picture_taken 1 || fail "$backend: no picture"
}

# Dialogs that close leave the focus to the window manager.
focus_is_back() {
    xdotool windowactivate "$window"
    sleep 0.3
    [[ $(xdotool getwindowfocus getwindowname 2> /dev/null) == 'Atlax example' ]]
}
dialog_opened() { xdotool search --onlyvisible --name 'Choose a text' > dialog 2> /dev/null; }
type_file_name() {
    press F1
    wait_until 10 dialog_opened || fail "wx: no file dialog"
    sleep 0.5
    xdotool type "$PWD/wx/dropped.txt"
    sleep 0.5
    xdotool key Return
}
decline_dialog() {
    press F1
    wait_until 10 dialog_opened || fail "wx: no second file dialog"
    sleep 0.5
    xdotool key Escape
}

play_dialogs() {
    if [[ $backend == sdl ]]; then
        step "no file dialog" "no file dialogs" press F1
    else
        step "a chosen file" "chose dropped.txt" type_file_name
        wait_until 10 focus_is_back || fail "wx: no focus after the dialog"
        step "a dialog declined" "chose nothing" decline_dialog
        wait_until 10 focus_is_back || fail "wx: no focus after the dialog"
    fi
}

play_end() {
    press F2
    step "closing is refused while text is typed" "close requested" press alt+F4
    sleep 0.3
    example_ended && fail "$backend: it closed although it refused"
    press F2
    step "closing" "stopped" press alt+F4
    wait_until 10 example_ended || fail "$backend: it goes on after it was closed"
    wait "$pid" || fail "$backend: it ended with status $?: $(cat "$backend/log")"
    pid=
}

play() {
    start_example "$@"
    play_input
    play_text
    play_window
    play_cursors
    play_dialogs
    play_pictures
    play_end
}

play sdl "$example_sdl"
play wx "$example_wx"

# On a display of high resolution; under X11 only GTK knows of such.
GDK_SCALE=2 "$example_wx" --seconds 1 > wx/said-hidpi 2>> wx/log || fail "wx: HiDPI: $(cat wx/log)"
grep --quiet --line-regexp "started 1280 960 scale 200 %" wx/said-hidpi ||
    fail "wx: HiDPI: $(cat wx/said-hidpi)"

# What was pressed, typed and dropped must have arrived alike. How often sizes and focus were told on
# the way, and who hears that Alt+F4 and a dialog's Escape go up, is the window manager's matter.
for backend in sdl wx; do
    grep -E '^(key [^F]|key F[2-9]|button|wheel|text|clipboard|dropped|close)' "$backend/said" |
        grep -vE 'LeftAlt|Escape' | sed "s,$PWD/$backend/,," > "$backend/input"
done
diff sdl/input wx/input > input.diff || fail "the backends differ: $(cat input.diff)"

# Mean difference of the pictures in parts of the whole range.
difference=$(compare -metric MAE sdl/picture1.png wx/picture1.png null: 2>&1 || true)
difference=$(sed -nE 's/.*\((.*)\)/\1/p' <<< "$difference")
awk -v d="${difference:-1}" 'BEGIN { exit !(d < 0.001) }' ||
    fail "the pictures differ by ${difference:-everything}; see $PWD"
(($(colours_of sdl/picture1.png) > 1000)) || fail "the picture is empty; see $PWD/sdl"
echo "$(wc -l < sdl/input) lines of input alike; pictures differ by $difference"
