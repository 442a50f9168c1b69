# Each key of the program, really pressed on a scene with all of it selected, does its action, and undo
# takes back what it has changed; no two actions have one key.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

# They begin another document, open a window of their own or end the program; the last ones need Shift,
# which keyboards put elsewhere.
set(but quit new level-new open-text save gallery fullscreen larger zoom-in grid demo)
string(REPLACE ";" " " but "${but}")
file(COPY ${SCENES}/car.json DESTINATION ${WORK})
# every_key(<ticks that have passed> <how many are pressed at least>)
macro(every_key ticks least)
  file(WRITE ${WORK}/round.txt "every-key car.json ${ticks} ${but}\n")
  run_window(0 --script round.txt)
  expect_text("${out}" "actions done: [0-9]+, never available:")
  string(REGEX REPLACE ".*actions done: ([0-9]+), never.*" "\\1" count "${out}")
  if(count LESS ${least})
    message(FATAL_ERROR "less than ${least} keys:\n${out}")
  endif()
endmacro()
every_key(0 87)
every_key(20 91)
