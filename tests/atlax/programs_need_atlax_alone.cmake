# The game, the example and what the sandbox shows need nothing of SDL, wxWidgets or OpenGL beside
# atlax; the sandbox's panels are of wxWidgets, but take nothing from it that atlax offers.
#   cmake -Dsource=<source tree> -P programs_need_atlax_alone.cmake
set(wrong)
set(count 0)

# forbid(<folder> <pattern of headers>...): no file below may include one.
macro(forbid folder)
  file(GLOB_RECURSE files ${source}/${folder}/*.hpp ${source}/${folder}/*.cpp)
  if(NOT files)
    message(FATAL_ERROR "there are no sources in ${folder}")
  endif()
  foreach(file ${files})
    math(EXPR count "${count} + 1")
    file(STRINGS ${file} includes REGEX "^#include")
    foreach(pattern ${ARGN})
      if("${includes}" MATCHES "[<\"]${pattern}")
        list(APPEND wrong "${file} includes ${pattern}")
      endif()
    endforeach()
  endforeach()
endmacro()

foreach(folder quaoar atlax/example atlax/tools atlax/core/include sulfurchamber/level sulfurchamber/model
    sulfurchamber/view)
  forbid(${folder} SDL wx/ GL/ epoxy/ EGL/ AL/)
endforeach()
forbid(sulfurchamber/app SDL GL/ epoxy/ AL/ wx/glcanvas wx/timer wx/clipbrd wx/filedlg wx/config
  wx/fileconf wx/dnd wx/sound wx/joystick)

if(wrong)
  list(JOIN wrong "\n  " wrong)
  message(FATAL_ERROR "these need more than atlax:\n  ${wrong}")
endif()
message(STATUS "${count} files")
