# Each action of menus and keys on a document with something in it, all of it selected: none ends the
# program, none that is offered refuses, and undo takes back what it has changed, to the byte.
cmake_policy(SET CMP0057 NEW)  # IN_LIST
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

# They begin another document or end the program; the scripts beside do them.
set(but quit about new level-new open-text save lesson-build lesson-break lesson-soften lesson-measure
  lesson-rewind lesson-level template-edit)
string(REPLACE ";" " " but "${but}")
file(COPY ${SCENES}/car.json ${SCENES}/../../levels/09-frost-slug.json DESTINATION ${WORK})
file(WRITE ${WORK}/group.txt "open car.json\nplace 3 2 Pip\nplace 5 2 Pip\ndo select-all\ndo group\nsave grouped.json\n")
run_window(0 --script group.txt)

# every_action(<file> <ticks that have passed> <how many are done at least>)
macro(every_action scene ticks least)
  file(WRITE ${WORK}/round.txt "every-action ${scene} ${ticks} ${but}\n")
  run_window(0 --script round.txt)
  expect_text("${out}" "actions done: [0-9]+, never available:")
  string(REGEX REPLACE ".*actions done: ([0-9]+), never.*" "\\1" count "${out}")
  string(REGEX REPLACE ".*never available:([^\n]*).*" "\\1" names "${out}")
  if(count LESS ${least})
    message(FATAL_ERROR "less than ${least} actions with ${scene}:\n${out}")
  endif()
  string(REPLACE " " ";" names "${names}")
  if(DEFINED missed)
    set(both)
    foreach(name IN LISTS missed)
      if(name IN_LIST names)
        list(APPEND both ${name})
      endif()
    endforeach()
    set(missed ${both})
  else()
    set(missed ${names})
  endif()
endmacro()
every_action(car.json 0 135)
every_action(09-frost-slug.json 0 157)
every_action(grouped.json 20 142)

# These need more than a document: scripts beside, tests/gui or the model's tests do what they do.
set(elsewhere undo redo unlock-all show-all template-place template-update skin-place
  bring-back delete-strays second-on mark-back mark-on
  newest other-future level-problem plot-meters plot-all plot-clear level-edit level-stop level-medals
  lesson-show lesson-skip lesson-end)
foreach(name IN LISTS missed)
  if(NOT name STREQUAL "" AND NOT name IN_LIST elsewhere)
    message(FATAL_ERROR "nothing does the action ${name}")
  endif()
endforeach()
