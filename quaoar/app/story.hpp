// How it began, in four pictures without a word: each is a small level in which something happens.
#pragma once

#include <array>
#include <atlax/canvas.hpp>
#include <memory>
#include <quaoar/session.hpp>
#include <quaoar/view/game_view.hpp>

namespace quaoar {

class Story {
public:
    static constexpr std::size_t pictures = 4;
    using Levels = std::array<std::shared_ptr<const Level>, pictures>;

    /// Begins with the first picture. `art` must outlive the story.
    Story(Art& art, Levels levels);
    /// The four levels of the game's folder "story". Throws what readLevel throws.
    static Levels levels();

    /// One tick of the picture that is shown; after its time the next one follows.
    void tick();
    /// The player has seen enough of this one.
    void next();
    bool over() const { return picture_ == pictures; }
    std::size_t picture() const { return picture_; }
    /// What happens in it.
    const Session& session() const { return *session_; }
    /// With a black bar above and below, and out of the dark.
    void draw(atlax::Canvas& canvas, double alpha, const ViewOptions& options);
    /// The graphics card was reset: goes on with other art.
    void remake(Art& art);

private:
    void open();
    float light() const;

    Art* art_;
    Levels levels_;
    std::size_t picture_ = 0;
    int ticks_ = 0;  ///< of this picture
    std::unique_ptr<Session> session_;
    std::unique_ptr<GameView> view_;
};

}  // namespace quaoar
