// The music of the four worlds, composed and played by the program.
#pragma once

#include <cstdint>
#include <quaoar/level.hpp>
#include <vector>

namespace quaoar {

inline constexpr int scoreRate = 22050;

/// Two loops of the same length that go together.
struct Score {
    std::vector<float> calm;    ///< pads, bells, plucked notes
    std::vector<float> danger;  ///< a pulse and uneasy notes, to be laid over it
};

/// The same seed gives the same samples. Takes some tenths of a second. Any thread.
Score compose(Theme::World world, std::uint32_t seed);

}  // namespace quaoar
