// The colours of the scene: light on a deep sea, or ink on paper; amber for what is soft or wants
// attention.
#pragma once

#include <atlax/color.hpp>

namespace sulfurchamber::palette {

struct Colours {
    atlax::Color deep, above;  ///< the scene's ground, below and above
    atlax::Color steel;        ///< what fills bodies
    atlax::Color sky;          ///< lines of bodies and texts
    atlax::Color ice;          ///< what stands out most
    atlax::Color amber, hot, cold;
};

inline constexpr Colours dark{atlax::Color::hex(0x0B1026), atlax::Color::hex(0x131D42),
                              atlax::Color::hex(0x1F3A5F), atlax::Color::hex(0x6FA8DC),
                              atlax::Color::hex(0xE8F4FF), atlax::Color::hex(0xFFB347),
                              atlax::Color::hex(0xFF5E57), atlax::Color::hex(0x43D9E8)};
inline constexpr Colours light{atlax::Color::hex(0xE3EAF3), atlax::Color::hex(0xF7FAFD),
                               atlax::Color::hex(0xA9C4E2), atlax::Color::hex(0x2F6FB0),
                               atlax::Color::hex(0x0E2138), atlax::Color::hex(0xB96A00),
                               atlax::Color::hex(0xCF2F28), atlax::Color::hex(0x007C93)};

// Those of the theme, which is chosen before anything is drawn.
inline atlax::Color deep = dark.deep;
inline atlax::Color above = dark.above;
inline atlax::Color steel = dark.steel;
inline atlax::Color sky = dark.sky;
inline atlax::Color ice = dark.ice;
inline atlax::Color amber = dark.amber;
inline atlax::Color hot = dark.hot;
inline atlax::Color cold = dark.cold;

inline void choose(const Colours& colours) {
    deep = colours.deep;
    above = colours.above;
    steel = colours.steel;
    sky = colours.sky;
    ice = colours.ice;
    amber = colours.amber;
    hot = colours.hot;
    cold = colours.cold;
}

/// Other colours for a while: a level has the game's night behind it in every theme.
class During {
public:
    explicit During(const Colours& colours)
        : before_{deep, above, steel, sky, ice, amber, hot, cold} {
        choose(colours);
    }
    ~During() { choose(before_); }
    During(const During&) = delete;
    During& operator=(const During&) = delete;

private:
    Colours before_;
};

}  // namespace sulfurchamber::palette
