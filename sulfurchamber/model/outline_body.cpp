#include "outline_body.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "properties.hpp"
#include "refusals.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;
using sulfur::Real;
using sulfur::Vec2;

constexpr std::size_t mostCorners = 200;
constexpr double leastShapeArea = 1e-5;  // m^2
constexpr double slitWidth = 1e-3;       // m, or less: the way to a hole
constexpr int mostThinnings = 7;         // of 2 cm

std::size_t cornersOf(const Region& region) {
    std::size_t count = region.outer.size();
    for (const Outline& hole : region.holes) count += hole.size();
    return count;
}

Region withFewCorners(Region region) {
    for (double error = std::sqrt(momentsOf(region).area) / 2000; cornersOf(region) > mostCorners;
         error *= 1.5)
        region = simplified(region, error);
    return region;
}

// As the tool for polygons makes it, so that its recipe stays; thinner where it is narrow.
sulfur::scene::Prefab rigidOf(const Region& region, double area) {
    sulfur::shapes::PolygonOptions options;
    const double slit = std::min(slitWidth, std::sqrt(area) / 500);
    for (const Point& point : keyholed(region, slit)) options.points.push_back(point.cast<Real>());
    options.mass = static_cast<Real>(area * outlineMassPerArea);
    double radius = std::min(0.02, std::sqrt(area) / 20);
    for (int tries = 1;; ++tries, radius /= 2) {
        options.radius = static_cast<Real>(radius);
        try {
            return sulfur::scene::makePrefab("shape", options);
        } catch (const sulfur::Error& error) {
            if (tries == mostThinnings) throw std::runtime_error(error.what());
        }
    }
}

// Some hundred particles, the nearer to each other the narrower the region is.
sulfur::Blueprint softOf(const Region& region, double area) {
    double around = 0;
    for (const Outline& outline : {region.outer})
        for (std::size_t i = 0; i < outline.size(); ++i)
            around += (outline[(i + 1) % outline.size()] - outline[i]).norm();
    for (const Outline& hole : region.holes)
        for (std::size_t i = 0; i < hole.size(); ++i)
            around += (hole[(i + 1) % hole.size()] - hole[i]).norm();
    const double spacing = std::clamp(area / around, std::sqrt(area / 300), std::sqrt(area / 40));
    const double mass = area * outlineMassPerArea;
    return lattice(region.outer, spacing, mass, 700 * mass, 1.5 * mass, region.holes);
}

}  // namespace

std::optional<OutlineKind> outlineKindFromName(std::string_view name) {
    if (name == "rigid") return OutlineKind::rigid;
    if (name == "soft") return OutlineKind::soft;
    if (name == "fixed") return OutlineKind::fixed;
    return std::nullopt;
}

sulfur::scene::Prefab bodyOf(const Region& region, OutlineKind kind) {
    if (region.outer.size() < 3) throw std::runtime_error("it has less than three corners");
    const double area = momentsOf(region).area;
    if (!(area > leastShapeArea)) throw std::runtime_error("it is smaller than 0.1 cm^2");
    const Region few = withFewCorners(region);
    if (few.outer.size() < 3 || tangled(few)) throw std::runtime_error("it crosses itself");
    sulfur::scene::Prefab prefab;
    if (kind == OutlineKind::soft) {
        prefab.blueprint = softOf(few, area);
    } else {
        prefab = rigidOf(few, area);
    }
    if (kind == OutlineKind::fixed) prefab.blueprint.kind = sulfur::BodyKind::fixed;
    prefab.blueprint.validate();
    return prefab;
}

std::vector<sulfur::BodyId> addShapes(Document& document, const std::vector<DrawnShape>& shapes,
                                      OutlineKind kind, const Point& place,
                                      std::vector<std::string>& leftOut) {
    std::vector<sulfur::BodyId> made;
    for (const DrawnShape& shape : shapes) {
        try {
            // Its frame's origin is its middle.
            const Point middle = momentsOf(shape.region).centre;
            Region region = shape.region;
            for (Point& point : region.outer) point -= middle;
            for (Outline& hole : region.holes)
                for (Point& point : hole) point -= middle;
            sulfur::scene::Prefab prefab = bodyOf(region, kind);
            prefab.blueprint.name = shape.name;
            sulfur::scene::Placement placement;
            placement.pose.position = place + middle;
            made.push_back(document.add(prefab, placement));
            if (!shape.colour.empty())
                setColour(document, std::span(&made.back(), 1), shape.colour);
        } catch (const std::exception& error) {
            leftOut.push_back(shape.name + ": " + trRefusal(error.what()));
        }
    }
    if (made.empty())
        throw std::runtime_error(leftOut.empty()
                                     ? tr("no body can be made of this")
                                     : tr("no body can be made of this: {}", {leftOut.front()}));
    return made;
}

}  // namespace sulfurchamber
