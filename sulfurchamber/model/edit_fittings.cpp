// What is fitted to a document: mechanisms, zones and thrusters of the plan, and what they are in
// this moment.
#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>

#include "document_steps.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Field;
using sulfur::MechanismId;
using sulfur::MechanismInfo;
using sulfur::MechanismKind;
using sulfur::Point;
using sulfur::Vec2;
using sulfur::World;
using sulfur::scene::MadeMechanism;
using sulfur::scene::Placement;
using sulfur::scene::SceneField;
using sulfur::scene::SceneMechanism;

MechanismKind kindOfSpec(const SceneMechanism& mechanism) {
    // In the order of the variant; a wheel is known by its slider.
    static constexpr std::array kinds{MechanismKind::hinge,    MechanismKind::weld,
                                      MechanismKind::slider,   MechanismKind::slider,
                                      MechanismKind::distance, MechanismKind::pulley,
                                      MechanismKind::gear};
    return kinds.at(mechanism.spec.index());
}

bool isSameZone(const sulfur::Zone& a, const sulfur::Zone& b) {
    if (a.index() != b.index()) return false;
    if (const auto* box = std::get_if<sulfur::BoxZone>(&a)) {
        const auto& other = std::get<sulfur::BoxZone>(b);
        return box->low == other.low && box->high == other.high;
    }
    if (const auto* circle = std::get_if<sulfur::CircleZone>(&a)) {
        const auto& other = std::get<sulfur::CircleZone>(b);
        return circle->centre == other.centre && circle->radius == other.radius;
    }
    return true;
}

bool isSameField(const Field& a, const Field& b) {
    if (a.index() != b.index()) return false;
    if (const auto* wind = std::get_if<sulfur::WindField>(&a)) {
        const auto& other = std::get<sulfur::WindField>(b);
        return wind->velocity == other.velocity && wind->drag == other.drag &&
               wind->mask == other.mask && isSameZone(wind->zone, other.zone);
    }
    if (const auto* uniform = std::get_if<sulfur::UniformField>(&a)) {
        const auto& other = std::get<sulfur::UniformField>(b);
        return uniform->acceleration == other.acceleration && uniform->mask == other.mask &&
               isSameZone(uniform->zone, other.zone);
    }
    const auto& radial = std::get<sulfur::RadialField>(a);
    const auto& other = std::get<sulfur::RadialField>(b);
    return radial.centre == other.centre && radial.strength == other.strength &&
           radial.falloff == other.falloff && radial.core == other.core &&
           radial.reach == other.reach && radial.mask == other.mask;
}

// Where a mechanism takes hold of its bodies, in their frames: tells two of a kind apart.
struct Holds {
    Point a{0, 0};
    Point b{0, 0};
    double from(const Holds& other) const { return (a - other.a).norm() + (b - other.b).norm(); }
};

Point inFrame(const sulfur::Pose& frame, const Point& point) {
    return Eigen::Rotation2Dd(-frame.angle) * (point - frame.position);
}

Holds holdsOfPlan(const Plan& plan, const SceneMechanism& mechanism) {
    return std::visit(
        [&](const auto& spec) -> Holds {
            if constexpr (requires { spec.atA; })
                return {inFrame(plan.body(spec.a).pose, spec.atA),
                        inFrame(plan.body(spec.b).pose, spec.atB)};
            else if constexpr (requires { spec.at; })
                return {Point(0, 0), inFrame(plan.body(spec.b).pose, spec.at)};
            else
                return {};
        },
        mechanism.spec);
}

Holds holdsInMoment(const World& world, const MechanismInfo& info) {
    const bool both = info.kind == MechanismKind::distance || info.kind == MechanismKind::pulley;
    return {both ? world.toBody(info.a, info.pointA) : Point(0, 0),
            world.toBody(info.b, info.pointB)};
}

}  // namespace

// --- looking ---------------------------------------------------------------------------------

std::vector<FittingRef> Document::fittings() const {
    std::vector<FittingRef> all;
    const auto add = [&](FittingRef::Kind kind, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) all.push_back({kind, i});
    };
    add(FittingRef::Kind::mechanism, scene().mechanisms.size());
    add(FittingRef::Kind::zone, scene().fields.size());
    add(FittingRef::Kind::thruster, thrusters().size());
    return all;
}

Fitting Document::fitting(const FittingRef& ref) const {
    if (ref.kind == FittingRef::Kind::mechanism) return scene().mechanisms.at(ref.index);
    if (ref.kind == FittingRef::Kind::zone) return scene().fields.at(ref.index);
    if (ref.isPart()) return part(ref);
    return thrusters().at(ref.index);
}

const std::vector<Thruster>& Document::thrusters() const {
    if (fitted_.revision != revision_) {
        fitted_.thrusters = thrustersOf(plan_.scene());
        fitted_.revision = revision_;
    }
    return fitted_.thrusters;
}

const std::vector<MadeMechanism>& Document::made() const {
    if (plan_.scene().mechanisms.empty()) {
        fitted_.made.clear();
        fitted_.matched.reset();
        return fitted_.made;
    }
    auto there = world_->mechanisms();
    if (fitted_.matched != revision_ || fitted_.there != there) {
        fitted_.there = std::move(there);
        matchMechanisms();
        fitted_.matched = revision_;
    }
    return fitted_.made;
}

// The world knows nothing of the plan: mechanisms are recognised by their bodies and by where they
// take hold of these.
void Document::matchMechanisms() const {
    std::unordered_map<std::string, BodyId> bodies;
    for (const BodyId body : world_->bodies())
        if (std::string id = idOf(body); !id.empty()) bodies.emplace(std::move(id), body);
    struct Candidate {
        MechanismId id;
        MechanismInfo info;
        bool taken = false;
    };
    std::vector<Candidate> candidates;
    for (const MechanismId id : fitted_.there) candidates.push_back({id, world_->info(id)});
    const auto body = [&](const std::string& id) {
        const auto found = bodies.find(id);
        return found == bodies.end() ? BodyId{} : found->second;
    };
    std::unordered_map<std::string, MechanismId> parts;
    const auto& plan = plan_.scene().mechanisms;
    fitted_.made.assign(plan.size(), {});
    for (std::size_t i = 0; i < plan.size(); ++i) {
        SceneMechanism mechanism = plan[i];
        const auto* gear = std::get_if<sulfur::scene::Gear>(&mechanism.spec);
        const auto names = bodiesOf(mechanism);
        const auto* hinge = std::get_if<sulfur::scene::Hinge>(&mechanism.spec);
        const Holds wanted = gear != nullptr ? Holds{} : holdsOfPlan(plan_, mechanism);
        const auto best = [&](MechanismKind kind, bool pin) {
            Candidate* found = nullptr;
            double nearest = 0;
            for (Candidate& one : candidates) {
                if (one.taken || one.info.kind != kind) continue;
                if (gear != nullptr && (one.info.first != parts[gear->first] ||
                                        one.info.second != parts[gear->second]))
                    continue;
                if (gear == nullptr &&
                    (one.info.a != body(*names[0]) || one.info.b != body(*names[1])))
                    continue;
                if (kind == MechanismKind::hinge && one.info.pin != pin) continue;
                const double off =
                    gear != nullptr ? 0 : wanted.from(holdsInMoment(*world_, one.info));
                if (found != nullptr && off >= nearest) continue;
                found = &one;
                nearest = off;
            }
            if (found == nullptr) return MechanismId{};
            found->taken = true;
            return found->id;
        };
        MadeMechanism& made = fitted_.made[i];
        made.id = best(kindOfSpec(mechanism), hinge == nullptr || hinge->options.pin);
        if (std::holds_alternative<sulfur::scene::Wheel>(mechanism.spec)) {
            made.spring = made.id;
            made.id = best(MechanismKind::hinge, false);
        }
        if (!mechanism.id.empty()) parts[mechanism.id] = made.id;
    }
}

sulfur::FieldId Document::fieldOf(std::size_t zone) const {
    const auto& plan = plan_.scene().fields;
    std::vector<bool> taken;
    const auto there = world_->fields();
    taken.resize(there.size());
    for (std::size_t i = 0; i < plan.size(); ++i)
        for (std::size_t k = 0; k < there.size(); ++k) {
            if (taken[k] || !isSameField(plan[i].field, world_->field(there[k]))) continue;
            if (i == zone) return there[k];
            taken[k] = true;
            break;
        }
    return {};
}

bool Document::isPeg(const std::string& id) const {
    if (!plan_.contains(id)) return false;
    const auto& plan = plan_.prefab(plan_.body(id).blueprint).blueprint;
    const auto isThin = [](const auto& one) { return !(one.radius > 0); };
    return plan.kind == sulfur::BodyKind::fixed && plan.particles.size() <= 2 &&
           std::all_of(plan.particles.begin(), plan.particles.end(), isThin) &&
           std::all_of(plan.joints.begin(), plan.joints.end(), isThin);
}

std::vector<BodyId> Document::withPegs(std::span<const BodyId> bodies) const {
    std::vector<BodyId> all(bodies.begin(), bodies.end());
    const auto names = idsOf(bodies);
    std::set<std::string> chosen(names.begin(), names.end());
    std::set<std::string> pegs, others;
    for (SceneMechanism mechanism : plan_.scene().mechanisms) {
        const auto ends = bodiesOf(mechanism);
        const bool isOwn = std::all_of(ends.begin(), ends.end(), [&](const auto* id) {
            return chosen.contains(*id) || isPeg(*id);
        });
        const bool isTied = std::any_of(ends.begin(), ends.end(),
                                        [&](const auto* id) { return chosen.contains(*id); });
        for (const std::string* id : ends)
            if (isPeg(*id) && !chosen.contains(*id)) (isOwn && isTied ? pegs : others).insert(*id);
    }
    for (const std::string& id : pegs)
        if (!others.contains(id))
            if (const BodyId body = bodyOf(id)) all.push_back(body);
    return all;
}

// --- changing --------------------------------------------------------------------------------

std::string Document::freeMechanismId(std::string_view base) const {
    std::string stem;
    for (const char c : base)
        stem += c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const auto& all = plan_.scene().mechanisms;
    std::string id = stem;
    const auto isTaken = [&] {
        return std::any_of(all.begin(), all.end(), [&](const auto& m) { return m.id == id; });
    };
    for (int n = 2; isTaken(); ++n) id = stem + std::to_string(n);
    return id;
}

std::vector<BodyId> Document::bodiesOfMechanism(std::size_t index) const {
    SceneMechanism mechanism = plan_.scene().mechanisms.at(index);
    std::vector<BodyId> bodies;
    for (const std::string* name : bodiesOf(mechanism))
        if (const BodyId body = bodyOf(*name)) bodies.push_back(body);
    return bodies;
}

// As in the plan, whose points must be those of this moment.
void Document::makeInMoment(const SceneMechanism& mechanism) {
    if (const auto* gear = std::get_if<sulfur::scene::Gear>(&mechanism.spec)) {
        const auto& all = plan_.scene().mechanisms;
        const auto part = [&](const std::string& id) {
            for (std::size_t i = 0; i < all.size(); ++i)
                if (all[i].id == id) return made()[i].id;
            return MechanismId{};
        };
        const MechanismId id = world_->gear(part(gear->first), part(gear->second), gear->ratio);
        if (gear->drive) world_->setDrive(id, *gear->drive);
        return;
    }
    SceneMechanism one = mechanism;
    std::map<std::string, BodyId, std::less<>> bodies;
    for (const std::string* name : bodiesOf(one)) bodies.emplace(*name, bodyOf(*name));
    sulfur::scene::makeMechanisms({&one, 1}, bodies, *world_);
}

FittingRef Document::fit(const Fitting& fitting) {
    auto& plan = plan_.scene();
    if (const auto* thruster = std::get_if<Thruster>(&fitting)) {
        auto all = thrusters();
        all.push_back(*thruster);
        setThrusters(plan, all);
        touched();
        return {FittingRef::Kind::thruster, all.size() - 1};
    }
    if (const auto* zone = std::get_if<SceneField>(&fitting)) {
        if (moved_) world_->add(zone->field);
        plan.fields.push_back(*zone);
        touched();
        return {FittingRef::Kind::zone, plan.fields.size() - 1};
    }
    SceneMechanism mechanism = std::get<SceneMechanism>(fitting);
    if (mechanism.id.empty()) mechanism.id = freeMechanismId(kindName(fitting));
    plan.mechanisms.push_back(mechanism);
    const std::size_t index = plan.mechanisms.size() - 1;
    if (moved_) {
        // The plan has its bodies where they are now, and its points with them: those are right.
        plan.mechanisms.pop_back();
        std::vector<BodyId> bodies;
        for (const std::string* name : bodiesOf(mechanism)) bodies.push_back(bodyOf(*name));
        bringPlanHere(bodies);
        plan.mechanisms.push_back(mechanism);
        touched();
        makeInMoment(mechanism);
    }
    touched();
    return {FittingRef::Kind::mechanism, index};
}

void Document::setZone(std::size_t zone, const std::optional<Field>& field) {
    const sulfur::FieldId id = moved_ ? fieldOf(zone) : sulfur::FieldId{};
    auto& fields = plan_.scene().fields;
    if (field)
        fields.at(zone).field = *field;
    else
        fields.erase(fields.begin() + static_cast<std::ptrdiff_t>(zone));
    if (!id) return;
    if (field)
        world_->set(id, *field);
    else
        world_->remove(id);
}

// With the gears that it is a part of, which go with what they join.
void Document::remakeInMoment(std::size_t index) {
    const SceneMechanism mechanism = plan_.scene().mechanisms.at(index);
    const MadeMechanism old = made().at(index);
    if (old.spring && world_->contains(old.spring)) world_->remove(old.spring);
    if (old.id && world_->contains(old.id)) world_->remove(old.id);
    ++revision_;
    makeInMoment(mechanism);
    ++revision_;
    if (mechanism.id.empty()) return;
    for (const SceneMechanism& other : plan_.scene().mechanisms)
        if (const auto* gear = std::get_if<sulfur::scene::Gear>(&other.spec))
            if (gear->first == mechanism.id || gear->second == mechanism.id) makeInMoment(other);
}

void Document::refit(const FittingRef& ref, const std::function<void(Fitting&)>& change,
                     bool live) {
    Fitting now = fitting(ref);
    if (ref.kind == FittingRef::Kind::mechanism && moved_ && !live) {
        bringPlanHere(bodiesOfMechanism(ref.index));
        now = fitting(ref);
    }
    change(now);
    if (ref.kind == FittingRef::Kind::thruster) {
        auto all = thrusters();
        all.at(ref.index) = std::get<Thruster>(now);
        setThrusters(plan_.scene(), all);
    } else if (ref.kind == FittingRef::Kind::zone) {
        setZone(ref.index, std::get<SceneField>(now).field);
    } else if (ref.isPart()) {
        setPart(ref, now);
    } else {
        const MadeMechanism there = moved_ ? made().at(ref.index) : MadeMechanism{};
        auto& mechanism = plan_.scene().mechanisms.at(ref.index);
        mechanism = std::get<SceneMechanism>(now);
        if (moved_ && !live) {
            remakeInMoment(ref.index);
        } else if (moved_) {
            if (const auto* drive = driveOf(std::as_const(mechanism)); drive != nullptr && there.id)
                world_->setDrive(there.id, *drive);
            const auto* wheel = std::get_if<sulfur::scene::Wheel>(&mechanism.spec);
            if (wheel != nullptr && there.spring)
                world_->setDrive(there.spring, wheel->options.spring);
        }
    }
    touched();
}

void Document::unfit(const FittingRef& ref) {
    if (ref.kind == FittingRef::Kind::zone) {
        setZone(ref.index, std::nullopt);
    } else if (ref.isPart()) {
        removePart(ref);
    } else if (ref.kind == FittingRef::Kind::thruster) {
        auto all = thrusters();
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(ref.index));
        setThrusters(plan_.scene(), all);
    } else {
        const MadeMechanism there = made().at(ref.index);
        auto& all = plan_.scene().mechanisms;
        SceneMechanism gone = all.at(ref.index);
        if (moved_)
            for (const MechanismId id : {there.spring, there.id})
                if (id && world_->contains(id)) world_->remove(id);
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(ref.index));
        sulfur::scene::removeMechanisms(all, [](const std::string&) { return false; });
        std::vector<BodyId> pegs;
        for (const std::string* name : bodiesOf(gone)) {
            const bool isFree = std::none_of(all.begin(), all.end(), [&](SceneMechanism other) {
                const auto names = bodiesOf(other);
                return std::any_of(names.begin(), names.end(),
                                   [&](const auto* one) { return *one == *name; });
            });
            if (isFree && isPeg(*name))
                if (const BodyId body = bodyOf(*name)) pegs.push_back(body);
        }
        if (!pegs.empty()) remove(pegs);
    }
    touched();
}

}  // namespace sulfurchamber
