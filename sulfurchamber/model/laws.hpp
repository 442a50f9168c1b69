// The laws of the textbook, for its own sources.
#pragma once

#include <span>

#include "textbook.hpp"

namespace sulfurchamber {

/// What a law needs and tells. Bodies are there and of the kind that it needs.
struct LawBook {
    std::string_view name;   ///< in files
    std::string_view title;  ///< for people
    std::size_t bodies = 1;  ///< that it names
    /// Why these bodies do not do, as the end of a sentence; "" when they do.
    std::string (*lacks)(const sulfur::World&, std::span<const sulfur::BodyId>) = nullptr;
    /// The numbers of the scene that the formula takes.
    std::vector<double> (*numbers)(const sulfur::World&, std::span<const sulfur::BodyId>) = nullptr;
    /// What is noted of a moment.
    std::array<double, 4> (*look)(const sulfur::World&, std::span<const sulfur::BodyId>) = nullptr;
    /// From both. Notes may be empty.
    std::vector<Finding> (*find)(std::span<const double> numbers,
                                 std::span<const Textbook::Note> notes) = nullptr;
};

const LawBook& lawBook(Law law);
/// In the order of Law.
std::span<const LawBook> lawBooks();

}  // namespace sulfurchamber
