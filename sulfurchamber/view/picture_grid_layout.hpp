// Where the pictures of a grid stand: under headings, as many in a row as fit.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace sulfurchamber {

/// Whole pixels, from the upper left; plain data.
struct GridRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    bool contains(int px, int py) const {
        return px >= x && py >= y && px < x + width && py < y + height;
    }
};

struct PictureGridLayout {
    /// What everything measures, pixels.
    struct Sizes {
        int width = 300;
        int pictureWidth = 96;  ///< at most; cells share the width
        int pictureRatio = 75;  ///< height of a picture in percent of its width
        int label = 18;         ///< height of the name below it
        int heading = 24;       ///< height of a heading
        int gap = 6;
    };
    struct Heading {
        std::string text;
        GridRect place;
    };
    std::vector<Heading> headings;
    std::vector<GridRect> cells;  ///< in the order of the items: picture and name
    std::vector<std::size_t> firstOfRow;
    int height = 0;

    /// `groups` is the heading of each item; items of one heading stand together.
    static PictureGridLayout of(const std::vector<std::string>& groups, const Sizes& sizes);
    std::optional<std::size_t> at(int x, int y) const;
    /// The item that a key leads to: by columns and rows from one to the next.
    std::size_t moved(std::size_t from, int columns, int rows) const;
};

}  // namespace sulfurchamber
