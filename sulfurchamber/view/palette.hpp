// The colours of the sandbox: light on a deep sea, amber for what is soft or wants attention.
#pragma once

#include <atlax/color.hpp>

namespace sulfurchamber::palette {

inline constexpr atlax::Color deep = atlax::Color::hex(0x0B1026);
inline constexpr atlax::Color above = atlax::Color::hex(0x131D42);
inline constexpr atlax::Color steel = atlax::Color::hex(0x1F3A5F);
inline constexpr atlax::Color sky = atlax::Color::hex(0x6FA8DC);
inline constexpr atlax::Color ice = atlax::Color::hex(0xE8F4FF);
inline constexpr atlax::Color amber = atlax::Color::hex(0xFFB347);
inline constexpr atlax::Color hot = atlax::Color::hex(0xFF5E57);
inline constexpr atlax::Color cold = atlax::Color::hex(0x43D9E8);

}  // namespace sulfurchamber::palette
