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
key 3
drag -3.2 3.4 -1.5 1.7
expect modified = 0
do fit-sine
expect plot.fit > 0.36
expect plot.fit < 0.46
screenshot ${WORK}/pendulum.png
whole
")
run_window(0 --script ${WORK}/pendulum.txt)

# Also in a small window nothing is cut.
file(WRITE ${WORK}/small.txt "tool box\nclick 0 3\ndo plot\nrun 0.5\nwhole\nscreenshot ${WORK}/small.png\n")
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
