#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/log.hpp>
#include <quaoar/view/art.hpp>

namespace quaoar {
namespace {

constexpr int pictureSide = 512;  ///< pixels: sharp at the size in which a crate fills a third

atlax::Image lightImage() {
    constexpr int side = 128;
    atlax::Image image({side, side});
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const atlax::Vec2 p{(static_cast<float>(x) + 0.5f) / side * 2 - 1,
                                (static_cast<float>(y) + 0.5f) / side * 2 - 1};
            const float fade = std::max(0.0f, 1 - atlax::length(p));
            const float strength = fade * fade * (3 - 2 * fade);
            image.setPixel(x, y, {255, 255, 255, static_cast<std::uint8_t>(255 * strength)});
        }
    }
    return image;
}

}  // namespace

atlax::Assets gameAssets() {
    atlax::Assets assets({.application = "sulfur/quaoar",
                          .environmentVariable = "QUAOAR_DATA",
                          .sourceFolder = QUAOAR_SOURCE_ASSETS});
    return assets;
}

atlax::Assets levelAssets() {
    return atlax::Assets({.application = "sulfur/levels",
                          .environmentVariable = "QUAOAR_LEVELS",
                          .sourceFolder = QUAOAR_SOURCE_LEVELS});
}

Art::Art(atlax::Canvas& canvas)
    : canvas_(canvas),
      assets_(gameAssets()),
      light_(canvas.createTexture(lightImage())),
      plain_(canvas.createShader("vec4 paint(vec2 uv, vec4 tint) {"
                                 " return textureLod(picture, uv, 0.0) * tint; }")),
      bold_(atlax::Font::find({"Jura-Bold", "DejaVuSans-Bold", "DejaVuSans"})),
      regular_(atlax::Font::find({"Jura-SemiBold", "Jura-Medium", "DejaVuSans"})) {
    for (const char* name : {"hero.svg", "gate.svg", "moon.svg", "bolt.svg"}) {
        assets_.find(name);  // a missing picture of the game itself is an error at once
        picture(name);
    }
}

const atlax::Texture& Art::picture(const std::string& name) {
    const auto known = pictures_.find(name);
    if (known != pictures_.end()) return known->second;
    atlax::Texture texture;
    try {
        const auto file = assets_.find(name);
        const bool svg = file.extension() == ".svg";
        texture = canvas_.createTexture(svg ? atlax::loadSvg(file, {pictureSide, pictureSide})
                                            : atlax::loadImage(file));
    } catch (const atlax::Error& error) {
        atlax::log(atlax::LogLevel::Warning, error.what());
    }
    return pictures_.emplace(name, texture).first->second;
}

}  // namespace quaoar
