#!/usr/bin/env python3
"""A jelly falls, is flattened, wobbles and gets its shape back; another way is tried in a clone."""
import sulfur

world = sulfur.World()
world.add(sulfur.floor((-10, 0), (10, 0)))
jelly = world.add(sulfur.jelly(size=(1, 1), columns=6, rows=6, mass=2, stiffness=600),
                  position=(0, 4))


def height(of):
    bounds = of.bounds
    return bounds.high.y - bounds.low.y


least = 1.0
for _ in range(1000):
    world.step()
    least = min(least, height(jelly))
print("flattened" if least < 0.9 else "not flattened")
world.run(8)
print("back in shape" if abs(height(jelly) - 1) < 0.05 else "bent for good")

# What if somebody pulled it up? The world itself does not know of it.
other = world.clone()
before = world.hash
grab = other.grab(other.body(jelly), target=(0, 3))
other.run(2)
print("pulled up in the clone" if other.body(jelly).centre_of_mass.y > 2 else "stuck")
print("still on the floor here" if world.hash == before else "disturbed")
