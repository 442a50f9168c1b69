# The installed programs start and find their files where they were moved to.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

set(ENV{LD_LIBRARY_PATH} ${prefix}/${libdir})
string(REPLACE "," ";" programs ${programs})
foreach(program ${programs})
  run(${prefix}/bin/${program} --version)
  expect_output("${output}" "[0-9]+\\.[0-9]+\\.[0-9]+")
  run(${prefix}/bin/${program} --help)
  expect_output("${output}" "--version")
endforeach()

file(GLOB levels ${prefix}/share/sulfur/levels/*.json)
list(FILTER levels EXCLUDE REGEX "schema\\.json$")
if(NOT levels)
  message(FATAL_ERROR "no level was installed")
endif()
run(${prefix}/bin/quaoar --headless --verify ${levels})

# The picture needs the assets; a copy of the source tree that could help out is not here.
set(ENV{SDL_VIDEODRIVER} offscreen)
list(GET levels 0 level)
run(${prefix}/bin/quaoar --screenshot ${work}/level.png --level ${level} --at 0)
