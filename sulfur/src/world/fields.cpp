// World: force fields.
#include "solver/fields.hpp"
#include "bodies/sleep.hpp"
#include "core/error_checks.hpp"
#include "core/limits.hpp"
#include "core/room.hpp"
#include "world/impl.hpp"

namespace sulfur {

using detail::FieldRecord;
using detail::State;

namespace {

void requirePoint(const Point& point, const char* what) {
    for (int axis = 0; axis < 2; ++axis)
        detail::requireRange(point[axis], -detail::maxCoordinate, detail::maxCoordinate, what);
}

void requireEachAxis(Vec2 value, double limit, const char* what) {
    for (int axis = 0; axis < 2; ++axis)
        detail::requireRange(static_cast<double>(value[axis]), -limit, limit, what);
}

struct ZoneCheck {
    void operator()(const Everywhere&) const {}
    void operator()(const BoxZone& zone) const {
        requirePoint(zone.low, "zone: low");
        requirePoint(zone.high, "zone: high");
        if ((zone.low.array() >= zone.high.array()).any())
            throw Error(ErrorCode::degenerate,
                        "the zone's low corner is not below its high corner; allowed is a box with "
                        "an extent on both axes");
    }
    void operator()(const CircleZone& zone) const {
        requirePoint(zone.centre, "zone: centre");
        detail::requireRange(static_cast<double>(zone.radius), 1e-9, detail::maxCoordinate,
                             "zone: radius");
    }
};

struct FieldCheck {
    int tickRate;

    void operator()(const UniformField& field) const {
        std::visit(ZoneCheck{}, field.zone);
        requireEachAxis(field.acceleration, detail::maxAcceleration, "field: acceleration");
    }
    void operator()(const RadialField& field) const {
        requirePoint(field.centre, "field: centre");
        detail::requireRange(static_cast<double>(field.strength), -1e12, 1e12, "field: strength");
        detail::requireRange(field.falloff, 0, 4, "field: falloff");
        detail::requireRange(static_cast<double>(field.core), 1e-3, 1e6, "field: core");
        if (field.reach != infinite)
            detail::requirePositive(static_cast<double>(field.reach), "field: reach");
    }
    void operator()(const WindField& field) const {
        std::visit(ZoneCheck{}, field.zone);
        requireEachAxis(field.velocity, static_cast<double>(detail::maxSpeed), "field: velocity");
        detail::requireRange(static_cast<double>(field.drag), 0, tickRate, "field: drag");
    }
};

void requireField(const State& state, const Field& field) {
    std::visit(FieldCheck{state.settings.tickRate}, field);
}

std::uint32_t indexOf(const State& state, FieldId id) {
    const auto& slots = state.influences.fieldSlots;
    if (slots.contains(id)) return slots.dense(id);
    throw Error(ErrorCode::staleHandle, "the field handle " + std::to_string(id.index) + ":" +
                                            std::to_string(id.generation) +
                                            " refers to nothing; allowed is one whose field is "
                                            "still in this world");
}

void wakeIn(State& state, const Field& field) {
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i)
        if (state.bodies[i].asleep && detail::actsOn(state, field, i)) detail::wakeBody(state, i);
}

}  // namespace

FieldId World::add(const Field& field) {
    State& state = impl_->changing();
    requireField(state, field);
    auto& influences = state.influences;
    detail::makeRoom(influences.fields, 1);
    influences.fieldSlots.makeRoom(1);
    const FieldId id =
        influences.fieldSlots.insert(static_cast<std::uint32_t>(influences.fields.size()));
    influences.fields.push_back({id, field});
    wakeIn(state, field);
    return id;
}

void World::set(FieldId id, const Field& field) {
    State& state = impl_->changing();
    const auto index = indexOf(state, id);
    requireField(state, field);
    FieldRecord& record = state.influences.fields[index];
    wakeIn(state, record.field);
    record.field = field;
    wakeIn(state, record.field);
}

void World::remove(FieldId id) {
    State& state = impl_->changing();
    const auto index = indexOf(state, id);
    auto& influences = state.influences;
    influences.fieldSlots.makeRoom(0);
    wakeIn(state, influences.fields[index].field);
    influences.fieldSlots.erase(id);
    influences.fields.erase(influences.fields.begin() + index);
    for (auto i = index; i < influences.fields.size(); ++i)
        influences.fieldSlots.move(influences.fields[i].id, i);
}

bool World::contains(FieldId id) const {
    return impl_->state().influences.fieldSlots.contains(id);
}

const Field& World::field(FieldId id) const {
    return impl_->state().influences.fields[indexOf(impl_->state(), id)].field;
}

std::vector<FieldId> World::fields() const {
    std::vector<FieldId> found;
    for (const FieldRecord& record : impl_->state().influences.fields) found.push_back(record.id);
    return found;
}

}  // namespace sulfur
