# A picture of the drawing area needs no display.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
unset(ENV{DISPLAY})
unset(ENV{WAYLAND_DISPLAY})

run(0 ${PROGRAM} --picture ${WORK}/start.png --width 640 --height 400 ${SCENES}/boxes.json)
run(0 ${PROGRAM} --picture ${WORK}/later.png --width 640 --height 400 --at 1 ${SCENES}/boxes.json)
run(0 ${PROGRAM} --picture ${WORK}/again.png --width 640 --height 400 --at 1 ${SCENES}/boxes.json)
run(0 ${PICTURE_CHECK} colourful ${WORK}/start.png)
run(0 ${PICTURE_CHECK} differ ${WORK}/start.png ${WORK}/later.png)
# The same scene at the same tick is the same picture.
run(0 ${PICTURE_CHECK} same ${WORK}/later.png ${WORK}/again.png)
# The scene is light in a light theme, and dark otherwise.
run(0 ${PROGRAM} --picture ${WORK}/light.png --width 640 --height 400 --theme light ${SCENES}/boxes.json)
run(0 ${PICTURE_CHECK} light ${WORK}/light.png)
run(1 ${PICTURE_CHECK} light ${WORK}/start.png)
