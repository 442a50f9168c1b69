# What guides a beginner, in the window: films of tools, lessons by hand and shown, the gallery,
# and the three languages.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

# A film begins under the pointer and ends elsewhere; it is drawn over the scene.
file(WRITE ${WORK}/films.txt "
expect film = 0
screenshot ${WORK}/empty.png
point tool-ball
expect film = 1
screenshot ${WORK}/film.png
click 3 1
expect film = 0
do demo
expect film = 1
do demo
expect film = 0
do films
point tool-wall
expect film = 0
")
run_window(0 --script ${WORK}/films.txt)
run(0 ${PICTURE_CHECK} differ ${WORK}/empty.png ${WORK}/film.png)

# A lesson goes on when the learner does what it asks, not before; a hand shows the rest.
file(WRITE ${WORK}/lesson.txt "
do lesson-build
expect lesson.step = 0
tool ball
click 2 1
expect lesson.step = 0
do undo
tool box
drag -0.4 0.9 0.4 1.5
run 0.05
expect lesson.step = 1
screenshot ${WORK}/lesson.png
whole
do lesson-skip
expect lesson.step = 2
run 1.2
expect lesson.step = 3
do lesson-end
do new
do lesson-soften
do lesson-show
expect lesson.showing = 1
run 0.02
run 2
expect lesson.step > 0
expect bodies = 2
do lesson-end
")
run_window(0 --script ${WORK}/lesson.txt)

# The sixth makes a level: by hand up to the play-test, which Esc ends; then a hand does all of it.
foreach(step RANGE 1 6)
  string(APPEND shown "do lesson-show\nawait lesson.step = ${step} 20\nawait lesson.showing = 0 10\n")
endforeach()
file(WRITE ${WORK}/level.txt "
do lesson-level
expect lesson.step = 0
do level-make
await lesson.step = 1 5
do place-spawn
click -4 0.5
await lesson.step = 2 5
do place-exit
click 4 0.5
await lesson.step = 3 5
tool box
drag -0.4 0.1 0.4 0.9
await lesson.step = 4 5
screenshot ${WORK}/level.png
whole
key F5
await playtest = 1 10
await lesson.step = 5 20
screenshot ${WORK}/level-played.png
key Escape
await lesson.step = 6 10
expect playtest = 0
expect level.things > 6
do lesson-end
do new
do lesson-level
${shown}expect playtest = 0
expect level.problems = 0
")
run_window(0 --script ${WORK}/level.txt)
run(0 ${PICTURE_CHECK} differ ${WORK}/level.png ${WORK}/level-played.png)

# The gallery draws its pictures.
file(WRITE ${WORK}/gallery.txt "
do gallery
await gallery.pictures > 24 60
screenshot ${WORK}/gallery.png
")
run_window(0 --script ${WORK}/gallery.txt)
run(0 ${PICTURE_CHECK} colourful ${WORK}/gallery.png)

file(GLOB textbooks ${SCENES}/textbook-*.json)
list(TRANSFORM textbooks REPLACE "(.+)" "open \\1\nrun 0.1\nwhole\n" OUTPUT_VARIABLE laws)
list(JOIN laws "" laws)
string(REPEAT "do lesson-skip\nwhole\n" 5 skipped)
# Menus, hints, steps and pages in the language of the user; scripts speak English unless told otherwise.
foreach(pair "de:Beispielszenen …:Rückgängig: „Kiste hinzufügen“" "it:Scene di esempio…:Annulla «Aggiungi cassa»")
  string(REPLACE ":" ";" parts "${pair}")
  list(GET parts 0 language)
  list(GET parts 1 gallery)
  list(SUBLIST parts 2 -1 undo)
  string(REPLACE ";" ":" undo "${undo}")
  file(WRITE ${WORK}/${language}.txt "
label gallery ${gallery}
tool box
drag -0.4 0.9 0.4 1.5
label undo ${undo}
screenshot ${WORK}/${language}.png
whole
tool hinge
click 0 1.2
expect fittings = 1
do select-all                # where values differ, fields say so
do page-object
whole
do page-measure
whole
do page-library
whole
do page-history
whole
do level-make
do page-level
thing exit 0
whole
do lesson-measure
run 0.05
whole
do lesson-end
do lesson-level
whole
${skipped}do lesson-end
do page-measure
${laws}table4 0.02
whole
do language-system
do theme-system
do grid-half
")
  run_window(0 --language ${language} --script ${WORK}/${language}.txt)
  # In the smallest window too, with each hint.
  set(hints)
  foreach(tool select box ball wheel polygon wall ground jelly draw cloth rope chain bridge particle joint hinge motor
      weld spring cable winch slider axle pulley gear thruster wind gravity conveyor liquid pin cut erase measure)
    string(APPEND hints "tool ${tool}\nwhole\n")
  endforeach()
  file(WRITE ${WORK}/${language}-small.txt "
${hints}
open ${SCENES}/car.json
do select-all
do page-object
whole
tool jelly
drag -2 1 -1.2 1.6
property mass 4985.12
property damping 1234.56
whole
do select-all
do page-library
whole
do plot
run 0.1
whole
do plot
open ${SCENES}/../../levels/09-frost-slug.json
do page-level
whole
")
  run_window(0 --language ${language} --width 640 --height 480 --script ${WORK}/${language}-small.txt)
endforeach()
run(105 ${PROGRAM} --language xx)
