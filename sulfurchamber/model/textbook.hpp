// Scenes of the textbook: what a formula expects of a scene's own numbers, and what is measured.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document.hpp"

namespace sulfurchamber {

/// What a scene shows, as its member "textbook" says: {"law": "pendulum", "bodies": ["bob"]}.
enum class Law : std::uint8_t {
    pendulum,   ///< a particle on a rigid joint below a pinned one: its period
    fall,       ///< a body above the ground, the second one: time and speed of its fall
    throwing,   ///< a body with a velocity: how far and how high it flies
    slope,      ///< a block on a plank that tilts: the angle at which it slips
    spring,     ///< a particle on an elastic joint below a pinned one: its period
    collision,  ///< two bodies that meet on a level line: their speeds afterwards
    rolling     ///< a disc on a slope, the second one: its acceleration
};

/// One line of expected against measured.
struct Finding {
    std::string name;     ///< "Period"
    std::string formula;  ///< UTF-8, with a meaning for each letter that is not usual
    std::string unit;
    double expected = 0;
    std::optional<double> measured;  ///< nothing as long as it has not happened
    double bound = 0;                ///< by how much both may differ, in the unit
    /// Measured less expected.
    std::optional<double> difference() const;
};

/// Follows the document's scene. It takes note of each tick; where time was rewound, what came
/// later is forgotten, and where the scene's numbers change, all of it. One thread.
class Textbook {
public:
    /// `document` must outlive it.
    explicit Textbook(const Document& document) : document_(document) {}

    /// Whether the scene is one of the textbook and has all that its law needs.
    bool applies() const;
    /// What the member "textbook" lacks or has wrong, as one sentence; "" when nothing.
    std::string problem() const;
    /// For people: "Period of a pendulum"; "" where nothing applies.
    std::string_view title() const;
    /// Expected of the scene as it is now; measured until now.
    std::vector<Finding> findings() const;

    /// Before each tick: the start counts.
    void beforeTick();
    /// After each tick.
    void sample();

    /// What is noted of a tick.
    struct Note {
        double time = 0;
        std::array<double, 4> values{};
    };

private:
    struct Subject {
        Law law = Law::pendulum;
        std::vector<std::string> bodies;
    };
    void follow() const;
    std::vector<sulfur::BodyId> bodies() const;
    void note();

    const Document& document_;
    mutable std::string text_;
    mutable std::string problem_;
    mutable std::optional<Subject> subject_;
    std::vector<double> basis_;
    std::vector<Note> notes_;
};

}  // namespace sulfurchamber
