#include "svg_heat_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sulfur::lab {

namespace {

constexpr double panelWidth = 360, panelHeight = 340, left = 80, top = 80, between = 40;

/// From dark blue over green to yellow, rising in lightness, so that it can be read in grey too.
std::string colour(double share) {
    static constexpr std::array<std::array<double, 3>, 5> stops{
        {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};
    const double along = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(along), stops.size() - 2);
    const double t = along - static_cast<double>(i);
    std::array<int, 3> rgb{};
    for (std::size_t c = 0; c < 3; ++c)
        rgb[c] = static_cast<int>(std::lround(stops[i][c] + t * (stops[i + 1][c] - stops[i][c])));
    return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

constexpr const char *noneColour = "#808080", *unlimitedColour = "#ffffff";

class Drawing {
public:
    explicit Drawing(const HeatMaps& maps) : maps_(maps) {
        for (const auto& panel : maps.panels) {
            for (const HeatCell& cell : panel.cells) {
                if (!cell.value) continue;
                low_ = std::min(low_, std::log10(*cell.value));
                high_ = std::max(high_, std::log10(*cell.value));
            }
        }
        if (!(low_ < high_)) {  // one value, or none
            low_ = std::isfinite(low_) ? low_ : 0;
            high_ = low_ + 1;
        }
        low_ = std::floor(low_);
        high_ = std::ceil(high_);
    }

    std::string run() {
        const auto count = static_cast<double>(maps_.panels.size());
        const double right = left + count * (panelWidth + between);
        out_ = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
            "height=\"{1}\" font-family=\"sans-serif\" font-size=\"13\">\n"
            "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
            right + 170, top + panelHeight + 80);
        text(left, 34, "start", maps_.title, "font-size=\"17\" font-weight=\"bold\"");
        double x = left;
        for (const auto& panel : maps_.panels) {
            draw(panel, x);
            x += panelWidth + between;
        }
        const double middle = top + panelHeight / 2;
        text(0, 0, "middle", maps_.yTitle,
             fmt::format("transform=\"translate(22 {}) rotate(-90)\"", middle));
        legend(right);
        return out_ + "</svg>\n";
    }

private:
    void text(double x, double y, const char* anchor, const std::string& content,
              const std::string& more = "") {
        out_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x,
                            y, anchor, more, content);
    }
    void box(double x, double y, double width, double height, const std::string& fill,
             const char* stroke = "none") {
        out_ += fmt::format(
            "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" "
            "stroke=\"{}\"/>\n",
            x, y, width, height, fill, stroke);
    }

    void draw(const HeatMaps::Panel& panel, double x0) {
        const std::size_t columns = maps_.xLabels.size(), rows = maps_.yLabels.size();
        const double w = panelWidth / static_cast<double>(columns);
        const double h = panelHeight / static_cast<double>(rows);
        text(x0 + panelWidth / 2, top - 12, "middle", panel.title);
        for (std::size_t row = 0; row < rows; ++row) {
            const double y = top + panelHeight - h * static_cast<double>(row + 1);
            for (std::size_t column = 0; column < columns; ++column) {
                const HeatCell& cell = panel.cells[row * columns + column];
                const std::string fill =
                    cell.value ? colour((std::log10(*cell.value) - low_) / (high_ - low_))
                               : (cell.unlimited ? unlimitedColour : noneColour);
                // A little wider, so that no gap shows between cells.
                box(x0 + w * static_cast<double>(column), y, w + 0.4, h + 0.4, fill);
            }
            if (x0 == left && (rows < 16 || row % 2 == 0))
                text(x0 - 6, y + h / 2 + 4, "end", maps_.yLabels[row]);
        }
        box(x0, top, panelWidth, panelHeight, "none", "#404040");
        const std::size_t each = std::max<std::size_t>(1, columns / 6);
        for (std::size_t column = 0; column < columns; column += each)
            text(x0 + w * (static_cast<double>(column) + 0.5), top + panelHeight + 20, "middle",
                 maps_.xLabels[column]);
        text(x0 + panelWidth / 2, top + panelHeight + 48, "middle", maps_.xTitle);
    }

    void legend(double x) {
        constexpr int steps = 60;
        constexpr double height = 240;
        text(x, top - 12, "start", maps_.valueTitle);
        for (int i = 0; i < steps; ++i)
            box(x, top + height * (steps - 1 - i) / steps, 20, height / steps + 0.4,
                colour((i + 0.5) / steps));
        for (double power = low_; power <= high_; ++power)
            text(x + 28, top + height * (1 - (power - low_) / (high_ - low_)) + 5, "start",
                 fmt::format("10<tspan dy=\"-6\" font-size=\"10\">{:g}</tspan>", power));
        box(x, top + height + 24, 20, 16, unlimitedColour, "#404040");
        text(x + 28, top + height + 37, "start", maps_.unlimitedWord);
        box(x, top + height + 50, 20, 16, noneColour, "#404040");
        text(x + 28, top + height + 63, "start", maps_.noneWord);
    }

    const HeatMaps& maps_;
    double low_ = std::numeric_limits<double>::infinity();
    double high_ = -std::numeric_limits<double>::infinity();
    std::string out_;
};

}  // namespace

std::string draw(const HeatMaps& maps) {
    return Drawing(maps).run();
}

}  // namespace sulfur::lab
