/// \file
/// A scene: everything that a world begins with, as plain data.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <sulfur/scene/document.hpp>
#include <sulfur/scene/extra.hpp>
#include <sulfur/scene/mechanism.hpp>
#include <sulfur/scene/prefab.hpp>
#include <sulfur/world.hpp>
#include <vector>

namespace sulfur::scene {

/// Bounds of what a file may contain.
struct Limits {
    static constexpr std::size_t particles = 24'000;   ///< of all bodies, and of all blueprints
    static constexpr std::size_t joints = 72'000;      ///< the same, with connections and angles
    static constexpr std::size_t bodies = 24'000;      ///< of a scene
    static constexpr std::size_t vetoes = 72'000;      ///< of a scene
    static constexpr std::size_t fields = 1'000;       ///< of a scene
    static constexpr std::size_t mechanisms = 24'000;  ///< of a scene
    /// Summed over the bodies of each mechanism of a scene, because the particles that hold its
    /// points are searched for.
    static constexpr std::size_t searchedParticles = 4'000'000;
    static constexpr double coordinate = 1'000;         ///< metres, either way
    static constexpr double speed = 2'000;              ///< m/s
    static constexpr double spin = 1e6;                 ///< rad/s, of discs
    static constexpr double smallestMass = 1e-9;        ///< kg, of a particle
    static constexpr double mass = 1e9;                 ///< kg
    static constexpr double stiffness = 1e18;           ///< N/m, beside "rigid"
    static constexpr double damping = 1e12;             ///< N s/m, or N m s/rad
    static constexpr double angularStiffness = 1e12;    ///< N m/rad; of drives also N/m
    static constexpr double driven = 1e6;               ///< rad, m, rad/s or m/s of drives
    static constexpr double leastRatio = 1e-6;          ///< of pulleys and gears
    static constexpr double ratio = 1e6;                ///< of pulleys and gears
    static constexpr double angle = 3.1415928;          ///< rad, either way; pi, also as Real
    static constexpr double bending = 100;              ///< of ropes, also its damping
    static constexpr double strength = 1e18;            ///< N, beside "unbreakable"
    static constexpr double friction = 1e6;             ///< coefficient
    static constexpr double rollingResistance = 1'000;  ///< coefficient
    static constexpr double surfaceSpeed = 1'000;       ///< m/s, either way
    static constexpr double gravity = 10'000;           ///< m/s^2
    static constexpr std::size_t nameBytes = 100;       ///< of ids and names
    static constexpr std::size_t textBytes = 100'000;   ///< of titles and descriptions
};

/// Where the particles of a body are when they have left the shape of its blueprint.
struct BodyState {
    std::vector<Point> positions;  ///< in the world, one per particle
    std::vector<Vec2> velocities;  ///< one per particle
    /// rad, of a body that is a single disc; that of its pose when not given
    std::optional<double> angle = std::nullopt;
    double spin = 0;  ///< rad/s, of a body that is a single disc
};

/// One body: an instance of a prefab.
struct Placement {
    std::string id;                ///< unique in the scene; stays the same when others come and go
    std::string blueprint;         ///< name of a prefab of the scene
    Pose pose;                     ///< where the blueprint's frame is
    Vec2 velocity{0, 0};           ///< of the whole body at the start
    std::optional<BodyKind> kind;  ///< where given, instead of what the prefab says
    std::optional<Material> material;  ///< where given, instead of what the prefab says
    std::optional<Filter> filter;      ///< where given, instead of what the prefab says
    std::optional<bool> sensor;        ///< where given, instead of what the prefab says
    std::optional<BodyState> state;    ///< instead of pose and velocity
    ExtraTree extra;                   ///< unknown members
};

/// A particle of a body of the scene.
struct ParticleRef {
    std::string body;            ///< id of a placement
    std::uint32_t particle = 0;  ///< its place in the body's blueprint
};

/// A joint between two bodies.
struct Connection {
    ParticleRef a;           ///< one end
    ParticleRef b;           ///< the other end
    ConnectOptions options;  ///< what it is made of
    ExtraTree extra;         ///< unknown members
};

/// A particle that is held at a point of a body.
struct Attachment {
    ParticleRef particle;  ///< what is held
    std::string body;      ///< id of a placement
    Vec2 point{0, 0};      ///< metres, in the frame of the body's blueprint
    Extra extra;           ///< unknown members
};

/// Two bodies that pass through each other.
struct Veto {
    std::string a;  ///< id of a placement
    std::string b;  ///< id of another
};

/// A force field.
struct SceneField {
    Field field;      ///< what it is
    ExtraTree extra;  ///< unknown members
};

/// A whole scene file.
struct Scene {
    std::string title;                       ///< for people
    std::string description;                 ///< for people
    WorldSettings settings;                  ///< what its world is made with
    std::vector<Prefab> blueprints;          ///< each name once
    std::vector<Placement> bodies;           ///< each id once
    std::vector<Connection> connections;     ///< joints between bodies
    std::vector<Attachment> attachments;     ///< particles held at bodies
    std::vector<Veto> vetoes;                ///< bodies that never touch
    std::vector<SceneMechanism> mechanisms;  ///< hinges and the like; parts of gears before them
    std::vector<SceneField> fields;          ///< force fields
    Extra settingsExtra;                     ///< unknown members of "world"
    Extra extra;       ///< unknown top-level members, such as the game's "level"
    std::string file;  ///< what it was read from, for messages

    /// The prefab of a name, or null.
    const Prefab* prefab(std::string_view name) const;
    /// The prefab of a name, or null.
    Prefab* prefab(std::string_view name);
    /// The body of an id, or null.
    const Placement* body(std::string_view id) const;
    /// The body of an id, or null.
    Placement* body(std::string_view id);
    /// `base` if no body has this id, otherwise base2, base3, ...
    std::string freeId(const std::string& base) const;
    /// The same for names of prefabs.
    std::string freeName(const std::string& base) const;

    /// An unknown top-level member as a document whose errors name the scene's file and lines.
    std::optional<Document> section(std::string_view key) const;
};

/// The blueprint of a body with its overrides applied. Throws ReadError when the prefab is
/// missing.
Blueprint blueprintOf(const Scene& scene, const Placement& body);

/// Places in a scene that the reader had no use for, as "file:line: object ...: unknown key ...":
/// usually a typing mistake or another program's data. Top-level members are not among them.
std::vector<std::string> unknownKeys(const Scene& scene);

}  // namespace sulfur::scene
