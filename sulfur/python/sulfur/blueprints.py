"""Plans of bodies."""
import ctypes

from . import c
from .library import call, get, library
from .values import options_of, vec, vecs


def _property(kind, name, convert=lambda value: value):
    """A property of a blueprint that has a function to get it and one to set it."""
    return property(
        lambda self: get(kind, f"sulfur_blueprint_{name}", self._handle),
        lambda self, value: call(f"sulfur_blueprint_set_{name}", self._handle, convert(value)))


class Blueprint:
    """The plan of a body; sulfur/c/blueprint.h. World.add makes bodies of it, as many as wanted."""

    def __init__(self, _handle=None):
        self._handle = _handle or get(ctypes.c_void_p, "sulfur_blueprint_create")

    def __del__(self):
        if getattr(self, "_handle", None):
            library.sulfur_blueprint_destroy(self._handle)

    def copy(self):
        """Another one like it."""
        return Blueprint(get(ctypes.c_void_p, "sulfur_blueprint_copy", self._handle))

    kind = _property(ctypes.c_int32, "kind")
    material = _property(c.Material, "material")
    filter = _property(c.Filter, "filter")
    self_collision = _property(ctypes.c_bool, "self_collision")
    sensor = _property(ctypes.c_bool, "sensor")

    @property
    def name(self):
        """For people."""
        return get(ctypes.c_char_p, "sulfur_blueprint_name", self._handle).decode()

    @name.setter
    def name(self, text):
        call("sulfur_blueprint_set_name", self._handle, text.encode())

    @property
    def mass(self):
        """Kilograms."""
        return get(ctypes.c_double, "sulfur_blueprint_mass", self._handle)

    @property
    def centre_of_mass(self):
        """In the body's frame."""
        return get(c.Vec, "sulfur_blueprint_centre_of_mass", self._handle)

    def validate(self):
        """Raises Error unless a body can be made of it."""
        call("sulfur_blueprint_validate", self._handle)

    def add_particle(self, position, mass=1, radius=0, pinned=False):
        """Adds a particle and returns its index."""
        spec = options_of("particle_spec", {"position": position, "mass": mass, "radius": radius,
                                          "pinned": pinned})
        index = ctypes.c_uint32()
        call("sulfur_blueprint_add_particle", self._handle, spec, ctypes.byref(index))
        return index.value

    def add_joint(self, a, b, **options):
        """Joins two particles by their indices and returns the joint's; sulfur.c.JointSpec."""
        spec = options_of("joint_spec", {"a": a, "b": b, **options})
        index = ctypes.c_uint32()
        call("sulfur_blueprint_add_joint", self._handle, spec, ctypes.byref(index))
        return index.value

    def add_angle(self, a, b, c, **options):
        """Makes the corner b between a and c elastic and returns the index of this angular joint:
        stiffness, damping, rest_angle."""
        spec = options_of("angular_joint_spec", {"a": a, "b": b, "c": c, **options})
        index = ctypes.c_uint32()
        call("sulfur_blueprint_add_angle", self._handle, spec, ctypes.byref(index))
        return index.value

    def particles(self):
        """Copies of its particles."""
        count = get(ctypes.c_size_t, "sulfur_blueprint_particle_count", self._handle)
        return [get(c.ParticleSpec, "sulfur_blueprint_particle", self._handle, i)
                for i in range(count)]

    def joints(self):
        """Copies of its joints."""
        count = get(ctypes.c_size_t, "sulfur_blueprint_joint_count", self._handle)
        return [get(c.JointSpec, "sulfur_blueprint_joint", self._handle, i)
                for i in range(count)]

    def angles(self):
        """Copies of its angular joints."""
        count = get(ctypes.c_size_t, "sulfur_blueprint_angle_count", self._handle)
        return [get(c.AngularJointSpec, "sulfur_blueprint_angle", self._handle, i)
                for i in range(count)]

    def set_particle(self, index, spec):
        """Changes a particle."""
        call("sulfur_blueprint_set_particle", self._handle, index, spec)

    def set_joint(self, index, spec):
        """Changes a joint."""
        call("sulfur_blueprint_set_joint", self._handle, index, spec)

    def set_angle(self, index, spec):
        """Changes an angular joint."""
        call("sulfur_blueprint_set_angle", self._handle, index, spec)

    def wear(self, texture, uv, triangles):
        """Gives it a skin: a name, a place in it for each particle, triples of particles."""
        corners = [corner for triangle in triangles for corner in triangle]
        skin = c.Skin(texture.encode(), vecs(uv), len(uv),
                      (ctypes.c_uint32 * len(corners))(*corners), len(triangles))
        call("sulfur_blueprint_set_skin", self._handle, ctypes.byref(skin))


def _shape(name):
    def make(**options):
        return Blueprint(get(ctypes.c_void_p, f"sulfur_shape_{name}",
                              ctypes.byref(options_of(f"{name}_options", options))))

    make.__name__ = name
    make.__doc__ = "A blueprint; sulfur/c/shapes.h has its options."
    return make


ground, box, polygon, ball = map(_shape, ("ground", "box", "polygon", "ball"))
wheel, rope, chain, bridge = map(_shape, ("wheel", "rope", "chain", "bridge"))
jelly, cloth, wall, blob = map(_shape, ("jelly", "cloth", "wall", "blob"))


def floor(start, end, radius=0.05):
    """A fixed straight floor."""
    return Blueprint(get(ctypes.c_void_p, "sulfur_shape_floor", vec(start), vec(end), radius))
