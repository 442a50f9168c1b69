#include "look.hpp"

namespace quaoar {

using atlax::Color;

const WorldLook& lookOf(Theme::World world) {
    static const WorldLook dawn{.horizon = Color::hex(0xF2A679),
                                .haze = Color::hex(0x8FA9D8),
                                .far = Color::hex(0x7E8FC0),
                                .near = Color::hex(0x1B3058),
                                .accent = Color::hex(0xBFE4FF),
                                .seep = Color::hex(0x5C9BD6),
                                .cap = Color::hex(0xEAF5FF),
                                .weather = Weather::snow,
                                .stars = true,
                                .sun = true};
    static const WorldLook bog{.horizon = Color::hex(0x6FB36A),
                               .haze = Color::hex(0x4E9A78),
                               .far = Color::hex(0x2F6B58),
                               .near = Color::hex(0x0C2622),
                               .accent = Color::hex(0xD4F56A),
                               .seep = Color::hex(0x4F8A4A),
                               .cap = Color::hex(0x8FC24A),
                               .weather = Weather::spores,
                               .stars = false,
                               .sun = false};
    static const WorldLook machine{.horizon = Color::hex(0xC45A34),
                                   .haze = Color::hex(0x6E3A3C),
                                   .far = Color::hex(0x52303A),
                                   .near = Color::hex(0x181119),
                                   .accent = Color::hex(0xFFC46B),
                                   .seep = Color::hex(0x7A6A62),
                                   .cap = Color::hex(0x9A8F88),
                                   .weather = Weather::embers,
                                   .stars = false,
                                   .sun = true};
    static const WorldLook deep{.horizon = Color::hex(0x2F7FC8),
                                .haze = Color::hex(0x5A4BC0),
                                .far = Color::hex(0x3D3396),
                                .near = Color::hex(0x140C3A),
                                .accent = Color::hex(0x7DF3FF),
                                .seep = Color::hex(0x7A5CE0),
                                .cap = Color::hex(0xB7C8FF),
                                .weather = Weather::bubbles,
                                .stars = true,
                                .sun = false};
    switch (world) {
        case Theme::World::dawn:
            break;
        case Theme::World::bog:
            return bog;
        case Theme::World::machine:
            return machine;
        case Theme::World::deep:
            return deep;
    }
    return dawn;
}

}  // namespace quaoar
