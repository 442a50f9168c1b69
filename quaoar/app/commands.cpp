#include "commands.hpp"

#include <atlax/image.hpp>
#include <atlax/offscreen.hpp>
#include <cmath>
#include <cstdio>
#include <new>
#include <quaoar/recording.hpp>
#include <quaoar/view/game_view.hpp>

#include "hints.hpp"
#include "overlay.hpp"

namespace quaoar {
namespace {

/// One line on standard output; whether the level was finished.
bool verifyLevel(const std::filesystem::path& file) {
    const auto level = std::make_shared<const Level>(readLevel(file));
    const std::filesystem::path proof = proofOf(file);
    if (!std::filesystem::exists(proof)) {
        std::printf("%s  not finished  no proof: %s is missing\n", level->id.c_str(),
                    proof.string().c_str());
        return false;
    }
    const Recording recording = Recording::read(proof);
    const Verdict verdict = verify(level, recording);
    std::printf("%s  %s  %.3f s  %016llx\n", level->id.c_str(),
                verdict.finished ? "finished" : "not finished", verdict.seconds,
                static_cast<unsigned long long>(verdict.hash));
    std::fflush(stdout);
    if (!verdict.sameAsRecorded) {
        std::fprintf(stderr,
                     "quaoar: the replay of %s ended in another state than the one recorded with "
                     "library %s (%s); make the proof again with quaoar_solve\n",
                     proof.string().c_str(), recording.library.c_str(), recording.numbers.c_str());
    }
    return verdict.finished;
}

}  // namespace

int verifyLevels(const std::vector<std::filesystem::path>& levels) {
    bool all = true;
    for (const std::filesystem::path& file : levels) {
        try {
            all = verifyLevel(file) && all;
        } catch (const std::bad_alloc&) {
            throw;  // the next one would fare no better
        } catch (const std::exception& error) {
            std::fprintf(stderr, "quaoar: %s\n", error.what());
            all = false;
        }
    }
    return all ? 0 : 1;
}

void takePicture(const PictureOptions& options) {
    const auto level = std::make_shared<const Level>(readLevel(options.level));
    std::shared_ptr<const Recording> recording;
    if (options.replay) {
        recording = std::make_shared<const Recording>(Recording::read(*options.replay));
        requireMatch(*level, *recording);
    } else {
        auto idle = std::make_shared<Recording>(*level);
        TickInput look;
        setAim(look, 0.6, 0.8);
        idle->append(look);
        recording = idle;
    }
    Session session(level);
    atlax::OffscreenCanvas offscreen(options.size);
    Art art(offscreen.canvas());
    Texts texts;
    texts.setLanguage(options.language);
    GameView view(art, session);
    const PlayerActions actions;
    const Prompts prompts(actions, texts);
    Hints hints(actions, prompts, texts);
    hints.start(*level);
    Playback playback(recording);
    const auto ticks = static_cast<std::uint64_t>(std::llround(options.at * Session::tickRate));
    for (std::uint64_t n = 0; n < ticks; ++n) {
        session.tick(playback.next());
        view.tick();
        hints.tick(session, {});
    }
    atlax::Canvas& canvas = offscreen.begin();
    view.draw(canvas, 1, {});
    hints.draw({canvas, art, texts});
    drawStatus({canvas, art, texts}, session, {.replay = options.replay.has_value()});
    offscreen.finish();
    atlax::savePng(offscreen.image(), options.file);
}

}  // namespace quaoar
