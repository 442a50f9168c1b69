"""The world, and threads for it."""
import ctypes
import weakref

from . import c
from .library import call, entries, find, get, guarded, library
from .things import Attachment, Body, Field, Grab, Joint, Mechanism, Particle
from .values import options_of, pose_of, vec


class ThreadPool:
    """Threads for worlds; World.set_thread_pool. 0: as many as the machine has."""

    def __init__(self, threads=0):
        self._handle = get(ctypes.c_void_p, "sulfur_thread_pool_create", threads)

    def __del__(self):
        if getattr(self, "_handle", None):
            library.sulfur_thread_pool_destroy(self._handle)


class World:
    """Owns particles, joints and bodies and moves them; sulfur/c/world.h.

    Options: gravity, air_friction, tick_rate, sleeping, damper, friction, tell_persisting, sweeps,
    sleep_speed, rebound_speed.
    """

    def __init__(self, *, _handle=None, **options):
        self._handle = _handle or get(
            ctypes.c_void_p, "sulfur_world_create",
            ctypes.byref(options_of("world_settings", options)))
        self._pool = None
        self._callbacks = {}  # by name: what C calls, which must live as long as it may

    def __del__(self):
        if getattr(self, "_handle", None):
            library.sulfur_world_destroy(self._handle)

    def _ask(self, kind, question, *arguments):
        return get(kind, f"sulfur_world_{question}", self._handle, *arguments)

    def _tell(self, order, *arguments):
        call(f"sulfur_world_{order}", self._handle, *arguments)

    def _ask_list(self, kind, question, *arguments):
        return entries(kind, f"sulfur_world_{question}", self._handle, *arguments)

    def clone(self):
        """Another world in the same state; body(b) of it is the body of the same handle."""
        return World(_handle=self._ask(ctypes.c_void_p, "clone"))

    # --- making -----------------------------------------------------------------------------

    def add(self, blueprint, position=(0, 0), angle=0):
        """Makes a body."""
        return Body(self, self._ask(c.BodyId, "add_body", blueprint._handle,
                                    pose_of(position, angle)))

    def connect(self, a, b, **options):
        """Joins two particles: stiffness, damping, rest_length, radius, strength, material."""
        return Joint(self, self._ask(c.JointId, "connect", a.id, b.id,
                                     ctypes.byref(options_of("connect_options", options))))

    def attach(self, particle, to, at):
        """Holds a particle at a point of a body's own frame, or at a place 0 to 1 on a joint."""
        if isinstance(to, Joint):
            handle = self._ask(c.AttachmentId, "attach_to_joint", particle.id, to.id, at)
        else:
            handle = self._ask(c.AttachmentId, "attach_to_body", particle.id, to.id, vec(at))
        return Attachment(self, handle)

    def add_field(self, field):
        """Adds what uniform_field(), radial_field() or wind_field() returned."""
        return Field(self, self._ask(c.FieldId, "add_field", ctypes.byref(field)))

    def grab(self, what, target, at=(0, 0), **options):
        """Pulls a particle, or a body at a place in its frame: frequency, damping_ratio, max_force."""
        firmness = ctypes.byref(options_of("grab_options", options))
        if isinstance(what, Particle):
            handle = self._ask(c.GrabId, "grab_particle", what.id, vec(target), firmness)
        else:
            handle = self._ask(c.GrabId, "grab_body", what.id, vec(at), vec(target), firmness)
        return Grab(self, handle)

    def _join(self, kind, options, *ends):
        struct = options_of(f"{kind.removesuffix('_on_rail')}_options", options)
        return Mechanism(self, self._ask(c.MechanismId, kind, *ends, ctypes.byref(struct)))

    def hinge(self, a, b, at, **options):
        """Lets two bodies turn about a point: drive, collide, pin, strength, value. A drive is
        what drive() returns, or a dict of its options."""
        return self._join("hinge", options, a.id, b.id, vec(at))

    def weld(self, a, b, at, **options):
        """Holds the angle too: stiffness, damping, collide, strength, torque_strength, value."""
        return self._join("weld", options, a.id, b.id, vec(at))

    def slider(self, a, b, at, axis=None, rail=None, **options):
        """Leads a point of b along a line that moves with a, or along a rail, joints of a in the
        order of a line: drive, collide, turns, value."""
        if rail is not None:
            links = (c.JointId * len(rail))(*(joint.id for joint in rail))
            return self._join("slider_on_rail", options, a.id, b.id, vec(at), links, len(rail))
        return self._join("slider", options, a.id, b.id, vec(at), vec(axis))

    def wheel(self, body, wheel, at, axis, **options):
        """Hangs a wheel on a body: spring, motor (both drives), collide. Returns both mechanisms:
        the slider and the hinge."""
        ids = self._ask(c.WheelIds, "wheel", body.id, wheel.id, vec(at), vec(axis),
                        ctypes.byref(options_of("wheel_mechanism_options", options)))
        return Mechanism(self, ids.spring), Mechanism(self, ids.motor)

    def distance(self, a, at_a, b, at_b, **options):
        """Keeps the distance of two points in limits, or drives it: drive, collide."""
        return self._join("distance", options, a.id, vec(at_a), b.id, vec(at_b))

    def pulley(self, a, at_a, over_a, b, at_b, over_b, frame, **options):
        """Hangs two bodies on one rope that runs over two points of a third one: ratio, length,
        strength."""
        return self._join("pulley", options, a.id, vec(at_a), vec(over_a), b.id, vec(at_b),
                          vec(over_b), frame.id)

    def gear(self, first, second, ratio):
        """Couples two mechanisms: the value of the first plus ratio times that of the second
        stays what it is."""
        return Mechanism(self, self._ask(c.MechanismId, "gear", first.id, second.id, ratio))

    def body(self, body):
        """The body of this world that has the handle of another one, or that handle."""
        found = Body(self, getattr(body, "id", body))
        found.kind  # refuses what is not here
        return found

    bodies = property(lambda self: [Body(self, id) for id in
                                    self._ask_list(c.BodyId, "bodies")], doc="Oldest first.")
    connections = property(lambda self: [Joint(self, id) for id in
                                         self._ask_list(c.JointId, "connections")],
                           doc="Joints between bodies, oldest first.")
    attachments = property(lambda self: [Attachment(self, id) for id in
                                         self._ask_list(c.AttachmentId, "attachments")],
                           doc="Oldest first.")
    fields = property(lambda self: [Field(self, id) for id in
                                    self._ask_list(c.FieldId, "fields")], doc="Oldest first.")
    grabs = property(lambda self: [Grab(self, id) for id in
                                   self._ask_list(c.GrabId, "grabs")], doc="Oldest first.")
    mechanisms = property(lambda self: [Mechanism(self, id) for id in
                                        self._ask_list(c.MechanismId, "mechanisms")],
                          doc="Oldest first.")

    def set_collision(self, a, b, on):
        """Lets two bodies pass through each other (False), or not."""
        self._tell("set_collision", a.id, b.id, on)

    def collision(self, a, b):
        """False after set_collision(a, b, False)."""
        return self._ask(ctypes.c_bool, "collision", a.id, b.id)

    @property
    def vetoes(self):
        """Pairs of bodies that pass through each other."""
        return [(Body(self, pair.a), Body(self, pair.b))
                for pair in self._ask_list(c.BodyPair, "vetoes")]

    # --- time and state ---------------------------------------------------------------------

    def step(self):
        """Advances by one tick."""
        self._tell("step")

    def run(self, seconds):
        """Advances by so many seconds, to the nearest tick."""
        for _ in range(round(seconds * self.settings.tick_rate)):
            self.step()

    ticks = property(lambda self: self._ask(ctypes.c_uint64, "ticks"), doc="Since it was made.")
    time = property(lambda self: self._ask(ctypes.c_double, "time"), doc="Seconds.")
    tick_duration = property(lambda self: self._ask(ctypes.c_double, "tick_duration"),
                             doc="Seconds.")
    energy = property(lambda self: self._ask(ctypes.c_double, "energy"), doc="Joules.")
    hash = property(lambda self: self._ask(ctypes.c_uint64, "hash"),
                    doc="Of all that decides how it goes on.")
    settings = property(lambda self: self._ask(c.WorldSettings, "settings"), doc="As they are.")
    statistics = property(lambda self: self._ask(c.Statistics, "statistics"),
                          doc="What the last tick did.")
    memory = property(lambda self: self._ask_list(c.MemoryUse, "memory"),
                      doc="What it holds, part by part.")
    gravity = property(lambda self: self._ask(c.Vec, "gravity"),
                       lambda self, gravity: self._tell("set_gravity", vec(gravity)),
                       doc="m/s^2.")
    air_friction = property(lambda self: self._ask(ctypes.c_double, "air_friction"),
                            lambda self, value: self._tell("set_air_friction", value), doc="1/s.")
    tick_rate = property(lambda self: self.settings.tick_rate,
                         lambda self, rate: self._tell("set_tick_rate", rate), doc="Hz.")
    damper = property(lambda self: self.settings.damper,
                      lambda self, kind: self._tell("set_damper", kind),
                      doc="sulfur.c.AXIAL_DAMPER or FULL_DAMPER.")

    def snapshot(self):
        """The whole state as bytes."""
        handle = self._ask(ctypes.c_void_p, "snapshot")
        try:
            start, size = ctypes.c_void_p(), ctypes.c_size_t()
            call("sulfur_snapshot_bytes", handle, ctypes.byref(start), ctypes.byref(size))
            return ctypes.string_at(start, size.value)
        finally:
            library.sulfur_snapshot_destroy(handle)

    def restore(self, snapshot):
        """Goes back to a snapshot of the same build of the library."""
        self._tell("restore", bytes(snapshot), len(snapshot))

    def validate(self):
        """The first broken invariant, or an empty text."""
        return self._ask(ctypes.c_char_p, "validate").decode()

    def set_profiling(self, on):
        """Whether statistics also has the time of each stage."""
        self._tell("set_profiling", on)

    def set_thread_pool(self, pool):
        """Lends it threads; None takes them away."""
        self._tell("set_thread_pool", pool._handle if pool else None)
        self._pool = pool  # which must live as long

    # --- callbacks --------------------------------------------------------------------------

    def _set_callback(self, name, kind, function):
        callback = kind(guarded(function, otherwise=True)) if function else kind()
        self._tell(f"set_{name}", callback, None)
        self._callbacks[name] = callback  # not before: the world may have refused it

    def set_should_collide(self, function):
        """Asks function(a, b) whether two bodies that come near each other collide; None asks
        nobody. It may look at the world, but not change it; what it raises comes out of step()
        when the tick has gone to its end as if nobody had been asked; sulfur/c/callbacks.h."""
        world = weakref.ref(self)  # else the world would keep itself
        self._set_callback("should_collide", c.ShouldCollideFunction, function and (
            lambda _, a, b: bool(function(Body(world(), a), Body(world(), b)))))

    def set_pre_solve(self, function):
        """Asks function(contact, surface) of each contact, before it is solved, whether it acts;
        None asks nobody. contact is a sulfur.c.PreSolveContact, surface a Material, which it may
        change. Otherwise as set_should_collide()."""
        def ask(_, contact, surface):
            changed = c.Material.from_buffer_copy(surface.contents)
            acts = bool(function(c.PreSolveContact.from_buffer_copy(contact.contents), changed))
            surface[0] = changed
            return acts

        self._set_callback("pre_solve", c.PreSolveFunction, function and ask)

    # --- what happened ----------------------------------------------------------------------

    @property
    def events(self):
        """Lists of what happened in the last tick, by name: contacts_begun, joints_broken ..."""
        told = self._ask(c.Events, "events")
        lists = {name[:-len("_count")] for name, _ in c.Events._fields_ if name.endswith("_count")}
        return {name: [type(entry).from_buffer_copy(entry) for entry in
                       getattr(told, name)[:getattr(told, name + "_count")]] for name in lists}

    @property
    def contacts(self):
        """Contacts that push."""
        return self._ask_list(c.ContactInfo, "contacts")

    # --- queries ----------------------------------------------------------------------------

    def _filter(self, accept=None, ignore=None, **options):
        """A struct, which keeps alive what it points to."""
        if ignore is not None:
            options["ignore"] = ignore.id
        if accept is not None:
            options["accept"] = c.AcceptFunction(
                guarded(lambda _, id: bool(accept(Body(self, id)))))
        return options_of("query_filter", options)

    def _cast(self, kind, question, *arguments, **options):
        return find(kind, f"sulfur_world_{question}", self._handle, *arguments,
                     ctypes.byref(self._filter(**options)))

    def cast_segment(self, start, end, **options):
        """The first surface between two points, or None: mask, ignore, sensors, accept."""
        return find(c.CastHit, "sulfur_world_cast_segment", self._handle, vec(start), vec(end),
                     ctypes.byref(self._filter(**options)))

    def cast_ray(self, start, direction, reach, **options):
        """The first surface in a direction, or None."""
        return self._cast(c.CastHit, "cast_ray", vec(start), vec(direction), reach, **options)

    def cast_all(self, start, end, **options):
        """All capsules and discs between two points, nearest first."""
        return self._ask_list(c.CastHit, "cast_all", vec(start), vec(end),
                              ctypes.byref(self._filter(**options)))

    def cast_shape(self, shape, translation, **options):
        """The first surface that a moved shape meets, or None."""
        return self._cast(c.CastHit, "cast_shape", ctypes.byref(shape), vec(translation),
                          **options)

    def closest_point(self, point, reach, **options):
        """The place of a surface that is nearest to a point, or None."""
        return self._cast(c.ClosestPoint, "closest_point", vec(point), reach, **options)

    def overlap(self, shape, **options):
        """All bodies that touch or enclose a shape."""
        return self._ask_list(c.Overlap, "overlap", ctypes.byref(shape),
                              ctypes.byref(self._filter(**options)))

    def bodies_at(self, point, **options):
        """All bodies that contain a point."""
        return [Body(self, id) for id in self._ask_list(
            c.BodyId, "bodies_at", vec(point), ctypes.byref(self._filter(**options)))]

    def bodies_in(self, low, high, **options):
        """All bodies in an upright rectangle, also those without a surface."""
        return [Body(self, id) for id in self._ask_list(
            c.BodyId, "bodies_in", vec(low), vec(high),
            ctypes.byref(self._filter(**options)))]

    def nearest_particle(self, point, reach):
        """The particle nearest to a point, or None."""
        found = find(c.ParticleId, "sulfur_world_nearest_particle", self._handle, vec(point),
                      reach)
        return found and Particle(self, found)

    def draw(self, visitor, **options):
        """Calls those of visitor's methods body, particle, disc, joint, capsule, contact,
        attachment, field, grab, mechanism and angle that it has, each with a struct of sulfur.c
        that is valid only meanwhile: sulfur/c/draw.h."""
        functions = c.DebugDraw()
        for name, kind in c.DebugDraw._fields_[1:]:
            method = getattr(visitor, name, None)
            if method is not None:
                setattr(functions, name, kind(guarded(
                    lambda _, shown, method=method: method(shown.contents))))
        self._tell("draw", ctypes.byref(functions),
                   ctypes.byref(options_of("draw_options", options)))
