#!/usr/bin/env bash
# Whatever ends with three dots in the menus asks, by keys alone: each question is opened twice, closed
# by Escape, which changes nothing, and answered, which does what it says.
#   sandbox_dialogs.sh WORK_FOLDER SULFURCHAMBER
set -euo pipefail
# shellcheck source=tests/gui/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_work_folder "$1"

cat > scene.json <<'END'
{"format": "sulfur-scene", "version": 1,
 "blueprints": {"floor": {"shape": "floor", "from": [-5, 0], "to": [5, 0]},
                "box": {"shape": "box", "width": 1, "height": 1}},
 "bodies": [{"id": "floor", "blueprint": "floor"}, {"id": "box1", "blueprint": "box", "position": [0, 1]}]}
END
cat > drawing.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="40" height="40"><path d="M5 5H35V35H5Z"/></svg>
END

openbox > openbox.log 2>&1 &
manager=$!
"$2" --width 1200 --height 800 scene.json > sandbox.log 2>&1 &
pid=$!
trap 'kill $pid $manager 2> /dev/null || true' EXIT
window_opened() { xdotool search --onlyvisible --class sulfurchamber > window 2> /dev/null; }
picture_is_drawn() { take_picture start.png && [[ $(colours_of start.png) -gt 1000 ]]; }
wait_until 30 window_opened || fail "no window; the sandbox said: $(cat sandbox.log)"
wait_until 30 picture_is_drawn || fail "the window stays empty"
sleep 1
xdotool windowfocus "$(tail -1 window)"
sleep 0.5

has_focus() { [[ $(xdotool getactivewindow getwindowname 2> /dev/null) == "$1" ]]; }
main_has_focus() { [[ $(xdotool getactivewindow getwindowname 2> /dev/null) == *" – SulfurChamber" ]]; }
complain() { take_picture failed.png; fail "$*; see $PWD/failed.png"; }

# press KEYS: one after the other, as a person does.
press() {
    local key
    for key in $1; do xdotool key "$key" sleep 0.2; done
}
# asks KEYS TITLE: opens a question and leaves it open.
asks() {
    wait_until 10 main_has_focus || complain "the window has no focus before $1"
    press "$1"
    wait_until 10 has_focus "$2" || complain "$1 does not ask '$2'"
    sleep 0.5
}
# escapes KEYS TITLE: the question goes by Escape.
escapes() {
    asks "$1" "$2"
    take_picture "${2// /-}.png"
    press Escape
    wait_until 10 main_has_focus || complain "'$2' does not go by Escape"
}
# writes KEYS TITLE FILE: the question is answered by a name, and a file is there then.
writes() {
    escapes "$1" "$2"
    [[ ! -e $3 ]] || fail "$3 is there before '$2' is answered"
    asks "$1" "$2"
    press ctrl+a
    xdotool type --delay 10 "$PWD/$3"
    press Return
    wait_until 30 test -s "$3" || complain "'$2' writes no $3"
}
# reads KEYS TITLE FILE: the question is answered by a file that is there.
reads() {
    escapes "$1" "$2"
    asks "$1" "$2"
    xdotool type --delay 10 "$PWD/$3"
    press Return
}
saved_has() { press ctrl+s && sleep 0.3 && grep --quiet -- "$1" "$2"; }
title_has() { [[ $(xdotool getwindowname "$(tail -1 window)") == *"$1"* ]]; }

# The box and the floor are selected while the scene runs for a moment.
press "ctrl+a F8 space"
sleep 1
press space
writes "alt+f m" "Save this moment as a new scene" moment.json
writes "alt+f plus" "Export as C++ source" scene.cpp
grep --quiet '#include <sulfur/' scene.cpp || fail "scene.cpp is no source"
writes "alt+f f" "Film of the last 10 s" film.png
writes "alt+m x t" "Save the table" measured.csv
writes "alt+m x p" "Save the diagram" measured.png
writes "ctrl+shift+s" "Save the scene" other.json
wait_until 10 title_has other.json || complain "the scene has not got its new name"

reads "alt+e s c" "Choose a picture to wear" start.png
wait_until 20 saved_has '"skin"' other.json || complain "no body wears the picture"
reads "alt+f i" "Make bodies from a drawing or a picture" drawing.svg
wait_until 10 has_focus "Bodies from outlines" || complain "the drawing is not asked about"
press Return
wait_until 20 saved_has '"path"' other.json || complain "the drawing is no body"

escapes "alt+e e s" "Save as a template"
asks "alt+e e s" "Save as a template"
press ctrl+a
xdotool type --delay 10 "Fine box"
press Return
is_template() { [[ -s $(find data -name 'Fine*box.json' -o -name 'fine*box.json' | head -1) ]]; }
wait_until 20 is_template || complain "there is no template of that name"

escapes "alt+m 4" "Table 4 of the paper"
asks "alt+m 4" "Table 4 of the paper"
press alt+t
wait_until 10 has_focus "Save the table" || complain "the window of Table 4 does not ask where to"
press Escape
wait_until 10 has_focus "Table 4 of the paper" || complain "the question of Table 4 does not go"
press Escape
escapes "F1" "Example scenes"
escapes "ctrl+shift+o" "Recent scenes"
press ctrl+s
reads "ctrl+o" "Open a scene or a level" scene.json
wait_until 10 title_has scene.json || complain "the scene is not opened"

# Arrows walk through an open menu, and move what is selected when none is.
box_x() { press ctrl+s && sleep 0.3 && grep -o '"box1".*' scene.json; }
press "ctrl+a"
before=$(box_x)
press "F10 Right Down Right Left Escape"
take_picture menu.png
[[ $(box_x) == "$before" ]] || complain "keys of a menu move what is selected"
press Right
[[ $(box_x) != "$before" ]] || complain "after a menu keys do nothing"

# Tab goes on to the fields of the side panel, and Escape back to the scene.
press "ctrl+1 Tab Tab"
xdotool type 3
press "Return Escape"
saved_has '"gravity": \[0, -3\]' scene.json || complain "Tab does not lead to the first field"
press "ctrl+a Left ctrl+s"
saved_has '"gravity": \[0, -3\]' scene.json || complain "keys go on to the field"

# What is not saved is asked about, before another scene is opened and at the end.
press "ctrl+a ctrl+d"
asks "ctrl+n" "SulfurChamber"
take_picture question.png
press Escape
wait_until 10 main_has_focus || complain "the question does not go by Escape"
title_has scene.json || fail "Escape has discarded the scene"
asks "ctrl+q" "SulfurChamber"
press Escape
wait_until 10 main_has_focus || complain "the question does not go by Escape"
kill -0 "$pid" || fail "Escape has ended the program"
asks "ctrl+q" "SulfurChamber"
press alt+d
has_ended() { ! kill -0 "$pid" 2> /dev/null; }
wait_until 10 has_ended || complain "'Discard' does not end the program"
! grep -E 'Gtk|GLib|Pixman' sandbox.log || fail "the toolkit complains; see $PWD/sandbox.log"
