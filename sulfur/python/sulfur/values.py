"""Pairs of numbers, structs with options, regions, fields, shapes of queries."""
import ctypes

from . import c
from .library import get, library


def vec(pair):
    x, y = pair
    return c.Vec(x, y)


def vecs(pairs):
    return (c.Vec * len(pairs))(*map(vec, pairs))


def pose_of(position, angle):
    return c.Pose(vec(position), angle)


def fill(struct, options):
    """Sets members of a struct by name; `has_...` follows by itself, None clears it. As `from`
    is a word of Python, `start` and `end` mean `from` and `to`."""
    members = dict(struct._fields_)
    for name, value in options.items():
        if "from" in members:
            name = {"start": "from", "end": "to"}.get(name, name)
        if name == "points":
            struct.points, struct.point_count = vecs(value), len(value)
            continue
        if name == "bends":
            struct.bends, struct.bend_count = (c.c_double * len(value))(*value), len(value)
            continue
        if name not in members:
            raise TypeError(f"{type(struct).__name__} has no option {name}; it has "
                            f"{', '.join(members)}")
        if value is None and "has_" + name in members:
            setattr(struct, "has_" + name, False)
            continue
        if members[name] is c.Vec:
            value = vec(value)
        elif isinstance(value, dict):
            value = fill(getattr(struct, name), value)
        setattr(struct, name, value)
        if "has_" + name in members:
            setattr(struct, "has_" + name, True)
    return struct


def options_of(name, options):
    """A struct with its defaults and these options."""
    return fill(getattr(library, f"sulfur_{name}_default")(), options)


def material(**options):
    """A surface: static_friction, kinetic_friction, restitution, surface_speed,
    rolling_resistance."""
    return options_of("material", options)


def drive(**options):
    """What acts along a mechanism: lower, upper, stiffness, damping, rest, motor_speed, motor_max,
    motor_target, strength."""
    return options_of("drive", options)


def collision_filter(**options):
    """What collides: category, mask, group."""
    return options_of("filter", options)


def _vec_text(self):
    return f"({self.x:g}, {self.y:g})"


def _same(self, other):
    return type(self) is type(other) and all(
        getattr(self, name) == getattr(other, name) for name, *_ in self._fields_)


def _hash(self):
    return hash(tuple(getattr(self, name) for name, *_ in self._fields_))


c.Vec.__iter__ = lambda self: iter((self.x, self.y))
c.Vec.__repr__ = _vec_text
for _kind in (c.Vec, c.BodyId, c.ParticleId, c.JointId, c.AttachmentId, c.FieldId, c.GrabId,
              c.MechanismId):
    _kind.__eq__, _kind.__hash__ = _same, _hash


def stage_name(stage):
    """The name of a stage of a tick, of which Statistics.items and seconds have one entry each."""
    return library.sulfur_stage_name(stage).decode()


# --- regions ------------------------------------------------------------------------------------


def box_zone(low, high):
    """A rectangle, for fields and drawing."""
    return options_of("zone", {"kind": c.BOX_ZONE, "low": low, "high": high})


def circle_zone(centre, radius):
    """A disc, for fields and drawing."""
    return options_of("zone", {"kind": c.CIRCLE_ZONE, "centre": centre, "radius": radius})


def _field(kind, member, options):
    field = library.sulfur_field_default(kind)
    fill(getattr(field, member), options)
    return field


def uniform_field(**options):
    """The same acceleration everywhere: zone, acceleration, mask."""
    return _field(c.UNIFORM_FIELD, "uniform", options)


def radial_field(**options):
    """Towards a point: centre, strength, falloff, core, reach, mask."""
    return _field(c.RADIAL_FIELD, "radial", options)


def wind_field(**options):
    """Moving air: zone, velocity, drag, mask."""
    return _field(c.WIND_FIELD, "wind", options)


def circle(centre, radius):
    """A shape for queries."""
    return get(c.QueryShape, "sulfur_query_shape_circle", vec(centre), radius)


def capsule(a, b, radius):
    """A shape for queries."""
    return get(c.QueryShape, "sulfur_query_shape_capsule", vec(a), vec(b), radius)


def rectangle(centre, size, angle=0):
    """A shape for queries."""
    return get(c.QueryShape, "sulfur_query_shape_box", vec(centre), vec(size), angle)


def hull(points, radius=0):
    """A shape for queries: the convex hull of up to eight points."""
    return get(c.QueryShape, "sulfur_query_shape_polygon", vecs(points), len(points), radius)
