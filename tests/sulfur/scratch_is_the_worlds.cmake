# Scratch memory belongs to a world, which counts it, gives it back when it goes, and may be stepped
# by another thread in every tick. What belonged to a thread would outlive all worlds, and what one of
# them leaves there another could read.
#   cmake -Dsource=<folder> -P scratch_is_the_worlds.cmake
set(wrong)
file(GLOB_RECURSE files ${source}/*.hpp ${source}/*.cpp ${source}/*.ipp)
foreach(file ${files})
  file(STRINGS ${file} found REGEX "thread_local")
  if(found)
    list(APPEND wrong "${file}")
  endif()
endforeach()
list(LENGTH files count)
if(count LESS 100)
  message(FATAL_ERROR "only ${count} sources were found in ${source}")
endif()
if(wrong)
  list(JOIN wrong "\n  " wrong)
  message(FATAL_ERROR "these have memory that belongs to threads:\n  ${wrong}")
endif()
message(STATUS "${count} files")
