#include "preferences.hpp"

#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/log.hpp>

#include "../model/words.hpp"
#include "../view/grid_painter.hpp"

namespace sulfurchamber {
namespace {

constexpr std::size_t mostFiles = 9;  // as many as wxFileHistory lists
constexpr const char* recentKey = "recent.files";
constexpr const char* gridStepKey = "view.grid-step";

/// The switches of the view by their names in settings.
struct Switch {
    const char* key;
    bool ViewOptions::*flag;
};
constexpr Switch switches[] = {
    {"view.grid", &ViewOptions::grid},         {"view.rulers", &ViewOptions::rulers},
    {"view.joints", &ViewOptions::joints},     {"view.velocities", &ViewOptions::velocities},
    {"view.strain", &ViewOptions::strain},     {"view.contacts", &ViewOptions::contacts},
    {"view.skeleton", &ViewOptions::skeleton}, {"view.films", &ViewOptions::films},
};

/// The same of what things snap to.
struct SnapSwitch {
    const char* key;
    bool SnapSwitches::*flag;
};
constexpr SnapSwitch snapSwitches[] = {
    {"view.snapping", &SnapSwitches::grid},
    {"view.snap-corners", &SnapSwitches::corners},
    {"view.snap-centres", &SnapSwitches::centres},
    {"view.snap-angles", &SnapSwitches::angles},
};

}  // namespace

Preferences::Preferences(const std::filesystem::path& file) : settings_({.file = file}) {
    settings_.load();
}

std::filesystem::path Preferences::settingsFile() {
    return atlax::configFolder("sulfurchamber") / "settings.json";
}

atlax::PixelSize Preferences::windowSize() const {
    return {settings_.get("window.width", 1280, 320, 8192),
            settings_.get("window.height", 800, 240, 8192)};
}

void Preferences::setWindowSize(atlax::PixelSize size) {
    settings_.set("window.width", size.width);
    settings_.set("window.height", size.height);
}

ViewOptions Preferences::viewOptions() const {
    ViewOptions options;
    for (const Switch& one : switches)
        options.*one.flag = settings_.get(one.key, options.*one.flag);
    const double step = settings_.get(gridStepKey, 0.0, 0.0, 1.0);
    if (std::find(gridStepChoices.begin(), gridStepChoices.end(), step) != gridStepChoices.end())
        options.gridStep = step;
    return options;
}

void Preferences::setViewOptions(const ViewOptions& options) {
    for (const Switch& one : switches) settings_.set(one.key, options.*one.flag);
    settings_.set(gridStepKey, options.gridStep);
}

SnapSwitches Preferences::snapping() const {
    SnapSwitches switches{false, true, true, true};
    for (const SnapSwitch& one : snapSwitches)
        switches.*one.flag = settings_.get(one.key, switches.*one.flag);
    return switches;
}

void Preferences::setSnapping(const SnapSwitches& switches) {
    for (const SnapSwitch& one : snapSwitches) settings_.set(one.key, switches.*one.flag);
}

std::string Preferences::language() const {
    const std::string code = settings_.get("language", std::string());
    const auto all = languages();
    return std::find(all.begin(), all.end(), code) != all.end() ? code : "";
}

std::string Preferences::theme() const {
    std::string name = settings_.get("theme", std::string());
    return name == "light" || name == "system" ? name : "dark";
}

std::vector<std::filesystem::path> Preferences::recentFiles() const {
    const auto texts = settings_.get(recentKey, std::vector<std::string>{});
    return {texts.begin(),
            texts.begin() + static_cast<std::ptrdiff_t>(std::min(texts.size(), mostFiles))};
}

void Preferences::noteFile(const std::filesystem::path& file) {
    std::vector<std::string> texts{file.string()};
    for (const std::string& text : settings_.get(recentKey, std::vector<std::string>{}))
        if (text != texts.front() && texts.size() < mostFiles) texts.push_back(text);
    try {
        settings_.set(recentKey, texts);
    } catch (const atlax::Error& error) {  // a name that is no UTF-8
        atlax::log(atlax::LogLevel::Warning, error.what());
    }
}

void Preferences::forgetFile(const std::filesystem::path& file) {
    auto texts = settings_.get(recentKey, std::vector<std::string>{});
    std::erase(texts, file.string());
    settings_.set(recentKey, texts);
}

}  // namespace sulfurchamber
