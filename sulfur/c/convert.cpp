// Plain values: numbers, kinds, plans of bodies, fields, settings, options.
#include "convert.hpp"

#include <cmath>
#include <limits>

namespace sulfur::c {

namespace {

/// A kind by its number, less than `count`.
template <class Kind>
Kind kindOf(std::int32_t number, std::int32_t count, const char* what) {
    if (number >= 0 && number < count) return static_cast<Kind>(number);
    throw Error(ErrorCode::outOfRange, std::string("the ") + what + " is " +
                                           std::to_string(number) + "; allowed is 0 to " +
                                           std::to_string(count - 1));
}

std::optional<Real> optional(bool has, double number) {
    return has ? std::optional<Real>(real(number)) : std::nullopt;
}

std::optional<Material> optional(bool has, const SulfurMaterial& material) {
    return has ? std::optional<Material>(fromC(material)) : std::nullopt;
}

}  // namespace

// --- from C --------------------------------------------------------------------------------------

Real real(double number) {
    constexpr double largest = static_cast<double>(std::numeric_limits<Real>::max());
    if (std::isfinite(number) && std::abs(number) > largest)
        throw Error(ErrorCode::outOfRange, "the number " + std::to_string(number) +
                                               " is beyond single precision; allowed is what its "
                                               "documentation says");
    return static_cast<Real>(number);
}

Vec2 vec(SulfurVec v) {
    return {real(v.x), real(v.y)};
}

std::vector<Vec2> vectors(const SulfurVec* list, std::size_t count) {
    std::vector<Vec2> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(vec((&required(list, "points"))[i]));
    return result;
}

Material fromC(const SulfurMaterial& material) {
    return {real(material.static_friction), real(material.kinetic_friction),
            real(material.restitution), real(material.surface_speed),
            real(material.rolling_resistance)};
}

ParticleSpec fromC(const SulfurParticleSpec& particle) {
    return {vec(particle.position), real(particle.mass), real(particle.radius), particle.pinned};
}

JointSpec fromC(const SulfurJointSpec& joint) {
    return {joint.a,
            joint.b,
            real(joint.stiffness),
            real(joint.damping),
            optional(joint.has_rest_length, joint.rest_length),
            real(joint.radius),
            real(joint.strength),
            optional(joint.has_material, joint.material),
            real(joint.bend)};
}

AngularJointSpec fromC(const SulfurAngularJointSpec& angle) {
    return {angle.a,
            angle.b,
            angle.c,
            real(angle.stiffness),
            real(angle.damping),
            optional(angle.has_rest_angle, angle.rest_angle),
            real(angle.lower),
            real(angle.upper),
            real(angle.motor_speed),
            real(angle.motor_max),
            optional(angle.has_motor_target, angle.motor_target),
            real(angle.strength)};
}

Skin fromC(const SulfurSkin& skin) {
    Skin result;
    result.texture = &required(skin.texture, "the name of the texture");
    result.uv = vectors(skin.uv, skin.uv_count);
    for (std::size_t i = 0; i < skin.triangle_count; ++i) {
        const std::uint32_t* corners = &required(skin.triangles, "triangles") + 3 * i;
        result.triangles.push_back({corners[0], corners[1], corners[2]});
    }
    return result;
}

BodyKind bodyKind(SulfurBodyKind kind) {
    return kindOf<BodyKind>(kind, 3, "kind of body");
}

Zone fromC(const SulfurZone& zone) {
    enum class Kind { everywhere, box, circle };
    switch (kindOf<Kind>(zone.kind, 3, "kind of zone")) {
        case Kind::box:
            return BoxZone{point(zone.low), point(zone.high)};
        case Kind::circle:
            return CircleZone{point(zone.centre), real(zone.radius)};
        case Kind::everywhere:
            break;
    }
    return Everywhere{};
}

Field fromC(const SulfurField& field) {
    enum class Kind { uniform, radial, wind };
    switch (kindOf<Kind>(field.kind, 3, "kind of field")) {
        case Kind::uniform: {
            const SulfurUniformField& f = field.uniform;
            return UniformField{fromC(f.zone), vec(f.acceleration), f.mask};
        }
        case Kind::radial: {
            const SulfurRadialField& f = field.radial;
            return RadialField{point(f.centre), real(f.strength), f.falloff,
                               real(f.core),    real(f.reach),    f.mask};
        }
        case Kind::wind:
            break;
    }
    const SulfurWindField& f = field.wind;
    return WindField{fromC(f.zone), vec(f.velocity), real(f.drag), f.mask};
}

Damper damper(SulfurDamper damper) {
    return kindOf<Damper>(damper, 2, "damper");
}

WorldSettings fromC(const SulfurWorldSettings& settings) {
    WorldSettings result;
    result.gravity = vec(settings.gravity);
    result.airFriction = real(settings.air_friction);
    result.tickRate = settings.tick_rate;
    result.sleeping = settings.sleeping;
    result.damper = damper(settings.damper);
    result.friction = kindOf<Friction>(settings.friction, 2, "friction");
    result.tellPersisting = settings.tell_persisting;
    result.sweeps = settings.sweeps;
    result.sleepSpeed = optional(settings.has_sleep_speed, settings.sleep_speed);
    result.reboundSpeed = optional(settings.has_rebound_speed, settings.rebound_speed);
    return result;
}

ConnectOptions fromC(const SulfurConnectOptions& options) {
    return {real(options.stiffness),
            real(options.damping),
            optional(options.has_rest_length, options.rest_length),
            real(options.radius),
            real(options.strength),
            optional(options.has_material, options.material)};
}

GrabOptions fromC(const SulfurGrabOptions& options) {
    return {real(options.frequency), real(options.damping_ratio),
            optional(options.has_max_force, options.max_force)};
}

QueryFilter fromC(const SulfurQueryFilter& filter) {
    QueryFilter result{filter.mask, fromC(filter.ignore), filter.sensors, {}};
    if (filter.accept)
        result.accept = [accept = filter.accept, user = filter.user](BodyId body) {
            return accept(user, toC(body));
        };
    return result;
}

QueryShape fromC(const SulfurQueryShape& shape) {
    std::vector<Point> points;
    for (std::uint32_t i = 0; i < std::min<std::uint32_t>(shape.count, QueryShape::maxPoints); ++i)
        points.push_back(point(shape.points[i]));
    // More are refused by the library as those beyond the last one.
    if (shape.count > points.size()) points.push_back(Point(0, 0));
    return QueryShape::polygon(points, shape.radius);
}

DrawOptions fromC(const SulfurDrawOptions& options) {
    return {options.bodies,     options.particles,  options.discs,       options.joints,
            options.capsules,   options.contacts,   options.attachments, options.fields,
            options.grabs,      options.mechanisms, options.angles,      options.alpha,
            fromC(options.view)};
}

// --- to C ----------------------------------------------------------------------------------------

SulfurMaterial toC(const Material& material) {
    return {toC(material.staticFriction), toC(material.kineticFriction), toC(material.restitution),
            toC(material.surfaceSpeed), toC(material.rollingResistance)};
}

SulfurParticleSpec toC(const ParticleSpec& particle) {
    return {toC(particle.position), toC(particle.mass), toC(particle.radius), particle.pinned};
}

SulfurJointSpec toC(const JointSpec& joint) {
    return {joint.a,
            joint.b,
            toC(joint.stiffness),
            toC(joint.damping),
            joint.restLength.has_value(),
            toC(joint.restLength.value_or(0)),
            toC(joint.radius),
            toC(joint.strength),
            joint.material.has_value(),
            toC(joint.material.value_or(Material{})),
            toC(joint.bend)};
}

SulfurAngularJointSpec toC(const AngularJointSpec& angle) {
    return {angle.a,
            angle.b,
            angle.c,
            toC(angle.stiffness),
            toC(angle.damping),
            angle.restAngle.has_value(),
            toC(angle.restAngle.value_or(0)),
            toC(angle.lower),
            toC(angle.upper),
            toC(angle.motorSpeed),
            toC(angle.motorMax),
            angle.motorTarget.has_value(),
            toC(angle.motorTarget.value_or(0)),
            toC(angle.strength)};
}

SulfurSkin toC(const Skin& skin, std::vector<SulfurVec>& uv) {
    std::vector<SulfurVec> copy;
    for (const Vec2& corner : skin.uv) copy.push_back(toC(corner));
    uv = std::move(copy);
    return {skin.texture.c_str(), uv.data(), uv.size(),
            skin.triangles.empty() ? nullptr : skin.triangles.front().data(),
            skin.triangles.size()};
}

SulfurZone toC(const Zone& zone) {
    SulfurZone result{};
    if (const auto* box = std::get_if<BoxZone>(&zone)) {
        result.kind = SULFUR_BOX_ZONE;
        result.low = toC(box->low);
        result.high = toC(box->high);
    } else if (const auto* circle = std::get_if<CircleZone>(&zone)) {
        result.kind = SULFUR_CIRCLE_ZONE;
        result.centre = toC(circle->centre);
        result.radius = toC(circle->radius);
    }
    return result;
}

SulfurField toC(const Field& field) {
    const auto* wind = std::get_if<WindField>(&field);
    const auto* radial = std::get_if<RadialField>(&field);
    const auto* uniform = std::get_if<UniformField>(&field);
    const UniformField u = uniform ? *uniform : UniformField{};
    const RadialField r = radial ? *radial : RadialField{};
    const WindField w = wind ? *wind : WindField{};
    return {radial ? SULFUR_RADIAL_FIELD
            : wind ? SULFUR_WIND_FIELD
                   : SULFUR_UNIFORM_FIELD,
            {toC(u.zone), toC(u.acceleration), u.mask},
            {toC(r.centre), toC(r.strength), r.falloff, toC(r.core), toC(r.reach), r.mask},
            {toC(w.zone), toC(w.velocity), toC(w.drag), w.mask}};
}

SulfurWorldSettings toC(const WorldSettings& settings) {
    return {toC(settings.gravity),
            toC(settings.airFriction),
            settings.tickRate,
            settings.sleeping,
            static_cast<SulfurDamper>(settings.damper),
            static_cast<SulfurFriction>(settings.friction),
            settings.tellPersisting,
            settings.sweeps,
            settings.sleepSpeed.has_value(),
            toC(settings.sleepSpeed.value_or(0)),
            settings.reboundSpeed.has_value(),
            toC(settings.reboundSpeed.value_or(0))};
}

SulfurConnectOptions toC(const ConnectOptions& options) {
    return {toC(options.stiffness),
            toC(options.damping),
            options.restLength.has_value(),
            toC(options.restLength.value_or(0)),
            toC(options.radius),
            toC(options.strength),
            options.material.has_value(),
            toC(options.material.value_or(Material{}))};
}

SulfurGrabOptions toC(const GrabOptions& options) {
    return {toC(options.frequency), toC(options.dampingRatio), options.maxForce.has_value(),
            toC(options.maxForce.value_or(0))};
}

SulfurDrawOptions toC(const DrawOptions& options) {
    return {options.bodies,   options.particles,  options.discs,       options.joints,
            options.capsules, options.contacts,   options.attachments, options.fields,
            options.grabs,    options.mechanisms, options.angles,      options.alpha,
            toC(options.view)};
}

}  // namespace sulfur::c
