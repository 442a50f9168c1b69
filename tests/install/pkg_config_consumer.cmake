# The same programs with pkg-config and one call of the compiler each.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

set(folder ${work}/pkg_config_consumer)
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
set(ENV{PKG_CONFIG_PATH} ${prefix}/${libdir}/pkgconfig)
# A shared library in an unusual place must be findable when the program starts.
set(ENV{LD_LIBRARY_PATH} ${prefix}/${libdir})

function(compile program source_file module)
  run(${pkg_config} --cflags --libs ${module})
  separate_arguments(flags UNIX_COMMAND "${output}")
  run(${compiler} -std=c++20 -MD -MF ${folder}/${program}.d
    -o ${folder}/${program} ${source_file} ${flags})
  file(READ ${folder}/${program}.d dependencies)
  string(FIND "${dependencies}" ${source}/sulfur/include found)
  if(NOT found EQUAL -1)
    message("${dependencies}")
    message(FATAL_ERROR "${program} was compiled against the source tree")
  endif()
endfunction()

compile(hello ${source}/sulfur/examples/hello.cpp sulfur)
run(${folder}/hello)
expect_output("${output}" "${hello_expected}")

compile(scene_reader ${CMAKE_CURRENT_LIST_DIR}/consumer/scene_reader.cpp sulfur-scene)
run(${folder}/scene_reader)
expect_output("${output}" "${scene_expected}")
