"""The C interface of Sulfur for ctypes: structs, constants, types of functions, functions.

Made by declare.py from sulfur/c/*.h, which say what all of it means. The package makes classes
of it.
"""
from ctypes import (CFUNCTYPE, POINTER, Structure, c_bool, c_char_p, c_double, c_int32, c_size_t,
                    c_uint32, c_uint64, c_void_p)

OK = 0
NOT_FINITE = 1
OUT_OF_RANGE = 2
BAD_INDEX = 3
STALE_HANDLE = 4
DEGENERATE = 5
BAD_SNAPSHOT = 6
TORN = 7
IN_CALLBACK = 8
NO_MEMORY = 9
NULL_POINTER = 10
FAILED = 11


class Vec(Structure):
    _fields_ = [
        ("x", c_double),
        ("y", c_double),
    ]


class Pose(Structure):
    _fields_ = [
        ("position", Vec),
        ("angle", c_double),
    ]


class Bounds(Structure):
    _fields_ = [
        ("low", Vec),
        ("high", Vec),
    ]


class ParticleId(Structure):
    _fields_ = [
        ("index", c_uint32),
        ("generation", c_uint32),
    ]


class JointId(Structure):
    _fields_ = [
        ("index", c_uint32),
        ("generation", c_uint32),
    ]


class BodyId(Structure):
    _fields_ = [
        ("index", c_uint32),
        ("generation", c_uint32),
    ]


class AttachmentId(Structure):
    _fields_ = [
        ("index", c_uint32),
        ("generation", c_uint32),
    ]


class FieldId(Structure):
    _fields_ = [
        ("index", c_uint32),
        ("generation", c_uint32),
    ]


class GrabId(Structure):
    _fields_ = [
        ("index", c_uint32),
        ("generation", c_uint32),
    ]


class MechanismId(Structure):
    _fields_ = [
        ("index", c_uint32),
        ("generation", c_uint32),
    ]


class AngleId(Structure):
    _fields_ = [
        ("index", c_uint32),
        ("generation", c_uint32),
    ]


class Material(Structure):
    _fields_ = [
        ("static_friction", c_double),
        ("kinetic_friction", c_double),
        ("restitution", c_double),
        ("surface_speed", c_double),
        ("rolling_resistance", c_double),
    ]


class Filter(Structure):
    _fields_ = [
        ("category", c_uint32),
        ("mask", c_uint32),
        ("group", c_int32),
    ]


class ParticleSpec(Structure):
    _fields_ = [
        ("position", Vec),
        ("mass", c_double),
        ("radius", c_double),
        ("pinned", c_bool),
    ]


class JointSpec(Structure):
    _fields_ = [
        ("a", c_uint32),
        ("b", c_uint32),
        ("stiffness", c_double),
        ("damping", c_double),
        ("has_rest_length", c_bool),
        ("rest_length", c_double),
        ("radius", c_double),
        ("strength", c_double),
        ("has_material", c_bool),
        ("material", Material),
        ("bend", c_double),
    ]


class AngularJointSpec(Structure):
    _fields_ = [
        ("a", c_uint32),
        ("b", c_uint32),
        ("c", c_uint32),
        ("stiffness", c_double),
        ("damping", c_double),
        ("has_rest_angle", c_bool),
        ("rest_angle", c_double),
        ("lower", c_double),
        ("upper", c_double),
        ("motor_speed", c_double),
        ("motor_max", c_double),
        ("has_motor_target", c_bool),
        ("motor_target", c_double),
        ("strength", c_double),
    ]


class Skin(Structure):
    _fields_ = [
        ("texture", c_char_p),
        ("uv", POINTER(Vec)),
        ("uv_count", c_size_t),
        ("triangles", POINTER(c_uint32)),
        ("triangle_count", c_size_t),
    ]


DYNAMIC = 0
KINEMATIC = 1
FIXED = 2


class GroundOptions(Structure):
    _fields_ = [
        ("points", POINTER(Vec)),
        ("point_count", c_size_t),
        ("closed", c_bool),
        ("radius", c_double),
        ("material", Material),
        ("bends", POINTER(c_double)),
        ("bend_count", c_size_t),
    ]


class BoxOptions(Structure):
    _fields_ = [
        ("size", Vec),
        ("mass", c_double),
        ("radius", c_double),
        ("stiffness", c_double),
        ("damping", c_double),
        ("strength", c_double),
        ("solid_inertia", c_bool),
        ("rounded", c_bool),
        ("material", Material),
    ]


class PolygonOptions(Structure):
    _fields_ = [
        ("points", POINTER(Vec)),
        ("point_count", c_size_t),
        ("mass", c_double),
        ("radius", c_double),
        ("stiffness", c_double),
        ("damping", c_double),
        ("strength", c_double),
        ("rounded", c_bool),
        ("material", Material),
    ]


class BallOptions(Structure):
    _fields_ = [
        ("radius", c_double),
        ("mass", c_double),
        ("material", Material),
    ]


class WheelOptions(Structure):
    _fields_ = [
        ("radius", c_double),
        ("segments", c_int32),
        ("mass", c_double),
        ("rim_radius", c_double),
        ("spoke_stiffness", c_double),
        ("spoke_damping", c_double),
        ("strength", c_double),
        ("material", Material),
    ]


class RopeOptions(Structure):
    _fields_ = [
        ("from", Vec),
        ("to", Vec),
        ("links", c_int32),
        ("has_slack", c_bool),
        ("slack", c_double),
        ("mass", c_double),
        ("radius", c_double),
        ("stiffness", c_double),
        ("damping", c_double),
        ("bending", c_double),
        ("bending_damping", c_double),
        ("strength", c_double),
        ("pin_first", c_bool),
        ("pin_last", c_bool),
        ("material", Material),
    ]


class ChainOptions(Structure):
    _fields_ = [
        ("from", Vec),
        ("to", Vec),
        ("links", c_int32),
        ("mass", c_double),
        ("radius", c_double),
        ("strength", c_double),
        ("pin_first", c_bool),
        ("pin_last", c_bool),
        ("material", Material),
    ]


class BridgeOptions(Structure):
    _fields_ = [
        ("from", Vec),
        ("to", Vec),
        ("planks", c_int32),
        ("sag", c_double),
        ("mass", c_double),
        ("radius", c_double),
        ("stiffness", c_double),
        ("damping", c_double),
        ("strength", c_double),
        ("material", Material),
    ]


class JellyOptions(Structure):
    _fields_ = [
        ("size", Vec),
        ("columns", c_int32),
        ("rows", c_int32),
        ("mass", c_double),
        ("radius", c_double),
        ("stiffness", c_double),
        ("damping", c_double),
        ("strength", c_double),
        ("material", Material),
    ]


class ClothOptions(Structure):
    _fields_ = [
        ("size", Vec),
        ("columns", c_int32),
        ("rows", c_int32),
        ("mass", c_double),
        ("radius", c_double),
        ("diagonals", c_bool),
        ("pin_corners", c_bool),
        ("stiffness", c_double),
        ("damping", c_double),
        ("strength", c_double),
        ("material", Material),
    ]


class WallOptions(Structure):
    _fields_ = [
        ("size", Vec),
        ("columns", c_int32),
        ("rows", c_int32),
        ("mass", c_double),
        ("radius", c_double),
        ("stiffness", c_double),
        ("damping", c_double),
        ("strength", c_double),
        ("pin_bottom", c_bool),
        ("material", Material),
    ]


class BlobOptions(Structure):
    _fields_ = [
        ("radius", c_double),
        ("segments", c_int32),
        ("mass", c_double),
        ("skin_radius", c_double),
        ("stiffness", c_double),
        ("damping", c_double),
        ("material", Material),
    ]


EVERYWHERE = 0
BOX_ZONE = 1
CIRCLE_ZONE = 2


class Zone(Structure):
    _fields_ = [
        ("kind", c_int32),
        ("low", Vec),
        ("high", Vec),
        ("centre", Vec),
        ("radius", c_double),
    ]


AXIAL_DAMPER = 0
FULL_DAMPER = 1
COULOMB_FRICTION = 0
SLIDING_FRICTION = 1


class WorldSettings(Structure):
    _fields_ = [
        ("gravity", Vec),
        ("air_friction", c_double),
        ("tick_rate", c_int32),
        ("sleeping", c_bool),
        ("damper", c_int32),
        ("friction", c_int32),
        ("tell_persisting", c_bool),
        ("sweeps", c_int32),
        ("has_sleep_speed", c_bool),
        ("sleep_speed", c_double),
        ("has_rebound_speed", c_bool),
        ("rebound_speed", c_double),
    ]


STAGE_COUNT = 11


class Statistics(Structure):
    _fields_ = [
        ("particles", c_uint32),
        ("joints", c_uint32),
        ("bodies", c_uint32),
        ("awake_particles", c_uint32),
        ("explicit_joints", c_uint32),
        ("implicit_joints", c_uint32),
        ("rigid_joints", c_uint32),
        ("swept_joints", c_uint32),
        ("explicit_angles", c_uint32),
        ("implicit_angles", c_uint32),
        ("clusters", c_uint32),
        ("trees", c_uint32),
        ("chain_steps", c_uint32),
        ("chains_in_lanes", c_uint32),
        ("chain_fallbacks", c_uint32),
        ("networks", c_uint32),
        ("network_factors", c_uint32),
        ("triangles", c_uint32),
        ("pressed_triangles", c_uint32),
        ("candidates", c_uint32),
        ("looks", c_uint32),
        ("contacts", c_uint32),
        ("boxes", c_uint32),
        ("substeps", c_uint32),
        ("damped_joints", c_uint32),
        ("breakable_joints", c_uint32),
        ("fast_pairs", c_uint32),
        ("held_back", c_uint32),
        ("idle_ticks", c_uint64),
        ("items", c_uint32 * 11),
        ("seconds", c_double * 11),
    ]


class MemoryUse(Structure):
    _fields_ = [
        ("name", c_char_p),
        ("items", c_size_t),
        ("bytes", c_size_t),
        ("hot", c_bool),
    ]


ThreadsFunction = CFUNCTYPE(c_size_t, c_void_p)
TaskFunction = CFUNCTYPE(None, c_void_p, c_size_t)
RunFunction = CFUNCTYPE(None, c_void_p, c_size_t, TaskFunction, c_void_p)
OverheadFunction = CFUNCTYPE(c_double, c_void_p)
RestFunction = CFUNCTYPE(None, c_void_p)


class Tasks(Structure):
    _fields_ = [
        ("user", c_void_p),
        ("threads", ThreadsFunction),
        ("run", RunFunction),
        ("overhead", OverheadFunction),
        ("rest", RestFunction),
    ]


UNIFORM_FIELD = 0
RADIAL_FIELD = 1
WIND_FIELD = 2


class UniformField(Structure):
    _fields_ = [
        ("zone", Zone),
        ("acceleration", Vec),
        ("mask", c_uint32),
    ]


class RadialField(Structure):
    _fields_ = [
        ("centre", Vec),
        ("strength", c_double),
        ("falloff", c_int32),
        ("core", c_double),
        ("reach", c_double),
        ("mask", c_uint32),
    ]


class WindField(Structure):
    _fields_ = [
        ("zone", Zone),
        ("velocity", Vec),
        ("drag", c_double),
        ("mask", c_uint32),
    ]


class Field(Structure):
    _fields_ = [
        ("kind", c_int32),
        ("uniform", UniformField),
        ("radial", RadialField),
        ("wind", WindField),
    ]


class BodyPair(Structure):
    _fields_ = [
        ("a", BodyId),
        ("b", BodyId),
    ]


class Drive(Structure):
    _fields_ = [
        ("lower", c_double),
        ("upper", c_double),
        ("stiffness", c_double),
        ("damping", c_double),
        ("rest", c_double),
        ("motor_speed", c_double),
        ("motor_max", c_double),
        ("has_motor_target", c_bool),
        ("motor_target", c_double),
        ("strength", c_double),
    ]


class HingeOptions(Structure):
    _fields_ = [
        ("drive", Drive),
        ("collide", c_bool),
        ("pin", c_bool),
        ("strength", c_double),
        ("value", c_double),
    ]


class WeldOptions(Structure):
    _fields_ = [
        ("stiffness", c_double),
        ("damping", c_double),
        ("collide", c_bool),
        ("strength", c_double),
        ("torque_strength", c_double),
        ("value", c_double),
    ]


class SliderOptions(Structure):
    _fields_ = [
        ("drive", Drive),
        ("collide", c_bool),
        ("turns", c_bool),
        ("value", c_double),
    ]


class WheelMechanismOptions(Structure):
    _fields_ = [
        ("spring", Drive),
        ("motor", Drive),
        ("collide", c_bool),
    ]


class DistanceOptions(Structure):
    _fields_ = [
        ("drive", Drive),
        ("collide", c_bool),
    ]


class PulleyOptions(Structure):
    _fields_ = [
        ("ratio", c_double),
        ("has_length", c_bool),
        ("length", c_double),
        ("strength", c_double),
    ]


class WheelIds(Structure):
    _fields_ = [
        ("spring", MechanismId),
        ("motor", MechanismId),
    ]


HINGE = 0
SLIDER = 1
DISTANCE = 2
PULLEY = 3
GEAR = 4
WELD = 5


class MechanismInfo(Structure):
    _fields_ = [
        ("kind", c_int32),
        ("a", BodyId),
        ("b", BodyId),
        ("point_a", Vec),
        ("point_b", Vec),
        ("value", c_double),
        ("speed", c_double),
        ("force", c_double),
        ("holding", Vec),
        ("at_lower", c_bool),
        ("at_upper", c_bool),
        ("drive", Drive),
        ("ratio", c_double),
        ("collide", c_bool),
        ("vetoes", c_bool),
        ("pin", c_bool),
        ("strength", c_double),
        ("turns", c_bool),
        ("axis", Vec),
        ("rail_begin", c_double),
        ("over_a", Vec),
        ("over_b", Vec),
        ("frame", BodyId),
        ("first", MechanismId),
        ("second", MechanismId),
        ("pin_1", AttachmentId),
        ("pin_2", AttachmentId),
        ("own_1", BodyId),
        ("own_2", BodyId),
    ]


class ParticleInfo(Structure):
    _fields_ = [
        ("body", BodyId),
        ("position", Vec),
        ("velocity", Vec),
        ("mass", c_double),
        ("radius", c_double),
        ("pinned", c_bool),
        ("angle", c_double),
        ("spin", c_double),
    ]


class ConnectOptions(Structure):
    _fields_ = [
        ("stiffness", c_double),
        ("damping", c_double),
        ("has_rest_length", c_bool),
        ("rest_length", c_double),
        ("radius", c_double),
        ("strength", c_double),
        ("has_material", c_bool),
        ("material", Material),
    ]


class JointInfo(Structure):
    _fields_ = [
        ("body", BodyId),
        ("a", ParticleId),
        ("b", ParticleId),
        ("rest_length", c_double),
        ("stiffness", c_double),
        ("damping", c_double),
        ("radius", c_double),
        ("strength", c_double),
        ("force", c_double),
        ("bend", c_double),
    ]


class AngleInfo(Structure):
    _fields_ = [
        ("id", AngleId),
        ("body", BodyId),
        ("a", ParticleId),
        ("b", ParticleId),
        ("c", ParticleId),
        ("drive", Drive),
        ("angle", c_double),
        ("torque", c_double),
        ("at_lower", c_bool),
        ("at_upper", c_bool),
    ]


class AttachmentInfo(Structure):
    _fields_ = [
        ("particle", ParticleId),
        ("count", c_uint32),
        ("supports", ParticleId * 3),
        ("weights", c_double * 3),
    ]


class GrabOptions(Structure):
    _fields_ = [
        ("frequency", c_double),
        ("damping_ratio", c_double),
        ("has_max_force", c_bool),
        ("max_force", c_double),
    ]


class GrabInfo(Structure):
    _fields_ = [
        ("body", BodyId),
        ("point", Vec),
        ("target", Vec),
        ("force", Vec),
    ]


AcceptFunction = CFUNCTYPE(c_bool, c_void_p, BodyId)


class QueryFilter(Structure):
    _fields_ = [
        ("mask", c_uint32),
        ("ignore", BodyId),
        ("sensors", c_bool),
        ("accept", AcceptFunction),
        ("user", c_void_p),
    ]


class CastHit(Structure):
    _fields_ = [
        ("body", BodyId),
        ("joint", JointId),
        ("particle", ParticleId),
        ("point", Vec),
        ("normal", Vec),
        ("fraction", c_double),
        ("along", c_double),
    ]


class ClosestPoint(Structure):
    _fields_ = [
        ("body", BodyId),
        ("joint", JointId),
        ("particle", ParticleId),
        ("point", Vec),
        ("normal", Vec),
        ("distance", c_double),
        ("along", c_double),
    ]


class Overlap(Structure):
    _fields_ = [
        ("body", BodyId),
        ("joint", JointId),
        ("particle", ParticleId),
    ]


MAX_SHAPE_POINTS = 8


class QueryShape(Structure):
    _fields_ = [
        ("points", Vec * 8),
        ("count", c_uint32),
        ("radius", c_double),
    ]


class ContactBegun(Structure):
    _fields_ = [
        ("a", BodyId),
        ("b", BodyId),
        ("point", Vec),
        ("normal", Vec),
        ("speed", c_double),
        ("impulse", c_double),
    ]


class ContactPersisted(Structure):
    _fields_ = [
        ("a", BodyId),
        ("b", BodyId),
        ("point", Vec),
        ("normal", Vec),
        ("impulse", c_double),
    ]


class ContactEnded(Structure):
    _fields_ = [
        ("a", BodyId),
        ("b", BodyId),
    ]


class JointBroken(Structure):
    _fields_ = [
        ("joint", JointId),
        ("body", BodyId),
        ("point", Vec),
        ("force", c_double),
    ]


class BodySplit(Structure):
    _fields_ = [
        ("body", BodyId),
        ("piece", BodyId),
    ]


class ParticleLost(Structure):
    _fields_ = [
        ("particle", ParticleId),
        ("body", BodyId),
        ("point", Vec),
    ]


class SensorEvent(Structure):
    _fields_ = [
        ("sensor", BodyId),
        ("visitor", BodyId),
    ]


class LimitEvent(Structure):
    _fields_ = [
        ("mechanism", MechanismId),
        ("upper", c_bool),
        ("angle", AngleId),
    ]


class MechanismBroken(Structure):
    _fields_ = [
        ("mechanism", MechanismId),
        ("a", BodyId),
        ("b", BodyId),
        ("force", c_double),
    ]


class AngleBroken(Structure):
    _fields_ = [
        ("angle", AngleId),
        ("body", BodyId),
        ("corner", ParticleId),
        ("torque", c_double),
    ]


class Events(Structure):
    _fields_ = [
        ("contacts_begun", POINTER(ContactBegun)),
        ("contacts_begun_count", c_size_t),
        ("contacts_persisted", POINTER(ContactPersisted)),
        ("contacts_persisted_count", c_size_t),
        ("contacts_ended", POINTER(ContactEnded)),
        ("contacts_ended_count", c_size_t),
        ("joints_broken", POINTER(JointBroken)),
        ("joints_broken_count", c_size_t),
        ("bodies_split", POINTER(BodySplit)),
        ("bodies_split_count", c_size_t),
        ("particles_lost", POINTER(ParticleLost)),
        ("particles_lost_count", c_size_t),
        ("sensors_entered", POINTER(SensorEvent)),
        ("sensors_entered_count", c_size_t),
        ("sensors_left", POINTER(SensorEvent)),
        ("sensors_left_count", c_size_t),
        ("limits_reached", POINTER(LimitEvent)),
        ("limits_reached_count", c_size_t),
        ("limits_left", POINTER(LimitEvent)),
        ("limits_left_count", c_size_t),
        ("mechanisms_broken", POINTER(MechanismBroken)),
        ("mechanisms_broken_count", c_size_t),
        ("angles_broken", POINTER(AngleBroken)),
        ("angles_broken_count", c_size_t),
    ]


class ContactInfo(Structure):
    _fields_ = [
        ("a", BodyId),
        ("b", BodyId),
        ("point", Vec),
        ("normal", Vec),
        ("impulse", c_double),
        ("friction", c_double),
    ]


class DrawOptions(Structure):
    _fields_ = [
        ("bodies", c_bool),
        ("particles", c_bool),
        ("discs", c_bool),
        ("joints", c_bool),
        ("capsules", c_bool),
        ("contacts", c_bool),
        ("attachments", c_bool),
        ("fields", c_bool),
        ("grabs", c_bool),
        ("mechanisms", c_bool),
        ("angles", c_bool),
        ("alpha", c_double),
        ("view", Zone),
    ]


class DrawnParticle(Structure):
    _fields_ = [
        ("id", ParticleId),
        ("body", BodyId),
        ("place", Vec),
        ("velocity", Vec),
        ("pinned", c_bool),
        ("asleep", c_bool),
    ]


class DrawnDisc(Structure):
    _fields_ = [
        ("id", ParticleId),
        ("body", BodyId),
        ("centre", Vec),
        ("radius", c_double),
        ("asleep", c_bool),
    ]


class DrawnJoint(Structure):
    _fields_ = [
        ("id", JointId),
        ("body", BodyId),
        ("a", Vec),
        ("b", Vec),
        ("force", c_double),
        ("strength", c_double),
        ("stiffness", c_double),
        ("asleep", c_bool),
    ]


class DrawnCapsule(Structure):
    _fields_ = [
        ("id", JointId),
        ("body", BodyId),
        ("a", Vec),
        ("b", Vec),
        ("radius", c_double),
        ("asleep", c_bool),
    ]


class DrawnBody(Structure):
    _fields_ = [
        ("id", BodyId),
        ("kind", c_int32),
        ("centre_of_mass", Vec),
        ("low", Vec),
        ("high", Vec),
        ("asleep", c_bool),
    ]


class DrawnAttachment(Structure):
    _fields_ = [
        ("id", AttachmentId),
        ("particle", Vec),
        ("point", Vec),
        ("supports", Vec * 3),
        ("count", c_uint32),
    ]


class DrawnField(Structure):
    _fields_ = [
        ("id", FieldId),
        ("field", Field),
    ]


class DrawnGrab(Structure):
    _fields_ = [
        ("id", GrabId),
        ("info", GrabInfo),
    ]


class DrawnMechanism(Structure):
    _fields_ = [
        ("id", MechanismId),
        ("info", MechanismInfo),
        ("places", Vec * 4),
        ("count", c_uint32),
    ]


class DrawnAngle(Structure):
    _fields_ = [
        ("info", AngleInfo),
        ("a", Vec),
        ("b", Vec),
        ("c", Vec),
        ("asleep", c_bool),
    ]


DrawBody = CFUNCTYPE(None, c_void_p, POINTER(DrawnBody))
DrawParticle = CFUNCTYPE(None, c_void_p, POINTER(DrawnParticle))
DrawDisc = CFUNCTYPE(None, c_void_p, POINTER(DrawnDisc))
DrawJoint = CFUNCTYPE(None, c_void_p, POINTER(DrawnJoint))
DrawCapsule = CFUNCTYPE(None, c_void_p, POINTER(DrawnCapsule))
DrawContact = CFUNCTYPE(None, c_void_p, POINTER(ContactInfo))
DrawAttachment = CFUNCTYPE(None, c_void_p, POINTER(DrawnAttachment))
DrawField = CFUNCTYPE(None, c_void_p, POINTER(DrawnField))
DrawGrab = CFUNCTYPE(None, c_void_p, POINTER(DrawnGrab))
DrawMechanism = CFUNCTYPE(None, c_void_p, POINTER(DrawnMechanism))
DrawAngle = CFUNCTYPE(None, c_void_p, POINTER(DrawnAngle))


class DebugDraw(Structure):
    _fields_ = [
        ("user", c_void_p),
        ("body", DrawBody),
        ("particle", DrawParticle),
        ("disc", DrawDisc),
        ("joint", DrawJoint),
        ("capsule", DrawCapsule),
        ("contact", DrawContact),
        ("attachment", DrawAttachment),
        ("field", DrawField),
        ("grab", DrawGrab),
        ("mechanism", DrawMechanism),
        ("angle", DrawAngle),
    ]


ShouldCollideFunction = CFUNCTYPE(c_bool, c_void_p, BodyId, BodyId)


class PreSolveContact(Structure):
    _fields_ = [
        ("a", BodyId),
        ("b", BodyId),
        ("point", Vec),
        ("normal", Vec),
        ("speed", c_double),
        ("gap", c_double),
    ]


PreSolveFunction = CFUNCTYPE(c_bool, c_void_p, POINTER(PreSolveContact), POINTER(Material))


FUNCTIONS = {  # name: type of the result, types of the parameters
    "sulfur_last_error": (c_char_p, []),
    "sulfur_result_name": (c_char_p, [c_int32]),
    "sulfur_version": (c_char_p, []),
    "sulfur_double_precision": (c_bool, []),
    "sulfur_material_default": (Material, []),
    "sulfur_filter_default": (Filter, []),
    "sulfur_may_collide": (c_bool, [Filter, Filter]),
    "sulfur_particle_spec_default": (ParticleSpec, []),
    "sulfur_joint_spec_default": (JointSpec, []),
    "sulfur_angular_joint_spec_default": (AngularJointSpec, []),
    "sulfur_skin_default": (Skin, []),
    "sulfur_blueprint_create": (c_int32, [POINTER(c_void_p)]),
    "sulfur_blueprint_copy": (c_int32, [c_void_p, POINTER(c_void_p)]),
    "sulfur_blueprint_destroy": (None, [c_void_p]),
    "sulfur_blueprint_validate": (c_int32, [c_void_p]),
    "sulfur_blueprint_mass": (c_int32, [c_void_p, POINTER(c_double)]),
    "sulfur_blueprint_centre_of_mass": (c_int32, [c_void_p, POINTER(Vec)]),
    "sulfur_blueprint_name": (c_int32, [c_void_p, POINTER(c_char_p)]),
    "sulfur_blueprint_set_name": (c_int32, [c_void_p, c_char_p]),
    "sulfur_blueprint_kind": (c_int32, [c_void_p, POINTER(c_int32)]),
    "sulfur_blueprint_set_kind": (c_int32, [c_void_p, c_int32]),
    "sulfur_blueprint_material": (c_int32, [c_void_p, POINTER(Material)]),
    "sulfur_blueprint_set_material": (c_int32, [c_void_p, Material]),
    "sulfur_blueprint_filter": (c_int32, [c_void_p, POINTER(Filter)]),
    "sulfur_blueprint_set_filter": (c_int32, [c_void_p, Filter]),
    "sulfur_blueprint_self_collision": (c_int32, [c_void_p, POINTER(c_bool)]),
    "sulfur_blueprint_set_self_collision": (c_int32, [c_void_p, c_bool]),
    "sulfur_blueprint_sensor": (c_int32, [c_void_p, POINTER(c_bool)]),
    "sulfur_blueprint_set_sensor": (c_int32, [c_void_p, c_bool]),
    "sulfur_blueprint_skin": (c_int32, [c_void_p, POINTER(Skin), POINTER(c_bool)]),
    "sulfur_blueprint_set_skin": (c_int32, [c_void_p, POINTER(Skin)]),
    "sulfur_blueprint_particle_count": (c_int32, [c_void_p, POINTER(c_size_t)]),
    "sulfur_blueprint_particle": (c_int32, [c_void_p, c_size_t, POINTER(ParticleSpec)]),
    "sulfur_blueprint_set_particle": (c_int32, [c_void_p, c_size_t, ParticleSpec]),
    "sulfur_blueprint_add_particle": (c_int32, [c_void_p, ParticleSpec, POINTER(c_uint32)]),
    "sulfur_blueprint_joint_count": (c_int32, [c_void_p, POINTER(c_size_t)]),
    "sulfur_blueprint_joint": (c_int32, [c_void_p, c_size_t, POINTER(JointSpec)]),
    "sulfur_blueprint_set_joint": (c_int32, [c_void_p, c_size_t, JointSpec]),
    "sulfur_blueprint_add_joint": (c_int32, [c_void_p, JointSpec, POINTER(c_uint32)]),
    "sulfur_blueprint_angle_count": (c_int32, [c_void_p, POINTER(c_size_t)]),
    "sulfur_blueprint_angle": (c_int32, [c_void_p, c_size_t, POINTER(AngularJointSpec)]),
    "sulfur_blueprint_set_angle": (c_int32, [c_void_p, c_size_t, AngularJointSpec]),
    "sulfur_blueprint_add_angle": (c_int32, [c_void_p, AngularJointSpec, POINTER(c_uint32)]),
    "sulfur_ground_options_default": (GroundOptions, []),
    "sulfur_shape_ground": (c_int32, [POINTER(GroundOptions), POINTER(c_void_p)]),
    "sulfur_shape_floor": (c_int32, [Vec, Vec, c_double, POINTER(c_void_p)]),
    "sulfur_box_options_default": (BoxOptions, []),
    "sulfur_shape_box": (c_int32, [POINTER(BoxOptions), POINTER(c_void_p)]),
    "sulfur_polygon_options_default": (PolygonOptions, []),
    "sulfur_shape_polygon": (c_int32, [POINTER(PolygonOptions), POINTER(c_void_p)]),
    "sulfur_ball_options_default": (BallOptions, []),
    "sulfur_shape_ball": (c_int32, [POINTER(BallOptions), POINTER(c_void_p)]),
    "sulfur_wheel_options_default": (WheelOptions, []),
    "sulfur_shape_wheel": (c_int32, [POINTER(WheelOptions), POINTER(c_void_p)]),
    "sulfur_rope_options_default": (RopeOptions, []),
    "sulfur_shape_rope": (c_int32, [POINTER(RopeOptions), POINTER(c_void_p)]),
    "sulfur_chain_options_default": (ChainOptions, []),
    "sulfur_shape_chain": (c_int32, [POINTER(ChainOptions), POINTER(c_void_p)]),
    "sulfur_bridge_options_default": (BridgeOptions, []),
    "sulfur_shape_bridge": (c_int32, [POINTER(BridgeOptions), POINTER(c_void_p)]),
    "sulfur_jelly_options_default": (JellyOptions, []),
    "sulfur_shape_jelly": (c_int32, [POINTER(JellyOptions), POINTER(c_void_p)]),
    "sulfur_cloth_options_default": (ClothOptions, []),
    "sulfur_shape_cloth": (c_int32, [POINTER(ClothOptions), POINTER(c_void_p)]),
    "sulfur_wall_options_default": (WallOptions, []),
    "sulfur_shape_wall": (c_int32, [POINTER(WallOptions), POINTER(c_void_p)]),
    "sulfur_blob_options_default": (BlobOptions, []),
    "sulfur_shape_blob": (c_int32, [POINTER(BlobOptions), POINTER(c_void_p)]),
    "sulfur_zone_default": (Zone, []),
    "sulfur_world_settings_default": (WorldSettings, []),
    "sulfur_world_create": (c_int32, [POINTER(WorldSettings), POINTER(c_void_p)]),
    "sulfur_world_clone": (c_int32, [c_void_p, POINTER(c_void_p)]),
    "sulfur_world_destroy": (None, [c_void_p]),
    "sulfur_world_step": (c_int32, [c_void_p]),
    "sulfur_world_ticks": (c_int32, [c_void_p, POINTER(c_uint64)]),
    "sulfur_world_time": (c_int32, [c_void_p, POINTER(c_double)]),
    "sulfur_world_tick_duration": (c_int32, [c_void_p, POINTER(c_double)]),
    "sulfur_world_settings": (c_int32, [c_void_p, POINTER(WorldSettings)]),
    "sulfur_world_gravity": (c_int32, [c_void_p, POINTER(Vec)]),
    "sulfur_world_set_gravity": (c_int32, [c_void_p, Vec]),
    "sulfur_world_air_friction": (c_int32, [c_void_p, POINTER(c_double)]),
    "sulfur_world_set_air_friction": (c_int32, [c_void_p, c_double]),
    "sulfur_world_set_tick_rate": (c_int32, [c_void_p, c_int32]),
    "sulfur_world_set_damper": (c_int32, [c_void_p, c_int32]),
    "sulfur_world_energy": (c_int32, [c_void_p, POINTER(c_double)]),
    "sulfur_world_hash": (c_int32, [c_void_p, POINTER(c_uint64)]),
    "sulfur_world_snapshot": (c_int32, [c_void_p, POINTER(c_void_p)]),
    "sulfur_snapshot_bytes": (c_int32, [c_void_p, POINTER(c_void_p), POINTER(c_size_t)]),
    "sulfur_snapshot_destroy": (None, [c_void_p]),
    "sulfur_world_restore": (c_int32, [c_void_p, c_void_p, c_size_t]),
    "sulfur_world_validate": (c_int32, [c_void_p, POINTER(c_char_p)]),
    "sulfur_stage_name": (c_char_p, [c_int32]),
    "sulfur_world_statistics": (c_int32, [c_void_p, POINTER(Statistics)]),
    "sulfur_world_set_profiling": (c_int32, [c_void_p, c_bool]),
    "sulfur_world_memory": (c_int32, [c_void_p, POINTER(MemoryUse), c_size_t, POINTER(c_size_t)]),
    "sulfur_thread_pool_create": (c_int32, [c_size_t, POINTER(c_void_p)]),
    "sulfur_thread_pool_destroy": (None, [c_void_p]),
    "sulfur_world_set_thread_pool": (c_int32, [c_void_p, c_void_p]),
    "sulfur_tasks_default": (Tasks, []),
    "sulfur_world_set_tasks": (c_int32, [c_void_p, POINTER(Tasks)]),
    "sulfur_field_default": (Field, [c_int32]),
    "sulfur_world_add_field": (c_int32, [c_void_p, POINTER(Field), POINTER(FieldId)]),
    "sulfur_field_set": (c_int32, [c_void_p, FieldId, POINTER(Field)]),
    "sulfur_field_info": (c_int32, [c_void_p, FieldId, POINTER(Field)]),
    "sulfur_field_remove": (c_int32, [c_void_p, FieldId]),
    "sulfur_field_exists": (c_int32, [c_void_p, FieldId, POINTER(c_bool)]),
    "sulfur_world_fields": (c_int32, [c_void_p, POINTER(FieldId), c_size_t, POINTER(c_size_t)]),
    "sulfur_preset_world": (WorldSettings, []),
    "sulfur_preset_rope": (RopeOptions, [c_double]),
    "sulfur_preset_plain_box": (BoxOptions, [Vec, c_double]),
    "sulfur_world_add_body": (c_int32, [c_void_p, c_void_p, Pose, POINTER(BodyId)]),
    "sulfur_body_remove": (c_int32, [c_void_p, BodyId]),
    "sulfur_body_exists": (c_int32, [c_void_p, BodyId, POINTER(c_bool)]),
    "sulfur_world_bodies": (c_int32, [c_void_p, POINTER(BodyId), c_size_t, POINTER(c_size_t)]),
    "sulfur_body_particles": (c_int32, [c_void_p, BodyId, POINTER(ParticleId), c_size_t, POINTER(c_size_t)]),
    "sulfur_body_particle": (c_int32, [c_void_p, BodyId, c_size_t, POINTER(ParticleId)]),
    "sulfur_body_joints": (c_int32, [c_void_p, BodyId, POINTER(JointId), c_size_t, POINTER(c_size_t)]),
    "sulfur_body_name": (c_int32, [c_void_p, BodyId, POINTER(c_char_p)]),
    "sulfur_body_kind": (c_int32, [c_void_p, BodyId, POINTER(c_int32)]),
    "sulfur_body_set_kind": (c_int32, [c_void_p, BodyId, c_int32]),
    "sulfur_body_enabled": (c_int32, [c_void_p, BodyId, POINTER(c_bool)]),
    "sulfur_body_set_enabled": (c_int32, [c_void_p, BodyId, c_bool]),
    "sulfur_body_skin": (c_int32, [c_void_p, BodyId, POINTER(Skin), POINTER(c_bool)]),
    "sulfur_body_material": (c_int32, [c_void_p, BodyId, POINTER(Material)]),
    "sulfur_body_set_material": (c_int32, [c_void_p, BodyId, Material]),
    "sulfur_body_filter": (c_int32, [c_void_p, BodyId, POINTER(Filter)]),
    "sulfur_body_set_filter": (c_int32, [c_void_p, BodyId, Filter]),
    "sulfur_body_self_collision": (c_int32, [c_void_p, BodyId, POINTER(c_bool)]),
    "sulfur_body_set_self_collision": (c_int32, [c_void_p, BodyId, c_bool]),
    "sulfur_body_sensor": (c_int32, [c_void_p, BodyId, POINTER(c_bool)]),
    "sulfur_body_set_sensor": (c_int32, [c_void_p, BodyId, c_bool]),
    "sulfur_body_visitors": (c_int32, [c_void_p, BodyId, POINTER(BodyId), c_size_t, POINTER(c_size_t)]),
    "sulfur_body_gravity_scale": (c_int32, [c_void_p, BodyId, POINTER(c_double)]),
    "sulfur_body_set_gravity_scale": (c_int32, [c_void_p, BodyId, c_double]),
    "sulfur_body_fixed_rotation": (c_int32, [c_void_p, BodyId, POINTER(c_bool)]),
    "sulfur_body_set_fixed_rotation": (c_int32, [c_void_p, BodyId, c_bool]),
    "sulfur_body_linear_damping": (c_int32, [c_void_p, BodyId, POINTER(c_double)]),
    "sulfur_body_angular_damping": (c_int32, [c_void_p, BodyId, POINTER(c_double)]),
    "sulfur_body_set_damping": (c_int32, [c_void_p, BodyId, c_double, c_double]),
    "sulfur_body_user_data": (c_int32, [c_void_p, BodyId, POINTER(c_uint64)]),
    "sulfur_body_set_user_data": (c_int32, [c_void_p, BodyId, c_uint64]),
    "sulfur_body_asleep": (c_int32, [c_void_p, BodyId, POINTER(c_bool)]),
    "sulfur_body_wake": (c_int32, [c_void_p, BodyId]),
    "sulfur_body_put_to_sleep": (c_int32, [c_void_p, BodyId, POINTER(c_bool)]),
    "sulfur_body_sleeping_allowed": (c_int32, [c_void_p, BodyId, POINTER(c_bool)]),
    "sulfur_body_set_sleeping_allowed": (c_int32, [c_void_p, BodyId, c_bool]),
    "sulfur_world_collision": (c_int32, [c_void_p, BodyId, BodyId, POINTER(c_bool)]),
    "sulfur_world_set_collision": (c_int32, [c_void_p, BodyId, BodyId, c_bool]),
    "sulfur_world_vetoes": (c_int32, [c_void_p, POINTER(BodyPair), c_size_t, POINTER(c_size_t)]),
    "sulfur_body_pose": (c_int32, [c_void_p, BodyId, POINTER(Pose)]),
    "sulfur_body_interpolated_pose": (c_int32, [c_void_p, BodyId, c_double, POINTER(Pose)]),
    "sulfur_body_to_world": (c_int32, [c_void_p, BodyId, Vec, POINTER(Vec)]),
    "sulfur_body_from_world": (c_int32, [c_void_p, BodyId, Vec, POINTER(Vec)]),
    "sulfur_body_vector_to_world": (c_int32, [c_void_p, BodyId, Vec, POINTER(Vec)]),
    "sulfur_body_vector_from_world": (c_int32, [c_void_p, BodyId, Vec, POINTER(Vec)]),
    "sulfur_body_angle": (c_int32, [c_void_p, BodyId, POINTER(c_double)]),
    "sulfur_body_centre_of_mass": (c_int32, [c_void_p, BodyId, POINTER(Vec)]),
    "sulfur_body_mean_velocity": (c_int32, [c_void_p, BodyId, POINTER(Vec)]),
    "sulfur_body_angular_velocity": (c_int32, [c_void_p, BodyId, POINTER(c_double)]),
    "sulfur_body_mass": (c_int32, [c_void_p, BodyId, POINTER(c_double)]),
    "sulfur_body_inertia": (c_int32, [c_void_p, BodyId, POINTER(c_double)]),
    "sulfur_body_bounds": (c_int32, [c_void_p, BodyId, POINTER(Bounds)]),
    "sulfur_body_set_pose": (c_int32, [c_void_p, BodyId, Pose]),
    "sulfur_body_set_velocity": (c_int32, [c_void_p, BodyId, Vec]),
    "sulfur_body_set_motion": (c_int32, [c_void_p, BodyId, Vec, c_double]),
    "sulfur_body_apply_force": (c_int32, [c_void_p, BodyId, Vec, Vec]),
    "sulfur_body_apply_torque": (c_int32, [c_void_p, BodyId, c_double]),
    "sulfur_body_apply_impulse": (c_int32, [c_void_p, BodyId, Vec, Vec]),
    "sulfur_body_apply_angular_impulse": (c_int32, [c_void_p, BodyId, c_double]),
    "sulfur_body_move_to": (c_int32, [c_void_p, BodyId, Pose]),
    "sulfur_drive_default": (Drive, []),
    "sulfur_hinge_options_default": (HingeOptions, []),
    "sulfur_weld_options_default": (WeldOptions, []),
    "sulfur_slider_options_default": (SliderOptions, []),
    "sulfur_wheel_mechanism_options_default": (WheelMechanismOptions, []),
    "sulfur_distance_options_default": (DistanceOptions, []),
    "sulfur_pulley_options_default": (PulleyOptions, []),
    "sulfur_world_hinge": (c_int32, [c_void_p, BodyId, BodyId, Vec, POINTER(HingeOptions), POINTER(MechanismId)]),
    "sulfur_world_weld": (c_int32, [c_void_p, BodyId, BodyId, Vec, POINTER(WeldOptions), POINTER(MechanismId)]),
    "sulfur_world_slider": (c_int32, [c_void_p, BodyId, BodyId, Vec, Vec, POINTER(SliderOptions), POINTER(MechanismId)]),
    "sulfur_world_slider_on_rail": (c_int32, [c_void_p, BodyId, BodyId, Vec, POINTER(JointId), c_size_t, POINTER(SliderOptions), POINTER(MechanismId)]),
    "sulfur_world_wheel": (c_int32, [c_void_p, BodyId, BodyId, Vec, Vec, POINTER(WheelMechanismOptions), POINTER(WheelIds)]),
    "sulfur_world_distance": (c_int32, [c_void_p, BodyId, Vec, BodyId, Vec, POINTER(DistanceOptions), POINTER(MechanismId)]),
    "sulfur_world_pulley": (c_int32, [c_void_p, BodyId, Vec, Vec, BodyId, Vec, Vec, BodyId, POINTER(PulleyOptions), POINTER(MechanismId)]),
    "sulfur_world_gear": (c_int32, [c_void_p, MechanismId, MechanismId, c_double, POINTER(MechanismId)]),
    "sulfur_mechanism_info": (c_int32, [c_void_p, MechanismId, POINTER(MechanismInfo)]),
    "sulfur_mechanism_rail": (c_int32, [c_void_p, MechanismId, POINTER(JointId), c_size_t, POINTER(c_size_t)]),
    "sulfur_mechanism_set_drive": (c_int32, [c_void_p, MechanismId, POINTER(Drive)]),
    "sulfur_mechanism_remove": (c_int32, [c_void_p, MechanismId]),
    "sulfur_mechanism_exists": (c_int32, [c_void_p, MechanismId, POINTER(c_bool)]),
    "sulfur_world_mechanisms": (c_int32, [c_void_p, POINTER(MechanismId), c_size_t, POINTER(c_size_t)]),
    "sulfur_particle_info": (c_int32, [c_void_p, ParticleId, POINTER(ParticleInfo)]),
    "sulfur_particle_exists": (c_int32, [c_void_p, ParticleId, POINTER(c_bool)]),
    "sulfur_particle_position": (c_int32, [c_void_p, ParticleId, POINTER(Vec)]),
    "sulfur_particle_interpolated": (c_int32, [c_void_p, ParticleId, c_double, POINTER(Vec)]),
    "sulfur_particle_velocity": (c_int32, [c_void_p, ParticleId, POINTER(Vec)]),
    "sulfur_particle_set_position": (c_int32, [c_void_p, ParticleId, Vec]),
    "sulfur_particle_set_velocity": (c_int32, [c_void_p, ParticleId, Vec]),
    "sulfur_particle_set_mass": (c_int32, [c_void_p, ParticleId, c_double]),
    "sulfur_particle_set_pinned": (c_int32, [c_void_p, ParticleId, c_bool]),
    "sulfur_particle_apply_force": (c_int32, [c_void_p, ParticleId, Vec]),
    "sulfur_particle_apply_impulse": (c_int32, [c_void_p, ParticleId, Vec]),
    "sulfur_connect_options_default": (ConnectOptions, []),
    "sulfur_world_connect": (c_int32, [c_void_p, ParticleId, ParticleId, POINTER(ConnectOptions), POINTER(JointId)]),
    "sulfur_joint_remove": (c_int32, [c_void_p, JointId]),
    "sulfur_joint_info": (c_int32, [c_void_p, JointId, POINTER(JointInfo)]),
    "sulfur_joint_exists": (c_int32, [c_void_p, JointId, POINTER(c_bool)]),
    "sulfur_world_connections": (c_int32, [c_void_p, POINTER(JointId), c_size_t, POINTER(c_size_t)]),
    "sulfur_joint_material": (c_int32, [c_void_p, JointId, POINTER(Material)]),
    "sulfur_joint_set_material": (c_int32, [c_void_p, JointId, POINTER(Material)]),
    "sulfur_joint_set_stiffness": (c_int32, [c_void_p, JointId, c_double]),
    "sulfur_joint_set_damping": (c_int32, [c_void_p, JointId, c_double]),
    "sulfur_joint_set_rest_length": (c_int32, [c_void_p, JointId, c_double]),
    "sulfur_joint_set_strength": (c_int32, [c_void_p, JointId, c_double]),
    "sulfur_body_angles": (c_int32, [c_void_p, BodyId, POINTER(AngleInfo), c_size_t, POINTER(c_size_t)]),
    "sulfur_angle_info": (c_int32, [c_void_p, AngleId, POINTER(AngleInfo)]),
    "sulfur_angle_set_drive": (c_int32, [c_void_p, AngleId, POINTER(Drive)]),
    "sulfur_angle_remove": (c_int32, [c_void_p, AngleId]),
    "sulfur_angle_exists": (c_int32, [c_void_p, AngleId, POINTER(c_bool)]),
    "sulfur_world_attach_to_body": (c_int32, [c_void_p, ParticleId, BodyId, Vec, POINTER(AttachmentId)]),
    "sulfur_world_attach_to_joint": (c_int32, [c_void_p, ParticleId, JointId, c_double, POINTER(AttachmentId)]),
    "sulfur_attachment_remove": (c_int32, [c_void_p, AttachmentId]),
    "sulfur_attachment_info": (c_int32, [c_void_p, AttachmentId, POINTER(AttachmentInfo)]),
    "sulfur_attachment_exists": (c_int32, [c_void_p, AttachmentId, POINTER(c_bool)]),
    "sulfur_world_attachments": (c_int32, [c_void_p, POINTER(AttachmentId), c_size_t, POINTER(c_size_t)]),
    "sulfur_grab_options_default": (GrabOptions, []),
    "sulfur_world_grab_particle": (c_int32, [c_void_p, ParticleId, Vec, POINTER(GrabOptions), POINTER(GrabId)]),
    "sulfur_world_grab_body": (c_int32, [c_void_p, BodyId, Vec, Vec, POINTER(GrabOptions), POINTER(GrabId)]),
    "sulfur_grab_set_target": (c_int32, [c_void_p, GrabId, Vec]),
    "sulfur_grab_release": (c_int32, [c_void_p, GrabId]),
    "sulfur_grab_info": (c_int32, [c_void_p, GrabId, POINTER(GrabInfo)]),
    "sulfur_grab_exists": (c_int32, [c_void_p, GrabId, POINTER(c_bool)]),
    "sulfur_world_grabs": (c_int32, [c_void_p, POINTER(GrabId), c_size_t, POINTER(c_size_t)]),
    "sulfur_query_filter_default": (QueryFilter, []),
    "sulfur_query_shape_default": (QueryShape, []),
    "sulfur_query_shape_circle": (c_int32, [Vec, c_double, POINTER(QueryShape)]),
    "sulfur_query_shape_capsule": (c_int32, [Vec, Vec, c_double, POINTER(QueryShape)]),
    "sulfur_query_shape_box": (c_int32, [Vec, Vec, c_double, POINTER(QueryShape)]),
    "sulfur_query_shape_polygon": (c_int32, [POINTER(Vec), c_size_t, c_double, POINTER(QueryShape)]),
    "sulfur_world_cast_segment": (c_int32, [c_void_p, Vec, Vec, POINTER(QueryFilter), POINTER(CastHit), POINTER(c_bool)]),
    "sulfur_world_cast_ray": (c_int32, [c_void_p, Vec, Vec, c_double, POINTER(QueryFilter), POINTER(CastHit), POINTER(c_bool)]),
    "sulfur_world_cast_all": (c_int32, [c_void_p, Vec, Vec, POINTER(QueryFilter), POINTER(CastHit), c_size_t, POINTER(c_size_t)]),
    "sulfur_world_cast_shape": (c_int32, [c_void_p, POINTER(QueryShape), Vec, POINTER(QueryFilter), POINTER(CastHit), POINTER(c_bool)]),
    "sulfur_world_closest_point": (c_int32, [c_void_p, Vec, c_double, POINTER(QueryFilter), POINTER(ClosestPoint), POINTER(c_bool)]),
    "sulfur_world_overlap": (c_int32, [c_void_p, POINTER(QueryShape), POINTER(QueryFilter), POINTER(Overlap), c_size_t, POINTER(c_size_t)]),
    "sulfur_world_overlap_box": (c_int32, [c_void_p, Vec, Vec, POINTER(QueryFilter), POINTER(Overlap), c_size_t, POINTER(c_size_t)]),
    "sulfur_world_overlap_circle": (c_int32, [c_void_p, Vec, c_double, POINTER(QueryFilter), POINTER(Overlap), c_size_t, POINTER(c_size_t)]),
    "sulfur_world_bodies_at": (c_int32, [c_void_p, Vec, POINTER(QueryFilter), POINTER(BodyId), c_size_t, POINTER(c_size_t)]),
    "sulfur_world_bodies_in": (c_int32, [c_void_p, Vec, Vec, POINTER(QueryFilter), POINTER(BodyId), c_size_t, POINTER(c_size_t)]),
    "sulfur_world_nearest_particle": (c_int32, [c_void_p, Vec, c_double, POINTER(ParticleId), POINTER(c_bool)]),
    "sulfur_world_events": (c_int32, [c_void_p, POINTER(Events)]),
    "sulfur_world_contacts": (c_int32, [c_void_p, POINTER(ContactInfo), c_size_t, POINTER(c_size_t)]),
    "sulfur_body_contacts": (c_int32, [c_void_p, BodyId, POINTER(ContactInfo), c_size_t, POINTER(c_size_t)]),
    "sulfur_world_touches": (c_int32, [c_void_p, BodyId, BodyId, POINTER(c_bool)]),
    "sulfur_draw_options_default": (DrawOptions, []),
    "sulfur_debug_draw_default": (DebugDraw, []),
    "sulfur_world_draw": (c_int32, [c_void_p, POINTER(DebugDraw), POINTER(DrawOptions)]),
    "sulfur_world_set_should_collide": (c_int32, [c_void_p, ShouldCollideFunction, c_void_p]),
    "sulfur_world_set_pre_solve": (c_int32, [c_void_p, PreSolveFunction, c_void_p]),
}
