# What the scripts of this folder share. The installed tree is ${work}/prefix.
set(prefix ${work}/prefix)

# run(<command>...): stops the test with the command's output unless it succeeds. Leaves what it
# wrote in `output`.
function(run)
  execute_process(COMMAND ${ARGN}
    WORKING_DIRECTORY ${work}
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    string(JOIN " " command ${ARGN})
    message("${command}\n${output}")
    message(FATAL_ERROR "the command above failed (${status})")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# expect_output(<output> <regular expression>)
function(expect_output output expected)
  if(NOT output MATCHES "${expected}")
    message("${output}")
    message(FATAL_ERROR "the output above is not what was expected: ${expected}")
  endif()
endfunction()

# The crate of hello.cpp starts 3 m up, has fallen 1.23 m after half a second (g t^2 / 2), and
# lies on the floor, which is 0.05 m thick above its line, from the second second on.
set(hello_expected
  "^0\\.0 s: 3\\.00 m\n0\\.5 s: 1\\.77 m\n1\\.0 s: 0\\.5[0-9] m\n1\\.5 s: 0\\.55 m\n2\\.0 s: 0\\.55 m\n$")
set(scene_expected "^drop: 2 bodies; the ball is at 0\\.30 m after 2 s\n$")
