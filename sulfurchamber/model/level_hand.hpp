// What the mouse does to the things of a level: selects, moves and resizes them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "level_things.hpp"

namespace sulfurchamber {

class Workbench;
struct Pointer;

/// Where the mark of a thing is drawn and hit. What is said about a body stands in a row above it,
/// so that the body itself stays free. `reach`: metres within which the pointer hits.
sulfur::Point markOf(const LevelShape& shape, double reach);
/// Whether it is seen without being selected: what every second body has is not.
bool isShown(const Document& document, const LevelThing& thing);
/// The thing whose mark is at a place, else one whose border is; nothing where there is none.
/// `marksOnly`: without borders, which give way to bodies.
std::optional<LevelThing> levelThingAt(const Document& document, const sulfur::Point& place,
                                       double reach, bool marksOnly);

/// The part of the select tool that is about levels.
class LevelHand {
public:
    explicit LevelHand(Workbench& bench) : bench_(bench) {}

    /// Takes hold of a handle or a thing; false where there is none, then nothing has changed.
    bool press(const Pointer& pointer);
    void move(const Pointer& pointer);
    void release();
    /// Puts back what is half done.
    void cancel();
    bool holds() const { return held_.has_value(); }
    std::string hint() const;

private:
    bool pressHandle(const Pointer& pointer);
    bool pressThing(const Pointer& pointer);
    void moveAll(const sulfur::Point& by);

    Workbench& bench_;
    std::optional<LevelThing> held_;
    std::optional<std::size_t> handle_;
    sulfur::Point from_{0, 0};
    sulfur::Point moved_{0, 0};  ///< by so much since the press
    bool changed_ = false;
};

}  // namespace sulfurchamber
