// Values of the C interface as those of C++, and back.
#pragma once

#include <sulfur/c/sulfur.h>

#include <array>
#include <string>
#include <sulfur/sulfur.hpp>
#include <utility>

namespace sulfur::c {

/// Thrown where a pointer is null that must not be.
struct NullPointer {
    const char* what;  // it should point to
};

template <class T>
T& required(T* pointer, const char* what) {
    if (!pointer) throw NullPointer{what};
    return *pointer;
}

// --- from C: throw Error where a value has no counterpart, which the library would have refused --

/// Throws where single precision would make an infinity of a finite number.
Real real(double number);
Vec2 vec(SulfurVec v);
inline Point point(SulfurVec v) {
    return {v.x, v.y};
}
std::vector<Vec2> vectors(const SulfurVec* list, std::size_t count);

inline ParticleId fromC(SulfurParticleId id) {
    return {id.index, id.generation};
}
inline JointId fromC(SulfurJointId id) {
    return {id.index, id.generation};
}
inline BodyId fromC(SulfurBodyId id) {
    return {id.index, id.generation};
}
inline AttachmentId fromC(SulfurAttachmentId id) {
    return {id.index, id.generation};
}
inline FieldId fromC(SulfurFieldId id) {
    return {id.index, id.generation};
}
inline GrabId fromC(SulfurGrabId id) {
    return {id.index, id.generation};
}
inline MechanismId fromC(SulfurMechanismId id) {
    return {id.index, id.generation};
}
inline AngleId fromC(SulfurAngleId id) {
    return {id.index, id.generation};
}
inline Pose fromC(const SulfurPose& pose) {
    return {point(pose.position), pose.angle};
}
inline Filter fromC(const SulfurFilter& filter) {
    return {filter.category, filter.mask, filter.group};
}
Material fromC(const SulfurMaterial& material);
ParticleSpec fromC(const SulfurParticleSpec& particle);
JointSpec fromC(const SulfurJointSpec& joint);
AngularJointSpec fromC(const SulfurAngularJointSpec& angle);
Skin fromC(const SulfurSkin& skin);
BodyKind bodyKind(SulfurBodyKind kind);
Zone fromC(const SulfurZone& zone);
Field fromC(const SulfurField& field);
Damper damper(SulfurDamper damper);
WorldSettings fromC(const SulfurWorldSettings& settings);
ConnectOptions fromC(const SulfurConnectOptions& options);
GrabOptions fromC(const SulfurGrabOptions& options);
Drive fromC(const SulfurDrive& drive);
HingeOptions fromC(const SulfurHingeOptions& options);
WeldOptions fromC(const SulfurWeldOptions& options);
SliderOptions fromC(const SulfurSliderOptions& options);
WheelOptions fromC(const SulfurWheelMechanismOptions& options);
DistanceOptions fromC(const SulfurDistanceOptions& options);
PulleyOptions fromC(const SulfurPulleyOptions& options);
QueryFilter fromC(const SulfurQueryFilter& filter);
QueryShape fromC(const SulfurQueryShape& shape);
DrawOptions fromC(const SulfurDrawOptions& options);
shapes::GroundOptions fromC(const SulfurGroundOptions& options);
shapes::BoxOptions fromC(const SulfurBoxOptions& options);
shapes::PolygonOptions fromC(const SulfurPolygonOptions& options);
shapes::BallOptions fromC(const SulfurBallOptions& options);
shapes::WheelOptions fromC(const SulfurWheelOptions& options);
shapes::RopeOptions fromC(const SulfurRopeOptions& options);
shapes::ChainOptions fromC(const SulfurChainOptions& options);
shapes::BridgeOptions fromC(const SulfurBridgeOptions& options);
shapes::JellyOptions fromC(const SulfurJellyOptions& options);
shapes::ClothOptions fromC(const SulfurClothOptions& options);
shapes::WallOptions fromC(const SulfurWallOptions& options);
shapes::BlobOptions fromC(const SulfurBlobOptions& options);

/// What `options` points at, or the defaults.
template <class Options, class Given>
Options orDefault(const Given* options) {
    return options ? fromC(*options) : Options{};
}

// --- to C ----------------------------------------------------------------------------------------

inline bool toC(bool value) {
    return value;
}
inline std::uint32_t toC(std::uint32_t value) {
    return value;
}
inline std::uint64_t toC(std::uint64_t value) {
    return value;
}
inline double toC(float value) {
    return static_cast<double>(value);
}
inline double toC(double value) {
    return value;
}
inline const char* toC(const std::string& text) {
    return text.c_str();
}
inline SulfurVec toC(const Vec2& v) {
    return {toC(v.x()), toC(v.y())};
}
#ifndef SULFUR_REAL_DOUBLE
inline SulfurVec toC(const Point& p) {
    return {p.x(), p.y()};
}
#endif
inline SulfurParticleId toC(ParticleId id) {
    return {id.index, id.generation};
}
inline SulfurJointId toC(JointId id) {
    return {id.index, id.generation};
}
inline SulfurBodyId toC(BodyId id) {
    return {id.index, id.generation};
}
inline SulfurAttachmentId toC(AttachmentId id) {
    return {id.index, id.generation};
}
inline SulfurFieldId toC(FieldId id) {
    return {id.index, id.generation};
}
inline SulfurGrabId toC(GrabId id) {
    return {id.index, id.generation};
}
inline SulfurMechanismId toC(MechanismId id) {
    return {id.index, id.generation};
}
inline SulfurAngleId toC(AngleId id) {
    return {id.index, id.generation};
}
inline SulfurBodyPair toC(const std::pair<BodyId, BodyId>& pair) {
    return {toC(pair.first), toC(pair.second)};
}
inline SulfurPose toC(const Pose& pose) {
    return {toC(pose.position), pose.angle};
}
inline SulfurBounds toC(const Bounds& bounds) {
    return {toC(bounds.low), toC(bounds.high)};
}
inline SulfurFilter toC(const Filter& filter) {
    return {filter.category, filter.mask, filter.group};
}
inline SulfurBodyKind toC(BodyKind kind) {
    return static_cast<SulfurBodyKind>(kind);
}
SulfurMaterial toC(const Material& material);
SulfurParticleSpec toC(const ParticleSpec& particle);
SulfurJointSpec toC(const JointSpec& joint);
SulfurAngularJointSpec toC(const AngularJointSpec& angle);
SulfurZone toC(const Zone& zone);
SulfurField toC(const Field& field);
SulfurWorldSettings toC(const WorldSettings& settings);
SulfurStatistics toC(const Statistics& statistics);
SulfurMemoryUse toC(const MemoryUse& use);
SulfurParticleInfo toC(const ParticleInfo& info);
SulfurJointInfo toC(const JointInfo& info);
SulfurAngleInfo toC(const AngleInfo& info);
SulfurPreSolveContact toC(const PreSolveContact& contact);
SulfurAttachmentInfo toC(const AttachmentInfo& info);
SulfurGrabInfo toC(const GrabInfo& info);
SulfurConnectOptions toC(const ConnectOptions& options);
SulfurGrabOptions toC(const GrabOptions& options);
SulfurDrive toC(const Drive& drive);
SulfurHingeOptions toC(const HingeOptions& options);
SulfurWeldOptions toC(const WeldOptions& options);
SulfurSliderOptions toC(const SliderOptions& options);
SulfurWheelMechanismOptions toC(const WheelOptions& options);
SulfurDistanceOptions toC(const DistanceOptions& options);
SulfurPulleyOptions toC(const PulleyOptions& options);
SulfurWheelIds toC(const WheelIds& ids);
SulfurMechanismInfo toC(const MechanismInfo& info);
SulfurCastHit toC(const CastHit& hit);
SulfurClosestPoint toC(const ClosestPoint& closest);
SulfurOverlap toC(const Overlap& overlap);
SulfurQueryShape toC(const QueryShape& shape);
SulfurContactInfo toC(const ContactInfo& contact);
SulfurDrawOptions toC(const DrawOptions& options);
SulfurContactBegun toC(const ContactBegun& event);
SulfurContactPersisted toC(const ContactPersisted& event);
SulfurContactEnded toC(const ContactEnded& event);
SulfurJointBroken toC(const JointBroken& event);
SulfurBodySplit toC(const BodySplit& event);
SulfurParticleLost toC(const ParticleLost& event);
SulfurSensorEvent toC(const SensorEntered& event);
SulfurSensorEvent toC(const SensorLeft& event);
SulfurLimitEvent toC(const LimitReached& event);
SulfurLimitEvent toC(const LimitLeft& event);
SulfurMechanismBroken toC(const MechanismBroken& event);
SulfurAngleBroken toC(const AngleBroken& event);
SulfurGroundOptions toC(const shapes::GroundOptions& options);
SulfurBoxOptions toC(const shapes::BoxOptions& options);
SulfurPolygonOptions toC(const shapes::PolygonOptions& options);
SulfurBallOptions toC(const shapes::BallOptions& options);
SulfurWheelOptions toC(const shapes::WheelOptions& options);
SulfurRopeOptions toC(const shapes::RopeOptions& options);
SulfurChainOptions toC(const shapes::ChainOptions& options);
SulfurBridgeOptions toC(const shapes::BridgeOptions& options);
SulfurJellyOptions toC(const shapes::JellyOptions& options);
SulfurClothOptions toC(const shapes::ClothOptions& options);
SulfurWallOptions toC(const shapes::WallOptions& options);
SulfurBlobOptions toC(const shapes::BlobOptions& options);

/// A skin as C sees it points to `uv`, which is filled here, and into `skin`.
SulfurSkin toC(const Skin& skin, std::vector<SulfurVec>& uv);

}  // namespace sulfur::c
