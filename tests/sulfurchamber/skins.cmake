# Pictures on bodies: dropped, chosen, placed by handles, saved beside the scene.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(MAKE_DIRECTORY ${WORK}/away ${WORK}/scenes)
file(COPY_FILE ${TEMPLATES}/skins/crate.svg ${WORK}/away/mine.svg)
file(WRITE ${WORK}/skins.txt "
tool box
drag -1 1 1 3
tool select
click 4 5
screenshot ${WORK}/plain.png
drop ${WORK}/away/mine.svg 4 4 wear
expect problem = 1          # nothing is there
drop ${WORK}/away/mine.svg 0 2
expect skins = 1
expect selected = 1
screenshot ${WORK}/dressed.png
do skin-place
screenshot ${WORK}/handles.png
drag 0 2 0.4 2.2
expect steps = 3
do undo
do redo
do skin-fit
expect steps = 4
do skin-remove
expect skins = 0
do undo
skin ${TEMPLATES}/skins/pip.svg
expect skins = 1
do page-object
screenshot ${WORK}/page.png
save ${WORK}/scenes/dressed.json
")
run_window(0 --script ${WORK}/skins.txt)
run(0 ${PICTURE_CHECK} differ ${WORK}/plain.png ${WORK}/dressed.png)
run(0 ${PICTURE_CHECK} differ ${WORK}/dressed.png ${WORK}/handles.png)
if(NOT EXISTS ${WORK}/scenes/skins/pip.svg)
  message(FATAL_ERROR "the picture was not copied beside the scene")
endif()
