# The installed programs start and find their files where they were moved to.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

string(REPLACE "," ";" programs ${programs})
foreach(program ${programs})
  run(${prefix}/bin/${program} --version)
  expect_output("${output}" "[0-9]+\\.[0-9]+\\.[0-9]+")
  run(${prefix}/bin/${program} --help)
  expect_output("${output}" "--version")
endforeach()

foreach(wanted levels/01-cold-wake.json levels/01-cold-wake.proof levels/level.schema.json
    quaoar/hero.svg scenes/boxes.json)
  if(NOT EXISTS ${prefix}/share/sulfur/${wanted})
    message(FATAL_ERROR "share/sulfur/${wanted} was not installed")
  endif()
endforeach()
run(${prefix}/bin/quaoar --headless --verify ${prefix}/share/sulfur/levels/01-cold-wake.json)
expect_output("${output}" "01-cold-wake +finished")
run(${prefix}/bin/quaoar --screenshot ${work}/level.png --at 0
  --level ${prefix}/share/sulfur/levels/01-cold-wake.json)
