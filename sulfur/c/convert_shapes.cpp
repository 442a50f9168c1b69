// Options of ready-made blueprints. What members of a struct for C and of ours belong together is
// told once; it is read both ways.
#include <concepts>
#include <type_traits>

#include "convert.hpp"

namespace sulfur::c {

namespace {

/// Either of them may be the one that is read.
template <class Type, class Plain>
concept Is = std::same_as<std::remove_const_t<Type>, Plain>;

struct FromC {
    void operator()(double c, Real& own) const { own = real(c); }
    void operator()(SulfurVec c, Vec2& own) const { own = vec(c); }
    void operator()(const SulfurMaterial& c, Material& own) const { own = fromC(c); }
    template <std::integral Number>
    void operator()(Number c, Number& own) const {
        own = c;
    }
    void operator()(bool has, double c, std::optional<Real>& own) const {
        own = has ? std::optional<Real>(real(c)) : std::nullopt;
    }
};

struct ToC {
    void operator()(double& c, Real own) const { c = static_cast<double>(own); }
    void operator()(SulfurVec& c, const Vec2& own) const { c = toC(own); }
    void operator()(SulfurMaterial& c, const Material& own) const { c = toC(own); }
    template <std::integral Number>
    void operator()(Number& c, Number own) const {
        c = own;
    }
    void operator()(bool& has, double& c, const std::optional<Real>& own) const {
        has = own.has_value();
        c = static_cast<double>(own.value_or(0));
    }
};

template <class Copy, Is<SulfurGroundOptions> C, class Own>
void members(const Copy& copy, C& c, Own& own) {
    copy(c.closed, own.closed);
    copy(c.radius, own.radius);
    copy(c.material, own.material);
}

template <class Copy, Is<SulfurBoxOptions> C, class Own>
void members(const Copy& copy, C& c, Own& own) {
    copy(c.size, own.size);
    copy(c.mass, own.mass);
    copy(c.radius, own.radius);
    copy(c.stiffness, own.stiffness);
    copy(c.damping, own.damping);
    copy(c.strength, own.strength);
    copy(c.solid_inertia, own.solidInertia);
    copy(c.rounded, own.rounded);
    copy(c.material, own.material);
}

template <class Copy, Is<SulfurPolygonOptions> C, class Own>
void members(const Copy& copy, C& c, Own& own) {
    copy(c.mass, own.mass);
    copy(c.radius, own.radius);
    copy(c.stiffness, own.stiffness);
    copy(c.damping, own.damping);
    copy(c.strength, own.strength);
    copy(c.rounded, own.rounded);
    copy(c.material, own.material);
}

template <class Copy, Is<SulfurBallOptions> C, class Own>
void members(const Copy& copy, C& c, Own& own) {
    copy(c.radius, own.radius);
    copy(c.mass, own.mass);
    copy(c.material, own.material);
}

template <class Copy, Is<SulfurWheelOptions> C, class Own>
void members(const Copy& copy, C& c, Own& own) {
    copy(c.radius, own.radius);
    copy(c.segments, own.segments);
    copy(c.mass, own.mass);
    copy(c.rim_radius, own.rimRadius);
    copy(c.spoke_stiffness, own.spokeStiffness);
    copy(c.spoke_damping, own.spokeDamping);
    copy(c.strength, own.strength);
    copy(c.material, own.material);
}

template <class Copy, Is<SulfurRopeOptions> C, class Own>
void members(const Copy& copy, C& c, Own& own) {
    copy(c.from, own.from);
    copy(c.to, own.to);
    copy(c.links, own.links);
    copy(c.has_slack, c.slack, own.slack);
    copy(c.mass, own.mass);
    copy(c.radius, own.radius);
    copy(c.stiffness, own.stiffness);
    copy(c.damping, own.damping);
    copy(c.bending, own.bending);
    copy(c.bending_damping, own.bendingDamping);
    copy(c.strength, own.strength);
    copy(c.pin_first, own.pinFirst);
    copy(c.pin_last, own.pinLast);
    copy(c.material, own.material);
}

template <class Copy, Is<SulfurChainOptions> C, class Own>
void members(const Copy& copy, C& c, Own& own) {
    copy(c.from, own.from);
    copy(c.to, own.to);
    copy(c.links, own.links);
    copy(c.mass, own.mass);
    copy(c.radius, own.radius);
    copy(c.strength, own.strength);
    copy(c.pin_first, own.pinFirst);
    copy(c.pin_last, own.pinLast);
    copy(c.material, own.material);
}

template <class Copy, Is<SulfurBridgeOptions> C, class Own>
void members(const Copy& copy, C& c, Own& own) {
    copy(c.from, own.from);
    copy(c.to, own.to);
    copy(c.planks, own.planks);
    copy(c.sag, own.sag);
    copy(c.mass, own.mass);
    copy(c.radius, own.radius);
    copy(c.stiffness, own.stiffness);
    copy(c.damping, own.damping);
    copy(c.strength, own.strength);
    copy(c.material, own.material);
}

template <class Copy, Is<SulfurJellyOptions> C, class Own>
void members(const Copy& copy, C& c, Own& own) {
    copy(c.size, own.size);
    copy(c.columns, own.columns);
    copy(c.rows, own.rows);
    copy(c.mass, own.mass);
    copy(c.radius, own.radius);
    copy(c.stiffness, own.stiffness);
    copy(c.damping, own.damping);
    copy(c.strength, own.strength);
    copy(c.material, own.material);
}

template <class Copy, Is<SulfurClothOptions> C, class Own>
void members(const Copy& copy, C& c, Own& own) {
    copy(c.size, own.size);
    copy(c.columns, own.columns);
    copy(c.rows, own.rows);
    copy(c.mass, own.mass);
    copy(c.radius, own.radius);
    copy(c.diagonals, own.diagonals);
    copy(c.pin_corners, own.pinCorners);
    copy(c.stiffness, own.stiffness);
    copy(c.damping, own.damping);
    copy(c.strength, own.strength);
    copy(c.material, own.material);
}

template <class Copy, Is<SulfurWallOptions> C, class Own>
void members(const Copy& copy, C& c, Own& own) {
    copy(c.size, own.size);
    copy(c.columns, own.columns);
    copy(c.rows, own.rows);
    copy(c.mass, own.mass);
    copy(c.radius, own.radius);
    copy(c.stiffness, own.stiffness);
    copy(c.damping, own.damping);
    copy(c.strength, own.strength);
    copy(c.pin_bottom, own.pinBottom);
    copy(c.material, own.material);
}

template <class Copy, Is<SulfurBlobOptions> C, class Own>
void members(const Copy& copy, C& c, Own& own) {
    copy(c.radius, own.radius);
    copy(c.segments, own.segments);
    copy(c.mass, own.mass);
    copy(c.skin_radius, own.skinRadius);
    copy(c.stiffness, own.stiffness);
    copy(c.damping, own.damping);
    copy(c.material, own.material);
}

template <class Own, class C>
Own ours(const C& options) {
    Own result;
    members(FromC{}, options, result);
    return result;
}

template <class C, class Own>
C theirs(const Own& options) {
    C result{};
    members(ToC{}, result, options);
    return result;
}

}  // namespace

shapes::GroundOptions fromC(const SulfurGroundOptions& options) {
    auto result = ours<shapes::GroundOptions>(options);
    result.points = vectors(options.points, options.point_count);
    for (std::size_t i = 0; i < options.bend_count; ++i)
        result.bends.push_back(real((&required(options.bends, "bends"))[i]));
    return result;
}
SulfurGroundOptions toC(const shapes::GroundOptions& options) {
    return theirs<SulfurGroundOptions>(options);
}
shapes::BoxOptions fromC(const SulfurBoxOptions& options) {
    return ours<shapes::BoxOptions>(options);
}
SulfurBoxOptions toC(const shapes::BoxOptions& options) {
    return theirs<SulfurBoxOptions>(options);
}
shapes::PolygonOptions fromC(const SulfurPolygonOptions& options) {
    auto result = ours<shapes::PolygonOptions>(options);
    result.points = vectors(options.points, options.point_count);
    return result;
}
SulfurPolygonOptions toC(const shapes::PolygonOptions& options) {
    return theirs<SulfurPolygonOptions>(options);
}
shapes::BallOptions fromC(const SulfurBallOptions& options) {
    return ours<shapes::BallOptions>(options);
}
SulfurBallOptions toC(const shapes::BallOptions& options) {
    return theirs<SulfurBallOptions>(options);
}
shapes::WheelOptions fromC(const SulfurWheelOptions& options) {
    return ours<shapes::WheelOptions>(options);
}
SulfurWheelOptions toC(const shapes::WheelOptions& options) {
    return theirs<SulfurWheelOptions>(options);
}
shapes::RopeOptions fromC(const SulfurRopeOptions& options) {
    return ours<shapes::RopeOptions>(options);
}
SulfurRopeOptions toC(const shapes::RopeOptions& options) {
    return theirs<SulfurRopeOptions>(options);
}
shapes::ChainOptions fromC(const SulfurChainOptions& options) {
    return ours<shapes::ChainOptions>(options);
}
SulfurChainOptions toC(const shapes::ChainOptions& options) {
    return theirs<SulfurChainOptions>(options);
}
shapes::BridgeOptions fromC(const SulfurBridgeOptions& options) {
    return ours<shapes::BridgeOptions>(options);
}
SulfurBridgeOptions toC(const shapes::BridgeOptions& options) {
    return theirs<SulfurBridgeOptions>(options);
}
shapes::JellyOptions fromC(const SulfurJellyOptions& options) {
    return ours<shapes::JellyOptions>(options);
}
SulfurJellyOptions toC(const shapes::JellyOptions& options) {
    return theirs<SulfurJellyOptions>(options);
}
shapes::ClothOptions fromC(const SulfurClothOptions& options) {
    return ours<shapes::ClothOptions>(options);
}
SulfurClothOptions toC(const shapes::ClothOptions& options) {
    return theirs<SulfurClothOptions>(options);
}
shapes::WallOptions fromC(const SulfurWallOptions& options) {
    return ours<shapes::WallOptions>(options);
}
SulfurWallOptions toC(const shapes::WallOptions& options) {
    return theirs<SulfurWallOptions>(options);
}
shapes::BlobOptions fromC(const SulfurBlobOptions& options) {
    return ours<shapes::BlobOptions>(options);
}
SulfurBlobOptions toC(const shapes::BlobOptions& options) {
    return theirs<SulfurBlobOptions>(options);
}

}  // namespace sulfur::c
