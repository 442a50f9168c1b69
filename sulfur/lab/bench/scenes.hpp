// The scenes of the comparison. Each is written once, for every engine.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/engine.hpp"

namespace sulfur::lab::bench {

/// What a run of a scene shows beside its time.
struct Figure {
    std::string name, unit;
    double value = 0;
};
using Figures = std::vector<Figure>;

/// Numbers that are the same everywhere: a linear congruential generator of 32 bits.
class Lcg {
public:
    explicit Lcg(std::uint32_t start) : state_(start) {}
    /// 0 up to 1, without 1.
    double next() {
        state_ = state_ * 1664525U + 1013904223U;
        return static_cast<double>(state_ >> 8) / (1U << 24);
    }

private:
    std::uint32_t state_;
};

/// A scene while it runs in one world.
class Play {
public:
    virtual ~Play() = default;
    /// Makes what is there at the start; not timed.
    virtual void begin(EngineWorld& world) = 0;
    /// Before the tick that begins at `time`, s; timed.
    virtual void before(EngineWorld&, double /*time*/) {}
    /// Looks at what has come to be; not timed.
    virtual void look(const EngineWorld&, double /*time*/) {}
    /// After the last tick.
    virtual Figures figures(const EngineWorld& world) = 0;
};

/// A scene of one size.
struct Scene {
    std::string key;      ///< "S1"
    std::string variant;  ///< "100 boxes/s"
    std::string title;
    Feature needs;
    double seconds = 10;     ///< simulated
    double size = 0;         ///< what the variant is about: bodies, or kg of a load
    int looksPerSecond = 0;  ///< 0: only at the end; more than the rate: after every tick
    bool onWall = false;     ///< timed on the wall, because threads take part
    bool sleeping = false;   ///< whether what rests may fall asleep
    bool weightless = false;
    bool timesTicks = false;  ///< the worst tick and the mean one are figures
    std::string error;        ///< name of the figure that tells best how wrong a run is
    std::function<std::unique_ptr<Play>()> play;
    /// Measures something in worlds of its own, once for each setting; may be empty.
    std::function<Figures(const Engine&, const Setting&)> aside = {};
};

/// How large the comparison is.
enum class Extent { quick, usual, large };

/// Names of all scenes, and of the parts of S8 and S9: "S8:tumbler".
const std::vector<std::string>& sceneNames();
/// All sizes of the scenes with these names. When none is given: of all but S8 and S9.
std::vector<Scene> scenes(const std::vector<std::string>& names, Extent extent);
/// The settings in which an engine is run in a scene; empty when it does not offer the scene.
std::vector<Setting> settingsFor(const Engine& engine, const Scene& scene);

Scene droppedBoxes(int perSecond, double seconds = 10);
Scene pyramid(int base, bool threads = false);
Scene softBlobs(int count);
Scene swingingRope(double load);
Scene hangingRope(double load);
Scene pendulums(int count, double seconds);

/// The width of the arena of S1, m.
double arenaWidth(int perSecond);
/// Where pair k of S1 appears: x of the middle between its two boxes, m.
double pairPlace(int perSecond, int k);
/// Where blob k of n of S3 begins.
Point blobPlace(int count, int k);

}  // namespace sulfur::lab::bench
