# The story of a newcomer, by mouse and keyboard: a soft creature on a rope, a wall that falls on
# it, back in time, stiffer, its energy over time; then a car with driven wheels and a catapult.
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
drag 3.4 3 3.75 3
screenshot ${WORK}/5-catapult.png
run 1.2
screenshot ${WORK}/6-running.png
expect problem = 0
save ${WORK}/machines.json
")
run_window(0 --script ${WORK}/machines.txt)
foreach(picture 1-built 2-hit 3-stiffer 4-car 5-catapult 6-running)
  run(0 ${PICTURE_CHECK} colourful ${WORK}/${picture}.png)
endforeach()
