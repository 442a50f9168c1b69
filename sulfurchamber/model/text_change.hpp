// What differs between two texts, line by line: a step of the history is kept as this.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sulfurchamber {

/// How one text becomes another and back again. Both directions are exact to the byte.
class TextChange {
public:
    TextChange() = default;
    /// Complexity: linear in both texts. It is as small as the lines that differ, where lines keep
    /// their order; what changes places counts as taken out and put in.
    static TextChange between(std::string_view before, std::string_view after);

    bool empty() const { return pieces_.empty(); }
    /// The text after the change, of the one before it.
    std::string apply(std::string_view before) const;
    /// The text before the change, of the one after it.
    std::string revert(std::string_view after) const;

    /// As bytes, and from those that bytes() made.
    std::string bytes() const;
    static TextChange fromBytes(std::string_view bytes);

private:
    /// Whole lines that give way to others.
    struct Piece {
        std::size_t at = 0;  ///< byte in the text before
        std::string before;
        std::string after;
    };
    std::vector<Piece> pieces_;
};

}  // namespace sulfurchamber
