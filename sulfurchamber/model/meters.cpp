#include "meters.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::JointId;
using sulfur::MechanismId;
using sulfur::MechanismKind;
using sulfur::ParticleId;
using sulfur::Point;
using sulfur::World;

constexpr double degreesOfRadian = 180 / std::numbers::pi;
constexpr double gaugeMemory = 10;  // seconds that the scale of a gauge looks back

constexpr std::array<Quantity, 2> ofRulers{
    {{"length", "Length", "m", "Distance of both ends"},
     {"slope", "Slope", "\xC2\xB0", "Of the way from the first end to the second", nullptr, false,
      true}}};
constexpr std::array<Quantity, 1> ofProtractors{
    {{"turn", "Angle", "\xC2\xB0", "From the second end to the third, anticlockwise", nullptr,
      false, true}}};
constexpr std::array<Quantity, 3> ofTracers{{{"trace-speed", "Speed", "m/s", "Of the point"},
                                             {"trace-x", "Horizontal place", "m", "Of the point"},
                                             {"trace-y", "Height", "m", "Of the point"}}};
constexpr std::array<Quantity, 2> ofGauges{
    {{"force", "Force", "N", "Of the joint, above 0 it pulls; of mechanisms and contacts its size"},
     {"gauge-strain", "Strain", "%", "Of the joint; above 0 it is stretched"}}};
constexpr std::array<Quantity, 1> ofGuns{{{"passing", "Speed", "m/s", "Of what is in the beam"}}};

// Whether a joint is between these two, in either order.
bool isBetween(const World& world, JointId joint, ParticleId a, ParticleId b) {
    const auto info = world.info(joint);
    return (info.a == a && info.b == b) || (info.a == b && info.b == a);
}

std::optional<ParticleId> particleOf(const World& world, BodyId body, const MeterEnd& end) {
    if (!body || !end.particle) return std::nullopt;
    const auto particles = world.particles(body);
    if (*end.particle >= particles.size()) return std::nullopt;
    return particles[*end.particle];
}

}  // namespace

std::span<const Quantity> readingsOf(MeterKind kind) {
    switch (kind) {
        case MeterKind::protractor:
            return ofProtractors;
        case MeterKind::tracer:
            return ofTracers;
        case MeterKind::gauge:
            return ofGauges;
        case MeterKind::gun:
            return ofGuns;
        case MeterKind::ruler:
            break;
    }
    return ofRulers;
}

std::span<const Quantity> readingsOf(const Meter& meter) {
    const auto all = readingsOf(meter.kind);
    const bool ofJoint = !meter.ends.empty() && meter.ends[0].particle.has_value();
    return meter.kind == MeterKind::gauge && !ofJoint ? all.first(1) : all;
}

double roundAbove(double value) {
    double power = std::pow(10, std::floor(std::log10(std::max(value, 1e-3))));
    for (const double step : {1.0, 2.0, 5.0, 10.0})
        if (step * power >= value * (1 - 1e-12)) return step * power;
    return 10 * power;
}

// --- following the plan ----------------------------------------------------------------------

// Grows with whatever may give something another handle.
std::uint64_t Meters::stamp() const {
    return document_.revision() * 1'000'003 + document_.world().bodies().size() + 1;
}

void Meters::follow() const {
    const auto* member = sulfur::scene::findExtra(document_.scene().extra, "meters");
    const std::string& text = member == nullptr ? std::string() : member->json;
    if (text == text_) return;
    text_ = text;
    std::vector<Entry> next;
    for (Meter& meter : metersOf(document_.scene())) {
        Entry entry{std::move(meter), {}, {}};
        // What was recorded stays, as long as it is the same that is measured.
        for (Entry& old : entries_)
            if (old.meter == entry.meter) entry.series = std::move(old.series);
        if (entry.series.empty())
            for (const Quantity& reading : readingsOf(entry.meter))
                entry.series.push_back({BodyId{}, 0, entry.meter.id, &reading, {}});
        next.push_back(std::move(entry));
    }
    entries_ = std::move(next);
    meters_.clear();
    for (const Entry& entry : entries_) meters_.push_back(entry.meter);
}

const std::vector<Meter>& Meters::all() const {
    follow();
    return meters_;
}

const Meter* Meters::find(std::string_view id) const {
    for (const Meter& meter : all())
        if (meter.id == id) return &meter;
    return nullptr;
}

const Meters::Entry& Meters::entryOf(const Meter& meter) const {
    follow();
    for (const Entry& entry : entries_)
        if (entry.meter.id == meter.id) return entry;
    static const Entry none;
    return none;
}

BodyId Meters::bodyOf(const Entry& entry, std::size_t end) const {
    const std::string& id = entry.meter.ends[end].body;
    if (id.empty()) return {};
    BodyId& held = entry.held.bodies[end];
    if (document_.world().contains(held) && document_.idOf(held) == id) return held;
    if (entry.held.searched == stamp()) return {};
    held = document_.bodyOf(id);
    if (!held) entry.held.searched = stamp();
    return held;
}

std::optional<Point> Meters::place(const Meter& meter, std::size_t end, double alpha) const {
    const Entry& entry = entryOf(meter);
    if (end >= entry.meter.ends.size()) return std::nullopt;
    const MeterEnd& one = entry.meter.ends[end];
    if (one.body.empty()) return one.at;
    const BodyId body = bodyOf(entry, end);
    if (!body) return std::nullopt;
    const World& world = document_.world();
    if (const auto particle = particleOf(world, body, one))
        return world.interpolated(*particle, alpha);
    if (alpha >= 1) return world.toWorld(body, one.at);
    const sulfur::Pose pose = world.interpolatedPose(body, alpha);
    return pose.position + Eigen::Rotation2Dd(pose.angle) * one.at;
}

// --- reading ---------------------------------------------------------------------------------

std::optional<double> Meters::read(const Meter& meter, const Quantity& reading) const {
    const Entry& entry = entryOf(meter);
    if (entry.meter.ends.empty()) return std::nullopt;
    const auto first = place(meter, 0);
    switch (meter.kind) {
        case MeterKind::ruler: {
            const auto second = place(meter, 1);
            if (!first || !second) return std::nullopt;
            const Point way = *second - *first;
            if (reading.key == "length") return way.norm();
            return std::atan2(way.y(), way.x()) * degreesOfRadian;
        }
        case MeterKind::protractor:
            return readAngle(meter);
        case MeterKind::tracer: {
            if (!first) return std::nullopt;
            if (reading.key == "trace-x") return first->x();
            if (reading.key == "trace-y") return first->y();
            const BodyId body = bodyOf(entry, 0);
            if (!body) return 0.0;
            const World& world = document_.world();
            if (const auto particle = particleOf(world, body, meter.ends[0]))
                return static_cast<double>(world.velocity(*particle).norm());
            const Point arm = *first - world.centreOfMass(body);
            const Point turning(-arm.y(), arm.x());
            return (world.meanVelocity(body).cast<double>() + world.angularVelocity(body) * turning)
                .norm();
        }
        case MeterKind::gauge:
            return reading.key == "force" ? readForce(entry) : readStrain(entry);
        case MeterKind::gun:
            return readBeam(meter);
    }
    return std::nullopt;
}

std::optional<double> Meters::readAngle(const Meter& meter) const {
    const auto corner = place(meter, 0), from = place(meter, 1), to = place(meter, 2);
    if (!corner || !from || !to) return std::nullopt;
    const Point a = *from - *corner, b = *to - *corner;
    if (!(a.norm() > 0) || !(b.norm() > 0)) return std::nullopt;
    return std::atan2(sulfur::cross(a, b), a.dot(b)) * degreesOfRadian;
}

std::optional<double> Meters::readForce(const Entry& entry) const {
    const Meter& meter = entry.meter;
    if (meter.ends.size() == 1) {
        const BodyId body = bodyOf(entry, 0);
        if (!body) return std::nullopt;
        return quantity("contact-force")->get(document_.world(), body);
    }
    if (!meter.ends[0].particle) return mechanismForce(entry);
    const auto joint = jointOf(entry);
    if (!joint) return std::nullopt;
    return static_cast<double>(document_.world().info(*joint).force);
}

std::optional<double> Meters::readStrain(const Entry& entry) const {
    if (entry.meter.ends.size() < 2 || !entry.meter.ends[0].particle) return std::nullopt;
    const auto joint = jointOf(entry);
    if (!joint) return std::nullopt;
    const World& world = document_.world();
    return strainOf(world, world.info(*joint));
}

std::optional<JointId> Meters::jointOf(const Entry& entry) const {
    const World& world = document_.world();
    const BodyId a = bodyOf(entry, 0), b = bodyOf(entry, 1);
    const auto from = particleOf(world, a, entry.meter.ends[0]);
    const auto to = particleOf(world, b, entry.meter.ends[1]);
    if (!from || !to) return std::nullopt;
    JointId& held = entry.held.joint;
    if (!world.contains(held) || !isBetween(world, held, *from, *to)) {
        if (entry.held.searched == stamp()) return std::nullopt;
        held = {};
        if (a == b) {
            for (const JointId joint : world.joints(a))
                if (isBetween(world, joint, *from, *to)) held = joint;
        } else {
            for (const JointId joint : world.connections())
                if (isBetween(world, joint, *from, *to)) held = joint;
        }
        if (!held) {
            entry.held.searched = stamp();
            return std::nullopt;
        }
    }
    return held;
}

std::optional<double> Meters::mechanismForce(const Entry& entry) const {
    const World& world = document_.world();
    const BodyId a = bodyOf(entry, 0), b = bodyOf(entry, 1);
    if (!a || !b) return std::nullopt;
    MechanismId& held = entry.held.mechanism;
    if (!world.contains(held)) {
        if (entry.held.searched == stamp()) return std::nullopt;
        held = {};
        const Point at = world.toWorld(a, entry.meter.ends[0].at);
        double nearest = 0;
        for (const MechanismId one : world.mechanisms()) {
            const auto info = world.info(one);
            if (info.a != a || info.b != b || info.kind == MechanismKind::gear) continue;
            const double distance = (info.pointA - at).norm();
            if (held && distance >= nearest) continue;
            held = one;
            nearest = distance;
        }
        if (!held) {
            entry.held.searched = stamp();
            return std::nullopt;
        }
    }
    const auto info = world.info(held);
    const bool turns = info.kind == MechanismKind::hinge || info.kind == MechanismKind::weld;
    // The drive of what turns is a torque, all else are forces.
    const double along = turns ? 0 : static_cast<double>(info.force);
    return std::hypot(along, static_cast<double>(info.holding.norm()));
}

std::optional<sulfur::CastHit> Meters::hitOf(const Meter& gun) const {
    const auto from = place(gun, 0), to = place(gun, 1);
    if (!from || !to || !((*to - *from).norm() > 0)) return std::nullopt;
    sulfur::QueryFilter filter;
    filter.ignore = bodyOf(entryOf(gun), 0);
    return document_.world().castSegment(*from, *to, filter);
}

std::optional<double> Meters::readBeam(const Meter& gun) const {
    const World& world = document_.world();
    const auto hit = hitOf(gun);
    if (!hit || world.kind(hit->body) == sulfur::BodyKind::fixed) return std::nullopt;
    if (!hit->joint) return static_cast<double>(world.velocity(hit->particle).norm());
    const auto joint = world.info(hit->joint);
    return static_cast<double>(
        ((1 - hit->along) * world.velocity(joint.a) + hit->along * world.velocity(joint.b)).norm());
}

std::optional<Point> Meters::beamEnd(const Meter& gun) const {
    if (const auto hit = hitOf(gun)) return hit->point;
    return place(gun, 1);
}

// --- recording -------------------------------------------------------------------------------

void Meters::sample() {
    follow();
    for (Entry& entry : entries_)
        for (Series& one : entry.series)
            addSample(one, document_.world().time(), read(entry.meter, *one.quantity));
}

void Meters::clear() {
    for (Entry& entry : entries_)
        for (Series& one : entry.series) one.samples.clear();
}

std::span<const Series> Meters::record(std::string_view id) const {
    follow();
    for (const Entry& entry : entries_)
        if (entry.meter.id == id) return entry.series;
    return {};
}

std::optional<Sample> Meters::last(const Meter& meter) const {
    const auto series = record(meter.id);
    if (series.empty()) return std::nullopt;
    const double now = document_.world().time();
    const auto past = between(series[0].samples, 0, now + 1e-9);
    return past.empty() ? std::nullopt : std::optional(past.back());
}

double Meters::scaleOf(const Meter& gauge) const {
    const auto series = record(gauge.id);
    double most = std::abs(read(gauge, readingsOf(gauge.kind)[0]).value_or(0));
    const double now = document_.world().time();
    if (!series.empty())
        for (const Sample& one : between(series[0].samples, now - gaugeMemory, now + 1e-9))
            most = std::max(most, std::abs(one.value));
    return most > 0 ? roundAbove(most) : 10;
}

}  // namespace sulfurchamber
