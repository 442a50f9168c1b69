# A separate project that finds the library with find_package(sulfur).
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(REMOVE_RECURSE ${work}/cmake_consumer ${work}/cmake_consumer_build)
file(COPY ${CMAKE_CURRENT_LIST_DIR}/consumer/ DESTINATION ${work}/cmake_consumer)
file(COPY ${source}/sulfur/examples/hello.cpp DESTINATION ${work}/cmake_consumer)

run(${CMAKE_COMMAND} -S cmake_consumer -B cmake_consumer_build -G Ninja
  -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_PREFIX_PATH=${prefix}
  -DCMAKE_CXX_COMPILER=${compiler}
  -DCMAKE_CXX_COMPILER_LAUNCHER=${launcher})
run(${CMAKE_COMMAND} --build cmake_consumer_build --verbose)
string(FIND "${output}" "-I${source}/sulfur" found)
if(NOT found EQUAL -1)
  message("${output}")
  message(FATAL_ERROR "the consumer was compiled against the source tree")
endif()

run(cmake_consumer_build/hello)
expect_output("${output}" "${hello_expected}")
run(cmake_consumer_build/scene_reader)
expect_output("${output}" "${scene_expected}")

# A library that was asked for something that it does not have must say so.
file(WRITE ${work}/cmake_consumer_no/CMakeLists.txt
  "cmake_minimum_required(VERSION 3.25)\nproject(no LANGUAGES CXX)\n"
  "find_package(sulfur 0.1 CONFIG REQUIRED COMPONENTS cloth_tailor)\n")
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${work}/cmake_consumer_no -B ${work}/cmake_consumer_no/build -G Ninja
    -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${compiler}
  RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE output)
if(status EQUAL 0 OR NOT output MATCHES "cloth_tailor")
  message("${output}")
  message(FATAL_ERROR "an unknown component was not refused")
endif()
