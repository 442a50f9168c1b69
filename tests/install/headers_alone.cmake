# Every public header compiles on its own, whatever was or was not included before it.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

set(folder ${work}/headers_alone)
file(REMOVE_RECURSE ${folder})
file(GLOB_RECURSE headers RELATIVE ${prefix}/include ${prefix}/include/*.hpp)
if(NOT headers)
  message(FATAL_ERROR "no header was installed")
endif()
set(sources)
foreach(header ${headers})
  string(MAKE_C_IDENTIFIER ${header} name)
  file(WRITE ${folder}/${name}.cpp "#include <${header}>\n#include <${header}>\n")
  list(APPEND sources ${name}.cpp)
endforeach()
list(JOIN sources " " sources)
file(WRITE ${folder}/CMakeLists.txt
  "cmake_minimum_required(VERSION 3.25)\n"
  "project(headers_alone LANGUAGES CXX)\n"
  "find_package(sulfur CONFIG REQUIRED)\n"
  "add_library(headers OBJECT ${sources})\n"
  "target_link_libraries(headers PRIVATE sulfur::scene)\n")
run(${CMAKE_COMMAND} -S ${folder} -B ${folder}/build -G Ninja
  -DCMAKE_PREFIX_PATH=${prefix}
  -DCMAKE_CXX_COMPILER=${compiler}
  -DCMAKE_CXX_COMPILER_LAUNCHER=${launcher})
run(${CMAKE_COMMAND} --build ${folder}/build)
