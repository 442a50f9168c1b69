// What the program does without a window.
#pragma once

#include <atlax/vec.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quaoar {

/// Replays the proof beside each level file and prints one line a level. Returns the exit status:
/// 0 only when all finished.
int verifyLevels(const std::vector<std::filesystem::path>& levels);

struct PictureOptions {
    std::filesystem::path file;  ///< PNG to write
    std::filesystem::path level;
    double at = 0;  ///< seconds after the start
    std::optional<std::filesystem::path> replay = std::nullopt;
    atlax::PixelSize size{1280, 720};
    std::string language = "en";  ///< of what is written in it
};

/// Draws a moment of a level offscreen. Needs no display. Throws with one sentence.
void takePicture(const PictureOptions& options);

}  // namespace quaoar
