// What the player has chosen, kept between runs.
#pragma once

#include <atlax/audio.hpp>
#include <atlax/settings.hpp>
#include <atlax/vec.hpp>
#include <filesystem>
#include <string>

namespace quaoar {

struct PlayerActions;

/// What is either on or off.
enum class Choice : std::uint8_t {
    fullscreen,
    vsync,
    shake,         ///< the picture trembles with blows
    flashes,       ///< sudden lights
    highContrast,  ///< what can be held and what hurts stands out from the rest
    toggleRope,    ///< one press fires, the next lets go
    aimAssist,
    countIn,    ///< a moment between a pause and going on
    unlockAll,  ///< every level may be played
};

/// Whose ghost runs beside the player.
enum class GhostChoice : std::uint8_t { none, best, gold };

/// Reads and writes the settings of the game by their names. Owns the values; main thread. Nothing
/// throws: what cannot be read has its default, what cannot be written is said in the log.
class Preferences {
public:
    /// Reads the file, usually settingsFile().
    explicit Preferences(const std::filesystem::path& file);
    /// "settings.json" in the player's configuration folder (XDG_CONFIG_HOME).
    static std::filesystem::path settingsFile();

    /// Logical units.
    atlax::PixelSize windowSize() const;
    void setWindowSize(atlax::PixelSize size);
    bool on(Choice choice) const;
    void set(Choice choice, bool on);
    /// Empty: that of the user's environment.
    std::string language() const { return settings_.get("language", ""); }
    void setLanguage(const std::string& language) { settings_.set("language", language); }
    /// 0..100, of effects, music or interface.
    int volume(atlax::Bus bus) const;
    void setVolume(atlax::Bus bus, int percent);
    /// 70..100 per cent of real time.
    int speed() const { return settings_.get("play.speed", 100, 70, 100); }
    void setSpeed(int percent) { settings_.set("play.speed", percent); }
    GhostChoice ghost() const;
    void setGhost(GhostChoice ghost) { settings_.set("play.ghost", static_cast<int>(ghost)); }
    /// Seconds; 0: none. Where the first version kept the best times; see Progress.
    double formerBest(const std::string& level) const;

    void readBindings(PlayerActions& actions) const;
    void setBindings(const PlayerActions& actions);

    void save() { settings_.trySave(); }

private:
    atlax::Settings settings_;
};

}  // namespace quaoar
