// World: showing itself to a visitor.
#include <algorithm>
#include <sulfur/draw.hpp>
#include <vector>

#include "core/error_checks.hpp"
#include "shape/bends.hpp"
#include "solver/rails.hpp"
#include "solver/zones.hpp"
#include "world/impl.hpp"

namespace sulfur {

namespace {

using detail::BodyRecord;
using detail::none;
using detail::State;

/// One drawing of a world.
class Drawing {
public:
    Drawing(const World& world, const State& state, DebugDraw& to, const DrawOptions& options)
        : world_(world), state_(state), to_(to), options_(options) {}

    void run() {
        if (options_.fields)
            for (const auto& record : state_.influences.fields)
                to_.field({record.id, &record.field});
        for (std::uint32_t i = 0; i < state_.bodies.size(); ++i)
            if (anyInView(state_.bodies[i])) drawBody(i);
        const auto& joints = state_.joints;
        for (std::uint32_t j = 0; j < joints.size(); ++j) {
            if (joints.body[j] != none) continue;
            if (!inView(joints.a[j]) && !inView(joints.b[j])) continue;
            drawCapsule(j);
            drawJoint(j);
        }
        if (options_.attachments)
            for (const auto& held : state_.attachments) drawAttachment(held);
        if (options_.mechanisms)
            for (const auto& mechanism : state_.mechanisms.list)
                if (!mechanism.angle) drawMechanism(mechanism);
        if (options_.grabs)
            for (const GrabId id : world_.grabs()) to_.grab({id, world_.info(id)});
        if (options_.contacts)
            for (const ContactInfo& contact : world_.contacts())
                if (detail::contains(options_.view, contact.point)) to_.contact(contact);
    }

private:
    Point place(std::uint32_t i) const {
        const auto& p = state_.particles;
        return p.position[i] - (1 - options_.alpha) * p.displacement[i].cast<double>();
    }
    Point place(ParticleId id) const { return place(state_.particleSlots.dense(id)); }
    Point place(const detail::MechanismPoint& point) const {
        Point sum(0, 0);
        for (std::uint32_t k = 0; k < point.count; ++k)
            sum += static_cast<double>(point.weight[k]) * place(point.support[k]);
        return sum;
    }
    bool inView(std::uint32_t i) const { return detail::contains(options_.view, place(i)); }
    bool anyInView(const BodyRecord& body) const {
        for (std::uint32_t k = 0; k < body.particles.size(); ++k)
            if (inView(body.firstParticle + k)) return true;
        return false;
    }
    bool asleep(std::uint32_t particle) const {
        return state_.bodies[state_.particles.body[particle]].asleep;
    }
    BodyId ownerOf(std::uint32_t joint) const {
        const auto body = state_.joints.body[joint];
        return body == none ? BodyId{} : state_.bodies[body].id;
    }

    void drawBody(std::uint32_t index) {
        const BodyRecord& body = state_.bodies[index];
        if (options_.bodies) drawOutline(body);
        for (const JointId id : body.joints) {
            const auto j = state_.jointSlots.dense(id);
            drawCapsule(j);
            drawJoint(j);
        }
        for (std::uint32_t k = 0; k < body.particles.size(); ++k)
            drawParticle(body.firstParticle + k);
        if (options_.angles) drawAngles(body);
    }

    void drawAngles(const BodyRecord& body) {
        for (const AngleInfo& info : world_.angles(body.id))
            to_.angle({info, place(info.a), place(info.b), place(info.c), body.asleep});
    }

    /// The centre of mass moves in a tick as the mean of its particles does.
    void drawOutline(const BodyRecord& body) {
        const auto& p = state_.particles;
        const Point origin = place(body.firstParticle);
        DebugDraw::Body shown{body.id, body.kind, {0, 0}, origin, origin, body.asleep};
        double mass = 0;
        for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
            const auto i = body.firstParticle + k;
            const Point at = place(i);
            shown.low = shown.low.cwiseMin(at);
            shown.high = shown.high.cwiseMax(at);
            shown.centreOfMass += static_cast<double>(p.mass[i]) * (at - origin);
            mass += static_cast<double>(p.mass[i]);
        }
        shown.centreOfMass = origin + shown.centreOfMass / mass;
        to_.body(shown);
    }

    void drawParticle(std::uint32_t i) {
        const auto& p = state_.particles;
        const BodyId body = state_.bodies[p.body[i]].id;
        if (options_.discs && p.radius[i] > 0)
            to_.disc({p.id[i], body, place(i), p.radius[i], asleep(i)});
        if (options_.particles)
            to_.particle(
                {p.id[i], body, place(i), p.velocity[i].cast<Real>(), p.pinned[i] != 0, asleep(i)});
    }

    void drawCapsule(std::uint32_t j) {
        const auto& joints = state_.joints;
        if (!options_.capsules || joints.radius[j] <= 0) return;
        detail::forEachPieceOf(state_, j, place(joints.a[j]), place(joints.b[j]),
                               [&](const Point& a, const Point& b, double, double) {
                                   to_.capsule({joints.id[j], ownerOf(j), a, b, joints.radius[j],
                                                asleep(joints.a[j])});
                               });
    }

    void drawJoint(std::uint32_t j) {
        const auto& joints = state_.joints;
        if (!options_.joints) return;
        to_.joint({joints.id[j], ownerOf(j), place(joints.a[j]), place(joints.b[j]),
                   joints.force[j], joints.strength[j], joints.stiffness[j], asleep(joints.a[j])});
    }

    void drawAttachment(const detail::Attachment& held) {
        std::array<Point, 3> supports;
        Point point(0, 0);
        bool seen = inView(held.particle);
        for (std::uint32_t k = 0; k < held.count; ++k) {
            supports[k] = place(held.support[k]);
            point += static_cast<double>(held.weight[k]) * supports[k];
            seen = seen || inView(held.support[k]);
        }
        if (seen)
            to_.attachment({held.id, place(held.particle), point, {supports.data(), held.count}});
    }

    /// The line of what is left of a rail, then what slides.
    std::vector<Point> placesOnRail(const detail::Mechanism& m) const {
        std::vector<Point> line;
        for (const JointId id : runOf(state_, m).links) {
            const auto j = state_.jointSlots.dense(id);
            std::vector<Point> link{place(state_.joints.a[j])};
            detail::forEachPieceOf(
                state_, j, link[0], place(state_.joints.b[j]),
                [&](const Point&, const Point& to, double, double) { link.push_back(to); });
            const auto meets = [&](const Point& end) {
                return !line.empty() && end == line.back();
            };
            if (!meets(link.front()) && !meets(link.back())) std::reverse(line.begin(), line.end());
            if (meets(link.back())) std::reverse(link.begin(), link.end());
            line.insert(line.end(), link.begin() + (line.empty() ? 0 : 1), link.end());
        }
        line.push_back(place(m.points[0]));
        return line;
    }
    /// DebugDraw::Mechanism says which.
    std::vector<Point> placesOf(const detail::Mechanism& m) const {
        const auto& p = m.points;
        switch (m.kind) {
            case MechanismKind::hinge:
            case MechanismKind::weld:
                if (!m.pins[0]) return {place(m.arms[0].from), place(m.arms[1].from)};
                return {
                    place(state_.attachments[state_.attachmentSlots.dense(m.pins[0])].particle)};
            case MechanismKind::slider:
                return m.rail.isNothing() ? std::vector{place(p[1]), place(p[0])} : placesOnRail(m);
            case MechanismKind::distance:
                return {place(p[0]), place(p[1])};
            case MechanismKind::pulley:
                return {place(p[1]), place(p[0]), place(p[2]), place(p[3])};
            case MechanismKind::gear:
                break;
        }
        std::vector<Point> ends;
        for (const MechanismId part : m.parts) ends.push_back(placesOf(partOf(part)).front());
        return ends;
    }
    const detail::Mechanism& partOf(MechanismId id) const {
        return state_.mechanisms.list[state_.mechanisms.slots.dense(id)];
    }

    void drawMechanism(const detail::Mechanism& m) {
        const std::vector<Point> places = placesOf(m);
        const auto seen = [&](const Point& at) { return detail::contains(options_.view, at); };
        if (std::any_of(places.begin(), places.end(), seen))
            to_.mechanism({m.id, world_.info(m.id), places});
    }

    const World& world_;
    const State& state_;
    DebugDraw& to_;
    const DrawOptions& options_;
};

}  // namespace

void World::draw(DebugDraw& to, const DrawOptions& options) const {
    detail::requireRange(options.alpha, 0, 1, "draw: alpha");
    Drawing(*this, impl_->state(), to, options).run();
}

void World::draw(DebugDraw& to) const {
    draw(to, DrawOptions{});
}

}  // namespace sulfur
