// What scripts say about levels.
#include <atlax/backend.hpp>
#include <cctype>

#include "level_panel.hpp"
#include "script.hpp"

namespace sulfurchamber {
namespace {

std::optional<LevelKind> kindOf(const std::string& key) {
    for (const LevelKindInfo& info : levelKinds())
        if (info.key == key) return info.kind;
    return std::nullopt;
}

}  // namespace

bool Script::startLevel(const Words& words) {
    Workbench& bench = frame_.bench();
    if (words[0] == "await" && words.size() == 5) {
        const auto endNs = atlax::monotonicNs() + static_cast<std::int64_t>(number(words[4]) * 1e9);
        waitFor([this, words, endNs] {
            waitedFrames_ = 0;  // the clock decides
            if (holds(words)) return true;
            if (atlax::monotonicNs() > endNs) expect(words);
            return false;
        });
    } else if (words[0] == "thing" && words.size() == 3) {
        const auto kind = kindOf(words[1]);
        if (!kind) fail("there is no kind of thing called " + words[1]);
        const bool surface = *kind == LevelKind::surface;
        const LevelThing thing{*kind, surface ? 0 : static_cast<std::size_t>(number(words[2])),
                               surface ? words[2] : std::string()};
        if (!contains(bench.document(), thing)) fail("there is no such thing");
        frame_.stage().goTo(thing);
    } else if (words[0] == "field" && words.size() >= 3) {
        if (bench.things().empty()) fail("no thing of the level is selected");
        const LevelThing thing = bench.things().front();
        const LevelField* field = levelField(thing.kind, words[1] == "-" ? "" : words[1]);
        if (field == nullptr) fail("there is no field " + words[1]);
        std::string text;
        for (std::size_t i = 2; i < words.size(); ++i) text += (i > 2 ? " " : "") + words[i];
        changeField(bench.document(), thing, *field, text);
    } else if (words[0] == "keep-key" && words.size() == 3 && words[1].size() == 1) {
        const int code = std::toupper(static_cast<unsigned char>(words[1][0]));
        frame_.canvas().SetFocus();
        simulator_.KeyDown(code);
        const auto endNs = atlax::monotonicNs() + static_cast<std::int64_t>(number(words[2]) * 1e9);
        waitFor(
            [this, endNs] {
                waitedFrames_ = 0;
                return atlax::monotonicNs() > endNs;
            },
            [this, code] { simulator_.KeyUp(code); });
    } else if (words[0] == "swing" && words.size() == 5 && words[3].size() == 1) {
        swing({number(words[1]), number(words[2])},
              std::toupper(static_cast<unsigned char>(words[3][0])), number(words[4]));
    } else {
        return false;
    }
    return true;
}

// The rope is shot at a place, and held with a key for so long of the game's own time.
void Script::swing(const sulfur::Point& at, int key, double seconds) {
    const PlayTest* test = frame_.stage().test();
    if (test == nullptr) fail("no level is played");
    frame_.canvas().SetFocus();
    const auto hold = [this, key, seconds] {
        simulator_.MouseDown();
        simulator_.KeyDown(key);
        const double from = levelQuantity("playtest.time").value_or(0);
        waitFor([this, from,
                 seconds] { return levelQuantity("playtest.time").value_or(0) > from + seconds; },
                [this, key] {
                    simulator_.KeyUp(key);
                    simulator_.MouseUp();
                });
    };
    if (!moveMouseTo(test->pixelsOf(at), hold)) fail("this place is not in view of the game");
}

std::optional<double> Script::levelQuantity(const std::string& name) const {
    const LevelStage& stage = frame_.stage();
    const LevelDesk& desk = stage.desk();
    if (name == "level.things")
        return static_cast<double>(levelThings(frame_.bench().document()).size());
    if (name == "level.selected") return static_cast<double>(frame_.bench().things().size());
    if (name == "level.problems") return static_cast<double>(desk.problems().size());
    if (name == "level.checked") return desk.checked() ? 1 : 0;
    if (name == "level.playable") return desk.playable() ? 1 : 0;
    if (name == "level.proof") return static_cast<double>(desk.proof());
    if (name == "level.searching")
        return desk.job() != nullptr && !desk.job()->progress().over() ? 1 : 0;
    if (name == "level.survival") {
        const auto result = desk.result();
        return result && result->robust.survival.games > 0 ? result->robust.survival.share() : -1;
    }
    if (name == "playtest") return stage.playing() ? 1 : 0;
    if (name == "playtest.first") return stage.firstPicture();
    if (name == "playtest.time") return stage.test() ? stage.test()->session().seconds() : 0;
    if (name == "playtest.ticks")
        return stage.test() ? static_cast<double>(stage.test()->session().ticks()) : 0;
    if (name == "playtest.x") return stage.test() ? stage.test()->session().heroPosition().x() : 0;
    return std::nullopt;
}

}  // namespace sulfurchamber
