"""Sulfur for Python: 2D physics of rigid and soft bodies and ropes, in SI units.

    import sulfur
    world = sulfur.World()
    world.add(sulfur.floor((-20, 0), (20, 0)))
    crate = world.add(sulfur.box(size=(1, 1), mass=2), position=(0, 3))
    world.run(2)
    print(crate.position.y)

It needs the standard library and the shared library sulfur_c, which it looks for in the file that
the environment variable SULFUR_LIBRARY names, where the package was installed, and where the
system looks for libraries.

What calls do, units and ranges stand in the headers: sulfur/c/*.h, which name those of C++. Places
and vectors are pairs of numbers; angles are radians. A call that the library refuses raises Error
and changes nothing. A World must be used by one thread at a time.
"""
from . import c
from .blueprints import (Blueprint, ball, blob, box, bridge, chain, cloth, floor, ground, jelly,
                         polygon, rope, wall, wheel)
from .library import VERSION, Error
from .things import Angle, Attachment, Body, Field, Grab, Joint, Mechanism, Particle
from .values import (box_zone, capsule, circle, circle_zone, collision_filter, drive, hull, material,
                     radial_field, rectangle, stage_name, uniform_field, wind_field)
from .world import ThreadPool, World

DYNAMIC, KINEMATIC, FIXED = c.DYNAMIC, c.KINEMATIC, c.FIXED
INFINITE = float("inf")  # stiffness of what is rigid, strength of what never breaks
