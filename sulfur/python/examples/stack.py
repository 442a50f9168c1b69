#!/usr/bin/env python3
"""Ten crates are stacked, come to rest and fall asleep; a ball knocks them over."""
import sulfur

world = sulfur.World()
world.add(sulfur.floor((-50, 0), (50, 0)))
crate = sulfur.box(size=(1, 1), mass=2)
crates = [world.add(crate, position=(0, 0.55 + 1.0 * i)) for i in range(10)]
world.run(4)
print(f"asleep: {sum(body.asleep for body in crates)} of {len(crates)}")
print(f"the highest is at {crates[-1].position.y:.2f} m")

ball = world.add(sulfur.ball(radius=0.4, mass=20), position=(-6, 5.5))
ball.velocity = (25, 0)
hits = 0
for _ in range(1500):
    world.step()
    hits += len(world.events["contacts_begun"])
print("it was hit" if hits > 5 else "it was missed")
print("and fell" if max(body.position.y for body in crates) < 5 else "and stands")
