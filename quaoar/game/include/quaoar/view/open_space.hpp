// How much of a part of the level is rock: sums over a grid, made once.
#pragma once

#include <atlax/vec.hpp>
#include <quaoar/session.hpp>
#include <string>
#include <vector>

namespace quaoar {

/// A fixed body with a closed border, as it lies in the world.
struct FixedShape {
    sulfur::BodyId id;
    std::string name;               ///< of the body in the scene
    std::vector<atlax::Vec2> loop;  ///< metres, the border's middle line, counter-clockwise
    float radius = 0;               ///< metres, half of the border's thickness
};

/// All of them in the order of the scene, apart from pegs and what crumbles.
std::vector<FixedShape> fixedShapes(const Session& session);

/// Which part of the level is filled with fixed bodies. A plain value; any thread.
class OpenSpace {
public:
    OpenSpace(const Level& level, const std::vector<FixedShape>& shapes);

    /// The share of a rectangle that is rock, 0..1; metres.
    float rock(atlax::Rect rect) const { return share(rock_, rect); }
    /// The share that is rock or lies outside of the level's bounds.
    float closed(atlax::Rect rect) const { return share(closed_, rect); }
    bool isRock(atlax::Vec2 at) const;
    /// Side of a cell of the grid, metres.
    float cell() const { return cell_; }

private:
    using Sums = std::vector<float>;  ///< of all cells left of and below a corner of the grid

    void fill(const std::vector<atlax::Vec2>& loop);
    Sums summed(const std::vector<char>& cells) const;
    float share(const Sums& sums, atlax::Rect rect) const;
    float sumAt(const Sums& sums, atlax::Vec2 at) const;

    atlax::Vec2 low_;
    float cell_ = 0.1f;
    int columns_ = 0, rows_ = 0;
    std::vector<char> cells_;
    Sums rock_, closed_;
};

}  // namespace quaoar
