# Who compiles as C++17 is told first, by any header that needs more, what to do.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

set(ENV{PKG_CONFIG_PATH} ${prefix}/${libdir}/pkgconfig)
run(${pkg_config} --cflags sulfur)
separate_arguments(flags UNIX_COMMAND "${output}")
foreach(header sulfur world body blueprint ids queries shapes)
  file(WRITE ${work}/cpp17.cpp "#include <sulfur/${header}.hpp>\n")
  execute_process(
    COMMAND ${compiler} -std=c++17 -fsyntax-only ${flags} ${work}/cpp17.cpp
    RESULT_VARIABLE status ERROR_VARIABLE output)
  string(REGEX MATCH "error:[^\n]*" first "${output}")
  if(status EQUAL 0 OR NOT first MATCHES "needs C\\+\\+20")
    message("${output}")
    message(FATAL_ERROR "sulfur/${header}.hpp, compiled as C++17, does not say first what it needs")
  endif()
endforeach()
