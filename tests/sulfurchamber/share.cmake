# Files that are dropped, outlines that become bodies, scenes that go elsewhere.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(WRITE ${WORK}/cat.svg "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>
<g transform='translate(0 5)'>
<path id='cat' fill='#d08030' d='M20 80 C5 60 10 40 25 35 L22 12 L38 26 Q50 20 62 26 L78 12 L75 35 C90 40 95 60 80 80 Z'/>
</g>
<path id='ring' fill-rule='evenodd' d='M110 50a20 20 0 1 0 40 0a20 20 0 1 0 -40 0z M120 50a10 10 0 1 0 20 0a10 10 0 1 0 -20 0z'/>
</svg>")
file(WRITE ${WORK}/bad.svg "<svg><path d='M0 0 L1'/></svg>")
file(WRITE ${WORK}/rube.json [[{"allowSleep": true, "gravity": {"x": 0, "y": -10}, "body": [
  {"name": "post", "type": 0, "position": {"x": 0, "y": 4}, "fixture": [{"circle": {"center": 0, "radius": 0.1}}]},
  {"name": "bob", "type": 2, "position": {"x": 1, "y": 4}, "fixture": [{"circle": {"center": 0, "radius": 0.3}}]}],
  "joint": [{"type": "rope", "bodyA": 0, "bodyB": 1, "anchorA": 0, "anchorB": 0, "maxLength": 1}],
  "image": []}]])
file(WRITE ${WORK}/share.txt "
drop ${WORK}/cat.svg 0 3
expect bodies = 3
expect selected = 2
label undo Undo “Import cat”
screenshot ${WORK}/cat.png
do undo
expect bodies = 1
import ${WORK}/cat.svg soft 3
expect bodies = 3
expect particles > 100
run 3
expect contacts > 0
export-cpp ${WORK}/scene.cpp
do play
film ${WORK}/film.png
do play
do reset
expect problem = 0
do select-all
do copy-scene
do new
expect bodies = 1
do open-text
expect bodies = 3
do new
do paste
expect bodies = 4
expect problem = 0
drop ${SCENES}/jelly-tower.json 0 2 add
expect bodies > 4
drop ${SCENES}/rope.json 0 2
label undo Undo
open ${WORK}/rube.json
expect bodies = 2
expect modified = 0
drop ${WORK}/rube.json 0 4 add
expect bodies = 4
expect problem = 0
drop ${WORK}/bad.svg 0 2 outline
expect problem = 1
")
run_window(0 --script ${WORK}/share.txt)
expect_text("${out}${err}" "bad.svg: holds no closed outline")
expect_text("${out}${err}" "This was left out: images")
run(0 ${PICTURE_CHECK} colourful ${WORK}/cat.png)
run(0 ${PICTURE_CHECK} colourful ${WORK}/film.png)
file(READ ${WORK}/film.png film HEX)
expect_text("${film}" "6163544c")  # the chunk acTL: it moves
file(READ ${WORK}/scene.cpp source)
expect_text("${source}" "Blueprint makeCat\\(\\)")
expect_text("${source}" "world.add\\(makeRing")
