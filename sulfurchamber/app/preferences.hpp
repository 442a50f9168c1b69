// What the user has set and opened, kept between runs.
#pragma once

#include <atlax/settings.hpp>
#include <atlax/vec.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "../view/scene_painter.hpp"
#include "../view/scene_view.hpp"

namespace sulfurchamber {

/// Reads and writes the settings of the sandbox by their names. Owns the values; main thread.
/// Nothing throws: what cannot be read has its default, what cannot be written is said in the log.
class Preferences {
public:
    /// Reads the file, usually settingsFile().
    explicit Preferences(const std::filesystem::path& file);
    /// "settings.json" in the user's configuration folder (XDG_CONFIG_HOME).
    static std::filesystem::path settingsFile();

    /// Logical units.
    atlax::PixelSize windowSize() const;
    void setWindowSize(atlax::PixelSize size);
    bool maximised() const { return settings_.get("window.maximised", false); }
    void setMaximised(bool on) { settings_.set("window.maximised", on); }

    ViewOptions viewOptions() const;
    void setViewOptions(const ViewOptions& options);
    /// At first things snap to all but the grid.
    SnapSwitches snapping() const;
    void setSnapping(const SnapSwitches& switches);

    /// The latest first, nine at most.
    std::vector<std::filesystem::path> recentFiles() const;
    void noteFile(const std::filesystem::path& file);
    void forgetFile(const std::filesystem::path& file);

    /// "de" and so on; empty: as the system has it.
    std::string language() const;
    void setLanguage(const std::string& code) { settings_.set("language", code); }

    /// Of the panels: "dark", "light" or "system".
    std::string theme() const;
    void setTheme(const std::string& name) { settings_.set("theme", name); }

    void save() { settings_.trySave(); }

private:
    atlax::Settings settings_;
};

}  // namespace sulfurchamber
