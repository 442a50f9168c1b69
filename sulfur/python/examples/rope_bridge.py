#!/usr/bin/env python3
"""A bridge of planks between two pins bears a crate, hangs through by it, and breaks under more."""
import sulfur

world = sulfur.World()
bridge = world.add(sulfur.bridge(start=(-4, 0), end=(4, 0), planks=16, sag=0.3, strength=20000))


def lowest():
    return min(particle.position.y for particle in bridge.particles)


world.run(2)
empty = lowest()
planks = len(bridge.joints)
crate = world.add(sulfur.box(size=(0.8, 0.8), mass=10), position=(0, 0.2))
world.run(3)
print(f"empty it hangs {-empty:.1f} m below its pins")
whole = len(bridge.joints) == planks and crate.position.y > -1
print("it bears a crate" if whole else "it broke")
print("which bends it" if lowest() < empty - 0.01 else "which does nothing to it")

world.add(sulfur.box(size=(0.8, 0.8), mass=2000), position=(0.1, 1.2))
broken = 0
for _ in range(1000):
    world.step()
    broken += len(world.events["joints_broken"])
print("two tons break it" if broken > 0 else "it bears two tons")
