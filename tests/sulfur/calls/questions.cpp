// Questions of every kind: they change nothing, and what they find is there.
#include <algorithm>
#include <array>

#include "calls/caller.hpp"

namespace sulfur::test {

namespace {

/// Looks at everything that it is shown.
class Viewer final : public DebugDraw {
public:
    explicit Viewer(const World& world) : world_(world) {}
    void body(const Body& shown) override {
        require(world_.contains(shown.id) && shown.centreOfMass.allFinite(), "bodies are drawn");
    }
    void particle(const Particle& shown) override {
        require(world_.contains(shown.id) && shown.place.allFinite(), "particles are drawn");
    }
    void joint(const Joint& shown) override {
        require(world_.contains(shown.id) && std::isfinite(shown.force), "joints are drawn");
    }
    void capsule(const Capsule& shown) override {
        require(shown.a.allFinite() && shown.b.allFinite(), "capsules are drawn");
    }
    void attachment(const Attachment& shown) override {
        require(!shown.supports.empty() && shown.point.allFinite(), "attachments are drawn");
    }
    void grab(const Grab& shown) override {
        require(shown.info.point.allFinite() && shown.info.force.allFinite(), "grabs are drawn");
    }

private:
    const World& world_;
};

void checkHit(const World& world, const CastHit& hit) {
    require(world.contains(hit.body), "a cast hits a body");
    require(hit.fraction >= 0 && hit.fraction <= 1, "a hit is on the way");
    require(hit.point.allFinite() && hit.normal.allFinite(), "hits are finite");
}

void checkOverlaps(const World& world, const std::vector<Overlap>& found) {
    for (std::size_t i = 0; i < found.size(); ++i) {
        require(world.contains(found[i].body), "overlaps are of bodies");
        require(i == 0 || found[i - 1].body < found[i].body, "each body overlaps once, in order");
    }
}

void askWhole(const World& world, BodyId id, double alpha) {
    const Pose now = world.pose(id), drawn = world.interpolatedPose(id, alpha);
    require(now.position.allFinite() && std::abs(now.angle) < 3.15 && now.angle == world.angle(id),
            "a body has a pose");
    require(drawn.position.allFinite() && std::abs(drawn.angle) < 3.15, "a pose is interpolated");
    require(std::isfinite(world.angularVelocity(id)) && world.inertia(id) >= 0,
            "a body has a spin and an inertia");
    const Point local(1, -2);
    const double far = 1e-9 * (1 + now.position.norm());
    require((world.toBody(id, world.toWorld(id, local)) - local).norm() < 10 * far,
            "a point of a body goes to the world and back");
    const Bounds bounds = world.bounds(id);
    const Point centre = world.centreOfMass(id);
    const double within = 1e-9 * (1 + centre.norm());
    require((centre.array() >= bounds.low.array() - within).all() &&
                (centre.array() <= bounds.high.array() + within).all(),
            "a body is within its bounds");
}

void askContacts(const World& world, BodyId id) {
    std::array<ContactInfo, 8> found;
    const std::size_t count = world.contacts(id, found);
    for (std::size_t k = 0; k < std::min(count, found.size()); ++k)
        require((found[k].a == id || found[k].b == id) && found[k].point.allFinite(),
                "contacts of a body are its own");
}

}  // namespace

/// Who does not ask has drawn the same numbers.
template <class Question>
void Caller::answer(Question&& question) {
    if (!asks_) return;
    const auto before = world_->hash();
    try {
        question(static_cast<const World&>(*world_));
    } catch (const Error& error) {
        require(std::string(error.what()).size() > 20, "an error says what is wrong");
    }
    require(world_->hash() == before, "looking changes nothing");
}

QueryFilter Caller::queryFilter() {
    QueryFilter filter;
    filter.sensors = either();
    if (oneIn(4)) filter.mask = static_cast<std::uint32_t>(numbers_->below(8));
    if (oneIn(4)) filter.ignore = body();
    if (oneIn(4))
        filter.accept = [this](BodyId id) { return world_->contains(id) && id.index % 2 == 0; };
    return filter;
}

QueryShape Caller::queryShape() {
    const Point at = place();
    switch (numbers_->below(4)) {
        case 0:
            return QueryShape::circle(at, real());
        case 1: {
            const Point to = place();
            return QueryShape::capsule(at, to, real());
        }
        case 2: {
            const Vec2 size = vector();
            return QueryShape::box(at, size, real());
        }
        default: {
            std::vector<Point> points(numbers_->below(10));
            for (Point& point : points) point = place();
            return QueryShape::polygon(points, std::abs(real()) / 5);
        }
    }
}

void Caller::ask() {
    try {
        switch (numbers_->below(3)) {
            case 0:
                return askWays();
            case 1:
                return askPlaces();
            default:
                return askThings();
        }
    } catch (const Error&) {  // of a shape that cannot be
    }
}

void Caller::askWays() {
    const QueryFilter filter = queryFilter();
    const Point from = place();
    switch (numbers_->below(4)) {
        case 0: {
            const Point to = place();
            return answer([&](const World& w) {
                if (const auto hit = w.castSegment(from, to, filter)) checkHit(w, *hit);
            });
        }
        case 1: {
            const Vec2 direction = vector();
            const double reach = 4 * real();
            return answer([&](const World& w) {
                if (const auto hit = w.castRay(from, direction, reach, filter)) checkHit(w, *hit);
            });
        }
        case 2: {
            const Point to = place();
            return answer([&](const World& w) {
                for (const CastHit& hit : w.castAll(from, to, filter)) checkHit(w, hit);
            });
        }
        default: {
            const QueryShape shape = queryShape();
            const Point way = place();
            return answer([&](const World& w) {
                if (const auto hit = w.castShape(shape, way, filter)) checkHit(w, *hit);
            });
        }
    }
}

void Caller::askPlaces() {
    const QueryFilter filter = queryFilter();
    const Point at = place();
    const double reach = real();
    switch (numbers_->below(6)) {
        case 0:
            return answer([&](const World& w) {
                const auto closest = w.closestPoint(at, reach, filter);
                if (!closest) return;
                require(w.contains(closest->body) && closest->point.allFinite() &&
                            closest->distance <= reach,
                        "the closest point is on a body and in reach");
            });
        case 1: {
            const QueryShape shape = queryShape();
            return answer([&](const World& w) { checkOverlaps(w, w.overlap(shape, filter)); });
        }
        case 2: {
            const Point size = place();
            return answer(
                [&](const World& w) { checkOverlaps(w, w.overlapBox(at, at + size, filter)); });
        }
        case 3:
            return answer(
                [&](const World& w) { checkOverlaps(w, w.overlapCircle(at, reach, filter)); });
        case 4:
            return answer([&](const World& w) {
                for (const BodyId id : w.bodiesAt(at, filter))
                    require(w.contains(id), "a body is where it was pointed at");
                for (const BodyId id : w.bodiesIn(at, at, filter))
                    require(w.contains(id), "a body is in the box round a point");
            });
        default:
            return answer([&](const World& w) {
                if (const auto found = w.nearestParticle(at, static_cast<Real>(reach)))
                    require(w.contains(*found), "the nearest particle is one");
            });
    }
}

void Caller::askThings() {
    const BodyId id = body(), other = body();
    const ParticleId p = particle();
    const JointId j = joint();
    const double alpha = unit();
    const Zone view = zone();
    const auto which = numbers_->below(6);
    answer([&](const World& w) {
        switch (which) {
            case 0:
                require(w.centreOfMass(id).allFinite() && w.meanVelocity(id).allFinite() &&
                            w.mass(id) > 0,
                        "a body has a place, a velocity and a mass");
                return askWhole(w, id, alpha);
            case 1:
                for (const BodyId visitor : w.visitors(id))
                    require(w.contains(visitor), "visitors are bodies");
                w.collision(id, other);
                w.touches(id, other);
                return askContacts(w, id);
            case 2:
                require(w.info(p).position == w.position(p) && w.velocity(p).allFinite() &&
                            w.interpolated(p, alpha).allFinite(),
                        "a particle is somewhere");
                return;
            case 3:
                w.material(j);
                require(std::isfinite(w.info(j).force), "forces of joints are finite");
                return;
            case 4: {
                Viewer viewer(w);
                return w.draw(viewer, {.alpha = alpha, .view = view});
            }
            default:
                return lookAtAll();
        }
    });
}

void Caller::lookAtAll() {
    const World& w = *world_;
    for (const AttachmentId id : w.attachments())
        require(w.contains(w.info(id).particle), "attachments hold particles");
    for (const GrabId id : w.grabs())
        require(w.contains(w.info(id).body) && w.info(id).point.allFinite(), "grabs hold bodies");
    for (const FieldId id : w.fields())
        require(w.contains(id) && w.field(id).index() < 3, "fields");
    for (const auto& [a, b] : w.vetoes()) require(!w.collision(a, b), "vetoes hold");
    for (const BodyId id : w.bodies()) {
        w.asleep(id);
        for (const AngleInfo& angle : w.angles(id)) {
            require(std::isfinite(angle.torque) && std::isfinite(angle.angle), "angles are finite");
            require(w.contains(angle.id) && w.info(angle.id).body == id, "angles are of bodies");
        }
        if (const auto& skin = w.skin(id))
            require(skin->uv.size() == w.particles(id).size(), "a skin has a place per particle");
    }
    std::size_t bytes = 0;
    for (const MemoryUse& use : w.memory()) bytes += use.bytes;
    require(bytes > 0, "a world holds something");
    require(std::isfinite(w.time()), "the clock goes");
}

}  // namespace sulfur::test
