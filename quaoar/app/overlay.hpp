// What lies over the picture of the world: status, title, pause and finish.
#pragma once

#include <atlax/canvas.hpp>
#include <quaoar/session.hpp>
#include <quaoar/view/art.hpp>
#include <quaoar/view/texts.hpp>
#include <string>

namespace quaoar {

/// "0:07.34"
std::string clockText(double seconds);

/// What the drawings below need of the program. Refers to all of it.
struct OverlayTools {
    atlax::Canvas& canvas;
    Art& art;
    const Texts& texts;
};

/// Level, time and, for a replay, a mark that says so.
void drawStatus(const OverlayTools& tools, const Session& session, bool replay);
/// The name of the level for the first seconds of an attempt.
void drawLevelName(const OverlayTools& tools, const Level& level, double seconds);
/// The game's name and how to begin. Returns where a menu may begin, pixels from the top.
float drawTitle(const OverlayTools& tools, double seconds);
/// A headline over the dimmed picture. Returns the same.
float drawHeadline(const OverlayTools& tools, const std::string& text);
/// Time, medal and the best time so far.
float drawFinish(const OverlayTools& tools, const Session& session, double best, bool replay);

}  // namespace quaoar
