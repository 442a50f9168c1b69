# Measuring by mouse and menus: what is plotted, cursor, zoom, fits and export.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(WRITE ${WORK}/fall.txt "
screenshot ${WORK}/before.png
tool box
drag 0 5 1 6
tool select
click 0.5 5.5
do plot
expect series = 2           # height and energy
expect samples = 0
do plot-energy
do plot-height
do plot-velocity-y
expect series = 1
run 0.9
expect samples = 450
do fit-line
expect plot.fit < -9.80
expect plot.fit > -9.82
do fit-mean
expect plot.fit < -4
expect plot.fit > -5
plot-drag 0.5 0.5           # the cursor in the middle: half a second of the second that is shown
expect plot.cursor < -4.8
expect plot.cursor > -5.0
screenshot ${WORK}/plot.png
plot-drag 0.2 0.6
expect plot.from > 0.19
expect plot.from < 0.22
expect plot.to > 0.58
expect plot.to < 0.62
plot-wheel 0.5 -9           # away: all again
expect plot.from < 0.01
plot-wheel 0.5 3
expect plot.from > 0.1
do plot-all
expect plot.from < 0.01
do fit-none
seek 0.5
expect samples = 450        # looking back forgets nothing
run 0.1
expect samples = 300        # going on replaces what came later
save-plot ${WORK}/fall.csv
save-plot ${WORK}/fall.png
whole
")
foreach(key x angle speed velocity-x spin kinetic potential elastic momentum-x momentum-y joint-force
    strain contact-force)
  file(APPEND ${WORK}/fall.txt "do plot-${key}\n")
endforeach()
file(APPEND ${WORK}/fall.txt "expect series = 12          # no more
run 0.1
screenshot ${WORK}/all.png
do plot-clear
expect samples = 0
do plot
expect problem = 0
")
run_window(0 --script ${WORK}/fall.txt)
if("${out}${err}" MATCHES "BUG|CRITICAL|Gtk-WARNING")
  message(FATAL_ERROR "GTK complains: ${out}${err}")
endif()
run(0 ${PICTURE_CHECK} differ ${WORK}/before.png ${WORK}/plot.png)
file(SIZE ${WORK}/fall.png bytes)
if(bytes LESS 4000)
  message(FATAL_ERROR "the picture of the diagram has ${bytes} bytes")
endif()
file(STRINGS ${WORK}/fall.csv lines)
list(LENGTH lines count)
list(GET lines 0 head)
if(NOT count EQUAL 301 OR NOT head STREQUAL "time/s,Vertical velocity of box/m/s")
  message(FATAL_ERROR "the table has ${count} lines and begins with ${head}")
endif()

# A pendulum of 1.2 m: its sine has the frequency of its length, a little less as it swings far.
file(WRITE ${WORK}/pendulum.txt "
open ${SCENES}/pendulum.json
do plot
do plot-energy
do plot-height
expect series = 0
do plot-x
do select-all
expect series = 3
do trails
run 6
do fit-sine
expect plot.fit > 0.36
expect plot.fit < 0.46
screenshot ${WORK}/pendulum.png
whole
")
run_window(0 --script ${WORK}/pendulum.txt)

# Meters by mouse: placed, plotted, moved, deleted; the page with them; forces with their legend.
file(WRITE ${WORK}/meters.txt "
open ${SCENES}/textbook-spring.json
expect meters = 2
expect meter.ruler = 1
do page-measure
do tool-tracer
click 0 2
do tool-gun
drag -1.5 1.7 1.5 1.7
do tool-protractor
drag -1 3 -0.2 3
click -0.2 3.8
expect meters = 5
expect meter.protractor > 44
expect meter.protractor < 46
expect steps = 3
do gravity
do joint-forces
do contact-forces
do strain
do velocities
run 4
expect measured > 0.99
expect measured < 1
expect difference < 0.002
expect difference > -0.002
expect meter.ruler > 1
expect meter.gun > 0
screenshot ${WORK}/meters.png
do plot-meters
expect selected = 5
expect series > 6
screenshot ${WORK}/readings.png
whole
tool select
click 0 3.9                 # nothing: the selection ends
expect selected = 0
drag -1 3 -1.4 3.4          # the corner of the angle
expect steps = 4
expect selected = 1
key Delete
expect meters = 4
key Ctrl+Z
key Ctrl+Z
expect meters = 5
save ${WORK}/meters.json
open ${WORK}/meters.json
expect meters = 5
expect problem = 0
")
run_window(0 --script ${WORK}/meters.txt)
if("${out}${err}" MATCHES "BUG|CRITICAL|Gtk-WARNING")
  message(FATAL_ERROR "GTK complains: ${out}${err}")
endif()
run(0 ${PICTURE_CHECK} differ ${WORK}/meters.png ${WORK}/readings.png)

# The paper's Table 4 runs beside the scene, which goes on.
file(WRITE ${WORK}/table4.txt "
do table4
run 0.2
table4 0.5
expect table4.cells = 7
whole                       # no column is cut, no number without its unit
save-table4 ${WORK}/table4.csv
save-table4 ${WORK}/table4.png
screenshot ${WORK}/table4_window.png
expect problem = 0
")
run_window(0 --script ${WORK}/table4.txt)
file(STRINGS ${WORK}/table4.csv lines)
list(LENGTH lines count)
list(GET lines 0 head)
list(GET lines 4 ours)
if(NOT count EQUAL 5 OR NOT head MATCHES ",20,40,60,80,100,150,200$" OR NOT ours MATCHES
    "^this machine(,[0-9.]+)+$")
  message(FATAL_ERROR "the table of the paper is ${lines}")
endif()
file(SIZE ${WORK}/table4.png bytes)
if(bytes LESS 4000)
  message(FATAL_ERROR "the picture of the paper's table has ${bytes} bytes")
endif()

# Also in a small window nothing is cut.
file(WRITE ${WORK}/small.txt "tool box\nclick 0 3\ndo plot\ndo page-measure\nrun 0.5\nwhole\nscreenshot ${WORK}/small.png\n")
foreach(size 640x480 900x600)
  string(REPLACE "x" ";" sides ${size})
  list(GET sides 0 width)
  list(GET sides 1 height)
  run(0 ${XVFB_RUN} -a -s "-screen 0 ${size}x24" ${PROGRAM} --width ${width} --height ${height} --script
    ${WORK}/small.txt)
  if("${out}${err}" MATCHES "BUG|CRITICAL|Gtk-WARNING")
    message(FATAL_ERROR "GTK complains: ${out}${err}")
  endif()
endforeach()
