# Installs to one place and moves it to another, which only works when no path is built in.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})
run(${CMAKE_COMMAND} --install ${build} --prefix ${work}/staging)
file(RENAME ${work}/staging ${prefix})

foreach(wanted
    include/sulfur/sulfur.hpp
    include/sulfur/scene.hpp
    include/sulfur/c/sulfur.h
    ${libdir}/libsulfur_c.so
    ${libdir}/cmake/sulfur/sulfurConfig.cmake
    ${libdir}/pkgconfig/sulfur.pc
    ${libdir}/pkgconfig/sulfur-c.pc
    ${libdir}/pkgconfig/sulfur-scene.pc
    share/sulfur/scene.schema.json
    share/doc/sulfur/LICENSE
    share/doc/sulfur/README.md)
  if(NOT EXISTS ${prefix}/${wanted})
    message(FATAL_ERROR "${wanted} was not installed")
  endif()
endforeach()

# The text that others' builds read must not lead back to this checkout.
file(GLOB_RECURSE texts ${prefix}/include/* ${prefix}/${libdir}/*.cmake ${prefix}/${libdir}/*.pc)
foreach(text ${texts})
  file(READ ${text} content)
  string(FIND "${content}" ${source} found)
  if(NOT found EQUAL -1)
    message(FATAL_ERROR "${text} names the source tree, ${source}")
  endif()
endforeach()

# The README shows the example as it is.
file(READ ${source}/README.md readme)
file(READ ${source}/sulfur/examples/hello.cpp example)
string(FIND "${readme}" "```cpp\n${example}```" found)
if(found EQUAL -1)
  message(FATAL_ERROR "the example in README.md is not sulfur/examples/hello.cpp")
endif()
