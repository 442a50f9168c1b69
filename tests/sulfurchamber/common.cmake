# Shared by the scripts beside.
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
# No question to the session bus, no settings of the person who runs the tests.
set(ENV{NO_AT_BRIDGE} 1)
# GTK and the graphics driver keep memory to the end; the model's tests look for leaks.
set(ENV{ASAN_OPTIONS} detect_leaks=0)
set(ENV{GSETTINGS_BACKEND} memory)
set(ENV{XDG_CONFIG_HOME} ${WORK}/config)
set(ENV{XDG_STATE_HOME} ${WORK}/state)
set(ENV{XDG_DATA_HOME} ${WORK}/data)
set(ENV{XDG_CACHE_HOME} ${WORK}/cache)

# run(<expected exit code> <command>...): sets `out` and `err`.
macro(run expected)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err
    WORKING_DIRECTORY ${WORK} TIMEOUT 120)
  if(NOT "${code}" STREQUAL "${expected}")
    message(FATAL_ERROR "${ARGN}\nended with ${code}, expected ${expected}\n${out}\n${err}")
  endif()
endmacro()

# run_window(<expected exit code> <arguments of the program>...)
macro(run_window expected)
  run(${expected} ${XVFB_RUN} -a -s "-screen 0 1280x800x24" ${PROGRAM} ${ARGN})
endmacro()

function(expect_text text pattern)
  if(NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "expected to find \"${pattern}\" in\n${text}")
  endif()
endfunction()

function(expect_same a b)
  file(READ ${a} left)
  file(READ ${b} right)
  if(NOT left STREQUAL right)
    message(FATAL_ERROR "${a} and ${b} differ")
  endif()
endfunction()
