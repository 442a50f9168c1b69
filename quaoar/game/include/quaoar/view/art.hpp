// Pictures and fonts of the game, loaded once.
#pragma once

#include <atlax/canvas.hpp>
#include <atlax/files.hpp>
#include <atlax/image.hpp>
#include <map>
#include <string>
#include <string_view>

namespace quaoar {

/// Where the game's own files lie: the variable QUAOAR_DATA, "../share/sulfur/quaoar" beside the
/// program (installed), or the source tree.
atlax::Assets gameAssets();
/// The same for levels: QUAOAR_LEVELS, "../share/sulfur/levels", the source tree.
atlax::Assets levelAssets();

/// Colours that mean something in every level.
namespace palette {
inline constexpr atlax::Color night = atlax::Color::hex(0x0B1026);
inline constexpr atlax::Color deep = atlax::Color::hex(0x1F3A5F);
inline constexpr atlax::Color ice = atlax::Color::hex(0x6FA8DC);
inline constexpr atlax::Color frost = atlax::Color::hex(0xE8F4FF);
inline constexpr atlax::Color amber = atlax::Color::hex(0xFFB347);
inline constexpr atlax::Color ember = atlax::Color::hex(0x7A3E12);
inline constexpr atlax::Color glow = atlax::Color::hex(0xFFE3B0);
inline constexpr atlax::Color danger = atlax::Color::hex(0xE0457B);
}  // namespace palette

/// Textures and fonts. Needs the canvas's context when made and when a texture is first asked for.
class Art {
public:
    /// Throws atlax::Error when a picture or every font is missing.
    explicit Art(atlax::Canvas& canvas);

    /// An SVG or PNG of the assets; rasterised when first asked for. A picture that a level names
    /// but that does not exist is said in the log once and drawn plain.
    const atlax::Texture& picture(const std::string& name);
    /// A soft round light, white, fading to nothing.
    const atlax::Texture& light() const { return light_; }
    /// Paints pictures without mipmaps: cheapest for those that fill the screen.
    const atlax::Shader& plain() const { return plain_; }
    /// A picture made by the program.
    atlax::Texture make(const atlax::Image& image) { return canvas_.createTexture(image); }
    const atlax::Font& bold() const { return bold_; }
    const atlax::Font& regular() const { return regular_; }

private:
    atlax::Canvas& canvas_;
    atlax::Assets assets_;
    std::map<std::string, atlax::Texture> pictures_;
    atlax::Texture light_;
    atlax::Shader plain_;
    atlax::Font bold_;
    atlax::Font regular_;
};

}  // namespace quaoar
