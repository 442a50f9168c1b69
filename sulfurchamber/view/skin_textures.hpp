// The pictures of skins on the graphics card.
#pragma once

#include <atlax/canvas.hpp>
#include <filesystem>
#include <map>
#include <string>

#include "../model/skins.hpp"

namespace sulfurchamber {

/// Loads a picture when it is first drawn, and anew when its file has changed. Belongs to the
/// thread of the canvas.
class SkinTextures {
public:
    explicit SkinTextures(SkinStore store) : store_(std::move(store)) {}

    const SkinStore& store() const { return store_; }
    /// Null where there is no such picture, or one that cannot be read; the log says so once.
    const atlax::Texture* of(atlax::Canvas& canvas, const std::string& texture,
                             const Document& document);
    /// Files may have changed.
    void lookAgain() { checked_.clear(); }
    /// The context is lost with all that was on the card.
    void forget();

private:
    struct Loaded {
        std::filesystem::file_time_type time;
        atlax::Texture texture;
        bool isGood = false;
    };
    SkinStore store_;
    std::map<std::string, Loaded> loaded_;                  ///< by file
    std::map<std::string, const atlax::Texture*> checked_;  ///< by folder and name
};

}  // namespace sulfurchamber
