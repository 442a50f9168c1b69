// Options of ready-made blueprints.
#include "convert.hpp"

namespace sulfur::c {

shapes::GroundOptions fromC(const SulfurGroundOptions& options) {
    shapes::GroundOptions result;
    result.points = vectors(options.points, options.point_count);
    result.closed = options.closed;
    result.radius = real(options.radius);
    result.material = fromC(options.material);
    return result;
}

SulfurGroundOptions toC(const shapes::GroundOptions& options) {
    SulfurGroundOptions result{};
    result.closed = options.closed;
    result.radius = static_cast<double>(options.radius);
    result.material = toC(options.material);
    return result;
}

shapes::BoxOptions fromC(const SulfurBoxOptions& options) {
    shapes::BoxOptions result;
    result.size = vec(options.size);
    result.mass = real(options.mass);
    result.radius = real(options.radius);
    result.stiffness = real(options.stiffness);
    result.damping = real(options.damping);
    result.strength = real(options.strength);
    result.solidInertia = options.solid_inertia;
    result.material = fromC(options.material);
    return result;
}

SulfurBoxOptions toC(const shapes::BoxOptions& options) {
    SulfurBoxOptions result{};
    result.size = toC(options.size);
    result.mass = static_cast<double>(options.mass);
    result.radius = static_cast<double>(options.radius);
    result.stiffness = static_cast<double>(options.stiffness);
    result.damping = static_cast<double>(options.damping);
    result.strength = static_cast<double>(options.strength);
    result.solid_inertia = options.solidInertia;
    result.material = toC(options.material);
    return result;
}

shapes::PolygonOptions fromC(const SulfurPolygonOptions& options) {
    shapes::PolygonOptions result;
    result.points = vectors(options.points, options.point_count);
    result.mass = real(options.mass);
    result.radius = real(options.radius);
    result.stiffness = real(options.stiffness);
    result.damping = real(options.damping);
    result.strength = real(options.strength);
    result.material = fromC(options.material);
    return result;
}

SulfurPolygonOptions toC(const shapes::PolygonOptions& options) {
    SulfurPolygonOptions result{};
    result.mass = static_cast<double>(options.mass);
    result.radius = static_cast<double>(options.radius);
    result.stiffness = static_cast<double>(options.stiffness);
    result.damping = static_cast<double>(options.damping);
    result.strength = static_cast<double>(options.strength);
    result.material = toC(options.material);
    return result;
}

shapes::BallOptions fromC(const SulfurBallOptions& options) {
    shapes::BallOptions result;
    result.radius = real(options.radius);
    result.mass = real(options.mass);
    result.material = fromC(options.material);
    return result;
}

SulfurBallOptions toC(const shapes::BallOptions& options) {
    SulfurBallOptions result{};
    result.radius = static_cast<double>(options.radius);
    result.mass = static_cast<double>(options.mass);
    result.material = toC(options.material);
    return result;
}

shapes::WheelOptions fromC(const SulfurWheelOptions& options) {
    shapes::WheelOptions result;
    result.radius = real(options.radius);
    result.segments = options.segments;
    result.mass = real(options.mass);
    result.rimRadius = real(options.rim_radius);
    result.spokeStiffness = real(options.spoke_stiffness);
    result.spokeDamping = real(options.spoke_damping);
    result.strength = real(options.strength);
    result.material = fromC(options.material);
    return result;
}

SulfurWheelOptions toC(const shapes::WheelOptions& options) {
    SulfurWheelOptions result{};
    result.radius = static_cast<double>(options.radius);
    result.segments = options.segments;
    result.mass = static_cast<double>(options.mass);
    result.rim_radius = static_cast<double>(options.rimRadius);
    result.spoke_stiffness = static_cast<double>(options.spokeStiffness);
    result.spoke_damping = static_cast<double>(options.spokeDamping);
    result.strength = static_cast<double>(options.strength);
    result.material = toC(options.material);
    return result;
}

shapes::RopeOptions fromC(const SulfurRopeOptions& options) {
    shapes::RopeOptions result;
    result.from = vec(options.from);
    result.to = vec(options.to);
    result.links = options.links;
    if (options.has_slack) result.slack = real(options.slack);
    result.mass = real(options.mass);
    result.radius = real(options.radius);
    result.stiffness = real(options.stiffness);
    result.damping = real(options.damping);
    result.bending = real(options.bending);
    result.strength = real(options.strength);
    result.pinFirst = options.pin_first;
    result.pinLast = options.pin_last;
    result.material = fromC(options.material);
    return result;
}

SulfurRopeOptions toC(const shapes::RopeOptions& options) {
    SulfurRopeOptions result{};
    result.from = toC(options.from);
    result.to = toC(options.to);
    result.links = options.links;
    result.has_slack = options.slack.has_value();
    result.slack = static_cast<double>(options.slack.value_or(0));
    result.mass = static_cast<double>(options.mass);
    result.radius = static_cast<double>(options.radius);
    result.stiffness = static_cast<double>(options.stiffness);
    result.damping = static_cast<double>(options.damping);
    result.bending = static_cast<double>(options.bending);
    result.strength = static_cast<double>(options.strength);
    result.pin_first = options.pinFirst;
    result.pin_last = options.pinLast;
    result.material = toC(options.material);
    return result;
}

shapes::ChainOptions fromC(const SulfurChainOptions& options) {
    shapes::ChainOptions result;
    result.from = vec(options.from);
    result.to = vec(options.to);
    result.links = options.links;
    result.mass = real(options.mass);
    result.radius = real(options.radius);
    result.strength = real(options.strength);
    result.pinFirst = options.pin_first;
    result.pinLast = options.pin_last;
    result.material = fromC(options.material);
    return result;
}

SulfurChainOptions toC(const shapes::ChainOptions& options) {
    SulfurChainOptions result{};
    result.from = toC(options.from);
    result.to = toC(options.to);
    result.links = options.links;
    result.mass = static_cast<double>(options.mass);
    result.radius = static_cast<double>(options.radius);
    result.strength = static_cast<double>(options.strength);
    result.pin_first = options.pinFirst;
    result.pin_last = options.pinLast;
    result.material = toC(options.material);
    return result;
}

shapes::BridgeOptions fromC(const SulfurBridgeOptions& options) {
    shapes::BridgeOptions result;
    result.from = vec(options.from);
    result.to = vec(options.to);
    result.planks = options.planks;
    result.sag = real(options.sag);
    result.mass = real(options.mass);
    result.radius = real(options.radius);
    result.stiffness = real(options.stiffness);
    result.damping = real(options.damping);
    result.strength = real(options.strength);
    result.material = fromC(options.material);
    return result;
}

SulfurBridgeOptions toC(const shapes::BridgeOptions& options) {
    SulfurBridgeOptions result{};
    result.from = toC(options.from);
    result.to = toC(options.to);
    result.planks = options.planks;
    result.sag = static_cast<double>(options.sag);
    result.mass = static_cast<double>(options.mass);
    result.radius = static_cast<double>(options.radius);
    result.stiffness = static_cast<double>(options.stiffness);
    result.damping = static_cast<double>(options.damping);
    result.strength = static_cast<double>(options.strength);
    result.material = toC(options.material);
    return result;
}

shapes::JellyOptions fromC(const SulfurJellyOptions& options) {
    shapes::JellyOptions result;
    result.size = vec(options.size);
    result.columns = options.columns;
    result.rows = options.rows;
    result.mass = real(options.mass);
    result.radius = real(options.radius);
    result.stiffness = real(options.stiffness);
    result.damping = real(options.damping);
    result.strength = real(options.strength);
    result.material = fromC(options.material);
    return result;
}

SulfurJellyOptions toC(const shapes::JellyOptions& options) {
    SulfurJellyOptions result{};
    result.size = toC(options.size);
    result.columns = options.columns;
    result.rows = options.rows;
    result.mass = static_cast<double>(options.mass);
    result.radius = static_cast<double>(options.radius);
    result.stiffness = static_cast<double>(options.stiffness);
    result.damping = static_cast<double>(options.damping);
    result.strength = static_cast<double>(options.strength);
    result.material = toC(options.material);
    return result;
}

shapes::ClothOptions fromC(const SulfurClothOptions& options) {
    shapes::ClothOptions result;
    result.size = vec(options.size);
    result.columns = options.columns;
    result.rows = options.rows;
    result.mass = real(options.mass);
    result.radius = real(options.radius);
    result.diagonals = options.diagonals;
    result.pinCorners = options.pin_corners;
    result.stiffness = real(options.stiffness);
    result.damping = real(options.damping);
    result.strength = real(options.strength);
    result.material = fromC(options.material);
    return result;
}

SulfurClothOptions toC(const shapes::ClothOptions& options) {
    SulfurClothOptions result{};
    result.size = toC(options.size);
    result.columns = options.columns;
    result.rows = options.rows;
    result.mass = static_cast<double>(options.mass);
    result.radius = static_cast<double>(options.radius);
    result.diagonals = options.diagonals;
    result.pin_corners = options.pinCorners;
    result.stiffness = static_cast<double>(options.stiffness);
    result.damping = static_cast<double>(options.damping);
    result.strength = static_cast<double>(options.strength);
    result.material = toC(options.material);
    return result;
}

shapes::WallOptions fromC(const SulfurWallOptions& options) {
    shapes::WallOptions result;
    result.size = vec(options.size);
    result.columns = options.columns;
    result.rows = options.rows;
    result.mass = real(options.mass);
    result.radius = real(options.radius);
    result.stiffness = real(options.stiffness);
    result.damping = real(options.damping);
    result.strength = real(options.strength);
    result.pinBottom = options.pin_bottom;
    result.material = fromC(options.material);
    return result;
}

SulfurWallOptions toC(const shapes::WallOptions& options) {
    SulfurWallOptions result{};
    result.size = toC(options.size);
    result.columns = options.columns;
    result.rows = options.rows;
    result.mass = static_cast<double>(options.mass);
    result.radius = static_cast<double>(options.radius);
    result.stiffness = static_cast<double>(options.stiffness);
    result.damping = static_cast<double>(options.damping);
    result.strength = static_cast<double>(options.strength);
    result.pin_bottom = options.pinBottom;
    result.material = toC(options.material);
    return result;
}

shapes::BlobOptions fromC(const SulfurBlobOptions& options) {
    shapes::BlobOptions result;
    result.radius = real(options.radius);
    result.segments = options.segments;
    result.mass = real(options.mass);
    result.skinRadius = real(options.skin_radius);
    result.stiffness = real(options.stiffness);
    result.damping = real(options.damping);
    result.material = fromC(options.material);
    return result;
}

SulfurBlobOptions toC(const shapes::BlobOptions& options) {
    SulfurBlobOptions result{};
    result.radius = static_cast<double>(options.radius);
    result.segments = options.segments;
    result.mass = static_cast<double>(options.mass);
    result.skin_radius = static_cast<double>(options.skinRadius);
    result.stiffness = static_cast<double>(options.stiffness);
    result.damping = static_cast<double>(options.damping);
    result.material = toC(options.material);
    return result;
}

}  // namespace sulfur::c
