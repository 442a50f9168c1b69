// Meters that stand in a scene: what they are, and how a scene keeps them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <sulfur/scene.hpp>
#include <vector>

namespace sulfurchamber {

enum class MeterKind : std::uint8_t {
    ruler,       ///< the distance of two ends
    protractor,  ///< the angle at the first end from the second to the third, anticlockwise
    tracer,      ///< the way of a point
    gauge,       ///< the force in a joint or mechanism, or of all contacts of a body
    gun          ///< the speed of what is in the beam from the first end to the second
};

/// Where a meter takes hold: a particle or a point of a body, or a place of the world.
struct MeterEnd {
    sulfur::Point at{0, 0};  ///< metres, in the frame of the body's blueprint, or of the world
    std::string body = {};   ///< id of a placement; empty: the world
    std::optional<std::uint32_t> particle = {};  ///< its place in the body; `at` counts without
    bool operator==(const MeterEnd&) const = default;
};

/// One meter. A gauge with one end tells the contacts of that body. With two it tells the joint
/// between both particles, or, where the ends have none, the mechanism of both bodies whose point
/// is nearest to the first end.
struct Meter {
    std::string id;
    MeterKind kind = MeterKind::ruler;
    std::vector<MeterEnd> ends;
    bool operator==(const Meter&) const = default;
};

/// Most meters of a scene.
inline constexpr std::size_t mostMeters = 24;

/// "ruler", "protractor", "tracer", "gauge", "gun": as files say it.
std::string_view meterName(MeterKind kind);
/// For people: "Ruler", "Force gauge".
std::string_view meterTitle(MeterKind kind);

/// The meters of a scene, which are its member "meters". Throws sulfur::scene::ReadError with file,
/// line and meter when that is unusable.
std::vector<Meter> metersOf(const sulfur::scene::Scene& scene);
/// Writes them back; without any the scene has no such member.
void setMeters(sulfur::scene::Scene& scene, std::span<const Meter> meters);

// All of these change a plan; they are parts of the open edit.

/// Adds a meter with a free id, which is returned. Throws std::runtime_error when the scene has
/// mostMeters.
std::string addMeter(sulfur::scene::Scene& scene, Meter meter);
/// Puts a meter in the place of the one of its id, if there is one.
void changeMeter(sulfur::scene::Scene& scene, const Meter& meter);
void removeMeters(sulfur::scene::Scene& scene, std::span<const std::string> ids);
/// Takes away those that hold on to bodies that go. These must be there still.
void forgetMeters(sulfur::scene::Scene& scene,
                  const std::function<bool(const std::string& body)>& gone);
/// Takes away those that hold on to a particle of a body; the particles after it move up by one.
void forgetParticleInMeters(sulfur::scene::Scene& scene, const std::string& body,
                            std::uint32_t particle);
/// Follows a body's new id, which it does not have yet.
void renameInMeters(sulfur::scene::Scene& scene, const std::string& from, const std::string& to);

}  // namespace sulfurchamber
