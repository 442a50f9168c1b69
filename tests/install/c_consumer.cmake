# A project in C, with find_package and with pkg-config, and each of the headers for C alone.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(REMOVE_RECURSE ${work}/c_consumer ${work}/c_consumer_build)
file(COPY ${CMAKE_CURRENT_LIST_DIR}/c_consumer/ DESTINATION ${work}/c_consumer)
file(COPY ${source}/sulfur/examples/hello.c DESTINATION ${work}/c_consumer)
run(${CMAKE_COMMAND} -S c_consumer -B c_consumer_build -G Ninja
  -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_C_COMPILER=${c_compiler})
run(${CMAKE_COMMAND} --build c_consumer_build --verbose)
string(FIND "${output}" "-I${source}/sulfur" found)
if(NOT found EQUAL -1)
  message("${output}")
  message(FATAL_ERROR "the consumer was compiled against the source tree")
endif()
run(c_consumer_build/hello)
expect_output("${output}" "${hello_expected}")

set(ENV{PKG_CONFIG_PATH} ${prefix}/${libdir}/pkgconfig)
# A shared library in an unusual place must be findable when the program starts.
set(ENV{LD_LIBRARY_PATH} ${prefix}/${libdir})
run(${pkg_config} --cflags --libs sulfur-c)
separate_arguments(flags UNIX_COMMAND "${output}")
set(strict -std=c99 -pedantic -Wall -Wextra -Werror)
run(${c_compiler} ${strict} -o c_consumer/hello c_consumer/hello.c ${flags})
run(c_consumer/hello)
expect_output("${output}" "${hello_expected}")

file(GLOB headers RELATIVE ${prefix}/include ${prefix}/include/sulfur/c/*.h)
if(NOT headers)
  message(FATAL_ERROR "no header for C was installed")
endif()
foreach(header ${headers})
  file(WRITE ${work}/c_consumer/header.c
    "#include <${header}>\n#include <${header}>\nint nothing;\n")
  run(${c_compiler} ${strict} -c -o c_consumer/header.o c_consumer/header.c ${flags})
endforeach()
