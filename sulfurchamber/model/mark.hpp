// What is worth finding again in the recorded past.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace sulfurchamber {

/// What a time bar shows of a tick or of a tenth of a second.
struct Mark {
    enum class Kind : std::uint8_t { edit, contact, breakage };
    std::uint64_t tick = 0;
    Kind kind = Kind::edit;
    std::string label;      ///< of an edit
    std::size_t count = 1;  ///< of contacts or of joints
};
/// "Move", "2 first contacts", "1 joint breaks".
std::string textOf(const Mark& mark);

}  // namespace sulfurchamber
