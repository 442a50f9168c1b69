// What lies over the picture of the world: status, title, pause and finish.
#pragma once

#include <atlax/canvas.hpp>
#include <quaoar/session.hpp>
#include <quaoar/view/art.hpp>
#include <string>

namespace quaoar {

/// "0:07.34"
std::string clockText(double seconds);

/// Level, time and, for a replay, a mark that says so.
void drawStatus(atlax::Canvas& canvas, Art& art, const Session& session, bool replay);
/// The name of the level for the first seconds of an attempt.
void drawLevelName(atlax::Canvas& canvas, Art& art, const Level& level, double seconds);
/// The game's name and how to begin. Returns where a menu may begin, pixels from the top.
float drawTitle(atlax::Canvas& canvas, Art& art, double seconds);
float drawPause(atlax::Canvas& canvas, Art& art);
/// Time, medal and the best time so far.
float drawFinish(atlax::Canvas& canvas, Art& art, const Session& session, double best, bool replay);

}  // namespace quaoar
