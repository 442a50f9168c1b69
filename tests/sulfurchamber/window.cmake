# The window, driven by real clicks and keys of the X server; no window manager runs.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(WRITE ${WORK}/drop.txt "
expect bodies = 1
expect modified = 0
tool box
screenshot ${WORK}/empty.png
click 0.5 3
expect bodies = 2
expect modified = 1
expect newest.y > 2.9
key Ctrl+Z
expect bodies = 1
do redo
expect bodies = 2
screenshot ${WORK}/above.png
run 0.85
expect newest.y < 0.5      # it fell
expect newest.y > 0        # and the floor holds it
expect contacts > 0
key Space
expect playing = 1
key Space
expect playing = 0
screenshot ${WORK}/below.png
expect particles = 7
key Period                  # one tick
expect playing = 0
do reset
expect newest.y > 2.9
do undo                     # of the reset
expect newest.y < 0.5
do reset
do undo
do undo                     # of the reset and of the box
expect bodies = 1
do redo
expect bodies = 2
")
run_window(0 --script ${WORK}/drop.txt)
foreach(name empty above below)
  run(0 ${PICTURE_CHECK} colourful ${WORK}/${name}.png)
endforeach()
run(0 ${PICTURE_CHECK} differ ${WORK}/empty.png ${WORK}/above.png)
run(0 ${PICTURE_CHECK} differ ${WORK}/above.png ${WORK}/below.png)

# Dragging a body with the spring while time runs, selecting, deleting, cutting.
file(WRITE ${WORK}/drag.txt "
tool box
click 0 0.5
run 1
tool select
do play
hold 0 0.3 1.5 2 1.5
expect newest.x > 0.8
do play
expect playing = 0
do select-all
expect selected = 2
do copy
do paste                    # from the X server's clipboard
expect bodies = 4
do undo
expect bodies = 2
do select-all
key Escape
expect selected = 0
wheel 0 1 3
set gravity 3
expect gravity = 3
do undo
expect gravity > 9
set rain 20
run 1
expect bodies > 15
set rain 0
expect problem = 0
")
run_window(0 --script ${WORK}/drag.txt)

# A script that expects the wrong thing fails and says where.
file(WRITE ${WORK}/wrong.txt "expect bodies = 1\nexpect bodies = 5\n")
run_window(1 --script ${WORK}/wrong.txt)
expect_text("${out}${err}" "wrong.txt:2: bodies is 1, expected = 5")

# Nothing is cut, whatever the size and the tool, and nothing complains on the terminal.
foreach(size 640x480 900x600 1280x800 3840x2160)
  string(REPLACE "x" ";" sides ${size})
  list(GET sides 0 width)
  list(GET sides 1 height)
  set(script "open ${SCENES}/jelly-tower.json\n")
  set(tools select box ball wheel polygon wall ground jelly draw cloth rope chain bridge particle joint hinge motor
    weld spring cable winch slider axle pulley gear thruster wind gravity conveyor liquid pin cut erase measure)
  if(width GREATER 3000)
    set(tools box)  # what is drawn by software there takes its time
  endif()
  foreach(tool IN LISTS tools)
    string(APPEND script "tool ${tool}\nwhole\n")
  endforeach()
  string(APPEND script "do page-object\nwhole\ndo select-all\nwhole\ndo page-history\nwhole\ndo page-outline\nwhole\n")
  # Numbers of many digits, and a verdict of two lines.
  string(APPEND script "do new\ndo page-object\ntool jelly\ndrag 2 3 3 4\nproperty mass 4985.12\nproperty x -13.642\n"
    "whole\nopen ${SCENES}/../../levels/01-cold-wake.json\ndo page-level\nwhole\n"
    "open ${SCENES}/jelly-tower.json\n")
  file(WRITE ${WORK}/whole.txt "${script}screenshot ${WORK}/${size}.png\nrun 0.2\nwhole\n")
  run(0 ${XVFB_RUN} -a -s "-screen 0 ${size}x24" ${PROGRAM} --width ${width} --height ${height}
    --script ${WORK}/whole.txt)
  if("${out}${err}" MATCHES "BUG|CRITICAL|Gtk-WARNING")
    message(FATAL_ERROR "GTK complains: ${out}${err}")
  endif()
endforeach()

# Undo says what it undoes; what has left is counted and comes back; paste goes to the mouse.
file(WRITE ${WORK}/edit.txt "
label undo Undo
tool ball
click 2 3
label undo Undo “Add ball”
do undo
label redo Redo “Add ball”
do redo
tool select
click 2 3
do copy
click -3 4
do paste
expect bodies = 3
expect newest.x < -2.9
expect newest.x > -3.1
set gravity -30
run 4
expect strays = 2
screenshot ${WORK}/strays.png
set gravity 9.81
do bring-back
expect strays = 0
expect newest.y < 5
set gravity -30
run 4
expect strays = 2
do delete-strays
expect strays = 0
expect bodies = 1
do undo
expect bodies = 3
")
run_window(0 --script ${WORK}/edit.txt)

# Properties of one and of many, in a running world too.
file(WRITE ${WORK}/properties.txt "
do page-object
tool box
click -2 3
tool jelly
click 2 3
tool select
click -2 3
expect selected = 1
expect property.mass = 1
property mass 5
expect property.mass = 5
label undo Undo “Change mass”
run 0.3
material steel
expect property.density > 77
do select-all
screenshot ${WORK}/many.png
do reset
do undo                     # of the reset
do undo                     # of the steel
click -2 2.6
expect property.mass = 5
expect problem = 0
do nudge-up
do turn-left
label undo Undo “Turn”
do mirror
do larger
expect property.mass > 5.9
screenshot ${WORK}/handles.png
do page-object
select box
colour cc2211
whole
expect swatch = 1
do select-all
whole
expect swatch = 3           # red, soft, and the blue floor
screenshot ${WORK}/colours.png
do page-history
screenshot ${WORK}/history.png
")
run_window(0 --script ${WORK}/properties.txt)

# Order: groups, locks, what is hidden, in line, and the page that lists it all.
file(WRITE ${WORK}/order.txt "
tool box
click -3 2
click 0 3
click 3 4
do page-outline
expect outline-rows = 4
outline name 2
expect selected = 1
outline lock 1              # the floor
expect locked = 1
do select-all
expect selected = 3
do align-top
do distribute-across
do front
do back
do undo
do undo
do undo
do undo
do group
label undo Undo “Group”
expect outline-rows = 5
outline arrow 2
expect outline-rows = 2
tool select
key Escape
click 0 3
expect selected = 3
outline arrow 2
outline search box2
expect outline-rows = 2
outline eye 2
expect hidden = 1
outline lock 2
expect locked = 2
screenshot ${WORK}/outline.png
outline search -
screenshot ${WORK}/outline-all.png
do show-all
do unlock-all
expect hidden = 0
expect locked = 0
outline double 3
expect zoom < 0.01
do fit
outline name 2
expect selected = 3
do ungroup
do lock
expect locked = 3
do unlock-all
key Escape
outline name 2
do hide
expect hidden = 1
do show-all
expect problem = 0
")
run_window(0 --script ${WORK}/order.txt)

# Numbers of the selection, and handles at work.
file(WRITE ${WORK}/place.txt "
do snap-corners
do snap-centres
do snap-angles
tool box
click 0 3
tool select
click 0 3
do page-object
property x 1
property angle 30
property frame-width 2
expect property.frame-width > 1.99
expect property.angle > 29.9
expect property.x > 0.99
screenshot ${WORK}/frame.png
expect problem = 0
")
run_window(0 --script ${WORK}/place.txt)
