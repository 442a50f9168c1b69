// The outline of what is opaque in a picture.
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "drawing.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

constexpr int tracedSide = 512;     // pixels; larger pictures are traced in steps
constexpr double leastPart = 5e-4;  // of the picture that a part must have

// Alpha from 0 to 1 on a grid with an empty frame around it.
struct AlphaGrid {
    int width = 0;
    int height = 0;
    std::vector<double> values;

    double at(int x, int y) const {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    bool opaque(int x, int y) const { return at(x, y) >= 0.5; }
};

[[noreturn]] void refusePicture(const std::string& name, const std::string& why) {
    throw std::runtime_error(name + ": " + why);
}

AlphaGrid gridOf(const atlax::Image& picture) {
    const int step =
        std::max(1, (std::max(picture.width(), picture.height()) + tracedSide - 1) / tracedSide);
    const int columns = (picture.width() + step - 1) / step;
    const int rows = (picture.height() + step - 1) / step;
    AlphaGrid grid{columns + 2, rows + 2, {}};
    grid.values.resize(static_cast<std::size_t>(grid.width) *
                       static_cast<std::size_t>(grid.height));
    const auto bytes = picture.bytes();
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            int sum = 0, count = 0;
            for (int y = row * step; y < std::min((row + 1) * step, picture.height()); ++y)
                for (int x = column * step; x < std::min((column + 1) * step, picture.width());
                     ++x, ++count)
                    sum += bytes[4 * (static_cast<std::size_t>(y) *
                                          static_cast<std::size_t>(picture.width()) +
                                      static_cast<std::size_t>(x)) +
                                 3];
            grid.values[static_cast<std::size_t>(row + 1) * static_cast<std::size_t>(grid.width) +
                        static_cast<std::size_t>(column + 1)] = sum / 255.0 / std::max(1, count);
        }
    return grid;
}

// A crossing of the border with an edge of the grid: the edge from (x, y) to the right, or down.
using GridEdge = std::array<int, 3>;  // x, y, 0: right, 1: down

Point crossingOf(const AlphaGrid& grid, const GridEdge& edge) {
    const auto [x, y, down] = edge;
    const double a = grid.at(x, y);
    const double b = down != 0 ? grid.at(x, y + 1) : grid.at(x + 1, y);
    const double share = std::clamp((0.5 - a) / (b - a), 0.05, 0.95);
    return down != 0 ? Point(x, y + share) : Point(x + share, y);
}

// Marching squares: in each cell the border goes from edge to edge with what is opaque on its
// left. Where two opaque corners face each other they hang together.
std::map<GridEdge, GridEdge> bordersOf(const AlphaGrid& grid) {
    std::map<GridEdge, GridEdge> next;
    for (int y = 0; y + 1 < grid.height; ++y)
        for (int x = 0; x + 1 < grid.width; ++x) {
            const GridEdge top{x, y, 0}, bottom{x, y + 1, 0}, left{x, y, 1}, right{x + 1, y, 1};
            const int cell = (grid.opaque(x, y) ? 1 : 0) | (grid.opaque(x + 1, y) ? 2 : 0) |
                             (grid.opaque(x + 1, y + 1) ? 4 : 0) | (grid.opaque(x, y + 1) ? 8 : 0);
            const auto go = [&](const GridEdge& from, const GridEdge& to) { next[from] = to; };
            switch (cell) {
                case 1:
                    go(left, top);
                    break;
                case 2:
                    go(top, right);
                    break;
                case 3:
                    go(left, right);
                    break;
                case 4:
                    go(right, bottom);
                    break;
                case 5:
                    go(left, bottom);
                    go(right, top);
                    break;
                case 6:
                    go(top, bottom);
                    break;
                case 7:
                    go(left, bottom);
                    break;
                case 8:
                    go(bottom, left);
                    break;
                case 9:
                    go(bottom, top);
                    break;
                case 10:
                    go(top, left);
                    go(bottom, right);
                    break;
                case 11:
                    go(bottom, right);
                    break;
                case 12:
                    go(right, left);
                    break;
                case 13:
                    go(right, top);
                    break;
                case 14:
                    go(top, left);
                    break;
                default:
                    break;
            }
        }
    return next;
}

std::vector<Outline> loopsOf(const AlphaGrid& grid) {
    auto next = bordersOf(grid);
    std::vector<Outline> loops;
    while (!next.empty()) {
        Outline loop;
        GridEdge edge = next.begin()->first;
        for (auto step = next.find(edge); step != next.end(); step = next.find(edge)) {
            loop.push_back(crossingOf(grid, edge));
            edge = step->second;
            next.erase(step);
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

}  // namespace

Drawing traced(const atlax::Image& picture, const std::string& name,
               const DrawingOptions& options) {
    const AlphaGrid grid = gridOf(picture);
    const int inside = (grid.width - 2) * (grid.height - 2);
    const auto opaque = std::count_if(grid.values.begin(), grid.values.end(),
                                      [](double alpha) { return alpha >= 0.5; });
    if (opaque == inside)
        refusePicture(name,
                      tr("has no transparent part, so that its outline is its frame; make its "
                         "background transparent first"));
    if (opaque == 0) refusePicture(name, tr("is wholly transparent"));
    Drawing drawing;
    std::vector<Outline> loops = loopsOf(grid);
    std::erase_if(loops,
                  [&](const Outline& loop) { return areaWithin(loop) < leastPart * inside; });
    if (loops.empty()) refusePicture(name, tr("has only specks that are opaque"));
    Point low = loops[0][0], high = low;
    for (const Outline& loop : loops)
        for (const Point& point : loop) {
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
    const double scale = options.size / (high - low).maxCoeff();
    const Point middle = (low + high) / 2;
    for (Outline& loop : loops) {
        for (Point& point : loop)
            point = Point(point.x() - middle.x(), middle.y() - point.y()) * scale;
        // A border of pixels has steps of half a pixel, which are no shape.
        loop = simplified(loop, std::max(options.tolerance, 0.6 * scale), true);
    }
    std::erase_if(loops, [](const Outline& loop) { return loop.size() < 3; });
    if (loops.size() > DrawingLimits::outlines)
        refusePicture(name, tr("has more than 200 outlines"));
    std::string stem = std::filesystem::path(name).stem().string();
    for (char& c : stem)
        if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126 || c == '"' ||
            c == '\\')
            c = '-';
    for (const Region& region : regionsOf(loops, FillRule::evenOdd))
        drawing.shapes.push_back({stem.empty() ? "picture" : stem.substr(0, 60), region, ""});
    return drawing;
}

}  // namespace sulfurchamber
