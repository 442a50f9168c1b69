// What acts on the bodies of a world without being one: force fields and grabs.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <sulfur/fields.hpp>
#include <sulfur/grab.hpp>
#include <sulfur/ids.hpp>
#include <vector>

#include "core/slots.hpp"

namespace sulfur::detail {

/// The alternatives of Field as one thing that the archive can write and read.
struct FieldRecord {
    FieldId id;
    Field field;

    template <class Archive>
    void archive(Archive& a);
};

/// A soft constraint that pulls a weighted mean of up to three particles towards a target. It
/// keeps handles, not indices: it is looked up once a tick, and whatever is removed from the world
/// needs to know nothing of it.
struct Grab {
    GrabId id;
    std::uint32_t count = 0;  // of supports
    std::array<ParticleId, 3> support{};
    std::array<Real, 3> weight{0, 0, 0};
    Point target{0, 0};  // m
    Real stiffness = 0;  // N/m
    Real damping = 0;    // N s/m
    Real maxForce = 0;   // N
    Vec2 impulse{0, 0};  // kg m, of this tick: force times h^2

    template <class Archive>
    void archive(Archive& a) {
        a(id);
        a(count);
        a(support);
        a(weight);
        a(target);
        a(stiffness);
        a(damping);
        a(maxForce);
        a(impulse);
    }
};

struct Influences {
    std::vector<FieldRecord> fields;
    std::vector<Grab> grabs;
    Slots<FieldId> fieldSlots;
    Slots<GrabId> grabSlots;

    bool empty() const { return fields.empty() && grabs.empty(); }
    /// The first broken invariant, or "".
    std::string validate() const;

    template <class Archive>
    void archive(Archive& a) {
        a(fields);
        a(grabs);
        a(fieldSlots);
        a(grabSlots);
    }
};

template <class Archive>
void archiveZone(Archive& a, Zone& zone) {
    std::uint32_t kind = static_cast<std::uint32_t>(zone.index());
    a(kind);
    if (kind == 1) {
        if (zone.index() != 1) zone = BoxZone{};
        a(std::get<BoxZone>(zone).low);
        a(std::get<BoxZone>(zone).high);
    } else if (kind == 2) {
        if (zone.index() != 2) zone = CircleZone{};
        a(std::get<CircleZone>(zone).centre);
        a(std::get<CircleZone>(zone).radius);
    } else {
        zone = Everywhere{};
    }
}

template <class Archive>
void archiveField(Archive& a, UniformField& field) {
    archiveZone(a, field.zone);
    a(field.acceleration);
    a(field.mask);
}

template <class Archive>
void archiveField(Archive& a, RadialField& field) {
    a(field.centre);
    a(field.strength);
    a(field.falloff);
    a(field.core);
    a(field.reach);
    a(field.mask);
}

template <class Archive>
void archiveField(Archive& a, WindField& field) {
    archiveZone(a, field.zone);
    a(field.velocity);
    a(field.drag);
    a(field.mask);
}

template <class Archive>
void FieldRecord::archive(Archive& a) {
    a(id);
    std::uint32_t kind = static_cast<std::uint32_t>(field.index());
    a(kind);
    // A reader has a field of the first kind and makes it the one that it found.
    if (kind == 1 && field.index() != 1) field = RadialField{};
    if (kind == 2 && field.index() != 2) field = WindField{};
    std::visit([&a](auto& one) { archiveField(a, one); }, field);
}

}  // namespace sulfur::detail
