# A program that was built from an exported scene moves it as the scene itself moves, to the bit.
foreach(ticks 0 1 300)
  execute_process(COMMAND ${WRITER} hash ${SCENE} ${ticks} OUTPUT_VARIABLE wanted COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${EXPORTED} ${ticks} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "hash [0-9a-f]+\n" is "${said}")
  if(NOT is STREQUAL wanted)
    message(FATAL_ERROR "after ${ticks} ticks the program has ${is}, the scene ${wanted}\n${said}")
  endif()
endforeach()
