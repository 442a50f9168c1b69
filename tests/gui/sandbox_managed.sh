#!/usr/bin/env bash
# Starts the sandbox under a window manager, which gives the window another size than it asked for while
# it opens: GTK complains of nothing, the first view is as wide as without, and each page of the side
# panel shows what it has, before anything is laid out anew.
#   sandbox_managed.sh WORK_FOLDER SULFURCHAMBER LEVEL
set -euo pipefail
# shellcheck source=tests/gui/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_work_folder "$1"

openbox > openbox.log 2>&1 &
manager=$!
pid=
trap 'kill $pid $manager 2> /dev/null || true' EXIT
manager_answers() { xdotool get_num_desktops > /dev/null 2>&1; }
wait_until 30 manager_answers || fail "openbox does not manage the display: $(cat openbox.log)"

window_opened() { xdotool search --onlyvisible --class sulfurchamber > window 2> /dev/null; }
picture_is_drawn() { take_picture "$1-start.png" && [[ $(colours_of "$1-start.png") -gt 1000 ]]; }
start_sandbox() {
    local name=$1
    shift
    "$sandbox" --width 1200 --height 800 "$@" > "$name.log" 2>&1 &
    pid=$!
    wait_until 30 window_opened || fail "no window; the sandbox said: $(cat "$name.log")"
    wait_until 30 picture_is_drawn "$name" || fail "the window stays empty"
    sleep 1
    xdotool windowfocus "$(tail -1 window)"
}
end_sandbox() {
    kill "$pid"
    wait "$pid" 2> /dev/null || true
    ! grep -E 'Gtk|GLib|Pixman' "$1.log" || fail "the toolkit complains; see $PWD/$1.log"
}
# Takes a picture when nothing changes any more: where processors are busy, the little pictures of the
# library come one by one for seconds.
stays() {
    mv "$1" before.png
    sleep 0.3
    take_picture "$1"
    (($(changed_pixels before.png "$1") < 200))
}
take_last_picture() {
    sleep 1
    take_picture "$1"
    sleep 0.5
    wait_until 60 stays "$1" || fail "the window changes for ever; see $PWD/$1"
}
# A page shows the same after the diagram came and went, with which everything is laid out anew.
page_is_whole() {
    xdotool key "$1"
    take_last_picture "page-$1.png"
    local changed
    changed=$(changed_pixels "$2-start.png" "page-$1.png")
    ((changed > 3000)) || fail "page $1 does not open; see $PWD/page-$1.png"
    xdotool key F8
    take_last_picture "page-$1-diagram.png"
    changed=$(changed_pixels "page-$1.png" "page-$1-diagram.png")
    ((changed > 3000)) || fail "no diagram opens; see $PWD/page-$1-diagram.png"
    xdotool key F8
    take_last_picture "page-$1-anew.png"
    changed=$(changed_pixels "page-$1.png" "page-$1-anew.png")
    ((changed < 2000)) || fail "page $1 was not laid out: $changed pixels; see $PWD/page-$1.png"
}

sandbox=$2
level=$3
# One start for each page: what is laid out anew once stays right.
for page in 2 3 4 5 6; do
    start_sandbox "page$page"
    [[ $page == 2 ]] && xdotool key ctrl+a
    page_is_whole "ctrl+$page" "page$page"
    end_sandbox "page$page"
done
start_sandbox level "$level"
page_is_whole ctrl+7 level
end_sandbox level

# An empty scene is 12 m wide, with its floor in the lower fifth: fitting it anew changes nothing.
start_sandbox view
take_picture view.png
xdotool key minus
sleep 1
take_picture view-small.png
changed=$(changed_pixels view.png view-small.png)
((changed > 1000)) || fail "nothing is zoomed; see $PWD/view-small.png"
xdotool key f
sleep 1
take_picture view-fit.png
changed=$(changed_pixels view.png view-fit.png)
((changed < 500)) || fail "the first view does not fit: $changed pixels; see $PWD/view.png"
end_sandbox view
