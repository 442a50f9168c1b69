// The sounds of the game, made from recipes: no recordings, no files.
#pragma once

#include <atlax/audio.hpp>
#include <future>
#include <map>
#include <optional>
#include <quaoar/session.hpp>
#include <quaoar/view/recipes.hpp>
#include <quaoar/view/score.hpp>
#include <vector>

namespace quaoar {

/// Follows a session and plays what happens: effects by the material of what is hit, the creak of
/// the rope by its tension, music by the level's world with a layer for danger. Silent where there
/// is no sound device. Main thread; music is composed in a thread of its own.
class Sounds {
public:
    /// `audio` must outlive every call, but not the object itself.
    explicit Sounds(atlax::Audio& audio);

    /// Call once after every tick of the session.
    void tick(const Session& session);
    /// Stops the sounds that go on and lowers the music, for pauses and menus.
    void hush();
    /// Lets the music of a level's world begin, or go on; also called by tick().
    void accompany(const Level& level);
    /// A menu's click.
    void click();

    /// How often an effect was played: for tests.
    int played(Effect effect) const;
    /// Whether music is playing, and how much of its danger is heard, 0 to 1.
    bool musicPlays() const { return calmVoice_.generation != 0; }
    float danger() const { return danger_; }
    /// 1 in play, less in menus.
    float musicLoudness() const { return loudness_; }

private:
    enum class Material : std::uint8_t { ice, metal, rock, soft };
    /// The music of one world: on its way, or there.
    struct Piece {
        std::future<Score> coming;
        atlax::Sound calm, danger;
    };

    void play(Effect effect, float gain, float pitch = 1);
    void playEvents(const Session& session);
    void playBlows(const Session& session);
    void follow(const Session& session);
    void followRope(const Session& session);
    void followDanger(const Session& session);
    void setMusicGain();
    Material materialOf(const Session& session, sulfur::BodyId body) const;
    std::optional<sulfur::BodyId> holding(const Session& session) const;

    atlax::Audio& audio_;
    std::vector<atlax::Sound> effects_;
    std::vector<int> played_;
    atlax::Sound creak_, hum_;
    atlax::Voice creakVoice_, humVoice_;
    std::map<Theme::World, Piece> pieces_;
    std::optional<Theme::World> world_;  ///< whose music plays or will
    atlax::Voice calmVoice_, dangerVoice_;
    float danger_ = 0;
    float loudness_ = 0;  ///< of the music, towards 1 in play and less in menus
    bool hushed_ = true;
    double lastTension_ = 0;
    float strain_ = 0;
    int bumpRest_ = 0;  ///< ticks until the next bump may sound
    int snapRest_ = 0;
    int followRest_ = 0;
};

}  // namespace quaoar
