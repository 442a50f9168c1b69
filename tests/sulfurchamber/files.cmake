# Opening, refusing, saving and opening again, in the window.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(WRITE ${WORK}/broken.json "{\"format\": \"sulfur-scene\", \"version\": 1, \"bodies\": 7}")
file(WRITE ${WORK}/script.txt "
open ${SCENES}/jelly-tower.json
expect bodies = 5
expect problem = 0
open ${WORK}/broken.json
expect problem = 1
expect bodies = 5           # the document is as it was
save ${WORK}/first.json
open ${WORK}/first.json
expect bodies = 5
save ${WORK}/second.json
tool ball
click 0 3.2
expect bodies = 6
expect modified = 1
save ${WORK}/planned.json
run 0.5
save ${WORK}/played.json     # the plan, not the moment
save-moment ${WORK}/moved.json
expect modified = 0
open ${WORK}/moved.json
expect bodies = 6
save ${WORK}/moved-again.json
")
run_window(0 --script ${WORK}/script.txt)
expect_text("${out}${err}" "broken.json:1:")
expect_same(${WORK}/first.json ${WORK}/second.json)
expect_same(${WORK}/planned.json ${WORK}/played.json)
expect_same(${WORK}/moved.json ${WORK}/moved-again.json)

# Where nothing can be written, nothing is, and the reason is told.
file(WRITE ${WORK}/unwritable.txt "save ${WORK}/broken.json/scene.json\n")
run_window(1 --script ${WORK}/unwritable.txt)
expect_text("${out}${err}" "unwritable.txt:1:")

run_window(0 --screenshot ${WORK}/window.png --at 0.5 --drop 5 ${SCENES}/bridge.json)
run(0 ${PICTURE_CHECK} colourful ${WORK}/window.png)
