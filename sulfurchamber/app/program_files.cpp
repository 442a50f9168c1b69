#include "program_files.hpp"

#include <atlax/files.hpp>

namespace sulfurchamber {
namespace {

// Of the folders in which files may have been installed the first that is there.
std::vector<std::filesystem::path> firstOf(const atlax::Assets& assets) {
    std::error_code error;
    for (const auto& folder : assets.folders())
        if (std::filesystem::is_directory(folder, error)) return {folder};
    return {};
}

std::vector<std::filesystem::path> templateFolder() {
    return firstOf(atlax::Assets({.application = "sulfur/templates",
                                  .environmentVariable = "SULFUR_TEMPLATES",
                                  .sourceFolder = SULFURCHAMBER_SOURCE_TEMPLATES}));
}

}  // namespace

Library templateLibrary() {
    return {templateFolder(), atlax::dataFolder("sulfurchamber") / "templates"};
}

SkinStore skinStore() {
    auto folders = templateFolder();
    const auto add = [&](const atlax::Assets::Options& options) {
        for (auto& folder : firstOf(atlax::Assets(options))) folders.push_back(std::move(folder));
    };
    add({.application = "sulfur/scenes",
         .environmentVariable = "SULFUR_SCENES",
         .sourceFolder = SULFURCHAMBER_SOURCE_SCENES});
    add({.application = "sulfur/quaoar",
         .environmentVariable = "QUAOAR_DATA",
         .sourceFolder = SULFURCHAMBER_SOURCE_GAME});
    return {atlax::dataFolder("sulfurchamber"), std::move(folders)};
}

}  // namespace sulfurchamber
