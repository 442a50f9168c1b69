# Templates in the window: the library and its pictures, dragging one into the scene, making one of
# a selection, instances that follow.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(WRITE ${WORK}/place.txt "
library car
screenshot ${WORK}/library.png
expect templates > 0
drop-template 0 1
expect instances = 1
expect bodies = 4
expect selected = 3
expect overrides = 0
expect modified = 1
key Ctrl+Z
expect bodies = 1
library seesaw
do template-place
click 2 1                   # the next click places it
expect instances = 1
expect selected = 4
click 5 5                   # and then one selects again
expect instances = 1
expect selected = 0
do undo
place 0 0.1 Pip
place 2 0.1 Pip
expect instances = 2
property mass 4
expect overrides = 1
do page-object
screenshot ${WORK}/override.png
do page-library
screenshot ${WORK}/differs.png
do template-apply
expect overrides = 0
do undo
expect overrides = 1
do template-reset
expect overrides = 0
property mass 5
do template-update
expect overrides = 0
do template-unlink
expect instances = 1
do undo
expect instances = 2
do select-all
save-template Twosome
expect instances = 1
library twosome
expect templates = 1
expect problem = 0
save ${WORK}/scene.json
")
run_window(0 --script ${WORK}/place.txt)
foreach(name library override differs)
  run(0 ${PICTURE_CHECK} colourful ${WORK}/${name}.png)
endforeach()
# One's own templates and the pictures have their folders.
if(NOT EXISTS ${WORK}/data/sulfurchamber/templates/twosome.json OR
   NOT EXISTS ${WORK}/data/sulfurchamber/templates/pip.json)
  message(FATAL_ERROR "the templates were not saved")
endif()
file(GLOB pictures ${WORK}/cache/sulfurchamber/thumbnails/*.png)
if(NOT pictures)
  message(FATAL_ERROR "no picture was kept")
endif()

# A template's file that falls on the window is placed, a scene opens.
file(WRITE ${WORK}/drop.txt "
drop ${TEMPLATES}/snowman.json 0 1
expect instances = 1
expect modified = 1
drop ${SCENES}/boxes.json 0 1
expect instances = 0
expect modified = 0
expect problem = 0
drop ${WORK}/nothing.json 0 1
expect problem = 1
")
run_window(0 --script ${WORK}/drop.txt)

# The file of a template is edited as a scene of its own: one of the program's is copied first. A scene
# keeps the version that it has until it takes that of the library.
file(WRITE ${WORK}/edit.txt "
place 0 0.1 Snowman
save ${WORK}/snow.json
library snowman
do template-edit
expect instances = 0
expect bodies = 5
expect modified = 0
select belly
expect property.mass = 20
property mass 33
do save
expect modified = 0
open ${WORK}/snow.json
select belly
expect property.mass = 20
expect instances = 1
do template-take
select belly
expect property.mass = 33
expect steps = 1
expect overrides = 0
do undo
select belly
expect property.mass = 20
do new
place 0 0.1 Snowman         # what is placed from now on is the new version
select belly
expect property.mass = 33
expect problem = 0
")
run_window(0 --script ${WORK}/edit.txt)
if(NOT EXISTS ${WORK}/data/sulfurchamber/templates/snowman.json)
  message(FATAL_ERROR "the template of the program was not copied")
endif()
