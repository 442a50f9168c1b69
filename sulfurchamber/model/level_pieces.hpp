// What the palette of a level has: pieces that are put into the picture, and levels to begin with.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "level_things.hpp"

namespace sulfurchamber {

enum class LevelPiece : std::uint8_t {
    ground,
    spawn,
    exit,
    bounds,
    hint,
    checkpoint,
    pickup,
    gravity,
    wind,
    liquid,
    deadlyZone,
    trigger,
    mover,
    monster,
    rock,
    hazard
};

/// How the mouse places a piece.
enum class Placing : std::uint8_t {
    click,   ///< where one clicks
    frame,   ///< a rectangle that one drags
    body,    ///< a click on a body, or beside all for one that is made
    way,     ///< from a body to where it shall go
    corners  ///< corner by corner
};

struct LevelPieceInfo {
    LevelPiece piece;
    std::string_view name;   ///< for scripts and icons: "spawn"
    std::string_view label;  ///< for people, with '&' before its letter in a menu
    Placing placing = Placing::click;
    std::string_view hint;  ///< one sentence: what the mouse does
};
std::span<const LevelPieceInfo> levelPieces();
const LevelPieceInfo& infoOf(LevelPiece piece);

/// Puts a piece between two places (the same for a click), as a part of the open edit; `body` is
/// what is there, null for none. Returns what was added or moved. Throws std::runtime_error in one
/// sentence where it cannot be.
LevelThing placePiece(Document& document, LevelPiece piece, const sulfur::Point& from,
                      const sulfur::Point& to, sulfur::BodyId body);
/// A block of ground inside of a closed outline, as a part of the open edit. Throws where that
/// crosses itself.
LevelThing addGround(Document& document, std::vector<sulfur::Point> outline);

/// A scene with a floor, a ceiling, a spawn, an exit and a gap between: where a level begins.
sulfur::scene::Scene newLevel();
/// Makes a level of the scene that is open, as a part of the open edit: spawn, exit and bounds
/// about what there is, 500 Hz. Nothing if it is one.
void makeLevel(Document& document);

}  // namespace sulfurchamber
