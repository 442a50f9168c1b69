// What lies over the picture of the world: status, title, pause and finish.
#pragma once

#include <atlax/canvas.hpp>
#include <quaoar/session.hpp>
#include <quaoar/view/art.hpp>
#include <quaoar/view/texts.hpp>
#include <string>
#include <vector>

namespace quaoar {

/// "0:07.34"
std::string clockText(double seconds);

/// What the drawings below need of the program. Refers to all of it.
struct OverlayTools {
    atlax::Canvas& canvas;
    Art& art;
    const Texts& texts;
};

/// Pixels of a length that is 1 in a picture 720 high: less where the picture is narrow.
float unitOf(atlax::PixelSize size);

/// Where a menu has room, pixels from the top.
struct MenuRoom {
    float top = 0;
    float bottom = 0;
};

/// What stands beside the clock.
struct StatusNews {
    bool replay = false;
    std::string split = {};  ///< at the last checkpoint; empty: none just now
    bool ahead = false;      ///< of the best run
};
/// Level, time, pick-ups, a countdown where there is one, and a mark that says it is a replay.
void drawStatus(const OverlayTools& tools, const Session& session, const StatusNews& news);
/// The name of the level for the first seconds of an attempt.
void drawLevelName(const OverlayTools& tools, const Level& level, double seconds);
/// A sentence at the lower edge, in a box; `alpha` 0..1.
void drawBanner(const OverlayTools& tools, const std::string& text, float alpha);
/// A line at the very bottom of a menu: what the keys do, or news.
void drawFooter(const OverlayTools& tools, const std::string& text, bool news);
/// The seconds before play goes on.
void drawCountIn(const OverlayTools& tools, int number);
/// The game's name.
MenuRoom drawTitle(const OverlayTools& tools, double seconds);
/// A headline over the dimmed picture, and a sentence below it where there is one.
MenuRoom drawHeadline(const OverlayTools& tools, const std::string& text,
                      const std::string& below = {});
/// Lines of text under a headline: pairs of a name and a value, or, without a value, in the middle.
struct TextLine {
    std::string name;
    std::string value;
};
MenuRoom drawLines(const OverlayTools& tools, const std::string& headline,
                   const std::vector<TextLine>& lines);

/// What the finish screen says beside the time.
struct FinishNews {
    double seconds = 0;  ///< of this run
    double best = 0;     ///< seconds, with this run; 0: none yet
    double before = 0;   ///< the best before this run
    bool replay = false;
};
MenuRoom drawFinish(const OverlayTools& tools, const Session& session, const FinishNews& news);

/// A level in the grid.
struct LevelCell {
    int number = 0;
    bool open = false;
    Medal medal = Medal::none;
    bool finished = false;
    const atlax::Texture* picture = nullptr;  ///< null: not drawn yet
};
/// Draws the cells and tells where each is, pixels; `columns` becomes their number in a row.
std::vector<atlax::Rect> drawGrid(const OverlayTools& tools, const std::vector<LevelCell>& cells,
                                  std::size_t selected, const std::string& details, int& columns);

}  // namespace quaoar
