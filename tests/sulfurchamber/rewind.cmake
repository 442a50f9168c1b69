# Time by mouse and keyboard: the time bar, its keys, branches and speeds.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(WRITE ${WORK}/rewind.txt "
tool box
drag -2 3 -1 4
tool jelly
drag 0.5 1.5 2 3
expect branches = 0
expect past.pictures = 0
run 2
expect branches = 1
await past.pictures > 4 20  # one strip of them above the line
screenshot ${WORK}/end.png
key Comma                   # one tick back
expect time < 1.9985
expect time > 1.9975
slide 0.9 0.4
expect time > 0.75
expect time < 0.85
expect playing = 0
expect past.card = 0        # the scene shows what is under the pointer
slide 0.8 0.8
expect past.card = 1        # a picture of what was there
slide 0.4 0.4
screenshot ${WORK}/back.png
key PageUp
expect time = 0
key End
expect time = 2
key Home
expect time = 0
key PageDown
expect time = 1
do mark-back                # the box lands
expect time < 1
expect time > 0
do oldest
do mark-on
expect time > 0
do second-on
do second-back
do newest
do tick-back
expect branches = 1         # looking alone changes nothing
seek 1
set gravity -5
expect branches = 2
run 1.5
expect time = 2.5
expect newest.y > 3
key Z                       # the future that was left
expect time = 2
expect newest.y < 2
expect branches = 2
key Z
expect time = 2.5
do undo                     # of the gravity
expect gravity > 9
expect time = 1
do slower
expect speed = 0.5
key Ctrl+Up
expect speed = 1
key Ctrl+Up
key Ctrl+Up
expect speed = 4
run 1
key Ctrl+Down
expect speed = 2
do speed-thousandth
expect speed = 0.001
run 0.002
do speed-hundredth
do speed-tenth
do speed-half
do speed-twice
do speed-four
do speed-normal
key M
expect speed = 0.25
do faster
expect speed = 0.5
do reset
expect time = 0
slide 0.1 0.5               # what ran before the reset is there still
expect time > 0
set gravity -30
run 4
expect strays > 0
seek 0
expect strays = 0
whole
do new
await past.pictures = 0 20  # they went with what was recorded
expect problem = 0
")
run_window(0 --script ${WORK}/rewind.txt)
run(0 ${PICTURE_CHECK} differ ${WORK}/end.png ${WORK}/back.png)
if("${out}${err}" MATCHES "BUG|CRITICAL|Gtk-WARNING")
  message(FATAL_ERROR "GTK complains: ${out}${err}")
endif()
