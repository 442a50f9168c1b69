# What is refused before a window opens. There is no display here.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
unset(ENV{DISPLAY})
unset(ENV{WAYLAND_DISPLAY})

run(0 ${PROGRAM} --version)
expect_text("${out}" "^sulfurchamber [0-9]+\\.[0-9]+\\.[0-9]+")
run(0 ${PROGRAM} --help)
expect_text("${out}" "--screenshot")
run(0 ${PROGRAM} --script-help)
expect_text("${out}" "click X Y")

execute_process(COMMAND ${PROGRAM} --no-such-option RESULT_VARIABLE code ERROR_VARIABLE err OUTPUT_QUIET)
if(code EQUAL 0)
  message(FATAL_ERROR "an unknown option was accepted")
endif()

# A broken file: one sentence with file and line, exit 1.
file(WRITE ${WORK}/broken.json "{\n  \"format\": \"sulfur-scene\",\n  \"version\": 1,\n  \"bodies\": [\n")
run(1 ${PROGRAM} ${WORK}/broken.json)
expect_text("${err}" "broken.json:[0-9]+:")
run(1 ${PROGRAM} ${WORK}/not-there.json)
expect_text("${err}" "not-there.json")

# Without a display the window is refused with a remedy.
run(1 ${PROGRAM} ${SCENES}/boxes.json)
expect_text("${err}" "no display")
