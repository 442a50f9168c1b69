#include "picture_grid_layout.hpp"

#include <algorithm>

namespace sulfurchamber {

PictureGridLayout PictureGridLayout::of(const std::vector<std::string>& groups,
                                        const Sizes& sizes) {
    PictureGridLayout layout;
    const int room = std::max(sizes.width - sizes.gap, 1);
    const int columns =
        std::max(1, (room + sizes.pictureWidth / 3) / (sizes.pictureWidth + sizes.gap));
    const int width = std::max(16, room / columns - sizes.gap);
    const int height = width * sizes.pictureRatio / 100 + sizes.label;
    int y = sizes.gap;
    int column = 0;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const bool begins = i == 0 || groups[i] != groups[i - 1];
        if (begins) {
            if (column > 0) y += height + sizes.gap;
            column = 0;
            if (!groups[i].empty()) {
                layout.headings.push_back({groups[i], {sizes.gap, y, room, sizes.heading}});
                y += sizes.heading;
            }
        } else if (column == columns) {
            y += height + sizes.gap;
            column = 0;
        }
        if (column == 0) layout.firstOfRow.push_back(i);
        layout.cells.push_back({sizes.gap + column * (width + sizes.gap), y, width, height});
        ++column;
    }
    layout.height = y + (column > 0 ? height + sizes.gap : 0);
    return layout;
}

std::optional<std::size_t> PictureGridLayout::at(int x, int y) const {
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (cells[i].contains(x, y)) return i;
    return std::nullopt;
}

std::size_t PictureGridLayout::moved(std::size_t from, int columns, int rows) const {
    if (cells.empty()) return 0;
    const auto last = static_cast<std::ptrdiff_t>(cells.size()) - 1;
    auto to = static_cast<std::size_t>(
        std::clamp(static_cast<std::ptrdiff_t>(from) + columns, std::ptrdiff_t{0}, last));
    if (rows == 0) return to;
    const auto after = std::upper_bound(firstOfRow.begin(), firstOfRow.end(), to);
    const auto row = after - firstOfRow.begin() - 1;
    const auto wanted = std::clamp(row + rows, std::ptrdiff_t{0},
                                   static_cast<std::ptrdiff_t>(firstOfRow.size()) - 1);
    if (wanted == row) return to;
    const std::size_t column = to - firstOfRow[static_cast<std::size_t>(row)];
    const std::size_t first = firstOfRow[static_cast<std::size_t>(wanted)];
    const std::size_t end = static_cast<std::size_t>(wanted) + 1 < firstOfRow.size()
                                ? firstOfRow[static_cast<std::size_t>(wanted) + 1]
                                : cells.size();
    return std::min(first + column, end - 1);
}

}  // namespace sulfurchamber
