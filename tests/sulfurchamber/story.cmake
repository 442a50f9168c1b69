# The story of a newcomer, by mouse and keyboard: a soft creature on a rope, a wall that falls on
# it, back in time, stiffer, its energy over time; then a car with driven wheels and a catapult, both
# saved as templates, a template whose instances follow, and a level with car and catapult that is
# played: the hero gets on.
# Pictures of each step lie in the working folder.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(WRITE ${WORK}/creature.txt "
tool draw
stroke -0.7 1.2 -0.6 1.6 -0.3 1.85 0 1.75 0.3 1.85 0.6 1.6 0.7 1.2 0.55 0.9 0.25 0.75 0 0.8 -0.25 0.75 -0.55 0.9 -0.7 1.2
expect bodies = 2
tool rope
drag 0 4.2 0 1.75
expect bodies = 3
tool wall
drag 0.3 3.1 1.6 3.9
expect bodies = 4
screenshot ${WORK}/1-built.png
run 2
screenshot ${WORK}/2-hit.png
expect time > 1.9
seek 0.1
expect time < 0.2
tool select
click 0 1.3
expect selected = 1
property stiffness 4000
do plot
run 2
expect branches > 1
expect samples > 500
screenshot ${WORK}/3-stiffer.png
whole
save ${WORK}/creature.json
expect problem = 0
")
run_window(0 --script ${WORK}/creature.txt)

file(WRITE ${WORK}/machines.txt "
tool wheel
drag -2.6 0.4 -2.6 0.1
tool wheel
drag -1.2 0.4 -1.2 0.1
tool box
drag -3 0.5 -0.8 0.8
tool axle
drag -2.6 0.4 -2.6 0.65
tool axle
drag -1.2 0.4 -1.2 0.65
expect fittings = 2
screenshot ${WORK}/4-car.png
tool box
drag 2 0.06 2.4 0.9
tool select
click 2.2 0.5
property x 2.2
tool pin
click 2.02 0.08
click 2.38 0.08
tool box
drag 1 0.85 3.6 0.95
tool hinge
click 2.2 0.88
expect fittings = 3
tool ball
drag 1.2 1.15 1.3 1.15
tool ball
drag 3.4 1.6 3.7 1.6
tool select
drag -3.4 1.2 -0.4 -0.4
expect selected = 3
save-template Car of mine
drag 0.7 2.4 4 -0.4
expect selected = 4
save-template Catapult of mine
expect instances = 2
screenshot ${WORK}/5-catapult.png
hold-key Right 1
select box
expect property.x > -1.4
select ball
expect property.y > 1.3
screenshot ${WORK}/6-running.png
expect problem = 0
save ${WORK}/machines.json
")
run_window(0 --script ${WORK}/machines.txt)
foreach(picture 1-built 2-hit 3-stiffer 4-car 5-catapult 6-running)
  run(0 ${PICTURE_CHECK} colourful ${WORK}/${picture}.png)
endforeach()

# A part that is wanted more than once becomes a template: what changes in it changes in all.
file(WRITE ${WORK}/template.txt "
tool ball
drag -3 0.6 -3 0.2
save-template Wheel of mine
expect instances = 1
place -0.5 0.6 Wheel of mine
place 2 0.6 Wheel of mine
expect instances = 3
screenshot ${WORK}/7-instances.png
property mass 7
colour ff8800
expect overrides = 2
do template-apply
expect overrides = 0
screenshot ${WORK}/8-followed.png
tool select
click -3 0.6
expect selected = 1
expect property.mass = 7
expect overrides = 0
click -0.5 0.6
expect property.mass = 7
do undo
expect property.mass < 6
save ${WORK}/templates.json
expect problem = 0
")
run_window(0 --script ${WORK}/template.txt)
run(0 ${PICTURE_CHECK} differ ${WORK}/7-instances.png ${WORK}/8-followed.png)

# A level: made, checked, furnished, begun to be played in the same window, and edited on.
file(WRITE ${WORK}/level.txt "
do level-new
do page-level
expect page = 7
await level.checked = 1 60
expect level.problems = 0
place 3.4 0.1 Car of mine
place 8.4 0.1 Catapult of mine
expect instances = 2
do place-checkpoint
click 7 1.4
do place-hint
click 9 2
field text Well done
thing exit 0
field radius 0.8
whole
await level.checked = 1 60
expect level.problems = 0
screenshot ${WORK}/9-level.png
key F5
await playtest.ticks > 100 30
expect playtest.time = 0
expect playtest.x < 1.01
swing 2.2 0.05 W 0.8        # the hero pulls himself along by his rope
expect playtest.time > 0.7
expect playtest.x > 1.5
screenshot ${WORK}/10-played.png
key Escape
expect playtest = 0
expect time = 0
field radius 0.5
save ${WORK}/level.json
expect problem = 0
")
run_window(0 --script ${WORK}/level.txt)
run(0 ${PICTURE_CHECK} differ ${WORK}/9-level.png ${WORK}/10-played.png)
