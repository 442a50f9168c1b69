// What the player has chosen and reached, kept between runs.
#pragma once

#include <atlax/settings.hpp>
#include <atlax/vec.hpp>
#include <filesystem>
#include <string>

namespace quaoar {

struct PlayerActions;

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
    bool fullscreen() const { return settings_.get("window.fullscreen", false); }
    void setFullscreen(bool on) { settings_.set("window.fullscreen", on); }
    /// Empty: that of the user's environment.
    std::string language() const { return settings_.get("language", ""); }
    void setLanguage(const std::string& language) { settings_.set("language", language); }
    /// 0..100
    int volume() const { return settings_.get("sound.volume", 100, 0, 100); }
    void setVolume(int percent) { settings_.set("sound.volume", percent); }
    /// Seconds; 0: the level was not finished yet.
    double best(const std::string& level) const;
    void setBest(const std::string& level, double seconds);

    void readBindings(PlayerActions& actions) const;
    void setBindings(const PlayerActions& actions);

    void save() { settings_.trySave(); }

private:
    atlax::Settings settings_;
};

}  // namespace quaoar
