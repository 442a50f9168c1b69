"""Things in a world, by their handles: bodies, particles, joints, mechanisms and so on."""
import ctypes

from . import c
from .library import call, entries, find, get
from .values import fill, pose_of, vec


class Thing:
    """Something in a world, by its handle. It stays the same when what it refers to is removed."""

    def __init__(self, world, handle):
        self.world, self.id = world, handle

    def _ask(self, kind, question, *arguments):
        return get(kind, f"sulfur_{self._name}_{question}", self.world._handle, self.id,
                    *arguments)

    def _tell(self, order, *arguments):
        call(f"sulfur_{self._name}_{order}", self.world._handle, self.id, *arguments)

    def _ask_list(self, kind, question):
        return entries(kind, f"sulfur_{self._name}_{question}", self.world._handle, self.id)

    @property
    def exists(self):
        """Whether it is still in its world."""
        return self._ask(ctypes.c_bool, "exists")

    def __eq__(self, other):
        return type(self) is type(other) and self.world is other.world and self.id == other.id

    def __hash__(self):
        return hash((type(self), self.id))

    def __repr__(self):
        return f"<{type(self).__name__} {self.id.index}:{self.id.generation}>"


def _reading(kind, question, doc):
    return property(lambda self: self._ask(kind, question), doc=doc)


def _setting(kind, question, doc, convert=lambda value: value):
    return property(lambda self: self._ask(kind, question),
                    lambda self, value: self._tell(f"set_{question}", convert(value)), doc=doc)


class Body(Thing):
    """A body; sulfur/c/bodies.h."""

    _name = "body"

    def remove(self):
        """Removes it with all that holds on to it."""
        self._tell("remove")

    kind = _setting(ctypes.c_int32, "kind", "DYNAMIC, KINEMATIC or FIXED.")
    enabled = _setting(ctypes.c_bool, "enabled", "Whether it takes part.")
    pose = _setting(c.Pose, "pose", "Position and angle of its frame.",
                    lambda value: value if isinstance(value, c.Pose) else pose_of(*value))
    angle = _reading(ctypes.c_double, "angle", "Radians.")
    centre_of_mass = _reading(c.Vec, "centre_of_mass", "Metres.")
    velocity = _reading(c.Vec, "mean_velocity", "m/s, the mean of its particles by mass.")
    angular_velocity = _reading(ctypes.c_double, "angular_velocity", "rad/s.")
    mass = _reading(ctypes.c_double, "mass", "kg.")
    inertia = _reading(ctypes.c_double, "inertia", "kg m^2.")
    bounds = _reading(c.Bounds, "bounds", "The smallest upright rectangle around it.")
    asleep = _reading(ctypes.c_bool, "asleep", "Whether it rests and costs nothing.")
    material = _setting(c.Material, "material", "Its surface.")
    filter = _setting(c.Filter, "filter", "What it collides with.")
    self_collision = _setting(ctypes.c_bool, "self_collision", "Whether its parts touch.")
    sensor = _setting(ctypes.c_bool, "sensor", "Whether it only feels.")
    gravity_scale = _setting(ctypes.c_double, "gravity_scale", "How much of gravity acts on it.")
    fixed_rotation = _setting(ctypes.c_bool, "fixed_rotation", "Whether it keeps its angle.")
    linear_damping = _reading(ctypes.c_double, "linear_damping", "1/s, of its centre of mass.")
    angular_damping = _reading(ctypes.c_double, "angular_damping", "1/s, of how it turns.")
    sleeping_allowed = _setting(ctypes.c_bool, "sleeping_allowed", "Whether it may fall asleep.")
    user_data = _setting(ctypes.c_uint64, "user_data", "A number of the caller's.")

    @property
    def name(self):
        """The name of its blueprint."""
        return self._ask(ctypes.c_char_p, "name").decode()

    @property
    def position(self):
        """Where its own frame is."""
        return self.pose.position

    @velocity.setter
    def velocity(self, velocity):
        self._tell("set_velocity", vec(velocity))

    def set_motion(self, linear, angular):
        """m/s of its centre of mass and rad/s about it."""
        self._tell("set_motion", vec(linear), angular)

    def interpolated_pose(self, alpha):
        """The pose for drawing, between the last two ticks."""
        return self._ask(c.Pose, "interpolated_pose", alpha)

    def to_world(self, local):
        """Where a point of its frame is in the world."""
        return self._ask(c.Vec, "to_world", vec(local))

    def from_world(self, point):
        """Where a point of the world is in its frame."""
        return self._ask(c.Vec, "from_world", vec(point))

    def vector_to_world(self, local):
        """A vector of its frame as it is in the world."""
        return self._ask(c.Vec, "vector_to_world", vec(local))

    def vector_from_world(self, vector):
        """A vector of the world as it is in its frame."""
        return self._ask(c.Vec, "vector_from_world", vec(vector))

    def touches(self, other):
        """Whether it touched another body at the end of the last tick."""
        return get(ctypes.c_bool, "sulfur_world_touches", self.world._handle, self.id, other.id)

    def apply_force(self, force, at):
        """Newtons at a point of the world during the next tick."""
        self._tell("apply_force", vec(force), vec(at))

    def apply_torque(self, torque):
        """N m during the next tick."""
        self._tell("apply_torque", torque)

    def apply_impulse(self, impulse, at):
        """N s at a point of the world."""
        self._tell("apply_impulse", vec(impulse), vec(at))

    def apply_angular_impulse(self, impulse):
        """N m s."""
        self._tell("apply_angular_impulse", impulse)

    def move_to(self, position, angle=0):
        """Moves a kinematic body during the next tick."""
        self._tell("move_to", pose_of(position, angle))

    def wake(self):
        """Wakes it and its island."""
        self._tell("wake")

    def put_to_sleep(self):
        """Puts it to sleep with its island and returns whether it sleeps now."""
        return self._ask(ctypes.c_bool, "put_to_sleep")

    def set_damping(self, linear, angular):
        """1/s, how its way and its turning die away; each 0 to the tick rate."""
        self._tell("set_damping", linear, angular)

    @property
    def particles(self):
        """Its particles in the order of its blueprint."""
        return [Particle(self.world, id) for id in self._ask_list(c.ParticleId, "particles")]

    @property
    def joints(self):
        """Its joints in the order of its blueprint, without those that are gone."""
        return [Joint(self.world, id) for id in self._ask_list(c.JointId, "joints")]

    @property
    def angles(self):
        """Its angular joints in the order of its blueprint, without those that are gone."""
        return [Angle(self.world, info.id) for info in self._ask_list(c.AngleInfo, "angles")]

    @property
    def contacts(self):
        """Its contacts that push."""
        return self._ask_list(c.ContactInfo, "contacts")

    @property
    def visitors(self):
        """Who is in it, if it is a sensor."""
        return [Body(self.world, id) for id in self._ask_list(c.BodyId, "visitors")]

    @property
    def skin(self):
        """What it wears: name, places, triples of particles; or None."""
        skin = find(c.Skin, "sulfur_body_skin", self.world._handle, self.id)
        if skin is None:
            return None
        corners = skin.triangles[:3 * skin.triangle_count]
        return (skin.texture.decode(), [tuple(place) for place in skin.uv[:skin.uv_count]],
                [tuple(corners[i:i + 3]) for i in range(0, len(corners), 3)])


class Particle(Thing):
    """A particle; sulfur/c/parts.h."""

    _name = "particle"

    info = _reading(c.ParticleInfo, "info", "All that it is at the moment.")
    position = _setting(c.Vec, "position", "Metres.", vec)
    velocity = _setting(c.Vec, "velocity", "m/s.", vec)
    mass = property(lambda self: self.info.mass,
                    lambda self, mass: self._tell("set_mass", mass), doc="kg.")
    pinned = property(lambda self: self.info.pinned,
                      lambda self, on: self._tell("set_pinned", on), doc="Whether it is held.")

    def interpolated(self, alpha):
        """Where to draw it, between the last two ticks."""
        return self._ask(c.Vec, "interpolated", alpha)

    def apply_force(self, force):
        """Newtons during the next tick."""
        self._tell("apply_force", vec(force))

    def apply_impulse(self, impulse):
        """N s."""
        self._tell("apply_impulse", vec(impulse))


def _of_info(name, doc):
    return property(lambda self: getattr(self.info, name),
                    lambda self, value: self._tell(f"set_{name}", value), doc=doc)


class Joint(Thing):
    """A joint; sulfur/c/parts.h."""

    _name = "joint"

    info = _reading(c.JointInfo, "info", "All that it is at the moment.")
    stiffness = _of_info("stiffness", "N/m.")
    damping = _of_info("damping", "N s/m.")
    rest_length = _of_info("rest_length", "Metres.")
    strength = _of_info("strength", "N.")
    force = property(lambda self: self.info.force, doc="N in the last tick, positive if it pulls.")

    @property
    def material(self):
        """Its surface; None gives it its body's again."""
        return self._ask(c.Material, "material")

    @material.setter
    def material(self, surface):
        self._tell("set_material", ctypes.byref(surface) if surface is not None else None)

    def remove(self):
        """Removes it."""
        self._tell("remove")


class _Driven(Thing):
    """What has a coordinate on which a drive acts."""

    @property
    def drive(self):
        """What acts along its coordinate; set it to what drive() returned."""
        return self.info.drive

    @drive.setter
    def drive(self, drive):
        self._tell("set_drive", ctypes.byref(drive))

    def change_drive(self, **options):
        """Changes some members of its drive: motor_speed, upper ...; motor_target=None forgets."""
        self.drive = fill(self.drive, options)


class Angle(_Driven):
    """An angular joint; sulfur/c/parts.h."""

    _name = "angle"

    info = _reading(c.AngleInfo, "info", "All that it is at the moment.")
    angle = property(lambda self: self.info.angle, doc="rad.")
    torque = property(lambda self: self.info.torque, doc="N m in the last tick.")

    def remove(self):
        """Takes it away; what it bent stays."""
        self._tell("remove")


class Attachment(Thing):
    """A particle held at a point of a body; sulfur/c/parts.h."""

    _name = "attachment"

    info = _reading(c.AttachmentInfo, "info", "What holds what.")

    def remove(self):
        """Lets go."""
        self._tell("remove")


class Field(Thing):
    """A force field; sulfur/c/fields.h."""

    _name = "field"

    info = _reading(c.Field, "info", "What it is.")

    def set(self, field):
        """Changes it to what uniform_field(), radial_field() or wind_field() returned."""
        self._tell("set", ctypes.byref(field))

    def remove(self):
        """Removes it."""
        self._tell("remove")


class Grab(Thing):
    """A grab, as with a mouse; sulfur/c/parts.h."""

    _name = "grab"

    info = _reading(c.GrabInfo, "info", "Where it holds and pulls.")

    def set_target(self, target):
        """Moves the target."""
        self._tell("set_target", vec(target))

    def release(self):
        """Lets go."""
        self._tell("release")


class Mechanism(_Driven):
    """A hinge, a weld, a slider, a distance, a pulley or a gear; sulfur/c/mechanisms.h."""

    _name = "mechanism"

    info = _reading(c.MechanismInfo, "info", "All that it is at the moment.")
    value = property(lambda self: self.info.value, doc="rad or m.")
    speed = property(lambda self: self.info.speed, doc="rad/s or m/s.")
    force = property(lambda self: self.info.force, doc="N m or N of its drive in the last tick.")

    @property
    def rail(self):
        """The joints that are left of the rail of a slider, in order."""
        return [Joint(self.world, id) for id in self._ask_list(c.JointId, "rail")]

    def remove(self):
        """Lets both bodies go."""
        self._tell("remove")
