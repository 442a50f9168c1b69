# Read by CTest, before it runs anything: the cases of a GoogleTest program, one test for each suite.
# A program with the sanitizers takes 0.3 s to start and to look for leaks, longer than most cases run:
# in processes of their own, 1,200 of them would spend six minutes on that alone.
#
# Given are `program`, `prefix`, which names the build, and `long`, a filter of GoogleTest: each case
# of it is a test of its own with the label "long", and is left out of its suite.
cmake_policy(VERSION 3.25)
if(NOT EXISTS "${program}")
  cmake_path(GET program FILENAME name)
  add_test("${prefix}${name}_NOT_BUILT" "${name}_NOT_BUILT")
  return()
endif()
execute_process(COMMAND "${program}" --gtest_list_tests
  OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "." "\\." long_cases "^(${long})$")
string(REPLACE "*" ".*" long_cases "${long_cases}")
string(REPLACE ":" "|" long_cases "${long_cases}")

# A suite stands at the beginning of its line and ends with a dot, its cases are indented.
string(REGEX MATCHALL "[^\n]+" lines "${listed}")
set(suites)
foreach(line IN LISTS lines)
  string(REGEX REPLACE " *#.*" "" line "${line}")
  if(line MATCHES "^[^ ]+\\.$")
    set(suite "${line}")
  elseif(line MATCHES "^  ([^ ].*)$")
    set(case "${suite}${CMAKE_MATCH_1}")
    if(case MATCHES "DISABLED_")
      continue()
    elseif(case MATCHES "${long_cases}")
      add_test("${prefix}${case}" "${program}" "--gtest_filter=${case}")
      set_tests_properties("${prefix}${case}" PROPERTIES TIMEOUT 300 LABELS long)
    else()
      list(APPEND suites "${suite}")
    endif()
  endif()
endforeach()
list(REMOVE_DUPLICATES suites)
foreach(suite IN LISTS suites)
  string(REGEX REPLACE "\\.$" "" name "${prefix}${suite}")
  add_test("${name}" "${program}" "--gtest_filter=${suite}*-${long}")
  set_tests_properties("${name}" PROPERTIES TIMEOUT 900)
endforeach()
