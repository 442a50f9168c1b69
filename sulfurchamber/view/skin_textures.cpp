#include "skin_textures.hpp"

#include <atlax/error.hpp>
#include <atlax/log.hpp>

namespace sulfurchamber {
namespace {

constexpr int pictureSide = 512;  // pixels of a drawing, as in the game

}  // namespace

void SkinTextures::forget() {
    checked_.clear();
    loaded_.clear();
}

const atlax::Texture* SkinTextures::of(atlax::Canvas& canvas, const std::string& texture,
                                       const Document& document) {
    const auto folder = document.file().parent_path();
    const std::string key = folder.string() + '\n' + texture;
    if (const auto known = checked_.find(key); known != checked_.end()) return known->second;
    const auto file = store_.find(texture, folder);
    if (file.empty()) return checked_[key] = nullptr;
    std::error_code error;
    const auto time = std::filesystem::last_write_time(file, error);
    const auto [found, isNew] = loaded_.try_emplace(file.string());
    Loaded& loaded = found->second;
    if (isNew || loaded.time != time) {
        loaded = {time, {}, false};
        try {
            const bool svg = file.extension() == ".svg";
            loaded.texture = canvas.createTexture(
                svg ? atlax::loadSvg(file, {pictureSide, pictureSide}) : atlax::loadImage(file));
            loaded.isGood = true;
        } catch (const atlax::Error& problem) {
            atlax::log(atlax::LogLevel::Warning, problem.what());
        }
    }
    return checked_[key] = loaded.isGood ? &loaded.texture : nullptr;
}

}  // namespace sulfurchamber
